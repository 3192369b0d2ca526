//! Cube maps: six square pictures of the environment, seen from the middle of a cube.
//!
//! The faces are those of OpenGL: px, nx, py, ny, pz and nz look along the axes of a frame with x
//! right, y up and z forward, which is left-handed. Each face shows what is seen from inside, not
//! mirrored. The four faces of the horizon have y up; the lower edge of py and the upper edge of ny
//! meet pz. This frame becomes the project's by turning z around: pz is -z, in front of the camera,
//! as the middle of an equirectangular map is, and px is +x, to its right.

use crate::light::environment::{EnvironmentMap, Integrals, MOST_TEXELS};
use crate::light::map_file::maps_in;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::path::{Path, PathBuf};

/// The names of the faces, in OpenGL's order.
pub const FACES: [&str; 6] = ["px", "nx", "py", "ny", "pz", "nz"];

/// The direction of each face's middle, of its rows' right and of its columns' lower end.
const AXES: [[[f64; 3]; 3]; 6] = [
    [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]],
    [[-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]],
    [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
    [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
    [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]],
];

/// Where the faces are in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unfolding {
    /// 4 x 3 faces.
    Horizontal,
    /// 3 x 4 faces.
    Vertical,
    /// 1 x 6 faces.
    Stack,
    /// 1 x 6 faces, as OpenEXR has them.
    OpenExr,
}

impl Unfolding {
    /// The cross of a picture of this size, and the size of its faces.
    fn of_cross(width: usize, height: usize) -> Option<(Self, usize)> {
        let (columns, rows) = (width / 4, width / 3);
        if (4 * columns, 3 * columns) == (width, height) {
            Some((Self::Horizontal, columns))
        } else if (3 * rows, 4 * rows) == (width, height) {
            Some((Self::Vertical, rows))
        } else {
            None
        }
    }

    /// Column and row of a face, counted in faces, and whether it is upside down.
    fn place(self, face: usize) -> (usize, usize, bool) {
        match (self, face) {
            (Self::Stack, _) => (0, face, false),
            // `CubeMap` of ImfEnvmap.cpp, turned about y by pi as its `LatLongMap` is: +x, first in
            // the file, is nx.
            (Self::OpenExr, 0) => (0, 1, false),
            (Self::OpenExr, 1) => (0, 0, false),
            (Self::OpenExr, 2 | 3) => (0, face, true),
            (Self::OpenExr, _) => (0, face, false),
            (_, 0) => (2, 1, false),
            (_, 1) => (0, 1, false),
            (_, 2) => (1, 0, false),
            (_, 3) => (1, 2, false),
            (_, 4) => (1, 1, false),
            (Self::Horizontal, _) => (3, 1, false),
            // It hangs on ny's lower edge.
            (Self::Vertical, _) => (1, 3, true),
        }
    }
}

/// Linear radiance on the faces of a cube.
#[derive(Clone, Debug, PartialEq)]
pub struct CubeMap {
    size: usize,
    picture: EnvironmentMap,
    unfolding: Unfolding,
}

impl CubeMap {
    /// Whether a picture has the shape of a cross: 4 x 3 or 3 x 4 square faces.
    #[must_use]
    pub fn is_cross(picture: &EnvironmentMap) -> bool {
        Unfolding::of_cross(picture.width, picture.height).is_some()
    }

    /// The cube that is unfolded to a cross, in one picture: py above pz, ny below it, nx left and
    /// px right of it. nz is right of px in a horizontal cross, of 4 x 3 faces, and below ny,
    /// upside down, in a vertical one, of 3 x 4. What is beside the faces is ignored.
    ///
    /// # Errors
    ///
    /// If the picture has another shape.
    pub fn from_cross(picture: EnvironmentMap) -> Result<Self> {
        let (width, height) = (picture.width, picture.height);
        let Some((unfolding, size)) = Unfolding::of_cross(width, height) else {
            return Err(Error::new(
                format!("it is {width} x {height} pixels, not a cross of 4 x 3 or 3 x 4 squares"),
                "crop the picture to the cross, or leave out --layout cross",
            ));
        };
        Ok(Self { size, picture, unfolding })
    }

    /// The cube of an OpenEXR file whose attribute `envmap` is `cube`: its six faces from the top
    /// down. It is placed as the equirectangular map that OpenEXR makes of it.
    ///
    /// # Errors
    ///
    /// If the picture has another shape.
    pub fn from_openexr(picture: EnvironmentMap) -> Result<Self> {
        let (size, height) = (picture.width, picture.height);
        if 6 * size != height {
            let what = format!("it is {size} x {height} pixels, and its attribute `envmap` a cube");
            return Err(Error::new(what, "save six square faces, one below the other"));
        }
        Ok(Self { size, picture, unfolding: Unfolding::OpenExr })
    }

    /// Whether it is the cube of an OpenEXR file.
    #[must_use]
    pub fn is_of_openexr(&self) -> bool {
        self.unfolding == Unfolding::OpenExr
    }

    /// Reads a folder with a map for each of [`FACES`], as `px.hdr`.
    ///
    /// # Errors
    ///
    /// If a face is missing, is there twice, is not square or has another size than px; those of
    /// [`EnvironmentMap::from_path`], whose limit holds for all faces together.
    pub fn from_folder(folder: &InputFile) -> Result<Self> {
        let (mut size, mut texels) = (0, Vec::new());
        for path in face_files(folder.path())? {
            let face = EnvironmentMap::from_path(folder.other(&path))?;
            let count = 6 * face.texels.len() as u64;
            folder.at_most(count, MOST_TEXELS as u64, "texels in six faces")?;
            let (width, height) = (face.width, face.height);
            let what = if width != height {
                format!("it is {width} x {height} pixels, not square")
            } else if size != 0 && width != size {
                format!("it is {width} x {height} pixels, but px is {size} x {size}")
            } else {
                size = width;
                texels.reserve_exact(if texels.is_empty() { 6 * face.texels.len() } else { 0 });
                texels.extend(face.texels);
                continue;
            };
            return Err(Error::new(what, "give six square faces of the same size").in_file(path));
        }
        let picture = EnvironmentMap::new(size, 6 * size, texels)?;
        Ok(Self { size, picture, unfolding: Unfolding::Stack })
    }

    /// Columns and rows of each face.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// The texels of a face, in the order of [`FACES`]: unit direction of the center, solid angle
    /// and radiance.
    pub(crate) fn texels(&self, face: usize) -> impl Iterator<Item = ([f64; 3], f64, [f32; 3])> {
        let [middle, right, down] = AXES[face];
        let (column, row, is_upside_down) = self.unfolding.place(face);
        let corner = row * self.size * self.picture.width + column * self.size;
        let edge = move |k: usize| 2.0 * k as f64 / self.size as f64 - 1.0;
        (0..self.size).flat_map(move |row| {
            (0..self.size).map(move |column| {
                let (x, y) =
                    (0.5 * (edge(column) + edge(column + 1)), 0.5 * (edge(row) + edge(row + 1)));
                let length = (1.0 + x * x + y * y).sqrt();
                let axis = |k: usize| (middle[k] + x * right[k] + y * down[k]) / length;
                let solid_angle = corner_angle(edge(column), edge(row))
                    - corner_angle(edge(column + 1), edge(row))
                    - corner_angle(edge(column), edge(row + 1))
                    + corner_angle(edge(column + 1), edge(row + 1));
                let place = if is_upside_down {
                    (self.size - 1 - row) * self.picture.width + self.size - 1 - column
                } else {
                    row * self.picture.width + column
                };
                ([0, 1, 2].map(axis), solid_angle, self.picture.texels[corner + place])
            })
        })
    }

    /// The integrals of the map and of its negative texels, with exact solid angles.
    #[must_use]
    pub fn negative_integral(&self) -> Integrals {
        let mut integrals = Integrals { total: [0.0; 3], negative: [0.0; 3] };
        for (_, solid_angle, texel) in (0..FACES.len()).flat_map(|face| self.texels(face)) {
            for (channel, value) in texel.map(f64::from).into_iter().enumerate() {
                integrals.total[channel] += solid_angle * value;
                integrals.negative[channel] += solid_angle * value.min(0.0);
            }
        }
        integrals
    }
}

/// The solid angle of the rectangle from the middle of a face to (x, y), where its edges are at ±1.
fn corner_angle(x: f64, y: f64) -> f64 {
    (x * y).atan2((1.0 + x * x + y * y).sqrt())
}

/// Whether these files are faces of a cube by their names, and nothing else.
#[must_use]
pub fn are_faces(files: &[PathBuf]) -> bool {
    !files.is_empty() && files.iter().all(|file| FACES.iter().any(|face| is_named(file, face)))
}

/// The files of the faces in a folder, in the order of [`FACES`].
///
/// # Errors
///
/// If the folder cannot be read, or a face is missing or there twice.
pub fn face_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let files = maps_in(folder)?;
    let of = |face: &str| files.iter().filter(|file| is_named(file, face)).collect::<Vec<_>>();
    let missing: Vec<_> = FACES.into_iter().filter(|face| of(face).is_empty()).collect();
    let twice = FACES.into_iter().find(|face| of(face).len() > 1);
    let what = match twice {
        Some(face) => format!("it has more than one face {face}"),
        None if missing.is_empty() => {
            return Ok(FACES.iter().flat_map(|face| of(face)).cloned().collect());
        }
        None => format!("it has no map named {}", missing.join(", ")),
    };
    let remedy = format!("a cube is a folder with one map each for {}", FACES.join(", "));
    Err(Error::new(what, remedy).in_file(folder))
}

fn is_named(file: &Path, face: &str) -> bool {
    file.file_stem().is_some_and(|stem| stem.eq_ignore_ascii_case(face))
}

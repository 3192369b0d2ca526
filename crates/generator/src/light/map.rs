//! A map of either layout, and how it is recognized.

use crate::light::cube::{CubeMap, FACES, face_files};
use crate::light::environment::{EnvironmentMap, Integrals};
use crate::light::map_file::{self, is_picture};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::meta::attribute::EnvironmentMap as Stated;

/// How the pixels of a map are spread over the sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layout {
    /// One picture, see [`environment`](super::environment).
    Equirectangular,
    /// A cube unfolded to a cross, see [`CubeMap::from_cross`].
    Cross,
    /// A folder of six faces, see [`CubeMap::from_folder`].
    Cube,
}

/// Linear radiance in every direction.
#[derive(Clone, Debug, PartialEq)]
pub enum Map {
    /// One picture.
    Equirectangular(EnvironmentMap),
    /// The faces of a cube.
    Cube(CubeMap),
}

impl Map {
    /// Reads a file, or a folder of six faces.
    ///
    /// Without a `layout`, a picture is what the attribute `envmap` of an OpenEXR file states, one
    /// with the shape of a cross is a cross, any other one is equirectangular, and a folder is a
    /// cube.
    ///
    /// # Errors
    ///
    /// Those of [`EnvironmentMap::from_path`], [`CubeMap::from_cross`],
    /// [`CubeMap::from_openexr`] and [`CubeMap::from_folder`]; also if the layout does not fit.
    pub fn read(file: impl Into<InputFile>, layout: Option<Layout>) -> Result<Self> {
        let file = file.into();
        let is_folder = file.path().is_dir();
        match (layout, is_folder) {
            (None | Some(Layout::Cube), true) => {
                return CubeMap::from_folder(&file).map(Self::Cube);
            }
            (Some(Layout::Equirectangular | Layout::Cross), true) => {
                let what = "this folder holds the six faces of a cube";
                let remedy = "give --layout cube, or leave --layout out";
                return Err(Error::new(what, remedy).in_file(file.path()));
            }
            (Some(Layout::Cube), false) => {
                let what = "a cube is a folder with the maps px, nx, py, ny, pz and nz";
                let remedy = "give such a folder, or --layout cross for a cross in one picture";
                return Err(Error::new(what, remedy).in_file(file.path()));
            }
            _ => {}
        }
        let (picture, stated) = map_file::read(&file)?;
        let cube = match (layout, stated) {
            (Some(Layout::Equirectangular), _) | (None, Some(Stated::LatitudeLongitude)) => {
                return Ok(Self::Equirectangular(picture));
            }
            (None, Some(Stated::Cube)) => CubeMap::from_openexr(picture),
            (None, None) if !CubeMap::is_cross(&picture) => {
                return Ok(Self::Equirectangular(picture));
            }
            _ => CubeMap::from_cross(picture),
        };
        cube.map(Self::Cube).map_err(|error| error.in_file(file.path()))
    }

    /// Whether it is a cube.
    #[must_use]
    pub fn is_cube(&self) -> bool {
        matches!(self, Self::Cube(_))
    }

    /// The integrals of the map and of its negative texels, with exact solid angles.
    #[must_use]
    pub fn negative_integral(&self) -> Integrals {
        match self {
            Self::Equirectangular(map) => map.negative_integral(),
            Self::Cube(cube) => cube.negative_integral(),
        }
    }

    /// Warns if the map of this file is equirectangular and not twice as wide as high, or is of
    /// pictures, which clip light at white, and reaches it.
    pub fn warn(&self, file: &InputFile) {
        if let Self::Equirectangular(map) = self
            && !map.is_twice_as_wide_as_high()
        {
            file.warn("it is not twice as wide as high; it is read as equirectangular");
        }
        let of_picture = match file.path() {
            folder if folder.is_dir() => {
                face_files(folder).is_ok_and(|files| files.iter().any(|file| is_picture(file)))
            }
            path => is_picture(path),
        };
        if of_picture && self.reaches_white() {
            file.warn(
                "light is clipped at white, as in every PNG or JPEG picture: lamps and the sun are \
                 too dark; use an .hdr or .exr map if there is one",
            );
        }
    }

    /// Whether some texel is white in a channel, as a picture shows it: a radiance of 1 or more.
    fn reaches_white(&self) -> bool {
        let is_white = |texel: [f32; 3]| texel.into_iter().any(|channel| channel > 0.9999);
        match self {
            Self::Equirectangular(map) => map.texels.iter().copied().any(is_white),
            Self::Cube(cube) => {
                let mut texels = (0..FACES.len()).flat_map(|face| cube.texels(face));
                texels.any(|(_, _, texel)| is_white(texel))
            }
        }
    }
}

//! Shared by the readers of mesh files: the triangles that they return, with the normals at their
//! corners, text lines of limited length, and the error for a broken file.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::vector::{cross, dot};
use std::io::{self, BufRead};

/// Twice the area that a fan of triangles may miss, relative to the square of the polygon's size.
/// Corners on a line are on it only up to rounding.
const MISSED: f64 = 1e-4;
/// The most corners that are tried as the start of a fan, to bound the time.
const TRIED: usize = 1000;

/// The most corners, and the most triangles, that are read.
pub(crate) const MOST: u64 = 1 << 22;

/// Triangles as the file readers return them: 24 bytes for each corner, 12 for each triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The positions.
    pub corners: Vec<[f64; 3]>,
    /// Three indices of positions for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Normals, of any length.
    pub normals: Attribute<3>,
    /// Texture coordinates, (0, 0) at the upper left corner of a texture.
    pub coordinates: Attribute<2>,
    /// Linear colors and opacities.
    pub colors: Attribute<4>,
    /// The first triangle of each material, and its name.
    pub materials: Vec<(u32, String)>,
    /// The names of files of materials.
    pub libraries: Vec<String>,
}

/// Numbers at the corners of triangles; empty in a mesh without.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Attribute<const N: usize> {
    /// The numbers.
    pub values: Vec<[f32; N]>,
    /// Three indices of values for each triangle, [`NONE`](Self::NONE) where it has no value; empty
    /// if these are the indices of its positions.
    pub places: Vec<[u32; 3]>,
}

impl<const N: usize> Attribute<N> {
    /// The index of no value.
    pub const NONE: u32 = u32::MAX;

    /// The values at the corners of triangle `number`, which has these positions.
    #[must_use]
    pub fn at(&self, number: usize, corners: [u32; 3]) -> [Option<[f32; N]>; 3] {
        let places = if self.places.is_empty() { Some(&corners) } else { self.places.get(number) };
        let value = |place: u32| self.values.get(place as usize).copied();
        places.map_or([None; 3], |places| places.map(value))
    }
}

impl Mesh {
    /// An empty mesh with room for the given numbers of corners and triangles.
    ///
    /// # Errors
    ///
    /// If there are more than [`MOST`] of either.
    pub(crate) fn with_room(file: &InputFile, corners: u64, triangles: u64) -> Result<Self> {
        file.at_most(corners, MOST, "corners")?;
        file.at_most(triangles, MOST, "triangles")?;
        let [corners, triangles] = [corners, triangles].map(|count| count as usize);
        Ok(Self {
            corners: Vec::with_capacity(corners),
            triangles: Vec::with_capacity(triangles),
            ..Self::default()
        })
    }

    /// Adds a polygon, cut into a fan of triangles, and returns the number of the polygon's corner
    /// from which the fan starts. Its corners must be in the mesh already, unless it is a triangle.
    ///
    /// # Errors
    ///
    /// If it has fewer than three corners, no fan covers it, or there are more than [`MOST`]
    /// triangles.
    pub(crate) fn push_polygon(&mut self, file: &InputFile, polygon: &[u32]) -> Result<usize> {
        let corners = polygon.len();
        if corners < 3 {
            let found = if corners == 0 { "none".to_owned() } else { corners.to_string() };
            return Err(broken(format!("a face of fewer than three corners: it has {found}")));
        }
        let first = if corners == 3 { 0 } else { self.fan_corner(polygon)? };
        let count = self.triangles.len() + corners - 2;
        file.at_most(count as u64, MOST, "triangles")?;
        self.triangles.extend(fan(polygon, first));
        Ok(first)
    }

    /// The number of the polygon's corner from which a fan of triangles covers it: the first one
    /// among [`TRIED`] from which all triangles have the orientation of the polygon's normal
    /// (Newell's), up to [`MISSED`].
    fn fan_corner(&self, polygon: &[u32]) -> Result<usize> {
        // From the first one.
        let mut corners = Vec::with_capacity(polygon.len());
        let start = self.corner(polygon[0])?;
        for place in polygon {
            let end = self.corner(*place)?;
            corners.push([0, 1, 2].map(|axis| end[axis] - start[axis]));
        }
        let size = corners.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        // Twice the area of each triangle, times its normal.
        let fan = |first: usize| {
            fan(&corners, first).map(move |[a, b, c]: [[f64; 3]; 3]| {
                let [u, v] = [b, c].map(|to| [0, 1, 2].map(|axis| (to[axis] - a[axis]) / size));
                cross(u, v)
            })
        };
        let normal = fan(0).fold([0.0; 3], |sum, one| [0, 1, 2].map(|axis| sum[axis] + one[axis]));
        let misses = |first: &usize| {
            let mut missed = 0.0;
            fan(*first).any(|one| {
                if dot(one, normal) <= 0.0 {
                    missed += dot(one, one).sqrt();
                }
                missed > MISSED
            })
        };
        (0..polygon.len().min(TRIED)).find(|first| !misses(first)).ok_or_else(|| {
            let count = polygon.len();
            let what = format!("a face of {count} corners, and no fan of triangles covers it");
            Error::new(what, "triangulate the mesh, and export it again")
        })
    }

    fn corner(&self, place: u32) -> Result<[f64; 3]> {
        self.corners
            .get(place as usize)
            .copied()
            .ok_or_else(|| broken(format!("corner {place} does not exist")))
    }

    /// The corners of each triangle.
    ///
    /// # Errors
    ///
    /// If a corner does not exist.
    pub(crate) fn triangles(&self) -> impl Iterator<Item = Result<[[f64; 3]; 3]>> {
        let corner = |place| self.corner(place);
        self.triangles.iter().map(move |&[a, b, c]| Ok([corner(a)?, corner(b)?, corner(c)?]))
    }
}

/// The triangles of a fan from corner number `first`.
pub(crate) fn fan<T: Copy>(polygon: &[T], first: usize) -> impl Iterator<Item = [T; 3]> {
    (1..polygon.len() - 1).map(move |k| [0, k, k + 1].map(|k| polygon[(first + k) % polygon.len()]))
}

/// The error for a broken file; the remedy is to export it again.
pub(crate) fn broken(what: impl Into<String>) -> Error {
    Error::new(what, "export the mesh again, as triangles")
}

/// Maximum length of a line in bytes, enough for a polygon of a hundred thousand corners.
pub(crate) const LONGEST_LINE: usize = 1 << 20;

/// Appends the next line to `line`, with `\n` for its end: CR, LF or CRLF. Returns false at the end
/// of the text.
///
/// # Errors
///
/// The errors of the reader, and a line that makes `line` longer than about [`LONGEST_LINE`].
pub(crate) fn append_line(reader: &mut impl BufRead, line: &mut Vec<u8>) -> io::Result<bool> {
    let before = line.len();
    while line.len() <= LONGEST_LINE {
        let rest = reader.fill_buf()?;
        let end = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        let read = end.map_or(rest.len(), |end| end + 1);
        line.extend(&rest[..read]);
        reader.consume(read);
        if read == 0 {
            return Ok(line.len() > before);
        }
        if end.is_some() {
            if line.pop() == Some(b'\r') && reader.fill_buf()?.first() == Some(&b'\n') {
                reader.consume(1);
            }
            line.push(b'\n');
            return Ok(true);
        }
    }
    Err(io::Error::new(io::ErrorKind::InvalidData, "a line of more than 1 MiB"))
}

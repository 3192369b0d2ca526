//! The object of a picture: a sphere, a mesh or a normal map, or the look-up of a matcap.

use crate::picture::SphereView;
use eigenshade::Normal;
use eigenshade::object::{Matcap, NormalMap};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_shading::picture::Pixel;

/// Pixels across a sphere and a mesh, unless the caller asks for another number.
pub const SIZE: usize = 512;

/// The object of a picture. The pixels of the first two are not stored, because they may be many.
#[derive(Clone, Debug, PartialEq)]
pub enum Object {
    /// A sphere in this many pixels across, as in [`SphereView`].
    Sphere(usize),
    /// The texels of a matcap.
    Matcap(Matcap),
    /// The object of a file.
    View(ObjectView),
}

impl Object {
    /// Pixels across and down.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        match self {
            Self::Sphere(size) => [*size; 2],
            Self::Matcap(texels) => [texels.size(); 2],
            Self::View(view) => [view.width, view.height],
        }
    }

    /// The pixels, row by row from the top, each with its unit normal, z >= 0.
    #[must_use]
    pub fn pixels(&self) -> Box<dyn Iterator<Item = (Pixel, [f64; 3])> + '_> {
        match self {
            Self::Sphere(size) => Box::new(SphereView::pixels(*size)),
            Self::Matcap(texels) => Box::new(texels.clone().map(|texel| {
                let normal = texel.normal().components().map(f64::from);
                let (column, row, is_inside) = (texel.column(), texel.row(), normal[2] > 0.0);
                (Pixel { column, row, coverage: 1.0, is_inside }, normal)
            })),
            Self::View(view) => {
                Box::new(view.pixels.iter().copied().zip(view.normals.iter().copied()))
            }
        }
    }
}

/// The pixels of a picture that an object covers at least in part.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectView {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The pixels, row by row from the top.
    pub pixels: Vec<Pixel>,
    /// The unit normal of each pixel, with z >= 0.
    pub normals: Vec<[f64; 3]>,
}

/// How the object of a file is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ObjectOptions {
    /// Pixels across; by default [`SIZE`], and those of the file for a normal map, which can only
    /// shrink.
    pub size: Option<usize>,
    /// Whether green points down in a normal map.
    pub flip_green: bool,
    /// Whether the facets of a mesh have their own normals alone.
    pub is_flat: bool,
    /// The rotation of a mesh, by rows.
    pub rotation: Option<[[f64; 3]; 3]>,
}

impl ObjectOptions {
    /// The default options with this number of pixels across.
    #[must_use]
    pub fn of_size(size: Option<usize>) -> Self {
        Self { size, ..Self::default() }
    }

    /// How a mesh is looked at.
    #[cfg(feature = "generate")]
    #[must_use]
    pub fn view(&self) -> eigenshade_generator::object::surface::View {
        let view = eigenshade_generator::object::surface::View::default();
        let rotation = self.rotation.unwrap_or(view.rotation);
        eigenshade_generator::object::surface::View { is_flat: self.is_flat, rotation }
    }

    /// Fails if an option is not for this kind of object.
    pub fn check(&self, file: &InputFile) -> Result<()> {
        if self.flip_green && file.extension() != "png" {
            let what = "--flip-green is for a normal map (.png)";
            return Err(Error::new(what, "leave it out").in_file(file.path()));
        }
        if (self.is_flat || self.rotation.is_some()) && !is_mesh(file) {
            let what = "--flat, --view and --rotate-object are for a mesh";
            return Err(Error::new(what, "leave them out").in_file(file.path()));
        }
        Ok(())
    }
}

impl ObjectView {
    /// The object of a file: a normal map (.png) or a mesh (.obj, .stl, .ply, .glb, .gltf) from +z; or
    /// a sphere, if its name is `sphere`. Fails if the file has another extension, cannot be read, shows
    /// nothing or is smaller than the size asked for, or if an option is not for such an object.
    pub fn read(file: InputFile, options: ObjectOptions) -> Result<Self> {
        options.check(&file)?;
        if file.path().as_os_str() == "sphere" {
            return Ok(Self::sphere(options.size.unwrap_or(SIZE)));
        }
        if file.extension() != "png" && !is_mesh(&file) {
            let remedy =
                "use `sphere`, a normal map (.png) or a mesh (.obj, .stl, .ply, .glb, .gltf)";
            return Err(Error::new("unknown kind of object", remedy).in_file(file.path()));
        }
        of_file(file, options)
    }

    /// A sphere, as in [`SphereView`].
    #[must_use]
    pub fn sphere(size: usize) -> Self {
        let SphereView { size, pixels, normals } = SphereView::new(size);
        Self { width: size, height: size, pixels, normals }
    }

    /// The codes of a [`NormalMap`] of this picture, row by row. A pixel that the object covers in
    /// part refers to the neighbor with the nearest normal. If it has no neighbor that the object
    /// covers completely, it is drawn whole from a coverage of one half on. Fails if a normal is
    /// not visible.
    pub fn codes(&self) -> Result<Vec<[u8; 2]>> {
        let mut whole = vec![None; self.width * self.height];
        let place = |pixel: &Pixel| pixel.row * self.width + pixel.column;
        let covered = self.pixels.iter().zip(&self.normals);
        for (pixel, normal) in covered.clone().filter(|(pixel, _)| pixel.coverage >= WHOLE) {
            whole[place(pixel)] = Some(*normal);
        }
        let mut codes = vec![NormalMap::BACKGROUND; whole.len()];
        for (pixel, normal) in covered.filter(|(pixel, _)| pixel.coverage >= 1.0 - WHOLE) {
            codes[place(pixel)] = match self.nearest(pixel, *normal, &whole) {
                _ if pixel.coverage >= WHOLE => code(*normal)?,
                Some(step) => NormalMap::edge_code((255.0 * pixel.coverage).round() as u8, step),
                None if pixel.coverage >= 0.5 => code(*normal)?,
                None => NormalMap::BACKGROUND,
            };
        }
        Ok(codes)
    }

    /// The step to the neighbor whose normal is nearest to this one.
    fn nearest(
        &self,
        pixel: &Pixel,
        normal: [f64; 3],
        whole: &[Option<[f64; 3]>],
    ) -> Option<[i8; 2]> {
        let steps = (-1..=1).flat_map(|down| (-1..=1).map(move |right| [right, down]));
        let found = steps.filter_map(|[right, down]: [i8; 2]| {
            let column = pixel.column.checked_add_signed(right.into())?;
            let row = pixel.row.checked_add_signed(down.into())?;
            let other =
                if column < self.width { *whole.get(row * self.width + column)? } else { None };
            let cosine: f64 = other?.iter().zip(normal).map(|(a, b)| a * b).sum();
            Some((cosine, [right, down]))
        });
        found.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, step)| step)
    }
}

/// Whether a file has the extension of a mesh, or of glTF.
#[must_use]
pub fn is_mesh(file: &InputFile) -> bool {
    file.is_mesh() || is_gltf(file)
}

fn is_gltf(file: &InputFile) -> bool {
    ["glb", "gltf"].contains(&file.extension().as_str())
}

/// The coverage from which on a pixel is whole in a [`NormalMap`].
const WHOLE: f64 = 1.0 - 1.0 / 64.0;

fn code([x, y, z]: [f64; 3]) -> Result<[u8; 2]> {
    let normal = Normal::new(x as f32, y as f32, z as f32);
    let fault = |error: eigenshade::Error| Error::new(error.to_string(), "check the object");
    Ok(NormalMap::code(normal.map_err(fault)?))
}

/// The object of a mesh or a normal map.
#[cfg(feature = "generate")]
fn of_file(file: InputFile, options: ObjectOptions) -> Result<ObjectView> {
    use eigenshade_generator::object::picture::{Picture, Shown};
    let ObjectOptions { size, flip_green, .. } = options;
    if is_gltf(&file) {
        return of_gltf(&file, options);
    }
    let picture = if file.is_mesh() {
        Picture::of_mesh(file, size.unwrap_or(SIZE), &options.view())
    } else {
        Picture::of_map(file, size, flip_green)
    };
    let Picture { width, height, pixels: all } = picture?;
    let (mut pixels, mut normals) = (Vec::new(), Vec::new());
    for (place, shown) in all.into_iter().enumerate() {
        let Some(Shown { normal, coverage }) = shown else { continue };
        let (row, column) = (place / width, place % width);
        pixels.push(Pixel { column, row, coverage, is_inside: coverage >= 0.5 });
        normals.push(normal);
    }
    Ok(ObjectView { width, height, pixels, normals })
}

/// The mean normals of the pixels of a glTF file, whatever its materials.
#[cfg(feature = "generate")]
fn of_gltf(file: &InputFile, options: ObjectOptions) -> Result<ObjectView> {
    use eigenshade_asset::{asset::Asset, texels::Samples};
    use eigenshade_model::inputs::normals::visible;
    let asset = Asset::read(file)?.unwrap_or_default();
    let size = options.size.unwrap_or(SIZE);
    let samples = Samples::new(file, &asset, size, &options.view())?;
    let mut view =
        ObjectView { width: size, height: size, pixels: Vec::new(), normals: Vec::new() };
    for row in 0..size {
        let found = samples.rows(row..row + 1);
        let mut texels = found.texels.iter().zip(&found.shares);
        for covered in &found.pixels {
            let mut sum = [0.0; 3];
            for (texel, share) in texels.by_ref().take(covered.texels) {
                let parts = sum.iter_mut().zip(texel.normal);
                parts.for_each(|(sum, part)| *sum += f64::from(*share) * part);
            }
            let Ok(normal) = visible(sum) else { continue };
            view.pixels.push(covered.pixel());
            view.normals.push(normal);
        }
    }
    Ok(view)
}

#[cfg(not(feature = "generate"))]
fn of_file(file: InputFile, _: ObjectOptions) -> Result<ObjectView> {
    let remedy = "build with the feature `generate`, or leave the object out";
    Err(Error::new("this build reads no meshes and no normal maps", remedy).in_file(file.path()))
}

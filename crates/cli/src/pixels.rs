//! The pixels of an image: a photograph or rendering as irradiance, which is linear values with a
//! weight for each pixel, and the normal of each pixel.

use crate::object::{ObjectOptions, ObjectView, is_mesh};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::object::normal_map;
use eigenshade_generator::png_samples::{self, Curve};
use eigenshade_generator::reading::observation::LARGEST;
use eigenshade_model::database::luminance;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use eigenshade_model::srgb::linear;
use eigenshade_model::vector::dot;
use eigenshade_shading::picture::Pixel;
use std::path::Path;

/// By how much rounding may leave an opacity outside 0 to 1.
const OPACITY_SLACK: f32 = 1e-3;

/// Colors that were multiplied by less have too few digits.
const LEAST_OPACITY: f32 = 1.0 / 255.0;

/// How the samples of a PNG encode light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Transfer {
    /// Proportional to the light
    Linear,
    /// The curve of IEC 61966-2-1
    Srgb,
}

/// An image in linear units.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearImage {
    /// Width and height in pixels; `None` for a list of pixels.
    pub size: Option<[usize; 2]>,
    /// r, g, b of each pixel, row by row from the top. The full scale of a PNG is 1.
    pub pixels: Vec<[f64; 3]>,
    /// The weight of each pixel: its opacity, or 0 if it is clipped.
    pub weights: Vec<f64>,
    /// The number of pixels left out because one of their channels is at full scale.
    pub clipped: usize,
    /// The number of pixels left out because they are transparent.
    pub transparent: usize,
}

impl LinearImage {
    /// Reads a `.png`, an environment map's file types (`.exr`, `.hdr`, `.pfm`), or a CSV with the
    /// columns `r,g,b` or `value` and one row per pixel.
    ///
    /// Without a `transfer`, a PNG is read with the curve that it declares ([`Curve`]). A PNG that
    /// declares no curve is read as sRGB if it has 8 bits, as cameras and programs write such
    /// files, and as linear if it has 16. The other types are linear, and the colors of an `.exr`
    /// are divided by its opacity. The true value of a clipped pixel is unknown, so its weight is 0.
    ///
    /// Fails if the file has another type, cannot be read or is broken; if a transfer is given for
    /// a type that has none, or none is given for a PNG that declares another curve; if numbers are
    /// not finite.
    pub fn read(file: impl Into<InputFile>, transfer: Option<Transfer>) -> Result<Self> {
        let file = file.into();
        let path = file.path();
        let ending = file.extension();
        if ending == "png" {
            return Self::of_png(&file, transfer);
        }
        if transfer.is_some() {
            let what = "only PNGs have a transfer function; this file is linear";
            return Err(Error::new(what, "leave --transfer out").in_file(path));
        }
        match ending.as_str() {
            "csv" => Self::of_csv(file),
            "exr" => {
                let (map, opacities) = EnvironmentMap::with_opacities(file.clone())?;
                let mut image = Self::of_map(&map);
                image.uncover(&opacities).map_err(|error| error.in_file(path))?;
                Ok(image)
            }
            "hdr" | "pfm" => Ok(Self::of_map(&EnvironmentMap::from_path(file)?)),
            _ => {
                let remedy = "give a file that ends in .png, .exr, .hdr, .pfm or .csv";
                Err(Error::new("it is not an image of a supported type", remedy).in_file(path))
            }
        }
    }

    fn of_map(map: &EnvironmentMap) -> Self {
        let pixels = map.texels.iter().map(|texel| texel.map(f64::from)).collect();
        Self::whole(Some([map.width, map.height]), pixels)
    }

    /// Divides the pixels by their opacities, which become their weights.
    fn uncover(&mut self, opacities: &[f32]) -> Result<()> {
        let allowed = -OPACITY_SLACK..=1.0 + OPACITY_SLACK;
        if let Some(at) = opacities.iter().position(|opacity| !allowed.contains(opacity)) {
            let what = format!("the opacity of pixel {at} in its channel A is {}", opacities[at]);
            let remedy = "give opacities from 0 to 1, or save the picture without the channel A";
            return Err(Error::new(what, remedy));
        }
        let pixels = self.pixels.iter_mut().zip(&mut self.weights);
        for ((pixel, weight), &opacity) in pixels.zip(opacities) {
            if opacity < LEAST_OPACITY {
                *weight = 0.0;
                self.transparent += 1;
            } else {
                *weight = f64::from(opacity.min(1.0));
                *pixel = pixel.map(|value| value / *weight);
            }
        }
        Ok(())
    }

    fn whole(size: Option<[usize; 2]>, pixels: Vec<[f64; 3]>) -> Self {
        Self { size, weights: vec![1.0; pixels.len()], pixels, clipped: 0, transparent: 0 }
    }

    fn of_png(file: &InputFile, transfer: Option<Transfer>) -> Result<Self> {
        let png = png_samples::read(file.clone())?.upright();
        let full = f64::from(png.full);
        let transfer = match (transfer, &png.curve) {
            (Some(transfer), _) => transfer,
            (None, Curve::Linear) => Transfer::Linear,
            (None, Curve::Srgb) => Transfer::Srgb,
            (None, Curve::Undeclared) if png.full == u16::from(u8::MAX) => Transfer::Srgb,
            (None, Curve::Undeclared) => Transfer::Linear,
            (None, curve @ (Curve::Profile(_) | Curve::Other(_))) => {
                let what = match curve {
                    Curve::Other(what) => what,
                    _ => "it has a color profile",
                };
                let what = format!("{what}, which is not a supported transfer function");
                let remedy = "give --transfer linear or --transfer srgb";
                return Err(Error::new(what, remedy).in_file(file.path()));
            }
        };
        let value = |sample: u16| match transfer {
            Transfer::Linear => f64::from(sample) / full,
            Transfer::Srgb => linear(f64::from(sample) / full),
        };
        let color = |color: &[u16; 3]| {
            let color = color.map(value);
            png.to_srgb.map_or(color, |matrix| matrix.map(|row| dot(row, color)))
        };
        let pixels = png.colors.iter().map(color).collect();
        let mut image = Self::whole(Some([png.width, png.height]), pixels);
        for ((weight, color), opacity) in
            image.weights.iter_mut().zip(&png.colors).zip(&png.opacities)
        {
            let clips = color.contains(&png.full);
            *weight = if clips { 0.0 } else { f64::from(*opacity) / full };
            image.transparent += usize::from(*opacity == 0);
            image.clipped += usize::from(clips && *opacity > 0);
        }
        Ok(image)
    }

    fn of_csv(file: InputFile) -> Result<Self> {
        let sheet = Sheet::read(file, "r,g,b")?;
        let columns = sheet.colors()?.ok_or_else(|| sheet.wrong_header("`r,g,b` or `value`"))?;
        let pixels = sheet.rows().map(|row| row.numbers(columns)).collect::<Result<_>>()?;
        Ok(Self::whole(None, pixels))
    }

    /// Whether the three channels are equal in every pixel.
    #[must_use]
    pub fn is_gray(&self) -> bool {
        self.pixels.iter().all(|[r, g, b]| r == g && g == b)
    }
}

/// Reads the unit normal, z >= 0, of each pixel of an image of this size; `None` where there is no
/// object.
///
/// `file` is one of four: the name `sphere`, for a centered sphere that fills the image as in
/// [`SphereView`](crate::picture::SphereView); a mesh, drawn as large; a PNG of the image's size, read as a [`normal_map`]; or a
/// CSV `x,y,z` with a row for each pixel, row by row. `counts` states for each pixel whether it is
/// used; in a normal map, unused pixels may face away. A pixel at the rim, which an object covers in
/// part, has no normal.
///
/// Fails if `sphere` or a mesh is given for an image without a size, an option is not for such an
/// object, the file has another size than the image, or the file cannot be read.
pub fn normals(
    file: &InputFile,
    size: Option<[usize; 2]>,
    counts: &[bool],
    options: ObjectOptions,
) -> Result<Vec<Option<[f64; 3]>>> {
    options.check(file)?;
    let is_sphere = file.path() == Path::new("sphere");
    if is_sphere || is_mesh(file) {
        let size = size.ok_or_else(|| {
            let what = if is_sphere { "sphere" } else { "mesh" };
            let remedy = "give --normals a CSV with a row for each of them";
            Error::new(format!("a list of pixels shows no {what}"), remedy)
        })?;
        return centered(file, size, options);
    }
    let found: Vec<_> = match file.extension().as_str() {
        "png" => normals_of_png(file, size, counts, options.flip_green)?,
        _ => read_normals(file.clone())?.into_iter().map(Some).collect(),
    };
    if found.len() != counts.len() {
        let what = format!("it holds {} normals, the image {} pixels", found.len(), counts.len());
        let remedy = "give one normal for each pixel, row by row from the top";
        return Err(Error::new(what, remedy).in_file(file.path()));
    }
    Ok(found)
}

/// The normals of a sphere or a mesh that fills the largest square in the middle of an image.
fn centered(
    file: &InputFile,
    [width, height]: [usize; 2],
    options: ObjectOptions,
) -> Result<Vec<Option<[f64; 3]>>> {
    let side = width.min(height);
    let view = ObjectView::read(file.clone(), ObjectOptions { size: Some(side), ..options })?;
    let is_whole = |pixel: &Pixel| match is_mesh(file) {
        true => pixel.coverage >= 1.0,
        false => pixel.is_inside,
    };
    let (left, top) = ((width - side) / 2, (height - side) / 2);
    let mut normals = vec![None; width * height];
    let shown = view.pixels.iter().zip(view.normals);
    for (pixel, normal) in shown.filter(|(pixel, _)| is_whole(pixel)) {
        normals[(top + pixel.row) * width + left + pixel.column] = Some(normal);
    }
    Ok(normals)
}

fn normals_of_png(
    file: &InputFile,
    size: Option<[usize; 2]>,
    counts: &[bool],
    flip_green: bool,
) -> Result<Vec<Option<[f64; 3]>>> {
    let path = file.path();
    let png = normal_map::load(file, flip_green)?;
    let (width, height) = (png.width, png.height);
    let what = match size {
        Some([w, h]) if [w, h] != [width, height] => format!("the image {w} x {h}"),
        None if counts.len() != width * height => format!("the image has {}", counts.len()),
        _ => return normal_map::normals(&png, counts).map_err(|error| error.in_file(path)),
    };
    let what = format!("it is {width} x {height} pixels, {what}");
    Err(Error::new(what, "give a normal map of the image's size").in_file(path))
}

/// Reads a weight for each pixel, either from a PNG of the image's size (luminance times opacity, 0
/// to 1) or from a CSV with the column `weight` (0 or more). Fails if the file has another size
/// than the image, a weight is negative, or the file cannot be read.
pub fn weights(file: &InputFile, size: Option<[usize; 2]>, count: usize) -> Result<Vec<f64>> {
    let is_png = file.extension() == "png";
    let found = if is_png { weights_of_png(file, size)? } else { weights_of_csv(file)? };
    if found.len() != count {
        let what = format!("it holds {} weights, the image {count} pixels", found.len());
        let remedy = "give one weight for each pixel, row by row from the top";
        return Err(Error::new(what, remedy).in_file(file.path()));
    }
    Ok(found)
}

fn weights_of_png(file: &InputFile, size: Option<[usize; 2]>) -> Result<Vec<f64>> {
    let png = png_samples::read(file.clone())?.upright();
    if let Some([width, height]) = size
        && (width, height) != (png.width, png.height)
    {
        let (w, h) = (png.width, png.height);
        let what = format!("it is {w} x {h} pixels, the image {width} x {height}");
        return Err(Error::new(what, "give a mask of the image's size").in_file(file.path()));
    }
    let full = f64::from(png.full);
    let weight = |(color, opacity): (&[u16; 3], &u16)| {
        let share = color.map(|sample| f64::from(sample) / full);
        luminance(share) * f64::from(*opacity) / full
    };
    Ok(png.colors.iter().zip(&png.opacities).map(weight).collect())
}

fn weights_of_csv(file: &InputFile) -> Result<Vec<f64>> {
    let sheet = Sheet::read(file.clone(), "weight")?;
    let [column] = sheet.columns(["weight"]).ok_or_else(|| sheet.wrong_header("`weight`"))?;
    let weight = |row: Row<'_>| {
        let weight = row.number(column)?;
        if weight != 0.0 && !(1.0 / LARGEST..=LARGEST).contains(&weight) {
            let remedy = "give 0, or weights from 1e-100 to 1e100";
            return Err(row.fault(format!("the weight is {weight}"), remedy));
        }
        Ok(weight)
    };
    sheet.rows().map(weight).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_are_divided_by_their_opacities() {
        let covered = |opacities: &[f32]| {
            let pixels = vec![[0.5, 0.25, 0.0]; opacities.len()];
            let mut image = LinearImage::whole(None, pixels);
            image.uncover(opacities).map(|()| image)
        };
        let image = covered(&[0.5, 1.0, 0.0, 1.0005]).unwrap();
        assert_eq!(image.pixels[..2], [[1.0, 0.5, 0.0], [0.5, 0.25, 0.0]]);
        assert_eq!(image.weights, [0.5, 1.0, 0.0, 1.0]);
        assert_eq!((image.transparent, image.clipped), (1, 0));
        for bad in [f32::NAN, -0.5, 2.0, f32::INFINITY] {
            let error = covered(&[1.0, bad]).unwrap_err().to_string();
            assert!(error.contains(&format!("the opacity of pixel 1 in its channel A is {bad}")));
        }
    }
}

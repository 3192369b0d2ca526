//! How far pictures from a palette of normals are from those with every pixel shaded.

use crate::numbers::digits;
use eigenshade::object::{Disc, DiscPixel, NormalMap, NormalPixel};
use eigenshade::screen::{Display, Exposure, Meter, Palette, Tone};
use eigenshade::sphere::color::{self, Scene};
use eigenshade::{Light, Material, Rgb};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_model::shipped;
use indicatif::ProgressBar;
use palette::color_difference::Ciede2000;
use palette::{IntoColor, Lab, Srgb};

/// The lights of the pictures.
pub const LIGHTS: [&str; 5] = ["lobby", "studio", "forest", "night", "sky"];
/// The diameter of the sphere in pixels.
pub const SIZE: usize = 240;

pub const COLUMNS: &str = "material,light,rgb565_mean,rgb565_p95,palette_mean,palette_p95,\
    palette565_mean,palette565_p95,palette_worst";

static DISPLAY: Display = Display::new(Tone::Linear);

/// CIEDE2000 over the pixels of a picture, against every pixel shaded and not rounded: the mean, what
/// 95 of 100 pixels do not exceed, and the largest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    pub mean: f64,
    pub p95: f64,
    pub worst: f64,
}

/// The errors of one picture.
#[derive(Clone, Debug)]
pub struct Row {
    pub material: String,
    pub light: &'static str,
    /// Every pixel shaded and rounded to RGB565.
    pub rgb565: Errors,
    /// The palette with 8 bits a channel.
    pub palette: Errors,
    /// The palette in RGB565.
    pub palette565: Errors,
}

impl Row {
    #[must_use]
    pub fn fields(&self) -> Vec<String> {
        let pairs = [self.rgb565, self.palette, self.palette565];
        let numbers = pairs.into_iter().flat_map(|errors| [errors.mean, errors.p95]);
        let numbers = numbers.chain([self.palette.worst]).map(|one| digits(one, 3));
        [self.material.clone(), self.light.into()].into_iter().chain(numbers).collect()
    }
}

/// The errors of all shipped materials in color under [`LIGHTS`], or of those with these names.
///
/// # Errors
///
/// If a shipped file is damaged.
pub fn errors(names: &[&str], bar: &ProgressBar) -> Result<Vec<Row>> {
    let (lights, materials) = (shipped::lights()?, shipped::named_materials(7)?);
    let chosen = |named: &&Named| names.is_empty() || names.contains(&named.name.as_str());
    let materials: Vec<&Named> = materials.entries.iter().filter(chosen).collect();
    let mut codes = vec![NormalMap::BACKGROUND; SIZE * SIZE];
    NormalMap::sphere(SIZE, &mut codes).map_err(fault)?;
    let map = NormalMap::new(SIZE, SIZE, codes.as_flattened()).map_err(fault)?;
    let rows = parallel::map(materials.len(), bar, |k| {
        let rows = LIGHTS.map(|light| row(materials[k], light, &lights.entries, &map));
        rows.into_iter().collect::<Result<Vec<Row>>>()
    });
    Ok(rows.into_iter().collect::<Result<Vec<_>>>()?.concat())
}

fn fault(error: eigenshade::Error) -> Error {
    Error::new(error.to_string(), "a defect: please report it")
}

fn row(
    material: &Named,
    light: &'static str,
    lights: &[Named],
    map: &NormalMap<'_>,
) -> Result<Row> {
    let found = lights.iter().find(|named| named.name == light);
    let of_light = found.ok_or_else(|| Error::new(format!("no light {light}"), "restore it"))?;
    let [light_numbers, material_numbers] =
        [(of_light, 100), (material, 40)].map(|(named, most)| {
            named.rgb.each_ref().map(|channel| {
                let numbers = channel.iter().take(most).map(|&number| number as f32);
                numbers.collect::<Vec<f32>>()
            })
        });
    let [r, g, b] = light_numbers.each_ref().map(|numbers| Light::new(numbers));
    let lights = Rgb { r: r.map_err(fault)?, g: g.map_err(fault)?, b: b.map_err(fault)? };
    let [r, g, b] = material_numbers.each_ref().map(|numbers| Material::new(numbers));
    let materials = Rgb { r: r.map_err(fault)?, g: g.map_err(fault)?, b: b.map_err(fault)? };
    let scene = color::scene(lights, materials).map_err(fault)?;
    let (rgb565, palette, palette565) = compared(&scene, map);
    Ok(Row { material: material.name.clone(), light, rgb565, palette, palette565 })
}

/// The three errors of a scene.
fn compared(scene: &Scene, map: &NormalMap<'_>) -> (Errors, Errors, Errors) {
    let pixels = || Disc::new(SIZE).into_iter().flatten();
    let mut meter = Meter::default();
    pixels().for_each(|pixel| meter.add(scene.shade(pixel.normal())));
    let exposure = meter.exposure().unwrap_or_default();
    let mut palette = Palette::default();
    palette.fill(&map.nodes(), &DISPLAY, |normal| exposure.of(scene.shade(normal)));
    let whole: Vec<NormalPixel> = map.pixels().filter(|pixel| pixel.coverage() == 255).collect();
    let places: Vec<usize> = whole.iter().map(|pixel| pixel.index()).collect();
    let exact: Vec<DiscPixel> =
        pixels().filter(|pixel| places.binary_search(&pixel.index()).is_ok()).collect();
    let shaded = |pixel: &DiscPixel, exposure: Exposure| exposure.of(scene.shade(pixel.normal()));
    let reference: Vec<Lab> = exact
        .iter()
        .map(|pixel| {
            let encoded = shaded(pixel, exposure).map(|one| DISPLAY.encode(one.into()));
            lab(encoded.map(|one| f32::from(one) / 65_535.0))
        })
        .collect();
    let against = |found: Vec<Lab>| summed(&reference, &found);
    (
        against(exact.iter().map(|one| lab565(DISPLAY.rgb565(shaded(one, exposure)))).collect()),
        against(
            whole
                .iter()
                .map(|one| lab(palette.rgb888(one.code()).map(|one| f32::from(one) / 255.0)))
                .collect(),
        ),
        against(whole.iter().map(|one| lab565(palette.rgb565(one.code()))).collect()),
    )
}

fn lab565(pixel: u16) -> Lab {
    let level = |shift: u32, most: u16| f32::from(pixel >> shift & most) / f32::from(most);
    lab(Rgb { r: level(11, 31), g: level(5, 63), b: level(0, 31) })
}

fn lab(Rgb { r, g, b }: Rgb<f32>) -> Lab {
    Srgb::new(r, g, b).into_linear().into_color()
}

fn summed(reference: &[Lab], found: &[Lab]) -> Errors {
    assert_eq!(reference.len(), found.len(), "the pixels of both are the same");
    let mut apart: Vec<f64> =
        reference.iter().zip(found).map(|(&a, &b)| f64::from(a.difference(b))).collect();
    apart.sort_by(f64::total_cmp);
    let count = apart.len().max(1);
    let at = |share: usize| apart.get(apart.len() * share / 100).copied().unwrap_or_default();
    Errors {
        mean: apart.iter().sum::<f64>() / count as f64,
        p95: at(95),
        worst: apart.last().copied().unwrap_or_default(),
    }
}

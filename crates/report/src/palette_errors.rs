//! How far pictures from a palette of normals are from those with every pixel shaded.

use crate::numbers::digits;
use eigenshade::object::{Disc, DiscPixel, NormalMap, NormalPixel};
use eigenshade::presets::{light, sources};
use eigenshade::screen::{Display, Meter, Palette, Tone};
use eigenshade::sphere::color;
use eigenshade::{Gloss, Highlights, Light, Material, Normal, Rgb, Rotation, Source};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::parallel;
use eigenshade_model::shipped;
use indicatif::ProgressBar;
use palette::color_difference::Ciede2000;
use palette::{IntoColor, Lab, LinSrgb, Srgb};
use std::collections::BTreeMap;

/// The lights of the pictures.
pub const LIGHTS: [&str; 5] = ["lobby", "studio", "forest", "night", "sky"];
/// The roughnesses of a glTF material whose highlights are sharp.
pub const ROUGHNESSES: [f32; 4] = [0.2, 0.3, 0.4, 0.5];
/// The diameter of the sphere in pixels.
pub const SIZE: usize = 240;

/// The ways that are compared, each by its mean and its 95th percentile: RGB565 with every pixel
/// shaded; the palette with 8 bits a channel, in RGB565, and in dithered RGB565; as means of 4 x 4
/// pixels, both kinds of RGB565 from the palette, and both with every pixel shaded; every pixel shaded
/// under light of degree 2; and a picture that stands still while the light turns by [`TURN`].
pub const COLUMNS: &str = "material,light,rgb565_mean,rgb565_p95,palette_mean,palette_p95,\
    palette565_mean,palette565_p95,dithered_mean,dithered_p95,blurred565_mean,blurred565_p95,\
    blurred_dithered_mean,blurred_dithered_p95,shaded_blurred565_mean,shaded_blurred565_p95,\
    shaded_blurred_dithered_mean,shaded_blurred_dithered_p95,degree2_mean,degree2_p95,still_mean,still_p95,\
    palette_worst";

/// Degrees by which the light turns about the vertical axis where a picture stands still.
pub const TURN: f32 = 30.0;

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
    /// In the order of [`COLUMNS`].
    pub errors: [Errors; 10],
}

impl Row {
    #[must_use]
    pub fn fields(&self) -> Vec<String> {
        let [_, palette, ..] = self.errors;
        let numbers = self.errors.into_iter().flat_map(|errors| [errors.mean, errors.p95]);
        let numbers = numbers.chain([palette.worst]).map(|one| digits(one, 3));
        [self.material.clone(), self.light.into()].into_iter().chain(numbers).collect()
    }
}

/// The errors of all shipped materials in color under [`LIGHTS`], and of glTF's copper of
/// [`ROUGHNESSES`] with four sources of each light, or of those with these names.
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
    let mut rows = rows.into_iter().collect::<Result<Vec<_>>>()?.concat();
    for roughness in ROUGHNESSES {
        let name = format!("copper-{roughness}");
        if names.is_empty() || names.contains(&name.as_str()) {
            for light in LIGHTS {
                let errors = of_copper(roughness, light, &map).map_err(fault)?;
                rows.push(Row { material: name.clone(), light, errors });
            }
        }
    }
    Ok(rows)
}

/// The errors of a glTF material under a light, its four brightest sources as highlights.
fn of_copper(roughness: f32, light: &str, map: &NormalMap<'_>) -> Compared {
    let color = [0.93, 0.52, 0.38];
    let material = Material::metallic_roughness(color, 1.0, roughness)?;
    let gloss = Gloss::metallic_roughness(color, 1.0, roughness)?;
    let (of_light, sources) = match light {
        "studio" => (light::STUDIO, sources::STUDIO.as_slice()),
        "forest" => (light::FOREST, sources::FOREST.as_slice()),
        "night" => (light::NIGHT, sources::NIGHT.as_slice()),
        "sky" => (light::SKY, sources::SKY.as_slice()),
        _ => (light::LOBBY, sources::LOBBY.as_slice()),
    };
    let sources = sources.split_at_checked(4).map_or(sources, |(four, _)| four);
    let rest = of_light.residual::<100>(sources)?;
    let rotation = Rotation::from_euler(TURN.to_radians(), 0.0, 0.0)?;
    let turned_sources: Vec<Source> = sources.iter().map(|one| one.turned(rotation)).collect();
    let [here, there] = [sources, &turned_sources].map(|all| Highlights::<4>::new(&gloss, all));
    let (here, there) = (here?, there?);
    let scene = color::scene(rest.lights()?, material.materials()?)?;
    let turned = rest.lights()?.turned::<100>(&rotation)?;
    let turned = color::scene(turned.lights()?, material.materials()?)?;
    let coarse = color::scene(of_light.map(|one| one.truncated(2)), material.materials()?)?;
    compared(
        [
            &|normal| scene.shade(normal) + here.shade(normal),
            &|normal| coarse.shade(normal),
            &|normal| turned.shade(normal) + there.shade(normal),
        ],
        map,
    )
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
    let errors = of_material(lights, materials, map).map_err(fault)?;
    Ok(Row { material: material.name.clone(), light, errors })
}

/// The errors of one material under one light.
fn of_material(
    light: Rgb<Light<'_>>,
    material: Rgb<Material<'_>>,
    map: &NormalMap<'_>,
) -> Compared {
    let scene = color::scene(light, material)?;
    let coarse = color::scene(light.map(|light| light.truncated(2)), material)?;
    let rotation = Rotation::from_euler(TURN.to_radians(), 0.0, 0.0)?;
    let turned = light.turned::<100>(&rotation)?;
    let turned = color::scene(turned.lights()?, material)?;
    compared([&|one| scene.shade(one), &|one| coarse.shade(one), &|one| turned.shade(one)], map)
}

/// The irradiance of a normal.
type Shade<'s> = &'s dyn Fn(Normal) -> Rgb<f32>;

type Compared = std::result::Result<[Errors; 10], eigenshade::Error>;

/// The errors of a picture, and against it those under light of degree 2 and under a turned light.
fn compared([scene, coarse, turned]: [Shade<'_>; 3], map: &NormalMap<'_>) -> Compared {
    let exact: Vec<DiscPixel> =
        Disc::new(SIZE)?.filter(|pixel| pixel.coverage() == u8::MAX).collect();
    let mut meter = Meter::default();
    exact.iter().for_each(|pixel| meter.add(scene(pixel.normal())));
    let exposure = meter.exposure().unwrap_or_default();
    let mut palette = Palette::default();
    palette.fill(&map.nodes(), &DISPLAY, |normal| exposure.of(scene(normal)));
    let whole: Vec<NormalPixel> = map.pixels().filter(|pixel| pixel.coverage() == 255).collect();
    // The pixels that both have.
    let places: Vec<usize> = whole.iter().map(|pixel| pixel.index()).collect();
    let exact: Vec<DiscPixel> =
        exact.into_iter().filter(|pixel| places.binary_search(&pixel.index()).is_ok()).collect();
    let places: Vec<usize> = exact.iter().map(|pixel| pixel.index()).collect();
    let whole: Vec<NormalPixel> =
        whole.into_iter().filter(|pixel| places.binary_search(&pixel.index()).is_ok()).collect();

    let shaded = |scene: Shade<'_>| -> Vec<Rgb<f32>> {
        exact.iter().map(|pixel| exposure.of(scene(pixel.normal()))).collect()
    };
    let encoded = |shaded: Vec<Rgb<f32>>| -> Vec<Srgb> {
        let displayed =
            |color: Rgb<f32>| color.map(|one| f32::from(DISPLAY.encode(one.into())) / 65_535.0);
        shaded.into_iter().map(|color| srgb(displayed(color))).collect()
    };
    let rounded = |scene: Shade<'_>| -> Vec<Srgb> {
        shaded(scene).into_iter().map(|color| of565(DISPLAY.rgb565(color))).collect()
    };
    let reference = encoded(shaded(scene));
    let nearest: Vec<Srgb> = whole.iter().map(|one| of565(palette.rgb565(one.code()))).collect();
    let dithered: Vec<Srgb> = whole
        .iter()
        .map(|one| of565(palette.dithered().rgb565(one.code(), one.column(), one.row())))
        .collect();
    let shaded_dithered: Vec<Srgb> = exact
        .iter()
        .map(|one| {
            let color = exposure.of(scene(one.normal()));
            of565(DISPLAY.rgb565_dithered(color, one.column(), one.row()))
        })
        .collect();
    let fine: Vec<Srgb> = whole
        .iter()
        .map(|one| srgb(palette.rgb888(one.code()).map(|one| f32::from(one) / 255.0)))
        .collect();
    let blurred = |picture: &[Srgb]| blurred(&places, picture);
    Ok([
        summed(&reference, &rounded(scene)),
        summed(&reference, &fine),
        summed(&reference, &nearest),
        summed(&reference, &dithered),
        summed(&blurred(&reference), &blurred(&nearest)),
        summed(&blurred(&reference), &blurred(&dithered)),
        summed(&blurred(&reference), &blurred(&rounded(scene))),
        summed(&blurred(&reference), &blurred(&shaded_dithered)),
        summed(&reference, &rounded(coarse)),
        summed(&encoded(shaded(turned)), &rounded(scene)),
    ])
}

/// Means of 4 x 4 pixels in linear light, where all 16 are given.
fn blurred(places: &[usize], picture: &[Srgb]) -> Vec<Srgb> {
    let mut sums = BTreeMap::new();
    for (&place, color) in places.iter().zip(picture) {
        let tile = (place / SIZE / 4, place % SIZE / 4);
        let (count, sum): &mut (usize, [f32; 3]) = sums.entry(tile).or_default();
        let color: LinSrgb = color.into_linear();
        *count += 1;
        sum.iter_mut().zip([color.red, color.green, color.blue]).for_each(|(sum, one)| *sum += one);
    }
    let whole = sums.into_values().filter(|&(count, _)| count == 16);
    whole
        .map(|(_, sum)| {
            let [r, g, b] = sum.map(|channel| channel / 16.0);
            Srgb::from_linear(LinSrgb::new(r, g, b))
        })
        .collect()
}

fn of565(pixel: u16) -> Srgb {
    let level = |shift: u32, most: u16| f32::from(pixel >> shift & most) / f32::from(most);
    srgb(Rgb { r: level(11, 31), g: level(5, 63), b: level(0, 31) })
}

fn srgb(Rgb { r, g, b }: Rgb<f32>) -> Srgb {
    Srgb::new(r, g, b)
}

/// The errors of a picture whose pixels are those of the reference.
#[must_use]
pub fn summed(reference: &[Srgb], found: &[Srgb]) -> Errors {
    assert_eq!(reference.len(), found.len(), "the pixels of both are the same");
    let lab = |color: Srgb| -> Lab { color.into_linear().into_color() };
    let mut apart: Vec<f64> =
        reference.iter().zip(found).map(|(&a, &b)| f64::from(lab(a).difference(lab(b)))).collect();
    apart.sort_by(f64::total_cmp);
    let count = apart.len().max(1);
    let at = |share: usize| apart.get(apart.len() * share / 100).copied().unwrap_or_default();
    Errors {
        mean: apart.iter().sum::<f64>() / count as f64,
        p95: at(95),
        worst: apart.last().copied().unwrap_or_default(),
    }
}

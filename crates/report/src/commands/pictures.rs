//! The pictures of the README: spheres of materials under captured lights, and all presets.

use eigenshade::lights::Window;
use eigenshade::object::{Disc, NormalMap};
use eigenshade::presets::{self, light, material};
use eigenshade::screen::{Display, Exposure, Meter, Palette, Target, Tone};
use eigenshade::{Light, Normal, Rgb, sphere};
use eigenshade_cli::picture::{Canvas, SphereView, TextHeight, text_width};
use eigenshade_cli::table;
use eigenshade_generator::material::brdf::projection::project;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::shipped;
use eigenshade_model::srgb::srgb;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::picture::write_png;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use report::numbers::exposure;
use std::path::Path;

/// Width of a sphere and of the gap beside it, in pixels.
const SIZE: usize = 168;
const GAP: usize = 12;
/// The share of a row's values that its exposure leaves unclipped.
const UNCLIPPED: f64 = 0.985;
/// The light of each row.
const LIGHTS: [&str; 2] = ["esplanade", "workshop"];
/// The roughness, and for each channel the reflectance at normal incidence and the diffuse albedo.
const MATERIALS: [(f64, [f64; 3], [f64; 3]); 5] = [
    (0.5, [1.0, 0.77, 0.34], [0.0; 3]),
    (0.45, [0.04; 3], [0.55, 0.04, 0.03]),
    (0.6, [0.95, 0.64, 0.54], [0.0; 3]),
    (0.8, [0.04; 3], [0.08, 0.22, 0.45]),
    (1.0, [0.04; 3], [0.75, 0.72, 0.66]),
];

pub fn spheres(out: &Path, table: &Path) -> Result<()> {
    let table = table::read(table)?;
    let (degree, order) = (table.gram.degree, table.gram.order);
    let lights = shipped::lights()?.truncated(degree);
    let mut materials = Vec::new();
    for (roughness, reflectance, albedo) in MATERIALS {
        let mut rgb = [const { Vec::new() }; 3];
        for ((f0, albedo), channel) in reflectance.into_iter().zip(albedo).zip(&mut rgb) {
            let brdf = Ggx::new(roughness, f0, albedo)?;
            *channel = project(&brdf, order, Measure::Projected).coefficients;
        }
        materials.push(Named { name: format!("{roughness}"), rgb });
    }
    let basis = OwnedBasis::new(&table)?;
    let mut shader = Shader::new(basis.basis().map_err(fault)?, table.count());
    let view = SphereView::new(SIZE);
    let normals = OwnedNormals::new(&view.normals);
    let (width, height) = (across(MATERIALS.len()), across(LIGHTS.len()));
    let mut bytes = vec![0; 4 * width * height];
    for (row, name) in LIGHTS.into_iter().enumerate() {
        let light = lights.entries.iter().find(|light| light.name == name);
        let light = light.ok_or_else(|| Error::new("no such light", "take a shipped one"))?;
        let images = materials.iter().map(|material| shader.color(light, material, &normals));
        let images = images.collect::<Result<Vec<_>>>()?;
        let all = images.iter().flatten().flatten().map(|&value| f64::from(value)).collect();
        let exposure = exposure(all, UNCLIPPED);
        for (column, image) in images.iter().enumerate() {
            for (k, pixel) in view.pixels.iter().enumerate() {
                let (x, y) = (across(column) + pixel.column, across(row) + pixel.row);
                let start = 4 * (y * width + x);
                for (channel, byte) in image.iter().zip(&mut bytes[start..]) {
                    *byte = srgb(exposure * f64::from(channel[k]));
                }
                bytes[start + 3] = (255.0 * pixel.coverage).round() as u8;
            }
        }
    }
    write_png(out, width, height, &bytes)
}

/// The width in pixels of this many spheres side by side, with gaps on all sides.
const fn across(count: usize) -> usize {
    GAP + count * (SIZE + GAP)
}

/// Spheres side by side.
const COLUMNS: usize = 11;
/// Pixels across a sphere, and the field with its name.
const BALL: usize = 92;
const FIELD: [usize; 2] = [124, 134];
/// Size of the names, and pixels from one line to the next.
const NAME: TextHeight = TextHeight::Size16;
const LINE: usize = 14;
const BACKGROUND: [u8; 3] = [32; 3];
const TEXT: [u8; 3] = [200; 3];
/// The width of the lights' window, which removes the ringing of small lamps.
const WINDOW: f32 = 12.0;

pub fn contact_sheet(out: &Path) -> Result<()> {
    let canvas = all_presets();
    let canvas = canvas.map_err(|fault| Error::new(fault.to_string(), "check the presets"))?;
    write_png(out, canvas.width, canvas.height, &canvas.bytes)
}

fn all_presets() -> std::result::Result<Canvas, eigenshade::Error> {
    let view = SphereView::new(BALL);
    let mut spheres = Vec::new();
    for (name, material) in material::ALL {
        spheres.push((name, colors(&view, light::LOBBY, material)?, Exposure::default()));
    }
    // The materials have one light, and the exposure of all of them.
    let of_all = metered(spheres.iter().flat_map(|(_, colors, _)| colors));
    spheres.iter_mut().for_each(|(.., exposure)| *exposure = of_all);
    for (name, light) in light::ALL {
        let windowed = light.windowed::<100>(Window::SincFourth { width: WINDOW })?;
        let colors = colors(&view, windowed.lights()?, material::GOLD_METALLIC_PAINT)?;
        let exposure = metered(&colors);
        spheres.push((name, colors, exposure));
    }
    let rows = spheres.len().div_ceil(COLUMNS);
    let mut canvas = Canvas::new(FIELD[0] * COLUMNS, FIELD[1] * rows, BACKGROUND);
    for (k, (name, colors, exposure)) in spheres.into_iter().enumerate() {
        let place = [FIELD[0] * (k % COLUMNS), FIELD[1] * (k / COLUMNS)];
        draw(&mut canvas, place, name, &view, colors.into_iter().map(|one| exposure.of(one)));
    }
    Ok(canvas)
}

/// The irradiances of a sphere.
fn colors(
    view: &SphereView,
    light: Rgb<Light<'_>>,
    material: presets::Material,
) -> std::result::Result<Vec<Rgb<f32>>, eigenshade::Error> {
    let scene = sphere::color::scene(light, material)?;
    let normals = view.normals.iter().map(|normal| normal.map(|component| component as f32));
    normals.map(|[x, y, z]| Ok(scene.shade(Normal::new(x, y, z)?))).collect()
}

/// The exposure of these irradiances.
fn metered<'a>(colors: impl IntoIterator<Item = &'a Rgb<f32>>) -> Exposure {
    let mut meter = Meter::default();
    colors.into_iter().for_each(|&color| meter.add(color));
    meter.exposure().unwrap_or_default()
}

/// Draws one sphere and its name into the field whose top left corner is given.
fn draw(
    canvas: &mut Canvas,
    [left, top]: [usize; 2],
    name: &str,
    view: &SphereView,
    colors: impl Iterator<Item = Rgb<f32>>,
) {
    static DISPLAY: Display = Display::new(Tone::Filmic);
    let margin = (FIELD[0] - BALL) / 2;
    for (color, pixel) in colors.zip(&view.pixels) {
        let color = DISPLAY.rgb888(color).into();
        canvas.blend(left + margin + pixel.column, top + 4 + pixel.row, color, pixel.coverage);
    }
    let most = FIELD[0] / text_width(NAME, " ");
    for (line, part) in lines(name, most).into_iter().enumerate() {
        let place = (left + FIELD[0] / 2, top + 5 + BALL + LINE * line);
        canvas.centered_text(place, NAME, TEXT, part);
    }
}

/// A name in one line, or in two that part after a hyphen.
fn lines(name: &str, most: usize) -> Vec<&str> {
    match name.get(..most).and_then(|start| start.rfind('-')) {
        Some(place) if name.len() > most => vec![&name[..=place], &name[place + 1..]],
        _ => vec![name],
    }
}

/// Pixels of a sphere in the picture of palettes, of a part of it, and the scale of that part.
const SPHERE: usize = 240;
const PART: usize = 90;
const SCALE: usize = 4;

/// Part of a sphere with every pixel shaded, from a palette, and from a palette and dithered, in
/// RGB565: of a matte material and of gold.
pub fn palettes(out: &Path) -> Result<()> {
    static DISPLAY: Display = Display::new(Tone::Filmic);
    let mut codes = vec![NormalMap::BACKGROUND; SPHERE * SPHERE];
    NormalMap::sphere(SPHERE, &mut codes).map_err(fault)?;
    let map = NormalMap::new(SPHERE, SPHERE, codes.as_flattened()).map_err(fault)?;
    let side = PART * SCALE;
    let (width, height) = (3 * side, 2 * side);
    let mut bytes = vec![u8::MAX; 4 * width * height];
    for (row, material) in [material::PTFE_633NM, material::GOLD_METALLIC_PAINT].iter().enumerate()
    {
        let scene = sphere::color::scene(light::LOBBY, *material).map_err(fault)?;
        let exposure = scene.exposure_by_factor(1.5).map_err(fault)?;
        let mut palette = Palette::default();
        palette.fill_mirrored(&map.nodes(), &DISPLAY, |normal| {
            scene.shade_mirrored(normal).map(|color| exposure.of(color))
        });
        let mut pictures = [(); 3].map(|()| vec![0_u16; SPHERE * SPHERE]);
        let [shaded, plain, dithered] = &mut pictures;
        let mut target = Target::new(shaded, SPHERE).map_err(fault)?;
        for pixel in Disc::new(SPHERE).map_err(fault)? {
            let color = exposure.of(scene.shade(pixel.normal()));
            pixel.put(&mut target, DISPLAY.rgb565(color));
        }
        palette.draw(&map, &mut Target::new(plain, SPHERE).map_err(fault)?);
        palette.dithered().draw(&map, &mut Target::new(dithered, SPHERE).map_err(fault)?);
        for (column, picture) in pictures.iter().enumerate() {
            for (y, x) in (0..side).flat_map(|y| (0..side).map(move |x| (y, x))) {
                let pixel = picture[(20 + y / SCALE) * SPHERE + 20 + x / SCALE];
                let level = |shift: u32, most: u16| {
                    (u32::from(pixel >> shift & most) * 255 / u32::from(most)) as u8
                };
                let at = 4 * ((row * side + y) * width + column * side + x);
                bytes[at..at + 3].copy_from_slice(&[level(11, 31), level(5, 63), level(0, 31)]);
            }
        }
    }
    write_png(out, width, height, &bytes)
}

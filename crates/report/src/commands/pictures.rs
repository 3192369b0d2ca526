//! Pictures of all presets, and of palettes.

use eigenshade::lights::Window;
use eigenshade::object::{Disc, NormalMap};
use eigenshade::presets::{self, light, material};
use eigenshade::screen::{Display, Exposure, Meter, Palette, Target, Tone};
use eigenshade::{Light, Normal, Rgb, sphere};
use eigenshade_cli::picture::{Canvas, SphereView, TextHeight, text_width};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::picture::write_png;
use eigenshade_shading::shader::fault;
use std::path::Path;

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

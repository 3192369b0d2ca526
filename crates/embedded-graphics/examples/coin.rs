//! A golden coin on a blue dial, as docs/guides/watch.md builds it: `coin FILE.png`.

use eigenshade::object::NormalMap;
use eigenshade::presets::light::HALL;
use eigenshade::presets::material::{BLUE_METALLIC_PAINT2, GOLD_METALLIC_PAINT};
use eigenshade::screen::{Display, Nodes, Palette, Tone};
use eigenshade::sphere::color::{self, Transfer};
use eigenshade::{Error, Rotation};
use eigenshade_embedded_graphics::{Dial, Frame, Layer};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::image::GetPixel as _;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

static COIN: &[u8] = include_bytes!("coin.bin");
static DISPLAY: Display = Display::new(Tone::Filmic);

/// An object: its normals, its material, and its colors in this frame.
struct Object<'a> {
    map: NormalMap<'a>,
    nodes: Nodes,
    material: Transfer,
    palette: Palette,
}

impl<'a> Object<'a> {
    fn new(map: NormalMap<'a>, material: Transfer) -> Self {
        Self { map, nodes: map.nodes(), material, palette: Palette::BLACK }
    }
}

/// Lights the objects when the wrist is tilted by this many radians.
fn relight(tilt: f32, objects: &mut [Object; 2]) -> Result<(), Error> {
    let light = HALL.turned::<100>(&Rotation::from_euler(tilt, 0.0, 0.0)?)?;
    for Object { nodes, material, palette, .. } in objects {
        let scene = color::relight(&*material, light.lights()?)?;
        let exposure = scene.exposure_by_factor(2.0)?;
        palette.fill_mirrored(nodes, &DISPLAY, |normal| {
            scene.shade_mirrored(normal).map(|color| exposure.of(color))
        });
    }
    Ok(())
}

/// Draws the coin on the dial.
fn draw<D: DrawTarget<Color = Rgb565>>(
    [dial, coin]: &[Object; 2],
    target: &mut D,
) -> Result<(), D::Error> {
    let layers = [
        Layer::new(Point::zero(), dial.map, &dial.palette),
        Layer::new(Point::new(19, 19), coin.map, &coin.palette),
    ];
    let area = Rectangle::new(Point::zero(), Size::new(128, 128));
    Frame::new(area, &layers, Rgb565::BLACK).draw(target)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let file = std::env::args().nth(1).ok_or("usage: coin FILE.png")?;
    let mut dial = [[0; 2]; 128 * 128];
    Dial::codes(128, 8, 4, &mut dial)?;
    let mut objects = [
        Object::new(
            NormalMap::new(128, 128, dial.as_flattened())?,
            color::transfer(BLUE_METALLIC_PAINT2)?,
        ),
        Object::new(NormalMap::new(90, 90, COIN)?, color::transfer(GOLD_METALLIC_PAINT)?),
    ];

    // Three moments, side by side.
    const WIDTH: usize = 3 * 128;
    const BYTES: usize = buffer_size::<Rgb565>(WIDTH, 128);
    let mut display = Framebuffer::<Rgb565, RawU16, LittleEndian, WIDTH, 128, BYTES>::new();
    for (place, tilt) in [(0, -0.5), (128, 0.0), (256, 0.5)] {
        relight(tilt, &mut objects)?;
        draw(&objects, &mut display.translated(Point::new(place, 0)))?;
    }
    let colors = display.bounding_box().points().filter_map(|place| display.pixel(place));
    let colors = colors.map(Rgb888::from).flat_map(|color| [color.r(), color.g(), color.b()]);
    let mut png = png::Encoder::new(std::fs::File::create(file)?, WIDTH as u32, 128);
    png.set_color(png::ColorType::Rgb);
    Ok(png.write_header()?.write_image_data(&colors.collect::<Vec<u8>>())?)
}

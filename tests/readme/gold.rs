use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
use eigenshade::object::Disc;
use eigenshade::screen::{Display, Target, Tone};
use eigenshade::sphere;

static DISPLAY: Display = Display::new(Tone::Filmic);

fn draw(screen: &mut Target<'_>) -> Result<(), eigenshade::Error> {
    let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    for pixel in Disc::new(240)? {
        pixel.put(screen, DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal()))));
    }
    Ok(())
}

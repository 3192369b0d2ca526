use eigenshade::presets::{light::q15::LOBBY, material::q15::GOLD_METALLIC_PAINT};
use eigenshade::object::Disc;
use eigenshade::screen::{Display, Target, Tone};
use eigenshade::sphere;

static DISPLAY: Display = Display::new(Tone::Filmic);

fn draw(screen: &mut Target<'_>) -> Result<(), eigenshade::Error> {
    let scene = sphere::q15::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    for pixel in Disc::new(240)? {
        pixel.put(screen, DISPLAY.rgb565(exposure.of(scene.shade(pixel.normal_q15()))));
    }
    Ok(())
}

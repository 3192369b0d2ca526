use eigenshade::presets::{light::LOBBY, material::GOLD_METALLIC_PAINT};
use eigenshade::{Disc, Display, sphere};

fn draw(screen: &mut [u16; 240 * 240], display: &Display) -> Result<(), eigenshade::Error> {
    let scene = sphere::color::scene(LOBBY, GOLD_METALLIC_PAINT)?;
    let exposure = scene.exposure_by_factor(1.5)?;
    for pixel in Disc::new(240)? {
        pixel.put(screen, display.rgb565(exposure.of(scene.shade(pixel.normal()))));
    }
    Ok(())
}

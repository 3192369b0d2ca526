//! Loops over pixels in color.

use eigenshade::screen::{Display, Exposure, Tone};
use eigenshade::{Normals, Rgb};
use eigenshade_wasm_setup::scene::COLLAPSED;
use eigenshade_wasm_setup::shared::{NORMALS, Shared};

/// Normals to shade: all x, all y, all z.
#[unsafe(export_name = "normals")]
pub static AXES: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);
/// Their irradiances: all red, all green, all blue.
#[unsafe(export_name = "irradiance")]
pub static IRRADIANCE: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);

/// Computes the irradiances of the first `count` normals. Returns `count`, or 0 if there is no
/// scene or `count` is too large.
#[unsafe(no_mangle)]
extern "C" fn shade(count: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (axes, planes) = unsafe { (AXES.borrow(), IRRADIANCE.borrow()) };
    shaded(count, axes, planes).map_or(0, |()| count)
}

/// [`shade`], from borrowed buffers.
pub fn shaded(
    count: usize,
    [x, y, z]: &[[f32; NORMALS]; 3],
    planes: &mut [[f32; NORMALS]; 3],
) -> Option<()> {
    // SAFETY: once, and no other function runs.
    let scene = unsafe { COLLAPSED.borrow() }.scene()?;
    let normals = Normals::from_unit(x.get(..count)?, y.get(..count)?, z.get(..count)?).ok()?;
    for (scene, plane) in <[_; 3]>::from(scene).iter().zip(&mut *planes) {
        scene.shade_slice(normals, plane.get_mut(..count)?).ok()?;
    }
    #[cfg(feature = "sources")]
    // SAFETY: as above.
    if let Some(highlights) = unsafe { eigenshade_wasm_setup::highlights::HIGHLIGHTS.borrow() } {
        let [r, g, b] = planes;
        for (((normal, r), g), b) in normals.iter().zip(r).zip(g).zip(b) {
            let color = highlights.shade(normal);
            *r += color.r;
            *g += color.g;
            *b += color.b;
        }
    }
    Some(())
}

/// The colors of irradiances.
pub fn colors([r, g, b]: &[[f32; NORMALS]; 3]) -> impl Iterator<Item = Rgb<f32>> {
    r.iter().zip(g).zip(b).map(|((&r, &g), &b)| Rgb::new(r, g, b))
}

pub static DISPLAYS: [Display; 3] =
    [Display::new(Tone::Linear), Display::new(Tone::Reinhard), Display::new(Tone::Filmic)];
/// Pixels: red, green, blue and opacity.
#[unsafe(export_name = "pixels")]
pub static PIXELS: Shared<[[u8; 4]; NORMALS]> = Shared::new([[0; 4]; NORMALS]);

/// Encodes the first `count` irradiances, exposed, by the tone curve of this number. Returns
/// `count`, or 0 if it is too large, there is no such curve, or the exposure is not above 0.
#[unsafe(no_mangle)]
extern "C" fn rgb888(count: usize, exposure: f32, tone: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (planes, pixels) = unsafe { (IRRADIANCE.borrow(), PIXELS.borrow()) };
    let (Some(display), Some(pixels)) = (DISPLAYS.get(tone), pixels.get_mut(..count)) else {
        return 0;
    };
    let Ok(exposure) = Exposure::new(exposure) else { return 0 };
    for (pixel, color) in pixels.iter_mut().zip(colors(planes)) {
        let Rgb { r, g, b } = display.rgb888(exposure.of(color));
        *pixel = [r, g, b, u8::MAX];
    }
    count
}

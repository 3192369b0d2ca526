//! Loops over pixels in color.

use eigenshade::screen::{Display, Exposure, Tone};
use eigenshade::{Normals, Rgb};
use eigenshade_wasm_setup::scene::COLLAPSED;
use eigenshade_wasm_setup::shared::{NORMALS, Shared};

/// Normals to shade: all x, all y, all z.
#[unsafe(export_name = "normals")]
static AXES: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);
/// Their irradiances: all red, all green, all blue.
#[unsafe(export_name = "irradiance")]
static IRRADIANCE: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);

/// Computes the irradiances of the first `count` normals. Returns `count`, or 0 if there is no
/// scene or `count` is too large.
#[unsafe(no_mangle)]
extern "C" fn shade(count: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (collapsed, [x, y, z], planes) =
        unsafe { (COLLAPSED.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let (Some(scene), Some(x), Some(y), Some(z)) =
        (collapsed.scene(), x.get(..count), y.get(..count), z.get(..count))
    else {
        return 0;
    };
    let Ok(normals) = Normals::from_unit(x, y, z) else { return 0 };
    for (scene, plane) in <[_; 3]>::from(scene).iter().zip(&mut *planes) {
        let Some(irradiance) = plane.get_mut(..count) else { return 0 };
        if scene.shade_slice(normals, irradiance).is_err() {
            return 0;
        }
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
    count
}

static DISPLAYS: [Display; 3] =
    [Display::new(Tone::Linear), Display::new(Tone::Reinhard), Display::new(Tone::Filmic)];
/// Pixels: red, green, blue and opacity.
#[unsafe(export_name = "pixels")]
static PIXELS: Shared<[[u8; 4]; NORMALS]> = Shared::new([[0; 4]; NORMALS]);

/// Encodes the first `count` irradiances, exposed, by the tone curve of this number. Returns
/// `count`, or 0 if it is too large, there is no such curve, or the exposure is not above 0.
#[unsafe(no_mangle)]
extern "C" fn rgb888(count: usize, exposure: f32, tone: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let ([r, g, b], pixels) = unsafe { (IRRADIANCE.borrow(), PIXELS.borrow()) };
    let (Some(display), Some(pixels)) = (DISPLAYS.get(tone), pixels.get_mut(..count)) else {
        return 0;
    };
    let Ok(exposure) = Exposure::new(exposure) else { return 0 };
    for (pixel, ((&r, &g), &b)) in pixels.iter_mut().zip(r.iter().zip(&*g).zip(&*b)) {
        let Rgb { r, g, b } = display.rgb888(exposure.of(Rgb::new(r, g, b)));
        *pixel = [r, g, b, u8::MAX];
    }
    count
}

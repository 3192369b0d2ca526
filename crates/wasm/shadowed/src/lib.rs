//! Objects with their shadows as a WebAssembly module with plain exports, without tables.
//!
//! An instance draws one object. The page grows the memory by all that the functions take, and gives
//! them the addresses: a file, the coefficients and the turn of a light, the colors of the codes and
//! the picture. Every function returns 0 if it rejects its input. Only for `wasm32-unknown-unknown`; on
//! other targets the crate is empty.
#![cfg(target_arch = "wasm32")]
#![no_std]

use core::slice;
use eigenshade::object::{ObjectCoefficients, ShadowedObject};
use eigenshade::screen::{Display, Exposure, Linear, Meter, Target, Tone};
use eigenshade::{Light, Rgb, Rotation};

unsafe extern "C" {
    /// An undefined symbol: a module with a reachable panic imports it, and a
    /// test of the package for web pages fails.
    safe fn a_panic_can_be_reached() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    a_panic_can_be_reached()
}

/// The largest degree of a light that turns, and the number of its coefficients.
const DEGREE: usize = 16;
const MOST: usize = (DEGREE + 1) * (DEGREE + 1);

static DISPLAYS: [Display; 3] =
    [Display::new(Tone::Linear), Display::new(Tone::Reinhard), Display::new(Tone::Filmic)];

/// Addresses of the memory that the page fills, and the turn of the light. Addresses are multiples of 4.
#[repr(C)]
struct Places {
    /// A file of `eigenshade pack-object --shadows`, and its length.
    file: *const u8,
    length: usize,
    /// (degree + 1)² coefficients of each channel, for the object's degree.
    light: *const f32,
    /// The quaternion (x, y, z, w) by which the light is turned.
    turn: [f32; 4],
    /// As many colors as codes: red, green, blue and opacity.
    colors: *mut [u8; 4],
    /// The picture, row by row from the top.
    pixels: *mut [u8; 4],
}

/// The largest brightness that is metered: three bytes beside the opacity.
const BRIGHTEST: u32 = (1 << 24) - 1;

/// The number of coefficients of a channel of the light: at least 1, so that no panic is linked.
fn count(object: &ShadowedObject<'_>) -> usize {
    ((object.degree() + 1) * (object.degree() + 1)).max(1)
}

/// Width, height, number of codes and degree.
type Shape = [u32; 4];

impl Places {
    /// # Safety
    ///
    /// The page has placed a file, which nothing changes.
    unsafe fn object(&self) -> Option<ShadowedObject<'static>> {
        // SAFETY: as this function asks of its caller.
        let bytes = unsafe { slice::from_raw_parts(self.file, self.length) };
        ShadowedObject::new(bytes).ok()
    }

    /// The coefficients of the object under the turned light.
    ///
    /// # Safety
    ///
    /// The page has placed a light of the object's degree.
    unsafe fn coefficients(&self, object: &ShadowedObject<'_>) -> Option<Rgb<ObjectCoefficients>> {
        let count = count(object);
        // SAFETY: as this function asks of its caller.
        let numbers = unsafe { slice::from_raw_parts(self.light, 3 * count) };
        let mut channels = numbers.chunks_exact(count).map(Light::from_finite);
        let mut channel = || channels.next()?.ok();
        let light = Rgb { r: channel()?, g: channel()?, b: channel()? };
        let rotation = Rotation::from_quaternion(self.turn).ok()?;
        let turned = light.turned::<MOST>(&rotation).ok()?;
        object.coefficients(turned.lights().ok()?).ok()
    }

    /// # Safety
    ///
    /// The page has placed the colors of the object, and borrows them once.
    unsafe fn colors(&self, object: &ShadowedObject<'_>) -> &'static mut [[u8; 4]] {
        // SAFETY: as this function asks of its caller.
        unsafe { slice::from_raw_parts_mut(self.colors, object.codes()) }
    }

    /// Draws these colors over a transparent picture.
    ///
    /// # Safety
    ///
    /// The page has placed a picture of the object's size, and borrows it once.
    unsafe fn draw(
        &self,
        object: &ShadowedObject<'_>,
        colors: &[[u8; 4]],
    ) -> &'static mut [[u8; 4]] {
        let count = object.width() * object.height();
        // SAFETY: as this function asks of its caller.
        let pixels = unsafe { slice::from_raw_parts_mut(self.pixels, count) };
        pixels.fill([0; 4]);
        if let Ok(mut target) = Target::new(pixels, object.width()) {
            object.draw(colors, &mut target);
        }
        pixels
    }
}

/// Reads a file, and writes its shape.
///
/// # Safety
///
/// The page has placed a file; `to` is of other memory.
#[unsafe(no_mangle)]
unsafe extern "C" fn read(places: &Places, to: &mut Shape) -> u32 {
    // SAFETY: as this function asks of the page.
    let Some(object) = (unsafe { places.object() }) else { return 0 };
    *to = [object.width(), object.height(), object.codes(), object.degree()].map(|one| one as u32);
    1
}

/// Draws the object by the tone curve of this number.
///
/// # Safety
///
/// The page has placed all of [`Places`], for an object that [`read`] has read.
#[unsafe(no_mangle)]
unsafe extern "C" fn draw(places: &Places, exposure: f32, tone: usize) -> u32 {
    let drawn = || {
        // SAFETY: as this function asks of the page; each place is borrowed once.
        unsafe {
            let object = places.object()?;
            let d = places.coefficients(&object)?;
            let colors = places.colors(&object);
            object.colors(&d, Exposure::new(exposure).ok()?, DISPLAYS.get(tone)?, colors).ok()?;
            places.draw(&object, colors);
        }
        Some(())
    };
    drawn().is_some().into()
}

/// The exposure of the picture by the rule of [`Meter`]; 0 for a black one. It overwrites colors and
/// picture.
///
/// # Safety
///
/// As [`draw`].
#[unsafe(no_mangle)]
unsafe extern "C" fn meter(places: &Places) -> f32 {
    let metered = || {
        // SAFETY: as this function asks of the page; `draw` borrows the picture alone.
        let (object, d, light, colors) = unsafe {
            let object = places.object()?;
            let light = slice::from_raw_parts(places.light, 3 * count(&object));
            (object, places.coefficients(&object)?, light, places.colors(&object))
        };
        let means = light.iter().step_by(count(&object));
        let brightest = means.fold(0.0, |most: f32, mean| most.max(*mean));
        let mut exposure = Exposure::new(1.0 / brightest).ok()?;
        // Twice, since the first one may be far off the range of integers.
        for _ in 0..2 {
            let mut to = colors.iter_mut();
            object.shade(&d, exposure, |Rgb { r, g, b }| {
                let Linear(brightness) = r.max(g).max(b);
                let [a, b, c, _] = brightness.min(BRIGHTEST).to_le_bytes();
                to.by_ref().take(1).for_each(|color| *color = [a, b, c, u8::MAX]);
            });
            let mut meter = Meter::default();
            // SAFETY: as above; the borrow of the first round has ended.
            for &[a, b, c, opacity] in &*unsafe { places.draw(&object, colors) } {
                if opacity > u8::MAX / 2 {
                    let brightness = Linear(u32::from_le_bytes([a, b, c, 0]));
                    meter.add_linear(Rgb::gray(brightness));
                }
            }
            exposure = Exposure::new(exposure.factor() * meter.exposure()?.factor()).ok()?;
        }
        Some(exposure.factor())
    };
    metered().unwrap_or_default()
}

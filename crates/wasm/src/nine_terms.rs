//! The nine-term formula (Ramamoorthi and Hanrahan 2001) as a polynomial of the normal,
//! to compare times with.

use crate::floats::{AXES, IRRADIANCE};
use eigenshade_wasm_setup::inputs::NORMALS;
use eigenshade_wasm_setup::shared::Shared;

/// Its coefficients: of 1, x, y, z, x² - y², xy, xz, yz, z².
#[unsafe(export_name = "nine")]
static NINE: Shared<[f32; 9]> = Shared::new([0.0; 9]);

/// The irradiances of the first `count` normals.
#[unsafe(no_mangle)]
extern "C" fn nine_terms(count: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (nine, [x, y, z], irradiance) =
        unsafe { (NINE.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let &mut [a, b, c, d, e, f, g, h, i] = nine;
    let normals = x.iter().zip(y.iter()).zip(z.iter());
    for (((&x, &y), &z), irradiance) in normals.zip(irradiance).take(count) {
        let linear = a + b * x + c * y + d * z;
        let square = e * (x * x - y * y) + f * (x * y) + (g * x + h * y) * z;
        *irradiance = linear + square + i * (z * z);
    }
    count.min(NORMALS)
}

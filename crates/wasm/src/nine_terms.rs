//! The nine-term formula (Ramamoorthi and Hanrahan 2001), to compare times with.

use crate::floats::{AXES, IRRADIANCE};
use eigenshade::{NineTerms, Normals};
use eigenshade_wasm_setup::inputs::NORMALS;
use eigenshade_wasm_setup::shared::Shared;

/// Its coefficients: of 1, x, y, z, x² - y², xy, xz, yz, z².
#[unsafe(export_name = "nine")]
static NINE: Shared<[f32; 9]> = Shared::new([0.0; 9]);

/// The irradiances of the first `count` normals.
#[unsafe(no_mangle)]
extern "C" fn nine_terms(count: usize) -> usize {
    let count = count.min(NORMALS);
    // SAFETY: each place once, and no other function runs.
    let (nine, [x, y, z], irradiance) =
        unsafe { (NINE.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let (Some(x), Some(y), Some(z), Some(irradiance)) =
        (x.get(..count), y.get(..count), z.get(..count), irradiance.get_mut(..count))
    else {
        return 0;
    };
    let Ok(normals) = Normals::new(x, y, z) else { return 0 };
    if NineTerms::new(*nine).shade_slice(normals, irradiance).is_ok() { count } else { 0 }
}

//! A new light in floats on a material that stays. Both functions give 1, or 0 if there is
//! nothing to do it with.

use crate::floats::{D, ROOM};
use crate::inputs::{LIGHT, MATERIAL};
use crate::shared::Shared;
use crate::table::{BASIS, DEGREE, ORDER, TRANSFER};
use eigenshade::{Light, Material};

static FOLDED: Shared<[f32; TRANSFER]> = Shared::new([0.0; TRANSFER]);

/// Folds in the material.
#[unsafe(no_mangle)]
extern "C" fn f32_fold() -> u32 {
    // SAFETY: each place once, and no other function runs.
    let (material, room, folded) = unsafe { (MATERIAL.borrow(), ROOM.borrow(), FOLDED.borrow()) };
    let Ok(material) = Material::new(ORDER, material) else { return 0 };
    BASIS.transfer_into(&material, room, folded).is_ok().into()
}

/// Puts the folded material under the light: gives d.
#[unsafe(no_mangle)]
extern "C" fn f32_relight() -> u32 {
    // SAFETY: each place once, and no other function runs.
    let (light, folded, d) = unsafe { (LIGHT.borrow(), FOLDED.borrow(), D.borrow()) };
    let Ok(light) = Light::new(DEGREE, light) else { return 0 };
    BASIS.relight_into(folded, &light, d).is_ok().into()
}

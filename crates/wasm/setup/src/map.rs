//! An image baked on the paraboloid.

use crate::floats::COLLAPSED;
use crate::shared::Shared;

/// Texels along a side.
pub const SIZE: usize = 32;
/// The texels, row by row.
#[unsafe(export_name = "f32_map")]
pub static TEXELS: Shared<[f32; SIZE * SIZE]> = Shared::new([0.0; SIZE * SIZE]);

/// Bakes the scene: gives 1, or 0 if there is none.
#[unsafe(no_mangle)]
extern "C" fn f32_bake() -> u32 {
    // SAFETY: each place once, and no other function runs.
    let (scene, texels) = unsafe { (COLLAPSED.borrow(), TEXELS.borrow()) };
    let Some(scene) = scene else { return 0 };
    scene.bake_into(SIZE, &mut texels[..]).is_ok().into()
}

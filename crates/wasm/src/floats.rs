//! Pixels in floats.

use eigenshade::Normals;
use eigenshade_wasm_setup::floats::COLLAPSED;
use eigenshade_wasm_setup::inputs::NORMALS;
use eigenshade_wasm_setup::shared::Shared;

/// Normals to shade: all x, all y, all z.
#[unsafe(export_name = "f32_normals")]
pub static AXES: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);
/// Their irradiances.
#[unsafe(export_name = "f32_irradiance")]
pub static IRRADIANCE: Shared<[f32; NORMALS]> = Shared::new([0.0; NORMALS]);

/// The irradiances of the first `count` normals: gives their number, or 0 if there is no
/// scene or no room.
#[unsafe(no_mangle)]
extern "C" fn f32_shade(count: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (scene, [x, y, z], irradiance) =
        unsafe { (COLLAPSED.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let (Some(scene), Some(x), Some(y), Some(z), Some(irradiance)) =
        (scene, x.get(..count), y.get(..count), z.get(..count), irradiance.get_mut(..count))
    else {
        return 0;
    };
    let Ok(normals) = Normals::new(x, y, z) else { return 0 };
    if scene.shade_slice(normals, irradiance).is_ok() { count } else { 0 }
}

//! Floats: projection, relighting, collapsing and baking. Every function returns 1, or 0 if its
//! input is missing or invalid.

#[cfg(feature = "relight")]
use crate::table::TRANSFER;
use crate::table::{BASIS, COMPONENTS, SCENE, WORKSPACE};
use crate::{LIGHT, MATERIAL, Shared};
use eigenshade::{Light, Material, Scene};

/// The coefficients d.
#[unsafe(export_name = "f32_d")]
static D: Shared<[f32; COMPONENTS]> = Shared::new([0.0; COMPONENTS]);
static ROOM: Shared<[f32; WORKSPACE]> = Shared::new([0.0; WORKSPACE]);
/// The scene of the last `f32_collapse`.
pub static COLLAPSED: Shared<Option<Scene<'static, [f32; SCENE]>>> = Shared::new(None);

/// Computes d of the light on the material.
#[unsafe(no_mangle)]
extern "C" fn f32_project() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (light, material, room, d) =
        unsafe { (LIGHT.borrow(), MATERIAL.borrow(), ROOM.borrow(), D.borrow()) };
    let (Ok(light), Ok(material)) = (Light::from_finite(light), Material::from_finite(material))
    else {
        return 0;
    };
    BASIS.project_into(&light, &material, room, d).is_ok().into()
}

/// Collapses d to a scene.
#[unsafe(no_mangle)]
extern "C" fn f32_collapse() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (d, scene) = unsafe { (D.borrow(), COLLAPSED.borrow()) };
    *scene = BASIS.collapse_into(d, [0.0; SCENE]).ok();
    scene.is_some().into()
}

/// The transfer of the material.
#[cfg(feature = "relight")]
static TRANSFERRED: Shared<[f32; TRANSFER]> = Shared::new([0.0; TRANSFER]);

/// Computes the transfer of the material.
#[cfg(feature = "relight")]
#[unsafe(no_mangle)]
extern "C" fn f32_transfer() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (material, room, transfer) =
        unsafe { (MATERIAL.borrow(), ROOM.borrow(), TRANSFERRED.borrow()) };
    let Ok(material) = Material::from_finite(material) else { return 0 };
    BASIS.transfer_into(&material, room, transfer).is_ok().into()
}

/// Computes d of the light on the material of the last `f32_transfer`.
#[cfg(feature = "relight")]
#[unsafe(no_mangle)]
extern "C" fn f32_relight() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (light, transfer, d) = unsafe { (LIGHT.borrow(), TRANSFERRED.borrow(), D.borrow()) };
    let Ok(light) = Light::from_finite(light) else { return 0 };
    BASIS.relight_into(transfer, &light, d).is_ok().into()
}

/// Texels along a side of the map.
#[cfg(feature = "map")]
pub const SIZE: usize = 32;
/// The texels of the map, row by row.
#[cfg(feature = "map")]
#[unsafe(export_name = "f32_map")]
pub static TEXELS: Shared<[f32; SIZE * SIZE]> = Shared::new([0.0; SIZE * SIZE]);

/// Bakes the scene into the map.
#[cfg(feature = "map")]
#[unsafe(no_mangle)]
extern "C" fn f32_bake() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (scene, texels) = unsafe { (COLLAPSED.borrow(), TEXELS.borrow()) };
    let Some(scene) = scene else { return 0 };
    scene.bake_into(SIZE, &mut texels[..]).is_ok().into()
}

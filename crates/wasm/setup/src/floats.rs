//! The way in floats. Every function gives 1, or 0 if there is nothing to do it with.

use crate::inputs::{LIGHT, MATERIAL};
use crate::shared::Shared;
use crate::table::{BASIS, COMPONENTS, DEGREE, ORDER, SCENE, WORKSPACE};
use eigenshade::{Light, Material, Scene};

/// The coefficients d.
#[unsafe(export_name = "f32_d")]
pub(crate) static D: Shared<[f32; COMPONENTS]> = Shared::new([0.0; COMPONENTS]);
pub(crate) static ROOM: Shared<[f32; WORKSPACE]> = Shared::new([0.0; WORKSPACE]);
/// The scene, if there is one.
pub static COLLAPSED: Shared<Option<Scene<'static, [f32; SCENE]>>> = Shared::new(None);

/// The light on the material: gives d.
#[unsafe(no_mangle)]
extern "C" fn f32_project() -> u32 {
    // SAFETY: each place once, and no other function runs.
    let (light, material, room, d) =
        unsafe { (LIGHT.borrow(), MATERIAL.borrow(), ROOM.borrow(), D.borrow()) };
    let (Ok(light), Ok(material)) = (Light::new(DEGREE, light), Material::new(ORDER, material))
    else {
        return 0;
    };
    BASIS.project_into(&light, &material, room, d).is_ok().into()
}

/// Makes a scene of d.
#[unsafe(no_mangle)]
extern "C" fn f32_collapse() -> u32 {
    // SAFETY: each place once, and no other function runs.
    let (d, scene) = unsafe { (D.borrow(), COLLAPSED.borrow()) };
    *scene = BASIS.collapse_into(d, [0.0; SCENE]).ok();
    scene.is_some().into()
}

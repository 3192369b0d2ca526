//! Integers: transfer, relighting, collapsing and shading. Every function returns 1, or 0 if its
//! input is missing or invalid.

use crate::table::{COMPONENTS, ORDER};
use crate::{LIGHT, LIGHT_COUNT, MATERIAL, MATERIAL_COUNT, NORMALS, Shared};
use eigenshade::Format;
use eigenshade::quantized::{Light, Material, Normal, Scene, Transfer};

/// The data that a format keeps between calls.
struct State<Q: Format, const T: usize, const P: usize, const N: usize> {
    light: [Q; LIGHT_COUNT],
    material: [Q; MATERIAL_COUNT],
    of_material: [i8; ORDER + 1],
    room: [Q::Wide; N],
    transfer: [Q; T],
    of_transfer: [i16; P],
}

macro_rules! exports {
    ($module:ident, $format:ident, $mantissa:ty) => {
        /// One format.
        pub mod $module {
            use super::*;
            use crate::table::$module::{BASIS, PROFILES, SCENE, TRANSFER, WORKSPACE};
            use eigenshade::$format;

            /// The coefficients d.
            #[unsafe(export_name = concat!(stringify!($module), "_d"))]
            static D: Shared<[i32; COMPONENTS]> = Shared::new([0; COMPONENTS]);
            /// The exponents of d and of irradiances.
            #[unsafe(export_name = concat!(stringify!($module), "_exponents"))]
            static EXPONENTS: Shared<[i32; 2]> = Shared::new([0; 2]);
            static COLLAPSED: Shared<Option<Scene<'static, $format, [i32; SCENE]>>> =
                Shared::new(None);

            static STATE: Shared<State<$format, TRANSFER, PROFILES, WORKSPACE>> =
                Shared::new(State {
                    light: [$format(0); LIGHT_COUNT],
                    material: [$format(0); MATERIAL_COUNT],
                    of_material: [0; ORDER + 1],
                    room: [0; WORKSPACE],
                    transfer: [$format(0); TRANSFER],
                    of_transfer: [0; PROFILES],
                });

            /// Computes the transfer of the material.
            #[unsafe(export_name = concat!(stringify!($module), "_transfer"))]
            extern "C" fn transfer() -> u32 {
                let (from, state) =
                    // SAFETY: each buffer is borrowed once, and no other function runs.
                    unsafe { (MATERIAL.borrow(), STATE.borrow()) };
                let State { material, of_material, room, transfer, of_transfer, .. } = state;
                let Ok(material) = Material::quantize(from, material, of_material) else {
                    return 0;
                };
                BASIS.transfer_into(&material, room, transfer, of_transfer).is_ok().into()
            }

            /// Computes d of the light on the material of the last transfer.
            #[unsafe(export_name = concat!(stringify!($module), "_relight"))]
            extern "C" fn relight() -> u32 {
                let (from, state, d, exponents) =
                    // SAFETY: each buffer is borrowed once, and no other function runs.
                    unsafe { (LIGHT.borrow(), STATE.borrow(), D.borrow(), EXPONENTS.borrow()) };
                let Ok(light) = Light::quantize(from, &mut state.light) else { return 0 };
                let transfer = Transfer::new(&state.transfer, &state.of_transfer);
                let Ok(exponent) = BASIS.relight_into(&transfer, &light, d) else { return 0 };
                let [of_d, _] = exponents;
                *of_d = exponent;
                1
            }

            /// Collapses d to a scene.
            #[unsafe(export_name = concat!(stringify!($module), "_collapse"))]
            extern "C" fn collapse() -> u32 {
                let (collapsed, d, exponents) =
                    // SAFETY: each buffer is borrowed once, and no other function runs.
                    unsafe { (COLLAPSED.borrow(), D.borrow(), EXPONENTS.borrow()) };
                let [of_d, of_irradiance] = exponents;
                *collapsed = BASIS.collapse_into(d, *of_d, [0; SCENE]).ok();
                let Some(scene) = collapsed else { return 0 };
                *of_irradiance = scene.exponent();
                1
            }

            /// Normals to shade: all x, all y, all z.
            #[unsafe(export_name = concat!(stringify!($module), "_normals"))]
            static AXES: Shared<[[$mantissa; NORMALS]; 3]> = Shared::new([[0; NORMALS]; 3]);
            /// Their irradiances.
            #[unsafe(export_name = concat!(stringify!($module), "_irradiance"))]
            static IRRADIANCE: Shared<[i32; NORMALS]> = Shared::new([0; NORMALS]);

            /// Computes the irradiances of the first `count` normals, up to the first that is not a
            /// visible unit vector. Returns their number, 0 if there is no scene.
            #[unsafe(export_name = concat!(stringify!($module), "_shade"))]
            extern "C" fn shade(count: usize) -> usize {
                let (scene, [x, y, z], irradiance) =
                    // SAFETY: each buffer is borrowed once, and no other function runs.
                    unsafe { (COLLAPSED.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
                let Some(scene) = scene else { return 0 };
                let normals = x.iter().zip(y.iter()).zip(z.iter());
                let mut done = 0;
                for (((&x, &y), &z), irradiance) in normals.zip(irradiance).take(count) {
                    let normal = Normal::<$format>::from_unit($format(x), $format(y), $format(z));
                    let Ok(normal) = normal else { break };
                    *irradiance = scene.shade(normal);
                    done += 1;
                }
                done
            }
        }
    };
}

#[cfg(feature = "q15")]
exports!(q15, Q15, i16);
#[cfg(feature = "q31")]
exports!(q31, Q31, i32);

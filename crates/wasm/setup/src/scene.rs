//! Three channels in floats: a turned light on a material as a scene. Every function returns 0 if its
//! input is missing or invalid.

use crate::inputs::{LIGHT, TURN, UNTURNED};
use crate::shared::{LIGHT_COUNT, MATERIAL_COUNT, Shared};
use crate::table::{BASIS, COMPONENTS, DEGREE, SCENE, TRANSFER, WORKSPACE};
use eigenshade::truncation::{Shape, Tolerance, Truncation};
use eigenshade::{Effect, Light, Material, Rgb, Rotation, Scene};

/// The material of the next `transfer`, channel by channel.
#[unsafe(export_name = "material")]
static MATERIAL: Shared<[[f32; MATERIAL_COUNT]; 3]> = Shared::new([[0.0; MATERIAL_COUNT]; 3]);
/// Base color, metallic and roughness of the next `metallic_roughness`.
#[unsafe(export_name = "parameters")]
static PARAMETERS: Shared<[f32; 5]> = Shared::new([0.0; 5]);
/// The coefficients d, channel by channel.
#[unsafe(export_name = "d")]
static D: Shared<[[f32; COMPONENTS]; 3]> = Shared::new([[0.0; COMPONENTS]; 3]);
/// Terms, azimuths, bound, estimated error of the table and peak of the last `collapse_within`.
#[unsafe(export_name = "report")]
static REPORT: Shared<[f32; 5]> = Shared::new([0.0; 5]);

/// The products of light and material of which d is the sum: that of all effects alone, or those of
/// directional and of ambient light. `None` if there is none, or else the effect that masks the light.
static MASKS: Shared<[Option<Option<Effect>>; 2]> = Shared::new([None; 2]);
/// Of each product, the transfers of the masked material.
static TRANSFERS: Shared<[[[f32; TRANSFER]; 3]; 2]> = Shared::new([[[0.0; TRANSFER]; 3]; 2]);
static ROOM: Shared<[f32; WORKSPACE]> = Shared::new([0.0; WORKSPACE]);

/// The scene: its polynomials, channel by channel, and their lengths.
pub static COLLAPSED: Shared<Collapsed> =
    Shared::new(Collapsed { numbers: [0.0; 3 * SCENE], lengths: [0; DEGREE + 1] });

/// A scene in three channels.
pub struct Collapsed {
    numbers: [f32; 3 * SCENE],
    lengths: [u16; DEGREE + 1],
}

impl Collapsed {
    /// The channels, or `None` before the first scene.
    pub fn scene(&self) -> Option<Rgb<Scene<'_, &[f32]>>> {
        let shape = Shape { components: COMPONENTS, lengths: &self.lengths };
        let (channels, _) = self.numbers.as_chunks::<SCENE>();
        let [r, g, b] = channels else { return None };
        Rgb::new(r, g, b).try_map(|numbers| shape.scene(&numbers[..])).ok()
    }
}

/// The coefficients of a glTF material, from the parameters.
#[unsafe(no_mangle)]
extern "C" fn metallic_roughness() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (&mut [r, g, b, metallic, roughness], material) =
        unsafe { (PARAMETERS.borrow(), MATERIAL.borrow()) };
    let Ok(found) = Material::metallic_roughness([r, g, b], metallic, roughness) else { return 0 };
    for (to, from) in material.iter_mut().zip(<[_; 3]>::from(found)) {
        to.fill(0.0);
        to.iter_mut().zip(from.iter()).for_each(|(to, &from)| *to = from);
    }
    1
}

/// The transfers of the material, for the effects whose bits are set: ambient, diffuse, broad and
/// gloss from the lowest.
#[unsafe(no_mangle)]
extern "C" fn transfer(effects: u32) -> u32 {
    const AMBIENT: u32 = 1;
    const ALL: u32 = 0b1111;
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (materials, room, masks, transfers) =
        unsafe { (MATERIAL.borrow(), ROOM.borrow(), MASKS.borrow(), TRANSFERS.borrow()) };
    let directional = match effects & ALL {
        ALL => Some(None),
        AMBIENT | 0 => None,
        _ => Some(Some(Effect::Diffuse)),
    };
    let has_ambient = effects & ALL != ALL && effects & AMBIENT == AMBIENT;
    *masks = [directional, has_ambient.then_some(Some(Effect::Ambient))];
    let mut done = true;
    for (light, transfers) in masks.iter().zip(transfers) {
        for (material, transfer) in materials.iter().zip(transfers) {
            let mut masked = [0.0; MATERIAL_COUNT];
            match light {
                None => continue,
                Some(Some(Effect::Diffuse)) => mask(material, effects, &mut masked),
                Some(_) => masked = *material,
            }
            let transferred = Material::from_finite(&masked)
                .and_then(|material| BASIS.transfer_into(&material, room, transfer));
            done &= transferred.is_ok();
        }
    }
    done.into()
}

/// The coefficients of a material that have part in one of these directional effects.
fn mask(material: &[f32; MATERIAL_COUNT], effects: u32, masked: &mut [f32; MATERIAL_COUNT]) {
    for (bit, effect) in Effect::ALL.into_iter().enumerate().skip(1) {
        if effects >> bit & 1 == 1 {
            let mut part = *material;
            effect.mask_material(&mut part);
            masked.iter_mut().zip(part).for_each(|(sum, b)| *sum += b);
        }
    }
}

/// The coefficients d of the turned light on the material of the last `transfer`; 0 also if
/// one is not finite.
#[unsafe(no_mangle)]
extern "C" fn relight() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (light, turn, masks, transfers, d) =
        unsafe { (LIGHT.borrow(), TURN.borrow(), MASKS.borrow(), TRANSFERS.borrow(), D.borrow()) };
    let [r, g, b] = light;
    let Ok(lights) = Rgb::new(r, g, b).try_map(|numbers| Light::from_finite(&numbers[..])) else {
        return 0;
    };
    let turned;
    let lights = if *turn == UNTURNED {
        lights
    } else {
        let Ok(rotation) = Rotation::from_quaternion(*turn) else { return 0 };
        let Ok(found) = lights.turned::<LIGHT_COUNT>(&rotation) else { return 0 };
        turned = found;
        let Ok(lights) = turned.lights() else { return 0 };
        lights
    };
    let mut done = true;
    for (channel, (light, sums)) in <[_; 3]>::from(lights).into_iter().zip(d).enumerate() {
        *sums = [0.0; COMPONENTS];
        for (mask, transfers) in masks.iter().zip(&*transfers) {
            let (Some(mask), Some(transfer)) = (mask, transfers.get(channel)) else { continue };
            let mut masked = [0.0; LIGHT_COUNT];
            masked.iter_mut().zip(light.coefficients()).for_each(|(to, &from)| *to = from);
            if let Some(effect) = mask {
                effect.mask_light(&mut masked);
            }
            let mut d = [0.0; COMPONENTS];
            let relit = Light::from_finite(&masked)
                .and_then(|light| BASIS.relight_into(&transfer[..], &light, &mut d));
            done &= relit.is_ok();
            sums.iter_mut().zip(d).for_each(|(sum, d)| *sum += d);
        }
        // A sum of magnitudes: as large as any irradiance, about.
        done &= sums.iter().map(|d| d.abs()).sum::<f32>().is_finite();
    }
    done.into()
}

/// Collapses d to a scene with all terms.
#[unsafe(no_mangle)]
extern "C" fn collapse() -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (d, Collapsed { numbers, lengths }) = unsafe { (D.borrow(), COLLAPSED.borrow()) };
    let (channels, _) = numbers.as_chunks_mut::<SCENE>();
    let mut done = true;
    for (d, numbers) in d.iter().zip(channels) {
        done &= BASIS.collapse_into(d, numbers).is_ok();
    }
    *lengths = [0; DEGREE + 1];
    for (to, &from) in lengths.iter_mut().zip(BASIS.parts().lengths) {
        *to = from;
    }
    done.into()
}

/// Collapses d to a scene with as few terms as a share of white under an exposure allows, and writes
/// the report.
#[unsafe(no_mangle)]
extern "C" fn collapse_within(share: f32, exposure: f32) -> u32 {
    // SAFETY: each buffer is borrowed once, and no other function runs.
    let (d, Collapsed { numbers, lengths }, report) =
        unsafe { (D.borrow(), COLLAPSED.borrow(), REPORT.borrow()) };
    let mut reports = [Truncation::default(); 3];
    let mut found = [0; DEGREE + 1];
    let tolerance = Tolerance::OfWhite { share, exposure };
    let shape = BASIS.collapse_set_within(&d[..], 3, tolerance, &mut found, numbers, &mut reports);
    let Ok(shape) = shape else { return 0 };
    *lengths = [0; DEGREE + 1];
    for (to, &from) in lengths.iter_mut().zip(shape.lengths) {
        *to = from;
    }
    let most = |of: fn(&Truncation) -> f32| reports.iter().map(of).fold(0.0, f32::max);
    *report = [
        shape.terms() as f32,
        shape.azimuths() as f32,
        most(|report| report.bound),
        most(|report| report.floor),
        most(|report| report.peak),
    ];
    1
}

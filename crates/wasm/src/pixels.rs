//! Loops over pixels in floats.

#[cfg(feature = "nine-terms")]
use eigenshade::NineTerms;
use eigenshade::Normals;
#[cfg(feature = "map")]
use eigenshade::{BakedMap, MapPoint};
use eigenshade_wasm_setup::floats::COLLAPSED;
#[cfg(feature = "map")]
use eigenshade_wasm_setup::floats::{SIZE, TEXELS};
use eigenshade_wasm_setup::{NORMALS, Shared};

/// Normals to shade: all x, all y, all z.
#[unsafe(export_name = "f32_normals")]
static AXES: Shared<[[f32; NORMALS]; 3]> = Shared::new([[0.0; NORMALS]; 3]);
/// Their irradiances.
#[unsafe(export_name = "f32_irradiance")]
static IRRADIANCE: Shared<[f32; NORMALS]> = Shared::new([0.0; NORMALS]);

/// Computes the irradiances of the first `count` normals. Returns `count`, or 0 if there is no
/// scene or `count` is too large.
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
    let Ok(normals) = Normals::from_unit(x, y, z) else { return 0 };
    if scene.shade_slice(normals, irradiance).is_ok() { count } else { 0 }
}

/// Looks up the irradiances of the first `count` normals in the baked map, bilinearly. Returns
/// `count`, or 0 if it is too large. The map is zero before the first `f32_bake`.
#[cfg(feature = "map")]
#[unsafe(no_mangle)]
extern "C" fn f32_look_up(count: usize) -> usize {
    // SAFETY: each place once, and no other function runs.
    let (texels, [x, y, z], irradiance) =
        unsafe { (TEXELS.borrow(), AXES.borrow(), IRRADIANCE.borrow()) };
    let (Some(x), Some(y), Some(z), Some(irradiance)) =
        (x.get(..count), y.get(..count), z.get(..count), irradiance.get_mut(..count))
    else {
        return 0;
    };
    let (Ok(map), Ok(normals)) = (BakedMap::new(SIZE, &texels[..]), Normals::from_unit(x, y, z))
    else {
        return 0;
    };
    for (irradiance, normal) in irradiance.iter_mut().zip(normals.iter()) {
        *irradiance = map.bilinear(MapPoint::of(normal));
    }
    count
}

/// The coefficients of the nine-term formula (Ramamoorthi and Hanrahan 2001): of 1, x, y, z, x² -
/// y², xy, xz, yz, z².
#[cfg(feature = "nine-terms")]
#[unsafe(export_name = "nine")]
static NINE: Shared<[f32; 9]> = Shared::new([0.0; 9]);

/// Computes the irradiances of the first `count` normals by the nine-term formula, to compare
/// times. Returns `count`, or 0 if it is too large.
#[cfg(feature = "nine-terms")]
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
    let Ok(normals) = Normals::from_unit(x, y, z) else { return 0 };
    if NineTerms::new(*nine).shade_slice(normals, irradiance).is_ok() { count } else { 0 }
}

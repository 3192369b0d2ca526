//! Pixels of a baked map.

use crate::floats::{AXES, IRRADIANCE};
use eigenshade::{BakedMap, MapPoint, Normals};
use eigenshade_wasm_setup::map::{SIZE, TEXELS};

/// The irradiances of the first `count` normals, between the four texels around each: gives
/// their number, or 0 if there is no room. Zeros before the first `f32_bake`.
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
    let (Ok(map), Ok(normals)) = (BakedMap::new(SIZE, &texels[..]), Normals::new(x, y, z)) else {
        return 0;
    };
    for (irradiance, normal) in irradiance.iter_mut().zip(normals.iter()) {
        *irradiance = map.bilinear(MapPoint::of(normal));
    }
    count
}

//! Baked maps against the polynomials that they were made from, on the shipped lights and
//! materials.

use eigenshade::object::{BakedMap, MapPoint};
use eigenshade::{Error, Normal, Normals, Q15, q15, sphere};
use eigenshade_testing::images::{coefficients, on};
use eigenshade_testing::{fixtures, largest, median_and_largest};

/// Every `step`-th light on every `step`-th material.
fn scenes(step: usize) -> Vec<sphere::Scene> {
    let (lights, materials) = (fixtures::captured(9).entries, fixtures::measured(7).entries);
    let mut scenes = Vec::new();
    for light in lights.iter().step_by(step) {
        for material in materials.iter().step_by(step) {
            scenes.push(sphere::collapse(&on(light, material)));
        }
    }
    scenes
}

/// Normals as a picture of a sphere has them, `across` pixels across.
fn normals(across: usize) -> Vec<Normal> {
    fixtures::disc(across).into_iter().map(fixtures::normal).collect()
}

/// A normal of any numbers, which are not scaled.
fn unscaled([x, y, z]: [f32; 3]) -> Normal {
    Normals::from_unit(&[x], &[y], &[z]).expect("one length").iter().next().expect("one normal")
}

/// Scenes, and what their polynomials give for some normals.
struct Shaded {
    scenes: Vec<sphere::Scene>,
    images: Vec<Vec<f64>>,
}

impl Shaded {
    fn new(step: usize, normals: &[Normal]) -> Self {
        let scenes = scenes(step);
        let image = |scene: &sphere::Scene| {
            normals.iter().map(|&normal| f64::from(scene.shade(normal))).collect()
        };
        Self { images: scenes.iter().map(image).collect(), scenes }
    }

    /// Rms and largest error, of the peak, of `N` images of each scene.
    fn errors<const N: usize>(
        &self,
        mut images: impl FnMut(&sphere::Scene) -> [Vec<f32>; N],
    ) -> [Vec<[f64; 2]>; N] {
        let mut found = [const { Vec::new() }; N];
        for (scene, reference) in self.scenes.iter().zip(&self.images) {
            let peak = largest(reference.iter().copied());
            for (errors, image) in found.iter_mut().zip(images(scene)) {
                let apart: Vec<f64> =
                    image.iter().zip(reference).map(|(&a, b)| f64::from(a) - b).collect();
                let rms = (apart.iter().map(|e| e * e).sum::<f64>() / apart.len() as f64).sqrt();
                errors.push([rms / peak, largest(apart) / peak]);
            }
        }
        found
    }
}

fn assert_within(what: &str, errors: &[[f64; 2]], [rms, worst]: [f64; 2]) {
    let [found, largest] = [0, 1]
        .map(|k| median_and_largest(errors.iter().map(|error| error[k]).collect::<Vec<f64>>()));
    println!("{what}: rms {found:?}, largest {largest:?}");
    assert!(found[0] <= rms && found[1] <= worst, "{what}: {found:?} of {rms}, {worst}");
}

/// `Normals` takes any numbers and promises a meaningless irradiance for them.
#[test]
fn normals_that_are_none_are_no_panic() {
    let scene = &scenes(9)[0];
    let map = scene.bake_into(8, vec![0.0; 64]).expect("room");
    let numbers = [1e30, -1e30, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 0.5, -0.0];
    for x in numbers {
        for z in numbers {
            let normal = unscaled([x, z, z]);
            let _ = scene.shade(normal);
            for point in [MapPoint::of(normal), MapPoint::new(x, z)] {
                let _ = map.bilinear(point);
            }
        }
    }
}

/// Baked maps of N texels a side: N, and the rms error of the peak, of the median image and of the
/// worst.
const BAKED: [(usize, [f64; 2]); 3] =
    [(32, [4e-4, 2.1e-3]), (64, [1e-4, 5e-4]), (128, [2.5e-5, 1.4e-4])];

/// What integers may add to that: three roundings to 2^-15, and normals of 2^-16.
const BAKED_INTEGERS: f64 = 4e-5;

/// Map coordinates from Q15 normals, in units of 2^-15: their own rounding and that of the
/// quotient, whose scale is cut to 2^-16.
const MAP_POINT_Q15: f64 = 1.25;

/// A texel in integers is the nearest to that in f32, whose bits are the same: half a unit, and what
/// f32 rounds of 15 bits.
const TEXEL_ROUNDED: f32 = 0.501;

/// A texel against nine points, of the largest texel: some roundings of 24 bits, of places and of
/// irradiances.
const TEXEL_FITTED: f64 = 3e-6;

/// Texels of tens met 1e-6 inward of the rim.
const RIM_INWARD: f32 = 1e-4;

/// A component in Q15.
fn nearest(x: f32) -> Q15 {
    Q15((f64::from(x) * 32_768.0).round().min(32_767.0) as i16)
}

/// A normal in Q15, on the map.
fn on_map([x, y, z]: [Q15; 3]) -> q15::MapPoint {
    q15::MapPoint::of(q15::Normal::from_unit(x, y, z).expect("a unit normal"))
}

#[test]
fn maps_are_as_exact_as_documented() {
    let normals = normals(64);
    let shaded = Shaded::new(1, &normals);
    let points: Vec<_> = normals.iter().map(|&normal| MapPoint::of(normal)).collect();
    for (size, most) in BAKED {
        let [found] = shaded.errors(|scene| {
            let map = scene.bake_into(size, vec![0.0f32; size * size]).expect("room");
            [points.iter().map(|&point| map.bilinear(point)).collect()]
        });
        assert_within(&format!("{size}"), &found, most);
    }
}

/// Integers add their rounding: of the texels, of two steps of a look-up, of the normals.
#[test]
fn integer_maps_are_as_exact_as_documented() {
    let normals = normals(64);
    let shaded = Shaded::new(3, &normals);
    let of_normals: Vec<_> = normals.iter().map(|n| on_map(n.components().map(nearest))).collect();
    let given = normals.iter().map(|&n| MapPoint::of(n).coordinates().map(nearest));
    let given: Vec<_> = given.map(|[u, v]| q15::MapPoint::new(u, v)).collect();
    for (size, bilinear) in BAKED {
        let found = shaded.errors(|scene| {
            let map = scene.bake_integers_into(size, vec![0; size * size]).expect("room");
            let unit = f32::powi(2.0, map.exponent());
            [&of_normals, &given].map(|points| {
                points.iter().map(|&point| map.bilinear(point) as f32 * unit).collect()
            })
        });
        let most = bilinear.map(|rms| rms + BAKED_INTEGERS);
        for errors in found {
            assert_within(&format!("{size}, integers"), &errors, most);
        }
    }
}

/// What integers alone add to a map of the same texels.
#[test]
fn integers_round_and_no_more() {
    let normals = normals(40);
    let scene = &scenes(9)[5];
    let map = scene.bake_into(64, vec![0.0f32; 4096]).expect("room");
    let integers = scene.bake_integers_into(64, vec![0; 4096]).expect("room");
    let unit = f32::powi(2.0, integers.exponent());
    let most = integers.texels().iter().map(|texel| texel.unsigned_abs()).max();
    assert!(most.is_some_and(|most| (1 << 14..1 << 15).contains(&most)), "{most:?}");
    for (texel, integer) in map.texels().iter().zip(integers.texels()) {
        assert!((texel / unit - f32::from(*integer)).abs() <= TEXEL_ROUNDED);
    }
    for normal in normals {
        let [u, v] = MapPoint::of(normal).coordinates().map(nearest);
        let exact = MapPoint::new(f32::from(u.0) / 32_768.0, f32::from(v.0) / 32_768.0);
        let apart = map.bilinear(exact) / unit - integers.bilinear(q15::MapPoint::new(u, v)) as f32;
        // Half a unit of each of: texels, the step along u, the step along v.
        assert!(apart.abs() <= 1.51, "{apart}");
    }
}

/// Texels from the scene at the nine points around each, by the formula that is documented.
#[test]
fn texels_are_as_documented() {
    let scene = &scenes(9)[5];
    let shade = |u: f64, v: f64| {
        let direction = MapPoint::new(u as f32, v as f32).direction();
        f64::from(scene.shade(unscaled(direction)))
    };
    let fitted = |[a, b, c]: [f64; 3]| b - (a - 2.0 * b + c) / 12.0;
    for size in [2, 3, 4, 5, 8, 33] {
        let map = scene.bake_into(size, vec![9.0f32; size * size]).expect("room");
        let integers = scene.bake_integers_into(size, vec![9; size * size]).expect("room");
        let unit = f64::powi(2.0, integers.exponent());
        let most = largest(map.texels().iter().map(|&texel| f64::from(texel)));
        let step = 2.0 / (size - 1) as f64;
        for (k, (&texel, &integer)) in map.texels().iter().zip(integers.texels()).enumerate() {
            let [u, v] = [k % size, k / size].map(|k| k as f64 * step - 1.0);
            // The corner nearest to the center of the cells around the texel.
            let [a, b] = [u, v].map(|x| (x.abs() - step).max(0.0));
            let expected = match a * a + b * b {
                square if square <= 1.0 => {
                    let around = [-step, 0.0, step];
                    fitted(around.map(|up| fitted(around.map(|on| shade(u + on, v + up)))))
                }
                square if square > 1.01 => 0.0,
                _ => continue,
            };
            let [of_float, of_integer] =
                [f64::from(texel), f64::from(integer) * unit].map(|x| (x - expected).abs());
            assert!(of_float <= TEXEL_FITTED * most, "{size}: {texel} at {u}, {v}: {expected}");
            let allowed = TEXEL_FITTED * most + f64::from(TEXEL_ROUNDED) * unit;
            assert!(of_integer <= allowed, "{size}: {integer} at {u}, {v}: {expected}");
        }
    }
}

/// Texels at their points, in the order that is documented; none read that is not there.
#[test]
fn texels_stand_where_documented() {
    // I = x in the middle, whatever the fit takes off: no second differences to speak of.
    let texels: Vec<f32> =
        (0..25).map(|texel| (texel % 5) as f32 + 10.0 * (texel / 5) as f32).collect();
    let map = BakedMap::new(5, texels.as_slice()).expect("25 texels");
    for (u, v, bilinear) in [
        (-1.0, -1.0, 0.0),
        (1.0, -1.0, 4.0),
        (-1.0, 1.0, 40.0),
        (1.0, 1.0, 44.0),
        (0.0, 0.0, 22.0),
        (0.1, -0.2, 18.2),
        (0.3, 0.4, 30.6),
    ] {
        let point = MapPoint::new(u, v);
        // The rim is taken 1e-6 inward.
        assert!((map.bilinear(point) - bilinear).abs() < RIM_INWARD, "{point:?}");
    }
    let texels: Vec<i16> = texels.iter().map(|&texel| 100 * texel as i16).collect();
    let map = q15::BakedMap::new(5, 0, texels).expect("25 texels");
    assert_eq!(map.bilinear(q15::MapPoint::new(Q15(-32_768), Q15(-32_768))), 0);
    assert_eq!(map.bilinear(q15::MapPoint::new(Q15(0), Q15(0))), 2_200);
    assert_eq!(map.bilinear(q15::MapPoint::new(Q15(3_277), Q15(-6_554))), 1_820);
    assert_eq!(map.bilinear(q15::MapPoint::new(Q15(32_767), Q15(32_767))), 4_400);
    assert_eq!(map.bilinear(q15::MapPoint::new(Q15(32_767), Q15(-32_768))), 400);
    // The far corners of i16 neither wrap nor panic.
    let map = q15::BakedMap::new(2, 0, [i16::MIN, i16::MAX, i16::MAX, i16::MIN]).expect("4 texels");
    for u in [i16::MIN, -1, 0, i16::MAX] {
        for v in [i16::MIN, -1, 0, i16::MAX] {
            let exact = |x: i16| (f64::from(x) + 32_768.0) / 65_536.0;
            let (across, up) = (exact(u), exact(v));
            let weight = across + up - 2.0 * across * up;
            let expected = -32_768.0 + 65_535.0 * weight;
            let found = f64::from(map.bilinear(q15::MapPoint::new(Q15(u), Q15(v))));
            assert!((found - expected).abs() < 3.0, "{u} {v}: {found} {expected}");
        }
    }
}

/// Normals go to the map and back; integers without a division come as near as their
/// digits.
#[test]
fn normals_go_to_the_map_and_back() {
    let mut worst = 0.0f64;
    for normal in normals(200) {
        let back = MapPoint::of(normal).direction();
        let mut pairs = back.into_iter().zip(normal.components());
        assert!(pairs.all(|(back, there)| (back - there).abs() <= 3e-7), "{back:?}");
        let components = normal.components().map(nearest);
        let found = on_map(components).coordinates();
        let [x, y, z] = components.map(|q| f64::from(q.0) / 32_768.0);
        for (found, exact) in found.into_iter().zip([x / (1.0 + z), y / (1.0 + z)]) {
            worst = worst.max((f64::from(found.0) - 32_768.0 * exact).abs());
        }
    }
    // Every slant, at the largest component that it leaves.
    for z in 0..=i16::MAX {
        let slant = f64::from(z) / 32_768.0;
        for x in [1.0, -1.0].map(|sign| (sign * 32_768.0 * (1.0 - slant * slant).sqrt()) as i16) {
            let [u, v] = on_map([x, 0, z].map(Q15)).coordinates();
            let exact = f64::from(x) / (1.0 + slant);
            worst = worst.max((f64::from(u.0) - exact).abs());
            assert_eq!(v, Q15(0));
        }
    }
    println!("Q15: {worst}");
    assert!(worst <= MAP_POINT_Q15, "{worst}");
}

#[test]
fn sizes_that_do_not_fit_are_errors() {
    let scene = &scenes(9)[0];
    for size in [0, 1, 4097, usize::MAX] {
        let refused = Some(Error::Size { found: size });
        assert_eq!(scene.bake_into(size, [0.0f32; 4]).err(), refused);
        assert_eq!(BakedMap::<_>::new(size, [0.0f32; 4]).err(), refused);
        assert_eq!(q15::BakedMap::new(size, 0, [0; 4]).err(), refused);
    }
    assert!(matches!(scene.bake::<15>(4), Err(Error::Capacity { needed: 16, .. })));
    assert!(matches!(scene.bake_into(4, [0.0f32; 15]), Err(Error::Length { expected: 16, .. })));
    assert!(matches!(scene.bake_integers_into(4, [0; 15]), Err(Error::Length { .. })));
    assert!(scene.bake::<16>(4).is_ok());
    // A black image has no scale.
    let black = sphere::collapse(&coefficients(&[0.0], &[0.0]));
    let map = black.bake_integers_into(4, [1; 16]).expect("16 texels");
    assert!(map.texels().iter().all(|&texel| texel == 0));
}

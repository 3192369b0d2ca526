//! Look-ups against the polynomials that they sample, on the shipped lights and
//! materials.

use crate::shipped;
use eigenshade::{Error, MapPoint, Normal, Normals};
use shipped::{assert_within, errors, normals, scenes};

/// Look-ups with so many knots: knots, rms of linear and of cubic ones, of the peak, each of the median
/// image and of the worst: linear falls by four, cubic by sixteen at best, down to the rounding of f32.
const LOOKUP: [(usize, [f64; 2], [f64; 2]); 4] = [
    (16, [6e-4, 5e-3], [7e-5, 8e-4]),
    (32, [1.4e-4, 1.1e-3], [6e-6, 7e-5]),
    (64, [3.5e-5, 2.6e-4], [7e-7, 8e-6]),
    (128, [8e-6, 6.5e-5], [1.2e-7, 1e-6]),
];

#[test]
fn lookups_are_as_exact_as_documented() {
    let (scenes, normals) = (scenes(1), normals(64));
    for (knots, linear, cubic) in LOOKUP {
        let lookups: Vec<_> = scenes
            .iter()
            .map(|scene| {
                let room = vec![0.0f32; scene.lookup_len::<f32>(knots)];
                scene.lookup_into(knots, room).expect("room")
            })
            .collect();
        let mut of_scene = lookups.iter();
        let found = errors(&scenes, &normals, |_| {
            let lookup = of_scene.next().expect("one for each");
            normals.iter().map(|&n| lookup.linear(n)).collect()
        });
        assert_within(&format!("{knots}, linear"), &found, linear);
        let mut of_scene = lookups.iter();
        let found = errors(&scenes, &normals, |_| {
            let lookup = of_scene.next().expect("one for each");
            normals.iter().map(|&n| lookup.cubic(n)).collect()
        });
        assert_within(&format!("{knots}, cubic"), &found, cubic);
    }
}

/// At a knot both are the sample; the rim and the pole are knots.
#[test]
fn knots_are_met() {
    let scene = &scenes(9)[3];
    for knots in [8, 9, 64] {
        let lookup =
            scene.lookup_into(knots, vec![0.0; scene.lookup_len::<f32>(knots)]).expect("room");
        for k in 0..knots {
            let z = k as f32 / (knots - 1) as f32;
            let normal = Normal::new(0.6 * (1.0 - z * z).sqrt(), 0.8 * (1.0 - z * z).sqrt(), z)
                .expect("visible");
            let exact = scene.shade(normal);
            let peak =
                scene.shade(Normal::new(0.0, 0.0, 1.0).expect("visible")).abs().max(exact.abs());
            for found in [lookup.linear(normal), lookup.cubic(normal)] {
                // A knot is taken up to 2.4e-7 of an interval off, times the slope there.
                assert!((found - exact).abs() <= 2e-5 * peak, "{k} of {knots}: {found} {exact}");
            }
        }
    }
}

#[test]
fn numbers_of_knots_that_do_not_fit_are_errors() {
    let scene = &scenes(9)[0];
    for knots in [0, 7, 65_537, usize::MAX] {
        let found = scene.lookup_into(knots, [0.0f32; 4]);
        assert_eq!(found.err(), Some(Error::Knots { found: knots }));
    }
    let needed = scene.lookup_len::<f32>(8);
    // Azimuths to 6 of the shipped table.
    assert_eq!(needed, 13 * 10);
    assert!(matches!(scene.lookup::<f32, 129>(8), Err(Error::Capacity { needed: 130, .. })));
    assert!(matches!(scene.lookup_into(8, vec![0.0f32; 131]), Err(Error::Length { .. })));
    assert!(scene.lookup::<f32, 130>(8).is_ok());
}

/// `Normals` takes any numbers and promises a meaningless irradiance for them: z = 1e30 stood at the
/// last interval that there can be, whose second knot overflowed.
#[test]
fn normals_that_are_none_are_no_panic() {
    let scene = &scenes(9)[0];
    let lookup = scene.lookup_into(8, vec![0.0; scene.lookup_len::<f32>(8)]).expect("room");
    let map = scene.bake_into(8, vec![0.0; 64]).expect("room");
    let numbers = [1e30, -1e30, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 0.5, -0.0];
    for x in numbers {
        for z in numbers {
            let normals = [[x], [z], [z]];
            let [x, y, z] = normals.each_ref();
            let normals = Normals::new(x, y, z).expect("one length");
            let normal = normals.iter().next().expect("one normal");
            let _ = (lookup.linear(normal), lookup.cubic(normal), scene.shade(normal));
            for point in [MapPoint::of(normal), MapPoint::new(x[0], z[0])] {
                let _ = (map.bilinear(point), map.nearest(point));
            }
        }
    }
}

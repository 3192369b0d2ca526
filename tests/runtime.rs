//! The runtime on its shipped table: costs, errors, and agreement of every way.

use eigenshade::sphere;
use eigenshade_table::statics;

/// One f32 result by two orders of summation, of the largest: some twenty roundings.
const SAME_SUM_F32: f32 = 1e-6;

/// Bytes of the tables in f32, and numbers in a workspace, in coefficients, in a transfer and in a
/// scene.
const MEMORY: [usize; 5] = [22_008, 460, 46, 568, 167];

#[test]
fn costs_are_the_tables() {
    let bytes = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    let module = statics::floats(&table, "a test").expect("it projects");
    let flash = module.lines().nth(1).and_then(|line| line.split(' ').nth(1));
    let flash: usize = flash.and_then(|bytes| bytes.parse().ok()).expect("a number of bytes");
    let found = [flash, sphere::WORKSPACE, sphere::COMPONENTS, sphere::TRANSFER, sphere::SCENE];
    assert_eq!(found, MEMORY);
    // On a 32-bit machine 188, 2,276 and 676, as docs/costs.md has them.
    #[cfg(target_pointer_width = "64")]
    assert_eq!(
        [
            size_of::<sphere::Coefficients>(),
            size_of::<sphere::Transfer>(),
            size_of::<sphere::Scene>()
        ],
        [188 + 4, 2_276 + 92, 676 + 12]
    );
}

/// The generated kernels give what the general way gives, bit for bit or as near as
/// another order of summation allows.
#[test]
fn generated_kernels_agree_with_the_general_way() {
    let numbers = |count: usize, seed: f32| -> Vec<f32> {
        (0..count).map(|k| (seed * (k as f32 + 1.0)).sin() / (1.0 + 0.1 * k as f32)).collect()
    };
    // Miri takes two seconds a case.
    let cases = if cfg!(miri) { 3 } else { 39 };
    for case in 1..=cases {
        let light = numbers(100, 1.3 * case as f32);
        let material = numbers(40, 0.7 * case as f32);
        let light = eigenshade::Light::new(&light).expect("100 coefficients");
        let material = eigenshade::Material::new(&material).expect("40 coefficients");
        let general: sphere::Coefficients = sphere::BASIS
            .project::<{ sphere::WORKSPACE }, { sphere::COMPONENTS }>(&light, &material)
            .expect("capacities are the table's");
        let transfer = sphere::transfer(&material).expect("an order of 7");
        let relit: sphere::Coefficients =
            sphere::BASIS.relight(&transfer, &light).expect("capacities are the table's");
        let largest = general.iter().fold(0.0f32, |most, d| most.max(d.abs()));
        let fixed = sphere::project(&light, &material).expect("it fits");
        let fixed_relit = sphere::relight(&transfer, &light).expect("it fits");
        for k in 0..sphere::COMPONENTS {
            for other in [relit[k], fixed[k], fixed_relit[k]] {
                assert!((general[k] - other).abs() <= SAME_SUM_F32 * largest, "component {k}");
            }
        }
        // Lower degrees take the general way and count as zero above.
        let lower = light.truncated(case % 9);
        let mut padded = vec![0.0; 100];
        padded[..lower.coefficients().len()].copy_from_slice(lower.coefficients());
        let padded = eigenshade::Light::new(&padded).expect("100 coefficients");
        let (lower, padded) =
            (sphere::relight(&transfer, &lower), sphere::relight(&transfer, &padded));
        let (lower, padded) = (lower.expect("it fits"), padded.expect("it fits"));
        assert!(lower.iter().zip(&padded).all(|(a, b)| (a - b).abs() <= SAME_SUM_F32 * largest));
    }
}

#[test]
fn arguments_beyond_the_table_are_errors() {
    use eigenshade::{Argument, Error, Light, Material, Normal, Normals};
    let (many, few) = (vec![0.0f32; 121], vec![0.0f32; 55]);
    let refused = |argument, found| Err(Error::Count { argument, found });
    for found in [0, 2, 99, 101, 120] {
        assert_eq!(Light::new(&many[..found]).map(|_| ()), refused(Argument::Light, found));
    }
    for found in [0, 3, 39, 41, 54] {
        assert_eq!(Material::new(&few[..found]).map(|_| ()), refused(Argument::Material, found));
    }
    let light = Light::new(&many).expect("121 coefficients");
    let material = Material::new(&few).expect("55 coefficients");
    let fine = material.truncated(7);
    assert_eq!(light.truncated(usize::MAX), light);
    assert_eq!(material.truncated(usize::MAX), material);
    let beyond = |error| matches!(error, Some(Error::Beyond { .. }));
    assert!(beyond(sphere::project(&light, &fine).err()));
    assert!(beyond(sphere::project(&light.truncated(9), &material).err()));
    assert!(beyond(sphere::transfer(&material).err()));
    assert!(sphere::project(&light.truncated(9), &fine).is_ok());
    assert!(matches!(sphere::BASIS.collapse::<9>(&[]), Err(Error::Capacity { .. })));
    assert!(matches!(
        sphere::BASIS.collapse::<{ sphere::SCENE }>(&many),
        Err(Error::Length { .. })
    ));
    assert!(Normals::new(&many, &few, &many).is_err());
    // Neither longer or shorter than 1 by more than one part in 2,000, nor behind the rim.
    for (z, is_unit) in [
        (1.0004f32, true),
        (0.9996, true),
        (1.0006, false),
        (0.9994, false),
        (-1.0, false),
        (f32::NAN, false),
        (f32::INFINITY, false),
    ] {
        let found = Normals::new(&[0.6, 0.0], &[0.8, 0.0], &[0.0, z]).map(|list| list.len());
        assert_eq!(found, if is_unit { Ok(2) } else { Err(Error::Normals { index: 1 }) }, "{z}");
    }
    assert_eq!(Normal::new(0.0f32, 0.0, 0.0), Err(Error::Normal));
    assert_eq!(Normal::new(f32::NAN, 0.0, 1.0), Err(Error::Normal));
    assert_eq!(Normal::new(0.0f32, 1.0, -0.5), Err(Error::Hidden));
    let rim = Normal::new(2.0f32, 0.0, -0.001).expect("laid on the rim").components();
    assert_eq!(rim, [1.0, 0.0, 0.0]);
}

/// A coefficient that is not finite is refused with its place.
#[test]
fn lights_and_materials_are_finite() {
    use eigenshade::{Argument, Error, Light, Material};
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let numbers = [1.0, 0.0, bad, -2.0, bad];
        let light = Error::NotFinite { argument: Argument::Light, index: 2 };
        assert_eq!(Light::new(&numbers[..4]), Err(light));
        let material = Error::NotFinite { argument: Argument::Material, index: 2 };
        assert_eq!(Material::new(&numbers), Err(material));
    }
    let numbers = [f32::MAX, f32::MIN, 1e-45, -0.0, 0.0];
    assert_eq!(Light::new(&numbers[..4]), Light::from_finite(&numbers[..4]));
    assert_eq!(Material::new(&numbers), Material::from_finite(&numbers));
    assert!(matches!(Light::new(&numbers), Err(Error::Count { .. })));
}

/// Those of a map of 8 bits or of a mesh are scaled and laid on the rim; the first that cannot be
/// is an error with its place, and stays as it was.
#[test]
fn normals_are_scaled_where_they_are() {
    use eigenshade::{Error, Normals};
    let (mut x, mut y, mut z) =
        ([0.0f32, 255.0, 3.0, 0.0], [0.0f32, 1.0, 4.0, 0.0], [254.0f32, -31.0, 0.0, -1.0]);
    let refused = Normals::normalized(&mut x, &mut y, &mut z);
    assert_eq!(refused, Err(Error::Normals { index: 3 }));
    assert_eq!((x[3], y[3], z[3]), (0.0, 0.0, -1.0));
    assert_eq!((x[0], y[0], z[0]), (0.0, 0.0, 1.0));
    assert_eq!(z[1], 0.0);
    // A square root is exact to half a last place everywhere; `hypot` may be off by more.
    let length = (x[1] * x[1] + y[1] * y[1]).sqrt();
    assert!((length - 1.0).abs() <= 2.0 * f32::EPSILON, "{} {}", x[1], y[1]);
    let normals = Normals::normalized(&mut x[..3], &mut y[..3], &mut z[..3]);
    let [x, y, z] = normals.expect("visible").iter().nth(2).expect("three").components();
    assert!((x - 0.6).abs() < 1e-6 && (y - 0.8).abs() < 1e-6 && z == 0.0);
    let (mut x, mut z) = ([0.0f32], [1.0]);
    let length = Normals::normalized(&mut x, &mut [], &mut z);
    assert!(matches!(length, Err(Error::Length { .. })));
}

/// A slice is shaded as its normals are, whatever its length.
#[test]
fn slices_are_shaded_as_their_normals() {
    let light: Vec<f32> = (0..100).map(|k| 1.0 / (k as f32 + 1.0)).collect();
    let material: Vec<f32> = (0..40).map(|k| 1.0 / (k as f32 + 1.0)).collect();
    let light = eigenshade::Light::new(&light).expect("100 coefficients");
    let material = eigenshade::Material::new(&material).expect("40 coefficients");
    let d = sphere::project(&light, &material).expect("it fits");
    let scene = sphere::collapse(&d);
    for count in [0, 1, 15, 16, 17, 63, 64, 65, 200] {
        let normals: Vec<_> = (0..count)
            .map(|k| {
                let tilt = 0.7 * k as f32;
                eigenshade::Normal::new(tilt.cos(), tilt.sin(), 0.01 * k as f32).expect("visible")
            })
            .collect();
        let axis = |axis: usize| -> Vec<f32> {
            normals.iter().map(|normal| normal.components()[axis]).collect()
        };
        let (x, y, z) = (axis(0), axis(1), axis(2));
        let mut shaded = vec![0.0; count];
        let slices = eigenshade::Normals::new(&x, &y, &z).expect("one length");
        assert!(slices.iter().eq(normals.iter().copied()) && slices.iter().len() == count);
        scene.shade_slice(slices, &mut shaded).expect("one length");
        for (normal, shaded) in normals.iter().zip(&shaded) {
            assert_eq!(scene.shade(*normal), *shaded);
            let summed = sphere::BASIS.reconstruct(&d, *normal).expect("its coefficients");
            assert!((summed - shaded).abs() <= SAME_SUM_F32 * d[0].abs());
        }
        assert!(scene.shade_slice(slices, &mut vec![0.0; count + 1]).is_err());
    }
}

/// Relighting reads a transfer's numbers group by group: none straddles two cache lines.
#[cfg(target_pointer_width = "64")]
#[test]
fn a_transfer_starts_a_cache_line() {
    let material = eigenshade::Material::new(&[0.3; 40]).expect("40 coefficients");
    let transfer = sphere::transfer(&material).expect("an order of 7");
    assert_eq!(transfer.as_slice().as_ptr().addr() % 64, 0);
}

/// A normal is hidden from an eighth behind the rim on.
#[test]
fn normals_behind_the_rim_by_an_eighth_are_hidden() {
    let behind = |z: f32| eigenshade::Normal::new((1.0 - z * z).sqrt(), 0.0, -z);
    let [x, y, z] = behind(0.124_9).expect("near the rim").components();
    assert!((x - 1.0).abs() <= 2e-7 && (y, z) == (0.0, 0.0), "{x}");
    assert_eq!(behind(0.125_1), Err(eigenshade::Error::Hidden));
}

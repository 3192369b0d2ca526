//! Polynomials that are too long for powers of t, against their Chebyshev series by cosines,
//! trimmed polynomials against the direct sum (15), and what a scene within a tolerance costs a
//! pixel, beside the least that any lengths could cost: found by trying all, azimuth by azimuth.

use crate::invariants::integer::eigenimage;
use eigenshade::truncation::Tolerance;
use eigenshade::{Normal, sphere};
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::trim::trim;
use eigenshade_testing::fixtures::{
    Projector, captured, measured, normal, of_equal_areas, shipped_table, spiral,
};
use eigenshade_testing::images::{Image, on, products, rule, shape};
use eigenshade_testing::largest;

/// An eigenimage whose polynomial has an even and an odd half of ten terms, of its largest value:
/// its powers of u cancel, up to (1 + √2)^10 = 6,700 to one, and are rounded to 2^-24.
const HALVES_F32: f64 = 4e-4;

/// Each component alone, by collapsing it and by itself; of its largest value, the worst.
fn farthest() -> f64 {
    let table = shipped_table("pbr");
    let owned = OwnedBasis::new(&table).expect("a table for f32");
    let basis = owned.basis().expect("parts of a table");
    let lengths = basis.parts().lengths;
    assert!(lengths.iter().filter(|&&length| (17..=32).contains(&length)).count() >= 10);
    let mut worst = 0.0f64;
    for (k, component) in table.components.iter().enumerate() {
        let mut d = vec![0.0; table.components.len()];
        d[k] = 1.0;
        let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
        let (mut off, mut largest) = (0.0f64, 0.0f64);
        for at in spiral((0..200).map(|k| (f64::from(k) + 0.5) / 200.0)) {
            let reference = eigenimage(&table, component, at);
            let alone = basis.reconstruct(&d, normal(at)).expect("sizes");
            for found in [scene.shade(normal(at)), alone] {
                off = off.max((f64::from(found) - reference).abs());
            }
            largest = largest.max(reference.abs());
        }
        worst = worst.max(off / largest);
    }
    worst
}

#[test]
fn halves_cancel_little() {
    let worst = farthest();
    println!("of an eigenimage's largest value: {worst:.1e}");
    assert!(worst <= HALVES_F32);
}

/// Rms error of the firmware's full scene over the rms peak: what its components and terms are
/// chosen for.
const FULL_SCENE: f64 = 1e-4;

/// The table of `firmware/tables/full.toml`.
const TABLE: &[u8] = include_bytes!("../firmware/tables/full.bin");

/// The parts that the firmware's full scene leaves out, components and terms together: the root of
/// the mean square error over the root of the mean square of the images' peaks, lights
/// scaled to L_0^0 = 1.
#[test]
fn the_full_scene_keeps_its_tolerance() {
    let mut table = eigenshade_table::decode(TABLE).expect("a table");
    let said = trim(&mut table, 2e-4);
    assert!(said <= 2e-4, "{said}");
    let terms: usize =
        eigenshade_table::parts::floats(&table).lengths.iter().map(|&n| usize::from(n)).sum();
    assert!(terms <= 80, "{terms} for one sign of m");
    let projector = Projector::new(&table);
    let (degree, order) = (table.gram.degree, table.gram.order);
    let (lights, materials) = (captured(degree), measured(order));
    let normals = of_equal_areas(200);
    let eigenimages = projector.0.eigenimages(&normals);
    let reference = DirectSum::new(degree, order);
    let (mut error, mut peaks) = (0.0, 0.0);
    for material in &materials.entries {
        let material = material.luminance();
        let modes = normals.iter().map(|&normal| reference.at(normal));
        let scattered: Vec<_> = modes.map(|at| (at.scatter(&material), at)).collect();
        for light in &lights.entries {
            let light = light.luminance();
            let light: Vec<f64> = light.iter().map(|value| value / light[0]).collect();
            let found = eigenimages.reconstruct(&projector.project(&light, &material));
            let expected = scattered.iter().map(|(scattered, at)| at.irradiance(&light, scattered));
            let (mut square, mut peak) = (0.0, 0.0f64);
            for (found, expected) in found.iter().zip(expected) {
                square += (found - expected).powi(2) / normals.len() as f64;
                peak = peak.max(expected.abs());
            }
            error += square;
            peaks += peak * peak;
        }
    }
    let relative = (error / peaks).sqrt();
    println!("{relative:.2e}, trimmed by {said:.2e} of the deviation");
    assert!(relative <= FULL_SCENE, "{relative}");
}

/// Products of a pixel within a tolerance, over the fewest that any lengths need: in the mean, and
/// of any image. Terms go at few prices, and none comes back.
const OF_FEWEST: [f64; 2] = [1.02, 1.4];

/// The least share of images in per cent whose pixels take the fewest products, and the most
/// products of any over its fewest.
const RECORDED: [&str; 2] = ["68", "1.4"];

/// Mean square error of the image without the highest terms of one azimuth, by the number that
/// stay, by quadrature; azimuths are orthogonal, so those of several add.
fn losses(d: &[f32], image: &Image, rule: &[(Normal, f64)]) -> Vec<Vec<f64>> {
    let full = sphere::BASIS.parts().lengths;
    let of = |azimuth: usize, length: u16| {
        let mut lengths = full.to_vec();
        lengths[azimuth] = length;
        let room = [0.0; sphere::SCENE];
        let made = sphere::BASIS.collapse_as(d, shape(&lengths), room).expect("sizes");
        image.apart(&made.0, rule).powi(2)
    };
    let all = full.iter().enumerate();
    all.map(|(azimuth, &most)| (0..=most).map(|length| of(azimuth, length)).collect()).collect()
}

/// The fewest products of a pixel with at most this mean square error.
fn fewest(losses: &[Vec<f64>], allowed: f64) -> usize {
    let mut least = usize::MAX;
    for azimuths in 0..=losses.len() {
        let gone: f64 = losses[azimuths..].iter().map(|losses| losses[0]).sum();
        // By products of the polynomials: the least error.
        let mut errors = vec![gone];
        for (azimuth, losses) in losses[..azimuths].iter().enumerate() {
            let signs = if azimuth == 0 { 1 } else { 2 };
            let more = signs * losses.len();
            let mut next = vec![f64::INFINITY; errors.len() + more];
            for (cost, error) in errors.iter().enumerate() {
                for (length, loss) in losses.iter().enumerate() {
                    let place = &mut next[cost + signs * length.saturating_sub(1)];
                    *place = place.min(error + loss);
                }
            }
            errors = next;
        }
        let around = (4 * azimuths.saturating_sub(1)).saturating_sub(2);
        if let Some(cost) = errors.iter().position(|&error| error <= allowed) {
            least = least.min(cost + around + usize::from(cost > 0));
        }
    }
    least
}

#[test]
fn a_pixel_costs_little_more_than_the_least_possible() {
    let (lights, materials) = (captured(9), measured(7));
    let rule = rule();
    let shares = [0.1, 1e-2, 1e-3];
    let mut found = shares.map(|_| Vec::new());
    for light in &lights.entries {
        for material in materials.entries.iter().step_by(15) {
            let d = on(light, material);
            let image = Image::new(&d, &rule);
            let losses = losses(&d, &image, &rule);
            for (share, found) in shares.into_iter().zip(&mut found) {
                let (mut lengths, tolerance) = ([0; 16], Tolerance::OfPeak(share));
                let room = [0.0f32; sphere::SCENE];
                let within = sphere::BASIS.collapse_within(&d, tolerance, &mut lengths, room);
                let report = within.expect("sizes").1;
                let allowed = f64::from(share * report.peak).powi(2);
                let components = f64::from(report.left_out_by_components).powi(2);
                let least = fewest(&losses, allowed - components);
                let cost = products(&lengths[..report.azimuths]);
                found.push(if cost == least { 1.0 } else { cost as f64 / least.max(1) as f64 });
            }
        }
    }
    let (mut fewest, mut most) = (f64::INFINITY, 0.0f64);
    for (share, found) in shares.into_iter().zip(found) {
        let count = found.len() as f64;
        let worst = largest(found.iter().copied());
        let least = 100.0 * found.iter().filter(|&&ratio| ratio <= 1.0).count() as f64 / count;
        let mean = found.iter().sum::<f64>() / count;
        println!("{share}: {least:.0} % the least, mean {mean:.4}, worst {worst:.3}");
        assert!(mean <= OF_FEWEST[0], "{share}: {mean}");
        assert!(worst <= OF_FEWEST[1], "{share}: {worst}");
        (fewest, most) = (fewest.min(least), most.max(worst));
    }
    assert_eq!([format!("{fewest:.0}"), format!("{most:.1}")], RECORDED);
}

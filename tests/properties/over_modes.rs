//! Products of a sphere's eigenimages and energies of its modes, azimuth by azimuth.

use crate::tolerances;
use eigenshade_generator::basis::moments;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_index::effect::Effects;
use eigenshade_index::{light, material, mode};
use eigenshade_table::Table;

/// Each of `table`'s components against the others, in node space and over modes.
pub fn assert_orthonormal(loaded: &Loaded, table: &Table) {
    let gram = &table.gram;
    let moments = moments::LightMoments::new(&loaded.lights, table.scene.light.normalize)
        .expect("positive lights");
    for azimuth in 0..=gram.degree {
        let profiles: Vec<_> =
            table.profiles.iter().enumerate().filter(|(_, one)| one.azimuth == azimuth).collect();
        if profiles.is_empty() {
            continue;
        }
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let columns = gram.columns(azimuth);
        let image = |modes: &[f64]| {
            let mut image = vec![0.0; gram.nodes.len()];
            for (column, value) in columns.iter().zip(modes) {
                image.iter_mut().zip(column).for_each(|(pixel, a)| *pixel += value * a);
            }
            image
        };
        let images: Vec<_> = profiles.iter().map(|(_, one)| image(&one.modes)).collect();
        // What of a component lies where the cut-off counts A as zero: A F v / σ_k, so
        // at most cut-off |A| |F| / σ_k.
        let criterion = table.scene.basis.criterion;
        let of_materials = moments::MaterialMoments::new(&loaded.materials);
        let deviations =
            moments::deviations(&moments, &of_materials, Effects::ALL, criterion, azimuth);
        let squares = deviations.iter().flat_map(|one| &one.material).map(|b| b * b);
        let factor = squares.sum::<f64>().sqrt();
        let cut = table.scene.basis.rank_cutoff;
        let lost = |k: usize| {
            let component = table.components.iter().find(|one| one.profile == k);
            let value = component.and_then(|one| one.eigenvalue).map_or(1.0, f64::sqrt);
            // The constant is the image of one mode, of variance 1/16.
            let over = if value == 1.0 { factor.max(4.0) } else { factor };
            cut * table.summary.largest_singular_value * over / value
        };
        for (i, (k, a)) in profiles.iter().enumerate() {
            for (j, (n, b)) in profiles.iter().enumerate().take(i + 1) {
                let one = f64::from(u8::from(i == j));
                let nodes = (product(&a.node_values, &b.node_values) - one).abs();
                assert!(nodes <= tolerances::ORTHONORMAL_NODES, "WᵀW {nodes} of {azimuth}");
                let allowed = lost(*k) + lost(*n) + tolerances::ORTHONORMAL_ROUNDING / cut;
                let modes = (product(&images[i], &images[j]) - one).abs();
                assert!(modes <= allowed, "UᵀMU {modes} of {allowed}, |m| = {azimuth}: {i}, {j}");
            }
        }
    }
}

/// cᵀMc = Σ_m |A c|².
pub fn energy(table: &Table, light: &[f64], material: &[f64]) -> f64 {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut energy = 0.0;
    for azimuth in 0..=degree {
        let columns = table.gram.columns(azimuth);
        let m = azimuth.cast_signed();
        for order_m in if m == 0 { vec![0] } else { vec![m, -m] } {
            let mut image = vec![0.0; table.gram.nodes.len()];
            for ((l, o, p, q), column) in mode::indices(degree, order, azimuth).zip(&columns) {
                let c = light[light::position(l, order_m)] * material[material::position(o, p, q)];
                image.iter_mut().zip(column).for_each(|(pixel, a)| *pixel += c * a);
            }
            energy += image.iter().map(|pixel| pixel * pixel).sum::<f64>();
        }
    }
    energy
}

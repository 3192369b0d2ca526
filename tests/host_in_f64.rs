//! The host's own evaluation of tables, windows, sources and highlights in f64 against the
//! runtime's in f64.

use eigenshade::mathematics::Libm;
use eigenshade::{Effect, Effects, Normal, Rgb, SourceSet, Window as OfRuntime};
use eigenshade_index::light;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::source::{Gloss, Source};
use eigenshade_model::window::Window;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fitted};
use eigenshade_shading::{highlights as of_shading, shipped};
use eigenshade_table::Table;
use eigenshade_table::scene::Store;
use eigenshade_testing::fixtures::{self, SLANTS, shipped_table};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{self, listed};
use eigenshade_testing::{largest, largest_difference};

/// Of the peak.
const EQUAL: f64 = 1e-12;

/// Compares d, images and eigenimages of some lights on some materials.
fn compare(what: &str, table: &Table, lights: &Lights, materials: &Materials, effects: Effects) {
    let (lights, materials) = fitted(table, lights, materials);
    let owned = OwnedBasis::<f64>::new(table);
    let normals = fixtures::normals(&SLANTS, 7);
    let owned_normals = OwnedNormals::new(&normals);
    let mut most = [0.0_f64; 3];
    for components in [table.count(), table.count().div_ceil(3)] {
        let mut shader = Shader::new(owned.any().expect("a basis"), components)
            .with_transfers(owned.transfers())
            .with_effects(effects)
            .expect("effects");
        let evaluator = Evaluator::new(table).with_components(components);
        let evaluator = evaluator.with_effects(effects).expect("effects");
        let images = evaluator.eigenimages(&normals);
        for k in 0..8 {
            let light = &lights.entries[5 * k % lights.entries.len()].rgb[k % 3];
            let material = &materials.entries[7 * k % materials.entries.len()].rgb[k % 3];
            let d = evaluator.project(light, material).expect("a known material");
            if effects.has(Effect::Ambient) {
                let expected = shader.project(light, material).expect("it fits");
                most[0] = most[0].max(largest_difference(&d, expected) / largest(d.clone()));
            }
            let expected = shader.polynomial(light, material, &owned_normals).expect("it fits");
            let peak = largest(expected.iter().copied());
            let found = images.reconstruct(&d);
            most[1] = most[1].max(largest_difference(&found, &expected) / peak);
            if !table.effects().is_all() || components < table.count() {
                continue;
            }
            let each = owned_normals.each().expect("visible");
            let expected = shader.eigen(light, material, &each).expect("it fits");
            most[2] = most[2].max(largest_difference(&found, &expected) / peak);
        }
    }
    println!(
        "{what}, {} components: d {:e}, pixels {:e}, {:e}",
        table.count(),
        most[0],
        most[1],
        most[2]
    );
    assert!(most.iter().all(|error| *error <= EQUAL), "{what}: {most:?}");
}

#[test]
fn shipped_tables() {
    let lights = fixtures::captured(12);
    for name in ["sphere", "pbr", "color", "curet"] {
        let table = shipped_table(name);
        let materials = shipped::named_materials(table.gram.order).expect("shipped");
        compare(name, &table, &lights, &materials, Effects::ALL);
        // Of a lower degree and a lower order.
        compare(name, &table, &lights.truncated(4), &materials.truncated(3), Effects::ALL);
        for effect in Effect::ALL {
            compare(name, &table, &lights, &materials, Effects::NONE.with(effect));
        }
    }
}

#[test]
fn selections_means_effects_transfers_and_series() {
    let mut numbers = Numbers(5);
    let (degree, order) = (6, 5);
    let lights = fixtures::lights(degree, 6, &mut numbers);
    let materials = fixtures::materials(order, 5, &mut numbers);
    let whole = fixtures::scene(lights, materials);
    for standard in [false, true] {
        for (modes, store) in [
            (0, Store::Modes),
            (700, Store::Projection),
            (0, Store::Materials),
            (700, Store::Materials),
        ] {
            for wanted in [
                Effect::ALL.to_vec(),
                vec![Effect::Ambient, Effect::Diffuse],
                vec![Effect::Diffuse, Effect::Broad],
                vec![Effect::Ambient],
            ] {
                let mut loaded = whole.clone();
                if standard {
                    loaded = fixtures::standard(loaded);
                }
                let scene = &mut loaded.scene;
                (scene.basis.modes, scene.basis.store) = (modes, store);
                scene.effects.wanted = wanted.clone();
                let table = fixtures::table(&loaded);
                let what = format!("{standard} {modes} {store:?} {wanted:?}");
                compare(&what, &table, &loaded.lights, &loaded.materials, Effects::ALL);
                if store != Store::Materials {
                    for effect in [Effect::Ambient, Effect::Diffuse] {
                        let effects = Effects::NONE.with(effect);
                        // A table without any of the effects gives black images.
                        if wanted.contains(&effect) {
                            compare(&what, &table, &loaded.lights, &loaded.materials, effects);
                        }
                    }
                }
            }
        }
    }
    let lights = fixtures::lights(17, 3, &mut numbers);
    let materials = fixtures::materials(order, 3, &mut numbers);
    let high = fixtures::scene(lights, materials);
    compare("17", &fixtures::table(&high), &high.lights, &high.materials, Effects::ALL);
}

#[test]
fn general_bases() {
    let mut numbers = Numbers(9);
    let lights = fixtures::lights(4, 5, &mut numbers);
    let materials = fixtures::materials(4, 4, &mut numbers);
    let whole = fixtures::scene(lights, materials);
    let normals = (0..60).map(|_| (numbers.normal(), 1.0 + 0.5 * numbers.next()));
    let listed = listed(normals.collect::<Vec<_>>());
    for standard in [false, true] {
        for modes in [0, 300] {
            let mut loaded = whole.clone();
            if standard {
                loaded = fixtures::standard(loaded);
            }
            loaded.scene.basis.modes = modes;
            let table = pictures::table(&loaded, &listed);
            assert!(table.general.is_some());
            for effects in [Effects::ALL, Effects::ALL.without(Effect::Ambient)] {
                let what = format!("general {standard} {modes} {effects:?}");
                compare(&what, &table, &loaded.lights, &loaded.materials, effects);
            }
        }
    }
}

#[test]
fn windows() {
    for degree in [2, 9, 12, 17] {
        for k in 0..12 {
            // The k-th window suffices.
            let (mut ours, mut theirs) = (0, 0);
            let next = |count: &mut usize| {
                *count += 1;
                if *count > k { 0.0 } else { *count as f64 - 20.0 }
            };
            let window = Window::weakest(degree, |_| next(&mut ours));
            let expected = OfRuntime::<f64>::weakest(degree, |_| next(&mut theirs));
            assert_eq!(ours, theirs);
            for l in 0..20 {
                let apart = window.factor(l) - expected.factor::<Libm>(l);
                assert!(apart.abs() <= EQUAL, "{window:?} {expected:?} {l}");
            }
            let mut light: Vec<f64> = (0..light::count(degree)).map(|k| 1.0 + k as f64).collect();
            let mut other = light.clone();
            window.apply(&mut light);
            expected.apply::<Libm>(&mut other);
            assert!(largest_difference(&light, &other) <= EQUAL * largest(other));
        }
    }
}

#[test]
fn sources_and_highlights() {
    let sets = shipped::sources().expect("shipped");
    let sources: Vec<Source> = sets.iter().flat_map(|sets| sets.of_most(16).to_vec()).collect();
    let glosses = shipped::glosses().expect("shipped");
    let of_dielectric = Gloss {
        roughness: 0.0,
        reflectance: [0.04; 3],
        grazing: [1.0, 0.5, 0.0],
        albedo: [0.5, 0.2, 0.1],
    };
    let glosses: Vec<Gloss> =
        glosses.iter().map(|named| named.gloss).step_by(9).chain([of_dielectric]).collect();
    let mut normals = fixtures::disc(60);
    normals.extend(fixtures::normals(&SLANTS, 12));
    let errors = shipped::set_errors().expect("shipped");
    let mut most = [0.0_f64; 3];
    let far = [0.3, 1.0, 2.0, 3.0, 3.14159].map(|angle: f64| Source {
        direction: [0.6 * angle.sin(), 0.8 * angle.sin(), angle.cos()],
        energy: [1.0, 2.0, 0.0],
        major: [0.4 * angle.cos(), 0.1, -0.3 * angle.sin()],
        minor: 0.1,
    });
    let back = Source { direction: [0.0, 0.0, -1.0], ..far[0] };
    for source in sources.iter().step_by(5).chain(&far).chain([&back]) {
        let of_runtime = of_shading::source::<f64>(source).expect("a source");
        let expected = of_shading::harmonics::<f64>(source, 12).expect("room");
        let found = highlights::harmonics(source, 12);
        most[0] = most[0].max(largest_difference(&found, &expected));
        for gloss in &glosses {
            let runtime = of_shading::gloss::<f64>(gloss).expect("a gloss");
            assert_eq!(gloss.needs_sources(), runtime.needs_sources());
            let expected = eigenshade::Highlights::<f64, 1>::new::<Libm>(&runtime, &[of_runtime]);
            let expected = expected.expect("room");
            let found = Highlights::new(gloss, &[*source]);
            let pixel = |&[x, y, z]: &[f64; 3]| {
                let Rgb { r, g, b } = expected.shade(Normal::new(x, y, z).expect("visible"));
                [r, g, b]
            };
            let expected: Vec<f64> = normals.iter().flat_map(pixel).collect();
            let found: Vec<f64> = normals.iter().flat_map(|&at| found.irradiance(at)).collect();
            let apart = largest_difference(&found, &expected) / largest(expected.clone()).max(1e-9);
            most[1] = most[1].max(apart);
        }
    }
    for set in &errors {
        for gloss in &glosses {
            let runtime = of_shading::gloss::<f64>(gloss).expect("a gloss");
            let error = SourceSet::new(&[], set.errors.map(|error| error.mean)).error(&runtime);
            most[2] = most[2].max((set.of(gloss).mean - error).abs());
        }
    }
    println!("harmonics {:e}, of the peak {:e}, errors {:e}", most[0], most[1], most[2]);
    assert!(most.iter().all(|error| *error <= EQUAL), "{most:?}");
}

//! The host's own evaluation of tables, windows, sources and highlights in f64 against the
//! runtime's in f64.

use eigenshade::{Effect, Effects, Light, Material, Rgb, SourceSet, Window as OfRuntime};
use eigenshade_index::light;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::source::{Gloss, Source};
use eigenshade_model::window::Window;
use eigenshade_shading::shader::fitted;
use eigenshade_shading::shipped;
use eigenshade_table::Table;
use eigenshade_table::reduce::fingerprint;
use eigenshade_table::scene::Store;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_testing::fixtures::{self, SLANTS, normal, shipped_table};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::pictures::{self, listed};
use eigenshade_testing::{largest, largest_difference};

/// Of the peak.
const EQUAL: f64 = 1e-12;

/// d and an image by the runtime, from the collapsed polynomials and component by component.
fn by_runtime(
    owned: &OwnedBasis<f64>,
    (components, effects): (usize, Effects),
    [light, material]: [&[f64]; 2],
    normals: &[[f64; 3]],
) -> [Vec<f64>; 3] {
    let (basis, general) = (owned.basis(), owned.general());
    let mean = general.map_or(basis.parts().mean_coefficients, |one| one.parts().image_mean);
    let length = general.map_or(basis.workspace_len(), |general| general.workspace_len());
    let mut workspace = vec![0.0; length];
    let mut d = vec![0.0; general.map_or(basis.components(), |general| general.components())];
    let fingerprint = fingerprint(material);
    let light = Light::new(light).expect("coefficients");
    let on = Material::new(material).expect("coefficients");
    match (general, owned.transfers.iter().find(|one| one.0 == fingerprint)) {
        (Some(general), _) => {
            general.project_effects_into(&light, &on, effects, &mut workspace, &mut d)
        }
        (None, Some((_, transfer))) => basis.relight_into(transfer, &light, &mut d),
        (None, None) => basis.project_effects_into(&light, &on, effects, &mut workspace, &mut d),
    }
    .expect("it fits");
    d.truncate(components);
    let mut images = |d: &[f64]| {
        let room = vec![0.0; basis.scene_len()];
        let scene = match general {
            Some(general) => general.collapse_into(d, &mut workspace, room),
            None => basis.collapse_into(d, room),
        };
        let scene = scene.expect("sizes");
        let shaded = normals.iter().map(|&at| scene.shade(normal(at))).collect();
        let mut one = |&at: &[f64; 3]| match general {
            Some(general) => general.reconstruct(d, normal(at), &mut workspace),
            None => basis.reconstruct(d, normal(at)),
        };
        [shaded, normals.iter().map(|at| one(at).expect("sizes")).collect::<Vec<f64>>()]
    };
    let [mut shaded, mut summed] = images(&d);
    // The mean image is ambient.
    if !effects.has(Effect::Ambient) {
        let dark: Vec<f64> = mean.iter().take(components).map(|d| -d).collect();
        let [of_shaded, of_summed] = images(&dark);
        shaded.iter_mut().zip(of_shaded).for_each(|(value, dark)| *value -= dark);
        summed.iter_mut().zip(of_summed).for_each(|(value, dark)| *value -= dark);
        d.iter_mut().zip(mean).for_each(|(d, mean)| *d += mean);
    }
    [d, shaded, summed]
}

/// Compares d and images of some lights on some materials.
fn compare(what: &str, table: &Table, lights: &Lights, materials: &Materials, effects: Effects) {
    let (lights, materials) = fitted(table, lights, materials);
    let owned = OwnedBasis::new(table);
    let normals = fixtures::normals(&SLANTS, 7);
    let mut most = [0.0_f64; 3];
    for components in [table.count(), table.count().div_ceil(3)] {
        let evaluator = Evaluator::new(table).with_components(components);
        let evaluator = evaluator.with_effects(effects).expect("effects");
        let eigenimages = evaluator.eigenimages(&normals);
        for k in 0..8 {
            let light = &lights.entries[5 * k % lights.entries.len()].rgb[k % 3];
            let material = &materials.entries[7 * k % materials.entries.len()].rgb[k % 3];
            let d = evaluator.project(light, material).expect("a known material");
            let image = eigenimages.reconstruct(&d);
            let expected = by_runtime(&owned, (components, effects), [light, material], &normals);
            for ((found, expected), most) in
                [&d, &image, &image].into_iter().zip(expected).zip(&mut most)
            {
                let apart = largest_difference(found, &expected);
                *most = most.max(apart / largest(expected));
            }
        }
    }
    println!("{what}, {} components: {most:?}", table.count());
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
                let apart = window.factor(l) - expected.factor(l);
                assert!(apart.abs() <= EQUAL, "{window:?} {expected:?} {l}");
            }
            let mut light: Vec<f64> = (0..light::count(degree)).map(|k| 1.0 + k as f64).collect();
            let mut other = light.clone();
            window.apply(&mut light);
            expected.apply(&mut other);
            assert!(largest_difference(&light, &other) <= EQUAL * largest(other));
        }
    }
}

fn gloss_of_runtime(gloss: &Gloss) -> eigenshade::Gloss<f64> {
    let runtime = eigenshade::Gloss::new(gloss.roughness, gloss.reflectance, gloss.albedo);
    runtime.and_then(|runtime| runtime.with_grazing(gloss.grazing)).expect("a gloss")
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
        let &Source { direction, energy, major, minor } = source;
        let of_runtime = eigenshade::Source::new(direction, energy, major, minor);
        let of_runtime = of_runtime.expect("a source");
        let expected = of_runtime.harmonics::<169>(12).expect("room");
        let found = highlights::harmonics(source, 12);
        most[0] = most[0].max(largest_difference(&found, &expected));
        for gloss in &glosses {
            let runtime = gloss_of_runtime(gloss);
            assert_eq!(gloss.needs_sources(), runtime.needs_sources());
            let expected = eigenshade::Highlights::<f64, 1>::new(&runtime, &[of_runtime]);
            let expected = expected.expect("room");
            let found = Highlights::new(gloss, &[*source]);
            let pixel = |&at: &[f64; 3]| {
                let Rgb { r, g, b } = expected.shade(normal(at));
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
            let runtime = gloss_of_runtime(gloss);
            let error = SourceSet::new(&[], set.errors.map(|error| error.mean)).error(&runtime);
            most[2] = most[2].max((set.of(gloss).mean - error).abs());
        }
    }
    println!("harmonics {:e}, of the peak {:e}, errors {:e}", most[0], most[1], most[2]);
    assert!(most.iter().all(|error| *error <= EQUAL), "{most:?}");
}

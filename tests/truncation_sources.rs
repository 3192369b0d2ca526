//! Sources and terms chosen together: the choice against all others, and its corner cases. The
//! experiments compare the error with direct integration.

use eigenshade::index::highlights::PRODUCTS;
use eigenshade::mathematics::SinglePrecision;
use eigenshade::presets::{light, sources};
use eigenshade::{
    Argument, Buffer, Error, Gloss, GlossyScenes, Light, Material, Normal, Rgb, Source, SourceSet,
    Tolerance, Truncation, sphere,
};
use std::cell::Cell;

/// Rounding of f32 in irradiances and errors, relative to the peak.
const ROUNDING: f32 = 2e-6;

type Metal = Rgb<Buffer<f32, 40>>;

/// The coefficients of a light without some sources.
fn projected(
    light: Rgb<Light<'_, f32>>,
    metal: &Metal,
    taken: &[Source<f32>],
) -> Result<Rgb<sphere::Coefficients>, Error> {
    let rest = light.residual::<SinglePrecision, { sphere::LIGHT }>(taken)?;
    let channels = rest.lights()?.zip(metal.materials()?);
    channels.try_map(|(light, material)| sphere::project(&light, &material))
}

/// The error of a set and the table; if it is within the tolerance, also the number of products and
/// the total error.
fn tried(
    light: Rgb<Light<'_, f32>>,
    metal: &Metal,
    set: &SourceSet<'_, f32>,
    (gloss, share): (&Gloss<f32>, f32),
) -> (f32, Option<(usize, f32)>) {
    let (mut lengths, mut buffer) = ([0; sphere::DEGREE + 1], [0.0; 3 * sphere::SCENE]);
    let mut reports = [Truncation::default(); 3];
    let of = |set: &[_]| <[_; 3]>::from(projected(light, metal, set).unwrap());
    let mut collapse = |images: &[_; 3], tolerance| {
        let shape = sphere::BASIS
            .collapse_set_within(images, 3, tolerance, &mut lengths, &mut buffer, &mut reports)
            .unwrap();
        (shape.terms(), reports)
    };
    let mean = |squares: [f32; 3]| squares.iter().sum::<f32>() / 3.0;
    let peak = collapse(&of(&[]), Tolerance::OfPeak(0.5)).1[0].peak;
    let images = of(set.sources());
    let (_, alone) = collapse(&images, Tolerance::OfPeak(share));
    let floors = alone.map(|report| report.floor);
    let error = set.error(gloss).powi(2) + mean(floors.map(|floor| (floor / peak).powi(2)));
    let rest = share * share - error;
    let found = (rest > 1e-4 * share * share).then(|| {
        let of_all = rest.sqrt() * peak;
        let is_less = of_all < share * alone[0].peak;
        let tolerance =
            if is_less { Tolerance::Irradiance(of_all) } else { Tolerance::OfPeak(share) };
        let (terms, reports) = collapse(&images, tolerance);
        let of_terms = mean(reports.map(|report| (report.bound / peak).powi(2)));
        (3 * terms + PRODUCTS * set.sources().len(), (error + of_terms).sqrt())
    });
    (error.sqrt(), found)
}

fn metal(roughness: f32) -> (Metal, Gloss<f32>) {
    let color = [0.9, 0.7, 0.4];
    let metal = Material::metallic_roughness(color, 1.0, roughness).unwrap();
    (metal, Gloss::metallic_roughness(color, 1.0, roughness).unwrap())
}

/// Chooses for some sets of a light, and hands over what was chosen.
fn chosen<T>(
    light: Rgb<Light<'_, f32>>,
    sets: &[SourceSet<'_, f32>],
    (metal, gloss): &(Metal, Gloss<f32>),
    tolerance: Tolerance<f32>,
    look: impl FnOnce(Result<GlossyScenes<'_, '_, '_, f32>, Error>) -> T,
) -> T {
    let (mut lengths, mut buffer) = ([0; sphere::DEGREE + 1], [0.0; 3 * sphere::SCENE]);
    let project = |taken: &[_]| projected(light, metal, taken);
    let (lengths, buffer) = (&mut lengths[..], &mut buffer[..]);
    look(sphere::BASIS.collapse_sources_within(sets, gloss, tolerance, project, lengths, buffer))
}

#[test]
fn no_other_set_takes_fewer_products() {
    let mut by_count = [0; 17];
    for (name, sets) in sources::SETS {
        let (_, light) = light::ALL.into_iter().find(|(other, _)| *other == name).unwrap();
        for roughness in [0.2, 0.3, 0.45, 0.8] {
            let metal = metal(roughness);
            let usable = if metal.1.needs_sources() { sets } else { &sets[..1] };
            for share in [0.1, 0.03, 0.01, 0.003] {
                let of = |set| (set, tried(light, &metal.0, set, (&metal.1, share)));
                let all: Vec<_> = usable.iter().map(of).collect();
                let within = all.iter().filter_map(|(set, (_, found))| Some((set, (*found)?)));
                let best = within.min_by_key(|(_, (products, _))| *products);
                chosen(light, sets, &metal, Tolerance::OfPeak(share), |chosen| {
                    let chosen = chosen.unwrap();
                    by_count[chosen.sources.len()] += 1;
                    let products = 3 * chosen.shape.terms() + PRODUCTS * chosen.sources.len();
                    if let Some((set, (expected, error))) = best {
                        assert_eq!(products, expected, "{name}, {roughness}, {share}");
                        assert_eq!(chosen.sources, set.sources());
                        assert!((chosen.error - error).abs() <= ROUNDING);
                        assert!(chosen.error <= share * (1.0 + ROUNDING) && chosen.is_within);
                        return;
                    }
                    let nearest = all.iter().min_by(|(_, (a, _)), (_, (b, _))| a.total_cmp(b));
                    let (set, (least, _)) = nearest.unwrap();
                    assert_eq!(chosen.sources, set.sources(), "{name}, {roughness}, {share}");
                    assert!(chosen.error >= *least && chosen.error > share * 0.99);
                    assert!(!chosen.is_within);
                });
            }
        }
    }
    // All sizes are worth it somewhere.
    assert!([0, 1, 2, 4, 8, 16].iter().all(|&count| by_count[count] > 0), "{by_count:?}");
}

/// The scenes are those of the light without the sources, in the shape and within the bounds.
#[test]
fn scenes_are_those_of_the_rest_of_the_light() {
    let metal = metal(0.3);
    chosen(light::STUDIO, &sources::STUDIO, &metal, Tolerance::OfPeak(0.02), |chosen| {
        let chosen = chosen.unwrap();
        assert!(!chosen.sources.is_empty() && chosen.shape.terms() < sphere::SCENE);
        let d = projected(light::STUDIO, &metal.0, chosen.sources).unwrap();
        let channels = <[_; 3]>::from(chosen.scenes.zip(chosen.reports).zip(d));
        for ((scene, report), d) in channels {
            assert_eq!(report.terms, chosen.shape.terms());
            // Within the tolerance without the sources, too.
            assert!(report.bound <= 0.02 * report.peak && report.peak < chosen.peak);
            let room = [0.0; sphere::SCENE];
            let (again, of_again) = sphere::BASIS.collapse_as(&d, chosen.shape, room).unwrap();
            assert!((of_again.bound - report.bound).abs() <= ROUNDING * report.peak);
            for [x, y, z] in [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [-0.48, 0.64, 0.6]] {
                let normal = Normal::new(x, y, z).unwrap();
                let apart = (again.shade(normal) - scene.shade(normal)).abs();
                assert!(apart <= ROUNDING * report.peak, "{apart}");
            }
        }
    });
}

#[test]
fn bad_input_is_refused() {
    let metal = metal(0.3);
    let refused = |sets: &[_], tolerance| {
        chosen(light::STUDIO, sets, &metal, tolerance, |chosen| chosen.map(drop).unwrap_err())
    };
    let none = Error::Length { argument: Argument::Sources, expected: 1, found: 0 };
    assert_eq!(refused(&[], Tolerance::OfPeak(0.1)), none);
    for share in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        assert_eq!(refused(&sources::STUDIO, Tolerance::OfPeak(share)), Error::Tolerance);
    }
    assert_eq!(refused(&sources::STUDIO, Tolerance::Irradiance(0.1)), Error::Tolerance);
    // A set without a known error does not hide the others.
    let sets = [SourceSet::new(&[], [f32::NAN; 6]), sources::STUDIO[2]];
    chosen(light::STUDIO, &sets, &metal, Tolerance::OfPeak(0.001), |chosen| {
        assert_eq!(chosen.unwrap().sources, sources::STUDIO[2].sources());
    });
    let project = |taken: &[_]| projected(light::STUDIO, &metal.0, taken);
    let collapse = |lengths: &mut [u16], buffer: &mut [f32]| {
        let (sets, tolerance) = (&sources::STUDIO, Tolerance::Decibels(40));
        let basis = sphere::BASIS;
        let found =
            basis.collapse_sources_within(sets, &metal.1, tolerance, project, lengths, buffer);
        found.map(drop)
    };
    let (mut lengths, mut buffer) = ([0; sphere::DEGREE + 1], [0.0; 3 * sphere::SCENE]);
    let (expected, found) = (buffer.len(), buffer.len() - 1);
    let short = Error::Length { argument: Argument::Scene, expected, found };
    assert_eq!(collapse(&mut lengths, &mut buffer[1..]), Err(short));
    let short = Error::Length { argument: Argument::Lengths, expected: 10, found: 9 };
    assert_eq!(collapse(&mut lengths[1..], &mut buffer), Err(short));
    assert_eq!(collapse(&mut lengths, &mut buffer), Ok(()));

    // The errors of the projection are handed on, whichever call has them.
    let calls = Cell::new(0);
    for last in 0..3 {
        calls.set(0);
        let failing = |taken: &[_]| {
            calls.set(calls.get() + 1);
            if calls.get() > last { Err(Error::Tolerance) } else { project(taken) }
        };
        let (sets, tolerance) = (&sources::STUDIO, Tolerance::Decibels(40));
        let found = sphere::BASIS.collapse_sources_within(
            sets,
            &metal.1,
            tolerance,
            failing,
            &mut lengths,
            &mut buffer,
        );
        assert_eq!(found.map(drop), Err(Error::Tolerance));
        assert_eq!(calls.get(), last + 1);
    }
}

/// Neither has a peak to which a tolerance could be relative.
#[test]
fn black_and_endless_light() {
    let metal = metal(0.3);
    let sets = [SourceSet::new(&[], [0.01; 6])];
    let black = Rgb::gray(Light::new(&[0.0; 4]).unwrap());
    chosen(black, &sets, &metal, Tolerance::OfPeak(0.1), |chosen| {
        let chosen = chosen.unwrap();
        assert_eq!((chosen.sources.len(), chosen.error), (0, 0.0));
        assert_eq!(chosen.scenes.r.shade(Normal::new(0.0, 0.0, 1.0).unwrap()), 0.0);
    });
    let endless = Rgb::gray(Light::new(&[3e38; 100]).unwrap());
    chosen(endless, &sets, &metal, Tolerance::OfPeak(0.1), |chosen| {
        let chosen = chosen.unwrap();
        assert!(chosen.sources.is_empty() && chosen.shape.terms() == sphere::SCENE);
    });
}

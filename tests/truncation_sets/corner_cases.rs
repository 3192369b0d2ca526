//! Sets that are black, empty, dim, bright, of wrong sizes, or not numbers.

use super::{Chosen, on, shipped};
use eigenshade::truncation::{Shape, Tolerance, Truncation};
use eigenshade::{Argument, Error, sphere};

#[test]
fn black_images_and_none_cost_nothing() {
    let black = sphere::Coefficients::from([0.0; sphere::COMPONENTS]);
    let (lights, materials) = shipped();
    let lit = on(&lights[0], &materials[0]);
    let tolerance = Tolerance::OfPeak(1e-2);
    for none in [&[][..], &[black.clone(), black.clone()]] {
        let chosen = Chosen::new(none, 1, tolerance);
        assert_eq!((chosen.components, chosen.lengths.len()), (0, 0));
    }
    let (both, alone) =
        (Chosen::new(&[black, lit.clone()], 1, tolerance), Chosen::new(&[lit], 1, tolerance));
    assert_eq!((both.components, both.lengths), (alone.components, alone.lengths));
    assert_eq!((both.reports[0].bound, both.reports[1]), (0.0, alone.reports[0]));
}

/// Coefficients times a number.
fn scaled(d: &sphere::Coefficients, scale: f32) -> sphere::Coefficients {
    sphere::Coefficients::from(std::array::from_fn(|k| scale * d[k]))
}

/// Squares of dim and bright images are out of range in f32; the choice is the same.
#[test]
fn exposure_changes_nothing() {
    let (lights, materials) = shipped();
    let set: Vec<_> = materials.iter().step_by(9).map(|one| on(&lights[3], one)).collect();
    let expected = Chosen::new(&set, 1, Tolerance::OfPeak(1e-2));
    for exponent in [-90, 90] {
        let scale = 2f32.powi(exponent);
        let exposed: Vec<_> = set.iter().map(|d| scaled(d, scale)).collect();
        let found = Chosen::new(&exposed, 1, Tolerance::OfPeak(1e-2));
        assert_eq!(
            (found.components, found.lengths),
            (expected.components, expected.lengths.clone())
        );
        for (found, expected) in found.reports.iter().zip(&expected.reports) {
            assert_eq!(found.bound, scale * expected.bound);
        }
    }
}

/// A tolerance far beyond a black image's unit takes nothing from the others.
#[test]
fn black_images_pay_for_any_irradiance() {
    let black = sphere::Coefficients::from([0.0; sphere::COMPONENTS]);
    let (lights, materials) = shipped();
    let lit = on(&lights[0], &materials[0]);
    for irradiance in [1e-2, 2.0] {
        let tolerance = Tolerance::Irradiance(irradiance);
        let alone = Chosen::new(std::slice::from_ref(&lit), 1, tolerance);
        for set in [[black.clone(), lit.clone()], [lit.clone(), black.clone()]] {
            assert_eq!(Chosen::new(&set, 1, tolerance).lengths, alone.lengths, "{irradiance}");
        }
    }
}

/// What each can pay for does not depend on who is asked first.
#[test]
fn the_order_of_images_changes_nothing() {
    let (lights, materials) = shipped();
    for light in &lights {
        let mut set: Vec<_> = materials.iter().step_by(7).map(|one| on(light, one)).collect();
        let one = Chosen::new(&set, 1, Tolerance::OfPeak(1e-2));
        set.reverse();
        let other = Chosen::new(&set, 1, Tolerance::OfPeak(1e-2));
        assert_eq!((one.components, one.lengths), (other.components, other.lengths));
    }
}

/// Of sin 4β none of the 41 normals shows anything.
#[test]
fn what_is_not_a_number_is_never_left_out() {
    for number in [f32::NAN, f32::INFINITY] {
        for index in 0..sphere::COMPONENTS {
            let mut d = sphere::Coefficients::from([1.0; sphere::COMPONENTS]);
            d[index] = number;
            let (mut lengths, mut room) = ([0; sphere::DEGREE + 1], [0.0; sphere::SCENE]);
            let found = sphere::BASIS
                .collapse_within(&d, Tolerance::OfPeak(1e-2), &mut lengths, &mut room[..])
                .expect("room");
            assert!(
                !found.1.bound.is_finite() || found.1.terms == sphere::SCENE,
                "{index}: {:?}",
                found.1
            );
        }
    }
}

#[test]
fn faults_are_named() {
    let set = [[1.0f32; sphere::COMPONENTS]; 4];
    let tried = |channels, lengths: usize, buffer: usize, report: usize| {
        let (mut lengths, mut buffer) = (vec![0; lengths], vec![0.0; buffer]);
        let mut report = vec![Truncation::default(); report];
        let tolerance = Tolerance::OfPeak(1e-2);
        let done = sphere::BASIS.collapse_set_within(
            &set,
            channels,
            tolerance,
            &mut lengths,
            &mut buffer,
            &mut report,
        );
        done.map(|_| ())
    };
    let (azimuths, room) = (sphere::BASIS.azimuths(), 4 * sphere::SCENE);
    assert_eq!(tried(1, azimuths, room, 4), Ok(()));
    assert_eq!(tried(2, azimuths, room, 4), Ok(()));
    let wrong = |what, expected, found| Err(Error::Length { argument: what, expected, found });
    assert_eq!(tried(3, azimuths, room, 4), wrong(Argument::Images, 6, 4));
    assert_eq!(tried(0, azimuths, room, 4), wrong(Argument::Images, 0, 4));
    assert_eq!(tried(1, azimuths, room, 3), wrong(Argument::Images, 4, 3));
    assert_eq!(tried(1, azimuths, room - 1, 4), wrong(Argument::Scene, room, room - 1));
    assert_eq!(tried(1, azimuths - 1, room, 4), wrong(Argument::Lengths, azimuths, azimuths - 1));
    let shaped = |lengths: &[u16]| {
        let shape = Shape { components: sphere::COMPONENTS, lengths };
        let made = sphere::BASIS.collapse_as(&set[0], shape, [0.0; sphere::SCENE]);
        made.map(|(_, report)| report.terms)
    };
    assert_eq!(shaped(&[3, 2, 1, 0]), Ok(9));
    assert_eq!(shaped(&[]), Ok(0));
    assert!(matches!(shaped(&[99]), Err(Error::Length { argument: Argument::Lengths, .. })));
    assert!(matches!(shaped(&[0; 16]), Err(Error::Length { argument: Argument::Lengths, .. })));
    let shape = Shape { components: sphere::COMPONENTS, lengths: &[3, 2, 1] };
    assert_eq!(shape.scene([0.0f32; 8]).map(|_| ()), wrong(Argument::Scene, 9, 8));
}

/// A number that is none is no peak of 0, nor is the peak of the channels beside it.
#[test]
fn images_that_are_not_finite_are_reported() {
    let good = [1.0f32; sphere::COMPONENTS];
    let mut bad = good;
    bad[3] = f32::NAN;
    let of = sphere::Coefficients::from;
    let apart = Chosen::new(&[good, bad].map(of), 1, Tolerance::OfPeak(1e-2));
    assert!(apart.reports[0].peak.is_finite() && apart.reports[1].peak.is_nan());
    let channels = Chosen::new(&[bad, good].map(of), 2, Tolerance::OfPeak(1e-2));
    assert!(channels.reports.iter().all(|report| report.peak.is_nan()));
    // Too bright to be shaded: nothing is left out of it.
    let bright = [f32::MAX; sphere::COMPONENTS];
    let whole = Chosen::new(&[good, bright].map(of), 2, Tolerance::OfPeak(1e-2));
    assert!(whole.reports.iter().all(|report| !report.peak.is_finite()));
    let kept = (whole.components, whole.shape().terms());
    assert_eq!(kept, (sphere::COMPONENTS, sphere::SCENE));
}

/// A dark channel of a bright color may be off by as much as the others.
#[test]
fn a_peak_is_of_all_channels() {
    let (lights, materials) = shipped();
    let bright = on(&lights[0], &materials[0]);
    let dark = scaled(&bright, 1e-3);
    let set = [bright.clone(), dark.clone(), dark.clone()];
    let color = Chosen::new(&set, 3, Tolerance::OfPeak(1e-2));
    let each = Chosen::new(&set, 1, Tolerance::OfPeak(1e-2));
    let peaks = |chosen: &Chosen| chosen.reports.iter().map(|one| one.peak).collect::<Vec<_>>();
    assert_eq!(peaks(&color), [peaks(&each)[0]; 3]);
    assert!(peaks(&each)[1] < 2e-3 * peaks(&each)[0]);
    // The bright channel decides: it is the set of itself.
    let alone = Chosen::new(&set[..1], 1, Tolerance::OfPeak(1e-2));
    assert_eq!(color.lengths, alone.lengths);
}

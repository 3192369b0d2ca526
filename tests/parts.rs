//! A basis whose parts contradict each other is refused.

use eigenshade::wire::Parts;
use eigenshade::{Argument, Basis, Error, Light, Material, q15, sphere};
use eigenshade_table::record::{Azimuth, NONE, Pass, ProfilePlace, Row, Run};

/// The shipped table's parts.
fn shipped() -> Parts<'static> {
    *sphere::BASIS.parts()
}

fn refused(parts: Parts<'_>) -> Error {
    Basis::new(parts).expect_err("contradicting parts")
}

fn refused_length(parts: Parts<'_>) -> Argument {
    match refused(parts) {
        Error::Length { argument, .. } => argument,
        other => panic!("{other}"),
    }
}

/// All but the last.
fn short<T>(items: &[T]) -> &[T] {
    items.split_last().expect("not empty").1
}

/// The same items, one of them another.
fn with<T: Copy>(items: &[T], at: usize, item: T) -> Vec<T> {
    let mut items = items.to_vec();
    items[at] = item;
    items
}

/// A profile with these components and rows of +m and -m.
fn place(azimuth: u16, [plus, minus]: [u16; 2], [plus_row, minus_row]: [Row; 2]) -> ProfilePlace {
    ProfilePlace { azimuth, plus, minus, plus_row, minus_row }
}

#[test]
fn lengths_are_checked() {
    let parts = shipped();
    assert!(Basis::new(parts).is_ok());
    for (wrong, expected) in [
        (Parts { lengths: short(parts.lengths), ..parts }, Argument::Lengths),
        (Parts { degree: 12, ..parts }, Argument::Lengths),
        (Parts { order: 12, ..parts }, Argument::Polar),
        (Parts { slots: short(parts.slots), ..parts }, Argument::Slots),
        (Parts { polar: short(parts.polar), ..parts }, Argument::Polar),
        (Parts { factors: short(parts.factors), ..parts }, Argument::Factors),
        (Parts { terms: short(parts.terms), ..parts }, Argument::Terms),
    ] {
        assert_eq!(refused_length(wrong), expected);
    }
    for (degree, order) in [(13, 7), (9, 13), (usize::MAX, usize::MAX)] {
        let high = Basis::new(Parts { degree, order, ..parts }).err();
        assert_eq!(high, Some(Error::High { degree, order }));
    }
}

/// A basis of transfers alone relights those, and takes in no material.
#[test]
fn a_basis_may_lack_what_projects() {
    let (whole, parts) = (sphere::BASIS, Parts { polar: &[], factors: &[], ..shipped() });
    let basis = Basis::new(parts).expect("both are left out");
    assert!(whole.projects() && !basis.projects());
    let (light, material) = ([1.0; 100], [1.0; 40]);
    let light = Light::new(&light).expect("100 coefficients");
    let material = Material::new(&material).expect("40 coefficients");
    let transfer = sphere::transfer(&material).expect("it fits");
    let mut d = [0.0; sphere::COMPONENTS];
    basis.relight_into(transfer.as_slice(), &light, &mut d).expect("sizes");
    let expected: sphere::Coefficients = whole.relight(&transfer, &light).expect("sizes");
    assert_eq!(expected.as_slice(), d);
    let mut workspace = vec![0.0; basis.workspace_len()];
    let refused = basis.project_into(&light, &material, &mut workspace, &mut d);
    assert_eq!(refused, Err(Error::TransfersOnly));
    let mut room = vec![0.0; basis.transfer_len()];
    let refused = basis.transfer_into(&material, &mut workspace, &mut room);
    assert_eq!(refused, Err(Error::TransfersOnly));
    // One of the two alone is a mistake.
    assert_eq!(refused_length(Parts { polar: &[], ..shipped() }), Argument::Polar);
    assert_eq!(refused_length(Parts { factors: &[], ..shipped() }), Argument::Factors);
}

#[test]
fn profiles_serve_the_components() {
    let parts = shipped();
    for components in [parts.components - 1, parts.components + 1] {
        assert_eq!(refused(Parts { components, ..parts }), Error::Parts);
    }
    let first = parts.profiles[0];
    let last = parts.profiles.len() - 1;
    let unsorted = with(parts.profiles, last, first);
    assert_eq!(refused(Parts { profiles: &unsorted, ..parts }), Error::Parts);
    let row = Row { start: 256, step: 24 };
    let beyond = with(parts.profiles, last, place(10, [42, 43], [row, row]));
    assert_eq!(refused(Parts { profiles: &beyond, ..parts }), Error::Parts);
}

/// Every position that a table states is checked, by moving it by one.
#[test]
fn positions_are_those_of_the_parts() {
    let parts = shipped();
    for (number, &place) in parts.azimuths.iter().enumerate() {
        let Azimuth { first, profiles, start, terms, rows } = place;
        for moved in [
            Azimuth { first: first + 1, ..place },
            Azimuth { profiles: profiles + 1, ..place },
            Azimuth { start: start + 1, ..place },
            Azimuth { terms: terms + 1, ..place },
            Azimuth { rows: rows + 1, ..place },
        ] {
            let azimuths = with(parts.azimuths, number, moved);
            assert_eq!(refused(Parts { azimuths: &azimuths, ..parts }), Error::Parts);
        }
    }
    for (number, &run) in parts.runs.iter().enumerate() {
        let Run { order, profiles, first, step, start } = run;
        for moved in [
            Run { order: order + 1, ..run },
            Run { profiles: profiles + 1, ..run },
            Run { profiles: 0, ..run },
            Run { first: first + 1, ..run },
            Run { step: step + 1, ..run },
            Run { start: start + 1, ..run },
        ] {
            let runs = with(parts.runs, number, moved);
            assert_eq!(refused(Parts { runs: &runs, ..parts }), Error::Parts, "{moved:?}");
        }
    }
    for (number, &pass) in parts.passes.iter().enumerate() {
        for moved in
            [Pass { start: pass.start + 1, ..pass }, Pass { slots: pass.slots + 1, ..pass }]
        {
            let passes = with(parts.passes, number, moved);
            assert_eq!(refused(Parts { passes: &passes, ..parts }), Error::Parts);
        }
    }
    assert_eq!(refused(Parts { azimuths: short(parts.azimuths), ..parts }), Error::Parts);
    assert_eq!(refused(Parts { runs: short(parts.runs), ..parts }), Error::Parts);
}

/// What `transfer` writes is what `relight` reads.
#[test]
fn rows_and_slots_agree() {
    let parts = shipped();
    for slot in 0..parts.slots.len() {
        let (found, other) = (parts.slots[slot], (slot + 1) % parts.slots.len());
        let mut slots = with(parts.slots, slot, if found == 7 { u16::MAX } else { 7 });
        assert_eq!(refused(Parts { slots: &slots, ..parts }), Error::Parts);
        slots.copy_from_slice(parts.slots);
        slots.swap(slot, other);
        assert!(slots == parts.slots || Basis::new(Parts { slots: &slots, ..parts }).is_err());
    }
    for (start, step) in [(260, 24), (257, 24), (255, 24), (0, 24), (568, 24), (256, 20), (256, 0)]
    {
        let row = Row { start, step };
        let moved = place(0, [0, NONE], [row, row]);
        let profiles = with(parts.profiles, 0, moved);
        assert_eq!(refused(Parts { profiles: &profiles, ..parts }), Error::Parts, "{row:?}");
    }
    let halves = place(0, [0, NONE], [256, 260].map(|start| Row { start, step: 24 }));
    let profiles = with(parts.profiles, 0, halves);
    assert_eq!(refused(Parts { profiles: &profiles, ..parts }), Error::Parts);
}

#[test]
fn passes_are_those_of_the_layout() {
    let parts = shipped();
    let of_two = [-7, -2, -16, 12, i16::MIN, i16::MAX].map(|first| (first, 2));
    for (first, profiles) in of_two.into_iter().chain([(-8, 0), (-8, 9)]) {
        let passes = with(parts.passes, 0, Pass { first, profiles, ..parts.passes[0] });
        assert_eq!(refused(Parts { passes: &passes, ..parts }), Error::Parts, "{first} {profiles}");
    }
}

/// Nothing but an azimuth's profiles says how long its polynomials are.
#[test]
fn an_azimuth_without_a_profile_has_no_terms() {
    let parts = shipped();
    let bare = parts.lengths.iter().rposition(|&length| length == 0).expect("of some components");
    let endless = with(parts.lengths, bare, u16::MAX);
    let error = |found| Error::Length { argument: Argument::Lengths, expected: 0, found };
    assert_eq!(refused(Parts { lengths: &endless, ..parts }), error(65_535));
    let parts = sphere::q15::BASIS.parts();
    let bare = parts.lengths.iter().rposition(|&length| length == 0).expect("of some components");
    let endless = with(parts.lengths, bare, u8::MAX);
    let refused = q15::Basis::new(q15::Parts { lengths: &endless, ..*parts });
    assert_eq!(refused.err(), Some(error(255)));
}

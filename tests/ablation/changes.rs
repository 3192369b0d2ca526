//! What each change redoes with the shipped table, in multiplications.

use eigenshade::index::light;
use eigenshade_cli::shipped;
use eigenshade_table::parts::NONE;
use eigenshade_table::{Parts, decode};

/// Multiplications of each step, of the shipped table's 50 components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Multiplications {
    /// A light on a folded material: one for each number of a transfer that is not padding.
    pub relight: usize,
    /// Components to polynomials: one for each term of each component.
    pub collapse: usize,
    /// A material: polar integrals, then factors, padding apart.
    pub transfer: usize,
    /// Elements of the rotation matrices.
    pub turn: usize,
    /// A pixel: terms, and four for each azimuth's cosine and sine, two for its sum.
    pub pixel: usize,
}

/// Those of the shipped table.
pub fn multiplications() -> Multiplications {
    let parts = Parts::new(&decode(shipped::TABLE).expect("the shipped table"));
    let (degree, order) = (parts.degree, parts.order);
    let mut all = Multiplications { relight: 0, collapse: 0, transfer: 0, turn: 0, pixel: 0 };
    let pairs: usize = (0..=order).map(|q| (order - q) / 2 + 1).sum();
    for place in &parts.profiles {
        let azimuth = usize::from(place.azimuth);
        let signs = [place.plus, place.minus].iter().filter(|&&index| index != NONE).count();
        all.relight += signs * (degree + 1 - azimuth);
        all.collapse += signs * usize::from(parts.lengths[azimuth]);
        all.transfer += (degree + 1 - azimuth) * pairs;
    }
    for q in 0..=order {
        all.transfer += ((order - q) / 2 + 1).pow(2) * (degree + 1 - q);
    }
    all.turn = (1..=degree).map(|l| (2 * l + 1).pow(2)).sum();
    for (azimuth, &length) in parts.lengths.iter().enumerate().filter(|(_, length)| **length > 0) {
        all.pixel += usize::from(length) * if azimuth == 0 { 1 } else { 2 };
        all.pixel += if azimuth == 0 { 0 } else { 6 };
    }
    debug_assert_eq!(light::count(degree), 100);
    all
}

//! The number of multiplications in the runtime's steps for a table.

use eigenshade_index::layout;
use eigenshade_index::record::{NONE, ProfilePlace};
use eigenshade_model::error::Result;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::fault;
use eigenshade_table::{Table, parts};
use eigenshade_testing::images::products;

/// Multiplications of each step for one channel, including those by padding zeros.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Multiplications {
    /// A light on a transferred material: one for each number of a transfer.
    pub relight: usize,
    /// From components to polynomials: one for each term of each component.
    pub collapse: usize,
    /// A material: polar integrals, then factors.
    pub transfer: usize,
    /// Turning a light: one for each element of the matrices that exchange y and z, twice, and four
    /// for each pair of orders in each of four rotations about z.
    pub turn: usize,
    /// A pixel: the multiply-adds of `docs/performance.md`, by Horner's rule.
    pub pixel: usize,
}

impl Multiplications {
    /// The multiplications for a table.
    pub fn of(table: &Table) -> Result<Self> {
        let parts = parts::floats(table);
        let (degree, order) = (parts.degree, parts.order);
        let of_profile = |place: &ProfilePlace| {
            let signs = [place.plus, place.minus].iter().filter(|&&index| index != NONE).count();
            signs * usize::from(parts.lengths[usize::from(place.azimuth)])
        };
        let along = layout::LANES * layout::groups(degree);
        let polar: usize = (0..=order).map(|q| ((order - q) / 2 + 1).pow(2) * along).sum();
        let turn = |l: usize| {
            let (even, odd) = (l / 2, l.div_ceil(2));
            let elements = (even + 1).pow(2) + even.pow(2) + 2 * odd.pow(2);
            2 * elements + 16 * l
        };
        let owned = OwnedBasis::new(table);
        Ok(Self {
            relight: owned.basis().map_err(fault)?.transfer_len(),
            collapse: parts.profiles.iter().map(of_profile).sum(),
            transfer: polar + parts.factors.len(),
            turn: (1..=degree).map(turn).sum(),
            pixel: pixel(&parts.lengths),
        })
    }
}

/// Multiply-adds of a pixel with polynomials of these lengths, up to the last that is not empty.
fn pixel(lengths: &[u16]) -> usize {
    let used = lengths.iter().rposition(|&length| length > 0).map_or(0, |last| last + 1);
    products(&lengths[..used])
}

#[cfg(test)]
mod tests {
    use super::pixel;

    #[test]
    fn pixels_are_those_of_the_page_of_performance() {
        assert_eq!(pixel(&[14, 14, 13, 12, 12, 13, 12, 0, 0, 0]), 176);
        assert_eq!(pixel(&[3, 2, 1]), 11);
        assert_eq!(pixel(&[3, 2]), 7);
        assert_eq!((pixel(&[1]), pixel(&[])), (0, 0));
    }
}

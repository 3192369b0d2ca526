//! Irradiance modes E_lop^mq of (14), azimuth by azimuth.
//!
//! The modes of one azimuth |m| are sorted by l = |m|..=degree, and within one l as in
//! [`material`], restricted to q <= l. +m and -m share one list: E_lop^{-m,q} has (-1)^m times the
//! slant profile.

use crate::material;

/// All (l, o, p, q) of `azimuth` |m| up to `degree` and `order`.
pub fn indices(
    degree: usize,
    order: usize,
    azimuth: usize,
) -> impl Iterator<Item = (usize, usize, usize, usize)> {
    (azimuth..=degree).flat_map(move |l| {
        material::indices(order).filter(move |&(_, _, q)| q <= l).map(move |(o, p, q)| (l, o, p, q))
    })
}

/// Number of modes of `azimuth` |m|, counting one sign of m.
#[must_use]
pub fn count(degree: usize, order: usize, azimuth: usize) -> usize {
    indices(degree, order, azimuth).count()
}

/// Number of all modes, counting both signs of m.
#[must_use]
pub fn total(degree: usize, order: usize) -> usize {
    let of = |azimuth| count(degree, order, azimuth);
    of(0) + 2 * (1..=degree).map(of).sum::<usize>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn totals_are_the_papers() {
        assert_eq!(total(2, 0), 9);
        assert_eq!(total(5, 4), 464);
        assert_eq!(total(7, 7), 2264);
        assert_eq!(total(9, 7), 3704);
    }
}

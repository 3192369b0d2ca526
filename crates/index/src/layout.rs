//! Layout of the runtime's rows: numbers over l stand in groups of [`LANES`],
//! zero-padded, so that a compiler can take a group at a time.
//!
//! A row of azimuth |m| starts at l = |m| and holds [`groups`] groups.

/// Numbers in one group.
pub const LANES: usize = 4;

/// Groups in a row over l = azimuth..=degree. Domain: azimuth <= degree.
#[inline]
#[must_use]
pub const fn groups(degree: usize, azimuth: usize) -> usize {
    degree.saturating_sub(azimuth) / LANES + 1
}

/// Length of a row over l = 0..=degree from which the row of every azimuth can be
/// read in whole groups.
#[inline]
#[must_use]
pub const fn stride(degree: usize) -> usize {
    (degree + LANES).next_multiple_of(LANES)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_azimuth_reads_within_the_stride() {
        for degree in 0..70 {
            for azimuth in 0..=degree {
                let end = azimuth + LANES * groups(degree, azimuth);
                assert!(end > degree && end <= stride(degree));
            }
        }
    }
}

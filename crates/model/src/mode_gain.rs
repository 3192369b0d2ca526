//! The gain K_lop^q of (13) without its factor N_l^q, which [`crate::polar_integral`] combines with
//! C_lo^q.

/// K_lop^q / N_l^q = (-1)^q √((o+1)(p+1) / (2 (1 + δ_op))).
#[must_use]
pub fn gain(o: usize, p: usize, q: usize) -> f64 {
    let doubled = if o == p { 4.0 } else { 2.0 };
    let size = (((o + 1) * (p + 1)) as f64 / doubled).sqrt();
    if q.is_multiple_of(2) { size } else { -size }
}

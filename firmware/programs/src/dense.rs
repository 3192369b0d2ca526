//! A dense row of UᵀM times the mode coefficients in Q15, as a baseline: what a
//! library of matrix products does, without the structure of the basis.

/// Modes at degree 9 and order 7.
pub const MODES: usize = 3704;

/// One row's product, rounded to Q15: four products to a step in 64 bits, as CMSIS-DSP's
/// `arm_mat_vec_mult_q15` sums.
#[must_use]
#[inline]
pub fn row(row: &[i16; MODES], modes: &[i16; MODES]) -> i16 {
    let (rows, _) = row.as_chunks::<4>();
    let (modes, _) = modes.as_chunks::<4>();
    let mut sum = 0_i64;
    for ([a, b, c, d], [e, f, g, h]) in rows.iter().zip(modes) {
        let product = |a: i16, b: i16| i64::from(i32::from(a) * i32::from(b));
        sum += product(*a, *e) + product(*b, *f) + product(*c, *g) + product(*d, *h);
    }
    let rounded = (sum + (1 << 14)) >> 15;
    rounded.clamp(i64::from(i16::MIN), i64::from(i16::MAX)) as i16
}

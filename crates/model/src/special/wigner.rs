//! Wigner small d, the P_l^mn(cos α) of (45): the standard d^l_mn(α) with
//! d^1_10 = -sin(α)/√2. Notation follows (44)-(45).

/// d^l_mn(α) for l = max(|m|, |n|)..=degree.
///
/// Absolute error below 1e-13 up to degree 9, 5e-13 up to 64, for α in \[0, π\]. Empty if max(|m|,
/// |n|) > degree.
///
/// The recurrence in l starts from the closed form at l = max(|m|, |n|). The binomial coefficient
/// of the closed form is accumulated together with the powers of the half-angle functions, so that
/// neither overflows.
#[must_use]
pub fn column(degree: usize, m: isize, n: isize, alpha: f64) -> Vec<f64> {
    let lowest = m.unsigned_abs().max(n.unsigned_abs());
    let mut values = Vec::with_capacity((degree + 1).saturating_sub(lowest));
    if lowest > degree {
        return values;
    }
    let mut value = lowest_degree(m, n, alpha);
    values.push(value);
    let (z, mn) = (alpha.cos(), (m * n) as f64);
    let root = |l: f64| ((l * l - (m * m) as f64) * (l * l - (n * n) as f64)).sqrt();
    let mut before = 0.0;
    for l in lowest..degree {
        let l = l as f64;
        let next = if l == 0.0 {
            z * value
        } else {
            ((2.0 * l + 1.0) * (l * (l + 1.0) * z - mn) * value - (l + 1.0) * root(l) * before)
                / (l * root(l + 1.0))
        };
        (before, value) = (value, next);
        values.push(value);
    }
    values
}

/// d^l_mn(α) of one degree; 0 if |m| or |n| exceeds l.
#[must_use]
pub fn value(l: usize, m: isize, n: isize, alpha: f64) -> f64 {
    column(l, m, n, alpha).last().copied().unwrap_or(0.0)
}

/// d^l_mn for l = max(|m|, |n|): ±√C(2l, l+k) cos^(l+k)(α/2) sin^(l-k)(α/2).
fn lowest_degree(m: isize, n: isize, alpha: f64) -> f64 {
    // d_mn = (-1)^(m-n) d_nm = d_-n,-m: makes the larger index the first one, and positive.
    let (front, k, sign) = match (m.unsigned_abs() >= n.unsigned_abs(), m >= 0, n >= 0) {
        (true, true, _) => (m, n, parity(m - n)),
        (true, false, _) => (-m, -n, 1.0),
        (false, _, true) => (n, m, 1.0),
        (false, _, false) => (-n, -m, parity(m - n)),
    };
    let (sine, cosine) = (0.5 * alpha).sin_cos();
    let (more, fewer, large, small) = if k >= 0 {
        (front + k, front - k, cosine, sine)
    } else {
        (front - k, front + k, sine, cosine)
    };
    // C(2l, fewer) = Π (more + i) / i, with one power of each half-angle function per factor.
    let paired = (1..=fewer)
        .fold(1.0, |product, i| product * ((more + i) as f64 / i as f64).sqrt() * large * small);
    sign * paired * large.powi((more - fewer) as i32)
}

fn parity(k: isize) -> f64 {
    if k % 2 == 0 { 1.0 } else { -1.0 }
}

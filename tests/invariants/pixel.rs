//! A pixel in integers with room for everything, and the bounds that its steps keep.

use super::integer::Integer;
use eigenshade::quantised::Normal;

/// What `terms` give at a normal: every product and sum exact, rounded where the format
/// rounds.
///
/// # Panics
///
/// If a step or the irradiance leaves the format's bits.
pub fn exact<Q: Integer>(lengths: &[u8], terms: &[i32], normal: Normal<Q>) -> i128 {
    let bits = Q::BITS;
    let [x, y, z] = normal.components().map(Q::mantissa);
    let t = z - (1 << (bits - 1));
    let bounded = |value: i128| {
        assert!(value.abs() < 1 << Q::TERM_BITS, "a step of {value}");
        value
    };
    let mut terms = terms.iter().map(|&term| i128::from(term));
    let mut value = |length: usize| {
        let mut step = 0;
        for term in terms.by_ref().take(length) {
            step = bounded(((step * t) >> (bits - 1)) + term);
        }
        step
    };
    let mut lengths = lengths.iter().map(|&length| usize::from(length));
    let first = lengths.next().unwrap_or(0);
    let before_last = value(first.saturating_sub(1));
    let last = value(first.min(1));
    let mut sum = before_last * t + (last << (bits - 1));
    bounded(sum >> (bits - 1));
    let (mut cosine, mut sine) = ((x + 1) >> 1, (y + 1) >> 1);
    for length in lengths {
        for fraction in [cosine, sine] {
            let product = value(length) * fraction;
            assert!(product.abs() < 1 << (2 * bits + 1), "a product of {product}");
            sum += product;
        }
        let rounded = |number: i128| (number + (1 << (bits - 1))) >> bits;
        (cosine, sine) = (rounded(cosine * x - sine * y), rounded(cosine * y + sine * x));
    }
    bounded(((sum >> (bits - 2)) + 1) >> 1)
}

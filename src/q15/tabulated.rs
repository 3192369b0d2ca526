//! Roots, reciprocals and leading zeros of 32-bit integers by tables, for processors that have no
//! instructions for them.

/// The root of a number from 2^16 on, within 2e-4 of itself and a unit.
#[inline(always)]
pub(super) fn root(number: u32) -> u32 {
    let lead = leading(number);
    let number = number << (lead & 30);
    let [base, slope] = at(&ROOTS, number >> 26);
    let rest = (number >> 10) & 0xffff;
    (u32::from(base) + ((u32::from(slope) * rest) >> 16)) >> ((lead & 30) >> 1)
}

/// Roots of multiples of 2^26 from 2^30 on, and the differences to the next ones.
static ROOTS: [[u16; 2]; 64] = {
    let mut table = [[0; 2]; 64];
    let mut k = 16;
    while k < 64 {
        let (root, next) = (root_of(k), root_of(k + 1));
        #[expect(clippy::indexing_slicing, reason = "the index is below 64")]
        {
            table[k as usize] = [root as u16, (next - root) as u16];
        }
        k += 1;
    }
    table
};

/// The root of k 2^26, rounded.
const fn root_of(k: u64) -> u64 {
    ((k << 28).isqrt() + 1) >> 1
}

/// 2^43 / `divisor`, by one step of Newton's method, within 3e-4. Domain: from 2^28 to 2^31. Less
/// is possible where normal and source are both at the rim, and saturates.
#[inline(always)]
pub(super) fn reciprocal(divisor: u32) -> u32 {
    let guess = u32::from(RECIPROCALS.get((divisor >> 23) as usize & 255).copied().unwrap_or(0));
    let correction = (1_u32 << 29).wrapping_sub(guess.wrapping_mul(divisor >> 15)) >> 13;
    guess.wrapping_mul(correction) >> 15
}

/// Reciprocals of the middles of the intervals of 2^23.
static RECIPROCALS: [u16; 256] = {
    let mut table = [0; 256];
    let mut k = 0;
    while k < 256 {
        let reciprocal = ((1 << 21) + k) / (2 * k + 1);
        #[expect(clippy::indexing_slicing, reason = "the index is below 256")]
        {
            table[k] = if reciprocal > 0xffff { 0xffff } else { reciprocal as u16 };
        }
        k += 1;
    }
    table
};

/// The leading zeros of a number from 2^16 on, by a table: small processors have no instruction. It
/// is at most 16, which leaves less than 16 bits of smaller numbers.
#[inline(always)]
pub(super) fn leading(number: u32) -> u32 {
    let high = number >> 24;
    let of = |byte: u32| u32::from(LEADING.get(byte as usize & 255).copied().unwrap_or_default());
    if high == 0 { 8 + of(number >> 16) } else { of(high) }
}

static LEADING: [u8; 256] = {
    let mut table = [0; 256];
    let mut k = 0;
    while k < 256 {
        #[expect(clippy::indexing_slicing, reason = "the index is below 256")]
        {
            table[k] = (k as u8).leading_zeros() as u8;
        }
        k += 1;
    }
    table
};

/// The entry of a table, modulo its length.
#[inline(always)]
fn at<E: Copy + Default>(table: &[E; 64], place: u32) -> E {
    table.get((place & 63) as usize).copied().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::{leading, reciprocal, root};

    /// Numbers from 2^`from` to 2^`to`, about a thousand for each factor of two.
    fn numbers(from: u32, to: u32) -> impl Iterator<Item = u32> {
        (from..to).flat_map(|bits| {
            let step = ((1_u32 << bits) / 997).max(1);
            ((1 << bits)..(1_u64 << (bits + 1)) as u32).step_by(step as usize)
        })
    }

    #[test]
    fn approximations_are_as_near_as_stated() {
        for number in numbers(16, 31) {
            let exact = f64::from(number).sqrt();
            assert!((f64::from(root(number)) - exact).abs() <= 2e-4 * exact + 1.0, "{number}");
            assert_eq!(leading(number), number.leading_zeros(), "{number}");
        }
        for divisor in numbers(28, 31) {
            let exact = 43_f64.exp2() / f64::from(divisor);
            assert!((f64::from(reciprocal(divisor)) / exact - 1.0).abs() <= 3e-4, "{divisor}");
        }
    }
}

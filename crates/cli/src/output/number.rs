//! Numbers as text.

pub use eigenshade_model::inputs::rounding::exact;

/// A number of bytes with its digits in groups of three.
#[must_use]
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{exact, grouped};

    #[test]
    fn numbers_read_back() {
        for number in [0.0, -0.0, 1.0 / 3.0, 1e-300, -2.5e17, f64::from(0.1f32), 5e-324] {
            let back: f64 = exact(number).parse().unwrap();
            assert_eq!(back.to_bits(), number.to_bits());
        }
        assert_eq!(exact(1e-7), "1e-7");
        assert_eq!(exact(0.25), "0.25");
    }

    #[test]
    fn bytes_are_grouped() {
        let texts = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(texts, ["0", "999", "1,000", "1,234,567"]);
    }
}

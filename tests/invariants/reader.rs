//! Numbers from bytes; zeros where they end.

/// Bytes that are read one after the other.
pub struct Reader<'a> {
    rest: &'a [u8],
}

impl<'a> Reader<'a> {
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    /// Whether anything is left.
    pub fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub fn bytes<const N: usize>(&mut self) -> [u8; N] {
        let (now, rest) = self.rest.split_at(N.min(self.rest.len()));
        self.rest = rest;
        let mut bytes = [0; N];
        bytes[..now.len()].copy_from_slice(now);
        bytes
    }

    pub fn byte(&mut self) -> u8 {
        let [byte] = self.bytes();
        byte
    }

    pub fn i32(&mut self) -> i32 {
        i32::from_le_bytes(self.bytes())
    }

    /// A number of at most this, or this.
    pub fn up_to(&mut self, most: usize) -> usize {
        usize::from(self.byte()) % (most + 1)
    }

    /// A number of moderate size: 15 bits, times a power of two from 2^-40 to 2^7.
    pub fn moderate(&mut self) -> f32 {
        let [low, high, exponent] = self.bytes();
        let mantissa = f32::from(i16::from_le_bytes([low, high]));
        mantissa * 2f32.powi(i32::from(exponent) % 48 - 55)
    }
}

//! The checksum of a wire file.

/// The effect of four steps of a reflected CRC-32, for each low nibble.
const NIBBLES: [u32; 16] = {
    let (mut table, mut nibble) = ([0; 16], 0);
    let mut rest = table.as_mut_slice();
    while let [first, others @ ..] = rest {
        let (mut remainder, mut bits) = (nibble, 4);
        while bits > 0 {
            let odd = remainder & 1 == 1;
            remainder = (remainder >> 1) ^ if odd { 0xedb8_8320 } else { 0 };
            bits -= 1;
        }
        *first = remainder;
        (rest, nibble) = (others, nibble + 1);
    }
    table
};

/// The CRC-32 of ISO 3309, as in PNG and ZIP.
pub(super) fn checksum(bytes: &[u8]) -> u32 {
    let step = |sum: u32| {
        let nibble = NIBBLES.get((sum & 15) as usize).copied();
        (sum >> 4) ^ nibble.unwrap_or_default()
    };
    !bytes.iter().fold(u32::MAX, |sum, &byte| step(step(sum ^ u32::from(byte))))
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_standards_own_value() {
        assert_eq!(super::checksum(b"123456789"), 0xcbf4_3926);
        assert_eq!(super::checksum(b""), 0);
    }
}

//! The README's program in Q15. Its picture must have the checksum that the host's test asserts.
#![no_std]
#![no_main]

programs::program!();

include!("../../../tests/readme/gold_q15.rs");
include!("../../../tests/readme/checksum.rs");

fn readme() {
    let mut screen = [0; 240 * 240];
    let is_drawn = Target::new(&mut screen, 240).and_then(|mut target| draw(&mut target));
    if is_drawn.is_err() || crc32(screen.iter().flat_map(|pixel| pixel.to_le_bytes())) != CHECKSUM {
        board::exit(false);
    }
}

/// CRC-32, as in zlib and PNG.
fn crc32(bytes: impl Iterator<Item = u8>) -> u32 {
    let shifted = |crc: u32, _| (crc >> 1) ^ (0xedb8_8320 & 0_u32.wrapping_sub(crc & 1));
    !bytes.fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(byte), shifted))
}

//! The program in Q15 of the project's README, whose picture has the same bits as on the host.
#![no_std]
#![no_main]

use eigenshade::Tone;

programs::program!();

include!("../../../tests/readme/gold_q15.rs");
include!("../../../tests/readme/checksum.rs");

static DISPLAY: Display = Display::new(Tone::Filmic);

fn readme() {
    let mut screen = [0; 240 * 240];
    let is_drawn = draw(&mut screen, &DISPLAY).is_ok();
    if !is_drawn || crc32(screen.iter().flat_map(|pixel| pixel.to_le_bytes())) != CHECKSUM {
        board::exit(false);
    }
}

/// As zlib's and PNG's.
fn crc32(bytes: impl Iterator<Item = u8>) -> u32 {
    let shifted = |crc: u32, _| (crc >> 1) ^ (0xedb8_8320 & 0_u32.wrapping_sub(crc & 1));
    !bytes.fold(!0, |crc, byte| (0..8).fold(crc ^ u32::from(byte), shifted))
}

/// The CRC-32 of the pixels that `gold_q15.rs` draws, little-endian.
const CHECKSUM: u32 = 0xf1aa_62f3;

/// The CRC-32 of the pixels that `gold_q15.rs` draws, little-endian.
const CHECKSUM: u32 = 0xea25_faa8;

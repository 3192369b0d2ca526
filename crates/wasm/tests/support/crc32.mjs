// The CRC-32 of zlib, which Node 20 does not export.

/** Of an array's bytes, as they lie in memory. */
export function crc32(array) {
  let sum = 0xffffffff;
  for (const byte of new Uint8Array(array.buffer)) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return ~sum >>> 0;
}

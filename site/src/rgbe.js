// Radiance's .hdr: shared exponents, run lengths.

/** The chromaticities of sRGB: red, green, blue and white. */
const SRGB = [0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329];

/** What is to be said of a file whose colors have these chromaticities, which nothing converts. */
export const primariesNote = (/** @type {number[]} */ found) =>
  SRGB.every((value, k) => Math.abs(value - found[k]) < 1e-3) ? "" : " Its primaries are not those of sRGB, and are ignored.";

/**
 * Divides its COLORCORR out. The exposure that it states is ignored: that of a map is arbitrary.
 *
 * @param {ArrayBuffer} buffer
 * @returns {{ width: number, height: number, stride: number, data: Float32Array, note: string }}
 * @throws {Error} if it is no .hdr, is cut short or holds another orientation
 */
export function parseHdr(buffer) {
  const bytes = new Uint8Array(buffer);
  let at = 0;
  const line = () => {
    let text = "";
    while (at < bytes.length && bytes[at] !== 10) {
      text += String.fromCharCode(bytes[at++]);
      if (text.length > 4096) throw new Error("a line of the header has no end");
    }
    if (at++ >= bytes.length) throw new Error("it ends within its header");
    return text.trim();
  };
  if (!/^#\?/.test(line())) throw new Error("it does not start with #?RADIANCE");
  let [factors, note] = [[1, 1, 1], ""];
  for (let text = line(); text !== ""; text = line()) {
    const [, name, value = ""] = /^(FORMAT|COLORCORR|PRIMARIES)\s*=\s*(.*)$/i.exec(text)?.map((part) => part.trim()) ?? [];
    const numbers = value.split(/\s+/).map(Number);
    if (/FORMAT/i.test(name) && value !== "32-bit_rle_rgbe") throw new Error(`its format is ${value}, expected 32-bit_rle_rgbe`);
    if (/PRIMARIES/i.test(name)) note = primariesNote(numbers);
    if (/COLORCORR/i.test(name) && numbers.length === 3 && numbers.every((factor) => factor > 0)) {
      factors = factors.map((factor, c) => factor / numbers[c]);
    }
  }
  const size = line();
  const [, rows, columns] = /^-Y (\d+) \+X (\d+)$/.exec(size) ?? [];
  if (!rows) throw new Error(`its size is "${size}", expected "-Y rows +X columns"`);
  const [height, width] = [Number(rows), Number(columns)];
  if (!(width >= 1 && height >= 1 && width * height <= 2 ** 26)) throw new Error(`${width} x ${height} texels are too many`);
  const data = new Float32Array(3 * width * height);
  const scan = new Uint8Array(4 * width);
  const need = (/** @type {number} */ count) => {
    if (at + count > bytes.length) throw new Error("it ends within its pixels");
  };
  for (let y = 0; y < height; y++) {
    need(4);
    const packed = bytes[at] === 2 && bytes[at + 1] === 2 && ((bytes[at + 2] << 8) | bytes[at + 3]) === width;
    if (packed && width >= 8 && width < 32768) {
      at += 4;
      for (let part = 0; part < 4; part++) {
        for (let x = 0; x < width; ) {
          need(2);
          const code = bytes[at++];
          const count = code > 128 ? code - 128 : code;
          if (count === 0 || x + count > width) throw new Error(`row ${y} has a wrong run length`);
          need(code > 128 ? 1 : count);
          for (let k = 0; k < count; k++) scan[4 * x++ + part] = bytes[code > 128 ? at : at + k];
          at += code > 128 ? 1 : count;
        }
      }
    } else {
      need(4 * width);
      scan.set(bytes.subarray(at, at + 4 * width));
      at += 4 * width;
    }
    for (let x = 0; x < width; x++) {
      const exponent = scan[4 * x + 3];
      const scale = exponent ? 2 ** (exponent - 136) : 0;
      // Writers cut mantissas off, so a value is in the middle of its step, as Radiance reads it.
      for (let c = 0; c < 3; c++) data[3 * (y * width + x) + c] = (scan[4 * x + c] + 0.5) * scale * factors[c];
    }
  }
  return { width, height, stride: 3, data, note };
}

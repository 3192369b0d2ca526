// Files that tests drop.

/** A Radiance file: new run lengths, each as literals, and mantissas that are cut off. */
export function hdrFile(width, height, data) {
  const bytes = [...Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`)];
  for (let y = 0; y < height; y++) {
    const texels = Array.from({ length: width }, (_, x) => {
      const rgb = [0, 1, 2].map((c) => data[3 * (y * width + x) + c]);
      const exponent = Math.floor(Math.log2(Math.max(...rgb, 1e-30))) + 1;
      return [...rgb.map((value) => Math.min(255, Math.floor(value * 2 ** (8 - exponent)))), exponent + 128];
    });
    bytes.push(2, 2, width >> 8, width & 255);
    for (let part = 0; part < 4; part++) {
      // A run if all are equal, else literals.
      const line = texels.map((texel) => texel[part]);
      for (let x = 0; x < width; x += 64) {
        const chunk = line.slice(x, x + 64);
        if (chunk.every((value) => value === chunk[0])) bytes.push(128 + chunk.length, chunk[0]);
        else bytes.push(chunk.length, ...chunk);
      }
    }
  }
  return Buffer.from(bytes);
}

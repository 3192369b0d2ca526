// Files that tests drop, and the drop.

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

/** Where the places of an .exr's blocks start, and the first block, which `more` bytes moved. */
export function offsets(bytes, more) {
  let at = 8;
  while (bytes[at] !== 0) {
    for (let part = 0; part < 2; part++) at = bytes.indexOf(0, at) + 1;
    at += 4 + bytes.readUInt32LE(at);
  }
  return [at + 1, Number(bytes.readBigUInt64LE(at + 1)) + more];
}

/** Drops a file on the page. */
export const drop = (page, name, bytes) =>
  page.evaluate(async ([name, base64]) => {
    const transfer = new DataTransfer();
    const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    transfer.items.add(new File([data], name));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.getElementById("frame").dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }
  }, [name, Buffer.from(bytes).toString("base64")]);

// 256 colors of a picture.

/**
 * The colors of a picture, chosen by halving boxes of colors at the middle of their widest side, and a map
 * from a color, 65536 red + 256 green + blue, to its place among them.
 *
 * @param {Uint8Array} pixels red, green, blue and opacity; those of opacity 0 are left out
 */
export function quantized(pixels) {
  const counts = new Map();
  const keyOf = (at) => (pixels[at] << 16) | (pixels[at + 1] << 8) | pixels[at + 2];
  for (let at = 0; at < pixels.length; at += 4) if (pixels[at + 3]) counts.set(keyOf(at), (counts.get(keyOf(at)) ?? 0) + 1);
  const channel = (key, c) => (key >> (16 - 8 * c)) & 255;
  const boxOf = (keys) => {
    const spans = [0, 1, 2].map((c) => {
      const values = keys.map((key) => channel(key, c));
      return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
    });
    const widest = spans.indexOf(Math.max(...spans));
    const weight = keys.reduce((sum, key) => sum + counts.get(key), 0);
    return { keys, widest, rank: spans[widest] ** 2 * Math.sqrt(weight) };
  };
  const boxes = [boxOf([...counts.keys()])];
  while (boxes.length < 256) {
    boxes.sort((a, b) => a.rank - b.rank);
    const { keys, widest, rank } = boxes.pop();
    if (rank === 0) {
      boxes.push({ keys, widest, rank });
      break;
    }
    const values = keys.map((key) => channel(key, widest));
    const middle = (values.reduce((a, b) => Math.max(a, b)) + values.reduce((a, b) => Math.min(a, b))) / 2;
    boxes.push(boxOf(keys.filter((_, k) => values[k] <= middle)), boxOf(keys.filter((_, k) => values[k] > middle)));
  }
  const palette = Buffer.alloc(768);
  const index = new Map();
  boxes.forEach(({ keys }, place) => {
    const weight = keys.reduce((sum, key) => sum + counts.get(key), 0);
    for (let c = 0; c < 3; c++) {
      palette[3 * place + c] = Math.round(keys.reduce((sum, key) => sum + counts.get(key) * channel(key, c), 0) / weight);
    }
    keys.forEach((key) => index.set(key, place));
  });
  return { palette, index };
}

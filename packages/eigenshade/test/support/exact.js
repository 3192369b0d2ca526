// The picture of a sphere with every pixel shaded, in Node and in pages.

/** As `sphere`, from `Scene.pixels`. */
export function exact(scene, size, look) {
  const [axes, places] = [[[], [], []], []];
  const radius = Math.max(size - 1, 1) / 2;
  for (let at = 0; at < size * size; at++) {
    const across = ((at % size) + 0.5 - size / 2) / radius;
    const up = (size / 2 - Math.floor(at / size) - 0.5) / radius;
    const distance = Math.hypot(across, up);
    const coverage = Math.min(1, radius * (1 - distance) + 0.5);
    if (coverage <= 0) continue;
    const z = Math.sqrt(Math.max(0, 1 - distance ** 2));
    [across, up].forEach((along, k) => axes[k].push(along / Math.max(1, distance)));
    axes[2].push(z);
    places.push([4 * at, 255 * coverage]);
  }
  const pixels = scene.pixels(...axes.map((axis) => Float32Array.from(axis)), look);
  const picture = new Uint8ClampedArray(4 * size * size);
  places.forEach(([at, opacity], k) => {
    picture.set(pixels.subarray(4 * k, 4 * k + 3), at);
    picture[at + 3] = opacity;
  });
  return picture;
}

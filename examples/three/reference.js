// The irradiance of glTF materials by direct integration over a map's texels, in f64. It shares no
// code with eigenshade or three.js.

const { PI, SQRT1_2, cos, sin, sqrt, max } = Math;

/**
 * The texels of an equirectangular map as directions in the camera's frame and radiances times
 * solid angles. Rows are from the bottom, four numbers a texel, as three.js's EXRLoader gives them;
 * the middle of the map is -z.
 */
export function texels({ data, width, height }) {
  const all = { x: [], y: [], z: [], r: [], g: [], b: [] };
  for (let row = 0; row < height; row++) {
    const angle = (PI * (height - 1 - row + 0.5)) / height;
    // The exact solid angle: 2 π / width (cos top - cos bottom).
    const solid = ((2 * PI) / width) * 2 * sin(angle) * sin(PI / (2 * height));
    for (let column = 0; column < width; column++) {
      const turn = 2 * PI * ((column + 0.5) / width - 0.5);
      all.x.push(sin(turn) * sin(angle));
      all.y.push(cos(angle));
      all.z.push(-cos(turn) * sin(angle));
      const at = 4 * (row * width + column);
      ["r", "g", "b"].forEach((channel, k) => all[channel].push(solid * data[at + k]));
    }
  }
  return Object.fromEntries(Object.entries(all).map(([name, numbers]) => [name, Float64Array.from(numbers)]));
}

/**
 * The four integrals, in each channel, of which the irradiance of every glTF material of a
 * roughness is a sum: of cos θ_i times 1/π, k/π, D V and k D V, with k = (1 - cos θ_d)^5 of
 * Schlick's Fresnel term, D of Trowbridge and Reitz, and V of Smith, height-correlated. The view is
 * along z.
 */
export function integrals(map, [nx, ny, nz], roughness) {
  const square = roughness ** 4;
  const sums = new Float64Array(12);
  const masked = sqrt(square + (1 - square) * nz * nz);
  for (let k = 0; k < map.x.length; k++) {
    const incident = nx * map.x[k] + ny * map.y[k] + nz * map.z[k];
    if (incident <= 0) continue;
    // The half-way direction is (ω + z) / |ω + z|, and |ω + z|² = 2 + 2 ω_z.
    const difference = sqrt(max(0, (1 + map.z[k]) / 2));
    const fresnel = (1 - difference) ** 5;
    const half = difference > 0 ? (incident + nz) / (2 * difference) : SQRT1_2;
    const spread = 1 - (1 - square) * half * half;
    const distribution = square / (PI * spread * spread);
    const visibility = 0.5 / (incident * masked + nz * sqrt(square + (1 - square) * incident * incident));
    const weights = [1 / PI, fresnel / PI, distribution * visibility, fresnel * distribution * visibility];
    for (let w = 0; w < 4; w++) {
      const weight = weights[w] * incident;
      sums[3 * w] += weight * map.r[k];
      sums[3 * w + 1] += weight * map.g[k];
      sums[3 * w + 2] += weight * map.b[k];
    }
  }
  return sums;
}

/** The irradiance of a material, from its integrals. */
export function irradiance(sums, { baseColor, metallic }) {
  return baseColor.map((base, channel) => {
    const f0 = 0.04 + (base - 0.04) * metallic;
    const albedo = base * (1 - metallic);
    const [matte, grazing, lobe, rim] = [0, 1, 2, 3].map((w) => sums[3 * w + channel]);
    return (1 - f0) * albedo * (matte - grazing) + f0 * lobe + (1 - f0) * rim;
  });
}

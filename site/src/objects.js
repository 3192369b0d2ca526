// The page's objects: a mesh and a coin by formula, and meshes of .obj files.

/**
 * A mesh: positions and normals, three numbers each, texture coordinates, two each (outside 0 to 1:
 * no normal map), and triangles.
 *
 * @typedef {{ positions: Float32Array, normals: Float32Array, uvs: Float32Array, indices: Uint32Array }} Mesh
 */

/**
 * A surface over two parameters from 0 to 1, with the normals of its differences.
 *
 * @param {(u: number, v: number) => number[]} at
 * @param {number} columns
 * @param {number} rows
 * @returns {Mesh}
 */
function surface(at, columns, rows) {
  const count = (columns + 1) * (rows + 1);
  const mesh = {
    positions: new Float32Array(3 * count),
    normals: new Float32Array(3 * count),
    uvs: new Float32Array(2 * count).fill(-1),
    indices: new Uint32Array(6 * columns * rows),
  };
  const e = 1e-4;
  for (let j = 0, k = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++, k++) {
      // Not the poles themselves, where the differences along u vanish.
      const [u, v] = [i / columns, Math.min(1 - 1e-3, Math.max(1e-3, j / rows))];
      const difference = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.map((value, axis) => value - b[axis]);
      const along = difference(at(u + e, v), at(u - e, v));
      const down = difference(at(u, v + e), at(u, v - e));
      mesh.positions.set(at(u, j / rows), 3 * k);
      mesh.normals.set(unit(cross(along, down)), 3 * k);
    }
  }
  for (let j = 0, k = 0; j < rows; j++) {
    for (let i = 0; i < columns; i++, k += 6) {
      const [a, b] = [j * (columns + 1) + i, (j + 1) * (columns + 1) + i];
      mesh.indices.set([a, a + 1, b, a + 1, b + 1, b], k);
    }
  }
  return mesh;
}

/** @type {(one: any, other: any) => number[]} */
const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
const unit = (/** @type {number[]} */ vector) => {
  const length = Math.hypot(...vector) || 1;
  return vector.map((value) => value / length);
};

/** A sea urchin's shell: ten ribs, and rows of fine warts between them. */
export const relief = () =>
  surface((u, v) => {
    const [around, slant] = [2 * Math.PI * u, Math.PI * v];
    const sine = Math.sin(slant);
    const rib = 0.055 * sine * Math.abs(Math.cos(5 * around)) ** 1.5;
    const wart = 0.013 * sine ** 2 * (Math.sin(30 * around) * Math.sin(19 * slant)) ** 2;
    const radius = 0.9 - rib + wart;
    return [radius * sine * Math.cos(around), 0.78 * radius * Math.cos(slant), radius * sine * Math.sin(around)];
  }, 420, 140);

/** The height of the coin's face over its plane, at a point of the unit disc. */
function coinHeight(x, y) {
  const radius = Math.hypot(x, y);
  const angle = Math.atan2(x, y);
  const step = (/** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ value) => {
    const t = Math.min(1, Math.max(0, (value - from) / (to - from)));
    return t * t * (3 - 2 * t);
  };
  let height = 0.05 * step(0.88, 0.92, radius) * (1 - step(0.97, 1, radius));
  // A ring of beads.
  const bead = ((angle / (2 * Math.PI)) * 60 + 60) % 1;
  const far = Math.hypot((bead - 0.5) * 2 * Math.PI * 0.82 / 60, radius - 0.82);
  height += 0.028 * Math.sqrt(Math.max(0, 1 - (far / 0.032) ** 2));
  // A rosette: the nodal lines of a harmonic of degree 8, in relief.
  const petal = 0.42 + 0.26 * Math.abs(Math.cos(4 * angle)) ** 0.8;
  height += 0.06 * (1 - step(petal - 0.1, petal + 0.03, radius)) * (0.75 + 0.25 * Math.cos(18 * radius));
  height += 0.05 * Math.sqrt(Math.max(0, 1 - (radius / 0.16) ** 2));
  return height;
}

/**
 * The coin's normal map: x to the right, y up, z out of the face, row 0 at the bottom.
 *
 * @param {number} size texels a side
 */
export function coinNormals(size) {
  const heights = new Float32Array((size + 2) ** 2);
  for (let row = 0; row < size + 2; row++) {
    for (let column = 0; column < size + 2; column++) {
      heights[row * (size + 2) + column] = coinHeight((2 * column - 1) / size - 1, (2 * row - 1) / size - 1);
    }
  }
  const normals = new Float32Array(4 * size * size);
  for (let row = 0; row < size; row++) {
    for (let column = 0; column < size; column++) {
      const at = (row + 1) * (size + 2) + column + 1;
      const slope = (/** @type {number} */ step) => ((heights[at + step] - heights[at - step]) * size) / 4;
      normals.set([...unit([-slope(1), -slope(size + 2), 1]), 1], 4 * (row * size + column));
    }
  }
  return normals;
}

/** The coin: two faces with a normal map, and a reeded edge. */
export function coin() {
  const [around, half, bevel] = [360, 0.07, 0.985];
  const positions = [], normals = [], uvs = [], indices = [];
  const point = (/** @type {number[]} */ position, /** @type {number[]} */ normal, /** @type {number[]} */ uv) => {
    positions.push(...position);
    normals.push(...unit(normal));
    uvs.push(...uv);
    return positions.length / 3 - 1;
  };
  for (const side of [1, -1]) {
    const center = point([0, 0, side * half], [0, 0, side], [0.5, 0.5]);
    for (let k = 0; k <= around; k++) {
      const [x, y] = [Math.cos((2 * Math.PI * k) / around) * bevel, Math.sin((2 * Math.PI * k) / around) * bevel];
      // The back is the front, mirrored, so that it reads the same from behind.
      const rim = point([x, y, side * half], [0, 0, side], [0.5 + 0.5 * side * x, 0.5 + 0.5 * y]);
      if (k > 0) indices.push(center, side > 0 ? rim - 1 : rim, side > 0 ? rim : rim - 1);
    }
  }
  for (let k = 0; k <= around; k++) {
    const angle = (2 * Math.PI * k) / around;
    const [x, y] = [Math.cos(angle), Math.sin(angle)];
    const reed = 0.5 * Math.sin(120 * angle);
    const normal = [x - reed * y, y + reed * x, 0];
    const low = point([bevel * x, bevel * y, -half], normal, [-1, -1]);
    point([bevel * x, bevel * y, half], normal, [-1, -1]);
    if (k > 0) indices.push(low - 2, low, low + 1, low - 2, low + 1, low - 1);
  }
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    uvs: Float32Array.from(uvs),
    indices: Uint32Array.from(indices),
  };
}

/** Most triangles of a file. */
export const MOST = 2_000_000;

/** Facets that meet at a larger angle, 30 degrees, have an edge between them. */
const CREASE = Math.cos(Math.PI / 6);

/**
 * The mesh of an .obj file, in the unit sphere. Normals that it lacks are the mean of the facets',
 * weighted with their areas, up to creases.
 *
 * @param {string} text
 * @returns {Mesh}
 * @throws {RangeError} if it has no faces, or refers to vertices that it does not have
 */
export function parseObj(text) {
  const places = [], directions = [], positions = [], normals = [], indices = [];
  const corners = new Map();
  const numbers = (/** @type {string[]} */ words, /** @type {number} */ line) => {
    const values = words.slice(1, 4).map(Number);
    if (values.length < 3 || !values.every(Number.isFinite)) throw new RangeError(`line ${line} is not three numbers`);
    return values;
  };
  text.split(/\r?\n/).forEach((content, k) => {
    const words = content.trim().split(/\s+/);
    if (words[0] === "v") places.push(numbers(words, k + 1));
    if (words[0] === "vn") directions.push(numbers(words, k + 1));
    if (words[0] !== "f") return;
    const face = words.slice(1).map((word) => {
      let corner = corners.get(word);
      if (corner !== undefined) return corner;
      const [place, , direction] = word.split("/");
      const find = (/** @type {number[][]} */ list, /** @type {string} */ index) =>
        list[Number(index) < 0 ? list.length + Number(index) : Number(index) - 1];
      const found = find(places, place);
      if (!found) throw new RangeError(`line ${k + 1} refers to vertex ${place}, which is not there`);
      corner = positions.length / 3;
      // Relative indices mean another vertex each time.
      if (!word.includes("-")) corners.set(word, corner);
      positions.push(...found);
      normals.push(...unit((direction && find(directions, direction)) || [0, 0, 0]));
      return corner;
    });
    if (face.length < 3) throw new RangeError(`line ${k + 1} is a face of ${face.length} vertices`);
    for (let c = 2; c < face.length; c++) indices.push(face[0], face[c - 1], face[c]);
    if (indices.length > 3 * MOST) throw new RangeError(`more than ${MOST} triangles`);
  });
  if (indices.length === 0) throw new RangeError("it has no faces");
  smooth(positions, normals, indices);
  fit(positions);
  return {
    positions: Float32Array.from(positions),
    normals: Float32Array.from(normals),
    uvs: new Float32Array((positions.length / 3) * 2).fill(-1),
    indices: Uint32Array.from(indices),
  };
}

/**
 * Gives vertices without a normal those of their facets: the corners of facets that meet at an edge
 * without a crease share one, and the others get vertices of their own.
 *
 * @param {number[]} positions
 * @param {number[]} normals
 * @param {number[]} indices
 */
function smooth(positions, normals, indices) {
  const at = (/** @type {number[]} */ list, /** @type {number} */ k) => list.slice(3 * k, 3 * k + 3);
  const isBare = (/** @type {number} */ vertex) => at(normals, vertex).every((value) => value === 0);
  /** @type {Map<string, number>} */
  const known = new Map();
  const places = Array.from({ length: positions.length / 3 }, (_, k) => {
    const key = at(positions, k).join();
    if (!known.has(key)) known.set(key, known.size);
    return /** @type {number} */ (known.get(key));
  });
  /** The first corner of each group of corners that share a normal. */
  const groups = Array.from(indices, (_, corner) => corner);
  const first = (/** @type {number} */ corner) => {
    while (groups[corner] !== corner) corner = groups[corner] = groups[groups[corner]];
    return corner;
  };
  const facets = Array.from({ length: indices.length / 3 }, (_, k) => {
    const [a, b, c] = [0, 1, 2].map((corner) => at(positions, indices[3 * k + corner]));
    return cross(b.map((value, axis) => value - a[axis]), c.map((value, axis) => value - a[axis]));
  });
  const isSmooth = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    a.reduce((sum, value, axis) => sum + value * b[axis], 0) >= CREASE * Math.hypot(...a) * Math.hypot(...b);
  /** @type {Map<number, [number, number][]>} The corners at both ends of each edge, for each facet. */
  const edges = new Map();
  for (let from = 0; from < indices.length; from++) {
    const to = from % 3 === 2 ? from - 2 : from + 1;
    const ends = /** @type {[number, number]} */ (places[indices[from]] < places[indices[to]] ? [from, to] : [to, from]);
    const key = places[indices[ends[0]]] * known.size + places[indices[ends[1]]];
    const others = edges.get(key);
    if (!others) edges.set(key, [ends]);
    // Where more than two facets meet, each is compared with the one before it.
    else {
      const [before] = others.slice(-1);
      others.push(ends);
      if (!isSmooth(facets[Math.floor(from / 3)], facets[Math.floor(before[0] / 3)])) continue;
      ends.forEach((corner, end) => (groups[first(corner)] = first(before[end])));
    }
  }
  const sums = new Map();
  indices.forEach((_, corner) => {
    const sum = sums.get(first(corner)) ?? [0, 0, 0];
    sums.set(first(corner), sum.map((value, axis) => value + facets[Math.floor(corner / 3)][axis]));
  });
  /** @type {Map<number, number>} The vertex of each group. */
  const vertices = new Map();
  const bare = indices.map(isBare);
  indices.forEach((vertex, corner) => {
    if (!bare[corner]) return;
    const group = first(corner);
    if (!vertices.has(group)) {
      const own = isBare(vertex) ? vertex : positions.length / 3;
      vertices.set(group, own);
      const normal = unit(sums.get(group));
      normals.splice(3 * own, 3, ...(Math.hypot(...normal) ? normal : [0, 0, 1]));
      if (own !== vertex) positions.push(...at(positions, vertex));
    }
    indices[corner] = /** @type {number} */ (vertices.get(group));
  });
}

/** Moves and scales positions into the unit sphere. */
function fit(/** @type {number[]} */ positions) {
  const [low, high] = [[Infinity, Infinity, Infinity], [-Infinity, -Infinity, -Infinity]];
  positions.forEach((value, k) => {
    low[k % 3] = Math.min(low[k % 3], value);
    high[k % 3] = Math.max(high[k % 3], value);
  });
  const middle = low.map((value, axis) => (value + high[axis]) / 2);
  let most = 0;
  for (let k = 0; k < positions.length; k += 3) {
    most = Math.max(most, Math.hypot(positions[k] - middle[0], positions[k + 1] - middle[1], positions[k + 2] - middle[2]));
  }
  if (!(most > 0 && most < Infinity)) throw new RangeError("it has no extent");
  positions.forEach((value, k) => (positions[k] = (value - middle[k % 3]) / most));
}

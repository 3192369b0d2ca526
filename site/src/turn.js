// Rotations as quaternions [x, y, z, w].

/** @typedef {[number, number, number, number]} Quaternion */

/** @type {Quaternion} */
export const IDENTITY = [0, 0, 0, 1];

/**
 * First b, then a, of length 1.
 *
 * @param {Quaternion} a
 * @param {Quaternion} b
 * @returns {Quaternion}
 */
export function multiply([ax, ay, az, aw], [bx, by, bz, bw]) {
  const product = [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
  const length = Math.hypot(...product);
  return /** @type {Quaternion} */ (product.map((value) => value / length));
}

/** @param {number[]} turn */
export const inverse = ([x, y, z, w]) => [-x, -y, -z, w];

/**
 * The rotation of a drag: right turns about y, down about x. The arguments are angles.
 *
 * @param {number} right
 * @param {number} down
 * @returns {Quaternion}
 */
export function dragged(right, down, twist = 0) {
  const angle = Math.hypot(right, down, twist);
  if (angle === 0) return [...IDENTITY];
  const scale = Math.sin(angle / 2) / angle;
  return [down * scale, right * scale, twist * scale, Math.cos(angle / 2)];
}

/**
 * @param {number[]} turn
 * @param {number[]} vector
 */
export function rotate([x, y, z, w], [a, b, c]) {
  const [p, q, r] = [2 * (y * c - z * b), 2 * (z * a - x * c), 2 * (x * b - y * a)];
  return [a + w * p + y * r - z * q, b + w * q + z * p - x * r, c + w * r + x * q - y * p];
}

/**
 * The rotation as a matrix, column by column.
 *
 * @param {number[]} turn
 */
export const matrix = (turn) =>
  Float32Array.from([[1, 0, 0], [0, 1, 0], [0, 0, 1]].flatMap((axis) => rotate(turn, axis)));

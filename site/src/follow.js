// The light follows a place on the object.

/** Where the lamps of the light are, in the mean. */
const LAMP = [0.753,0.055,-0.655];

/**
 * The turn of the light that puts the lamp's highlight at a place of a sphere: (x, y) from -1 to 1 to the
 * right and up.
 *
 * @param {number[]} place
 * @returns {[number, number, number, number]}
 */
export function toward([x, y]) {
  // Beyond this the lamp is behind the object.
  const inside = Math.min(1, 0.8 / Math.max(1e-9, Math.hypot(x, y)));
  const normal = [x * inside, y * inside, 0];
  normal[2] = Math.sqrt(1 - normal[0] ** 2 - normal[1] ** 2);
  const mirrored = [2 * normal[2] * normal[0], 2 * normal[2] * normal[1], 2 * normal[2] ** 2 - 1];
  return between(LAMP, mirrored);
}

/** The smallest rotation from a unit vector to another that is not opposite. */
function between([a, b, c], [x, y, z]) {
  const turn = [b * z - c * y, c * x - a * z, a * y - b * x, 1 + a * x + b * y + c * z];
  const length = Math.hypot(...turn);
  return /** @type {[number, number, number, number]} */ (turn.map((value) => value / length));
}

// What a misspelled name may mean.

/**
 * Letters to add, leave out, change, or exchange with their neighbor, until one is the other.
 *
 * @param {string} one
 * @param {string} other
 */
function distance(one, other) {
  const rows = [Array.from({ length: other.length + 1 }, (_, k) => k)];
  for (let i = 1; i <= one.length; i++) {
    const row = [i];
    for (let k = 1; k <= other.length; k++) {
      const changed = rows[i - 1][k - 1] + Number(one[i - 1] !== other[k - 1]);
      const isExchanged = i > 1 && k > 1 && one[i - 1] === other[k - 2] && one[i - 2] === other[k - 1];
      const exchanged = isExchanged ? rows[i - 2][k - 2] + 1 : Infinity;
      row.push(Math.min(rows[i - 1][k] + 1, row[k - 1] + 1, changed, exchanged));
    }
    rows.push(row);
  }
  return rows[one.length][other.length];
}

/**
 * The names that are as near as a slip of the keyboard, the nearest first. Case and the kind of
 * separator make no difference.
 *
 * @param {string} given
 * @param {readonly string[]} names
 */
export function near(given, names) {
  const plain = (/** @type {string} */ name) => name.toLowerCase().replaceAll(/[ _]/g, "-");
  const most = given.length < 8 ? 1 : 2;
  return names
    .map((name) => ({ name, off: distance(plain(given), plain(name)) }))
    .filter(({ off }) => off <= most)
    .sort((one, other) => one.off - other.off)
    .map(({ name }) => name);
}

/**
 * Why a name is not accepted: `did you mean ..?`, or all names.
 *
 * @param {string} given
 * @param {readonly string[]} names
 */
export function unlike(given, names) {
  const [nearest] = near(given, names);
  return nearest === undefined ? `is not one of ${names.join(", ")}` : `is unknown; did you mean "${nearest}"?`;
}

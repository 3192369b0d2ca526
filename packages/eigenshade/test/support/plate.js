// A mesh that casts shadows on itself, as an .obj.

/** A square plate with a wall around it and a bar across: both cast shadows. */
export function plate() {
  const [points, faces] = [[], []];
  const side = 121;
  const heightAt = (x, y) => (Math.max(Math.abs(x), Math.abs(y)) > 0.8 ? 0.3 : Math.abs(x + 0.4 * y) < 0.12 ? 0.4 : 0);
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++) {
      const [x, y] = [column, row].map((at) => (2 * at) / (side - 1) - 1);
      points.push(`v ${x} ${y} ${heightAt(x, y)}`);
      if (row && column) {
        const [a, b, c, d] = [-side - 1, -side, 0, -1].map((by) => row * side + column + 1 + by);
        faces.push(`f ${a} ${b} ${c}`, `f ${a} ${c} ${d}`);
      }
    }
  }
  return [...points, ...faces, ""].join("\n");
}

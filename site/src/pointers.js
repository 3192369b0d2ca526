// Turns by pointers and arrow keys.

/**
 * Calls back for each turn: radians to the right, down and about the view axis, and whether Alt or
 * a second finger swaps light and object.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {(right: number, down: number, twist: number, other: boolean) => void} turn
 * @param {(is: boolean) => void} dragging called when a drag begins, and when a pointer is lifted
 */
export function turnable(canvas, turn, dragging) {
  /** @type {Map<number, PointerEvent>} */
  const pointers = new Map();
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button > 0) return;
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
    dragging(true);
  });
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const scale = 3 / canvas.clientWidth / pointers.size;
    let twist = 0;
    if (pointers.size === 2) {
      const other = [...pointers.values()].find(({ pointerId }) => pointerId !== event.pointerId);
      const angle = (/** @type {PointerEvent} */ at) => Math.atan2(at.clientY - (other?.clientY ?? 0), at.clientX - (other?.clientX ?? 0));
      twist = -Math.atan2(Math.sin(angle(event) - angle(before)), Math.cos(angle(event) - angle(before)));
    }
    pointers.set(event.pointerId, event);
    turn(scale * (event.clientX - before.clientX), scale * (event.clientY - before.clientY), twist, event.altKey || pointers.size > 1);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => {
      pointers.delete(/** @type {PointerEvent} */ (event).pointerId);
      dragging(pointers.size > 0);
    });
  }
  canvas.addEventListener("keydown", (event) => {
    const [right, down] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key] ?? [0, 0];
    if (!right && !down) return;
    event.preventDefault();
    turn(right * 0.0873, down * 0.0873, 0, event.altKey || event.shiftKey);
  });
}

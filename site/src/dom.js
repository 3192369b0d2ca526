// Elements of the page, and whether it is busy.

export const find = (/** @type {string} */ id) => /** @type {any} */ (document.getElementById(id));

/** Whether the picture and its numbers are not yet those of the state; tests wait for it. */
export const busy = (/** @type {boolean} */ is) => (document.documentElement.dataset.busy = String(is));

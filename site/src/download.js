// Saves files of what is shown.

import { find } from "./dom.js";

/**
 * Saves a file of this kind: the canvas's picture, or one of the texts.
 *
 * @param {string} kind the extension of the name
 * @param {string} name
 * @param {HTMLCanvasElement} canvas
 * @param {Record<string, () => string>} texts by kind
 */
export async function download(kind, name, canvas, texts) {
  const content = kind === "png" ? await pictureOf(canvas) : new Blob([texts[kind]()]);
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  find("take-note").textContent = `Saved ${name}`;
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

async function pictureOf(/** @type {HTMLCanvasElement} */ canvas) {
  const picture = await new Promise((/** @type {BlobCallback} */ done) => canvas.toBlob(done));
  if (!picture) throw new Error("This browser makes no PNG of the picture.");
  return picture;
}

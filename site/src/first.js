// The first sight: the object under a light that follows the pointer. All else is loaded afterwards.

import { busy, find } from "./dom.js";
import { drawer } from "./object-picture.js";
import { unpacked } from "./packed.js";

const canvas = /** @type {HTMLCanvasElement} */ (find("object"));

// ---- details ----

/** @type {Promise<typeof import("./main.js") | undefined> | undefined} */
let details;

/** Shows the details if the address holds a state, else the first sight. */
function route() {
  const open = location.hash.length > 1;
  const isOther = find("page").hidden === open;
  find("first").hidden = open;
  find("page").hidden = !open;
  for (const one of document.querySelectorAll(".only-details, .only-first")) /** @type {HTMLElement} */ (one).hidden = one.classList.contains("only-first") === open;
  find("take").open = false;
  if (open) details ??= import("./main.js").then(withDetails, withoutDetails);
  else start();
  return isOther;
}
addEventListener("hashchange", async () => {
  if (!route()) return;
  const open = find("first").hidden;
  find(open ? "picture" : "open-details").focus({ preventScroll: true });
  if (open || !find("terms").textContent) return;
  // The accuracy of the details.
  find("first-step").value = find("step").value;
  await started;
  find("first-step").dispatchEvent(new Event("input"));
});

/** Takes back the message of an earlier attempt. */
async function withDetails(/** @type {typeof import("./main.js")} */ module) {
  if (await started) say("");
  return module;
}

/** Goes back to the first sight, from where a link tries again. */
function withoutDetails(/** @type {Error} */ { message }) {
  details = undefined;
  location.replace("#");
  say(`The details cannot be shown: ${message}`);
  return undefined;
}
const say = (/** @type {string} */ text) => (find("first-fault").textContent = text);

// ---- downloads ----

const take = find("take");
take.addEventListener("click", async (/** @type {PointerEvent} */ { target }) => {
  const kind = /** @type {Element} */ (target).closest("[data-take]")?.getAttribute("data-take");
  if (!kind) return;
  find("take-note").textContent = "";
  try {
    const shown = await (find("first").hidden ? details : started);
    if (!shown) throw new Error("There is no picture.");
    await shown.download(kind);
  } catch (fault) {
    find("take-note").textContent = /** @type {Error} */ (fault).message;
  }
});
// A click elsewhere and Escape close the menu.
addEventListener("pointerdown", ({ target }) => take.contains(target) || (take.open = false));
take.addEventListener("keydown", (/** @type {KeyboardEvent} */ { key }) => {
  if (key !== "Escape") return;
  take.open = false;
  take.querySelector("summary").focus();
});

// ---- the object ----

/** @type {Promise<import("./live.js").Live | undefined> | undefined} */
let started;
function start() {
  started ??= begin().catch((fault) => {
    say(`The picture cannot be drawn: ${fault.message}`);
    busy(false);
    return undefined;
  });
}

/** Later modules, fetched at once because they import each other in five levels. */
const MODULES = [
  ...["live", "follow", "parts", "screen", "measure", "boards", "turn", "plot", "state", "harmonics", "pursuit"].map((name) => `./${name}`),
  ...["index", "assets", "engine", "preview", "presets", "input", "scene", "sphere", "renderer", "suggest", "exposure", "steps", "shader", "window", "programs"]
    .map((name) => `../eigenshade/src/${name}`),
  "../vendor/culori",
];

async function begin() {
  busy(true);
  const response = await fetch(new URL("../object/egg.bin", import.meta.url));
  if (!response.ok || !response.body) throw new Error(`object/egg.bin: ${response.status}; run site/build`);
  const object = await unpacked(response.body);
  const draw = drawer(canvas, object, say);
  draw(object.palettes);
  // The first frame shows the picture, and the second one comes after it.
  for (let k = 0; k < 2; k++) await new Promise(requestAnimationFrame);
  performance.mark("first-picture");
  for (const name of MODULES) {
    const href = new URL(`${name}.js`, import.meta.url).href;
    document.head.append(Object.assign(document.createElement("link"), { rel: "modulepreload", href }));
  }
  const [{ Live }, { follow }] = await Promise.all([import("./live.js"), import("./follow.js")]);
  const live = await Live.create(object, draw);
  follow(find("first"), canvas, object.about.place, live);
  return live;
}

find("closed").hidden = true;
route();

// Files of the user: objects and panoramas, chosen or dropped.

import { find } from "./dom.js";
import { parseObj } from "./objects.js";
import { counted } from "./plot.js";

/**
 * Calls back for a file that is dropped on the page.
 *
 * @param {(file: File) => void} open
 */
function onDrop(open) {
  let depth = 0;
  addEventListener("dragenter", (event) => {
    event.preventDefault();
    depth++;
    document.body.classList.add("dropping");
  });
  addEventListener("dragleave", () => {
    if (--depth <= 0) document.body.classList.remove("dropping");
  });
  addEventListener("dragover", (event) => event.preventDefault());
  addEventListener("drop", (event) => {
    event.preventDefault();
    depth = 0;
    document.body.classList.remove("dropping");
    const [file] = event.dataTransfer?.files ?? [];
    if (file) open(file);
  });
}

/** Most bytes of a file. */
const LARGEST = 512 * 2 ** 20;

/** Throws for a file that is not worth reading. */
function checkSize(/** @type {File} */ { size }) {
  if (size === 0) throw new Error("it is empty");
  if (size > LARGEST) throw new Error("it is larger than 512 MB");
}

/** Seconds that a worker may say nothing. */
const PATIENCE = 60;

/** Ends the worker of the last panorama. Nothing is said of it any more. */
let end = () => {};

/**
 * The light of a panorama, by a worker. A new one ends the one before.
 *
 * @param {File} file
 * @param {(text: string) => void} say
 * @returns {Promise<any>}
 */
function panorama(file, say) {
  end();
  const worker = new Worker(new URL("panorama.js", import.meta.url), { type: "module" });
  return new Promise((resolve, reject) => {
    /** @type {ReturnType<typeof setTimeout>} */
    let patience;
    end = () => {
      clearTimeout(patience);
      worker.terminate();
    };
    const refuse = (/** @type {string} */ why) => {
      end();
      reject(new Error(why));
    };
    const wait = () => {
      clearTimeout(patience);
      patience = setTimeout(() => refuse(`it is not read after ${PATIENCE} seconds`), 1000 * PATIENCE);
    };
    wait();
    worker.addEventListener("message", ({ data }) => {
      if (data.stage) {
        wait();
        say(data.stage === "decoding" ? `${file.name}: decoding` : `${file.name}: ${data.stage}, ${Math.round(100 * data.share)} %`);
        return;
      }
      if (data.fault) return refuse(data.fault);
      end();
      resolve(data);
    });
    worker.addEventListener("error", (event) => refuse(event.message || "the decoder cannot be loaded"));
    worker.postMessage({ file, name: file.name });
  });
}

/**
 * Opens files that are chosen or dropped.
 *
 * @param {object} page
 * @param {(parts: Partial<import("./state.js").State>) => void} page.set
 * @param {(parts: Partial<import("./state.js").State>) => Promise<string>} page.take
 * @param {import("./shown.js").Shown} page.shown
 * @param {boolean} page.draws whether WebGL draws
 * @param {(text: string) => void} page.say
 * @param {(text: string) => void} page.fail
 */
export function opens({ set, take, shown, draws, say, fail }) {
  async function read(/** @type {File} */ file) {
    checkSize(file);
    if (/\.(glb|gltf)$/i.test(file.name)) {
      if (!draws) throw new Error("it needs WebGL 2, which this browser has not");
      const { Model } = await import("./model.js");
      const model = await Model.read(await file.arrayBuffer());
      shown.takeModel(model);
      set({ object: "own" });
      const without = model.leftOut.length ? `, without ${model.leftOut.join(", ")}` : "";
      say(`${file.name}: ${counted(model.triangles, "triangle")} with its own materials${without}.`);
    } else if (/\.obj$/i.test(file.name)) {
      const mesh = parseObj(await file.text());
      shown.takeMesh(mesh);
      set({ object: "own" });
      say(`${file.name}: ${mesh.indices.length / 3} triangles.`);
      if (!draws) say(`${file.name} is read, but without WebGL 2 only spheres are drawn.`);
    } else {
      const { light, width, height, note } = await panorama(file, say);
      const fault = await take({ light: "own", ownLight: { name: file.name.slice(0, 80), light } });
      if (fault) throw new Error(fault);
      const shape = width === 2 * height ? "" : " It is not twice as wide as high; it is read as equirectangular.";
      say(`${file.name}: ${width} × ${height}, projected to degree 9, with ${counted(light.sources.length / 7, "source")}.${shape}${note}`);
    }
  }

  async function open(/** @type {File} */ file) {
    fail("");
    say(`Reading ${file.name}`);
    try {
      await read(file);
    } catch (fault) {
      say("");
      fail(`${file.name} cannot be used: ${/** @type {Error} */ (fault).message}. The picture is as it was.`);
    }
  }

  for (const id of ["open-light", "open-mesh"]) find(id).addEventListener("click", () => find("file").click());
  find("file").addEventListener("change", () => {
    const { files: [file] } = find("file");
    if (file) open(file);
    find("file").value = "";
  });
  onDrop(open);
}

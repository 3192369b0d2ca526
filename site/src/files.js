// Files of the user: dropped ones, and panoramas.

/**
 * Calls back for a file that is dropped on the page.
 *
 * @param {(file: File) => void} open
 */
export function onDrop(open) {
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
export function checkSize(/** @type {File} */ { size }) {
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
export function panorama(file, say) {
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

// The package's files: WebAssembly and presets.

/**
 * Where the folders `wasm` and `presets` are: an address, relative to the page, or a function from
 * a path such as `"presets/light/park.bin"` to the bytes of the file, `undefined` if there is none.
 *
 * @typedef {string | URL | ((path: string) => Promise<Uint8Array | undefined>)} Assets
 */

/** By a name: bundlers look for the files of a `new URL(.., import.meta.url)` and replace it. */
const here = import.meta.url;

/**
 * @param {string} address
 * @param {string | undefined} base
 */
function parsed(address, base) {
  try {
    return new URL(address, base);
  } catch {
    return undefined;
  }
}

/** @type {URL | ((path: string) => Promise<Uint8Array | undefined>) | undefined} */
let place = parsed("../", here);

/**
 * Sets where the package's files are, for the whole page. By default they are beside the folder of
 * the package's scripts, which a bundler may move.
 *
 * @param {Assets} assets
 * @throws {TypeError} unless this is an address or a function
 */
export function setAssets(assets) {
  if (typeof assets === "function") {
    place = assets;
    return;
  }
  const page = globalThis.document?.baseURI ?? globalThis.location?.href;
  const folder = parsed(String(assets).replace(/\/*$/, "/"), page);
  if (!folder) throw new TypeError(`assets: "${assets}" is neither an address nor a function`);
  place = folder;
}

/**
 * The error for a file that is not there or is something else.
 *
 * @param {string} path relative to the package's folder
 * @param {string} fault such as "is missing"
 */
export function misplaced(path, fault) {
  const address = place instanceof URL ? new URL(path, place).href : path;
  const served = "serve eigenshade's folders wasm and presets and call setAssets(address)";
  return new Error(`${address} ${fault}; import "eigenshade/bundled", or ${served}`);
}

/**
 * The bytes of a file of the package.
 *
 * @param {string} path relative to the package's folder
 * @returns {Promise<ArrayBuffer | undefined>} `undefined` if there is no such file
 */
export async function asset(path) {
  if (place === undefined) throw misplaced(path, "has no address in a script that is no module");
  if (typeof place === "function") {
    const bytes = await place(path);
    // A copy of a part of a larger buffer.
    return bytes && new Uint8Array(bytes).buffer;
  }
  const url = new URL(path, place);
  // Not an import, so that no bundler looks for the module. Node has no `fetch` for files.
  const node = /** @type {any} */ (globalThis).process?.getBuiltinModule?.("node:fs");
  if (url.protocol === "file:" && node) {
    try {
      return new Uint8Array(node.readFileSync(url)).buffer;
    } catch (fault) {
      if (/** @type {{ code?: string }} */ (fault).code === "ENOENT") return undefined;
      throw fault;
    }
  }
  const response = await fetch(url).catch((fault) => {
    throw misplaced(path, `cannot be fetched (${fault.message})`);
  });
  if (response.status === 404) return undefined;
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response.arrayBuffer();
}

/**
 * The bytes of a file that every package has.
 *
 * @param {string} path relative to the package's folder
 */
export async function required(path) {
  const bytes = await asset(path);
  if (!bytes) throw misplaced(path, "is missing");
  return bytes;
}

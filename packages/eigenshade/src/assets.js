// The files beside this module: WebAssembly and presets. Node has no `fetch` for files.

/** By a name: bundlers look for the files of a `new URL(.., import.meta.url)` and replace it. */
const here = import.meta.url;

/** @param {string} path relative to the package's folder */
const address = (path) => new URL(`../${path}`, here);

/**
 * The bytes of a file of the package.
 *
 * @param {string} path relative to the package's folder
 * @returns {Promise<ArrayBuffer | undefined>} `undefined` if there is no such file
 */
export async function asset(path) {
  const url = address(path);
  if (url.protocol === "file:") {
    // Node. Not an import, so that no bundler looks for the module.
    const { process } = /** @type {any} */ (globalThis);
    try {
      return new Uint8Array(process.getBuiltinModule("node:fs").readFileSync(url)).buffer;
    } catch (fault) {
      if (/** @type {{ code?: string }} */ (fault).code === "ENOENT") return undefined;
      throw fault;
    }
  }
  const response = await fetch(url);
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
  if (!bytes) throw new Error(`${address(path)} is missing from the package`);
  return bytes;
}

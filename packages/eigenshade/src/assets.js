// The files beside this module: WebAssembly and presets. Node has no `fetch` for files.

/**
 * The bytes of a file of the package.
 *
 * @param {string} path relative to the package's folder
 * @returns {Promise<ArrayBuffer | undefined>} `undefined` if there is no such file
 */
export async function asset(path) {
  const url = new URL(`../${path}`, import.meta.url);
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

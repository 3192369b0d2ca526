// `import "eigenshade/bundled"`: the package's files as parts of a program, for bundlers. Each is
// loaded when it is needed, from where the bundler puts it. The build replaces them by their bytes.

import { setAssets } from "./index.js";

setAssets(async (path) => {
  const [folder, ...names] = path.split("/");
  const name = names.join("/");
  if (path === "wasm/eigenshade.shadowed.wasm") {
    return (await import("../wasm/eigenshade.shadowed.wasm")).default;
  }
  // Two modules, which serve scenes with and without sources.
  if (folder === "wasm") {
    const part = /simd|relaxed/.test(name)
      ? import("../wasm/eigenshade.sources.simd.wasm")
      : import("../wasm/eigenshade.sources.wasm");
    return (await part).default;
  }
  try {
    return (await import(`../presets/${name}`)).default;
  } catch (fault) {
    // A chunk that cannot be fetched is another fault.
    if (/not found in bundle/.test(fault.message)) return undefined;
    throw fault;
  }
});

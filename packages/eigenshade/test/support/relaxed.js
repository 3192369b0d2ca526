// Relaxed SIMD, which Node 20 takes only with a flag.

import { setFlagsFromString } from "node:v8";

/** Modules that are loaded from now on may have relaxed SIMD. */
export const takeRelaxedSimd = () => setFlagsFromString("--experimental-wasm-relaxed-simd");

// Modules with tables of their own, made of the scenes beside the tests.

import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const ROOT = fileURLToPath(new URL("../../../../", import.meta.url));
/** The program. */
export const EIGENSHADE = process.env.EIGENSHADE ?? `${ROOT}target/debug/eigenshade`;

/** The module of a scene's table, with SIMD. */
export function ownModule(scene) {
  const folder = `${ROOT}target/modules/package/${scene}`;
  const path = fileURLToPath(new URL(`../${scene}.toml`, import.meta.url));
  mkdirSync(folder, { recursive: true });
  execFileSync(EIGENSHADE, ["basis", "--quiet", "--scene", path, "--out", `${folder}/table.bin`]);
  const environment = { ...process.env, EIGENSHADE_TABLE: `${folder}/table.bin` };
  execFileSync(`${ROOT}crates/wasm/build`, ["--to", folder, "color.simd"], { env: environment, stdio: "pipe" });
  return readFileSync(`${folder}/color.simd.wasm`);
}

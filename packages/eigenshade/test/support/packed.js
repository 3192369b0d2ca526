// The package as users get it: its packed archive, installed into an empty folder.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, realpathSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const PACKAGE = fileURLToPath(new URL("../../", import.meta.url));

/** A new folder with the package in `node_modules`, and the archive. */
export function installed() {
  // Vite wants the path itself, not a link to it.
  const folder = realpathSync(mkdtempSync(join(tmpdir(), "eigenshade-")));
  const npm = (...all) => execFileSync("npm", all, { cwd: folder, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] });
  const [{ filename }] = JSON.parse(npm("pack", "--ignore-scripts", "--json", PACKAGE));
  assert.equal(filename, "eigenshade-0.1.0.tgz");
  npm("install", "--no-audit", "--no-fund", `./${filename}`);
  return folder;
}

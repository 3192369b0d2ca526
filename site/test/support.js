// The page in Debian's Chromium, served from site/.

import { createReadStream } from "node:fs";
import { join } from "node:path";
import { Readable } from "node:stream";
import { fileURLToPath } from "node:url";
import { unpacked } from "../src/packed.js";
import { launch, serve as servePackage } from "../../packages/eigenshade/test/support/browser.js";

export { launch };
export const SITE = fileURLToPath(new URL("../", import.meta.url));
export const ROOT = fileURLToPath(new URL("../../", import.meta.url));

/** Serves site/ as any file server does. */
export async function serve() {
  const { address, close } = await servePackage({}, new URL("../", import.meta.url));
  return { address: `${address}/`, close };
}

/**
 * A page that has settled, and what went wrong in it: errors, and requests to other servers.
 */
export async function open(browser, address, { hash = "", width = 1440, height = 900, script, ...context } = {}) {
  const page = await browser.newPage({ viewport: { width, height }, reducedMotion: "reduce", ...context });
  const faults = [];
  page.on("pageerror", (fault) => faults.push(String(fault)));
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && !/GPU stall|GL Driver/.test(message.text()) && faults.push(message.text()));
  page.on("request", (request) => {
    if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(address)) faults.push(`request to ${request.url()}`);
  });
  if (script) await page.addInitScript(script);
  await page.goto(address + (hash ? `#${hash}` : ""));
  await settled(page);
  return { page, faults };
}

/**
 * Waits until the picture and its numbers are those of the state: less than a second, but up to a
 * minute of rendering in software on processors that do other work.
 */
export const settled = (page) => page.waitForFunction(() => document.documentElement.dataset.busy === "false", null, { timeout: 60e3 });

/** Takes WebGL 2 from a page: the CPU draws, which is faster than rendering in software. */
export const NO_WEBGL = `const { getContext } = HTMLCanvasElement.prototype;
  HTMLCanvasElement.prototype.getContext = function (kind, ...all) { return kind === "webgl2" ? null : getContext.call(this, kind, ...all); };`;

/** The file of the egg. */
export const eggFile = () => unpacked(Readable.toWeb(createReadStream(join(SITE, "object/egg.bin"))));

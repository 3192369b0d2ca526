// A small program made from the packed archive by each bundler, in a browser.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import * as esbuild from "esbuild";
import * as vite from "vite";
import webpack from "webpack";
import { launch, serve } from "./support/browser.js";
import { PACKAGE, installed } from "./support/packed.js";

const PAGE = (script) => `<!doctype html><title>waits</title><link rel=icon href=data:,>
<canvas style="width: 120px; height: 120px"></canvas>${script}`;

/** Says what it drew, or why it did not, in the page's title. */
const program = (lines, inputs = "") => `${lines}
import { Preview } from "eigenshade";
import "eigenshade/element";
import { EigenShade } from "eigenshade/react";
import { ShadowedObject } from "eigenshade/shadowed";
import { createElement } from "react";
import { createRoot } from "react-dom/client";
const canvas = document.querySelector("canvas");
Preview.create(canvas, { light: "park", material: "red-fabric2", sources: 2 ${inputs} }).then(
  async () => {
    const [r, g, b, a] = canvas.getContext("2d").getImageData(60, 60, 1, 1).data;
    // By its own module.
    const { message } = await ShadowedObject.load(new Uint8Array(1)).catch((fault) => fault);
    const { type } = await new Promise((onLoad) => createRoot(document.body).render(
      createElement(EigenShade, { light: "park", material: "nylon", onLoad, onError: onLoad }),
    ));
    const isRed = a === 255 && r > 1.2 * b && /is no object with shadows/.test(message) && type === "load";
    document.title = isRed ? "red" : [r, g, b, a, message, type].join();
  },
  ({ message }) => { document.title = message; },
);`;

/** The one line that bundlers need. */
const LINE = 'import "eigenshade/bundled";';

let folder, browser;

before(async () => {
  folder = installed();
  for (const name of ["react", "react-dom", "scheduler"]) cpSync(join(PACKAGE, "node_modules", name), join(folder, "node_modules", name), { recursive: true });
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** A new folder of a program, in that of the package. */
function app(name, lines, inputs) {
  const root = join(folder, name);
  mkdirSync(root);
  writeFileSync(join(root, "main.js"), program(lines, inputs));
  writeFileSync(join(root, "index.html"), PAGE('<script type="module" src="./main.js"></script>'));
  return root;
}

/** What the program of a page says. */
async function shown(address) {
  const page = await browser.newPage();
  try {
    await page.goto(address);
    await page.waitForFunction(() => document.title !== "waits");
    return await page.title();
  } finally {
    await page.close();
  }
}

/** What the program says whose scripts are in a folder. */
async function served(out, script) {
  writeFileSync(join(out, "index.html"), PAGE(script));
  const { address, close } = await serve({}, pathToFileURL(`${out}/`));
  try {
    return await shown(`${address}/`);
  } finally {
    close();
  }
}

const quiet = { configFile: false, logLevel: "silent" };
const bundlers = {
  "Vite, dev": async (root) => {
    const server = await vite.createServer({ ...quiet, root, cacheDir: join(root, ".vite"), server: { host: "127.0.0.1", port: 0, watch: null } });
    await server.listen();
    try {
      return await shown(server.resolvedUrls.local[0]);
    } finally {
      await server.close();
    }
  },
  "Vite, build and preview": async (root) => {
    await vite.build({ ...quiet, root });
    const server = await vite.preview({ ...quiet, root, preview: { host: "127.0.0.1", port: 0 } });
    try {
      return await shown(server.resolvedUrls.local[0]);
    } finally {
      await server.close();
    }
  },
  "webpack": async (root) => {
    const out = join(root, "dist");
    const stats = await new Promise((resolve, reject) => {
      const options = { context: root, entry: "./main.js", mode: "production", output: { path: out }, optimization: { minimize: false }, performance: false };
      webpack(options, (fault, stats) => (fault ? reject(fault) : resolve(stats)));
    });
    assert.deepEqual([...stats.compilation.errors, ...stats.compilation.warnings], []);
    return served(out, '<script src="./main.js" defer></script>');
  },
  "esbuild, ESM": async (root) => {
    const out = join(root, "dist");
    await esbuild.build({ entryPoints: [join(root, "main.js")], bundle: true, splitting: true, format: "esm", outdir: out });
    return served(out, '<script type="module" src="./main.js"></script>');
  },
  "esbuild, IIFE": async (root) => {
    const out = join(root, "dist");
    const { warnings } = await esbuild.build({ entryPoints: [join(root, "main.js")], bundle: true, format: "iife", outdir: out, logLevel: "silent" });
    assert.deepEqual(warnings, []);
    return served(out, '<script src="./main.js" defer></script>');
  },
  "esbuild, IIFE in a page opened from a file": async (root) => {
    await esbuild.build({ entryPoints: [join(root, "main.js")], bundle: true, format: "iife", outdir: root, allowOverwrite: true, logLevel: "silent" });
    writeFileSync(join(root, "index.html"), PAGE('<script src="./main.js" defer></script>'));
    return shown(pathToFileURL(join(root, "index.html")).href);
  },
};

for (const [k, [name, made]] of Object.entries(bundlers).entries()) {
  test(`${name}: with one line the program draws, without it says which`, async () => {
    assert.equal(await made(app(`with-${k}`, LINE)), "red");
    const said = await made(app(`without-${k}`, ""));
    assert.match(said, /^(https?|file):.*\/wasm\/.*wasm (is no|is missing|cannot be)|^wasm\/.*wasm has no address/, said);
    assert.ok(said.includes(`${LINE.replace(";", "")}, or serve `), said);
  });
}

test("the package's files served from a folder that an option names", async () => {
  const root = app("option", "", ', assets: "./files"');
  const out = join(root, "dist");
  for (const part of ["wasm", "presets"]) cpSync(join(folder, "node_modules/eigenshade", part), join(out, "files", part), { recursive: true });
  await esbuild.build({ entryPoints: [join(root, "main.js")], bundle: true, format: "esm", outdir: out });
  assert.equal(await served(out, '<script type="module" src="./main.js"></script>'), "red");
});

test("a program for Node, as a module and not", async () => {
  const source = join(folder, "node.js");
  writeFileSync(source, `${LINE}
import { Scene, presetNames } from "eigenshade";
presetNames().then(async ({ light }) => {
  const scene = await Scene.create({ light: "park", material: "red-fabric2" });
  console.log(light.includes("park"), scene.shade([0], [0], [1]).r[0] > 0);
  await Scene.create({ light: "parc", material: "red-fabric2" }).catch(({ message }) => console.log(message));
});`);
  for (const format of ["esm", "cjs"]) {
    const outfile = join(folder, "made", format === "esm" ? "node.mjs" : "node.cjs");
    await esbuild.build({ entryPoints: [source], bundle: true, platform: "node", format, outfile, logLevel: "silent" });
    const said = execFileSync("node", [outfile], { encoding: "utf8" });
    assert.equal(said, 'true true\nno light is called "parc"; did you mean park?\n');
  }
});

test("files of the package by their exported names", () => {
  const source = `for (const name of ["wasm/eigenshade.simd.wasm", "presets/light/park.bin", "presets/names.json", "package.json"])
    console.log(import.meta.resolve("eigenshade/" + name));`;
  writeFileSync(join(folder, "names.mjs"), source);
  const said = execFileSync("node", ["names.mjs"], { cwd: folder, encoding: "utf8" }).trim().split("\n");
  for (const address of said) assert.ok(readFileSync(new URL(address)).length > 0);
  assert.equal(said.length, 4);
});

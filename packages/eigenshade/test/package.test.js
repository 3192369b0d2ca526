// The packed archive, installed into an empty folder: the examples of README.md, and sizes.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { cpSync, readFileSync, readdirSync, rmSync, statSync, symlinkSync, unlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { sizes } from "../sizes.mjs";
import { launch, serve } from "./support/browser.js";
import { glb } from "./support/glb.js";
import { sizes as moduleSizes } from "./support/module-size.js";
import { EIGENSHADE } from "./support/own.js";
import { PACKAGE, installed } from "./support/packed.js";
import { plate } from "./support/plate.js";

const README = readFileSync(join(PACKAGE, "README.md"), "utf8");

/** The examples of README.md in a language. */
const examples = (language) =>
  [...README.matchAll(/```(\w+)\n(.*?)```/gs)].filter((found) => found[1] === language).map((found) => found[2]);

let folder, browser;

before(async () => {
  folder = installed();
  browser = await launch();
});

after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

test("nothing is missing from the archive, nothing is too much", () => {
  const listed = execFileSync("tar", ["tzf", join(folder, "eigenshade-0.1.0.tgz")], { encoding: "utf8" });
  const names = listed.trim().split("\n").map((name) => name.replace(/^package\//, ""));
  for (const name of [
    "LICENSE-APACHE", "LICENSE-MIT", "LICENSES-OF-LIBRARIES.txt", "DATA.md", "README.md", "dist/index.js", "dist/element.js", "dist/bundled.js",
    "index.d.ts", "dom.d.ts", "bundled.d.ts", "element.d.ts", "react.d.ts", "three.d.ts", "types/index.d.ts", "types/three.d.ts",
    "dist/three.js", "dist/react.js", "dist/shadowed.js", "shadowed.d.ts", "types/shadowed.d.ts", "wasm/eigenshade.shadowed.wasm",
    "wasm/eigenshade.wasm", "wasm/eigenshade.simd.wasm", "wasm/eigenshade.relaxed.wasm",
    "wasm/eigenshade.sources.wasm", "wasm/eigenshade.sources.simd.wasm",
    "wasm/eigenshade.sources.relaxed.wasm", "presets/names.json", "presets/light/park.bin", "presets/sources/park.bin",
  ]) {
    assert.ok(names.includes(name), name);
  }
  assert.ok(!names.some((name) => /test|node_modules|\.mjs$|^build/.test(name)), listed);
  const read = (name) => readFileSync(join(folder, "node_modules/eigenshade", name), "utf8");
  for (const crate of ["heapless", "libm", "zerocopy"]) assert.match(read("LICENSES-OF-LIBRARIES.txt"), new RegExp(`^${crate} [\\d.]+: `, "m"));
  assert.match(read("DATA.md"), /Terms: CC0 1\.0/);
  assert.deepEqual(JSON.parse(readFileSync(join(folder, "node_modules/eigenshade/package.json"))).dependencies, undefined);
});

test("bundlers find nothing to rewrite in the scripts", () => {
  for (const name of ["index", "element", "react", "shadowed", "three", "shared"]) {
    const script = readFileSync(join(folder, `node_modules/eigenshade/dist/${name}.js`), "utf8");
    // Vite and webpack replace this by an address of their own.
    assert.doesNotMatch(script, /new URL\([^()]*import\.meta\.url/);
    assert.equal(script.includes("import.meta.url"), name === "shared");
  }
});

test("an error says where a part of the package is missing", () => {
  cpSync(join(folder, "node_modules/eigenshade/dist"), join(folder, "moved/dist"), { recursive: true });
  const program = `import { Scene, presetNames } from "./dist/index.js";
    for (const promise of [presetNames(), Scene.create({ light: { r: [1], g: [1], b: [1] }, material: { roughness: 1 } })]) {
      await promise.catch(({ message }) => console.log(message));
    }`;
  writeFileSync(join(folder, "moved/program.mjs"), program);
  const said = execFileSync("node", ["moved/program.mjs"], { cwd: folder, encoding: "utf8" }).trim().split("\n");
  for (const [k, name] of ["presets/names.json", "wasm/eigenshade"].entries()) {
    assert.ok(said[k].startsWith(pathToFileURL(join(folder, "moved", name)).href), said[k]);
    assert.match(said[k], /is missing; import "eigenshade\/bundled", or serve/);
  }
});

test("the program of README.md draws a sphere in Node", () => {
  const program = examples("js").find((text) => text.includes("sphere.pam"));
  writeFileSync(join(folder, "sphere.mjs"), program);
  execFileSync("node", ["sphere.mjs"], { cwd: folder });
  const picture = readFileSync(join(folder, "sphere.pam"));
  const pixels = picture.subarray(picture.indexOf("ENDHDR\n") + 7);
  assert.equal(pixels.length, 4 * 240 * 240);
  const center = pixels.subarray(4 * (120 * 240 + 120)).subarray(0, 4);
  assert.ok(center[0] > center[2] && center[3] === 255, `red fabric: ${[...center]}`);
  assert.equal(pixels[3], 0);
});

test("the pages of README.md draw", async () => {
  const pages = examples("html");
  assert.equal(pages.length, 2);
  const root = pathToFileURL(`${folder}/`);
  const paths = Object.fromEntries(pages.map((page, k) => [`/${k}.html`, page]));
  const server = await serve({ ...paths, "/favicon.ico": "" }, root);
  for (const [k, color] of [[0, "copper"], [1, "red"]]) {
    const page = await browser.newPage();
    const [faults, modules] = [[], []];
    page.on("pageerror", (fault) => faults.push(fault.message));
    page.on("request", (request) => {
      if (!request.url().startsWith(server.address)) faults.push(request.url());
      if (request.url().endsWith(".wasm")) modules.push(request.url().split("/").at(-1));
    });
    page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
    await page.goto(`${server.address}/${k}.html`);
    // Its middle pixel.
    const middle = () =>
      page.evaluate(() => {
        const canvas = document.querySelector("canvas") ?? document.querySelector("eigen-shade")?.shadowRoot?.querySelector("canvas");
        const half = canvas.width >> 1;
        return [...canvas.getContext("2d").getImageData(half, half, 1, 1).data];
      });
    await page.waitForFunction(() => {
      const canvas = document.querySelector("canvas") ?? document.querySelector("eigen-shade")?.shadowRoot?.querySelector("canvas");
      const half = canvas.width >> 1;
      return canvas.width > 1 && canvas.getContext("2d").getImageData(half, half, 1, 1).data[3] === 255;
    });
    await page.waitForTimeout(200);
    const [red, , blue] = await middle();
    assert.ok(red > 1.2 * blue, `${color}: ${await middle()}`);
    assert.deepEqual(faults, []);
    // Chromium takes the fastest variant.
    assert.deepEqual(modules, ["eigenshade.sources.relaxed.wasm"]);
    await page.close();
  }
  server.close();
});

test("the program of README.md draws a .glb by three.js", async () => {
  const program = examples("js").find((text) => text.includes("watch.glb"));
  assert.ok(program.split("\n").filter((line) => line && !line.startsWith("import")).length <= 10);
  symlinkSync(join(PACKAGE, "node_modules/three"), join(folder, "node_modules/three"));
  const imports = {
    eigenshade: "/node_modules/eigenshade/dist/index.js", "eigenshade/three": "/node_modules/eigenshade/dist/three.js",
    three: "/node_modules/three/build/three.module.js", "three/addons/": "/node_modules/three/examples/jsm/",
  };
  const copper = { pbrMetallicRoughness: { baseColorFactor: [0.9, 0.4, 0.2, 1], roughnessFactor: 0.4 } };
  const server = await serve({
    "/": `<!doctype html><link rel=icon href=data:,><script type="importmap">${JSON.stringify({ imports })}</script>
      <canvas></canvas><script type="module">${program}</script>`,
    "/watch.glb": glb({ material: copper }),
  }, pathToFileURL(`${folder}/`));
  const page = await browser.newPage();
  const faults = [];
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
  await page.goto(server.address);
  const middle = () => page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const copy = new OffscreenCanvas(300, 150).getContext("2d");
    copy.drawImage(document.querySelector("canvas"), 0, 0);
    resolve([...copy.getImageData(150, 75, 1, 1).data]);
  }))));
  let [red, , blue, opacity] = [0, 0, 0, 0];
  for (let turn = 0; turn < 200 && opacity < 255; turn++) [red, , blue, opacity] = await middle();
  assert.ok(opacity === 255 && red > 1.2 * blue && red > 20, `${red}, ${blue}, ${opacity}`);
  assert.deepEqual(faults, []);
  server.close();
  await page.close();
});

test("the program of README.md draws an object with its shadows", async () => {
  const program = examples("js").find((text) => text.includes("coin.bin"));
  writeFileSync(join(folder, "plate.obj"), plate());
  execFileSync(EIGENSHADE, ["pack-object", "plate.obj", "--shadows", "--material", "red-fabric2", "--size", "32", "--out", "coin.bin"], { cwd: folder, stdio: "pipe" });
  const imports = { eigenshade: "/node_modules/eigenshade/dist/index.js", "eigenshade/shadowed": "/node_modules/eigenshade/dist/shadowed.js" };
  const server = await serve({
    "/": `<!doctype html><link rel=icon href=data:,><script type="importmap">${JSON.stringify({ imports })}</script>
      <canvas></canvas><script type="module">${program}</script>`,
  }, pathToFileURL(`${folder}/`));
  const page = await browser.newPage();
  const [faults, modules] = [[], []];
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("request", (request) => request.url().endsWith(".wasm") && modules.push(request.url().split("/").at(-1)));
  await page.goto(server.address);
  await page.waitForFunction(() => document.querySelector("canvas").width === 32);
  const [red, , blue, opacity] = await page.evaluate(() => [...document.querySelector("canvas").getContext("2d").getImageData(4, 16, 1, 1).data]);
  assert.ok(opacity === 255 && red > 1.2 * blue && red > 20, `${red}, ${blue}, ${opacity}`);
  assert.deepEqual([faults, modules], [[], ["eigenshade.shadowed.wasm"]]);
  server.close();
  await page.close();
});

test("the declarations are those of a strict program", () => {
  symlinkSync(join(PACKAGE, "node_modules/@types"), join(folder, "node_modules/@types"));
  writeFileSync(join(folder, "use.mts"), `import { Preview, Scene, lightPreset, presetNames, sphere, type Truncation } from "eigenshade";
    import { EigenShade } from "eigenshade/element";
    import { EigenMaterial, type EigenOptions } from "eigenshade/three";
    import { ShadowedObject } from "eigenshade/shadowed";
    const coin: ShadowedObject = (await ShadowedObject.load(new ArrayBuffer(8))).light(await lightPreset("park")).turn({ yaw: 1 });
    coin.draw(document.createElement("canvas")).draw(new OffscreenCanvas(1, 1)).draw(new ImageData(coin.pixels({ tone: "linear" }), coin.width, coin.height), { exposure: coin.exposure() });
    // @ts-expect-error: no bytes
    await ShadowedObject.load("coin.bin");
    import { Group, MeshStandardMaterial, Quaternion } from "three";
    const options: EigenOptions = { view: "camera", exposure: 2, lightRotation: new Quaternion() };
    const converted = async (scene: Scene): Promise<EigenMaterial[]> => [
      ...EigenMaterial.convert(new Group(), scene, options), EigenMaterial.from(new MeshStandardMaterial(), scene),
      new EigenMaterial(scene, { view: new Group(), exposure: "auto", roughness: 0.4 }).clone(),
    ];
    const element: EigenShade = document.createElement("eigen-shade");
    const shown: Preview | undefined = document.querySelector("eigen-shade")?.preview;
    element.light = await lightPreset("park");
    element.yaw = element instanceof EigenShade ? 30 : null;
    const scene: Scene = await Scene.create({ light: "park", material: { roughness: 0.3, metallic: 1 }, sources: 4, window: "none" });
    const drawn: number = scene.window("auto").window(9.5).sources + scene.windowWidth;
    const { r }: { r: Float32Array<ArrayBuffer> } = scene.turn({ yaw: 1 }).within(1e-2).shade([0], [0], [1]);
    const truncation: Truncation | undefined = scene.truncation;
    const preview: Promise<Preview> = Preview.create(document.createElement("canvas"), { light: "park", material: "chrome", tone: "filmic", sources: "auto", window: 12 });
    const pictures: ImageData[] = [scene.pixels([0], [0], [1]), sphere(scene, 1)].map((codes) => new ImageData(codes, 1, 1));
    const vectors: Float32Array<ArrayBuffer>[] = [scene.uniforms(), scene.eigenimage(0, [0], [0], [1]), scene.coefficients().r, r];
    const [x, y]: [readonly number[], Float64Array] = [[0], new Float64Array(1)];
    const shared: { r: Float32Array<SharedArrayBuffer> } = scene.shade(x, y, [1], one(new SharedArrayBuffer(4)));
    function one(buffer: SharedArrayBuffer) { const r = new Float32Array(buffer); return { r, g: r, b: r }; }
    const quaternion = { length: () => 1, *[Symbol.iterator]() { yield* [0, 0, 0, 1]; } };
    scene.turn(quaternion).turn([0, 0, 0, 1]).turn(new Float32Array(4).fill(1)).light({ r: [1], g: new Float32Array(1), b: [1], sources: null });
    // @ts-expect-error: no array
    scene.shade({ length: 1, 0: 0 }, [0], [1]);
    // @ts-expect-error: no array
    scene.light({ r: { length: 1, 0: 1 }, g: [1], b: [1] });
    // @ts-expect-error: neither a quaternion nor angles
    scene.turn({ length: 4, 0: 0, 1: 0, 2: 0, 3: 1 });
    // @ts-expect-error: there is no such choice
    await Scene.create({ light: "park", material: "chrome", sources: "all" });
    // @ts-expect-error: there is no such curve
    await preview.then((one) => one.look({ tone: "aces" }));
    export { converted, element, shown, drawn, pictures, vectors, shared, truncation, presetNames };`);
  const tsc = join(PACKAGE, "node_modules/.bin/tsc");
  const options = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", "--lib", "es2022,dom", "use.mts"];
  execFileSync(tsc, options, { cwd: folder, stdio: "pipe" });
  unlinkSync(join(folder, "node_modules/@types"));
});

test("the declarations are those of a program without a page, and of one with JSX", () => {
  const tsc = (name, program, ...options) => {
    writeFileSync(join(folder, name), program);
    const all = ["--noEmit", "--strict", "--target", "es2022", "--module", "nodenext", ...options, name];
    const { stdout } = spawnSync(join(PACKAGE, "node_modules/.bin/tsc"), all, { cwd: folder, encoding: "utf8" });
    assert.equal(stdout, "");
  };
  tsc("bare.mts", `import { ShadowedObject } from "eigenshade/shadowed";
    export const coin: Uint8ClampedArray = (await ShadowedObject.load(new Uint8Array(8))).pixels({ exposure: 2 });
    import { Scene, lightPreset, load, setAssets, sphere } from "eigenshade";
    setAssets(new Map<string, never>().get("") ?? "https://example.org/");
    const engine = await load(new Uint8Array(8));
    const scene = await Scene.create({ light: await lightPreset("park"), material: { roughness: 1 }, engine });
    export const pixels: Uint8ClampedArray = sphere(scene, 8);
    export const text: string = scene.glsl("block", { prefix: "a_" }) + scene.wgsl({ group: 1 });`,
  "--lib", "es2022");
  cpSync(join(PACKAGE, "node_modules/@types/react"), join(folder, "node_modules/@types/react"), { recursive: true });
  cpSync(join(PACKAGE, "node_modules/csstype"), join(folder, "node_modules/csstype"), { recursive: true });
  tsc("jsx.tsx", `import { EigenShade, type EigenShadeProps } from "eigenshade/react";
    import type { EigenShade as Element } from "eigenshade/element";
    import { createRef } from "react";
    const ref = createRef<Element>();
    const props: EigenShadeProps = { light: { r: [1], g: [1], b: [1] }, material: null, baseColor: "#b87333", roughness: 0.4, style: { width: 60 } };
    export const component = <EigenShade ref={ref} {...props} yaw={30} sources="auto" window={12} exposure={2} className="large" title="copper"
      onLoad={({ type }) => console.log(type, ref.current?.preview)} onError={({ message }) => console.log(message)}><img alt="" /></EigenShade>;
    // @ts-expect-error: no number of degrees
    export const degrees = <EigenShade yaw="30" />;
    // @ts-expect-error: there is no such curve
    export const curve = <EigenShade tone="aces" />;
    export const shown = <eigen-shade ref={ref} light={{ r: [1], g: [1], b: [1] }} material="nylon" yaw={30} sources="auto" window="none" className="large"
      tone="filmic" onload={() => ref.current?.preview?.turn({ yaw: 1 })} onerror={({ message }) => console.log(message)} />;
    export const copper = <eigen-shade base-color="#b87333" metallic={1} exposure="auto" />;
    // @ts-expect-error: React calls this for its own elements alone
    export const silent = <eigen-shade onLoad={() => {}} />;
    // @ts-expect-error: there is no such curve
    export const wrong = <eigen-shade tone="aces" />;`,
  "--lib", "es2022,dom", "--jsx", "react-jsx", "--types", "react");
});

/** Bytes of each module with gzip -9: its code, and all, with the tables. */
const MODULES = {
  "eigenshade.relaxed.wasm": [19262, 72919],
  "eigenshade.shadowed.wasm": [9548, 16611],
  "eigenshade.simd.wasm": [19219, 72880],
  "eigenshade.sources.relaxed.wasm": [23624, 77655],
  "eigenshade.sources.simd.wasm": [23584, 77605],
  "eigenshade.sources.wasm": [22460, 76285],
  "eigenshade.wasm": [18084, 71855],
};

// Debian's compiler makes a module whose code is 5 % larger.
const isNear = (bytes, stated) => Math.abs(stated - bytes) <= 0.06 * bytes;

test("README.md states the sizes of the entries", () => {
  for (const [name, ...bytes] of sizes()) {
    const line = README.split("\n").find((text) => text.startsWith(`| ${name} |`));
    const stated = line?.split("|").slice(2, 5).map((text) => Number(text.replaceAll(",", "")));
    assert.ok(bytes.every((one, k) => isNear(one, stated?.[k])), `${name}: ${bytes} bytes, not ${stated}`);
  }
});

test("the sizes of the modules and of the largest presets", () => {
  const inside = (path) => join(PACKAGE, path);
  const modules = readdirSync(inside("wasm"));
  assert.deepEqual(modules.toSorted(), Object.keys(MODULES));
  for (const name of modules) {
    const module = readFileSync(inside(`wasm/${name}`));
    const bytes = [moduleSizes(module).zipped, gzipSync(module, { level: 9 }).length];
    assert.ok(bytes.every((one, k) => isNear(one, MODULES[name][k])), `${name}: ${bytes} bytes, not ${MODULES[name]}`);
  }
  const largest = ["light", "sources", "material"].map((kind) =>
    Math.max(...readdirSync(inside(`presets/${kind}`)).map((name) => statSync(inside(`presets/${kind}/${name}`)).size)));
  assert.deepEqual(largest, [1200, 680, 520]);
});

// In pages of others: React, Vue, frames, policies, two copies of the package.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";
import { launch, serve } from "./support/browser.js";

const FOLDER = fileURLToPath(new URL(".", import.meta.url));
const STYLE = "<style>canvas, eigen-shade { width: 60px; height: 60px }</style>";
const POLICY = `<meta http-equiv="Content-Security-Policy" content="require-trusted-types-for 'script'; trusted-types 'none'">`;

/** A library as one script, in the build for development. */
async function library(contents) {
  const { outputFiles } = await esbuild.build({
    stdin: { contents, resolveDir: FOLDER }, bundle: true, format: "esm", write: false, define: { "process.env.NODE_ENV": '"development"' },
  });
  return outputFiles[0].contents;
}

let browser, server;
const faults = [];

before(async () => {
  server = await serve({
    "/": `<!doctype html><link rel=icon href=data:,>${STYLE}<canvas></canvas><canvas></canvas><div id=root></div>`,
    "/trusted.html": `<!doctype html><link rel=icon href=data:,>${POLICY}${STYLE}<script type="module" src="/src/element.js"></script><eigen-shade></eigen-shade>`,
    "/react.js": await library('export { StrictMode, createElement, useEffect, useRef } from "react"; export { createRoot } from "react-dom/client";'),
    "/vue.js": await library('export { reactive, isReactive } from "@vue/reactivity";'),
  });
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
  assert.deepEqual(faults, []);
});

/** What a function returns in a page. */
async function inPage(run, path = "/") {
  const page = await browser.newPage();
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  await page.addInitScript(() => {
    const middle = (canvas) => canvas.getContext("2d").getImageData(canvas.width >> 1, canvas.height >> 1, 1, 1).data;
    window.look = { light: "park", material: "red-fabric2" };
    window.isRed = (canvas) => middle(canvas)[3] === 255 && middle(canvas)[0] > 1.2 * middle(canvas)[2];
    window.next = (element, event) =>
      new Promise((resolve, reject) => {
        element.addEventListener(event, resolve, { once: true });
        setTimeout(() => reject(new Error(`no ${event}`)), 20000);
        const other = event === "load" ? "error" : "load";
        element.addEventListener(other, (said) => reject(new Error(`${other}: ${said.message}`)), { once: true });
      });
    window.until = async (isDone) => {
      for (let k = 0; k < 500 && !isDone(); k++) await new Promise((resolve) => setTimeout(resolve, 10));
    };
  });
  await page.goto(`${server.address}${path}`);
  try {
    return await page.evaluate(run);
  } finally {
    await page.close();
  }
}

test("the last preview of a canvas wins, and a signal ends one", async () => {
  const found = await inPage(async () => {
    const { Preview, Scene } = await import("/src/index.js");
    const [canvas, other] = document.querySelectorAll("canvas");
    const said = (promise) => promise.then(() => "drawn", ({ name, message }) => `${name}: ${message}`);
    const isFreed = (preview) => {
      try {
        preview.draw();
        return false;
      } catch {
        return true;
      }
    };
    const found = [];
    const scene = await Scene.create({ light: { r: [1], g: [1], b: [1] }, material: { roughness: 1 } });
    // The first one comes later than the second: it fetches.
    const late = said(Preview.create(canvas, look));
    const second = new Preview(canvas, scene);
    found.push(await late, isFreed(second));
    const third = await Preview.create(canvas, look);
    found.push(isFreed(second), isFreed(third), isRed(canvas));
    // One that fails leaves the one before.
    found.push(await said(Preview.create(canvas, { ...look, light: "parc" })), isFreed(third));
    third.free();
    // A signal that is aborted before, while it loads, and after.
    const before = AbortSignal.abort();
    found.push(await said(Preview.create(canvas, { ...look, signal: before })));
    const [during, later] = [new AbortController(), new AbortController()];
    const loading = said(Preview.create(other, { ...look, material: "chrome", signal: during.signal }));
    during.abort(new Error("left"));
    found.push(await loading);
    const ended = await Preview.create(other, { ...look, signal: later.signal });
    found.push(isFreed(ended));
    later.abort();
    found.push(isFreed(ended));
    return found;
  });
  assert.deepEqual(found, [
    "AbortError: Preview: a later preview has the canvas", false,
    true, false, true,
    'RangeError: no light is called "parc"; did you mean park?', false,
    "AbortError: signal is aborted without reason",
    "Error: left",
    false, true,
  ]);
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

test("React in strict mode: previews, properties and events", async () => {
  const found = await inPage(async () => {
    const { StrictMode, createElement, createRoot, useEffect, useRef } = await import("/react.js");
    const { Preview, Scene, lightPreset, sphere } = await import("/src/index.js");
    const { EigenShade } = await import("/src/element.js");
    const said = [];
    const Sphere = ({ hasSignal }) => {
      const canvas = useRef(null);
      useEffect(() => {
        const end = new AbortController();
        const options = hasSignal ? { ...look, signal: end.signal } : look;
        Preview.create(canvas.current, options).then(
          () => said.push(`drawn ${isRed(canvas.current)}`),
          ({ name }) => said.push(name),
        );
        return () => end.abort();
      }, []);
      return createElement("canvas", { ref: canvas });
    };
    const light = await lightPreset("studio");
    const events = [];
    const Element = ({ tone }) =>
      createElement("eigen-shade", {
        light, material: { baseColor: "#b87333", metallic: 1 }, yaw: 30, exposure: 2, tone,
        onload: () => events.push("load"), onerror: ({ message }) => events.push(message),
      });
    const root = createRoot(document.querySelector("#root"));
    const render = (tone) =>
      root.render(
        createElement(StrictMode, null, createElement(Sphere, { hasSignal: true }), createElement(Sphere, { hasSignal: false }), createElement(Element, { tone })),
      );
    render("linear");
    await until(() => said.length === 4 && events.length === 1);
    render("aces");
    await until(() => events.length === 2);
    const element = document.querySelector("eigen-shade");
    const canvas = element.shadowRoot.querySelector("canvas");
    const scene = await Scene.create({ light: "studio", material: { baseColor: "#b87333", metallic: 1 }, window: "auto" });
    scene.turn({ yaw: Math.PI / 6 });
    const expected = sphere(scene, 60, { exposure: 2, tone: "linear" });
    const found = canvas.getContext("2d").getImageData(0, 0, 60, 60).data;
    const most = Math.max(...found.map((code, k) => (found[k | 3] === 255 ? Math.abs(code - expected[k]) : 0)));
    const isElement = element instanceof EigenShade;
    root.unmount();
    return { said: said.sort(), events, most, isElement };
  });
  // Without a signal the first of the two is freed, or it comes too late.
  const { said, events, most, isElement } = found;
  assert.equal(said.filter((one) => one === "drawn true").length >= 2, true, `${said}`);
  assert.ok(said.every((one) => one === "drawn true" || one === "AbortError"), `${said}`);
  assert.ok(said.includes("AbortError"));
  assert.deepEqual(events, ["load", 'look: "aces" is not one of linear, reinhard, filmic']);
  assert.ok(most <= 1, `${most}`);
  assert.ok(isElement);
});

test("objects that Vue watches", async () => {
  const found = await inPage(async () => {
    const { reactive, isReactive } = await import("/vue.js");
    const { Preview, Scene, load } = await import("/src/index.js");
    const engine = await load(fetch("/wasm/eigenshade.wasm"));
    const inputs = reactive({ light: { r: [1], g: [1], b: [1] }, material: { baseColor: [1, 0, 0], roughness: 1 }, engine });
    const state = reactive({ scene: await Scene.create(inputs), preview: await Preview.create(document.querySelector("canvas"), look) });
    state.preview.turn({ yaw: 1 });
    state.preview.scene.material(inputs.material);
    await state.preview.light(inputs.light);
    const { r, g } = state.scene.turn(reactive({ yaw: 1 })).shade([0], [0], [1]);
    return [isReactive(inputs.light), isReactive(state.preview), r[0] > g[0]];
  });
  assert.deepEqual(found, [true, false, true]);
});

test("a canvas and an element of another document", async () => {
  const found = await inPage(async () => {
    const { Preview } = await import("/src/index.js");
    await import("/src/element.js");
    const frame = document.createElement("iframe");
    document.body.append(frame);
    const inner = frame.contentDocument;
    const canvas = inner.createElement("canvas");
    canvas.style.cssText = "width: 60px; height: 60px";
    inner.body.append(canvas);
    const preview = await Preview.create(canvas, look);
    const found = [canvas.width, isRed(canvas)];
    canvas.style.width = canvas.style.height = "80px";
    await until(() => canvas.width === 80);
    found.push(canvas.width);
    preview.free();
    const element = document.createElement("eigen-shade");
    element.setAttribute("material", "red-fabric2");
    document.body.append(element);
    await next(element, "load");
    const again = next(element, "load");
    inner.body.append(element);
    await again;
    const drawn = element.shadowRoot.querySelector("canvas");
    found.push(getComputedStyle(element).display, isRed(drawn));
    return found;
  });
  assert.deepEqual(found, [60, true, 80, "inline-block", true]);
});

test("a page that takes Trusted Types alone", async () => {
  const found = await inPage(async () => {
    const element = document.querySelector("eigen-shade");
    await until(() => element.preview);
    return element.shadowRoot.querySelector("canvas").width;
  }, "/trusted.html");
  assert.equal(found, 60);
});

test("two copies of the package define one element", async () => {
  const found = await inPage(async () => {
    const [one, other] = [await import("/src/element.js"), await import("/src/element.js?again")];
    const element = document.createElement("eigen-shade");
    return [one.EigenShade === other.EigenShade, element instanceof other.EigenShade];
  });
  assert.deepEqual(found, [true, true]);
});

test("an element's properties", async () => {
  const found = await inPage(async () => {
    const early = document.createElement("eigen-shade");
    early.material = { roughness: 0.4 };
    early.yaw = 20;
    document.body.append(early);
    await import("/src/element.js");
    await next(early, "load");
    const { lightPreset } = await import("/src/index.js");
    const found = [early.getAttribute("yaw"), early.yaw, early.material.roughness, early.light, early.hasAttribute("material")];
    const label = () => early.shadowRoot.querySelector("canvas").getAttribute("aria-label");
    const set = async (values, event = "load") => {
      const done = next(early, event);
      Object.assign(early, values);
      return (await done).message;
    };
    found.push(label());
    const studio = await lightPreset("studio", { sources: 4 });
    await set({ light: studio, material: "gold-metallic-paint" });
    found.push(label(), early.preview.scene.sources, early.light === studio);
    await set({ light: { r: [1], g: [1], b: [1] } });
    found.push(label(), early.preview.scene.sources);
    // The same object, changed.
    const { light } = early;
    const before = early.preview.scene.shade([0], [0], [1]).r[0];
    light.r[0] = 2;
    await set({ light });
    found.push(early.preview.scene.shade([0], [0], [1]).r[0] / before);
    // An attribute takes the place of the object.
    const done = next(early, "load");
    early.setAttribute("light", "lobby");
    await done;
    found.push(early.light, label());
    found.push(await set({ baseColor: "#ff0000" }, "error"));
    await set({ material: null });
    found.push(early.baseColor, label());
    await set({ baseColor: undefined, exposure: 2 });
    found.push(early.hasAttribute("base-color"), early.exposure);
    found.push(await set({ yaw: {} }, "error"));
    return found;
  });
  assert.deepEqual(found, [
    "20", 20, 0.4, null, false, "A sphere of a glTF material under the light park",
    "A sphere of gold-metallic-paint under the light studio", 4, true,
    "A sphere of gold-metallic-paint under a light", 0,
    2,
    "lobby", "A sphere of gold-metallic-paint under the light lobby",
    "base-color is beside material; leave out one of them",
    "#ff0000", "A sphere of a glTF material under the light lobby",
    false, 2,
    'yaw="[object Object]" is not a number',
  ]);
});

test("a canvas has a role and a label, unless the page gives them", async () => {
  const found = await inPage(async () => {
    const { Preview } = await import("/src/index.js");
    const [canvas, other] = document.querySelectorAll("canvas");
    const said = (canvas) => [canvas.getAttribute("role"), canvas.getAttribute("aria-label")];
    const preview = await Preview.create(canvas, look);
    const found = [said(canvas)];
    await preview.light("lobby");
    preview.draw();
    found.push(said(canvas));
    preview.free();
    await Preview.create(canvas, { light: "park", material: "chrome" });
    found.push(said(canvas));
    other.setAttribute("role", "presentation");
    other.setAttribute("aria-label", "a fabric");
    await Preview.create(other, look);
    found.push(said(other));
    return found;
  });
  assert.deepEqual(found, [
    ["img", "A sphere of red-fabric2 under the light park"],
    ["img", "A sphere of red-fabric2 under the light lobby"],
    ["img", "A sphere of chrome under the light park"],
    ["presentation", "a fabric"],
  ]);
});

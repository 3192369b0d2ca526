// `eigenshade/react`: the component in strict mode, on a server and hydrated.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import * as esbuild from "esbuild";
import { createElement } from "react";
import { renderToString } from "react-dom/server";
import { EigenShade } from "../src/react.js";
import { launch, serve } from "./support/browser.js";

const PROPS = { light: { r: [3], g: [2], b: [1] }, yaw: 30, className: "large", style: { width: 60, height: 60 }, title: "a ball" };

/** The component of README.md. */
const [, BALL] = readFileSync(new URL("../README.md", import.meta.url), "utf8").match(/```jsx\n(.*?)```/s);

let browser, server;

/** A program as one script, with React in the build for development. */
async function script(contents) {
  const { outputFiles } = await esbuild.build({
    stdin: { contents, resolveDir: fileURLToPath(new URL(".", import.meta.url)), loader: "jsx" },
    bundle: true, format: "esm", write: false, define: { "process.env.NODE_ENV": '"development"' },
    jsx: "automatic", alias: { "eigenshade/react": fileURLToPath(new URL("../src/react.js", import.meta.url)) },
  });
  return outputFiles[0].contents;
}

before(async () => {
  const page = (content) => `<!doctype html><link rel=icon href=data:,>
    <script type="importmap">{ "imports": { "react": "/react.js" } }</script><div id=root>${content}</div>`;
  server = await serve({
    "/react.js": await script(`
      export { StrictMode, createElement, createRef, useImperativeHandle, useLayoutEffect, useRef } from "react";
      export { flushSync } from "react-dom";
      export { createRoot, hydrateRoot } from "react-dom/client";`),
    "/ball.js": await script(`import { createRoot } from "react-dom/client";
      ${BALL}
      export const show = (root) => createRoot(root).render(<Ball angle={30} />);`),
    "/": page(""),
    "/rendered.html": page(renderToString(createElement(EigenShade, { ...PROPS, onLoad: () => {} }))),
  });
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** What a function returns in a page, which reports no error. `window.contexts` counts those of WebGL. */
async function inPage(run, path = "/") {
  const page = await browser.newPage();
  const faults = [];
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  await page.addInitScript((props) => {
    window.props = props;
    window.contexts = 0;
    for (const { prototype } of [OffscreenCanvas, HTMLCanvasElement]) {
      const { getContext } = prototype;
      prototype.getContext = function (kind, ...options) {
        window.contexts += /webgl|webgpu/.test(kind);
        return getContext.call(this, kind, ...options);
      };
    }
    window.until = async (isDone) => {
      for (let k = 0; k < 1000 && !isDone(); k++) await new Promise((resolve) => setTimeout(resolve, 10));
      if (!isDone()) throw new Error(`never: ${isDone}`);
    };
    window.pause = () => new Promise((resolve) => setTimeout(resolve, 200));
    window.pixels = (element) => {
      const canvas = element.shadowRoot.querySelector("canvas");
      return [...canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data];
    };
    /** The largest difference of a picture from one of the CPU, inside the outline. */
    window.difference = (found, expected) =>
      Math.max(...found.map((code, k) => (found[k | 3] === 255 ? Math.abs(code - expected[k]) : 0)));
  }, PROPS);
  await page.goto(`${server.address}${path}`);
  try {
    return await page.evaluate(run);
  } finally {
    await page.close();
    assert.deepEqual(faults, []);
  }
}

test("in strict mode: pictures, changes and errors", async () => {
  const found = await inPage(async () => {
    const { StrictMode, createElement, createRef, createRoot } = await import("/react.js");
    const { Scene, sphere } = await import("/src/index.js");
    const { EigenShade } = await import("/src/react.js");
    const root = createRoot(document.querySelector("#root"));
    const [events, ref] = [[], createRef()];
    const render = (more, name = "load") =>
      root.render(createElement(StrictMode, null, createElement(EigenShade, {
        light: { r: [3], g: [2], b: [1] }, material: { baseColor: "#b87333", metallic: 1 }, exposure: 2, tone: "linear", ref,
        className: "large", style: { width: 60, height: 60 }, ...more,
        onLoad: ({ target }) => events.push(target === ref.current && name), onError: ({ message }) => events.push(message),
      })));
    const expected = async (material, exposure = 2) => {
      const scene = await Scene.create({ light: { r: [3], g: [2], b: [1] }, material, window: "auto" });
      return sphere(scene, 60, { exposure, tone: "linear" });
    };
    render();
    await until(() => events.length === 1);
    const copper = await expected({ baseColor: "#b87333", metallic: 1 });
    const found = [ref.current.className, ref.current.tagName, difference(pixels(ref.current), copper) <= 1];
    // New objects and functions of equal value draw nothing anew.
    render({}, "again");
    await pause();
    found.push(events.length);
    render({ exposure: 3 }, "exposed");
    await until(() => events.length === 2);
    found.push(difference(pixels(ref.current), await expected({ baseColor: "#b87333", metallic: 1 }, 3)) <= 1);
    // A property that is left out has its default.
    render({ material: undefined, baseColor: "#ff0000" });
    await until(() => events.length === 3);
    found.push(difference(pixels(ref.current), await expected({ baseColor: "#ff0000" })) <= 1);
    const before = pixels(ref.current);
    render({ material: undefined, baseColor: "#ff0000", tone: "aces" });
    await until(() => events.length === 4);
    render({ material: undefined, baseColor: "#ff0000", yaw: NaN });
    await until(() => events.length === 5);
    found.push(difference(pixels(ref.current), before), events);
    root.unmount();
    return [...found, ref.current];
  });
  assert.deepEqual(found, [
    "large", "EIGEN-SHADE", true, 1, true, true, 0,
    ["load", "exposed", "load", 'look: "aces" is not one of linear, reinhard, filmic', 'yaw="NaN" is not a number'],
    null,
  ]);
});

test("mounted, unmounted and mounted again: one WebGL context, previews freed", async () => {
  const found = await inPage(async () => {
    const { StrictMode, createElement, createRoot, flushSync } = await import("/react.js");
    const { EigenShade } = await import("/src/react.js");
    const events = [];
    const isFreed = (preview) => {
      try {
        preview.draw();
        return false;
      } catch {
        return true;
      }
    };
    const element = (key) => createElement(EigenShade, {
      key, light: "park", material: "red-fabric2", style: props.style,
      onLoad: () => events.push(key), onError: ({ message }) => events.push(message),
    });
    const previews = [];
    for (let k = 0; k < 20; k++) {
      const root = createRoot(document.querySelector("#root"));
      root.render(createElement(StrictMode, null, element(1), element(2)));
      await until(() => events.length === 2 * (k + 1));
      const elements = [...document.querySelectorAll("eigen-shade")];
      previews.push(...elements.map(({ preview }) => preview));
      root.unmount();
      if (elements.some(({ preview }) => preview)) throw new Error("a preview is left");
    }
    // One that leaves the page while it loads says nothing.
    const root = createRoot(document.querySelector("#root"));
    flushSync(() => root.render(createElement(StrictMode, null, element(3))));
    const late = document.querySelector("eigen-shade");
    late.addEventListener("load", () => events.push(3));
    root.unmount();
    await pause();
    return [events.includes(3), late.preview === undefined, previews.every(isFreed), previews.length, contexts];
  });
  assert.deepEqual(found, [false, true, true, 40, 1]);
});

test("rendered on a server and hydrated", async () => {
  assert.equal(
    renderToString(createElement(EigenShade, { ...PROPS, onLoad: () => {} })),
    '<eigen-shade class="large" style="width:60px;height:60px" title="a ball"></eigen-shade>',
  );
  const found = await inPage(async () => {
    const { createElement, hydrateRoot } = await import("/react.js");
    const { EigenShade } = await import("/src/react.js");
    const rendered = document.querySelector("eigen-shade");
    let loads = 0;
    hydrateRoot(document.querySelector("#root"), createElement(EigenShade, { ...props, onLoad: () => loads++ }));
    await until(() => loads > 0);
    await pause();
    const [red, , blue] = pixels(rendered).slice(4 * (30 * 60 + 30));
    return [loads, document.querySelector("eigen-shade") === rendered, rendered.yaw, red > blue];
  }, "/rendered.html");
  assert.deepEqual(found, [1, true, 30, true]);
});

test("the component of README.md", async () => {
  const found = await inPage(async () => {
    const { show } = await import("/ball.js");
    const said = [];
    console.log = (text) => said.push(text);
    show(document.querySelector("#root"));
    await until(() => said.length > 0);
    const { className, yaw } = document.querySelector("eigen-shade");
    return [said, className, yaw];
  });
  assert.deepEqual(found, [["drawn"], "ball", 30]);
});

test("a script for clients, in a line that compilers of server components read", async () => {
  const script = await (await fetch(`${server.address}/dist/react.js`)).text();
  assert.match(script, /^"use client";/);
});

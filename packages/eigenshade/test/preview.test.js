// Previews and elements in a browser.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, beforeEach, test } from "node:test";
import { launch, serve } from "./support/browser.js";
import { EIGENSHADE } from "./support/own.js";

const PAGE = `<!doctype html><link rel=icon href=data:,><title>Previews</title>
<style>canvas { width: 120px; height: 120px }</style><canvas></canvas><canvas></canvas>`;

const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");

let browser, server, page;
const faults = [];

before(async () => {
  server = await serve({ "/": PAGE });
  browser = await launch();
});

beforeEach(async () => {
  await page?.close();
  page = await open();
});

after(async () => {
  await browser?.close();
  server?.close();
  assert.deepEqual(faults, []);
});

/** A page with `eigenshade`, and `pixels` of a canvas. */
async function open(script = () => {}, options = {}) {
  const page = await browser.newPage(options);
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  // A clock that stands still: WebGL in software is slower than the CPU, which would draw instead.
  await page.addInitScript(() => (performance.now = () => 0));
  await page.addInitScript(script);
  await page.goto(`${server.address}/`);
  await page.evaluate(async () => {
    window.eigenshade = await import("/src/index.js");
    window.canvases = [...document.querySelectorAll("canvas")];
    window.pixels = (canvas) =>
      canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
    window.frame = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    /** The largest difference, of pixels that the outline does not cross. */
    window.difference = (one, other) => {
      let most = 0;
      for (let k = 0; k < one.length; k++) {
        if (one[k | 3] === 255 && other[k | 3] === 255) most = Math.max(most, Math.abs(one[k] - other[k]));
        if ((k & 3) === 3) most = Math.max(most, Math.abs(one[k] - other[k]));
      }
      return most;
    };
  });
  return page;
}

test("a preview is the sphere that the module draws, to one code", async () => {
  for (const tone of ["linear", "reinhard", "filmic"]) {
    const { found, lit, size } = await page.evaluate(async (tone) => {
      const { Preview, sphere } = eigenshade;
      const look = { exposure: 2, tone };
      const preview = await Preview.create(canvases[0], { light: "lobby", material: "red-fabric2", ...look });
      const [shown, computed] = [pixels(canvases[0]), sphere(preview.scene, 120, look)];
      preview.free();
      return {
        found: difference(shown, computed),
        lit: Math.max(...shown.filter((_, k) => k % 4 === 0)),
        size: canvases[0].width,
      };
    }, tone);
    assert.ok(found <= 1, `${tone}: ${found}`);
    assert.ok(lit > 100 && size === 120);
  }
});

test("a preview with sources is the sphere that the module draws, to one code", async () => {
  const { found, fewer, still, none, rejected } = await page.evaluate(async () => {
    const { Preview, Scene, sphere } = eigenshade;
    const [material, look] = ["blue-metallic-paint", { exposure: 2, tone: "linear" }];
    const preview = await Preview.create(canvases[0], { light: "lobby", material, sources: 8, ...look });
    const against = async (sources) => {
      const scene = await Scene.create({ light: "sunset", material, sources });
      preview.draw();
      return [preview.scene.sources, difference(pixels(canvases[0]), sphere(scene, 120, look))];
    };
    await preview.light("sunset");
    const found = await against(8);
    await preview.light("sunset", { sources: 2 });
    const fewer = await against(2);
    // A light that is not set changes no number of sources.
    await preview.light("sunsets", { sources: 8 }).catch(() => {});
    await preview.light("sunset");
    const still = await against(2);
    const rejected = await preview.light("sunset", { sources: -1 }).catch(({ message }) => message);
    await preview.light("sunset", { sources: 0 });
    const none = await against(0);
    preview.free();
    return { found, fewer, still, none, rejected };
  });
  for (const [[count, off], sources] of [[found, 8], [fewer, 2], [still, 2], [none, 0]]) {
    assert.equal(count, sources);
    assert.ok(off <= 1, `${sources} sources: ${off}`);
  }
  assert.equal(rejected, 'sources: -1 is neither "auto" nor a whole number, 0 or more');
});

test("a preview of a light and a material is as bright as what the program renders", async () => {
  const file = join(mkdtempSync(join(tmpdir(), "eigenshade-")), "picture.png");
  // Metered by the brightest hundredth, by the median, and by the brightest tenth.
  for (const [light, material] of [["park", "red-fabric2"], ["studio", "gold-metallic-paint"], ["night", "chrome-steel"]]) {
    const all = ["render", "-l", light, "-m", material, "--table", "color", "--size", "120", "--out", file];
    execFileSync(EIGENSHADE, all, { stdio: "ignore" });
    const picture = `data:image/png;base64,${readFileSync(file, "base64")}`;
    const [found, expected] = await page.evaluate(async ([light, material, picture]) => {
      const preview = await eigenshade.Preview.create(canvases[0], { light, material, tone: "linear" });
      const program = document.createElement("canvas");
      [program.width, program.height] = [120, 120];
      program.getContext("2d").drawImage(await createImageBitmap(await (await fetch(picture)).blob()), 0, 0);
      const brightness = [canvases[0], program].map((canvas) => {
        const codes = pixels(canvas);
        const largest = [];
        for (let k = 0; k < codes.length; k += 4) {
          if (codes[k + 3] === 255) largest.push(Math.max(codes[k], codes[k + 1], codes[k + 2]));
        }
        largest.sort((one, other) => one - other);
        const at = (share) => largest[Math.floor(share * largest.length)] / 255;
        const linear = (share) => ((at(share) + 0.055) / 1.055) ** 2.4;
        return [0.25, 0.5, 0.75].map(linear);
      });
      preview.free();
      return brightness;
    }, [light, material, picture]);
    // The program meters in steps of 7 %, all pixels; codes have 8 bits.
    found.forEach((value, k) => assert.ok(Math.abs(value / expected[k] - 1) < 0.1, `${light}, ${material}: ${found}, ${expected}`));
  }
});

test("two previews share a context and do not disturb each other", async () => {
  const { contexts, before, after, same } = await page.evaluate(async () => {
    const { Preview } = eigenshade;
    let contexts = 0;
    const { getContext } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.getContext = function (...all) {
      contexts++;
      return getContext.apply(this, all);
    };
    const [one, other] = await Promise.all([
      Preview.create(canvases[0], { light: "lobby", material: "red-fabric2" }),
      Preview.create(canvases[1], { light: "park", material: "gold-metallic-paint" }),
    ]);
    const before = difference(pixels(canvases[0]), pixels(canvases[1]));
    const first = pixels(canvases[0]);
    other.turn({ yaw: 1 });
    await other.material({ baseColor: "#b87333", metallic: 1, roughness: 0.4 });
    await frame();
    one.draw();
    const same = difference(first, pixels(canvases[0]));
    await other.light("lobby");
    await other.turn([0, 0, 0, 1]).material("red-fabric2");
    await frame();
    return { contexts, before, after: difference(pixels(canvases[0]), pixels(canvases[1])), same };
  });
  assert.equal(contexts, 1);
  assert.ok(before > 20);
  assert.equal(same, 0);
  assert.equal(after, 0);
});

test("changes are drawn in the next frame, as large as the canvas is shown", async () => {
  const { sizes, turned } = await page.evaluate(async () => {
    const [canvas] = canvases;
    const preview = await eigenshade.Preview.create(canvas, { light: "studio", material: "red-fabric2" });
    const before = pixels(canvas);
    preview.turn({ yaw: 1 });
    await frame();
    const turned = difference(before, pixels(canvas));
    const sizes = [canvas.width];
    canvas.style.width = canvas.style.height = "77px";
    await frame();
    sizes.push(canvas.width);
    return { sizes, turned };
  });
  assert.ok(turned > 20);
  assert.deepEqual(sizes, [120, 77]);
});

test("a canvas of any shape, with or without a size in CSS, on a dense screen", async () => {
  const dense = await open(undefined, { deviceScaleFactor: 2 });
  const found = await dense.evaluate(async () => {
    const sizes = [];
    canvases[0].style.cssText = "width: 200px; height: 100px";
    canvases[1].style.cssText = "width: auto; height: auto";
    for (const canvas of canvases) {
      await eigenshade.Preview.create(canvas, { light: "lobby", material: "red-fabric2" });
      for (let k = 0; k < 5; k++) await frame();
      const at = (x, y) => canvas.getContext("2d").getImageData(x * canvas.width, y * canvas.height, 1, 1).data[3];
      sizes.push([canvas.width, canvas.height, canvas.clientWidth, canvas.clientHeight]);
      sizes.push([at(0.5, 0.5), at(0.27, 0.5), at(0.2, 0.5), at(0.7, 0.5), at(0.8, 0.5)]);
    }
    return sizes;
  });
  const centered = [255, 255, 0, 255, 0];
  assert.deepEqual(found, [[400, 200, 200, 100], centered, [600, 300, 300, 150], centered]);
  await dense.close();
});

test("a canvas with padding or more pixels than are drawn keeps its shape", async () => {
  const found = await page.evaluate(async () => {
    const sizes = [];
    const look = { light: "lobby", material: "red-fabric2" };
    for (const style of [
      "width: 120px; height: 80px; padding: 10px 20px", "width: 5000px; height: 2500px",
      "width: 120px; height: 80px; padding: 10px 20px; border: 1px solid; box-sizing: border-box",
      "width: auto; height: auto; padding: 10px", "width: 20px; height: 20px; padding: 10px; box-sizing: border-box",
    ]) {
      const canvas = document.createElement("canvas");
      canvas.style.cssText = style;
      document.body.append(canvas);
      const preview = await eigenshade.Preview.create(canvas, look);
      for (let k = 0; k < 3; k++) await frame();
      sizes.push([canvas.width, canvas.height]);
      preview.free();
      canvas.remove();
    }
    return sizes;
  });
  // The last one has no place for a picture: it is as it was.
  assert.deepEqual(found, [[120, 80], [4096, 2048], [78, 58], [300, 150], [300, 150]]);
});

test("a canvas is drawn anew when the screen's density changes, until the preview is freed", async () => {
  const session = await page.context().newCDPSession(page);
  // The emulation tells media queries of a new density only with a new width of the page.
  const dense = (deviceScaleFactor) =>
    session.send("Emulation.setDeviceMetricsOverride", { width: 700 + 100 * deviceScaleFactor, height: 600, deviceScaleFactor, mobile: false });
  const width = () => page.evaluate(() => frame().then(() => canvases[0].width));
  await page.evaluate(async () => {
    window.preview = await eigenshade.Preview.create(canvases[0], { light: "lobby", material: "red-fabric2" });
  });
  const found = [await width()];
  for (const density of [2, 1.5, 1]) {
    await dense(density);
    found.push(await width());
  }
  await page.evaluate(() => preview.free());
  await dense(3);
  assert.deepEqual([...found, await width()], [120, 240, 180, 120, 120]);
});

test("what a look leaves out stays", async () => {
  const found = await page.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], { light: "lobby", material: "red-fabric2", exposure: 3, tone: "linear" });
    const before = pixels(canvases[0]);
    preview.look({ exposure: undefined, tone: undefined }).look({}).draw();
    return difference(before, pixels(canvases[0]));
  });
  assert.equal(found, 0);
});

test("the last of several lights wins, whichever comes first", async () => {
  const found = await page.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], { light: "studio", material: "red-fabric2" });
    await Promise.all([preview.light("park"), preview.light(await eigenshade.lightPreset("lobby"))]);
    await frame();
    const other = await eigenshade.Preview.create(canvases[1], { light: "lobby", material: "red-fabric2" });
    other.draw();
    return difference(pixels(canvases[0]), pixels(canvases[1]));
  });
  assert.equal(found, 0);
});

test("input that fails does not keep an earlier one from being set", async () => {
  const found = await page.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], { light: "studio", material: "red-fabric2" });
    const good = preview.light("lobby");
    const [light, material] = [preview.light("parc"), preview.material({ roughness: 2 })];
    const other = preview.material("gold-metallic-paint");
    const failed = (await Promise.allSettled([light, material])).map(({ status }) => status);
    await Promise.all([good, other]);
    preview.draw();
    const same = await eigenshade.Preview.create(canvases[1], { light: "lobby", material: "gold-metallic-paint" });
    return [failed, difference(pixels(canvases[0]), pixels(same && canvases[1]))];
  });
  assert.deepEqual(found, [["rejected", "rejected"], 0]);
});

test("a canvas that is not shown yet is drawn once it is", async () => {
  const found = await page.evaluate(async () => {
    const canvas = document.createElement("canvas");
    await eigenshade.Preview.create(canvas, { light: "lobby", material: "red-fabric2" });
    const before = canvas.width;
    document.body.append(canvas);
    canvas.style.cssText = "width: auto; height: auto";
    for (let k = 0; k < 5; k++) await frame();
    return [before, canvas.width, canvas.height, pixels(canvas)[4 * (75 * 300 + 150) + 3]];
  });
  assert.deepEqual(found, [300, 300, 150, 255]);
});

test("a lost context comes back, and the CPU draws until then", async () => {
  const { lost, back } = await page.evaluate(async () => {
    const { renderer } = await import("/src/renderer.js");
    const preview = await eigenshade.Preview.create(canvases[0], { light: "studio", material: "red-fabric2" });
    const before = pixels(canvases[0]);
    const extension = renderer().context.getExtension("WEBGL_lose_context");
    extension.loseContext();
    preview.draw();
    const lost = difference(before, pixels(canvases[0]));
    const restored = new Promise((resolve) => renderer().restored.addEventListener("restored", resolve));
    canvases[0].getContext("2d").clearRect(0, 0, 120, 120);
    await frame();
    extension.restoreContext();
    await restored;
    await frame();
    return { lost, back: renderer().lost || difference(before, pixels(canvases[0])) };
  });
  assert.ok(lost <= 1, `${lost}`);
  assert.equal(back, 0);
});

test("the largest exposure shows what the CPU shows, by any curve", async () => {
  const found = await page.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], { light: "park", material: "red-fabric2" });
    return eigenshade.TONES.map((tone) => {
      const look = { exposure: 3e38, tone };
      preview.look(look).draw();
      return difference(pixels(canvases[0]), eigenshade.sphere(preview.scene, 120, look));
    });
  });
  assert.ok(Math.max(...found) <= 1, `${found}`);
});

test("a light that fails leaves the number of sources of the last one that is set", async () => {
  const found = await page.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], { light: "studio", material: "blue-metallic-paint", sources: 2 });
    const found = [];
    for (const names of [["nope", "sunset"], ["sunset", "nope"], ["nope", "none"], ["sunset"]]) {
      await preview.light("studio", { sources: 2 });
      await Promise.allSettled(names.map((name) => preview.light(name, { sources: 8 })));
      await preview.light("lobby");
      found.push(preview.scene.sources);
    }
    // A light that is asked for before another is set takes the number of that one.
    await Promise.all([preview.light("studio", { sources: 2 }), preview.light("lobby")]);
    return [...found, preview.scene.sources];
  });
  assert.deepEqual(found, [8, 8, 2, 8, 2]);
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

test("without WebGL 2 the CPU draws", async () => {
  const bare = await open(() => {
    const { getContext } = OffscreenCanvas.prototype;
    OffscreenCanvas.prototype.getContext = function (kind, ...all) {
      return kind === "webgl2" ? null : getContext.call(this, kind, ...all);
    };
  });
  const found = await bare.evaluate(async () => {
    const preview = await eigenshade.Preview.create(canvases[0], {
      light: "studio", material: "red-fabric2", exposure: 1, tone: "linear",
    });
    const { sphere } = eigenshade;
    return difference(pixels(canvases[0]), sphere(preview.scene, 120, { exposure: 1, tone: "linear" }));
  });
  assert.equal(found, 0);
  await bare.close();
});

/** What draws pictures of two sizes, with a clock that the test moves. */
for (const { name, shader, drawn } of [
  { name: "WebGL draws where it is fast", shader: 1, drawn: ["webgl", "webgl"] },
  { name: "the CPU draws where WebGL takes longer", shader: 100, drawn: ["cpu", "cpu"] },
]) {
  test(`${name}, by the time of the first picture`, async () => {
    const found = await page.evaluate(async (shader) => {
      const { Preview } = eigenshade;
      const { Engine } = await import("/src/engine.js");
      // Each call of either kind takes its time.
      let clock = 0;
      performance.now = () => clock;
      const { drawArrays } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.drawArrays = function (...all) {
        clock += shader;
        return drawArrays.apply(this, all);
      };
      const { shadeAll } = Engine.prototype;
      Engine.prototype.shadeAll = function (...all) {
        clock += 0.1;
        return shadeAll.apply(this, all);
      };
      const [canvas] = canvases;
      const { drawImage } = CanvasRenderingContext2D.prototype;
      let by = "";
      CanvasRenderingContext2D.prototype.drawImage = function (...all) {
        by = "webgl";
        return drawImage.apply(this, all);
      };
      const preview = await Preview.create(canvas, { light: "park", material: "red-fabric2" });
      const found = [];
      for (const size of [120, 50]) {
        canvas.style.width = canvas.style.height = `${size}px`;
        by = "cpu";
        preview.draw();
        found.push(by);
      }
      return found;
    }, shader);
    assert.deepEqual(found, drawn);
  });
}

test("wrong input rejects with one clear error, and the picture stays", async () => {
  const messages = await page.evaluate(async () => {
    const { Preview } = eigenshade;
    const messages = [];
    const fails = async (what) => {
      try {
        await what();
        messages.push("nothing");
      } catch (fault) {
        messages.push(`${fault.name}: ${fault.message}`);
      }
    };
    const good = { light: "park", material: "red-fabric2" };
    await fails(() => Preview.create(document.body, good));
    await fails(() => Preview.create(canvases[1]));
    await fails(() => Preview.create(canvases[1], { ...good, sorces: 4 }));
    await fails(() => Preview.create(canvases[1], { material: "red-fabric2" }));
    await fails(() => Preview.create(canvases[1], { ...good, exposure: -1 }));
    await fails(() => Preview.create(canvases[1], { ...good, material: "red" }));
    const other = document.createElement("canvas");
    other.getContext("webgl");
    await fails(() => Preview.create(other, good));
    const preview = await Preview.create(canvases[0], good);
    const before = pixels(canvases[0]);
    await fails(() => preview.light("parc"));
    await fails(() => preview.material({ roughness: 2 }));
    await fails(() => preview.turn({ yaw: "left" }));
    await fails(() => preview.look({ tone: "aces" }));
    await fails(() => preview.look({ exposure: NaN }));
    await fails(() => preview.look({ exposur: 1 }));
    await fails(() => preview.look({ exposure: 1e-50 }));
    await fails(() => preview.look());
    await fails(() => preview.light("lobby", null));
    await fails(() => preview.light("lobby", { sorces: 4 }));
    await fails(() => preview.material(new Date()));
    const light = await eigenshade.lightPreset("park");
    await fails(() => preview.light({ ...light, r: [3e38] }));
    await frame();
    messages.push(difference(before, pixels(canvases[0])));
    preview.free();
    preview.free();
    await fails(() => preview.turn({ yaw: 1 }));
    await fails(() => preview.light("lobby"));
    // Nothing is loaded, whose failure nobody would handle.
    await fails(() => preview.material("no such material"));
    await new Promise((resolve) => setTimeout(resolve, 300));
    await fails(() => preview.draw());
    const next = await Preview.create(canvases[0], good);
    messages.push(difference(before, pixels(canvases[0])));
    next.free();
    return messages;
  });
  assert.deepEqual(messages.map((message) => String(message).slice(0, 98)), [
    "TypeError: Preview: it is [object HTMLBodyElement], expected a canvas of a page",
    "TypeError: Preview: it is undefined, expected { light, material, sources, window, engine, assets, ",
    'TypeError: Preview: "sorces" is unknown; did you mean "sources"?',
    "TypeError: light: it is undefined, expected { r, g, b } with arrays of coefficients, which lightPr",
    "RangeError: Preview: the exposure is -1, expected a number from 1.2e-38 to 3.4e38",
    'RangeError: no material is called "red"; did you mean dark-red-paint, light-red-paint, red-fabric2',
    "TypeError: Preview: the canvas already has a context of another kind",
    'RangeError: no light is called "parc"; did you mean park?',
    "RangeError: material: roughness is 2, expected a number from 0 to 1",
    'RangeError: turn: yaw is "left", expected a number',
    'RangeError: look: "aces" is not one of linear, reinhard, filmic',
    "RangeError: look: the exposure is NaN, expected a number from 1.2e-38 to 3.4e38",
    'TypeError: look: "exposur" is unknown; did you mean "exposure"?',
    "RangeError: look: the exposure is 1e-50, expected a number from 1.2e-38 to 3.4e38",
    "TypeError: look: it is undefined, expected { exposure, tone }",
    "TypeError: light: it is null, expected { sources }",
    'TypeError: light: "sorces" is unknown; did you mean "sources"?',
    "TypeError: material: it is [object Date], expected { r, g, b }, which materialPreset(name) loads, ",
    "RangeError: light: r[0] is 3e+38, expected a number from -1e15 to 1e15",
    "0",
    "Error: Preview: it was freed",
    "Error: Preview: it was freed",
    "Error: Preview: it was freed",
    "Error: Preview: it was freed",
    "0",
  ]);
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

test("an element draws what its attributes say, and says what is wrong", async () => {
  const found = await page.evaluate(async () => {
    await import("/src/element.js");
    const { exact } = await import("/test/support/exact.js");
    const next = (element, event) => new Promise((resolve, reject) => {
      element.addEventListener(event, resolve, { once: true });
      element.addEventListener(event === "load" ? "error" : "load", ({ type }) => reject(new Error(`${type}, not ${event}`)), { once: true });
    });
    document.body.insertAdjacentHTML("beforeend",
      `<eigen-shade light="studio" material="red-fabric2" exposure="2" yaw="30"></eigen-shade>`);
    const element = document.querySelector("eigen-shade");
    await next(element, "load");
    const canvas = element.shadowRoot.querySelector("canvas");
    const size = canvas.width;
    // What is chosen by itself.
    const auto = { sources: "auto", window: "auto" };
    const scene = await eigenshade.Scene.create({ light: "studio", material: "red-fabric2", ...auto });
    scene.turn({ yaw: Math.PI / 6 });
    const same = difference(pixels(canvas), exact(scene, size, { exposure: 2 }));
    const label = canvas.getAttribute("aria-label");
    const message = element.shadowRoot.querySelector("[role=alert]");
    const wrong = [];
    for (const [name, value] of [["light", "parc"], ["yaw", "left"], ["tone", "aces"]]) {
      const before = element.getAttribute(name);
      element.setAttribute(name, value);
      const { message: said } = await next(element, "error");
      wrong.push(said.slice(0, 40), message.textContent === said);
      if (before === null) element.removeAttribute(name);
      else element.setAttribute(name, before);
      await next(element, "load");
      wrong.push(message.textContent);
    }
    // One wrong attribute, and the picture stays.
    const before = pixels(canvas);
    for (const changes of [
      { light: "parc", material: "chrome" }, { light: "lobby", material: "crome" }, { light: "lobby", material: null, roughness: "2" },
      { light: "lobby", exposure: "1e39" }, { material: "chrome", sources: "-1" }, { light: "lobby", yaw: "left" },
      { light: "lobby", window: "0" }, { light: "lobby", sources: "none" },
    ]) {
      const kept = Object.keys(changes).map((name) => [name, element.getAttribute(name)]);
      const give = (name, value) => (value === null ? element.removeAttribute(name) : element.setAttribute(name, value));
      for (const [name, value] of Object.entries(changes)) give(name, value);
      await next(element, "error");
      element.preview.draw();
      wrong.push(difference(before, pixels(canvas)));
      for (const [name, value] of kept) give(name, value);
      await next(element, "load");
    }
    element.setAttribute("exposure", "auto");
    await next(element, "load");
    const automatic = difference(pixels(canvas), exact(scene, size, { exposure: scene.exposure() }));
    // A turn keeps the exposure that was chosen.
    element.removeAttribute("exposure");
    await next(element, "load");
    element.setAttribute("yaw", "150");
    await next(element, "load");
    const exposure = scene.turn({ yaw: Math.PI / 6 }).exposure();
    scene.turn({ yaw: (5 * Math.PI) / 6 });
    const kept = difference(pixels(canvas), exact(scene, size, { exposure }));
    element.setAttribute("exposure", "2");
    element.setAttribute("yaw", "30");
    scene.turn({ yaw: Math.PI / 6 });
    element.removeAttribute("material");
    element.setAttribute("base-color", "#b87333");
    element.setAttribute("metallic", "1");
    await next(element, "load");
    const copper = difference(pixels(canvas), exact(scene.material({ baseColor: "#b87333", metallic: 1 }), size, { exposure: 2 }));
    const few = element.preview.scene.sources;
    element.setAttribute("sources", "4");
    element.setAttribute("window", "9.5");
    await next(element, "load");
    const bright = await eigenshade.Scene.create({ light: "studio", material: { baseColor: "#b87333", metallic: 1 }, sources: 4, window: 9.5 });
    bright.turn({ yaw: Math.PI / 6 });
    const sharp = [difference(pixels(canvas), exact(bright, size, { exposure: 2 })), element.preview.scene.sources, element.sources, element.window];
    element.window = "none";
    element.sources = null;
    await next(element, "load");
    sharp.push(few, element.preview.scene.sources, element.preview.scene.windowWidth, element.preview.scene.window("auto").windowWidth < Infinity);
    element.remove();
    return { sharp, size, same, label, wrong, automatic, copper, kept, gone: element.preview === undefined };
  });
  for (const name of ["same", "automatic", "copper", "kept"]) assert.ok(found[name] <= 1, `${name}: ${found[name]}`);
  assert.ok(found.size > 100);
  assert.ok(found.sharp[0] <= 1, `${found.sharp}`);
  assert.deepEqual(found.sharp.slice(1), [4, 4, 9.5, 2, 2, Infinity, false]);
  assert.equal(found.label, "A sphere of red-fabric2 under the light studio");
  assert.deepEqual(found.wrong, [
    'no light is called "parc"; did you mean ', true, "",
    'yaw="left" is not a number', true, "",
    'look: "aces" is not one of linear, reinh', true, "",
    0, 0, 0, 0, 0, 0, 0, 0,
  ]);
  assert.ok(found.gone);
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

test("elements of equal attributes have equal pixels, whatever they showed before", async () => {
  const [most, apart] = await page.evaluate(async () => {
    await import("/src/element.js");
    const element = document.createElement("eigen-shade");
    document.body.append(element);
    const shown = async (attributes) => {
      const loaded = new Promise((resolve) => element.addEventListener("load", resolve, { once: true }));
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
      await loaded;
      return pixels(element.shadowRoot.querySelector("canvas"));
    };
    const [yaw, material] = ["120", "red-fabric2"];
    const first = await shown({ light: "sunset", material, yaw });
    const other = await shown({ light: "park", yaw: "0" });
    await shown({ yaw });
    const switched = await shown({ light: "sunset" });
    element.remove();
    document.body.append(element);
    return [Math.max(difference(first, switched), difference(first, await shown({}))), difference(first, other)];
  });
  assert.equal(most, 0);
  assert.ok(apart > 20);
});

test("an element has no canvas before its first picture, and a name with it", async () => {
  const found = await page.evaluate(async () => {
    await import("/src/element.js");
    const element = document.createElement("eigen-shade");
    element.setAttribute("light", "nowhere");
    const event = (type) => new Promise((resolve) => element.addEventListener(type, resolve, { once: true }));
    const canvas = element.shadowRoot.querySelector("canvas");
    const state = () => [canvas.checkVisibility(), canvas.getAttribute("aria-label")];
    document.body.append(element);
    const found = [state()];
    await event("error");
    found.push(state());
    element.setAttribute("light", "park");
    await event("load");
    found.push(state());
    // It keeps the name of the picture that stays.
    element.setAttribute("light", "nowhere");
    await event("error");
    return [...found, state()];
  });
  const label = "A sphere of a glTF material under the light park";
  assert.deepEqual(found, [[false, null], [false, null], [true, label], [true, label]]);
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

test("an element that is not shown fires `load`, and is drawn once it is", async () => {
  const found = await page.evaluate(async () => {
    await import("/src/element.js");
    const element = document.createElement("eigen-shade");
    element.style.display = "none";
    const loaded = new Promise((resolve) => element.addEventListener("load", resolve));
    document.body.append(element);
    await loaded;
    const middle = () => {
      const canvas = element.shadowRoot.querySelector("canvas");
      return canvas.getContext("2d").getImageData(canvas.width >> 1, canvas.height >> 1, 1, 1).data[3];
    };
    const found = [middle()];
    element.style.display = "";
    for (let k = 0; k < 3; k++) await frame();
    return [...found, middle()];
  });
  assert.deepEqual(found, [0, 255]);
});

test("an element keeps its shape under the Content-Security-Policy of README.md", async () => {
  const policy = /`(script-src .*wasm-unsafe-eval')`/.exec(README)[1];
  const strict = await serve({ "/": `<!doctype html><link rel=icon href=data:,>
    <meta http-equiv="Content-Security-Policy" content="default-src 'self'; img-src data:; ${policy}">
    <script type="module" src="/src/element.js"></script><eigen-shade material="nylon"></eigen-shade>` });
  const page = await browser.newPage();
  page.on("console", (message) => faults.push(message.text()));
  await page.goto(`${strict.address}/`);
  const canvas = page.locator("eigen-shade canvas");
  await canvas.waitFor();
  const sizes = await canvas.evaluate((canvas) => [canvas.width, canvas.height, canvas.clientWidth, getComputedStyle(canvas.getRootNode().host).display]);
  assert.deepEqual(sizes, [192, 192, 192, "inline-block"]);
  await page.close();
  strict.close();
});

test("a thousand lights leak nothing", async () => {
  const session = await page.context().newCDPSession(page);
  const used = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return (await session.send("Runtime.getHeapUsage")).usedSize;
  };
  await page.evaluate(async () => {
    const { light } = await eigenshade.presetNames();
    const lights = await Promise.all(light.map((name) => eigenshade.lightPreset(name)));
    canvases[0].style.width = canvases[0].style.height = "8px";
    window.preview = await eigenshade.Preview.create(canvases[0], { light: "park", material: "red-fabric2" });
    window.change = async (count) => {
      for (let k = 0; k < count; k++) {
        await preview.light(lights[k % lights.length]);
        preview.turn({ yaw: k / 10 }).draw();
      }
    };
    // As small as possible, so that the renderer does not take the time, and until all is compiled.
    await change(1000);
  });
  const before = await used();
  await page.evaluate(() => change(1000));
  const after = await used();
  assert.ok(after <= 1.05 * before, `${before} bytes before, ${after} after`);
});

// The page in a browser: what it draws and says, control by control.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { pathToFileURL } from "node:url";
import { screenText, wholeVerdict } from "../src/screen.js";
import { glb } from "../../packages/eigenshade/test/support/glb.js";
import { hdrFile } from "./files.js";
import { NO_WEBGL, ROOT, SITE, launch, open, serve, settled } from "./support.js";

/** Small, so that rendering in software is fast. */
const SMALL = { width: 360, height: 480 };

let browser, server;

before(async () => {
  server = await serve();
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
});

/** A test of a page, which ends without a fault that it does not expect. All run at the end. */
const tests = [];
const on = (name, hash, run, options = {}) =>
  tests.push(() => test(name, async () => {
    const { page, faults } = await open(browser, server.address, { ...SMALL, hash, script: helpers, ...options });
    await run(page, faults);
    assert.deepEqual(faults, []);
    await page.close();
  }));

/** In the page: `pixels` of a canvas, and `apart`, their mean difference in codes. */
function helpers() {
  window.pixels = async (id = "picture") => {
    const canvas = document.getElementById(id);
    const copy = new OffscreenCanvas(canvas.width, canvas.height);
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  window.keep = async (id) => (window.kept = await pixels(id));
  window.apart = async (id) => {
    const now = await pixels(id);
    return now.reduce((sum, code, k) => sum + Math.abs(code - kept[k]), 0) / now.length;
  };
}

const keep = (page, id) => page.evaluate((id) => keep(id).then(() => {}), id);
const apart = (page, id) => page.evaluate((id) => apart(id), id);
const text = (page, id) => page.locator(`#${id}`).textContent();
const slide = async (page, id, value) => {
  await page.locator(`#${id}`).fill(String(value));
  await settled(page);
};
const tab = (page, name) => page.locator(`#tab-${name}`).click().then(() => settled(page));
/** Clicks a radio button, whose label covers it. */
const choose = async (page, name, value) => {
  await page.locator(`input[name=${name}][value="${value}"]`).check({ force: true });
  await settled(page);
};

for (const sources of [0, 4]) on(`the sphere is what the CPU module draws, to two codes, ${sources} sources`, `object=sphere&step=9&sources=${sources}`, async (page) => {
  const { most, middle } = await page.evaluate(async (sources) => {
    const { Scene } = await import("/eigenshade/src/index.js");
    const inputs = { light: "lobby", material: "gold-metallic-paint", window: "auto" };
    const scene = await Scene.create({ ...inputs, sources });
    if (scene.sources !== sources) throw new Error(`${scene.sources} sources`);
    const { disc } = await import("/src/cpu.js");
    const shown = await pixels();
    const { x, y, z, places, coverage } = disc(document.getElementById("picture").width);
    // That of the reference, which has all sources.
    const exposure = (await Scene.create({ ...inputs, sources: 16 })).exposure();
    const codes = scene.within(10 ** (-0.5 - (5.5 * 9) / 39), exposure).pixels(x, y, z, { exposure });
    let most = 0;
    places.forEach((place, k) => {
      if (coverage[k] < 1 || Math.hypot(x[k], y[k]) > 0.985) return;
      for (let c = 0; c < 3; c++) most = Math.max(most, Math.abs(codes[4 * k + c] - shown[4 * place + c]));
    });
    return { most, middle: shown[4 * places[places.length >> 1]] };
  }, sources);
  // Its own curve and that of the module round differently.
  assert.ok(most <= 2, `${most}`);
  assert.ok(middle > 60);
});

on("accuracy: the slider moves terms, errors, costs and the point, and the picture", "object=sphere&step=40", async (page) => {
  assert.equal(await text(page, "rms"), "0");
  const all = Number(await text(page, "terms"));
  const [x, m0] = [await page.locator(".rms-point").getAttribute("cx"), await text(page, "m0")];
  await keep(page);
  await slide(page, "step", 0);
  const few = Number(await text(page, "terms"));
  assert.ok(few < 15 && all > 150);
  assert.match(await text(page, "cost"), new RegExp(`^${few} terms? \\+ 1 source$`));
  assert.match(await text(page, "verdict"), /^Visible: mean \d/);
  assert.ok(Number(await page.locator(".rms-point").getAttribute("cx")) < Number(x) - 100);
  assert.ok((await apart(page)) > 3);
  const count = Math.round((3 * (44.8 + 5.3 * few) + 306) / 10) * 10;
  assert.equal(await text(page, "m0"), `${count.toLocaleString("en")} instr.`);
  assert.notEqual(m0, await text(page, "m0"));
  assert.match(await text(page, "light-time"), /^[\d.]+ µs$/);
  assert.match(await text(page, "pixel-time"), /^[\d.]+ ns$/);
  assert.ok((await page.locator("polyline.rms").getAttribute("points")).split(" ").length > 20);
});

on("the split view has ours, all terms, the nine-term formula and the difference", "object=sphere&step=6&view=split&turn=0.2,0.4,0.1,0.9&light=park", async (page) => {
  assert.ok(await page.locator("#captions").isVisible());
  const found = await page.evaluate(async () => {
    const { Scene, lightPreset } = await import("/eigenshade/src/index.js");
    const { nineTerms, shadeNine } = await import("/src/nine.js");
    const { meanOf, pictureOf } = await import("/src/measure.js");
    const { ambient } = await import("/src/harmonics.js");
    const { encoded } = await import("/src/color.js");
    const scene = await Scene.create({ light: ambient(), material: "gold-metallic-paint", sources: 1, window: "auto" });
    const light = await lightPreset("park", { sources: "auto" });
    const terms = nineTerms(light, meanOf(pictureOf(scene)));
    // That of the reference, which is the second pane.
    const best = await lightPreset("park", { sources: 16 });
    const exposure = scene.light(best).exposure();
    const length = Math.hypot(0.2, 0.4, 0.1, 0.9);
    const turn = [0.2, 0.4, 0.1, 0.9].map((value) => value / length);
    const shown = await pixels();
    const { width } = document.getElementById("picture");
    const worst = [0, 0, 0, 0];
    for (const [u, v] of [[0, 0], [0.5, 0.1], [-0.4, 0.6], [0.1, -0.7]]) {
      const column = Math.floor((width / 4) * (1 + 0.94 * u)), row = Math.floor((width / 4) * (1 - 0.94 * v));
      // The middle of the pixel.
      const [x, y] = [((4 * (column + 0.5)) / width - 1) / 0.94, (1 - (4 * (row + 0.5)) / width) / 0.94];
      const normal = [[x], [y], [Math.sqrt(1 - x * x - y * y)]];
      const whole = scene.light(best).within().turn(turn).shade(...normal);
      const nine = shadeNine(terms, turn, normal);
      const ours = scene.light(light).within(10 ** (-0.5 - (5.5 * 6) / 39), exposure).shade(...normal);
      [ours, whole, nine].forEach((picture, pane) => {
        for (const [c, channel] of ["r", "g", "b"].entries()) {
          const at = 4 * (width * (row + (pane >> 1) * (width / 2)) + column + (pane & 1) * (width / 2)) + c;
          worst[pane] = Math.max(worst[pane], Math.abs(shown[at] - encoded(exposure * picture[channel][0])));
          if (pane) continue;
          const apart = 4 * (width * (row + width / 2) + column + width / 2) + c;
          const expected = encoded(10 * exposure * Math.abs(ours[channel][0] - nine[channel][0]), false);
          worst[3] = Math.max(worst[3], Math.abs(shown[apart] - expected));
        }
      });
    }
    return worst;
  });
  found.forEach((most, pane) => assert.ok(most <= 2, `pane ${pane}: ${most} of ${found}`));
  await tab(page, "accuracy");
  await keep(page);
  await choose(page, "view", "picture");
  assert.ok((await apart(page)) > 5 && !(await page.locator("#captions").isVisible()));
});

/**
 * The larger errors of two turns against direct integration, of the metal next to a roughness, as the
 * page has them.
 */
function direct(light, roughness, sources) {
  const rows = readFileSync(join(SITE, "eigenshade/errors.csv"), "utf8").trim().split("\n").map((line) => line.split(","));
  const away = ([, rough]) => Math.abs(Number(rough) - roughness);
  const nearest = Math.min(...rows.map(away));
  const found = rows.filter((row) => row[0] === light && away(row) === nearest && Number(row[2]) === sources);
  const [mean, most] = [3, 4].map((column) => Math.max(...found.map((row) => Number(row[column]))));
  return { light, roughness: Number(found[0][1]), sources, error: { mean, most } };
}

/** The roughness of a measured material. */
const roughnessOf = (page, material) => page.evaluate(async (material) => {
  const { materialPreset } = await import("/eigenshade/src/index.js");
  return (await materialPreset(material)).gloss[0];
}, material);

on("the headline is the screen error of the whole picture, or against all sources, in words", "object=sphere&step=40&light=night&material=chrome-steel&sources=1", async (page) => {
  const headline = async () => `${await text(page, "verdict")}${await text(page, "against")}`;
  const roughness = await roughnessOf(page, "chrome-steel");
  const whole = (sources) => {
    const { error, against } = wholeVerdict({ mean: 0, most: 0 }, direct("night", roughness, sources));
    return `${error}${against}`;
  };
  assert.equal(await headline(), whole(1));
  // Of the terms, nothing is left out.
  assert.match(await text(page, "worst"), /^(0|< 0.001 %)$/);
  // The exposure of the picture is not that of the error.
  await tab(page, "scene");
  await slide(page, "exposure", -3);
  assert.equal(await headline(), whole(1));
  await tab(page, "accuracy");
  await choose(page, "sources", 8);
  assert.equal(await headline(), whole(8));
  // Fewer terms add their error.
  await slide(page, "step", 5);
  assert.match(await headline(), /with 8 sources, and what this picture leaves out$/);
  const numbers = (text) => text.match(/[\d.]+/g).slice(0, 1).map(Number)[0];
  assert.ok(numbers(await headline()) > numbers(whole(8)));
  await slide(page, "step", 40);
  // Nobody has integrated parts of pictures, matte materials and lights by formula.
  await tab(page, "effects");
  await page.locator("#effect-broad").click();
  await settled(page);
  const expected = await page.evaluate(async () => {
    const { Scene, lightPreset } = await import("/eigenshade/src/index.js");
    const { pictureOf } = await import("/src/measure.js");
    const { colorsOf, screenError, verdict } = await import("/src/screen.js");
    const scene = await Scene.create({ light: "night", material: "chrome-steel", sources: 16, window: "auto" });
    const [{ sources }, exposure] = [scene, scene.exposure()];
    const best = colorsOf(pictureOf(scene), exposure);
    scene.light(await lightPreset("night", { sources: 8 })).effects(["ambient", "diffuse", "gloss"]);
    const { error, against } = verdict(screenError(colorsOf(pictureOf(scene), exposure), best), sources);
    return `${error}${against}`;
  });
  assert.equal(await headline(), expected);
  assert.match(expected, /CIEDE2000 against all terms of 160 images and 16 sources; what degree 9 lacks adds to it$/);
  await page.locator("#effect-broad").click();
  await tab(page, "scene");
  await choose(page, "material", "red-fabric2");
  assert.match(await headline(), /^At best not visible: mean 0.0, .*against all terms of 160 images; what degree 9 lacks/);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

on("the curve is that of the inputs that are drawn, whenever it is measured", "object=sphere&step=9", async (page) => {
  const points = () => page.locator("polyline.rms").getAttribute("points");
  const before = await points();
  await page.evaluate(async () => {
    const { materialPreset } = await import("/eigenshade/src/index.js");
    await materialPreset("red-fabric2");
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    // A picture, whose curve is due; then a material whose picture waits for its frame until then.
    document.getElementById("upright").click();
    await frame();
    const { requestAnimationFrame: now } = window;
    const held = [];
    window.requestAnimationFrame = (run) => held.push(run);
    document.querySelector("input[value=red-fabric2]").click();
    await new Promise((resolve) => setTimeout(resolve, 400));
    window.requestAnimationFrame = now;
    if (held.length !== 1) throw new Error(`${held.length} frames`);
    held.forEach((run) => requestAnimationFrame(run));
  });
  await settled(page);
  const found = await points();
  await page.reload();
  await settled(page);
  assert.match(await page.locator("#picture").getAttribute("aria-label"), /red fabric2/);
  assert.equal(found, await points());
  assert.notEqual(found, before);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

on("sources: highlights, their number, and the error that degree 9 leaves", "object=sphere&step=20&light=lab", async (page) => {
  const roughness = await roughnessOf(page, "gold-metallic-paint");
  for (const sources of [0, 1, 4, 8]) {
    await choose(page, "sources", sources);
    assert.equal(await text(page, "sources-drawn"), sources ? `${sources} source${sources > 1 ? "s" : ""} drawn.` : "");
    assert.equal(await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("sources")), String(sources));
    if (sources) assert.ok((await apart(page)) > 0.3, `${sources}`);
    assert.equal(await text(page, "degree"), screenText(direct("lab", roughness, sources).error));
    await keep(page);
  }
  const none = async (act, why) => {
    await act();
    await settled(page);
    assert.match(await text(page, "sources-drawn"), new RegExp(`^None drawn: ${why}`));
  };
  await tab(page, "effects");
  await none(() => page.locator("#effect-broad").click(), "effects are left out");
  await page.locator("#effect-broad").click();
  await tab(page, "scene");
  await none(() => page.locator("input[name=material][value=red-fabric2]").check({ force: true }), "this material is matte");
  assert.equal(await text(page, "degree"), "-");
  await none(() => page.locator("#light").selectOption("hemisphere"), "this light has none");
  // As few as the material needs, which no link holds: it is the initial choice.
  await page.locator("#light").selectOption("night");
  await choose(page, "material", "chrome-steel");
  await tab(page, "accuracy");
  await choose(page, "sources", "auto");
  const auto = await page.evaluate(async () => {
    const { Scene } = await import("/eigenshade/src/index.js");
    return (await Scene.create({ light: "night", material: "chrome-steel", sources: "auto" })).sources;
  });
  assert.equal(await text(page, "sources-drawn"), `${auto} sources drawn.`);
  assert.equal(await page.evaluate(() => new URLSearchParams(location.hash.slice(1)).get("sources")), null);
});

on("what screen readers announce is not written again by a turn", "object=sphere&step=5", async (page) => {
  const written = await page.evaluate(async () => {
    let written = 0;
    const observer = new MutationObserver(() => written++);
    for (const region of document.querySelectorAll("output, [role=status], [role=alert], [aria-live]")) {
      if (region.ariaLive !== "off") observer.observe(region, { childList: true, characterData: true, subtree: true });
    }
    const picture = document.getElementById("picture");
    const before = document.getElementById("summary").textContent;
    for (let k = 0; k < 10; k++) {
      picture.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowLeft" }));
      await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
    }
    if (document.getElementById("summary").textContent === before) throw new Error("the picture is as it was");
    return written;
  });
  assert.equal(written, 0);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

on("effects: switches change picture, shares and terms, and automatic chooses", "object=sphere&step=5&tab=effects&light=studio&sources=0", async (page) => {
  for (const effect of ["ambient", "diffuse", "broad", "gloss"]) {
    assert.match(await text(page, `share-${effect}`), /^[\d.]+ %$/);
    assert.match(await text(page, `saved-${effect}`), /^leaving it out (saves (no|\d+) terms|takes \d+ more terms)$/);
    await keep(page);
    await page.locator(`#effect-${effect}`).click();
    await settled(page);
    assert.ok((await apart(page)) > 0.5, effect);
  }
  assert.ok(await page.evaluate(async () => (await pixels()).every((code, k) => k % 4 === 3 || code === 0)));
  await page.locator("#automatic").selectOption("5");
  await page.locator("#choose").click();
  await settled(page);
  const [, terms, error] = /and (\d+) terms: they leave out ([\d.]+) % of white rms/.exec(await text(page, "chosen"));
  assert.equal(await text(page, "terms"), terms);
  assert.ok(Number(error) <= 5 && Number(error) > 1);
  assert.equal(await text(page, "cost"), `${terms} terms`);
  assert.equal(await text(page, "rms"), `${error} %`);
});

on("eigenimages: 24 pictures with their coefficients, and their sum", "object=sphere&tab=images&step=8", async (page) => {
  const captions = await page.locator("#gallery span").allTextContents();
  assert.equal(captions.length, 24);
  const { coefficients, signs } = await page.evaluate(async () => {
    const { Scene } = await import("/eigenshade/src/index.js");
    const { g } = (await Scene.create({ light: "lobby", material: "gold-metallic-paint", sources: "auto", window: "auto" })).coefficients();
    const scene = await Scene.create({ light: "lobby", material: "gold-metallic-paint" });
    const signs = [...document.querySelectorAll("#gallery canvas")].map((canvas, k) => {
      const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
      // At a quarter to the upper right: blue or orange.
      const at = 4 * (Math.round(0.36 * canvas.height) * canvas.width + Math.round(0.6 * canvas.width));
      const [x, y] = [((2 * Math.round(0.6 * 72) + 1) / 72 - 1) / 0.94, (1 - (2 * Math.round(0.36 * 72) + 1) / 72) / 0.94];
      const [value] = scene.eigenimage(k, [x], [y], [Math.sqrt(1 - x * x - y * y)]);
      return Math.abs(value) < 0.2 || Math.sign(data[at] - data[at + 2]) === Math.sign(value);
    });
    return { coefficients: [...g.slice(0, 24)], signs };
  });
  assert.ok(signs.every(Boolean), `${signs}`);
  captions.forEach((caption, k) => {
    const value = Number(caption.replace(`d${k + 1} `, "").replace("−", "-"));
    assert.ok(Math.abs(value - coefficients[k]) <= 0.06 * Math.abs(coefficients[k]) + 6e-5, `${caption}: ${coefficients[k]}`);
  });
  await keep(page);
  const errors = [];
  for (const count of [0, 6, 40, 160]) {
    await slide(page, "components", count);
    errors.push(await apart(page));
  }
  assert.ok(errors[0] > errors[1] && errors[1] > errors[2] && errors[2] > errors[3] && errors[3] === 0, `${errors}`);
  assert.equal(await page.locator("#gallery li.out").count(), 0);
  await page.locator("#grow").click();
  await page.waitForFunction(() => { const count = parseInt(document.getElementById("components-value").textContent); return count >= 1 && count < 160; });
  await page.locator("#grow").click();
  assert.equal(await text(page, "grow"), "Grow");
});

on("shadows: nothing is loaded before the switch is on, and then the coin turns with the light", "object=sphere&step=5&light=park", async (page) => {
  const loaded = () => page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname).filter((name) => /shadow/.test(name)));
  assert.deepEqual(await loaded(), []);
  await tab(page, "shadows");
  assert.deepEqual(await loaded(), ["/src/shadows.js", "/eigenshade/src/shadowed.js", "/shadows/about.json"]);
  assert.ok(!(await page.locator("#shadowed").isVisible()));
  const bytes = Math.round(statSync(join(SITE, "shadows/object.bin")).size / 1000);
  assert.match(await text(page, "shadowed-bytes"), new RegExp(`^${bytes}\u00a0KB, loaded when it is turned on, with \\d+\u00a0KB of normals and code`));
  // The errors are those of docs/shadows.csv.
  const [names, ...rows] = readFileSync(join(ROOT, "docs/shadows.csv"), "utf8").split("\n").slice(1).map((line) => line.split(","));
  for (const [id, way] of [["without", "convex"], ["with", "codes: 4096"]]) {
    const row = rows.find(([shape, material, name]) => shape === "coin" && material === "metal 0.5" && name === way);
    const [mean, rms] = ["tilted_mean", "tilted_rms"].map((name) => Number(row[names.indexOf(name)]));
    const shown = await page.locator(`#shadowed-${id} td`).allTextContents();
    [mean, rms].forEach((value, k) => assert.ok(Math.abs(parseFloat(shown[k]) - value) <= 0.5 * (value < 9.95 ? 0.1001 : 1), `${shown}`));
    assert.ok(id === "with" ? mean < 2 && rms < 3 : mean > 5 && rms > 10);
  }
  await page.locator("#has-shadows").check();
  await settled(page);
  assert.deepEqual((await loaded()).slice(3).sort(), ["/eigenshade/wasm/eigenshade.shadowed.wasm", "/shadows/normals.bin", "/shadows/object.bin"]);
  assert.ok(await page.locator("#shadowed-with[aria-current]").isVisible());
  // As the package draws it; without shadows, its flat ground as a scene of a gray metal.
  const drawn = (turn, hasShadows) => page.evaluate(async ([turn, hasShadows]) => {
    const { Scene, lightPreset } = await import("/eigenshade/src/index.js");
    const { ShadowedObject } = await import("/eigenshade/src/shadowed.js");
    const object = await ShadowedObject.load(await (await fetch("/shadows/object.bin")).arrayBuffer());
    const exposure = 0.5 * object.light(await lightPreset("park")).exposure();
    const [shown, expected] = [await pixels("shadowed"), object.turn(turn).pixels({ exposure })];
    if (!hasShadows) {
      const scene = await Scene.create({ light: "park", material: { baseColor: [0.9, 0.9, 0.9], metallic: 1, roughness: 0.5 } });
      const color = scene.turn(turn).pixels([0], [0], [1], { exposure });
      const middle = 4 * (96 * 13 + 48);
      return { apart: Math.max(...[0, 1, 2].map((c) => Math.abs(shown[middle + c] - color[c]))), other: expected.reduce((sum, code, k) => sum + Math.abs(code - shown[k]), 0) / shown.length };
    }
    // A canvas rounds the colors of pixels that are covered in part.
    return { apart: expected.reduce((most, code, k) => Math.max(most, k % 4 === 3 || expected[k | 3] === 255 ? Math.abs(code - shown[k]) : 0), 0), middle: shown[4 * (96 * 48 + 48) + 3] };
  }, [turn, hasShadows]);
  const { apart: first, middle } = await drawn([0, 0, 0, 1], true);
  assert.ok(first === 0 && middle === 255, `${first}`);
  await keep(page, "shadowed");
  await page.locator("#shadowed").press("ArrowRight");
  await settled(page);
  assert.ok((await apart(page, "shadowed")) > 0.5);
  const turn = [0, Math.sin(0.0873 / 2), 0, Math.cos(0.0873 / 2)];
  assert.ok((await drawn(turn, true)).apart <= 1);
  await page.locator("#has-shadows").uncheck();
  await settled(page);
  assert.ok(await page.locator("#shadowed-without[aria-current]").isVisible());
  const { apart: plain, other } = await drawn(turn, false);
  assert.ok(plain <= 2 && other > 5, `${plain}, ${other}`);
  assert.match(await page.evaluate(() => location.hash), /tab=shadows/);
});

on("shadows: a link shows the coin, and a file that is missing is said and tried again", "object=sphere&step=5&tab=shadows&shadows=on", async (page, faults) => {
  assert.equal(await page.locator("#shadowed").getAttribute("aria-label"), "A coin with shadows");
  await page.route("**/shadows/object.bin", (route) => route.fulfill({ status: 200, body: "<!doctype html>" }));
  await page.reload();
  await settled(page);
  assert.match(await text(page, "fault"), /The coin cannot be shown: ShadowedObject: this is no object with shadows, or was cut/);
  await page.unroute("**/shadows/object.bin");
  await page.locator("#has-shadows").uncheck();
  await settled(page);
  await page.locator("#has-shadows").check();
  await settled(page);
  assert.ok(await page.locator("#shadowed").isVisible());
  assert.deepEqual(faults, []);
}, { script: NO_WEBGL });

on("hard cases: each shows two pictures that differ, and says why", "object=sphere&step=5&tab=cases", async (page) => {
  const options = await page.locator("#case option").evaluateAll((all) => all.map(({ value }) => value));
  assert.deepEqual(options, ["sun", "direction", "rim", "behind", "bytes"]);
  const texts = new Set();
  for (const option of options) {
    const before = await text(page, "case-text");
    await page.locator("#case").selectOption(option);
    await page.waitForFunction((before) => document.getElementById("case-text").textContent !== before, option === "sun" ? "" : before);
    texts.add(await text(page, "case-text"));
    assert.match(await text(page, "case-ours-caption"), /^Ours/);
    assert.match(await text(page, "case-naive-caption"), /^Naive/);
    await keep(page, "case-ours");
    const difference = await apart(page, "case-naive");
    assert.ok(difference > 0.4, `${option}: ${difference}`);
  }
  assert.equal(texts.size, 5);
  await page.locator("#case").selectOption("direction");
  await page.waitForFunction(() => /windowed/.test(document.getElementById("case-ours-caption").textContent));
  const depth = async (id) => Number(/−([\d.]+) %/.exec(await text(page, id))[1]);
  assert.ok((await depth("case-naive-caption")) > 2 * (await depth("case-ours-caption")));
});

on("scene: lights, materials and exposure change the picture", "object=sphere&step=3&tab=scene", async (page) => {
  assert.equal(await page.locator("#light option").count(), 26 + 3 + 1);
  const materials = await page.locator("#thumbs label").allTextContents();
  assert.ok(materials.length >= 30 && new Set(materials).size === materials.length);
  const change = async (what, act) => {
    await keep(page);
    await act();
    await settled(page);
    assert.ok((await apart(page)) > 0.5, what);
    assert.equal(await text(page, "fault"), "");
  };
  for (const light of ["sunset", "ambient", "hemisphere", "directional"]) {
    await change(light, () => page.locator("#light").selectOption(light));
  }
  await change("material", () => page.locator("input[name=material][value=red-plastic]").check({ force: true }));
  assert.match(await page.locator("#picture").getAttribute("aria-label"), /^A sphere of red plastic under the light directional$/);
  await change("base color", () => page.locator("#base-color").fill("#20a040"));
  await change("roughness", () => page.locator("#roughness").fill("0.9"));
  await change("metallic", () => page.locator("#metallic").fill("0"));
  await change("exposure", () => page.locator("#exposure").fill("-2"));
  // A thumbnail has the sources of its light: chrome without them is a zebra.
  await page.locator("#thumbs input[value=chrome-steel]").scrollIntoViewIfNeeded();
  await page.evaluate(() => {
    window.chrome = () => {
      const copy = new OffscreenCanvas(64, 64).getContext("2d");
      copy.drawImage(document.querySelector("#thumbs label:has([value=chrome-steel]) canvas"), 0, 0);
      return copy;
    };
  });
  await page.waitForFunction(() => chrome().getImageData(32, 32, 1, 1).data[3] === 255);
  const most = await page.evaluate(async () => {
    const { Scene } = await import("/eigenshade/src/index.js");
    const { disc, image } = await import("/src/cpu.js");
    const scene = await Scene.create({ light: "studio", material: "chrome-steel", sources: "auto", window: "auto" });
    if (!scene.sources) throw new Error(`${scene.sources} sources`);
    const at = disc(64);
    const expected = image(at, scene.shade(at.x, at.y, at.z), scene.exposure()).data;
    const shown = chrome().getImageData(0, 0, 64, 64).data;
    return Math.max(...at.places.map((place, k) => at.coverage[k] < 1 ? 0 : Math.max(...[0, 1, 2].map((c) => Math.abs(expected[4 * place + c] - shown[4 * place + c])))));
  });
  assert.ok(most <= 1, `${most}`);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

on("inputs that overtake each other: all are shown", "object=sphere&step=3&tab=scene", async (page) => {
  await page.locator("#light").selectOption("night");
  await page.locator("input[name=material][value=red-plastic]").check({ force: true });
  await settled(page);
  const label = await page.locator("#picture").getAttribute("aria-label");
  assert.match(label, /^A sphere of red plastic under the light night$/);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

on("objects: a sphere, a coin and a relief", "object=sphere&step=3&tab=scene", async (page) => {
  for (const object of ["coin", "relief", "sphere"]) {
    await keep(page);
    await choose(page, "object", object);
    assert.ok((await apart(page)) > 2, object);
  }
  // The light changes what WebGL draws, too.
  await keep(page);
  await page.locator("#light").selectOption("directional");
  await settled(page);
  assert.ok((await apart(page)) > 2);
});

on("drags, Alt-drags, two fingers and arrow keys turn object and light", "object=coin&step=5&pose=0,0,0,1", async (page) => {
  const state = () => page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
  const box = await page.locator("#picture").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const drag = async () => {
    await keep(page);
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 10, { steps: 3 });
    await page.mouse.up();
    await settled(page);
    assert.ok((await apart(page)) > 0.5);
  };
  // Screens that are touched have no Alt.
  const hint = "Drag or use arrow keys to turn the object; two fingers turn the light.";
  assert.equal(await text(page, "hint"), hint);
  await drag();
  const first = await state();
  // To the right about y, by 3 radians a width.
  const [, turned] = first.pose.split(",").map(Number);
  assert.ok(Math.abs(2 * Math.asin(turned) - (3 * 40) / box.width) < 0.02, first.pose);
  assert.equal(first.turn, undefined);
  await page.keyboard.down("Alt");
  await drag();
  await page.keyboard.up("Alt");
  const second = await state();
  assert.equal(second.pose, first.pose);
  assert.ok(Number(second.turn.split(",")[1]) > 0.1);
  const session = await page.context().newCDPSession(page);
  const touch = (type, ...places) => session.send("Input.dispatchTouchEvent", { type, touchPoints: places.map(([x, y], id) => ({ x, y, id })) });
  await touch("touchStart", [x - 20, y], [x + 20, y]);
  await touch("touchMove", [x + 10, y], [x + 50, y]);
  await touch("touchEnd");
  await settled(page);
  const third = await state();
  assert.equal(third.pose, first.pose);
  assert.notEqual(third.turn, second.turn);
  await page.locator("#picture").focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  const fourth = await state();
  assert.equal(fourth.turn, third.turn);
  assert.notEqual(fourth.pose, third.pose);
  await page.keyboard.press("Shift+ArrowUp");
  await settled(page);
  const fifth = await state();
  assert.equal(fifth.pose, fourth.pose);
  assert.notEqual(fifth.turn, fourth.turn);
  await tab(page, "scene");
  await choose(page, "drag", "light");
  await page.locator("#picture").focus();
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.notEqual((await state()).turn, fifth.turn);
  await page.locator("#upright").click();
  await settled(page);
  assert.equal((await state()).turn, undefined);
}, { hasTouch: true });

on("the keyboard reaches everything, and arrows move between tabs", "object=sphere&step=5", async (page) => {
  await page.locator("#tab-accuracy").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok(await page.locator("#effects").isVisible());
  assert.equal(await page.evaluate(() => document.activeElement.id), "tab-effects");
  await page.keyboard.press("Home");
  assert.ok(await page.locator("#scene").isVisible());
  const reached = new Set();
  await page.locator("#copy").focus();
  for (let k = 0; k < 24; k++) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => document.activeElement.id || document.activeElement.name));
  }
  for (const id of ["picture", "step", "tab-scene", "object", "open-mesh", "drag", "light", "open-light", "exposure", "material", "base-color", "roughness"]) {
    assert.ok(reached.has(id), `${id} of ${[...reached]}`);
  }
  await page.locator("#step").focus();
  const before = await text(page, "summary");
  for (let k = 0; k < 4; k++) await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.notEqual(await text(page, "summary"), before);
});

on("a link holds the whole state, and restores it", "object=coin&light=sunset&material=red-plastic&step=6&exposure=1&tab=effects&effects=diffuse,gloss", async (page, faults) => {
  assert.match(await text(page, "hint"), /; Alt-drag, two fingers or Shift\+arrow keys turn the light\.$/);
  await keep(page);
  assert.ok(await page.locator("#effects").isVisible());
  assert.ok(!(await page.locator("#effect-ambient").isChecked()) && (await page.locator("#effect-gloss").isChecked()));
  assert.equal(await page.locator("#light").inputValue(), "sunset");
  await page.locator("#picture").focus();
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.ok((await apart(page)) > 0.3);
  await keep(page);
  const url = page.url();
  const other = await open(browser, url.split("#")[0], { ...SMALL, hash: url.split("#")[1], script: helpers });
  const codes = await other.page.evaluate(async () => [...(await pixels())]);
  // Edges may fall on the other side of a sample: the link has five digits of a turn.
  const off = await page.evaluate((codes) => kept.length === codes.length ? kept.filter((code, k) => Math.abs(code - codes[k]) > 1).length / codes.length : 1, codes);
  assert.ok(off < 1e-3, `${off}`);
  faults.push(...other.faults);
  await other.page.close();
  // A link that is opened in the page, and one that is wrong.
  await page.evaluate(() => (location.hash = "object=sphere&step=3&light=night"));
  await page.waitForFunction(() => document.getElementById("light").value === "night");
  await settled(page);
  await page.evaluate(() => (location.hash = "step=77"));
  await page.waitForFunction(() => document.getElementById("fault").textContent !== "");
  assert.match(await text(page, "fault"), /^This link is not whole: step: "77" is not a whole number from 0 to 40\.$/);
});

/** Where the places of an .exr's blocks start, and the first block, which `more` bytes moved. */
function offsets(bytes, more) {
  let at = 8;
  while (bytes[at] !== 0) {
    for (let part = 0; part < 2; part++) at = bytes.indexOf(0, at) + 1;
    at += 4 + bytes.readUInt32LE(at);
  }
  return [at + 1, Number(bytes.readBigUInt64LE(at + 1)) + more];
}

/** Drops a file on the page. */
const drop = (page, name, bytes) =>
  page.evaluate(async ([name, base64]) => {
    const transfer = new DataTransfer();
    const data = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    transfer.items.add(new File([data], name));
    for (const type of ["dragenter", "dragover", "drop"]) {
      document.getElementById("frame").dispatchEvent(new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true }));
    }
  }, [name, Buffer.from(bytes).toString("base64")]);
const said = (page, id, pattern) =>
  page.waitForFunction(([id, source]) => new RegExp(source).test(document.getElementById(id).textContent), [id, pattern.source]);

on("good files are shown: .exr, .hdr, .png and .obj", "object=sphere&step=5&sources=0", async (page) => {
  await page.evaluate(() => {
    window.stages = [];
    new MutationObserver(() => stages.push(document.getElementById("status").textContent)).observe(document.getElementById("status"), { childList: true });
  });
  await keep(page);
  await drop(page, "sunset.exr", readFileSync(join(ROOT, "tables/inputs/maps/sunset.exr")));
  await said(page, "status", /sunset.exr: 512 × 256, projected to degree 9, with 8 sources/);
  await settled(page);
  assert.ok((await apart(page)) > 1);
  const stages = await page.evaluate(() => stages);
  for (const stage of [/: projecting, \d+ %/, /: finding sources, [1-9]\d? %/]) assert.ok(stages.some((said) => stage.test(said)), `${stage}`);
  await keep(page);
  assert.equal(await page.locator("#light").inputValue(), "own");
  const own = page.url();
  // The shipped light is that of the map.
  const most = await page.evaluate(async () => {
    const { fromHash } = await import("/src/state.js");
    const { lightPreset } = await import("/eigenshade/src/index.js");
    const { light } = fromHash(location.hash).state.ownLight;
    const shipped = await lightPreset("sunset");
    return Math.max(...["r", "g", "b"].flatMap((c) => [...light[c]].map((value, k) => Math.abs(value - shipped[c][k]) / shipped.g[0])));
  });
  assert.ok(most < 1e-3, `${most}`);
  // Its sources are drawn, the first n of them.
  for (const sources of [8, 2, 0]) {
    await choose(page, "sources", sources);
    assert.equal(await text(page, "sources-drawn"), sources ? `${sources} sources drawn.` : "");
  }
  // A link holds a light of one's own.
  await page.goto("about:blank");
  await page.goto(own);
  await settled(page);
  assert.equal(await page.locator("#light").inputValue(), "own");
  await keep(page);
  // Chromaticities are said: those of Rec. 2020 as an attribute before the others, and all places of
  // blocks after it moved.
  const plain = readFileSync(join(ROOT, "tables/inputs/maps/sunset.exr"));
  const attribute = Buffer.alloc("chromaticities".length * 2 + 2 + 4 + 32);
  attribute.write("chromaticities\0chromaticities\0");
  attribute.writeUInt32LE(32, attribute.length - 36);
  [0.708, 0.292, 0.17, 0.797, 0.131, 0.046, 0.3127, 0.329].forEach((value, k) => attribute.writeFloatLE(value, attribute.length - 32 + 4 * k));
  const wide = Buffer.concat([plain.subarray(0, 8), attribute, plain.subarray(8)]);
  const [start, first] = offsets(wide, attribute.length);
  for (let at = start; at < first; at += 8) wide.writeBigUInt64LE(wide.readBigUInt64LE(at) + BigInt(attribute.length), at);
  await drop(page, "wide.exr", wide);
  await said(page, "status", /wide.exr: 512 × 256, .*Its primaries are not those of sRGB, and are ignored\.$/);
  await settled(page);
  await keep(page);
  const sky = Float32Array.from({ length: 3 * 32 * 16 }, (_, k) => (k < 3 * 32 * 8 ? [0.2, 0.5, 2][k % 3] : 0.1));
  await drop(page, "sky.hdr", hdrFile(32, 16, sky));
  await said(page, "status", /sky.hdr: 32 × 16/);
  await settled(page);
  assert.ok((await apart(page)) > 1);
  await keep(page);
  const png = await page.evaluate(async () => {
    const canvas = new OffscreenCanvas(30, 20);
    const context = canvas.getContext("2d");
    context.fillStyle = "#f40";
    context.fillRect(0, 0, 30, 10);
    return [...new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())];
  });
  await drop(page, "wide.png", png);
  await said(page, "status", /wide.png: 30 × 20, .* not twice as wide as high/);
  await settled(page);
  // sRGB: the mean of red is half of 1, of green half of that of code 68, and of blue 0.
  const mean = await page.evaluate(async () => {
    const { fromHash } = await import("/src/state.js");
    const { r, g, b } = fromHash(location.hash).state.ownLight.light;
    return [r, g, b].map((channel) => channel[0] / Math.sqrt(4 * Math.PI));
  });
  [0.5, 0.5 * ((68 / 255 + 0.055) / 1.055) ** 2.4, 0].forEach((level, c) => assert.ok(Math.abs(mean[c] - level) < 1e-4, `${mean}`));
  assert.ok((await apart(page)) > 1);
  await keep(page);
  await drop(page, "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  await said(page, "status", /corner.obj: 1 triangles/);
  await settled(page);
  assert.ok((await apart(page)) > 5);
  assert.equal(await text(page, "fault"), "");
  // Back to the mesh, which the page still has.
  await keep(page);
  await page.evaluate(() => (location.hash = "object=sphere&step=5"));
  await page.waitForFunction(() => document.querySelector("[name=object][value=sphere]").checked);
  await settled(page);
  await page.goBack();
  await page.waitForFunction(() => document.querySelector("[name=object][value=own]").checked);
  await settled(page);
  assert.equal(await apart(page), 0);
  assert.equal(await text(page, "fault"), "");
});

const COPPER = { pbrMetallicRoughness: { baseColorFactor: [0.9, 0.5, 0.3, 1], metallicFactor: 1, roughnessFactor: 0.45 } };

on("a .glb is drawn with its own materials, by scripts that are loaded with it", "object=sphere&sources=auto&pose=0,0,0,1", async (page) => {
  const fetched = [];
  page.on("request", (request) => fetched.push(request.url()));
  const before = await page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name));
  assert.ok(!before.some((name) => /three|model|gltf/.test(name)), before.join());
  await drop(page, "ball.glb", glb({ material: COPPER }));
  await said(page, "status", /^ball\.glb: 12,?096 triangles with its own materials\.$/);
  await settled(page);
  assert.ok(fetched.some((name) => name.endsWith("/vendor/three.js")));
  assert.match(await page.locator("#picture").getAttribute("aria-label"), /its own materials under the light lobby/);
  /** The mean and the largest difference from the module, in codes, inside of the rim. */
  const off = (turn, stops) => page.evaluate(async ([turn, stops]) => {
    const { Scene, lightPreset } = await import("/eigenshade/src/index.js");
    const { disc } = await import("/src/cpu.js");
    const shown = await pixels("own-picture");
    const size = document.getElementById("own-picture").width;
    const { x, y, z, places, coverage } = disc(size);
    const most = Math.max(...(await lightPreset("lobby", { sources: "auto" })).steps.map(({ count }) => count));
    const scene = await Scene.create({ light: "lobby", material: {}, sources: most, window: "none" });
    scene.material({ baseColor: [0.9, 0.5, 0.3], metallic: 1, roughness: 0.45 });
    // The page meters its own pixels, the module others.
    const metered = scene.exposure() * 2 ** stops;
    const picture = (await pixels()).some((code) => code > 0);
    const differences = Array.from({ length: 25 }, (_, k) => k - 12).map((percent) => {
      const codes = scene.turn(turn).pixels(x, y, z, { exposure: metered * (1 + percent / 100) });
      let [sum, largest, count] = [0, 0, 0];
      places.forEach((place, k) => {
        if (coverage[k] < 1 || z[k] < 0.1) return;
        for (let c = 0; c < 3; c++) {
          const apart = Math.abs(codes[4 * k + c] - shown[4 * place + c]);
          [sum, count, largest] = [sum + apart, count + 1, Math.max(largest, apart)];
        }
      });
      return { mean: sum / count, largest, count, picture, percent };
    });
    return differences.sort((one, other) => one.mean - other.mean)[0];
  }, [turn, stops]);
  const near = ({ mean, largest, count, picture, percent }) => assert.ok(mean < 0.7 && largest <= 8 && count > 10_000 && !picture && Math.abs(percent) < 10, `${mean}, ${largest}, ${count}, ${picture}, ${percent}`);
  near(await off([0, 0, 0, 1], 0));
  await tab(page, "scene");
  await slide(page, "exposure", 1);
  near(await off([0, 0, 0, 1], 1));
  await slide(page, "exposure", 0);
  // A drag turns the object, and the light.
  await keep(page, "own-picture");
  await choose(page, "drag", "light");
  const { x, y, width, height } = await page.locator("#picture").boundingBox();
  await page.mouse.move(x + width / 2, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + width / 2 + 40, y + height / 2, { steps: 3 });
  await page.mouse.up();
  await settled(page);
  assert.ok((await apart(page, "own-picture")) > 0.5);
  const turn = await page.evaluate(async () => (await import("/src/state.js")).fromHash(location.hash.slice(1), true).state.turn);
  assert.ok(turn[1] > 0.05, `${turn}`);
  near(await off(turn, 0));
  // The page's own objects, and back.
  await choose(page, "object", "coin");
  assert.equal(await page.locator("#own-picture").isVisible(), false);
  await choose(page, "object", "own");
  assert.equal(await page.locator("#own-picture").isVisible(), true);
  near(await off(turn, 0));
  await drop(page, "corner.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  await said(page, "status", /corner.obj: 1 triangles/);
  await settled(page);
  assert.equal(await page.locator("#own-picture").isVisible(), false);
});

on("a .glb with textures, and a .gltf that holds its data", "object=sphere", async (page) => {
  const checks = { width: 2, height: 2, texels: [255, 0, 0, 255, 0, 0, 255, 255, 0, 0, 255, 255, 255, 0, 0, 255] };
  const material = { pbrMetallicRoughness: { baseColorTexture: { index: "checks" }, metallicFactor: 0, roughnessFactor: 1 }, extensions: { KHR_materials_clearcoat: {} } };
  const file = glb({ shape: "leaf", material, images: { checks }, more: { extensionsUsed: ["KHR_materials_clearcoat"] } });
  await page.evaluate(() => (location.hash = "object=sphere&pose=0,0,0,1&light=park"));
  await settled(page);
  await drop(page, "leaf.glb", file);
  await said(page, "status", /^leaf\.glb: 2 triangles with its own materials, without KHR_materials_clearcoat\.$/);
  await settled(page);
  const corners = await page.evaluate(async () => {
    const [codes, size] = [await pixels("own-picture"), document.getElementById("own-picture").width];
    return [[0.35, 0.35], [0.65, 0.35], [0.35, 0.65], [0.65, 0.65]].map(([x, y]) => {
      const at = 4 * (Math.round(y * size) * size + Math.round(x * size));
      return codes[at] > codes[at + 2] ? "red" : "blue";
    });
  });
  assert.deepEqual(corners, ["red", "blue", "blue", "red"]);
  const [start, size] = [20, file.readUInt32LE(12)];
  const json = JSON.parse(file.subarray(start, start + size));
  json.buffers[0].uri = `data:application/octet-stream;base64,${file.subarray(start + size + 8).toString("base64")}`;
  await drop(page, "leaf.gltf", JSON.stringify(json));
  await said(page, "status", /^leaf\.gltf: 2 triangles/);
});

on("a glTF file that cannot be drawn is said in place, and nothing is lost", "object=coin", async (page) => {
  await keep(page);
  const good = glb({ material: COPPER });
  const other = (change) => {
    const json = { asset: { version: "2.0" }, meshes: [{ primitives: [] }], ...change };
    return JSON.stringify(json);
  };
  for (const [name, bytes, pattern] of [
    ["text.glb", "nothing", /^text.glb cannot be used: it is not a glTF file\. The picture is as it was\.$/],
    ["cut.glb", good.subarray(0, 500), /cut.glb cannot be used: it ends after 500 of \d+ bytes/],
    ["old.gltf", other({ asset: { version: "1.0" } }), /it is glTF of version 1.0; expected 2.0/],
    ["packed.gltf", other({ extensionsUsed: ["KHR_draco_mesh_compression"] }), /it is compressed by Draco; export it without\. The picture/],
    ["new.gltf", other({ extensionsRequired: ["EXT_new"] }), /it needs the extension EXT_new, which is not drawn/],
    ["bare.gltf", other({ meshes: [] }), /it has no mesh\. The picture/],
    ["node.gltf", other({ scene: 0, scenes: [{ nodes: [] }] }), /it has no mesh\. The picture/],
    ["apart.gltf", other({ buffers: [{ byteLength: 4, uri: "apart.bin" }] }), /it refers to the file apart.bin; export a .glb/],
  ]) {
    await drop(page, name, bytes);
    await said(page, "fault", pattern);
    assert.equal(await text(page, "status"), "");
    await settled(page);
    assert.equal(await apart(page), 0, name);
  }
});

on("without WebGL 2 a .glb is not drawn", "object=sphere", async (page) => {
  await drop(page, "ball.glb", glb({ material: COPPER }));
  await said(page, "fault", /ball.glb cannot be used: it needs WebGL 2/);
}, { script: `(${helpers})(); ${NO_WEBGL}` });

test("opened as a file, the page says what to do", async () => {
  const page = await browser.newPage({ viewport: SMALL });
  await page.goto(pathToFileURL(join(SITE, "index.html")).href);
  const said = page.getByRole("alert").filter({ visible: true });
  assert.match(await said.textContent(), /scripts cannot be loaded.*opened as a file.*python3 -m http.server/s);
  for (const id of ["first", "page"]) assert.equal(await page.locator(`#${id}`).isVisible(), false);
  await page.close();
});

on("files that cannot be used are said in place, and nothing is lost", "object=sphere&step=5&sources=0", async (page, faults) => {
  await keep(page);
  const good = hdrFile(32, 16, new Float32Array(3 * 32 * 16).fill(1));
  for (const [name, bytes, pattern] of [
    ["empty.hdr", [], /^empty.hdr cannot be used: it is empty\. The picture is as it was\.$/],
    ["cut.hdr", good.subarray(0, good.length - 5), /cut.hdr cannot be used: it ends within its pixels/],
    ["text.exr", Buffer.from("v/1\x01 is not the whole header"), /text.exr cannot be used/],
    ["a.hdr", Buffer.from("not a panorama"), /a.hdr cannot be used: it is not a valid .hdr file\./],
    ["b.JPG", Buffer.from("nor this"), /b.JPG cannot be used: it is not a valid .JPG file\./],
    ["bright.hdr", hdrFile(32, 16, new Float32Array(3 * 32 * 16).fill(1e37)), /bright.hdr cannot be used: light: r\[0\] is [\d.]+e\+37, expected a number from -1e15 to 1e15/],
    ["film.gif", Buffer.from("GIF89a"), /film.gif cannot be used: gif files are not read; expected .hdr, .exr, .jpg or .png/],
    ["bad.png", Buffer.from("\x89PNG nothing", "latin1"), /bad.png cannot be used/],
    ["no.obj", Buffer.from("v 0 0 0\nf 1 2 3"), /no.obj cannot be used: line 2 refers to vertex 2/],
  ]) {
    await drop(page, name, bytes);
    await said(page, "fault", pattern);
    assert.equal(await text(page, "status"), "");
    await settled(page);
    assert.equal(await apart(page), 0, name);
  }
  // By the button.
  await tab(page, "scene");
  const chooser = page.waitForEvent("filechooser");
  await page.locator("#open-light").click();
  await (await chooser).setFiles({ name: "white.hdr", mimeType: "", buffer: good });
  await said(page, "status", /white.hdr: 32 × 16/);
  assert.equal(await text(page, "fault"), "");
  await page.evaluate(() => (location.hash = "light=nowhere"));
  await said(page, "fault", /This link is not whole: no light is called "nowhere"/);
  // A link counts even if the page saves its state in the address before the event.
  await page.evaluate(() => {
    location.hash = "light=elsewhere";
    history.replaceState(null, "", "#");
  });
  await said(page, "fault", /no light is called "elsewhere"/);
  // A name that every object of JavaScript has.
  await page.evaluate(() => (location.hash = "light=constructor&case=constructor"));
  await said(page, "fault", /This link is not whole: case: "constructor" is not one of sun, direction, rim, behind, bytes; no light is called "constructor"/);
  // What is right in a link counts.
  await page.evaluate(() => (location.hash = "light=nosuch&material=nylon&step=3&object=sphere"));
  await said(page, "fault", /This link is not whole: no light is called "nosuch"/);
  await settled(page);
  assert.equal(await page.locator("#step").inputValue(), "3");
  assert.equal(await page.locator("#picture").getAttribute("aria-label"), "A sphere of nylon under the light lobby");
  await page.goto("about:blank");
  await page.goto(`${server.address}#material=nothing`);
  await settled(page);
  assert.match(await text(page, "fault"), /no material is called "nothing"/);
  assert.equal(await text(page, "cost"), "73 terms + 1 source");
  faults.splice(0, faults.length, ...faults.filter((fault) => !fault.includes("404")));
});

on("without WebGL 2 the CPU draws, alone and split", "object=sphere&step=5", async (page) => {
  assert.match(await text(page, "hint"), /no WebGL 2.* Drag or use arrow keys to turn the light\./);
  const lit = () => page.evaluate(async () => (await pixels()).filter((code, k) => k % 4 === 0 && code > 100).length);
  assert.ok((await lit()) > 5000);
  await keep(page);
  await page.locator("#picture").focus();
  await page.keyboard.press("ArrowLeft");
  await settled(page);
  assert.ok((await apart(page)) > 0.3);
  await keep(page);
  await choose(page, "view", "split");
  assert.ok((await apart(page)) > 5 && (await lit()) > 5000);
  await tab(page, "cases");
  await page.locator("#case").selectOption("rim");
  await said(page, "case-text", /needs WebGL 2/);
}, {
  script: `(${helpers})(); ${NO_WEBGL}`,
});

on("a lost context is said, and comes back", "object=coin&step=5", async (page) => {
  await keep(page);
  const lost = await page.evaluate(async () => {
    const canvas = document.getElementById("picture");
    const extension = canvas.getContext("webgl2").getExtension("WEBGL_lose_context");
    const restored = new Promise((resolve) => canvas.addEventListener("webglcontextrestored", resolve));
    extension.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 50));
    const { textContent: lost } = document.getElementById("status");
    extension.restoreContext();
    await restored;
    return lost;
  });
  assert.match(lost, /^The browser has lost the picture/);
  assert.equal(await text(page, "status"), "");
  await settled(page);
  assert.equal(await apart(page), 0);
});

describe("the page", { concurrency: 4 }, () => tests.forEach((add) => add()));

// The panels of effects, eigenimages, shadows and hard cases.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { apart, keep, on, runs, slide, tab, text } from "./details.js";
import { NO_WEBGL, ROOT, SITE, settled } from "./support.js";

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

runs("panels");

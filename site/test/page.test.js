// The details as a whole: the picture, keyboard and links, and what a browser lacks.

import assert from "node:assert/strict";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { browser } from "./browser.js";
import { CPU, SMALL, apart, choose, helpers, keep, on, runs, said, tab, text } from "./details.js";
import { SITE, open, settled } from "./support.js";

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
}, { script: CPU });

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

test("opened as a file, the page says what to do", async () => {
  const page = await browser.newPage({ viewport: SMALL });
  await page.goto(pathToFileURL(join(SITE, "index.html")).href);
  const said = page.getByRole("alert").filter({ visible: true });
  assert.match(await said.textContent(), /scripts cannot be loaded.*opened as a file.*python3 -m http.server/s);
  for (const id of ["first", "page"]) assert.equal(await page.locator(`#${id}`).isVisible(), false);
  await page.close();
});

runs("the page");

// The panel of accuracy: its slider, numbers, curve and sources.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { screenText, wholeVerdict } from "../src/screen.js";
import { CPU, apart, choose, keep, on, runs, slide, tab, text } from "./details.js";
import { SITE, settled } from "./support.js";

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
}, { script: CPU });

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
}, { script: CPU });

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
}, { script: CPU });

runs("accuracy");

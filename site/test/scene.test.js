// The panel of the scene: lights, materials, objects, and what turns them.

import assert from "node:assert/strict";
import { CPU, apart, choose, keep, on, runs, tab, text } from "./details.js";
import { settled } from "./support.js";

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
}, { script: CPU });

on("inputs that overtake each other: all are shown", "object=sphere&step=3&tab=scene", async (page) => {
  await page.locator("#light").selectOption("night");
  await page.locator("input[name=material][value=red-plastic]").check({ force: true });
  await settled(page);
  const label = await page.locator("#picture").getAttribute("aria-label");
  assert.match(label, /^A sphere of red plastic under the light night$/);
}, { script: CPU });

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

runs("the scene");

// The pages, as a user sees them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open } from "./support.js";

/** The number of colors of a canvas's picture. */
const colors = (page) =>
  page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(() => {
    const { width, height } = document.querySelector("canvas");
    const copy = new OffscreenCanvas(width, height).getContext("2d");
    copy.drawImage(document.querySelector("canvas"), 0, 0);
    resolve(new Set(new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer)).size);
  }))));

for (const name of ["index.html", "matcap.html"]) {
  test(`${name} draws, and follows its controls and a drag`, async () => {
    const { page, faults, close } = await open(name, { width: 300, height: 240 });
    let shown;
    /** Waits for another picture. */
    const changed = async (what) => {
      for (let turn = 0; turn < 40; turn++) {
        const now = await page.locator("canvas").screenshot();
        if (!now.equals(shown)) return (shown = now);
        await page.waitForTimeout(50);
      }
      assert.fail(`the picture stays after ${what}`);
    };
    try {
      await page.waitForFunction(() => document.forms[0].light.options.length > 0);
      for (let turn = 0; turn < 40 && (await colors(page)) <= 300; turn++) await page.waitForTimeout(50);
      assert.ok((await colors(page)) > 300);
      shown = await page.locator("canvas").screenshot();
      await page.selectOption("[name=light]", "studio");
      await changed("a new light");
      await page.selectOption("[name=material]", "red-fabric2");
      await changed("a new material");
      await page.locator("[name=turn]").fill("90");
      await changed("a turn of the light");
      await page.mouse.move(150, 200);
      await page.mouse.down();
      await page.mouse.move(220, 180, { steps: 3 });
      await page.mouse.up();
      await changed("a drag");
      assert.deepEqual(faults, []);
    } finally {
      await close();
    }
  });
}

// The details in a browser: a page for each test, its pixels, and its controls.

import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { browser, server } from "./browser.js";
import { NO_WEBGL, open, settled } from "./support.js";

/** Small, so that rendering in software is fast. */
export const SMALL = { width: 360, height: 480 };

const tests = [];
/** A test of a page, which ends without a fault that it does not expect. `runs` runs all. */
export const on = (name, hash, run, options = {}) =>
  tests.push(() => test(name, async () => {
    const { page, faults } = await open(browser, server.address, { ...SMALL, hash, script: helpers, ...options });
    await run(page, faults);
    assert.deepEqual(faults, []);
    await page.close();
  }));

/** Runs all tests of a file. */
export const runs = (title) => describe(title, { concurrency: 4 }, () => tests.forEach((add) => add()));

/** In the page: `pixels` of a canvas, and `apart`, their mean difference in codes. */
export function helpers() {
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

export const keep = (page, id) => page.evaluate((id) => keep(id).then(() => {}), id);
export const apart = (page, id) => page.evaluate((id) => apart(id), id);
export const text = (page, id) => page.locator(`#${id}`).textContent();
export const slide = async (page, id, value) => {
  await page.locator(`#${id}`).fill(String(value));
  await settled(page);
};
export const tab = (page, name) => page.locator(`#tab-${name}`).click().then(() => settled(page));
/** Clicks a radio button, whose label covers it. */
export const choose = async (page, name, value) => {
  await page.locator(`input[name=${name}][value="${value}"]`).check({ force: true });
  await settled(page);
};
/** Waits until an element says it. */
export const said = (page, id, pattern) =>
  page.waitForFunction(([id, source]) => new RegExp(source).test(document.getElementById(id).textContent), [id, pattern.source]);

/** The script of a page on which the CPU draws. */
export const CPU = `(${helpers})(); ${NO_WEBGL}`;

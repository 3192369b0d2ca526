// The first sight in a browser.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { FIRST, began } from "../src/begin.js";
import { toward } from "../src/follow.js";
import { MOST } from "../src/packed.js";
import { LIGHT, SOURCES } from "../src/parts.js";
import { browser, server } from "./browser.js";
import { NO_WEBGL, ROOT, SITE, eggFile, open, settled } from "./support.js";

/** In the page: the mean place of the light on the object, each from -1 to 1, and the mean code. */
function brightness() {
  const canvas = document.getElementById("object");
  const side = 96;
  const context = new OffscreenCanvas(side, side).getContext("2d");
  context.drawImage(canvas, 0, 0, side, side);
  const { data } = context.getImageData(0, 0, side, side);
  const sum = { x: 0, y: 0, all: 0 };
  for (let k = 0; k < side * side; k++) {
    const code = data[4 * k] + data[4 * k + 1] + data[4 * k + 2];
    sum.x += code * ((2 * (k % side)) / side - 1);
    sum.y += code * (1 - (2 * Math.floor(k / side)) / side);
    sum.all += code;
  }
  return { x: sum.x / sum.all, y: sum.y / sum.all, mean: sum.all / (3 * side * side) };
}

const text = (page, id) => page.locator(`#${id}`).textContent();

describe("the first sight", { concurrency: 2 }, () => {
  test("before the first picture there are at most ten requests and 200 KB, without compression", async () => {
    const page = await browser.newPage({ viewport: { width: 390, height: 780 } });
    await page.goto(server.address);
    await page.waitForFunction(() => performance.getEntriesByName("first-picture").length);
    const { count, bytes, names } = await page.evaluate(() => {
      const [{ startTime }] = performance.getEntriesByName("first-picture");
      const [whole] = performance.getEntriesByType("navigation");
      const parts = performance.getEntriesByType("resource").filter(({ name, startTime: at }) => at < startTime && !name.endsWith("icon.svg"));
      return { count: 1 + parts.length, bytes: [whole, ...parts].reduce((sum, { transferSize }) => sum + transferSize, 0), names: parts.map(({ name }) => name) };
    });
    // The icon may be asked for later, or not at all.
    const [requests, all] = [count + 1, bytes + statSync(join(SITE, "icon.svg")).size];
    assert.ok(requests <= 10 && all <= 200e3, `${requests} requests, ${all} bytes: ${names}`);
    const [, said, asked] = /^\| before the first picture \| (\d+) \| (\d+) requests/m.exec(readFileSync(join(SITE, "README.md"), "utf8"));
    assert.ok(Math.abs(all / 1e3 - Number(said)) < 2 && requests === Number(asked), `${requests} requests, ${all} bytes`);
    assert.ok(names.some((name) => name.endsWith("egg.bin")) && !names.some((name) => name.endsWith(".wasm")), `${names}`);
    // All later modules are fetched at once.
    await settled(page);
    const later = await page.evaluate(() => [performance.getEntriesByType("resource").map(({ name }) => name), Array.from(document.querySelectorAll("[rel=modulepreload]"), ({ href }) => href)]);
    const scripts = later[0].filter((name) => name.endsWith(".js") && !name.endsWith("/first.js"));
    assert.deepEqual([...new Set(scripts)].sort(), [...later[1]].sort());
    // The picture is there, with the object in the middle and nothing in the corners.
    assert.ok((await page.evaluate(brightness)).mean > 15);
    await page.close();
  });

  for (const [how, script] of [["WebGL 2", undefined], ["the CPU", NO_WEBGL]]) {
    test(`the light follows the pointer and the arrow keys, drawn by ${how}`, async () => {
      const { page, faults } = await open(browser, server.address, { width: 640, height: 700, script });
      const box = await page.locator("#object").boundingBox();
      const at = async (x, y) => {
        await page.mouse.move(box.x + (box.width * (1 + x)) / 2, box.y + (box.height * (1 - y)) / 2);
        await settled(page);
        return page.evaluate(brightness);
      };
      const [left, right, above, below] = [await at(-0.6, 0), await at(0.6, 0), await at(0, 0.6), await at(0, -0.6)];
      assert.ok(right.x > left.x + 0.05, `${left.x} ${right.x}`);
      assert.ok(above.y > below.y + 0.05, `${below.y} ${above.y}`);
      await page.locator("#object").focus();
      for (let k = 0; k < 12; k++) await page.keyboard.press("ArrowUp");
      await settled(page);
      assert.ok((await page.evaluate(brightness)).y > below.y + 0.05);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }

  test("both ways to draw give the same pixels, between four of the object's", async () => {
    const [gl, cpu] = await Promise.all([undefined, NO_WEBGL].map(async (script) => {
      const { page } = await open(browser, server.address, { width: 390, height: 780, script });
      const picture = await page.evaluate(() => {
        const { width } = document.getElementById("object");
        const context = new OffscreenCanvas(width, width).getContext("2d");
        context.drawImage(document.getElementById("object"), 0, 0);
        return { side: width, data: [...context.getImageData(0, 0, width, width).data] };
      });
      await page.close();
      return picture;
    }));
    assert.equal(gl.side, cpu.side);
    const { width, height, texels } = await eggFile();
    const isWhole = (x, y) => x >= 0 && x < width && texels[4 * (width * y + x) + 3] >> 2 === 63;
    const codeOf = (x, y, c) => cpu.data[4 * (cpu.side * (y + ((cpu.side - height) >> 1)) + x + ((cpu.side - width) >> 1)) + c];
    // Places of the screen's pixels among the object's.
    const along = (at, whole) => ((at + 0.5 - gl.side / 2) * height) / (0.94 * gl.side) + whole / 2 - 0.5;
    let [count, most, sum] = [0, 0, 0];
    for (let row = 20; row < gl.side - 20; row++) {
      for (let column = 0; column < gl.side; column++) {
        const [x, y] = [along(column, width), along(row, height)];
        const [left, above] = [Math.floor(x), Math.floor(y)];
        const corners = [[0, 0], [1, 0], [0, 1], [1, 1]];
        if (!corners.every(([right, down]) => isWhole(left + right, above + down))) continue;
        for (let c = 0; c < 3; c++) {
          const expected = corners.reduce((all, [right, down]) => all + (right ? x - left : 1 - x + left) * (down ? y - above : 1 - y + above) * codeOf(left + right, above + down, c), 0);
          const apart = Math.abs(expected - gl.data[4 * (gl.side * row + column) + c]);
          [count, most, sum] = [count + 1, Math.max(most, apart), sum + apart];
        }
      }
    }
    assert.ok(count > 3e5 && most < 4 && sum / count < 0.6, `${count} codes, off by ${sum / count}, at most ${most}`);
  });

  test("where WebGL 2 does not link the program, the CPU draws", async () => {
    const script = `const { linkProgram } = WebGL2RenderingContext.prototype;
      WebGL2RenderingContext.prototype.linkProgram = function (program) {
        this.shaderSource(this.getAttachedShaders(program)[1], "?");
        this.compileShader(this.getAttachedShaders(program)[1]);
        linkProgram.call(this, program);
      };`;
    const { page } = await open(browser, server.address, { width: 390, height: 780, script });
    assert.ok((await page.evaluate(brightness)).mean > 15);
    await page.close();
  });

  test("a picture that the driver takes away is said, until it comes back", async () => {
    const { page } = await open(browser, server.address, { width: 390, height: 780 });
    await page.evaluate(() => {
      globalThis.losing = document.getElementById("object").getContext("webgl2").getExtension("WEBGL_lose_context");
      globalThis.losing.loseContext();
    });
    await page.waitForFunction(() => /took the picture away/.test(document.getElementById("first-fault").textContent));
    await page.evaluate(() => globalThis.losing.restoreContext());
    await page.waitForFunction(() => !document.getElementById("first-fault").textContent);
    assert.ok((await page.evaluate(brightness)).mean > 15);
    await page.close();
  });

  test("a drag of a finger turns the light", async () => {
    const { page } = await open(browser, server.address, { width: 390, height: 780, hasTouch: true, script: NO_WEBGL });
    assert.ok(!(await page.getByText("The light follows the pointer").isVisible()) && (await page.getByText("Drag on the egg: the light follows.").isVisible()));
    const { x, y, width } = await page.locator("#object").boundingBox();
    const session = await page.context().newCDPSession(page);
    const touch = async (type, ...shares) => {
      const touchPoints = shares.map((share) => ({ x: x + share * width, y: y + width / 2 }));
      await session.send("Input.dispatchTouchEvent", { type, touchPoints });
      await settled(page);
      return (await page.evaluate(brightness)).x;
    };
    const left = await touch("touchStart", 0.2);
    for (const share of [0.35, 0.5, 0.65]) await touch("touchMove", share);
    const right = await touch("touchMove", 0.8);
    assert.ok(right > left + 0.05, `${left} ${right}`);
    await touch("touchEnd");
    await page.close();
  });

  test("the page is busy until the light has arrived", async () => {
    const { page } = await open(browser, server.address, { width: 390, height: 780, reducedMotion: "no-preference", script: NO_WEBGL });
    const { x, y, width } = await page.locator("#object").boundingBox();
    await page.mouse.move(x + 0.2 * width, y + width / 2);
    await settled(page);
    await page.evaluate(() => {
      const { dataset } = document.documentElement;
      globalThis.settledTimes = 0;
      new MutationObserver(() => dataset.busy === "false" && globalThis.settledTimes++).observe(document.documentElement, { attributes: true });
    });
    await page.mouse.move(x + 0.8 * width, y + width / 2);
    await page.waitForTimeout(2000);
    await settled(page);
    assert.equal(await page.evaluate(() => globalThis.settledTimes), 1);
    await page.close();
  });

  test("until it is led, the light turns slowly for ten seconds, but not for readers who prefer less motion", async () => {
    for (const reducedMotion of ["no-preference", "reduce"]) {
      const page = await browser.newPage({ viewport: { width: 390, height: 780 }, reducedMotion });
      await page.addInitScript(NO_WEBGL);
      await page.goto(server.address);
      await settled(page);
      const before = await page.evaluate(brightness);
      await page.waitForTimeout(1500);
      const now = await page.evaluate(brightness);
      const moved = Math.hypot(now.x - before.x, now.y - before.y);
      assert.ok(reducedMotion === "reduce" ? moved === 0 : moved > 0.01, `${reducedMotion}: ${moved}`);
      // It stops after ten seconds.
      await page.waitForTimeout(11e3);
      await settled(page);
      const late = await page.evaluate(brightness);
      await page.waitForTimeout(500);
      assert.deepEqual(await page.evaluate(brightness), late);
      await page.close();
    }
  });

  test("the slider changes picture, color difference and frames, and the chip the frames", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, script: NO_WEBGL });
    const slide = async (step) => {
      await page.locator("#first-step").fill(String(step));
      await settled(page);
      return { difference: Number(await text(page, "difference")), seen: await text(page, "seen"), stays: Number(await text(page, "stays")), frames: Number(await text(page, "frames")), picture: await page.evaluate(brightness) };
    };
    const [few, some, all] = [await slide(0), await slide(14), await slide(40)];
    assert.ok(all.difference >= all.stays && all.difference - all.stays < 0.11 && all.stays > 0.4 && few.stays === all.stays, JSON.stringify([few, all]));
    assert.ok(few.difference > 4 && few.difference > some.difference && some.difference > all.difference, JSON.stringify([few, some, all]));
    assert.deepEqual([few, some, all].map(({ seen }) => seen), ["visible", "close", "not visible"]);
    assert.ok(few.frames > all.frames && all.frames > 5);
    assert.notDeepEqual(few.picture, all.picture);
    // The same chip has the same frames, also after the error was measured.
    const { frames } = await slide(9);
    await page.locator("#chip").dispatchEvent("change");
    assert.equal(Number(await text(page, "frames")), frames);
    // Chips of one instruction set differ by their clocks.
    const { frameOf, CHIPS } = await import("../src/boards.js");
    const rates = [];
    for (const { name, clock, core, board } of CHIPS) {
      await page.locator("#chip").selectOption(name);
      rates.push(Number(await text(page, "frames")));
      assert.match(await text(page, "frame-cost"), new RegExp(`^[\\d.]+ million instructions of a ${core.replace("+", "\\+")} at ${clock / 1e6} MHz${core.startsWith(board.name) ? "" : `, counted on a ${board.name}`}$`));
    }
    assert.ok(Math.abs(rates[5] / rates[4] - 480 / 150) < 0.2, `${rates}`);
    assert.ok(frameOf(CHIPS[0].board, [], 0) < 1e5);
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("details open with the accuracy of the first sight, by a link and back, and with any state", async () => {
    const { page, faults } = await open(browser, server.address, { width: 390, height: 780, script: NO_WEBGL });
    assert.ok(!(await page.locator("#page").isVisible()) && !(await page.locator("#copy").isVisible()));
    const { step } = FIRST;
    assert.deepEqual([await page.locator("#first-step").inputValue(), await page.locator("#open-details").getAttribute("href")], [String(step), `#step=${step}`]);
    await page.locator("#first-step").fill("9");
    await page.locator("#open-details").click();
    await page.waitForFunction(() => document.getElementById("terms").textContent);
    await settled(page);
    assert.ok(await page.locator("#page").isVisible());
    assert.equal(await page.locator("#step").inputValue(), "9");
    assert.ok(!(await page.locator("#first").isVisible()));
    const focused = () => page.evaluate(() => document.activeElement?.id);
    assert.equal(await focused(), "picture");
    // The initial state has a link, too.
    await page.locator("#step").fill("14");
    await page.waitForFunction(() => location.hash === "#details");
    await page.getByRole("link", { name: "Close details" }).click();
    assert.ok(await page.locator("#first").isVisible());
    assert.equal(await focused(), "open-details");
    // The accuracy stays.
    await settled(page);
    assert.deepEqual([await page.locator("#first-step").inputValue(), await page.locator("#open-details").getAttribute("href")], ["14", "#step=14"]);
    assert.equal(await page.locator("#first-step").getAttribute("aria-valuetext"), `color difference ${await text(page, "difference")}, ${await text(page, "frames")} frames a second`);
    assert.ok(!(await page.locator("#page").isVisible()));
    await page.goBack();
    assert.ok(await page.locator("#page").isVisible());
    assert.deepEqual(faults, []);
    await page.close();
  });

  test("details that cannot be loaded are said, and a link tries again", async () => {
    const page = await browser.newPage({ viewport: { width: 390, height: 780 }, reducedMotion: "reduce" });
    let isMissing = true;
    await page.route("**/main.js", (route) => (isMissing ? route.abort() : route.continue()));
    await page.goto(server.address);
    await settled(page);
    await page.locator("#open-details").click();
    await page.waitForFunction(() => document.getElementById("first-fault").textContent);
    assert.match(await text(page, "first-fault"), /^The details cannot be shown: /);
    assert.ok(await page.locator("#first").isVisible());
    isMissing = false;
    await page.locator("#open-details").click();
    await page.waitForFunction(() => document.getElementById("terms").textContent);
    assert.ok(await page.locator("#page").isVisible());
    assert.equal(await text(page, "first-fault"), "");
    await page.close();
  });

  test("a file that is missing is said in place", async () => {
    const page = await browser.newPage();
    await page.route("**/egg.bin", (route) => route.fulfill({ status: 404 }));
    await page.goto(server.address);
    await settled(page);
    assert.equal(await text(page, "first-fault"), "The picture cannot be drawn: object/egg.bin: 404; run site/build");
    await page.close();
  });

  test("the file of the egg has the packed pixels, of which the left half mirrors the right one", async () => {
    const { width, height, texels, palettes, about } = await eggFile();
    const packed = readFileSync(join(ROOT, "target/page/egg.packed"));
    const [wide, rows] = [packed.readUInt16LE(6), 12 + 6 * packed.readUInt16LE(10)];
    const [apart, counts] = [[0, 0, 0], [0, 0]];
    for (let row = 0; row < height; row++) {
      const [first, last] = [row, row + 1].map((k) => rows + 4 * (height + 1) + 6 * packed.readUInt32LE(rows + 4 * k));
      for (let at = first; at < last; ) {
        const [start, length] = [packed.readUInt16LE(at), packed.readUInt16LE(at + 2)];
        at += 6;
        for (let column = start; column < start + length; column++, at += 6) {
          const texel = 4 * (row * width + column - (wide - width) / 2);
          const side = Number(column < wide / 2);
          counts[side]++;
          const off = Math.hypot(packed.readInt8(at) + 128 - texels[texel], packed.readInt8(at + 1) + 128 - texels[texel + 1]);
          if (!side) assert.equal(off, 0, `row ${row}, column ${column}`);
          else apart[off > 2 ? 2 : 0]++;
        }
      }
    }
    assert.ok(Math.abs(counts[0] - counts[1]) < 500 && apart[2] < 0.03 * counts[1], `${counts} ${apart}`);
    // The errors of all terms are those of the shipped lights, between two roughnesses.
    const errors = readFileSync(join(ROOT, "tables/inputs/sources.errors.csv"), "utf8").split("\n").map((line) => line.split(","));
    for (const { metallic, roughness, direct } of about.regions) {
      const sources = roughness < 0.6 ? SOURCES : 0;
      const row = errors.find((row) => row.slice(0, 5).join() === `${LIGHT},${sources},9,7,${metallic < 0.5 ? "dielectric" : "metal"}`);
      const tenth = Math.min(5, Math.floor(10 * roughness));
      for (const [value, first] of [[direct.mean, 5], [direct.most, 11]]) {
        const [a, b] = [tenth - 1, tenth].map((k) => Number(row[first + k]));
        assert.ok(value <= Math.max(a, b) + 1e-9 && value >= Math.min(a, b) - 1e-9, `${roughness}: ${value} of ${a} and ${b}`);
      }
    }
    // The palettes of the first light, in 8 bits.
    const { palettes: exact, parts, exposure } = await began(about.regions);
    exact.forEach((value, k) => assert.ok(Math.abs(value - palettes[k]) <= 0.012 + 0.02 * value, `${k}: ${value} ${palettes[k]}`));
    // No light is clipped.
    for (let k = 0; k < 16; k++) {
      parts.set(toward([0, 1].map((axis) => 0.6 * Math.cos((k * Math.PI) / 8 - (axis * Math.PI) / 2))), undefined, exposure);
      assert.ok(parts.palettes(exposure).every((value) => value < MOST));
    }
  });
});

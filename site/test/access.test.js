// Accessibility by axe-core, motion, and what the page looks like.

import assert from "node:assert/strict";
import { readFileSync, statSync } from "node:fs";
import { join } from "node:path";
import { describe, test } from "node:test";
import { browser, server } from "./browser.js";
import { SIZES } from "./screenshots.js";
import { NO_WEBGL, ROOT, SITE, open, settled } from "./support.js";

const AXE = readFileSync(join(SITE, "node_modules/axe-core/axe.min.js"), "utf8");

describe("the page", { concurrency: 4 }, () => {
  for (const [colorScheme, width, height] of [["light", 360, 560], ["dark", 360, 560], ["dark", 1000, 560]]) {
    test(`axe finds nothing, ${colorScheme}, ${width} wide`, async () => {
      const { page, faults } = await open(browser, server.address, { width, height, colorScheme, hash: "step=4&view=split", script: NO_WEBGL });
      await page.evaluate(AXE);
      // With the menu open, then without: a click elsewhere closes it.
      await page.locator("#take summary").click();
      assert.deepEqual((await page.evaluate(() => axe.run())).violations.map(({ id }) => id), []);
      await page.locator("h1").click();
      assert.ok(!(await page.locator("#take button").first().isVisible()));
      for (const tab of width < 960 ? ["scene", "accuracy", "effects", "images", "shadows", "cases"] : ["effects"]) {
        await page.locator(`#tab-${tab}`).click();
        await settled(page);
        const found = await page.evaluate(async () => {
          const { violations, passes } = await axe.run();
          return { passes: passes.length, violations: violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120))}`) };
        });
        assert.deepEqual(found.violations, [], tab);
        assert.ok(found.passes > 20);
      }
      // axe finds what is wrong: a picture without a name.
      const planted = await page.evaluate(async () => {
        document.getElementById("frame").append(document.createElement("img"));
        return (await axe.run()).violations.map(({ id }) => id);
      });
      assert.deepEqual(planted, ["image-alt"]);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }

  for (const [colorScheme, width, height] of [["light", 390, 780], ["dark", 390, 780], ["light", 1440, 900], ["dark", 1440, 900]]) {
    test(`axe finds nothing at first sight, ${colorScheme}, ${width} wide`, async () => {
      const { page, faults } = await open(browser, server.address, { width, height, colorScheme, script: NO_WEBGL });
      await page.evaluate(AXE);
      const found = await page.evaluate(async () => {
        const { violations, passes } = await axe.run();
        return { passes: passes.length, violations: violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120))}`) };
      });
      assert.deepEqual(found.violations, []);
      assert.ok(found.passes > 20, `${found.passes}`);
      assert.deepEqual(faults, []);
      await page.close();
    });
  }

  test("in forced colors what is chosen looks different", async () => {
    const { page } = await open(browser, server.address, { width: 1200, forcedColors: "active", hash: "step=4&tab=effects&effects=ambient", script: NO_WEBGL });
    for (const [chosen, other, part, ...properties] of [
      ["[name=object]:checked + span", "[name=object]:not(:checked) + span", undefined, "backgroundColor", "color"],
      ["#thumbs label:has(:checked)", "#thumbs label:not(:has(:checked))", undefined, "borderTopColor"],
      ["[role=tab][aria-selected=true]", "[role=tab][aria-selected=false]", undefined, "borderBottomColor"],
      ["#effect-ambient", "#effect-gloss", undefined, "backgroundColor"],
      ["#effect-ambient", "#effect-gloss", "::after", "backgroundColor", "translate"],
    ]) {
      const styles = await page.evaluate(([selectors, part, properties]) => selectors.map((selector) => {
        const style = getComputedStyle(document.querySelector(selector), part);
        return properties.map((name) => style[name]);
      }), [[chosen, other], part, properties]);
      properties.forEach((name, k) => assert.notEqual(styles[0][k], styles[1][k], `${chosen}${part ?? ""} ${name}`));
    }
    // A switch is not of the color of its own background.
    for (const id of ["#effect-ambient", "#effect-gloss"]) {
      const [track, knob] = await page.evaluate((id) => [undefined, "::after"].map((part) => getComputedStyle(document.querySelector(id), part).backgroundColor), id);
      assert.notEqual(knob, track);
    }
    await page.close();
  });

  test("the picture that arrow keys turn is an application with a name", async () => {
    const { page } = await open(browser, server.address, { hash: "object=sphere&step=4", script: NO_WEBGL });
    const picture = page.getByRole("application", { name: "A sphere of gold metallic paint under the light lobby" });
    assert.equal(await picture.getAttribute("id"), "picture");
    await page.close();
  });

  test("without motion, switches jump and growing takes a second a step", async () => {
    for (const [reducedMotion, duration] of [["reduce", "0s"], ["no-preference", "0.12s"]]) {
      const { page } = await open(browser, server.address, { width: 360, height: 480, reducedMotion, hash: "step=4&tab=images", script: NO_WEBGL });
      assert.equal(await page.evaluate(() => getComputedStyle(document.querySelector("[role=switch]"), "::after").transitionDuration), duration);
      await page.locator("#grow").click();
      const start = Date.now();
      await page.waitForFunction(() => { const count = parseInt(document.getElementById("components-value").textContent); return count >= 2 && count < 160; });
      if (reducedMotion === "reduce") assert.ok(Date.now() - start > 1500);
      await page.close();
    }
  });

  for (const [width, height] of [[740, 360], [640, 320], [560, 300]]) {
    test(`on a phone on its side, ${width} x ${height}, picture and panels have room`, async () => {
      const { page } = await open(browser, server.address, { width, height, hash: "details", script: NO_WEBGL });
      for (const tab of ["scene", "accuracy", "effects", "images", "shadows", "cases"]) {
        await page.locator(`#tab-${tab}`).click();
        const box = async (id) => (await page.locator(`#${id}`).boundingBox());
        const [panel, picture] = [await box(tab), await box("picture")];
        assert.ok(panel.height > 0.6 * height && panel.width > 250 && panel.y + panel.height <= height + 1, `${tab}: ${JSON.stringify(panel)}`);
        assert.ok(picture.height > 100 && picture.x + picture.width <= panel.x, JSON.stringify(picture));
        const step = await box("step");
        assert.ok(step.y + step.height <= height, JSON.stringify(step));
      }
      const beyond = await page.evaluate(() => [document.documentElement, ...document.querySelectorAll(".panel, .stage, header, .tabs")].map((part) => part.scrollWidth - part.clientWidth));
      assert.ok(beyond.every((pixels) => pixels <= 0), `${beyond}`);
      await page.close();
    });
  }

  for (const width of [960, 1050, 1150, 1280]) {
    test(`${width} pixels wide, picture, slider and columns have room`, async () => {
      const { page } = await open(browser, server.address, { width, height: 700, hash: "details", script: NO_WEBGL });
      for (const [id, least] of [["picture", 350], ["step", 200], ["scene", 220], ["accuracy", 260], ["light", 90], ["exposure", 90]]) {
        const box = await page.locator(`#${id}`).boundingBox();
        assert.ok(box.width >= least && box.x >= 0 && box.x + box.width <= width, `${id}: ${JSON.stringify(box)}`);
      }
      const beyond = await page.evaluate(() => [document.documentElement, ...document.querySelectorAll(".panel, .stage, header, .tabs")].map((part) => part.scrollWidth - part.clientWidth));
      assert.ok(beyond.every((pixels) => pixels <= 0), `${beyond}`);
      await page.close();
    });
  }

  test("a page that has no room for a panel scrolls to all of it", async () => {
    const { page } = await open(browser, server.address, { width: 360, height: 300, hash: "details", script: NO_WEBGL });
    const [shown, all] = await page.evaluate(() => [document.documentElement, document.querySelector("#accuracy")].map((part) => [part.scrollHeight, part.clientHeight]));
    assert.ok(shown[0] > all[0] && all[0] <= all[1], `${shown}, ${all}`);
    await page.locator("#model").scrollIntoViewIfNeeded();
    assert.ok((await page.locator("#model").boundingBox()).y < 300);
    await page.close();
  });

  for (const [width, height] of SIZES) {
    test(`${width} pixels wide, nothing is cut off, and the committed picture is of this page`, async () => {
      const { page } = await open(browser, server.address, { width, height });
      const sizes = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight,
        ...[...document.querySelectorAll("#first, .say, header")].filter((part) => part.offsetParent).map((part) => part.scrollWidth - part.clientWidth)]);
      assert.deepEqual(sizes.slice(0, 2), [width, height]);
      assert.ok(sizes.slice(2).every((beyond) => beyond <= 0), `${sizes}`);
      const path = join(ROOT, `docs/site-${width}.png`);
      assert.ok(statSync(path).size < 300e3);
      const shot = (await page.screenshot()).toString("base64");
      const apart = await page.evaluate(async (pictures) => {
        const small = await Promise.all(pictures.map(async (base64) => {
          const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
          const context = new OffscreenCanvas(48, 48).getContext("2d");
          context.imageSmoothingQuality = "high";
          context.drawImage(bitmap, 0, 0, 48, 48);
          return context.getImageData(0, 0, 48, 48).data;
        }));
        return small[0].reduce((sum, code, k) => sum + Math.abs(code - small[1][k]), 0) / small[0].length;
      }, [shot, readFileSync(path).toString("base64")]);
      assert.ok(apart < 4, `${apart}`);
      await page.close();
    });
  }
});

// Panoramas and meshes that are opened.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { server } from "./browser.js";
import { apart, choose, keep, on, runs, said, tab, text } from "./details.js";
import { drop, hdrFile, offsets } from "./files.js";
import { ROOT, settled } from "./support.js";

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

runs("files");

// The page's mathematics in Node, against the committed counts, the program and other ways to
// compute it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { integrals, irradiance, texels } from "../../examples/three/reference.js";
import { EIGENSHADE } from "../../packages/eigenshade/test/support/own.js";
import { engine } from "../eigenshade/src/engine.js";
import { metered } from "../eigenshade/src/exposure.js";
import { EFFECTS, Scene, lightPreset } from "../eigenshade/src/index.js";
import { BOARDS, CHIPS, frameOf, instructions } from "../src/boards.js";
import { ANALYTIC, ambient, directional, disc, harmonics, windowed } from "../src/harmonics.js";
import * as measure from "../src/measure.js";
import { nineTerms, shadeNine } from "../src/nine.js";
import { coin, coinNormals, parseObj, relief } from "../src/objects.js";
import { percent } from "../src/plot.js";
import { project, resized } from "../src/project.js";
import { FINE, MOST, pursue } from "../src/pursuit.js";
import { parseHdr } from "../src/rgbe.js";
import { colorsOf, screenError, verdict, wholeVerdict } from "../src/screen.js";
import { AUTOMATIC, fromHash, initial, toHash } from "../src/state.js";
import { dragged, multiply, rotate } from "../src/turn.js";
import parseExr from "../vendor/parse-exr.js";
import { quantized } from "../quantize.js";
import { hdrFile } from "./files.js";
import { ROOT, SITE } from "./support.js";

// The modules of the page are those with sources.
await engine(true);

const table = (path) => {
  const [head, ...rows] = readFileSync(join(ROOT, path), "utf8").split("\n").filter((line) => line && !line.startsWith("#"));
  const names = head.split(",");
  return rows.map((row) => Object.fromEntries(row.split(",").map((value, k) => [names[k], value])));
};
const near = (one, other, tolerance) => assert.ok(Math.abs(one - other) <= tolerance, `${one}: ${other}`);

test("the lines of the boards are fits to the committed counts", () => {
  const settings = table("docs/accuracy-cost/accuracy-cost.csv");
  const counts = table("firmware/counts.csv");
  for (const { board, format, base, each, within, source } of BOARDS) {
    const count = (operation) => Number(counts.find((row) => row.board === board && row.format === format && row.operation === operation)?.instructions);
    near(source, (count("highlights") - count("color")) / 4, 0.5);
    const column = board === "microbit" ? "m0_pixel" : "m4f_pixel";
    // The terms of a counted table are those of the setting with its count.
    const points = counts
      .filter((row) => row.board === board && row.format === format && /^(first_\d+|full|curet)\/pixel$/.test(row.operation))
      .map(({ instructions, operation }) => {
        const row = settings.find((row) => row.way === "polynomial" && row.format === format && row.setting.startsWith("9/7") && row[column] === instructions);
        assert.ok(row, operation);
        return [Number(row.terms), Number(instructions)];
      });
    assert.equal(points.length, 7);
    let [s, st, stt, sy, sty] = [0, 0, 0, 0, 0];
    for (const [t, y] of points) {
      const w = 1 / y;
      [s, st, stt, sy, sty] = [s + w, st + w * t, stt + w * t * t, sy + w * y, sty + w * t * y];
    }
    const slope = (s * sty - st * sy) / (s * stt - st * st);
    near(each, slope, 0.006);
    near(base, (sy - slope * st) / s, 0.06);
    const worst = Math.max(...points.map(([t, y]) => Math.abs((base + each * t) / y - 1)));
    assert.ok(worst <= within && worst > within - 0.01, `${board}: ${worst}`);
    assert.equal(instructions({ base, each, source }, 100, 2), 3 * (base + 100 * each) + 2 * source);
  }
});

test("a frame of the counted object costs what was counted, and terms and pixels change it in proportion", () => {
  const counts = table("firmware/counts.csv");
  const described = execFileSync(EIGENSHADE, ["info", "--table", join(ROOT, "tables/sphere.bin")], { encoding: "utf8" });
  const terms = Number(/^terms +(\d+)$/m.exec(described)[1]);
  for (const board of BOARDS) {
    const count = (operation) => Number(counts.find((row) => row.board === board.board && row.format === board.format && row.operation === operation).instructions);
    const { turned, still, turn } = board.frame;
    assert.deepEqual([turned, still, turn], ["frame_textured", "frame_textured_still", "turn"].map(count));
    const parts = (terms, sources = 0) => [0, 1].map(() => ({ terms, sources }));
    const pixels = Math.PI * 60 ** 2;
    near(frameOf(board, parts(terms), pixels), turned, 1);
    near(frameOf(board, parts(terms), 3 * pixels), turned + 2 * still, 1);
    near(frameOf(board, [...parts(terms), ...parts(terms)], pixels), 2 * turned - still - turn, 1);
    near(frameOf(board, parts(terms, 1), pixels), turned + 2 * 803 * board.source, 1);
    const few = (frameOf(board, parts(10), 0) - turn) / (frameOf(board, parts(100), 0) - turn);
    near(few, instructions(board, 10) / instructions(board, 100), 1e-9);
  }
  for (const { board } of CHIPS) assert.ok(BOARDS.includes(board));
});

/** A shipped map, row 0 at the top. */
function mapOf(name) {
  const bytes = readFileSync(join(ROOT, `tables/inputs/maps/${name}.exr`));
  const { width, height, data } = parseExr(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 1015);
  const flipped = Float32Array.from({ length: 4 * width * height }, (_, k) => data[4 * width * (height - 1 - Math.floor(k / 4 / width)) + (k % (4 * width))]);
  return { width, height, stride: 4, data: flipped };
}

test("maps give the light of the program", () => {
  for (const name of ["park", "sunset", "hall"]) {
    const path = join(ROOT, `tables/inputs/maps/${name}.exr`);
    const found = project(mapOf(name));
    const rows = execFileSync(EIGENSHADE, ["light", "-q", path], { encoding: "utf8" }).trim().split("\n").slice(1);
    const expected = rows.map((row) => row.split(",").slice(3).map(Number));
    assert.equal(expected.length, 100);
    const peak = Math.max(...expected.flat().map(Math.abs));
    // parse-exr cuts halves off instead of rounding them.
    for (const [c, channel] of ["r", "g", "b"].entries()) {
      expected.forEach((row, k) => near(found[channel][k], row[c], (name === "park" && c === 2 ? 4e-3 : 1e-3) * peak));
    }
  }
});

test("a map of floats gives the light of the program to 1e-5", () => {
  const [width, height] = [64, 32];
  const data = Float32Array.from({ length: 3 * width * height }, (_, k) => 1 + Math.sin(k * 0.37) + (k % 97 === 0 ? 20 : 0));
  // RGBE, so that both read the same numbers.
  const file = hdrFile(width, height, data);
  const map = parseHdr(file.buffer.slice(file.byteOffset, file.byteOffset + file.length));
  const found = project(map);
  const path = join(ROOT, "target", "site-test.hdr");
  execFileSync("tee", [path], { input: file, stdio: ["pipe", "ignore", "inherit"] });
  const rows = execFileSync(EIGENSHADE, ["light", "-q", path], { encoding: "utf8" }).trim().split("\n").slice(1);
  rows.forEach((row, k) => row.split(",").slice(3).forEach((value, c) => near(found[["r", "g", "b"][c]][k], Number(value), 1e-4)));
});

test(".hdr files that are wrong say why", () => {
  const good = hdrFile(16, 8, new Float32Array(3 * 16 * 8).fill(1));
  const read = (bytes) => parseHdr(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  assert.equal(read(good).data[0], 128.5 / 128);
  // A channel of mantissa 0 is half a step, and exponent 0 is black.
  const texels = (...bytes) => [...read(Buffer.from([...Buffer.from(`#?RADIANCE\n\n-Y 1 +X ${bytes.length / 4}\n`), ...bytes])).data];
  assert.deepEqual(texels(255, 1, 0, 136, 9, 9, 9, 0), [255.5, 1.5, 0.5, 0, 0, 0]);
  // What a header states of color is applied or said.
  const headed = (lines) => read(Buffer.from([...Buffer.from(`#?RADIANCE\r\n${lines}\r\n\r\n-Y 1 +X 1\r\n`), 127, 127, 127, 136]));
  for (const [lines, data, note] of [
    ["EXPOSURE=4", [127.5, 127.5, 127.5], ""],
    ["COLORCORR= 2 1 0.5", [63.75, 127.5, 255], ""],
    ["COLORCORR=2 1 1\r\ncolorcorr=1 1 2", [63.75, 127.5, 63.75], ""],
    ["PRIMARIES= 0.640 0.330 0.300 0.600 0.150 0.060 0.3127 0.3290", [127.5, 127.5, 127.5], ""],
    ["PRIMARIES=0.708 0.292 0.170 0.797 0.131 0.046 0.3127 0.3290", [127.5, 127.5, 127.5], " Its primaries are not those of sRGB, and are ignored."],
  ]) {
    const found = headed(lines);
    assert.deepEqual([[...found.data], found.note], [data, note], lines);
  }
  assert.throws(() => read(good.subarray(0, good.length - 9)), /ends within its pixels/);
  assert.throws(() => read(good.subarray(0, 12)), /ends within its header/);
  assert.throws(() => read(Buffer.from("P6\n1 1\n255\n")), /does not start with/);
  assert.throws(() => read(Buffer.from("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n")), /its format is 32-bit_rle_xyze/);
  assert.throws(() => read(Buffer.from("#?RADIANCE\n\n+Y 1 +X 1\n")), /its size is/);
  assert.throws(() => project({ width: 2, height: 1, stride: 3, data: [1, 1, 1, NaN, 1, 1] }), /NaN/);
});

test("sources and a window of a map make its picture that of a direct integral, as far as stated", async () => {
  // Copper. Screen errors: mean and 95th percentile, of degree 9 alone and with 0, 4 and 8 sources
  // and the window.
  const copper = { baseColor: [0.955, 0.638, 0.538], metallic: 1, roughness: 0.35 };
  const count = 250;
  const axes = [0, 1, 2].map(() => new Float32Array(count));
  for (let k = 0; k < count; k++) {
    const [radius, angle] = [Math.sqrt((k + 0.5) / count), k * Math.PI * (3 - Math.sqrt(5))];
    [radius * Math.cos(angle), radius * Math.sin(angle), Math.sqrt(1 - radius * radius)].forEach((value, axis) => (axes[axis][k] = value));
  }
  for (const [name, widths, ...stated] of [
    ["studio", [Infinity, 12, 45, Infinity], [19.18, 55.0], [9.15, 26.65], [1.99, 7.23], [1.8, 7.57]],
    ["night", [Infinity, 45, Infinity, Infinity], [4.35, 14.44], [4.0, 14.0], [2.89, 9.73], [2.16, 4.86]],
  ]) {
    const map = mapOf(name);
    const light = project(map);
    const sources = pursue(project(resized(map), () => {}, FINE));
    assert.equal(sources.length, 7 * MOST);
    const scene = await Scene.create({ light, material: copper, sources: MOST });
    const small = resized(map, 256);
    const data = new Float32Array(4 * small.width * small.height);
    // The reference's rows are from the bottom.
    for (let k = 0; k < data.length; k++) {
      const [row, column] = [Math.floor(k / 4 / small.width), Math.floor(k / 4) % small.width];
      if (k % 4 < 3) data[k] = small.data[3 * ((small.height - 1 - row) * small.width + column) + (k % 4)];
    }
    const direct = texels({ ...small, data });
    const pixels = Array.from(axes[0], (x, k) => irradiance(integrals(direct, [x, axes[1][k], axes[2][k]], copper.roughness), copper));
    const [r, g, b] = [0, 1, 2].map((c) => Float32Array.from(pixels, (pixel) => pixel[c]));
    const exposure = metered({ r, g, b });
    const expected = colorsOf({ r, g, b }, exposure);
    for (const [k, drawn] of [0, 0, 4, 8].entries()) {
      scene.light({ ...light, sources: sources.subarray(0, 7 * drawn) }).window(k ? "auto" : "none");
      const picture = scene.shade(...axes);
      const { mean, most } = screenError(colorsOf(picture, exposure), expected);
      near(mean, stated[k][0], 0.02);
      near(most, stated[k][1], 0.1);
      // Rings have negative values. The lamps of the studio need sources, too.
      assert.equal(scene.windowWidth, widths[k]);
      const least = exposure * Math.min(...Object.values(picture).flatMap((channel) => [...channel]));
      assert.equal(least < -0.02, k === 0 || (name === "studio" && k === 1), `${name} ${k}: ${least}`);
    }
  }
});

test("a map has sources where it has lamps", () => {
  const [width, height] = [64, 32];
  const even = { width, height, stride: 3, data: new Float32Array(3 * width * height).fill(0.5) };
  const found = (map) => pursue(project(resized(map), () => {}, FINE));
  assert.equal(found(even).length, 0);
  // Bands of sky and ground are broad; 8 rows are patches, not points.
  for (const [columns, rows] of [[64, 32], [16, 8]]) {
    const data = Float32Array.from({ length: 3 * columns * rows }, (_, k) => (k < 1.5 * columns * rows ? 1 : 0.3));
    assert.equal(found({ width: columns, height: rows, stride: 3, data }).length, 0);
  }
  // A texel of 30 and one of 10, with a table: their directions and irradiances.
  const data = new Uint8Array(3 * width * height);
  const lamps = [[20, 10, 1], [50, 22, 2]];
  for (const [column, row, code] of lamps) data.fill(code, 3 * (row * width + column), 3 * (row * width + column) + 3);
  const sources = found({ width, height, stride: 3, data, table: [0.1, 30, 10] });
  lamps.forEach(([column, row, code], k) => {
    const [theta, t] = [(Math.PI * (row + 0.5)) / height, 2 * Math.PI * ((column + 0.5) / width - 0.5)];
    const [x, y, z, , energy] = sources.subarray(7 * k);
    near(x * Math.sin(t) * Math.sin(theta) + y * Math.cos(theta) - z * Math.cos(t) * Math.sin(theta), 1, 1e-4);
    const solid = ((2 * Math.PI) / width) * (Math.cos((Math.PI * row) / height) - Math.cos((Math.PI * (row + 1)) / height));
    near(energy / (([0.1, 30, 10][code] - 0.1) * solid), 1, 0.02);
  });
});

test("the error of a screen: exposed, clipped, mean and 95th percentile, in words", () => {
  const gray = (values) => ({ r: Float32Array.from(values), g: Float32Array.from(values), b: Float32Array.from(values) });
  const error = (found, expected, exposure = 1) => screenError(colorsOf(gray(found), exposure), colorsOf(gray(expected), exposure));
  // Beyond white and below black nothing shows, and white is 100 from black.
  assert.deepEqual(error([2, -1, 0.5], [9, 0, 0.5]), { mean: 0, most: 0 });
  near(error([1], [0]).mean, 100, 1e-6);
  // Light of 0.18 and 0.184 is L* 49.5 and 50.0: near 50 the error of grays is that of L*.
  near(error([0.184, 0.184], [0.18, 0.18]).mean, 0.5, 0.03);
  near(error([0.092], [0.09], 2).mean, error([0.184], [0.18]).mean, 1e-6);
  const some = (count) => error(Array.from({ length: 100 }, (_, k) => (k < count ? 1 : 0)), Array(100).fill(0));
  assert.deepEqual([some(5), some(6)].map(({ mean, most }) => [Math.round(mean), Math.round(most)]), [[5, 0], [6, 100]]);
  for (const [mean, most, sources, text] of [
    [0, 0, 0, "At best not visible: mean 0.0, 95\u00a0% within 0.0"],
    [1, 2, 4, "At best not visible: mean 1.0, 95\u00a0% within 2.0"],
    [0.01, 2.01, 4, "At best close: mean < 0.1, 95\u00a0% within 2.0"],
    [2, 5, 1, "At best close: mean 2.0, 95\u00a0% within 5.0"],
    [2.1, 5, 16, "Visible: mean 2.1, 95\u00a0% within 5.0"],
    [2, 25.2, 16, "Visible: mean 2.0, 95\u00a0% within 25"],
  ]) {
    const { error, against } = verdict({ mean, most }, sources);
    assert.equal(error, text);
    const also = { 0: "", 1: " and 1 source" }[sources] ?? ` and ${sources} sources`;
    assert.equal(against, `CIEDE2000 against all terms of 160 images${also}; what degree 9 lacks adds to it`);
  }
});

test("where the error against direct integration is known, it is in the headline", () => {
  const direct = { light: "night", roughness: 0.3, sources: 4, error: { mean: 1.2, most: 3.4 } };
  const said = (error, given = direct) => Object.values(wholeVerdict(error, given));
  const against = "CIEDE2000 against direct integration: that of a metal of roughness 0.3 in night with";
  assert.deepEqual(said({ mean: 0, most: 0 }), ["Close: mean 1.2, 95\u00a0% within 3.4", `${against} 4 sources`]);
  assert.deepEqual(said({ mean: 0.5, most: 2 }), ["Visible: mean 1.7, 95\u00a0% within 5.4", `${against} 4 sources, and what this picture leaves out`]);
  const none = { ...direct, sources: 0, error: { mean: 0.4, most: 0.9 } };
  assert.deepEqual(said({ mean: 0, most: 0 }, none), ["Not visible: mean 0.4, 95\u00a0% within 0.9", `${against} no sources`]);
});

test("lights by formula are those of maps", () => {
  const [width, height] = [512, 256];
  const radius = 1.1;
  const up = [0.48, 0.6, 0.64];
  const data = new Float32Array(3 * width * height);
  for (let k = 0; k < width * height; k++) {
    const [theta, t] = [(Math.PI * (Math.floor(k / width) + 0.5)) / height, 2 * Math.PI * (((k % width) + 0.5) / width - 0.5)];
    const along = up[0] * Math.sin(t) * Math.sin(theta) + up[1] * Math.cos(theta) - up[2] * Math.cos(t) * Math.sin(theta);
    data[3 * k] = data[3 * k + 1] = data[3 * k + 2] = along > Math.cos(radius) ? 2 : 0.5;
  }
  const found = project({ width, height, stride: 3, data });
  const [glow, rest] = [disc(up, radius, [1.5, 1.5, 1.5]), ambient([0.5, 0.5, 0.5])];
  found.r.forEach((value, k) => near(value, glow.r[k] + rest.r[k], 0.02));
  // Y_1^-1, Y_1^0 and Y_1^1 of the conventions.
  const values = harmonics(0.48, 0.6, 0.64, new Float64Array(4));
  const scale = Math.sqrt(3 / (4 * Math.PI));
  [-0.6, 0.64, -0.48].forEach((axis, k) => near(values[k + 1], scale * axis, 1e-12));
  const lamp = directional(up, [1, 2, 3]);
  near(windowed(lamp).g[0], lamp.g[0], 0);
  near(windowed(lamp, 20).g[90] / lamp.g[90], (Math.sin(0.45 * Math.PI) / (0.45 * Math.PI)) ** 4, 1e-6);
  assert.deepEqual(Object.keys(ANALYTIC), ["ambient", "hemisphere", "directional"]);
});

test("on a white matte under a light of degree 2, nine terms are the whole", async () => {
  const park = await lightPreset("park");
  const light = Object.fromEntries(["r", "g", "b"].map((c) => [c, park[c].slice(0, 9)]));
  const scene = await Scene.create({ light: ambient(), material: { r: [2], g: [1], b: [0.5] } });
  const albedo = measure.meanOf(measure.pictureOf(scene));
  [1, 0.5, 0.25].forEach((share, k) => near(albedo[k], share, 1e-4));
  const turn = multiply(dragged(0.7, 0.4), dragged(-0.2, 0.5, 0.3));
  scene.light(light).turn(turn);
  const { worst } = measure.errorOf(shadeNine(nineTerms(light, albedo), turn, measure.NORMALS), measure.pictureOf(scene), scene.exposure());
  assert.ok(worst <= 2e-3, `${worst}`);
});

test("turns compose, and drags turn to the right and down", () => {
  const quarter = Math.PI / 2;
  const close = (one, other) => one.forEach((value, k) => near(value, other[k], 1e-12));
  close(rotate(dragged(quarter, 0), [0, 0, 1]), [1, 0, 0]);
  close(rotate(dragged(0, quarter), [0, 0, 1]), [0, -1, 0]);
  close(rotate(multiply(dragged(quarter, 0), dragged(0, quarter)), [0, 1, 0]), [1, 0, 0]);
});

test("the curve of errors falls to zero, by the package's own bound", async () => {
  const scene = await Scene.create({ light: "studio", material: "gold-metallic-paint" });
  const whole = measure.pictureOf(scene);
  const exposure = scene.exposure();
  const curve = measure.curveOf(scene, whole, exposure);
  assert.equal(curve.length, measure.STEPS);
  assert.ok(curve[0].terms <= 25 && curve.at(-1).terms > 150 && curve.at(-1).rms === 0);
  curve.forEach(({ terms, rms, worst }, step) => {
    assert.ok(worst >= rms);
    if (step > 0) assert.ok(terms >= curve[step - 1].terms);
    const tolerance = measure.toleranceOf(step);
    if (tolerance) assert.ok(rms <= 1.3 * tolerance, `${rms}: ${tolerance}`);
  });
  const times = measure.timesOf(scene, await lightPreset("studio"));
  assert.ok(times.light > 1e-6 && times.light < 0.1 && times.pixel > 1e-9 && times.pixel < 1e-4);
});

test("the automatic choice holds its tolerance, and no choice of fewer terms does", async () => {
  const scene = await Scene.create({ light: "sky", material: { baseColor: "#808080", roughness: 1 } });
  const [whole, exposure] = [measure.pictureOf(scene), scene.exposure()];
  for (const tolerance of [0.1, 0.01]) {
    const best = measure.automatic(scene, exposure, tolerance);
    assert.ok(best.rms <= tolerance);
    const error = () => measure.errorOf(measure.pictureOf(scene), whole, exposure).rms;
    scene.effects(best.effects).within(measure.toleranceOf(best.step), exposure);
    near(error(), best.rms, 1e-6);
    for (let bits = 0; bits < 16; bits++) {
      scene.effects(EFFECTS.filter((_, k) => bits & (1 << k)));
      for (let step = 0; step < measure.STEPS; step++) {
        scene.within(measure.toleranceOf(step), exposure);
        if (scene.terms < best.terms) assert.ok(error() > tolerance);
      }
    }
    scene.effects().within();
  }
});

test("effects have shares, and what they save is counted at one share of white", async () => {
  const scene = await Scene.create({ light: "studio", material: "gold-metallic-paint" });
  const parts = measure.effectsOf(scene, scene.exposure(), 0.01);
  assert.deepEqual(Object.keys(parts), [...EFFECTS]);
  // The page takes a material's albedo from the same scene.
  assert.equal(scene.truncation, undefined);
  const picture = measure.pictureOf(scene.within().effects(["gloss"]));
  near(parts.gloss.share, measure.rmsOf(picture) / measure.rmsOf(measure.pictureOf(scene.effects())), 1e-6);
  assert.ok(parts.gloss.saved > 10 && Number.isInteger(parts.ambient.saved));
});

test("the state survives its link, with a light of one's own", async () => {
  const { r, g, b, sources: two } = await lightPreset("park", { sources: 2 });
  const light = { r, g, b, sources: Float32Array.from(two) };
  const state = {
    ...initial(), object: "coin", light: "own", ownLight: { name: "my sky, 1.hdr", light },
    material: { baseColor: "#b87333", metallic: 1, roughness: 0.35 }, turn: dragged(0.3, 0.4), pose: dragged(1, 0),
    step: 7, sources: 8, effects: ["diffuse", "gloss"], components: 33, exposure: -1.25, view: "split", drag: "light",
    tab: "effects", case: "rim", automatic: 5,
  };
  const { state: found, faults } = fromHash(`#${toHash(state)}`);
  assert.deepEqual(faults, []);
  assert.deepEqual(found.ownLight, state.ownLight);
  for (const key of Object.keys(state)) {
    if (key === "turn" || key === "pose") found[key].forEach((value, k) => near(value, state[key][k], 1e-4));
    else assert.deepEqual(found[key], state[key], key);
  }
  // A shipped light has its name in the link, and one's own no longer.
  assert.equal(toHash({ ...initial(), light: "sunset", ownLight: state.ownLight }), "light=sunset");
  assert.equal(toHash(initial()), "");
  assert.deepEqual(fromHash("").state, initial());
  const wrong = fromHash("#step=99&light=own&object=own&turn=0,0,0,0&material=../x&effects=ambient,x&foo=1&exposure=");
  assert.equal(wrong.faults.length, 8);
  assert.deepEqual(wrong.state, initial());
  assert.deepEqual(fromHash("#step=1.5&exposure=5").faults, [
    'step: "1.5" is not a whole number from 0 to 40', 'exposure: "5" is not a number from -4 to 4',
  ]);
  // The page may have the mesh that a link does not hold.
  assert.deepEqual(fromHash("#object=own", true), { state: { ...initial(), object: "own" }, faults: [] });
  const { sources, ...plain } = light;
  assert.equal(fromHash(`#${toHash({ ...state, ownLight: { name: "sky", light: plain } })}`).state.ownLight.light.sources.length, 0);
  const cut = { ...light, sources: sources.subarray(0, 4) };
  assert.match(fromHash(`#${toHash({ ...state, ownLight: { name: "sky", light: cut } })}`).faults[0], /its light is incomplete/);
  // Tolerances of the automatic choice are those of its list.
  const options = readFileSync(join(SITE, "index.html"), "utf8").matchAll(/<option value="(.*?)"/g);
  assert.deepEqual([...options].map(([, value]) => value), AUTOMATIC);
  assert.deepEqual(fromHash("#automatic=3").faults, ['automatic: "3" is not one of 10, 5, 2, 1, 0.5, 0.1']);
  assert.equal(fromHash("#automatic=0.5").state.automatic, 0.5);
  const bright = { ...light, g: light.g.map(() => 2e15) };
  const { faults: said } = fromHash(`#${toHash({ ...state, ownLight: { name: "sun", light: bright } })}`);
  assert.deepEqual(said, ["ownLight: its light has a number beyond 1000000000000000", "its own light is missing"]);
});

test("meshes by formula have unit normals that look outward, and so do their triangles", () => {
  for (const mesh of [relief(), coin()]) {
    const at = (array, k) => [...array.subarray(3 * k, 3 * k + 3)];
    const dot = (a, b) => a.reduce((sum, value, k) => sum + value * b[k], 0);
    for (let k = 0; k < mesh.positions.length / 3; k += 97) {
      const normal = at(mesh.normals, k);
      near(Math.hypot(...normal), 1, 1e-5);
      assert.ok(dot(normal, at(mesh.positions, k)) > -0.2);
      assert.ok(Math.hypot(...at(mesh.positions, k)) <= 1.01);
    }
    for (let k = 0; k < mesh.indices.length; k += 3 * 97) {
      const [a, b, c] = [0, 1, 2].map((corner) => at(mesh.positions, mesh.indices[k + corner]));
      const [p, q] = [b.map((v, i) => v - a[i]), c.map((v, i) => v - a[i])];
      const cross = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
      if (Math.hypot(...cross) > 1e-9) assert.ok(dot(cross, at(mesh.normals, mesh.indices[k])) > 0, `triangle ${k / 3}`);
    }
  }
  const normals = coinNormals(64);
  let tilted = 0;
  for (let k = 0; k < normals.length; k += 4) {
    near(Math.hypot(normals[k], normals[k + 1], normals[k + 2]), 1, 1e-5);
    tilted += Number(normals[k + 2] < 0.98);
  }
  assert.ok(tilted > 300);
});

test("an .obj is read with or without normals, and faults name their line", () => {
  const cube = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n";
  const mesh = parseObj(cube);
  assert.equal(mesh.indices.length, 6);
  assert.deepEqual([...mesh.normals.subarray(0, 3)], [0, 0, 1]);
  near(Math.hypot(...mesh.positions.subarray(0, 3)), 1, 1e-6);
  assert.deepEqual([...parseObj(`${cube.replace("f 1 2 3 4", "vn 1 0 0\nf 1//1 2//1 -2//-1")}`).normals.subarray(6, 9)], [1, 0, 0]);
  // Normals that are not there: a cube has edges, a fold of 25 degrees has none, one of 35 has.
  const box = parseObj(`${[0, 1, 2, 3, 4, 5, 6, 7].map((k) => `v ${k & 1} ${(k >> 1) & 1} ${k >> 2}`).join("\n")}
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6`);
  assert.equal(box.positions.length / 3, 24);
  box.indices.forEach((vertex, corner) => {
    const normal = [...box.normals.subarray(3 * vertex, 3 * vertex + 3)];
    const [axis, sign] = [[2, -1], [2, 1], [1, -1], [1, 1], [0, -1], [0, 1]][Math.floor(corner / 6)];
    assert.deepEqual(normal.map((value) => value + 0), [0, 1, 2].map((k) => (k === axis ? sign : 0)), `corner ${corner}`);
  });
  for (const [degrees, isSmooth] of [[25, true], [35, false]]) {
    const [y, z] = [Math.cos, Math.sin].map((f) => f((degrees * Math.PI) / 180));
    const fold = parseObj(`v 0 0 0\nv 1 0 0\nv 1 -1 0\nv 0 -1 0\nv 0 ${y} ${z}\nv 1 ${y} ${z}\nf 4 3 2 1\nf 1 2 6 5`);
    // The first vertex of the first face lies off the edge. Its third is on it: two triangles of the
    // face and one of the other meet there.
    near(fold.normals[3 * fold.indices[0] + 2], 1, 1e-6);
    near(fold.normals[3 * fold.indices[2] + 2], isSmooth ? (2 + y) / Math.hypot(2 + y, z) : 1, 1e-5);
  }
  // A closed fan: the corners around its middle share one vertex.
  const fan = Array.from({ length: 24 }, (_, k) => `v ${Math.cos((k * Math.PI) / 12)} ${Math.sin((k * Math.PI) / 12)} -0.2`);
  const tent = parseObj(`v 0 0 0\n${fan.join("\n")}\n${fan.map((_, k) => `f 1 ${k + 2} ${((k + 1) % 24) + 2}`).join("\n")}`);
  assert.equal(tent.positions.length / 3, 25);
  near(tent.normals[2], 1, 1e-6);
  assert.throws(() => parseObj("v 0 0 0\nf 1 2 3"), /line 2 refers to vertex 2/);
  assert.throws(() => parseObj("v 0 zero 0"), /line 1 is not three numbers/);
  assert.throws(() => parseObj("hello"), /no faces/);
  assert.throws(() => parseObj("v 1 1 1\nf 1 1 1"), /no extent/);
});

test("percentages have two digits", () => {
  assert.deepEqual([0, 1e-7, 1.234e-3, 0.0567, 0.25, 1].map(percent), ["0", "< 0.001 %", "0.12 %", "5.7 %", "25 %", "100 %"]);
});

test("the page has the bytes that its table says", () => {
  const size = (path) => {
    if (/(LICENSE|DATA)[^/]*$/.test(path)) return 0;
    return statSync(path).isDirectory() ? readdirSync(path).reduce((sum, name) => sum + size(join(path, name)), 0) : statSync(path).size;
  };
  const sum = (...names) => names.reduce((sum, name) => sum + size(join(SITE, name)), 0);
  // `first.test.js` compares those before the first picture.
  const page = readFileSync(join(SITE, "index.html"), "utf8");
  const early = [...page.matchAll(/(?:href|src)="([\w/-]+\.(?:css|js|svg))"/g)].map(([, name]) => name);
  const first = sum("index.html", "object", ...early);
  const three = sum("vendor/three.js");
  const coin = sum("shadows", "src/shadows.js", "eigenshade/src/shadowed.js", "eigenshade/wasm/eigenshade.shadowed.wasm");
  const all = sum("index.html", "style.css", "icon.svg", "src", "eigenshade", "object", "shadows", "vendor");
  const readme = readFileSync(join(SITE, "README.md"), "utf8");
  for (const [name, bytes, tolerance] of [["later, in all", all - first - three - coin, 15], ["for a glTF file", three, 10], ["for shadows", coin, 10]]) {
    const said = Number(new RegExp(`^\\| ${name} \\| ([\\d,]+) \\|`, "m").exec(readme)[1].replace(",", ""));
    assert.ok(Math.abs(bytes / 1e3 - said) <= tolerance, `${name}: ${bytes} bytes`);
  }
});

test("pixels of opacity 0 take no colors", () => {
  const gray = (code, opacity) => [code, code, code, opacity];
  const pixels = Uint8Array.from([gray(0, 0), gray(0, 0), gray(200, 9), gray(210, 255)].flat());
  const { palette, index } = quantized(pixels);
  assert.deepEqual([index.size, palette[0] + palette[3]], [2, 410]);
});

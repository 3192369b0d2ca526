// Pictures on the CPU: from a palette, against those with every pixel shaded.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { Scene, TONES, load, sphere } from "../src/index.js";
import { exact } from "./support/exact.js";

const README = readFileSync(new URL("../README.md", import.meta.url), "utf8");

/** The share of pixels that are within one code, and the largest difference, of README.md. */
const [SHARE, LARGEST] = /(\d+) % of the pixels[^.]* within\s1 of 255[^,]*, and all within (\d+)/.exec(README).slice(1).map(Number);

/** The largest difference in a channel of each pixel; opacities are equal. */
function differences(found, expected) {
  const all = [];
  for (let at = 0; at < found.length; at += 4) {
    assert.equal(found[at + 3], expected[at + 3]);
    const channels = [0, 1, 2].map((channel) => Math.abs(found[at + channel] - expected[at + channel]));
    if (found[at + 3]) all.push(Math.max(...channels));
  }
  return all.sort((a, b) => a - b);
}

const copper = (roughness) => ({ baseColor: "#b87333", metallic: 1, roughness });

test("small pictures are those with every pixel shaded, to one code", async () => {
  for (const material of ["gold-metallic-paint", copper(0.2)]) {
    const scene = await Scene.create({ light: "studio", material, sources: 4 });
    for (const size of [1, 2, 3, 64, 127]) {
      const look = { exposure: scene.exposure() };
      const all = differences(sphere(scene, size, look), exact(scene, size, look));
      assert.ok(all.at(-1) <= 1, `${size}: ${all.at(-1)}`);
    }
  }
});

test("pictures from a palette are as near to those with every pixel shaded as README.md states", async () => {
  const auto = { sources: "auto", window: "auto" };
  let most = 0;
  for (const [inputs, sizes] of [
    [{ light: "lobby", material: "gold-metallic-paint" }, [128, 480]],
    // Rows that are longer than the buffers.
    [{ light: "lobby", material: "gold-metallic-paint", sources: 4 }, [1100]],
    // The largest differences of all shipped pairs.
    [{ light: "warehouse", material: "black-obsidian", ...auto }, [200, 240]],
    [{ light: "dawn", material: "specular-yellow-phenolic", ...auto }, [200]],
    [{ light: "sunrise", material: "alum-bronze", ...auto }, [200]],
    // A highlight at the rim, beyond which no node counts.
    [{ light: "lab", material: "silicon-nitrade", ...auto }, [200]],
    // Sharp highlights, and a light that rings.
    ...[0.2, 0.3, 0.4, 0.5].flatMap((roughness) =>
      [0, 4].map((sources) => [{ light: "studio", material: copper(roughness), sources }, [240]])),
    [{ light: "night", material: { roughness: 0.2 }, sources: 8 }, [240]],
  ]) {
    const scene = await Scene.create(inputs);
    for (const size of sizes) {
      for (const tone of size === 240 ? TONES : ["filmic"]) {
        const look = { exposure: scene.exposure(), tone };
        const all = differences(sphere(scene, size, look), exact(scene, size, look));
        const [within, largest] = [all.findLastIndex((one) => one <= 1) / all.length, all.at(-1)];
        const what = `${JSON.stringify(inputs)}, ${size}, ${tone}: ${within}, ${largest}`;
        assert.ok(within >= SHARE / 100 && largest <= LARGEST, what);
        most = Math.max(most, largest);
      }
    }
  }
  console.log(`palette: ${most}`);
});

test("a matte sphere has no bands", async () => {
  const scene = await Scene.create({ light: "park", material: "nylon" });
  // Brighter to the right, from black to white.
  const three = (numbers) => ({ r: numbers, g: numbers, b: numbers });
  scene.light(three([3.5, 0, 0, -3])).material(three([2]));
  const look = { exposure: 1 / scene.shade([1], [0], [0]).g[0] };
  const [found, expected] = [sphere, exact].map((draw) => draw(scene, 480, look));
  assert.ok(differences(found, expected).at(-1) <= 1);
  const row = (picture) => Array.from({ length: 478 }, (_, column) => picture[4 * (240 * 480 + column + 1) + 1]);
  const [levels, exactLevels] = [row(found), row(expected)];
  assert.ok(new Set(exactLevels).size > 150);
  levels.forEach((level, k) => {
    if (k === 0) return;
    const [step, exactStep] = [level - levels[k - 1], exactLevels[k] - exactLevels[k - 1]];
    assert.ok(step >= 0 && step <= exactStep + 1, `column ${k}: ${step}, ${exactStep}`);
  });
});

test("pictures are drawn from a palette where it is faster", async () => {
  const engine = await load(readFileSync(new URL("../wasm/eigenshade.sources.simd.wasm", import.meta.url)));
  const { wasm } = engine;
  let used;
  engine.wasm = { ...wasm, draw: (...all) => (used = all[3], wasm.draw(...all)) };
  for (const [material, size, expected] of [
    ["gold-metallic-paint", 128, 1], ["gold-metallic-paint", 127, 0], [copper(0.2), 240, 0],
  ]) {
    const scene = await Scene.create({ light: "studio", material, engine });
    sphere(scene, size, { exposure: scene.exposure() });
    assert.equal(used, expected, `${material}, ${size}`);
  }
});

test("a palette is filled for each picture", async () => {
  const [one, other] = [await Scene.create({ light: "lobby", material: "red-fabric2" }), await Scene.create({ light: "park", material: "nylon" })];
  const look = { exposure: one.exposure() };
  const first = sphere(one, 200, look);
  sphere(other, 160);
  assert.deepEqual(sphere(one, 200, look), first);
  assert.notDeepEqual(sphere(one.turn({ yaw: 1 }), 200, look), first);
  assert.notDeepEqual(sphere(one.turn({}), 200, { ...look, tone: "linear" }), first);
});

test("the module checks counts, curves and exposures", async () => {
  for (const name of ["eigenshade", "eigenshade.sources"]) {
    const engine = await load(readFileSync(new URL(`../wasm/${name}.simd.wasm`, import.meta.url)));
    const { wasm, normals } = engine;
    await Scene.create({ light: "lobby", material: "nylon", engine }).then((scene) => scene.shade([0], [0], [1]));
    assert.equal(wasm.nodes(0, normals, 1, 2), normals);
    assert.equal(wasm.nodes(65 * 65 - 1, 1, 1, 2), 1);
    for (const wrong of [[0, normals + 1, 1, 2], [65 * 65, 1, 1, 2], [65 * 65 - 1, 2, 1, 2], [-1, 1, 1, 2], [0, -1, 1, 2], [0, 1, 0, 2], [0, 1, NaN, 2], [0, 1, 1, 3]]) {
      assert.equal(wasm.nodes(...wrong), 0, `${wrong}`);
    }
    for (const interpolates of [0, 1]) {
      // Points anywhere, which no sphere has.
      engine.points.fill(-(2 ** 31));
      engine.points.fill(2 ** 31 - 1, 7, 900);
      engine.scales.fill(NaN);
      assert.equal(wasm.draw(normals, 1, 2, interpolates), normals);
      for (const wrong of [[normals + 1, 1, 2], [-1, 1, 2], [1, 0, 2], [1, Infinity, 2], [1, 1, 3]]) {
        assert.equal(wasm.draw(...wrong, interpolates), 0, `${wrong}`);
      }
    }
  }
});

test("wrong looks throw one clear error", async () => {
  const scene = await Scene.create({ light: "park", material: "nylon" });
  assert.throws(() => sphere(scene, 200, { exposur: 1 }), { name: "TypeError", message: 'sphere: "exposur" is unknown; did you mean "exposure"?' });
  assert.throws(() => sphere(scene, 200, { exposure: 0 }), { name: "RangeError", message: "sphere: the exposure is 0, expected a number from 1.2e-38 to 3.4e38" });
  assert.throws(() => sphere(scene, 200, { tone: "aces" }), { name: "RangeError", message: 'sphere: "aces" is not one of linear, reinhard, filmic' });
});

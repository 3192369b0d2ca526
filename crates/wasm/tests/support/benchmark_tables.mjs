// Times of the modules that `crates/wasm/benchmark-tables` makes, each with a table of its own.

import { readFileSync } from "node:fs";
import { load } from "../../eigenshade.mjs";
import { row } from "./golden.mjs";
import { hemisphere, leasts } from "./timing.mjs";

/** The pair that is shaded; tables of a lower degree and order use the first coefficients. */
export const PAIR = "park 07-velvet g";

const FOLDER = new URL("../../../../target/modules/benchmark_tables/", import.meta.url);

function read(path, encoding) {
  try {
    return readFileSync(new URL(path, FOLDER), encoding);
  } catch (fault) {
    throw new Error(`${fault.message}; run crates/wasm/benchmark-tables first`);
  }
}

/** The tasks of a setting: pixels and new lights. */
function tasks(module, format, way) {
  const { f32, exports, [format]: used } = module;
  const count = used.shape.normals;
  const light = Float32Array.from(row("f32", "light", PAIR).numbers.slice(0, used.inputs.light.length));
  const material = row("f32", "material", PAIR).numbers.slice(0, used.inputs.material.length);
  used.light(light).material(material);
  // Leaves these normals in the module's buffer, and computes the transfer.
  if (format === "f32") f32.relight();
  else used.project();
  used.collapse().shade(...hemisphere(count));
  if (way === "look_up") f32.bake();
  const [pixels, relight, collapse] = [way, "relight", "collapse"].map((name) => exports[`${format}_${name}`]);
  const relit = () => {
    used.inputs.light.set(light);
    relight();
    collapse();
    if (way === "look_up") exports.f32_bake();
  };
  return [
    { work: () => pixels(count), count },
    { work: relit, count: 1 },
  ];
}

/** Nanoseconds for a pixel and for a new light of every setting, starting with the nine-term formula. */
export async function benchmarkTables() {
  const lines = read("benchmark_tables.csv", "utf8").trim().split("\n").slice(2);
  const all = [];
  for (const [table, module, setting, way, format] of lines.map((line) => line.split(","))) {
    const loaded = await load(read(`${table}/${module}.wasm`));
    all.push({ setting, tasks: tasks(loaded, format, way), exports: loaded.exports });
  }
  const { exports } = all[0];
  new Float32Array(exports.memory.buffer, exports.nine.value, 9)
    .set([0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
  const nine = { work: () => exports.nine_terms(1024), count: 1024 };
  const found = [{ setting: "2/0 all nine-terms f32", tasks: [nine] }, ...all];
  const every = found.flatMap((one) => one.tasks);
  const times = await leasts(every);
  return found.map(({ setting, tasks }) => ({
    setting,
    times: [...times.splice(0, tasks.length), undefined].slice(0, 2),
  }));
}

// Times of interleaved tasks.

/** Minimum duration of a run in nanoseconds: long against the clock's step, short against interruptions. */
const RUN = 5e4;

const RUNS = 301;

function time(work, repeat) {
  const start = process.hrtime.bigint();
  for (let turn = 0; turn < repeat; turn++) work();
  return Number(process.hrtime.bigint() - start) / repeat;
}

/** The minimum over interleaved runs, in nanoseconds for one of `count`. */
export async function leasts(tasks) {
  // Engines compile hot code in the background.
  for (let turn = 0; turn < 20; turn++) {
    for (const { work } of tasks) time(work, 20);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  const repeats = tasks.map(({ work }) => {
    const once = Math.min(...Array.from({ length: 20 }, () => time(work, 1)));
    return Math.max(1, Math.ceil(RUN / once));
  });
  const times = tasks.map(() => Infinity);
  for (let run = 0; run < RUNS; run++) {
    tasks.forEach(({ work, count }, k) => {
      times[k] = Math.min(times[k], time(work, repeats[k]) / count);
    });
  }
  return times;
}

/** Normals over the visible hemisphere. */
export function hemisphere(count) {
  const at = (k) => {
    const z = (k + 0.5) / count;
    const [sine, tilt] = [Math.sqrt(1 - z * z), 2.399963 * k];
    return [sine * Math.cos(tilt), sine * Math.sin(tilt), z];
  };
  return [0, 1, 2].map((axis) => Float32Array.from({ length: count }, (_, k) => at(k)[axis]));
}

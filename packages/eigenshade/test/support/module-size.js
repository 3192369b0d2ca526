// The sizes of the parts of a WebAssembly module.

import { gzipSync } from "node:zlib";

/** Id and bytes of each section, including its header. */
function sections(module) {
  const found = [];
  for (let at = 8; at < module.length; ) {
    let [place, length, shift] = [at + 1, 0, 0];
    do {
      length += (module[place] & 127) * 2 ** shift;
      shift += 7;
    } while (module[place++] & 128);
    found.push({ id: module[at], bytes: module.subarray(at, place + length) });
    at = place + length;
  }
  return found;
}

const DATA = 11;

/** Bytes of the module, of its data section, and of the rest without and with gzip -9. */
export function sizes(module) {
  const all = sections(module);
  const parts = all.filter(({ id }) => id !== DATA).map((section) => section.bytes);
  const rest = Buffer.concat([module.subarray(0, 8), ...parts]);
  const data = module.length - rest.length;
  return { module: module.length, data, rest: rest.length, zipped: gzipSync(rest, { level: 9 }).length };
}

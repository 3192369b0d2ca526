// Figures: CSV files in results/, and tables in README.md between markers.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";

const file = (name) => new URL(`results/${name}.csv`, import.meta.url);
const README = new URL("README.md", import.meta.url);

/** Rows of a CSV file, as objects of strings. */
export function readRows(name) {
  if (!existsSync(file(name))) return [];
  const [, head, ...lines] = readFileSync(file(name), "utf8").trim().split("\n");
  const names = head.split(",");
  return lines.map((line) => Object.fromEntries(line.split(",").map((text, k) => [names[k], text])));
}

/** Writes rows to a CSV file whose first line is the command. */
export function writeRows(name, command, rows) {
  mkdirSync(new URL("results/", import.meta.url), { recursive: true });
  const lines = [`# ${command}`, Object.keys(rows[0]).join(","), ...rows.map((row) => Object.values(row).join(","))];
  writeFileSync(file(name), `${lines.join("\n")}\n`);
}

/** A table in Markdown: the first column is text, the others are numbers unless `text` names them. */
export function markdown(heads, rows, text = []) {
  const rule = heads.map((head, k) => (k === 0 || text.includes(head) ? "---" : "---:"));
  return [heads, rule, ...rows].map((cells) => `| ${cells.join(" | ")} |`).join("\n").replace(/\| (-+:?) /g, "|$1").replace(/(-:?) \|$/gm, "$1|");
}

/** Puts a text between the markers of the README. */
export function putTable(name, text) {
  const readme = readFileSync(README, "utf8");
  const found = new RegExp(`(<!-- ${name} -->\\n)[^]*?(<!-- end of ${name} -->)`);
  if (!found.test(readme)) throw new Error(`README.md has no markers of ${name}`);
  writeFileSync(README, readme.replace(found, (_, start, end) => `${start}${text}\n${end}`));
}

/** Compares these columns of rows with those of the file; a number may differ by this share. */
export function checkRows(name, command, rows, columns, share = 0.02) {
  const before = readRows(name);
  const faults = before.length === rows.length ? [] : [`${before.length} rows, found ${rows.length}`];
  rows.forEach((row, k) => {
    for (const column of columns) {
      const [was, is] = [before[k]?.[column], String(row[column])];
      if (was === is || Math.abs(was - is) <= share * Math.abs(was)) continue;
      faults.push(`row ${k + 1}: ${column} is ${was}, found ${is}`);
    }
  });
  if (faults.length) {
    console.error(`results/${name}.csv differs:\n${faults.join("\n")}\nTo write it anew: ${command}`);
    process.exitCode = 1;
  }
}

/** A percentage with two digits. */
export const percent = (share) => {
  const number = 100 * share;
  return number >= 10 ? number.toFixed(0) : number >= 1 ? number.toFixed(1) : number.toPrecision(number >= 0.1 ? 2 : 1);
};

// The processor time of Chromium's GPU process, on Linux.

import { readFileSync, readdirSync } from "node:fs";

/** A function that returns the processor time, in nanoseconds. */
export async function clock(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  const { id } = processInfo.find(({ type }) => type === "GPU");
  const tasks = `/proc/${id}/task`;
  return () => readdirSync(tasks).reduce((sum, task) => sum + Number(readFileSync(`${tasks}/${task}/schedstat`, "utf8").split(" ")[0]), 0);
}

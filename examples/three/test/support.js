// A page in Debian's Chromium, with WebGL 2 in software. It records faults and requests elsewhere.

import { launch } from "../../../packages/eigenshade/test/support/browser.js";
import { serve } from "../serve.js";

export async function open(path = "test/blank.html", viewport = { width: 480, height: 400 }) {
  const server = await serve();
  const browser = await launch();
  const page = await browser.newPage({ viewport });
  const faults = [];
  page.on("pageerror", (fault) => faults.push(fault.message));
  page.on("console", (message) => {
    // Reading pixels back stalls; that is a remark about speed.
    const stalls = message.text().includes("ReadPixels");
    if (["error", "warning"].includes(message.type()) && !stalls) faults.push(message.text());
  });
  const { host } = new URL(server.address);
  page.on("request", (request) => {
    const url = new URL(request.url());
    if (url.protocol.startsWith("http") && url.host !== host) faults.push(`request of ${url}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400) faults.push(`${response.status()} ${response.url()}`);
  });
  await page.goto(server.address + path);
  const close = async () => {
    await browser.close();
    server.close();
  };
  return { page, faults, close, address: server.address };
}

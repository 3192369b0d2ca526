// One browser and one server for the tests of a file.

import { after, before } from "node:test";
import { launch, serve } from "./support.js";

export let browser, server;

before(async () => {
  server = await serve();
  browser = await launch();
});

after(async () => {
  await browser?.close();
  server?.close();
});

/// <reference path="./dom.d.ts" />
export * from "./types/index.js";

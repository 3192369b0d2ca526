/// <reference path="./dom.d.ts" />
export * from "./types/shadowed.js";

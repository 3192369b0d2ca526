export * from "./types/three.js";

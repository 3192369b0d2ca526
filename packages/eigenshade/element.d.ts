// `eigenshade/element`. JSDoc has no way to declare properties that are defined in a loop.

import type { Channels, MetallicRoughness, Preview, Tone } from "./types/index.js";

/** The attributes of `<eigen-shade>`, and its properties in camel case. */
export interface EigenShadeProperties {
  light: string | Channels | null;
  material: string | Channels | MetallicRoughness | null;
  baseColor: string | readonly number[] | null;
  metallic: number | null;
  roughness: number | null;
  sources: number | "auto" | null;
  window: number | "auto" | "none" | null;
  yaw: number | null;
  pitch: number | null;
  roll: number | null;
  exposure: number | "auto" | null;
  tone: Tone | null;
}

/** A sphere of a material under a light. It fires `load` after a picture, and `error`. */
export interface EigenShade extends HTMLElement, EigenShadeProperties {
  /** The preview, once it is drawn. */
  readonly preview: Preview | undefined;
}

export const EigenShade: {
  prototype: EigenShade;
  new (): EigenShade;
};

declare global {
  interface HTMLElementTagNameMap {
    "eigen-shade": EigenShade;
  }
}

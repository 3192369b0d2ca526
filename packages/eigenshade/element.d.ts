// `eigenshade/element`. JSDoc has no way to declare a page's elements.

import type { EigenShade } from "./types/element.js";

export { EigenShade };

declare global {
  interface HTMLElementTagNameMap {
    "eigen-shade": EigenShade;
  }
}

// `import type {} from "eigenshade/react"` declares `<eigen-shade>` in JSX for React 19.

import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { EigenShade, EigenShadeProperties } from "./element.js";

/** React has an `onLoad` and an `onError` of its own, which it calls for HTML's elements alone. */
interface Events {
  onload?: (event: Event) => void;
  onerror?: (event: ErrorEvent) => void;
  onLoad?: never;
  onError?: never;
}

type Html = Omit<DetailedHTMLProps<HTMLAttributes<EigenShade>, EigenShade>, keyof Events>;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "eigen-shade": Html & Partial<EigenShadeProperties> & { "base-color"?: string } & Events;
    }
  }
}

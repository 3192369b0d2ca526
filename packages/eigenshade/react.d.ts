// `eigenshade/react`, for React 19: the component, and `<eigen-shade>` in JSX.

import type { DetailedHTMLProps, HTMLAttributes, ReactElement } from "react";
import type { EigenShade as EigenShadeElement, EigenShadeProperties } from "./element.js";

/** React has an `onLoad` and an `onError` of its own, which it calls for HTML's elements alone. */
interface Events {
  onload?: (event: Event) => void;
  onerror?: (event: ErrorEvent) => void;
  onLoad?: never;
  onError?: never;
}

type Html = Omit<
  DetailedHTMLProps<HTMLAttributes<EigenShadeElement>, EigenShadeElement>,
  keyof Events
>;

/** The element's properties, its events, and the props of any HTML element. */
export interface EigenShadeProps extends Html, Partial<EigenShadeProperties> {
  /** Called after a picture. */
  onLoad?: (event: Event) => void;
  /** Called if a property is wrong, or a file cannot be loaded; the earlier picture stays. */
  onError?: (event: ErrorEvent) => void;
}

/** The element `<eigen-shade>` as a component. A server renders it without its properties. */
export function EigenShade(props: EigenShadeProps): ReactElement;

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "eigen-shade": Html & Partial<EigenShadeProperties> & { "base-color"?: string } & Events;
    }
  }
}

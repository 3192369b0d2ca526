"use client";
// `<EigenShade light="park" material="red-fabric2" />`: the element as a component of React.

import { createElement, useImperativeHandle, useLayoutEffect, useRef } from "react";
import { EigenShade as Element } from "./element.js";

/** The element's properties, from `light` to `tone`. */
const PROPERTIES = Object.keys(Element.prototype);

/** Equal for properties of equal value, whether or not they are the same object. */
const text = (/** @type {unknown} */ value) =>
  typeof value === "object" ? JSON.stringify(value) : String(value);

/**
 * The element `<eigen-shade>`, which frees its preview when it leaves the page. Props are the
 * element's properties, `onLoad` and `onError` for its events, and the props of any HTML element.
 * A property is set only if its value has changed, so a render may create objects anew. On a server
 * the element is rendered without its properties.
 *
 * @param {Record<string, any>} props
 */
export function EigenShade({ ref, onLoad, onError, ...props }) {
  const element = useRef(/** @type {any} */ (null));
  const set = useRef(/** @type {Record<string, string>} */ ({}));
  useImperativeHandle(ref, () => element.current, []);
  // Layout effects run before the element reads its properties, which it does in a microtask.
  useLayoutEffect(() => {
    const end = new AbortController();
    const { signal } = end;
    if (onLoad) element.current.addEventListener("load", onLoad, { signal });
    if (onError) element.current.addEventListener("error", onError, { signal });
    return () => end.abort();
  }, [onLoad, onError]);
  useLayoutEffect(() => {
    for (const name of PROPERTIES) {
      const value = props[name] ?? null;
      if (text(value) === (set.current[name] ?? "null")) continue;
      set.current[name] = text(value);
      element.current[name] = value;
    }
  });
  const html = Object.entries(props).filter(([name]) => !PROPERTIES.includes(name));
  return createElement("eigen-shade", { ...Object.fromEntries(html), ref: element });
}

// Warns of what `MeshMatcapMaterial` has not, once for each name, instead of ignoring it or failing
// inside a frame.

import { MeshPhongMaterial, MeshPhysicalMaterial } from "three";

/** Properties of other materials: textures, factors and colors. */
const OTHERS = [MeshPhysicalMaterial, MeshPhongMaterial].flatMap((Material) => Object.keys(new Material()))
  .filter((name) => !/^is[A-Z]|^wireframe/.test(name)).map((name) => name.replace(/^_/, ""));

/**
 * Makes a material warn when such a property is set.
 *
 * @param {import("three").MeshMatcapMaterial} material
 * @returns {(mesh: import("three").Object3D) => void} to be called for each mesh that is drawn
 */
export function warnUnsupported(material) {
  const warned = new Set();
  const warn = (name, remedy) => {
    if (warned.has(name)) return;
    warned.add(name);
    console.warn(`eigenshade: ${name} has no effect on this material; ${remedy}`);
  };
  for (const name of OTHERS) {
    if (name in material) continue;
    Object.defineProperty(material, name, {
      get: () => undefined,
      set(value) {
        if (value !== null && value !== undefined) warn(name, "light and reflectance are those of its eigenshade scene");
      },
    });
  }
  return (mesh) => {
    if (mesh.receiveShadow) warn("receiveShadow", "it draws no shadows that fall on it");
  };
}

// What an `EigenMaterial` leaves out of other materials.

import { MeshPhongMaterial, MeshPhysicalMaterial, MeshStandardMaterial } from "three";

const [standard, physical] = [new MeshStandardMaterial(), new MeshPhysicalMaterial()];

const names = (/** @type {object} */ material) => Object.keys(material).map((name) => name.replace(/^_/, ""));

/** Properties of other materials that a `MeshStandardMaterial` has not. */
export const OTHERS = [physical, new MeshPhongMaterial()].flatMap(names)
  .filter((name, k, all) => all.indexOf(name) === k && !/^is[A-Z]/.test(name) && !(name in standard));

/** @typedef {Record<string, unknown>} Properties */

const properties = (/** @type {any} */ material) => /** @type {Properties} */ (material);

/** Whether a property has an effect there: a texture, or another number or color than by default. */
function isSet(/** @type {any} */ value, /** @type {any} */ usual) {
  if (Object(value) !== value) return value !== undefined && value !== null && value !== usual;
  // Vectors are details of other properties.
  return value.isTexture === true || (value.isColor === true && !value.equals(usual));
}

/**
 * The names of what a material has and an `EigenMaterial` has not.
 *
 * @param {MeshStandardMaterial} material
 * @returns {string[]}
 */
export function differs(material) {
  const [given, usual] = [material, physical].map(properties);
  return OTHERS.filter((name) => name in given && isSet(given[name], usual[name]));
}

/**
 * The names of what has no effect on a mesh.
 *
 * @param {MeshStandardMaterial} material
 * @param {import("three").Object3D} mesh
 * @param {boolean} isScene whether the material reflects as a scene's does
 */
export function ignored(material, mesh, isScene) {
  const [given, usual] = [material, standard].map(properties);
  const all = ["envMap", "lightMap"];
  if (isScene) all.push("roughness", "metalness", "roughnessMap", "metalnessMap", "aoMap");
  const found = all.filter((name) => isSet(given[name], usual[name]));
  return mesh.receiveShadow ? [...found, "receiveShadow"] : found;
}

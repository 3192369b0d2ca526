// The frame in which meshes are seen: z points to the camera.

import { Box3, Matrix3, Matrix4, Quaternion, Sphere, Vector3 } from "three";
import { refuse } from "../input.js";
import { ImageTexture } from "./image-texture.js";

/** @typedef {import("three").Object3D} Object3D */

const TOWARD_CAMERA = new Vector3(0, 0, 1);

/** The most roughnesses of a frame that have images of their own. Others are blended. */
const MOST = 8;

const [matrix, box, sphere] = [new Matrix4(), new Box3(), new Sphere()];

/** A direction of view, the rotation of the light, and what materials with both share. */
export class Frame {
  /** How the light is turned, relative to the frame. */
  turn = new Quaternion();
  /** From the camera's frame to this one. */
  matrix = new Matrix3();
  /** @type {Vector3 | undefined} The center of the object that is looked at, in its own frame. */
  #center;
  /** Of the mesh that was drawn last: itself, the picture and the renderer. */
  #last = /** @type {unknown[]} */ ([]);
  /** @type {Map<number | undefined, ImageTexture>} By roughness; those that are blended have none. */
  #images = new Map();
  #warned = new Set();

  /**
   * @param {"object" | "camera" | Object3D} [view]
   * @param {Quaternion} [lightRotation]
   */
  constructor(view = "object", lightRotation = new Quaternion()) {
    if (typeof view === "string" ? view !== "object" && view !== "camera" : !view.isObject3D) {
      refuse("view", view, '"object", "camera" or an Object3D');
    }
    this.view = view;
    this.lightRotation = lightRotation;
    if (typeof view !== "string") {
      const center = box.setFromObject(view).getCenter(new Vector3());
      this.#center = view.worldToLocal(center);
    }
  }

  /**
   * Turns the frame to where a mesh is seen from.
   *
   * @param {import("three").WebGLRenderer} renderer
   * @param {import("three").Camera} camera
   * @param {Object3D} mesh
   */
  look(renderer, camera, mesh) {
    this.turn.setFromRotationMatrix(camera.matrixWorldInverse).multiply(this.lightRotation);
    this.matrix.identity();
    if (!isPerspective(camera) || this.view === "camera") return;
    if (this.view === "object") this.#checkAlone(mesh, renderer);
    const center = this.#center
      ? sphere.center.copy(this.#center).applyMatrix4(/** @type {Object3D} */ (this.view).matrixWorld)
      : centerOf(mesh);
    center.applyMatrix4(camera.matrixWorldInverse).negate().normalize();
    const rotation = new Quaternion().setFromUnitVectors(center, TOWARD_CAMERA);
    this.matrix.setFromMatrix4(matrix.makeRotationFromQuaternion(rotation));
    this.turn.premultiply(rotation);
  }

  /**
   * three.js uploads the uniforms of a material once for all meshes that follow each other.
   *
   * @param {Object3D} mesh
   * @param {import("three").WebGLRenderer} renderer
   */
  #checkAlone(mesh, renderer) {
    const { frame } = renderer.info.render;
    const [last, picture, drawer] = this.#last;
    if (mesh !== last && picture === frame && drawer === renderer) {
      const other = 'the view "camera" or an object';
      throw new Error(`EigenMaterial: each mesh needs a material of its own, or ${other}`);
    }
    this.#last = [mesh, frame, renderer];
  }

  /**
   * Images for a roughness, or for any.
   *
   * @param {number} [roughness]
   */
  images(roughness) {
    const key = this.#images.has(roughness) || this.#images.size < MOST ? roughness : undefined;
    const found = this.#images.get(key) ?? new ImageTexture(key);
    this.#images.set(key, found);
    return found;
  }

  dispose() {
    for (const { texture } of this.#images.values()) texture.dispose();
  }

  /** Warns once that something has no effect. */
  warn(/** @type {string} */ name) {
    if (this.#warned.has(name)) return;
    this.#warned.add(name);
    console.warn(`eigenshade: ${name} has no effect on an EigenMaterial; its light is that of a Scene`);
  }
}

/** @returns {camera is import("three").PerspectiveCamera} */
export const isPerspective = (/** @type {any} */ camera) => camera.isPerspectiveCamera === true;

/** The center of a mesh in the world. Skinned and instanced meshes have spheres of their own. */
function centerOf(/** @type {any} */ mesh) {
  const owner = mesh.boundingSphere === undefined ? mesh.geometry : mesh;
  if (owner.boundingSphere === null) owner.computeBoundingSphere();
  return sphere.copy(owner.boundingSphere).applyMatrix4(mesh.matrixWorld).center;
}

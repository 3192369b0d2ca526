// `eigenshade/three`: a material of three.js in the light of a scene.

import { Matrix3, Mesh, MeshStandardMaterial } from "three";
import { checkExposure, refuse } from "./input.js";
import { Scene } from "./index.js";
import { Frame, isPerspective } from "./three/frame.js";
import { MixedReflection } from "./three/mixed.js";
import { SceneReflection } from "./three/scene-reflection.js";
import { patched } from "./three/shader.js";
import { OTHERS, differs, ignored } from "./three/unsupported.js";

/**
 * How an `EigenMaterial` is seen and lit.
 *
 * @typedef {object} EigenOptions
 * @property {"object" | "camera" | import("three").Object3D} [view] in perspective the direction from
 *   which all pixels are seen, but for a turn of each normal: that to the center of the mesh, by
 *   default, the camera's axis, or that to the center of an object, which may have many meshes
 * @property {number | "auto"} [exposure] the factor from light to display; `"auto"`, the default, is
 *   `scene.exposure()`. It is no factor of `emissive`
 * @property {import("three").Quaternion} [lightRotation] turns the light in the world
 */

/** @typedef {import("three").Material} Material */

/**
 * A material of `WebGLRenderer` in the light of a scene. Other lights, shadows and environments have no
 * effect on it. The light is fixed to the world; a change of the scene is seen in the next frame.
 *
 * A new `EigenMaterial` reflects as the material of the scene does, times `color`, `map` and
 * vertex colors. One {@link EigenMaterial.from | from} a `MeshStandardMaterial` has its own color,
 * metalness and roughness. What has no effect gives a warning, once.
 *
 * eigenshade's view is orthographic. In perspective, each mesh needs a material of its own, unless
 * another `view` is given.
 */
export class EigenMaterial extends MeshStandardMaterial {
  #scene;
  #frame;
  /** @type {SceneReflection | MixedReflection} */
  #reflection;
  #uniforms = {
    eigenFrame: { value: new Matrix3() },
    eigenPerspective: { value: false },
    eigenExposure: { value: 1 },
  };

  static {
    for (const name of OTHERS) {
      Object.defineProperty(this.prototype, name, {
        get: () => undefined,
        set(value) {
          if (value !== null && value !== undefined) this.#frame.warn(name);
        },
      });
    }
  }

  /**
   * A material that reflects as the scene's does.
   *
   * @param {Scene} scene which the material turns
   * @param {EigenOptions & import("three").MeshStandardMaterialParameters} [options]
   * @throws {TypeError | RangeError} for a scene or an option that is none
   */
  constructor(scene, { view, exposure = "auto", lightRotation, ...parameters } = {}) {
    super();
    if (!(scene instanceof Scene)) refuse("EigenMaterial", scene, "a Scene");
    if (exposure !== "auto") checkExposure("EigenMaterial", exposure);
    this.#scene = scene;
    this.#frame = new Frame(view, lightRotation);
    this.#reflection = new SceneReflection(scene, this.#frame);
    /** The factor from light to display, or `"auto"`. */
    this.exposure = exposure;
    this.setValues(parameters);
    this.addEventListener("dispose", () => this.#reflection.dispose());
  }

  /**
   * A material that looks as another one, with the same textures.
   *
   * @param {MeshStandardMaterial} material maybe a `MeshPhysicalMaterial`
   * @param {Scene} scene whose light shines on it
   * @param {EigenOptions} [options]
   * @returns {EigenMaterial}
   * @throws {TypeError | RangeError} for another material, and as the constructor
   */
  static from(material, scene, options) {
    if (!material?.isMeshStandardMaterial) {
      refuse("EigenMaterial.from", material, "a MeshStandardMaterial");
    }
    return new EigenMaterial(scene, options).#like(material);
  }

  /**
   * Converts each `MeshStandardMaterial` of an object, such as the scene of a glTF file, once. The
   * others stay. The new materials share their light rotation and the direction of view, which is by
   * default that to the center of the object.
   *
   * @param {import("three").Object3D} object
   * @param {Scene} scene whose light shines on it
   * @param {EigenOptions} [options]
   * @returns {EigenMaterial[]} the new materials
   * @throws {TypeError | RangeError} as the constructor
   */
  static convert(object, scene, { view = object, exposure, lightRotation } = {}) {
    const frame = new Frame(view, lightRotation);
    /** @type {Map<Material, EigenMaterial>} */
    const converted = new Map();
    const replaced = (/** @type {Material} */ material) => {
      const isStandard = material instanceof MeshStandardMaterial && !(material instanceof EigenMaterial);
      if (!isStandard) return material;
      const made = converted.get(material) ?? new EigenMaterial(scene, { exposure }).#like(material, frame);
      converted.set(material, made);
      return made;
    };
    object.traverse((child) => {
      if (!(child instanceof Mesh)) return;
      const { material } = child;
      child.material = Array.isArray(material) ? material.map(replaced) : replaced(material);
    });
    return [...converted.values()];
  }

  /** The rotation of the light in the world. */
  get lightRotation() {
    return this.#frame.lightRotation;
  }

  /**
   * Takes the look of another material.
   *
   * @param {MeshStandardMaterial} material
   * @param {Frame} [frame]
   */
  #like(material, frame = this.#frame) {
    this.#frame = frame;
    this.#reflection.dispose();
    this.#reflection = new MixedReflection(this.#scene, frame, this);
    for (const name of differs(material)) frame.warn(name);
    return super.copy(material);
  }

  /** A material with the same textures in the same light. */
  clone() {
    const { view, lightRotation } = this.#frame;
    const { exposure } = this;
    const clone = new EigenMaterial(this.#scene, { view, exposure, lightRotation: lightRotation.clone() });
    const frame = typeof view === "string" ? clone.#frame : this.#frame;
    if (this.#reflection instanceof MixedReflection) return /** @type {this} */ (clone.#like(this, frame));
    return /** @type {this} */ (MeshStandardMaterial.prototype.copy.call(clone, this));
  }

  customProgramCacheKey() {
    return this.#reflection.text;
  }

  /** @param {import("three").WebGLProgramParametersWithUniforms} shader */
  onBeforeCompile(shader) {
    Object.assign(shader.uniforms, this.#uniforms, this.#reflection.uniforms);
    shader.fragmentShader = patched(shader.fragmentShader, this.#reflection.text);
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {import("three").Scene} world
   * @param {import("three").Camera} camera
   * @param {import("three").BufferGeometry} geometry
   * @param {import("three").Object3D} mesh
   */
  onBeforeRender(renderer, world, camera, geometry, mesh) {
    const isScene = this.#reflection instanceof SceneReflection;
    for (const name of ignored(this, mesh, isScene)) this.#frame.warn(name);
    const { text } = this.#reflection;
    this.#frame.look(renderer, camera, mesh);
    this.#reflection.update();
    if (this.#reflection.text !== text) this.needsUpdate = true;
    const exposure = this.exposure === "auto" ? this.#scene.exposure() : this.exposure;
    this.#uniforms.eigenFrame.value = this.#frame.matrix;
    this.#uniforms.eigenPerspective.value = isPerspective(camera);
    this.#uniforms.eigenExposure.value = exposure / this.#reflection.exposed;
  }
}

// A three.js material whose outgoing light is the irradiance of an eigenshade scene.

import { DataTexture, FloatType, Matrix3, Matrix4, MeshMatcapMaterial, Quaternion, RGBAFormat, Sphere, Vector3 } from "three";
import { warnUnsupported } from "./unsupported.js";

const TOWARD_CAMERA = new Vector3(0, 0, 1);

/**
 * A material of `WebGLRenderer`, for one mesh if the camera is a perspective one. It is a
 * `MeshMatcapMaterial` with another last line, so normal maps, bump maps, skinning, morph targets,
 * instancing, fog and tone mapping work as in every material of three.js, and lights, shadows and
 * environments of the three.js scene have no effect: the material warns once of each property of
 * other materials that is set, and of `receiveShadow`. `color` is the exposure.
 *
 * The light is fixed to the world: before each frame the material turns the scene's light by the
 * inverse rotation of the camera, and `material.lightRotation`, a quaternion, turns it in the
 * world. A new turn is an upload of uniforms. After `scene.light(..)` or `scene.material(..)` call
 * `material.update()`. A clone has the same scene.
 *
 * eigenshade's view is orthographic. For a perspective camera, `view: "object"` turns the light and
 * the normals into a frame whose z axis points from the center of the mesh to the camera: a small
 * mesh is then right anywhere on the screen. `view: "camera"` takes the camera's frame for all
 * meshes, which may then share a material. results/perspective.csv has the errors of both.
 *
 * @param {import("eigenshade").Scene} scene which the material turns
 * @param {object} [options] `view`, and parameters of `MeshMatcapMaterial`
 */
export function eigenMaterial(scene, { view = "object", ...parameters } = {}) {
  const material = new MeshMatcapMaterial(parameters);
  const uniforms = { eigenshade: { value: stored(scene) }, eigenFrame: { value: new Matrix3() }, eigenPerspective: { value: false } };
  let text = textOf(scene, uniforms.eigenshade.value);
  const [turn, turned] = [new Quaternion(), new Quaternion()];
  const check = warnUnsupported(material);
  let [changed, mesh, picture, drawer] = [true];

  material.lightRotation = new Quaternion();
  material.update = () => {
    changed = true;
    return material;
  };
  material.clone = () => {
    const clone = eigenMaterial(scene, { view }).copy(material);
    clone.lightRotation.copy(material.lightRotation);
    return clone;
  };
  material.customProgramCacheKey = () => text;
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms);
    const [main, outgoing] = ["void main() {", /vec3 outgoingLight = .*/];
    if (!(shader.fragmentShader.includes(main) && outgoing.test(shader.fragmentShader))) {
      throw new Error("eigenMaterial: this version of three.js has another MeshMatcapMaterial");
    }
    shader.fragmentShader = shader.fragmentShader.replace(main, `${text}${DECLARED}${main}`).replace(outgoing, OUTGOING);
  };
  material.onBeforeRender = (renderer, world, camera, geometry, object) => {
    check(object);
    turn.setFromRotationMatrix(camera.matrixWorldInverse).multiply(material.lightRotation);
    uniforms.eigenPerspective.value = camera.isPerspectiveCamera;
    if (view === "object" && camera.isPerspectiveCamera) {
      // three.js uploads the uniforms of a material once for all meshes that follow each other.
      const { frame: now } = renderer.info.render;
      if (object !== mesh && picture === now && drawer === renderer) {
        throw new Error("eigenMaterial: each mesh needs a material of its own");
      }
      [mesh, picture, drawer] = [object, now, renderer];
      const frame = frameOf(object, camera);
      uniforms.eigenFrame.value.setFromMatrix4(matrix.makeRotationFromQuaternion(frame));
      turn.premultiply(frame);
    } else {
      uniforms.eigenFrame.value.identity();
    }
    if (!changed && turn.equals(turned)) return;
    scene.turn(turned.copy(turn).toArray());
    uniforms.eigenshade.value = stored(scene, uniforms.eigenshade.value);
    // With a tolerance the terms depend on the light and its turn.
    const now = changed || scene.truncation ? textOf(scene, uniforms.eigenshade.value) : text;
    if (now !== text) material.needsUpdate = true;
    [text, changed] = [now, false];
  };
  material.addEventListener("dispose", () => uniforms.eigenshade.value.dispose?.());
  return material;
}

/** Uniform vectors that are left for a scene: WebGL 2 promises 224 in all. */
const MOST = 200;

/** The array of a scene as a uniform, or where it is too long as a texture, the one `before` if it fits. */
function stored(scene, before) {
  const vectors = scene.uniforms();
  const width = vectors.length / 4;
  if (width <= MOST) {
    before?.dispose?.();
    return vectors;
  }
  const texture = before?.image?.width === width ? before : new DataTexture(vectors, width, 1, RGBAFormat, FloatType);
  if (before !== texture) before?.dispose?.();
  texture.image.data = vectors;
  texture.needsUpdate = true;
  return texture;
}

/** The text of a scene that reads what is stored. */
const textOf = (scene, { isTexture }) => scene.glsl(isTexture ? "texture" : "uniforms");

const DECLARED = `
uniform mat3 eigenFrame;
uniform bool eigenPerspective;
`;

// In perspective the normal turns halfway to the frame in which z is its own direction of view:
// matte light needs no turn and mirrored light a whole one. Behind the rim the polynomials grow
// without bound, so the irradiance there is that of the rim.
const OUTGOING = `
  vec3 eigenNormal = eigenFrame * normal;
  if (eigenPerspective) {
    vec3 eigenView = eigenFrame * normalize(vViewPosition);
    vec3 eigenHalf = normalize(eigenView + vec3(0.0, 0.0, 1.0));
    vec3 eigenSum = eigenView + eigenHalf;
    eigenNormal += 2.0 * dot(eigenNormal, eigenView) * eigenHalf
      - dot(eigenNormal, eigenSum) / (1.0 + dot(eigenView, eigenHalf)) * eigenSum;
  }
  if (eigenNormal.z < 0.0) {
    eigenNormal = vec3(eigenNormal.xy * inversesqrt(max(dot(eigenNormal.xy, eigenNormal.xy), 1e-12)), 0.0);
  }
  vec3 outgoingLight = diffuseColor.rgb * max(irradiance(eigenNormal), 0.0);`;

const [frame, matrix, center, sphere] = [new Quaternion(), new Matrix4(), new Vector3(), new Sphere()];

/** The rotation that turns the direction from a mesh to the camera, in the camera's frame, to z. */
function frameOf(object, camera) {
  // Skinned and instanced meshes have spheres of their own.
  const owner = object.boundingSphere === undefined ? object.geometry : object;
  if (owner.boundingSphere === null) owner.computeBoundingSphere();
  sphere.copy(owner.boundingSphere).applyMatrix4(object.matrixWorld);
  center.copy(sphere.center).applyMatrix4(camera.matrixWorldInverse).negate();
  return frame.setFromUnitVectors(center.normalize(), TOWARD_CAMERA);
}

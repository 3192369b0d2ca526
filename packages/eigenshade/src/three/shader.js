// The fragment shader of `MeshStandardMaterial` with another light.

/** Lights, shadows and environments of three.js. */
const LEFT_OUT = [
  "iridescence_fragment", "envmap_common_pars_fragment", "envmap_physical_pars_fragment",
  "lightmap_pars_fragment", "lights_pars_begin", "lights_physical_pars_fragment",
  "transmission_pars_fragment", "shadowmap_pars_fragment",
];
/** What computes their light. */
const [FROM, TO] = ["#include <emissivemap_fragment>", "#include <opaque_fragment>"];
const MAIN = "void main() {";

const UNIFORMS = `
uniform mat3 eigenFrame;
uniform bool eigenPerspective;
uniform float eigenExposure;
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
  float eigenOcclusion = 1.0;
  #ifdef USE_AOMAP
    eigenOcclusion += (texture2D(aoMap, vAoMapUv).r - 1.0) * aoMapIntensity;
  #endif
  vec3 eigenLight = eigenReflected(
    eigenNormal, diffuseColor.rgb, metalnessFactor, roughnessFactor, eigenOcclusion);
  vec3 outgoingLight = eigenExposure * max(eigenLight, 0.0) + totalEmissiveRadiance;
`;

/**
 * The shader with the light of `vec3 eigenReflected(normal, base, metallic, roughness, occlusion)`.
 *
 * @param {string} fragment the shader of `MeshStandardMaterial`
 * @param {string} reflected the text of the function
 */
export function patched(fragment, reflected) {
  const [from, to] = [FROM, TO].map((include) => fragment.indexOf(include));
  if (from < 0 || to < from || !fragment.includes(MAIN)) {
    throw new Error("EigenMaterial: this version of three.js has another MeshStandardMaterial; use 0.187");
  }
  const lit = fragment.slice(0, from + FROM.length) + OUTGOING + fragment.slice(to);
  return LEFT_OUT.reduce((text, name) => text.replace(`#include <${name}>`, ""), lit)
    .replace(MAIN, () => `${UNIFORMS}${reflected}\n${MAIN}`);
}

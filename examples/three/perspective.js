// node perspective.js [--check]: the error of an orthographic view for objects at the edge of a
// perspective picture. Writes results/perspective.csv and a table of README.md.
//
// The reference turns the light and the normal of every pixel into the frame of the pixel's own
// direction: there the package is exact, to 2e-6 of the peak of the direct sum over modes.

import { Scene } from "../../packages/eigenshade/src/index.js";
import { Quaternion, Vector3 } from "three";
import { checkRows, markdown, percent, putTable, writeRows } from "./tables.js";

const COMMAND = "node perspective.js";
const PAIRS = ["lobby", "park", "studio"].flatMap((light) =>
  ["gold-metallic-paint", "red-fabric2", { baseColor: "#a0522d", roughness: 0.5 }].map((material) => ({ light, material })));
/** White and matte: the frame of each fragment is wrong for it. */
const MATTE = { light: "park", material: { r: [2], g: [2], b: [2] } };
const FIELDS = [20, 35, 50, 75];
/** Radius of the sphere, as a share of the picture's height. */
const RADII = [0.05, 0.15];
const PIXELS = 150;
const Z = new Vector3(0, 0, 1);
const { sin, cos, sqrt, asin, atan, tan, PI } = Math;

/** Directions to the camera and normals of a sphere that touches the edge of a picture, at an angle. */
function sphere(field, radius, angle) {
  const half = (field * PI) / 360;
  // It touches the edge: its own picture reaches from `half` inward.
  const angular = (half - atan(tan(half) * (1 - 4 * radius))) / 2;
  const center = new Vector3(sin(half - angular) * cos(angle), sin(half - angular) * sin(angle), -cos(half - angular));
  const toCenter = new Quaternion().setFromUnitVectors(new Vector3(0, 0, -1), center);
  const points = [];
  for (let k = 0; k < PIXELS; k++) {
    const [share, around] = [sqrt((k + 0.5) / PIXELS), k * PI * (3 - sqrt(5))];
    const off = asin(share * sin(angular));
    const ray = new Vector3(sin(off) * cos(around), sin(off) * sin(around), -cos(off)).applyQuaternion(toCenter);
    // The center has distance 1.
    const along = ray.dot(center);
    const distance = along - sqrt(Math.max(0, along ** 2 - 1 + sin(angular) ** 2));
    const normal = ray.clone().multiplyScalar(distance).sub(center).normalize();
    points.push({ view: ray.negate(), normal });
  }
  return { center: center.negate(), points };
}

/** The irradiances of normals, which the frame turns and the rim bounds. */
function shaded(scene, normals) {
  const bounded = normals.map((n) => (n.z < 0 ? n.clone().setZ(0).normalize() : n));
  const { r, g, b } = scene.shade(...["x", "y", "z"].map((axis) => bounded.map((n) => n[axis])));
  return normals.map((_, k) => [r[k], g[k], b[k]]);
}

/** The rotation that turns a direction of view to z. */
const to = (view) => new Quaternion().setFromUnitVectors(view, Z);

/** A normal, turned halfway to the frame of its own direction. */
const halfway = (normal, view) =>
  normal.clone().applyQuaternion(new Quaternion().setFromUnitVectors(view, view.clone().add(Z).normalize()));

/** Normals by these rules, under the light turned by a frame. */
const VIEWS = {
  // The camera's axis is the direction of view of all.
  plain: [() => new Quaternion(), (normal) => normal],
  // As a matcap: each normal in the frame of its own direction, the light in the camera's.
  fragment: [() => new Quaternion(), (normal, view) => normal.clone().applyQuaternion(to(view))],
  // `view: "camera"` of the material.
  camera: [() => new Quaternion(), halfway],
  // The light and the normals in the frame of the mesh's center.
  center: [to, (normal) => normal],
  // `view: "object"` of the material, its default.
  object: [to, halfway],
};

function shadedBy(view, scene, { points, center }) {
  const [frameOf, rule] = VIEWS[view];
  const frame = frameOf(center);
  scene.turn(frame.toArray());
  return shaded(scene, points.map(({ normal, view }) =>
    rule(normal.clone().applyQuaternion(frame), view.clone().applyQuaternion(frame))));
}

const rows = [];
const scenes = await Promise.all([...PAIRS, MATTE].map((pair) => Scene.create(pair)));
for (const field of FIELDS) {
  for (const radius of RADII) {
    const found = Object.fromEntries(Object.keys(VIEWS).map((view) => [view, { rms: [], worst: [], matte: 0 }]));
    for (const [which, scene] of scenes.entries()) {
      for (const angle of [0, PI / 2, PI, 1.5 * PI]) {
        const picture = sphere(field, radius, angle);
        const reference = picture.points.flatMap(({ normal, view }) => {
          const frame = to(view);
          scene.turn(frame.toArray());
          return shaded(scene, [normal.clone().applyQuaternion(frame)]);
        }).flat();
        const peak = Math.max(...reference);
        for (const view of Object.keys(VIEWS)) {
          const errors = shadedBy(view, scene, picture).flat().map((number, k) => Math.abs(number - reference[k]) / peak);
          const rms = sqrt(errors.reduce((sum, error) => sum + error ** 2, 0) / errors.length);
          if (which === PAIRS.length) {
            found[view].matte = Math.max(found[view].matte, rms);
            continue;
          }
          found[view].rms.push(rms);
          found[view].worst.push(Math.max(...errors));
        }
      }
    }
    for (const [view, { rms, worst, matte }] of Object.entries(found)) {
      rms.sort((a, b) => a - b);
      const median = (rms[rms.length / 2 - 1] + rms[rms.length / 2]) / 2;
      rows.push({ field, radius, view, rms_median: median.toPrecision(3), rms_largest: rms.at(-1).toPrecision(3), worst: Math.max(...worst).toPrecision(3), matte_largest: matte < 1e-4 ? 0 : matte.toPrecision(3) });
    }
  }
}
if (process.argv.includes("--check")) {
  checkRows("perspective", COMMAND, rows, ["field", "radius", "view", "rms_median", "rms_largest", "worst", "matte_largest"]);
} else {
  writeRows("perspective", COMMAND, rows);
  const names = { plain: "camera's axis", fragment: "frame of each fragment, light of the camera (matcap)", camera: '`view: "camera"`', center: "frame of the mesh", object: '`view: "object"`' };
  const sizes = FIELDS.flatMap((field) => RADII.map((radius) => ({ field, radius })));
  putTable("perspective", markdown(
    ["field of view, diameter of the sphere", ...Object.values(names)],
    sizes.map(({ field, radius }) => [`${field}°, ${200 * radius} %`, ...Object.keys(names).map((view) => {
      const row = rows.find((row) => row.field === field && row.radius === radius && row.view === view);
      return `${percent(row.rms_median)} / ${percent(row.rms_largest)}`;
    })]),
  ));
}

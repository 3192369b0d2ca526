// Meshes for the pages and the tests: none of them needs a file.

import * as THREE from "three";

/** A tangent-space normal map of smooth bumps, which repeats. */
export function normalMap(size = 256, bumps = 4, height = 0.12) {
  const data = new Uint8Array(4 * size * size);
  for (let k = 0; k < size * size; k++) {
    const [u, v] = [k % size, Math.floor(k / size)].map((at) => (2 * Math.PI * bumps * at) / size);
    const slope = [Math.cos(u) * Math.sin(v), Math.sin(u) * Math.cos(v)].map((s) => -bumps * height * s);
    const length = Math.hypot(...slope, 1);
    data.set([...slope, 1].map((s) => Math.round(127.5 + (127.5 * s) / length)), 4 * k);
    data[4 * k + 3] = 255;
  }
  const texture = new THREE.DataTexture(data, size, size);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** A knot, whose normal map is stretched along it. */
export function knot(material) {
  return new THREE.Mesh(new THREE.TorusKnotGeometry(0.7, 0.26, 192, 48), material);
}

/** A column of three bones; `bend(angle)` bends it. */
export function column(material) {
  const geometry = new THREE.CapsuleGeometry(0.3, 1.4, 12, 32, 24);
  const { position } = geometry.attributes;
  const [indices, weights] = [[], []];
  for (let k = 0; k < position.count; k++) {
    const along = THREE.MathUtils.clamp((position.getY(k) / 0.7 + 1) * 0.999, 0, 1.999);
    const bone = Math.floor(along);
    indices.push(bone, bone + 1, 0, 0);
    weights.push(1 - (along - bone), along - bone, 0, 0);
  }
  geometry.setAttribute("skinIndex", new THREE.Uint16BufferAttribute(indices, 4));
  geometry.setAttribute("skinWeight", new THREE.Float32BufferAttribute(weights, 4));
  const bones = [-0.7, 0.7, 0.7].map((y) => {
    const bone = new THREE.Bone();
    bone.position.y = y;
    return bone;
  });
  bones[0].add(bones[1].add(bones[2]));
  const mesh = new THREE.SkinnedMesh(geometry, material);
  mesh.add(bones[0]);
  mesh.bind(new THREE.Skeleton(bones));
  mesh.bend = (angle) => bones.forEach((bone) => (bone.rotation.z = angle));
  return mesh;
}

/** A sphere that morphs into an ellipsoid. */
export function morphing(material, share) {
  const geometry = new THREE.SphereGeometry(0.8, 64, 32);
  const { position, normal } = geometry.attributes;
  const flat = [position.clone(), normal.clone()];
  for (let k = 0; k < position.count; k++) {
    flat[0].setY(k, 0.4 * position.getY(k));
    flat[1].setXYZ(k, ...new THREE.Vector3(normal.getX(k), normal.getY(k) / 0.4, normal.getZ(k)).normalize());
  }
  geometry.morphAttributes.position = [flat[0]];
  geometry.morphAttributes.normal = [flat[1]];
  const mesh = new THREE.Mesh(geometry, material);
  mesh.updateMorphTargets();
  mesh.morphTargetInfluences[0] = share;
  return mesh;
}

/** Turned ellipsoids in one draw call. */
export function instances(material) {
  const mesh = new THREE.InstancedMesh(new THREE.SphereGeometry(0.3, 48, 24), material, 9);
  const [at, turn, scale] = [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3(1, 0.6, 1)];
  for (let k = 0; k < 9; k++) {
    at.set((k % 3) - 1, Math.floor(k / 3) - 1, 0).multiplyScalar(0.7);
    turn.setFromEuler(new THREE.Euler(k, 2 * k, 0));
    mesh.setMatrixAt(k, new THREE.Matrix4().compose(at, turn, scale));
  }
  return mesh;
}

// A small .glb made by code, in Node.

import { deflateSync } from "node:zlib";

const CRC = Uint32Array.from({ length: 256 }, (_, k) => {
  for (let bit = 0; bit < 8; bit++) k = k & 1 ? 0xedb88320 ^ (k >>> 1) : k >>> 1;
  return k;
});

function chunk(name, data) {
  const body = Buffer.concat([Buffer.from(name), data]);
  let crc = -1;
  for (const byte of body) crc = CRC[(crc ^ byte) & 255] ^ (crc >>> 8);
  const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  check.writeUInt32BE(~crc >>> 0);
  return Buffer.concat([length, body, check]);
}

/** A PNG of texels, each red, green, blue and opacity, row by row from the top. */
export function png({ width, height, texels }) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 6], 8);
  const rows = Array.from({ length: height }, (_, row) =>
    Buffer.from([0, ...texels.slice(4 * width * row, 4 * width * (row + 1))]));
  return Buffer.concat([
    Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]), chunk("IHDR", header), chunk("IDAT", deflateSync(Buffer.concat(rows))),
    chunk("IEND", Buffer.alloc(0)),
  ]);
}

/** A sphere of radius 1, and `colors` of its vertices, a function of the position. */
function sphere(colors, [across, down] = [96, 64]) {
  const [positions, uvs, indices] = [[], [], []];
  for (let row = 0; row <= down; row++) {
    for (let column = 0; column <= across; column++) {
      const [theta, phi] = [(Math.PI * row) / down, (2 * Math.PI * column) / across];
      positions.push(-Math.cos(phi) * Math.sin(theta), Math.cos(theta), Math.sin(phi) * Math.sin(theta));
      uvs.push(column / across, row / down);
    }
  }
  for (let row = 0; row < down; row++) {
    for (let column = 0; column < across; column++) {
      const [a, b] = [row, row + 1].map((at) => at * (across + 1) + column);
      if (row > 0) indices.push(a + 1, a, b + 1);
      if (row < down - 1) indices.push(a, b, b + 1);
    }
  }
  const points = Array.from({ length: positions.length / 3 }, (_, k) => positions.slice(3 * k, 3 * k + 3));
  return { positions, normals: positions, uvs, indices, colors: colors && points.flatMap(colors) };
}

/** A square in the plane of the picture that faces the camera. */
const leaf = () => ({
  positions: [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0],
  normals: [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1],
  uvs: [0, 1, 1, 1, 1, 0, 0, 0],
  indices: [0, 1, 2, 0, 2, 3],
});

/**
 * A file with a sphere, a `leaf` or a mesh of one's own, of a material as glTF has it; its textures are names
 * of `images`, and drawn without interpolation. `colors` is a function of the position. `more` has other parts
 * of the file.
 */
export function glb({ shape = "sphere", material = {}, images = {}, colors, more = {} }) {
  const mesh = typeof shape === "object" ? shape : shape === "leaf" ? leaf() : sphere(colors);
  const [parts, bufferViews, accessors] = [[], [], []];
  let end = 0;
  const view = (bytes) => {
    const padded = Buffer.concat([bytes, Buffer.alloc(-bytes.length & 3)]);
    parts.push(padded);
    bufferViews.push({ buffer: 0, byteOffset: end, byteLength: bytes.length });
    end += padded.length;
    return bufferViews.length - 1;
  };
  const accessor = (numbers, type, componentType = 5126) => {
    const array = componentType === 5126 ? Float32Array.from(numbers) : Uint32Array.from(numbers);
    const size = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type];
    const bounds = (of) => Array.from({ length: size }, (_, axis) => of(...numbers.filter((_, k) => k % size === axis)));
    accessors.push({
      bufferView: view(Buffer.from(array.buffer)), componentType, type, count: numbers.length / size,
      ...(size === 3 && { min: bounds(Math.min), max: bounds(Math.max) }),
    });
    return accessors.length - 1;
  };
  const attributes = {
    POSITION: accessor(mesh.positions, "VEC3"), NORMAL: accessor(mesh.normals, "VEC3"), TEXCOORD_0: accessor(mesh.uvs, "VEC2"),
    ...(mesh.tangents && { TANGENT: accessor(mesh.tangents, "VEC4") }),
    ...(mesh.colors && { COLOR_0: accessor(mesh.colors, "VEC3") }),
  };
  const primitive = { attributes, indices: accessor(mesh.indices, "SCALAR", 5125), material: 0 };
  const names = Object.keys(images);
  const withIndices = (value) =>
    value && typeof value === "object" && !Array.isArray(value)
      ? Object.fromEntries(Object.entries(value).map(([key, part]) => [key, key === "index" ? names.indexOf(part) : withIndices(part)]))
      : value;
  const json = {
    asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [primitive] }], materials: [withIndices(material)], accessors, bufferViews,
    images: names.map((name) => ({ mimeType: "image/png", bufferView: view(png(images[name])) })),
    textures: names.map((_, source) => ({ source, sampler: 0 })),
    samplers: [{ magFilter: 9728, minFilter: 9728 }],
    ...more,
  };
  json.buffers = [{ byteLength: end }];
  if (!names.length) for (const name of ["images", "textures", "samplers"]) delete json[name];
  const text = Buffer.from(JSON.stringify(json));
  const body = Buffer.concat([text, Buffer.alloc(-text.length & 3, " ")]);
  const head = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  return Buffer.concat([
    head(0x46546c67, 2, 28 + body.length + end), head(body.length, 0x4e4f534a), body, head(end, 0x004e4942), ...parts,
  ]);
}

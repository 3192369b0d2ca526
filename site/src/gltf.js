// What a glTF file says of itself, before it is loaded.

/** Extensions that are drawn; others that a file can do without are left out. */
const DRAWN = [
  "KHR_materials_emissive_strength", "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform",
  "EXT_mesh_gpu_instancing", "EXT_texture_webp", "EXT_texture_avif",
];

/** What packs the data of a file, and is not unpacked here. */
const PACKED = {
  KHR_draco_mesh_compression: "Draco",
  EXT_meshopt_compression: "meshopt",
  KHR_texture_basisu: "Basis Universal",
};

/**
 * Checks a file.
 *
 * @param {ArrayBuffer} bytes a .glb, or a .gltf that holds its own data
 * @returns {string[]} the extensions that are left out
 * @throws {Error} if it cannot be drawn
 */
export function checkGltf(bytes) {
  const json = parsed(textOf(bytes));
  if (!/^2\./.test(json.asset?.version)) throw new Error(`it is glTF of version ${json.asset?.version}; expected 2.0`);
  const { extensionsUsed = [], extensionsRequired = [] } = json;
  const left = (/** @type {string[]} */ names) => names.filter((name) => !DRAWN.includes(name));
  for (const [name, packer] of Object.entries(PACKED)) {
    if (extensionsUsed.includes(name)) throw new Error(`it is compressed by ${packer}; export it without`);
  }
  const [missing] = left(extensionsRequired);
  if (missing) throw new Error(`it needs the extension ${missing}, which is not drawn`);
  if (!json.meshes?.length) throw new Error("it has no mesh");
  const parts = [json.buffers, json.images].flatMap((all) => all ?? []);
  const other = parts.find(({ uri }) => uri && !uri.startsWith("data:"));
  if (other) throw new Error(`it refers to the file ${other.uri}; export a .glb, which holds all its data`);
  return left(extensionsUsed);
}

/** The JSON of a file, which a .glb has after a head of 20 bytes. */
function textOf(/** @type {ArrayBuffer} */ bytes) {
  const words = new Uint32Array(bytes.slice(0, Math.min(20, bytes.byteLength & ~3)));
  if (words[0] !== 0x46546c67) return new TextDecoder().decode(bytes);
  const [, version, length, size, kind] = words;
  if (version !== 2 || kind !== 0x4e4f534a) throw new Error("it is not a .glb of version 2");
  if (length > bytes.byteLength) throw new Error(`it ends after ${bytes.byteLength} of ${length} bytes`);
  return new TextDecoder().decode(bytes.slice(20, 20 + size));
}

/** @returns {any} */
function parsed(/** @type {string} */ text) {
  try {
    return Object(JSON.parse(text));
  } catch {
    throw new Error("it is not a glTF file");
  }
}

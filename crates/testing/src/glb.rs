//! Small glTF files, written by hand.

use std::f32::consts::{PI, TAU};

/// The type of floats.
pub const FLOAT: u32 = 5126;

/// The bytes of floats.
#[must_use]
pub fn floats(all: &[f32]) -> Vec<u8> {
    all.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// A glTF file of one mesh with one material.
#[derive(Clone, Debug)]
pub struct Glb {
    /// The corners.
    pub positions: Vec<[f32; 3]>,
    /// Their normals; none if empty, as below.
    pub normals: Vec<[f32; 3]>,
    /// Texture coordinates.
    pub coordinates: Vec<[f32; 2]>,
    /// Linear colors and opacities.
    pub colors: Vec<[f32; 4]>,
    /// Three corners for each triangle.
    pub indices: Vec<u32>,
    /// Further accessors, numbered from 0: type of number, kind and bytes.
    pub accessors: Vec<(u32, &'static str, Vec<u8>)>,
    /// Further attributes, each behind a comma.
    pub attributes: String,
    /// The members of the primitive after its material, each behind a comma.
    pub primitive: String,
    /// The members of the node after its mesh, each behind a comma.
    pub node: String,
    /// Further nodes, numbered from 1, each behind a comma.
    pub nodes: String,
    /// The members of the material.
    pub material: String,
    /// The pictures of the textures of the same numbers.
    pub images: Vec<Vec<u8>>,
    /// Members of the file, each before a comma.
    pub extra: String,
}

impl Glb {
    /// A square from (-1, -1) to (1, 1) that faces +z.
    #[must_use]
    pub fn square() -> Self {
        Self {
            positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]],
            normals: vec![[0.0, 0.0, 1.0]; 4],
            coordinates: vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]],
            colors: Vec::new(),
            indices: vec![0, 1, 2, 0, 2, 3],
            accessors: Vec::new(),
            attributes: String::new(),
            primitive: String::new(),
            node: String::new(),
            nodes: String::new(),
            material: String::new(),
            images: Vec::new(),
            extra: String::new(),
        }
    }

    /// A sphere of radius 1 about the axis y, with this many rings and twice as many columns.
    #[must_use]
    pub fn sphere(rings: u32) -> Self {
        let columns = 2 * rings;
        let (mut positions, mut coordinates, mut indices) = (Vec::new(), Vec::new(), Vec::new());
        for row in 0..=rings {
            for column in 0..=columns {
                let [u, v] = [column as f32 / columns as f32, row as f32 / rings as f32];
                let ((s, c), (t, d)) = ((PI * v).sin_cos(), (TAU * u).sin_cos());
                positions.push([-s * d, c, s * t]);
                coordinates.push([u, v]);
                if row < rings && column < columns {
                    let a = row * (columns + 1) + column;
                    let b = a + columns + 1;
                    indices.extend([a, b, a + 1, a + 1, b, b + 1]);
                }
            }
        }
        Self { normals: positions.clone(), positions, coordinates, indices, ..Self::square() }
    }

    /// The numbers, and the JSON of the file, whose buffer has this URI.
    #[must_use]
    pub fn parts(&self, uri: &str) -> (String, Vec<u8>) {
        let (mut bytes, mut views, mut accessors) = (Vec::new(), Vec::new(), Vec::new());
        let mut attributes = Vec::new();
        let further = self.accessors.iter();
        let further = further.map(|(number, kind, bytes)| ("", *number, *kind, bytes.clone()));
        let indices: Vec<u8> = self.indices.iter().flat_map(|x| x.to_le_bytes()).collect();
        for (name, number, kind, values) in further.chain([
            ("POSITION", FLOAT, "VEC3", floats(self.positions.as_flattened())),
            ("NORMAL", FLOAT, "VEC3", floats(self.normals.as_flattened())),
            ("TEXCOORD_0", FLOAT, "VEC2", floats(self.coordinates.as_flattened())),
            ("COLOR_0", FLOAT, "VEC4", floats(self.colors.as_flattened())),
            ("", 5125, "SCALAR", indices),
        ]) {
            if values.is_empty() {
                continue;
            }
            let (offset, length) = (bytes.len(), values.len());
            let wide = [("VEC2", 2), ("VEC3", 3), ("VEC4", 4), ("MAT4", 16)];
            let wide = wide.iter().find(|(known, _)| *known == kind).map_or(1, |(_, size)| *size);
            let bytes_each = [(FLOAT, 4), (5125, 4), (5123, 2)];
            let each = bytes_each.iter().find(|(known, _)| *known == number);
            let (view, count) =
                (accessors.len(), length / wide / each.map_or(1, |(_, each)| *each));
            views.push(format!(r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{length}}}"#));
            let bounds = if name == "POSITION" { r#","min":[-9,-9,-9],"max":[9,9,9]"# } else { "" };
            accessors.push(format!(
                r#"{{"bufferView":{view},"componentType":{number},"count":{count},"type":"{kind}"{bounds}}}"#
            ));
            if !name.is_empty() {
                attributes.push(format!(r#""{name}":{view}"#));
            }
            bytes.extend(values);
            bytes.resize(bytes.len().next_multiple_of(4), 0);
        }
        let indices = accessors.len() - 1;
        let (mut images, mut textures) = (Vec::new(), Vec::new());
        for image in &self.images {
            let (offset, length, view) = (bytes.len(), image.len(), views.len());
            views.push(format!(r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{length}}}"#));
            textures.push(format!(r#"{{"source":{}}}"#, images.len()));
            images.push(format!(r#"{{"bufferView":{view},"mimeType":"image/png"}}"#));
            bytes.extend(image);
            bytes.resize(bytes.len().next_multiple_of(4), 0);
        }
        let list = |name: &str, all: &[String]| match all {
            [] => String::new(),
            _ => format!(r#""{name}":[{}],"#, all.join(",")),
        };
        let json = format!(
            r#"{{"asset":{{"version":"2.0"}},{}{}{}{}{}"buffers":[{{"byteLength":{}{uri}}}],"materials":[{{{}}}],"meshes":[{{"primitives":[{{"attributes":{{{}{}}},"indices":{indices},"material":0{}}}]}}],"nodes":[{{"mesh":0{}}}{}],"scene":0,"scenes":[{{"nodes":[0]}}]}}"#,
            self.extra,
            list("images", &images),
            list("textures", &textures),
            list("bufferViews", &views),
            list("accessors", &accessors),
            bytes.len(),
            self.material,
            attributes.join(","),
            self.attributes,
            self.primitive,
            self.node,
            self.nodes,
        );
        (json, bytes)
    }

    /// The file.
    #[must_use]
    pub fn bytes(&self) -> Vec<u8> {
        let (json, mut binary) = self.parts("");
        let mut json = json.into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        binary.resize(binary.len().next_multiple_of(4), 0);
        let length = 12 + 8 + json.len() + 8 + binary.len();
        let word = |number: usize| (number as u32).to_le_bytes();
        let chunk = |kind: &[u8; 4], bytes: &[u8]| [&word(bytes.len()), &kind[..], bytes].concat();
        let head = [&b"glTF"[..], &word(2), &word(length)].concat();
        [head, chunk(b"JSON", &json), chunk(b"BIN\0", &binary)].concat()
    }
}

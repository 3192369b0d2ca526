//! Writes the seed corpora: `cargo run --example seeds`. Lights and materials of the kinds
//! that there are, in the order in which `tests/invariants` reads them.

use eigenshade_index::{light, material};
use std::path::Path;

/// Where a target's seeds stand, and what makes them.
type Corpus = (&'static str, fn() -> Vec<(String, Vec<u8>)>);

const CORPORA: [Corpus; 4] = [
    ("shade_any", shade_any),
    ("public_interface", public_interface),
    ("project_reconstruct", reconstruct),
    ("from_bytes", tables),
];

fn main() -> std::io::Result<()> {
    for (target, seeds) in CORPORA {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("seeds").join(target);
        if folder.exists() {
            std::fs::remove_dir_all(&folder)?;
        }
        std::fs::create_dir_all(&folder)?;
        for (name, bytes) in seeds() {
            std::fs::write(folder.join(name), bytes)?;
        }
    }
    Ok(())
}

/// A mantissa of 31 bits that falls with its place, of either sign.
fn mantissa(place: usize) -> i32 {
    let size = i32::MAX / (place as i32 + 1);
    if place % 3 == 1 { -size } else { size }
}

/// A mantissa in `bytes` bytes, little-endian.
fn put(to: &mut Vec<u8>, mantissa: i32, bytes: usize) {
    to.extend(&mantissa.to_le_bytes()[4 - bytes..]);
}

fn put_normals(to: &mut Vec<u8>, bytes: usize) {
    for (x, y, z) in [(0.0, 0.0, 1.0), (1.0, 0.0, 0.0), (0.6, 0.0, 0.8), (-0.36, 0.48, 0.8)] {
        for component in [x, y, z] {
            put(to, (component * f64::from(i32::MAX)) as i32, bytes);
        }
        to.push(0);
    }
}

fn shade_any() -> Vec<(String, Vec<u8>)> {
    let mut seeds = Vec::new();
    for (degree, order) in [(0, 0), (1, 0), (2, 1), (4, 4), (9, 7)] {
        let counts = [light::count(degree), material::count(order)];
        let mut floats = vec![0, degree as u8];
        for (count, next) in counts.into_iter().zip([Some(order as u8), None]) {
            let values = (0..count).map(|k| (mantissa(k) as f32 / i32::MAX as f32).to_le_bytes());
            floats.extend(values.flatten());
            floats.extend(next);
        }
        floats.extend([0.0f32, 0.6, 0.8].map(f32::to_le_bytes).concat());
        seeds.push((format!("f32-{degree}-{order}"), floats));
        for (kind, bytes) in [(1, 2), (2, 4)] {
            let mut from_material = vec![kind, 0xf1, degree as u8];
            (0..counts[0]).for_each(|k| put(&mut from_material, mantissa(k), bytes));
            from_material.push(order as u8);
            from_material.extend((0..=order).map(|o| 0u8.wrapping_sub(15 + o as u8)));
            (0..counts[1]).for_each(|k| put(&mut from_material, mantissa(k), bytes));
            put_normals(&mut from_material, bytes);
            seeds.push((format!("q{}-{degree}-{order}", 8 * bytes - 1), from_material));
        }
    }
    for (format, (bytes, bits)) in [(2, 15), (4, 31)].into_iter().enumerate() {
        let mut transfer = vec![3 + format as u8, 0xf1, 9];
        (0..100).for_each(|k| put(&mut transfer, mantissa(k), bytes));
        transfer.push(4);
        transfer.extend([0xf0, 0xff].repeat(28));
        (0..250).for_each(|k| put(&mut transfer, mantissa(k % 10), bytes));
        put_normals(&mut transfer, bytes);
        seeds.push((format!("q{bits}-transfer"), transfer));
        let mut coefficients = vec![5 + format as u8];
        put(&mut coefficients, -30, 4);
        coefficients.push(50);
        (0..50).for_each(|k| put(&mut coefficients, mantissa(k) >> 1, 4));
        put_normals(&mut coefficients, bytes);
        seeds.push((format!("q{bits}-coefficients"), coefficients));
    }
    // A color of three channels within 2^-7.
    let mut color = vec![7, 2, 1, 6, 0];
    for k in 0..150 {
        put(&mut color, mantissa(k % 50), 2);
        color.push(40);
    }
    seeds.push(("f32-color".to_owned(), color));
    seeds
}

/// Rotations of each kind, a light and an image of moderate size or of any, and some normals.
fn public_interface() -> Vec<(String, Vec<u8>)> {
    let seed = |(name, is_any): (&str, u8)| {
        let mut bytes = Vec::new();
        bytes.extend([1u64 << 32, 1, 0].map(u64::to_le_bytes).concat());
        bytes.push(is_any);
        bytes.push(4);
        bytes.push(0);
        bytes.extend([0.0f32, 0.0, 0.0, 7e-20].map(f32::to_le_bytes).concat());
        bytes.extend([1, 3, 250, 7, 100]);
        bytes.extend([3, 40, 80, 200]);
        bytes.extend([4, 30, 1, 2]);
        for k in 0..150 {
            if is_any == 0 {
                put(&mut bytes, mantissa(k % 100), 2);
                bytes.push(40);
            } else {
                bytes.extend((mantissa(k % 100) as f32 / i32::MAX as f32).to_le_bytes());
            }
        }
        bytes.extend([24, 30, 40]);
        for normal in [[0.0f32, 0.0, 1.0], [0.0, 0.0, 1e30], [0.8, 0.6, -0.1], [-0.36, 0.48, 0.8]] {
            bytes.extend(normal.map(f32::to_le_bytes).concat());
        }
        (name.to_owned(), bytes)
    };
    [("moderate", 0), ("any", 1)].map(seed).to_vec()
}

fn reconstruct() -> Vec<(String, Vec<u8>)> {
    let seed = |(degree, order): (usize, usize)| {
        let mut bytes = Vec::new();
        for (most, count) in [(degree, light::count(degree)), (order, material::count(order))] {
            bytes.push(most as u8);
            for k in 0..count {
                put(&mut bytes, mantissa(k), 2);
                bytes.push(40);
            }
        }
        put_normals(&mut bytes, 4);
        (format!("{degree}-{order}"), bytes)
    };
    [(0, 0), (1, 0), (2, 2), (5, 4), (9, 7)].map(seed).to_vec()
}

/// The wire files of the tests.
fn tables() -> Vec<(String, Vec<u8>)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/wire_files");
    let seed = |name: &str| {
        let path = Path::new(folder).join(format!("{name}.esw"));
        (name.to_owned(), std::fs::read(path).expect("a wire file of the tests"))
    };
    [
        "v1.sphere.f32",
        "v1.mean.f32",
        "v1.general.f32",
        "v1.sphere.q15",
        "v1.sphere.q31",
        "v1.effects.f32",
        "v1.turned.q15",
        "v1.long.f32",
    ]
    .map(seed)
    .to_vec()
}

//! `eigenshade read`: pictures, by every way of giving them.

use crate::support::reading::{answer, get, nearest, png};
use crate::support::{Folder, repository};
use png::{BitDepth, ColorType};
use std::fs;

/// d of an image and its normals in 16 bits against those in 8 bits of sRGB and exact, of the
/// largest: half a step of 2^-16 in normals, steeper at the rim.
const READ_SIXTEEN_BITS: f64 = 5e-4;

/// Share of the energy that 50 components leave of a picture in 8 bits: 3 % in amplitude.
const READ_PICTURE: f64 = 1e-3;

/// Pictures of the shipped velvet.
#[test]
fn pictures() {
    let folder = Folder::new();
    let tables = repository().join("tables");
    let (table, lights) = (tables.join("sphere.bin"), tables.join("inputs/lights.csv"));
    let materials = tables.join("inputs/materials.csv");
    let (table, lights, materials) = (table.display(), lights.display(), materials.display());
    folder.ok(&format!(
        "render {table} --light {lights}:park --material {materials}:07-velvet --size 96 --out v.png"
    ));
    let read = |arguments: &str| {
        let output = folder.run(&format!("read {arguments} --table {table}"));
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{arguments}: {said}");
        (answer(&String::from_utf8(output.stdout).unwrap()), said)
    };
    // 8 bits of sRGB, transparent around, a hundredth of it clipped.
    let (sphere, said) = read("v.png --normals sphere");
    assert_eq!(nearest(&sphere), "07-velvet", "{said}");
    assert!(said.contains("v.png: 9216 pixels, ") && said.contains(" clipped"), "{said}");
    assert!(get(&sphere, "relative-residual", "posterior")[0][0] < READ_PICTURE);

    // The same in 16 linear bits, with the normals as a map and a mask of half.
    let file = fs::File::open(folder.path("v.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    let (mut linear, mut map, mut mask) = (Vec::new(), Vec::new(), Vec::new());
    for (place, pixel) in bytes.chunks_exact(4).enumerate() {
        let (x, y) = ((place % 96) as f64 - 47.5, 47.5 - (place / 96) as f64);
        let (x, y) = (x / 47.5, y / 47.5);
        let square = 1.0 - x * x - y * y;
        let normal = if square > 0.0 { [x, y, square.sqrt()] } else { [0.0; 3] };
        for (channel, n) in pixel.iter().zip(normal) {
            let value = eigenshade_cli::picture::tone::linear(f64::from(*channel) / 255.0);
            linear.extend(((65535.0 * value).round() as u16).to_be_bytes());
            map.extend(((65535.0 * (0.5 + 0.5 * n)).round() as u16).to_be_bytes());
        }
        mask.push(if x < 0.5 { 255 } else { 0 });
    }
    folder.write("linear.png", png(96, 96, BitDepth::Sixteen, ColorType::Rgb, &linear));
    folder.write("map.png", png(96, 96, BitDepth::Sixteen, ColorType::Rgb, &map));
    folder.write("mask.png", png(96, 96, BitDepth::Eight, ColorType::Grayscale, &mask));
    let (mapped, _) = read("linear.png --normals map.png");
    let pairs = [&sphere, &mapped].map(|found| get(found, "d", "posterior"));
    let largest = pairs[0][0][0].abs();
    let both = pairs[0].iter().flatten().zip(pairs[1].iter().flatten());
    let far = both.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / largest;
    println!("16 bits: {far:.1e}");
    assert!(far <= READ_SIXTEEN_BITS, "{far:e}");
    let (masked, said) = read("linear.png --normals map.png --mask mask.png");
    let counts = [&mapped, &masked].map(|found| get(found, "fit", "pixels")[0][0]);
    assert!(counts[1] < 0.85 * counts[0] && counts[1] > 0.7 * counts[0], "{counts:?} {said}");
    // A table by itself has its statistics with it.
    fs::copy(repository().join("tables/sphere.bin"), folder.path("alone.bin")).unwrap();
    let alone = answer(&folder.ok("read v.png --normals sphere --table alone.bin"));
    assert_eq!(alone, sphere);
    // Taken for linear, 8 bits of sRGB are another image.
    let (wrong, _) = read("v.png --normals sphere --transfer linear");
    assert!((get(&wrong, "d", "posterior")[0][0] / largest - 1.0).abs() > 0.1);
    // Noise and components by hand.
    let (fewer, _) = read("v.png --normals sphere --components 9 --noise 0.01");
    assert_eq!(get(&fewer, "d", "posterior").len(), 9);
    assert!(get(&fewer, "fit", "noise")[0][0] > 0.01);
}

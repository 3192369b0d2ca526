//! `eigenshade read`: what is read from images that are known, and what is refused.

mod support;

#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

use png::{BitDepth, ColorType, Encoder};
use std::collections::HashMap;
use std::fmt::Write;
use std::fs;
use support::{Folder, assert_fails, lights, materials, noise, numbers, repository, rows};

const HEADER: &str = "quantity,name,index,r,g,b";

/// The answer's numbers by quantity and name, in the order of the index.
fn answer(text: &str) -> HashMap<(String, String), Vec<[f64; 3]>> {
    let mut found: HashMap<_, Vec<[f64; 3]>> = HashMap::new();
    for row in rows(text, HEADER) {
        let rgb = [3, 4, 5].map(|field| row[field].parse::<f64>().expect("a number"));
        assert!(rgb.iter().all(|value| value.is_finite()), "{row:?}");
        let list = found.entry((row[0].clone(), row[1].clone())).or_default();
        if row[0].starts_with("material-") {
            // The index is the place among the materials.
            list.push([row[2].parse().unwrap(), rgb[0], rgb[1]]);
        } else {
            assert_eq!(row[2], list.len().to_string(), "{row:?}");
            list.push(rgb);
        }
    }
    found
}

fn get<'a>(
    answer: &'a HashMap<(String, String), Vec<[f64; 3]>>,
    quantity: &str,
    name: &str,
) -> &'a [[f64; 3]] {
    &answer[&(quantity.to_owned(), name.to_owned())]
}

/// The nearest material.
fn nearest(answer: &HashMap<(String, String), Vec<[f64; 3]>>) -> &str {
    let first = |((quantity, _), list): &(&(String, String), &Vec<[f64; 3]>)| {
        quantity == "material-evidence" && list[0][0] == 0.0
    };
    &answer.iter().find(first).expect("a first material").0.1
}

fn png(width: usize, height: usize, depth: BitDepth, colour: ColorType, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_depth(depth);
    encoder.set_color(colour);
    encoder.write_header().unwrap().write_image_data(bytes).unwrap();
    file
}

/// A folder with the small table of all components, 400 normals, and `image.csv`,
/// the image of one coloured light on the third material.
fn with_image() -> Folder {
    let folder = Folder::with_table();
    folder.write("light.csv", lights(support::DEGREE, 1));
    let all = materials(support::ORDER, 4);
    let one: String = all
        .lines()
        .filter(|line| !line.starts_with("material-") || line.starts_with("material-2,"))
        .map(|line| format!("{line}\n"))
        .collect();
    folder.write("material.csv", one);
    let (mut text, mut noise) = ("x,y,z\n".to_owned(), noise(5));
    for _ in 0..400 {
        writeln!(text, "{},{},{}", noise(), noise(), noise().abs()).unwrap();
    }
    folder.write("normals.csv", text);
    folder.ok("shade b.bin --lights light.csv --materials material.csv --normals normals.csv \
               --format f64 --out image.csv");
    folder
}

const READ: &str = "read image.csv --normals normals.csv --table b.bin";

#[test]
fn components_and_material_come_back() {
    let folder = with_image();
    let found = answer(&folder.ok(&format!("{READ} --light-out l.csv --modes-out m.csv")));
    let header = "light,material,component,r,g,b";
    let project = folder.ok("project b.bin --lights light.csv --materials material.csv");
    let expected = numbers(&rows(&project, header), 3);
    let largest = expected.iter().fold(0.0f64, |most, d| most.max(d.abs()));
    for estimate in ["least-squares", "posterior"] {
        let d: Vec<f64> = get(&found, "d", estimate).iter().flatten().copied().collect();
        assert_eq!(d.len(), expected.len());
        let far = d.iter().zip(&expected).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
        println!("{estimate}: {:.1e}", far / largest);
        assert!(far <= tolerances::READ_NOISELESS * largest, "{estimate}: {far:e}");
    }
    assert_eq!(get(&found, "fit", "pixels")[0][0], 400.0);
    assert!(get(&found, "relative-residual", "least-squares")[0][0] < 1e-12);
    assert_eq!(nearest(&found), "material-2");

    // The light that was read makes the image again.
    let shade = "shade b.bin --materials material.csv --normals normals.csv --format f64";
    let again = folder.ok(&format!("{shade} --lights l.csv"));
    let images = [folder.read("image.csv"), again]
        .map(|text| numbers(&rows(&text, "light,material,normal,r,g,b"), 3));
    let peak = images[0].iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let both = images[0].iter().zip(&images[1]);
    let far = both.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / peak;
    println!("the light's image: {far:.1e}");
    assert!(far <= tolerances::READ_NOISELESS, "{far:e}");
    assert!(folder.read("l.csv").contains("\nimage,0,0,"));
    let modes = rows(&folder.read("m.csv"), "estimate,l,m,o,p,q,r,g,b");
    let count = eigenshade_index::mode::total(support::DEGREE, support::ORDER);
    assert_eq!(modes.len(), 2 * count);
}

#[test]
fn both_criteria_read_alike() {
    let folder = with_image();
    folder.write("scene.toml", support::scene("standard", 10_000, "[]"));
    folder.ok("basis --scene scene.toml --out b.bin");
    let found = answer(&folder.ok(READ));
    assert!(get(&found, "relative-residual", "least-squares")[0][0] < 1e-12);
    assert_eq!(nearest(&found), "material-2");
    let project = folder.ok("project b.bin --lights light.csv --materials material.csv");
    let expected = numbers(&rows(&project, "light,material,component,r,g,b"), 3);
    let d = get(&found, "d", "least-squares").iter().flatten();
    let far = d.zip(&expected).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(far <= tolerances::READ_NOISELESS * expected[0].abs(), "{far:e}");
}

#[test]
fn weighted_images() {
    let folder = with_image();
    // A pixel that weighs nothing may show anything.
    let text = folder.read("image.csv");
    let last = text.trim_end().rfind('\n').unwrap();
    folder.write("bad.csv", format!("{}\nlight-0,material-2,399,9,9,9\n", &text[..last]));
    folder.write("mask.csv", format!("weight\n{}0\n", "2\n".repeat(399)));
    let bad = "read bad.csv --normals normals.csv --table b.bin";
    let [with, without] =
        [format!("{bad} --mask mask.csv"), bad.to_owned()].map(|line| answer(&folder.ok(&line)));
    assert_eq!(get(&with, "fit", "pixels")[0][0], 399.0);
    assert!(get(&with, "relative-residual", "least-squares")[0][0] < 1e-12);
    assert!(get(&without, "relative-residual", "least-squares")[0][0] > 1e-6);
    assert_eq!(nearest(&with), "material-2");
}

#[test]
fn any_unit_reads_alike() {
    let folder = with_image();
    let values = numbers(&rows(&folder.read("image.csv"), "light,material,normal,r,g,b"), 3);
    let scaled = |scale: f64| {
        let mut text = "r,g,b\n".to_owned();
        for [r, g, b] in values.as_chunks::<3>().0 {
            writeln!(text, "{:e},{:e},{:e}", scale * r, scale * g, scale * b).unwrap();
        }
        folder.write("scaled.csv", text);
        "read scaled.csv --normals normals.csv --table b.bin".to_owned()
    };
    let expected = answer(&folder.ok(READ));
    for scale in [1e-30, 1e30] {
        let found = answer(&folder.ok(&scaled(scale)));
        assert_eq!(nearest(&found), "material-2");
        let [found, expected] = [&found, &expected].map(|answer| get(answer, "d", "posterior"));
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            let far = (found / scale - expected).abs() / get_largest(&values);
            assert!(far <= tolerances::READ_NOISELESS, "{scale:e}: {far:e}");
        }
    }
    for scale in [1e-160, 1e160] {
        let arguments = format!("{} --out new.csv", scaled(scale));
        assert_fails(&folder, &arguments, &["scaled.csv", "largest", "scale it"]);
    }
}

fn get_largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// Pixels of one normal determine one number, whatever the table has.
#[test]
fn a_flat_object() {
    let folder = with_image();
    folder.write("flat.csv", format!("x,y,z\n{}", "0.3,0.1,1\n".repeat(400)));
    folder.write("grey.csv", format!("value\n{}", "0.5\n".repeat(400)));
    let text = folder.ok("read grey.csv --normals flat.csv --table b.bin");
    let value = |begins: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with(begins)).expect("a line");
        line.rsplit(',').next().unwrap().parse().expect("a number")
    };
    assert_eq!(value("fit,rank,"), 1.0);
    assert!(value("residual-rms,least-squares,") < 1e-12);
    assert!(value("residual-rms,posterior,") < 1e-3);
    assert!(!text.contains("NaN"));
}

/// Pictures of the shipped velvet, by every way of giving them.
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
    assert!(get(&sphere, "relative-residual", "posterior")[0][0] < 1e-3);

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
            let value = eigenshade_cli::tone::linear(f64::from(*channel) / 255.0);
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
    assert!(far <= tolerances::READ_SIXTEEN_BITS, "{far:e}");
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

/// What would be read without a fault and mean nothing.
#[test]
fn nothing_is_read_from_nothing() {
    let folder = with_image();
    folder.write("black.csv", format!("value\n{}", "0\n".repeat(400)));
    let read = "--normals normals.csv --table b.bin --out new.csv";
    assert_fails(&folder, &format!("read black.csv {read}"), &["black.csv", "black"]);
    let twice = format!("read image.csv {read} --modes-out new.csv");
    assert_fails(&folder, &twice, &["new.csv", "two outputs"]);
    for noise in ["1e300", "1e-300", "0", "nan"] {
        let output = folder.run(&format!("read image.csv {read} --noise {noise}"));
        assert_eq!(output.status.code(), Some(2), "{noise}");
    }
    folder.write("heavy.csv", format!("weight\n{}", "1e300\n".repeat(400)));
    assert_fails(&folder, &format!("read image.csv {read} --mask heavy.csv"), &["heavy.csv:2:"]);
}

/// As many lights and materials as are shipped, but others, and not there any more.
#[test]
fn shipped_databases_stand_in_for_themselves_only() {
    let folder = with_image();
    let shipped = repository().join("tables/inputs");
    fs::copy(shipped.join("materials.csv"), folder.path("materials.csv")).unwrap();
    folder.write("lights.csv", lights(support::DEGREE, 26));
    folder.ok("basis --scene scene.toml --out other.bin");
    fs::remove_file(folder.path("lights.csv")).unwrap();
    let read = "read image.csv --normals normals.csv --table other.bin --components 9";
    assert_fails(&folder, &format!("{read} --out new.csv"), &["other.bin", "--lights"]);
    folder.write("lights.csv", lights(support::DEGREE, 26));
    folder.ok(read);
}

#[test]
fn bad_images() {
    let folder = with_image();
    let good = folder.read("image.csv");
    let tables = repository().join("tables/sphere.bin");
    let table = tables.display();
    let read = "--normals normals.csv --table b.bin --out new.csv";
    for (name, text, words) in [
        ("nan.csv", good.replacen(",material-2,7,", ",material-2,7,nan,", 1), "nan.csv:9:"),
        ("nan2.csv", "value\n1\nnan\n".to_owned(), "nan2.csv:3:"),
        ("inf.csv", "value\n1\ninf\n".to_owned(), "inf.csv:3:"),
        ("header.csv", "red,green,blue\n1,1,1\n".to_owned(), "header.csv:1:"),
        ("short.csv", "value\n1\n2\n".to_owned(), "normals.csv"),
        ("empty.csv", String::new(), "empty.csv"),
        ("picture.png", "no picture".to_owned(), "picture.png"),
        ("picture.exr", "no picture".to_owned(), "picture.exr"),
        ("picture.jpg", "no picture".to_owned(), "picture.jpg"),
    ] {
        folder.write(name, text);
        assert_fails(&folder, &format!("read {name} {read}"), &[words]);
    }
    let grey: Vec<u8> = (0..64u32 * 64).map(|k| (k % 199) as u8).collect();
    let whole = png(64, 64, BitDepth::Eight, ColorType::Grayscale, &grey);
    folder.write("whole.png", &whole);
    let sphere = format!("--normals sphere --table {table} --out new.csv");
    for cut in [8, 20, 33, whole.len() / 2, whole.len() - 20, whole.len() - 1] {
        folder.write("cut.png", &whole[..cut]);
        assert_fails(&folder, &format!("read cut.png {sphere}"), &["cut.png"]);
    }
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 0x10;
    folder.write("flipped.png", flipped);
    assert_fails(&folder, &format!("read flipped.png {sphere}"), &["flipped.png"]);
    // 2^31 - 1 pixels across and down, in 67 bytes.
    let tiny = png(1, 1, BitDepth::Eight, ColorType::Grayscale, &[0]);
    let mut absurd = tiny.clone();
    absurd[16..24].copy_from_slice(&[0x7f, 0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff]);
    let crc = crc(&absurd[12..29]);
    absurd[29..33].copy_from_slice(&crc.to_be_bytes());
    folder.write("absurd.png", absurd);
    assert_fails(&folder, &format!("read absurd.png {sphere}"), &["absurd.png", "2147483647"]);
    folder.write("tiny.png", tiny);
    assert_fails(&folder, &format!("read tiny.png {sphere}"), &["tiny.png", "50 components"]);
}

/// The checksum of PNG chunks, bit by bit.
fn crc(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |mut crc, byte| {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 };
        }
        crc
    })
}

#[test]
fn what_does_not_fit_together() {
    let folder = with_image();
    let grey = |side: usize, value: u8| {
        png(side, side, BitDepth::Eight, ColorType::Grayscale, &vec![value; side * side])
    };
    folder.write("image.png", grey(20, 100));
    folder.write("white.png", grey(20, 255));
    folder.write("small.png", grey(10, 200));
    folder.write("few.csv", format!("weight\n{}{}", "1\n".repeat(10), "0\n".repeat(390)));
    folder.write("none.csv", format!("weight\n{}", "0\n".repeat(400)));
    folder.write("negative.csv", format!("weight\n1\n-1\n{}", "1\n".repeat(398)));
    folder.write("wide.csv", "weight\n1\n");
    let png_read = "read image.png --normals normals.csv --table b.bin";
    for (arguments, words) in [
        (format!("{READ} --mask few.csv"), vec!["image.csv", "10 of its pixels"]),
        (format!("{READ} --mask none.csv"), vec!["image.csv", "0 of its pixels"]),
        (format!("{READ} --mask negative.csv"), vec!["negative.csv:3:"]),
        (format!("{READ} --mask wide.csv"), vec!["wide.csv", "400 pixels"]),
        (format!("{READ} --components 60000"), vec!["b.bin", "60000"]),
        (format!("{READ} --transfer srgb"), vec!["image.csv", "--transfer"]),
        (format!("{READ} --lights none.csv"), vec!["none.csv"]),
        (format!("{READ} --light-out nowhere/l.csv"), vec!["nowhere/l.csv"]),
        ("read image.csv --normals sphere --table b.bin".into(), vec!["--normals"]),
        (format!("{png_read} --mask small.png"), vec!["small.png", "10 x 10"]),
        ("read image.png --normals small.png --table b.bin".into(), vec!["small.png", "10 x 10"]),
        ("read small.png --normals normals.csv --table b.bin".into(), vec!["normals.csv", "100"]),
        (
            "read white.png --normals normals.csv --table b.bin".into(),
            vec!["white.png", "0 of its"],
        ),
        ("read image.csv --normals none2.csv --table b.bin".into(), vec!["none2.csv"]),
    ] {
        assert_fails(&folder, &format!("{arguments} --out new.csv"), &words);
    }
    for (store, arguments) in [("materials", ""), ("projection", "--modes-out m.csv")] {
        let scene = folder.read("scene.toml") + &format!("store = \"{store}\"\n");
        folder.write("kept.toml", scene);
        folder.ok("basis --scene kept.toml --out kept.bin");
        let read = "read image.csv --normals normals.csv --table kept.bin --out new.csv";
        assert_fails(&folder, &format!("{read} {arguments}"), &["kept.bin", "basis.store"]);
    }
    fs::rename(folder.path("lights.csv"), folder.path("elsewhere.csv")).unwrap();
    assert_fails(&folder, READ, &["lights.csv", "--lights"]);
    folder.ok(&format!("{READ} --lights elsewhere.csv"));
}

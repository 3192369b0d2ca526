//! Files as other programs write them: coefficients in their formats, normal maps in their
//! conventions, byte order marks, and pictures that old programs read.

use crate::support::files::{normal_map, obj, png};
use crate::support::{Folder, assert_fails, numbers, rows};
use png::{BitDepth, ColorType};

/// The order of cmgen and three.js, of degree 2.
const COEFFICIENTS: [[f64; 3]; 9] = [
    [0.8, 0.7, 0.6],
    [0.3, 0.35, 0.4],
    [-0.1, -0.12, -0.14],
    [-0.05, -0.04, -0.03],
    [0.02, 0.025, 0.03],
    [0.06, 0.055, 0.05],
    [-0.01, -0.015, -0.02],
    [0.08, 0.075, 0.07],
    [0.04, 0.045, 0.05],
];

fn orders() -> impl Iterator<Item = (i32, i32)> {
    (0..3).flat_map(|degree| (-degree..=degree).map(move |order| (degree, order)))
}

/// The same as a light CSV.
fn csv() -> String {
    let rows = orders().zip(COEFFICIENTS);
    let row = |((l, m), [r, g, b]): ((i32, i32), [f64; 3])| format!("a,{l},{m},{r},{g},{b}\n");
    format!("name,l,m,r,g,b\n{}", rows.map(row).collect::<String>())
}

/// The same as cmgen prints them.
fn cmgen(comment: &str) -> String {
    let rows = orders().zip(COEFFICIENTS);
    let row = |((l, m), [r, g, b]): ((i32, i32), [f64; 3])| {
        format!("({r:18.15}, {g:18.15}, {b:18.15}); // L{l}{m}{comment}\n")
    };
    rows.map(row).collect()
}

/// The same as `LightProbe.toJSON` of three.js.
fn probe(intensity: f64) -> String {
    let numbers: Vec<_> = COEFFICIENTS.as_flattened().iter().map(ToString::to_string).collect();
    format!(
        "{{\"metadata\":{{\"version\":4.6,\"type\":\"Object\"}},\"object\":{{\"type\":\"LightProbe\",\
         \"intensity\":{intensity},\"sh\":[{}]}}}}",
        numbers.join(",")
    )
}

#[test]
fn coefficients_of_other_programs() {
    let folder = Folder::new();
    folder.write("a.csv", csv());
    for (name, text, from) in [
        ("a.txt", cmgen(""), "cmgen"),
        ("a.txt", cmgen(", irradiance"), "cmgen-irradiance"),
        ("a.txt", cmgen(", irradiance, pre-scaled base"), "filament"),
        ("a.txt", format!("\u{feff}{}", cmgen("").replace('\n', "\r\n")), "cmgen"),
        ("a.json", probe(1.0), "graphics"),
        ("a.json", format!("\u{feff}{}", probe(1.0)), "three"),
    ] {
        folder.write(name, text);
        let expected = folder.ok(&format!("light a.csv --from {from}"));
        assert_eq!(folder.ok(&format!("light {name} --from {from}")), expected, "{name}");
        assert_eq!(folder.ok(&format!("light {name}")), expected, "{name}");
    }
    let (bright, message) = {
        folder.write("a.json", probe(2.0));
        folder.both("light a.json --degree 0")
    };
    assert!(message.contains("a.json: its intensity, 2, multiplies the coefficients"), "{message}");
    let values = |text: &str| numbers(&rows(text, "name,l,m,r,g,b"), 3);
    folder.write("a.json", probe(1.0));
    assert_eq!(values(&bright)[0], 2.0 * values(&folder.ok("light a.json --degree 0"))[0]);

    folder.write("a.txt", cmgen(""));
    let first = cmgen("").lines().next().unwrap_or_default().to_owned();
    for (name, text, arguments, what) in [
        ("a.txt", cmgen(""), "--from filament", "--from is filament, and the file is in cmgen"),
        ("a.txt", "hello\n".to_owned(), "", "line 1 is `hello`; give what `cmgen --sh` prints"),
        ("a.txt", cmgen("").replace("L11", "L12"), "", "line 4 is"),
        ("a.txt", format!("{first}\n{first}"), "", "line 2 is"),
        ("a.txt", cmgen("").replacen("L00", "L00, irradiance", 1), "", "line 2 is"),
        ("a.txt", String::new(), "", "it has 0 coefficients"),
        ("a.txt", cmgen(""), "--degree 3", "it has degree 2, but degree 3 is needed"),
        ("a.json", "{}".to_owned(), "", "it is not a LightProbe (missing field `object`"),
        ("a.json", probe(1.0).replace("0.8,", ""), "", "`sh` has 26 numbers"),
    ] {
        folder.write(name, text);
        assert_fails(&folder, &format!("light {name} {arguments}"), &[name, what]);
    }
}

/// A byte order mark in front of any text is no part of it.
#[test]
fn byte_order_marks_are_skipped() {
    let folder = Folder::new();
    folder.write("a.csv", csv());
    folder.write("m.toml", "[[material]]\nname = \"a\"\nmodel = \"lambertian\"\nalbedo = 0.5\n");
    folder.write("o.obj", obj());
    for (name, command) in [
        ("a.csv", "light a.csv --from graphics"),
        ("m.toml", "material m.toml"),
        ("scene.toml", "basis --scene scene.toml --out new.bin"),
        ("materials.csv", "basis --scene scene.toml --out new.bin"),
        ("o.obj", "pack-object o.obj --size 16 --out o.bin"),
        (
            "normals.csv",
            "shade --light a.csv --material materials.csv:material-0 --normals normals.csv",
        ),
    ] {
        // What a command prints about a file that it writes has the time that it took.
        let made = |folder: &Folder| {
            let text = folder.ok(command);
            let file = ["new.bin", "o.bin"].into_iter().find(|file| command.ends_with(file));
            file.map_or(text.into_bytes(), |file| folder.bytes(file))
        };
        let plain = folder.bytes(name);
        let expected = made(&folder);
        folder.write(name, [b"\xef\xbb\xbf", &plain[..]].concat());
        assert!(made(&folder) == expected, "{name}");
        folder.write(name, &plain);
    }
    let utf_16: Vec<u8> = "\u{feff}name".encode_utf16().flat_map(u16::to_le_bytes).collect();
    folder.write("a.csv", utf_16);
    assert_fails(
        &folder,
        "light a.csv --from graphics",
        &["a.csv", "UTF-16 text; save it as a UTF-8"],
    );
}

/// The map of a sphere, changed.
fn changed(change: impl Fn(&mut [u8])) -> Vec<u8> {
    let decoder = png::Decoder::new(std::io::Cursor::new(normal_map(BitDepth::Eight)));
    let mut reader = decoder.read_info().expect("a map");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    let frame = reader.next_frame(&mut pixels).expect("a picture");
    let channels = frame.color_type.samples();
    pixels.chunks_exact_mut(channels).for_each(change);
    png([frame.width, frame.height], BitDepth::Eight, frame.color_type, &pixels)
}

/// Whether a pixel shows the sphere.
fn is_of_sphere(pixel: &[u8]) -> bool {
    pixel[0] != pixel[1] || pixel[1] != pixel[2]
}

#[test]
fn normal_maps_of_other_conventions() {
    let folder = Folder::new();
    folder.write("n.png", normal_map(BitDepth::Eight));
    let packed = |arguments: &str| {
        let (_, messages) = folder.both(&format!("pack-object {arguments} --out n.bin"));
        (folder.bytes("n.bin"), messages)
    };
    let (expected, messages) = packed("n.png");
    assert_eq!(messages, "");
    folder.write("dx.png", changed(|pixel| pixel[1] = 255 - pixel[1]));
    let (flipped, messages) = packed("dx.png --flip-green");
    assert_eq!((&flipped, messages.as_str()), (&expected, ""));
    for command in
        ["pack-object dx.png --out n.bin", "render -l lobby -m chrome -n dx.png -s 32 -o r.png"]
    {
        let messages = folder.messages(command);
        let expected = "warning: dx.png: it fits a surface only if green points down, as in \
                        DirectX: give --flip-green, or flip its green channel";
        assert!(messages.contains(expected), "{messages}");
        let messages = folder.messages(&command.replace("dx.png", "dx.png --flip-green"));
        assert!(!messages.contains("green"), "{messages}");
    }
    let (_, messages) = packed("n.png --flip-green");
    assert!(messages.contains("only without --flip-green"), "{messages}");
    for arguments in ["sphere --flip-green", "o.obj --flip-green"] {
        folder.write("o.obj", obj());
        let command = format!("pack-object {arguments} --out new.bin");
        assert_fails(&folder, &command, &["--flip-green is for a normal map"]);
    }

    // Two channels, with any constant for the third: within a step of 16 bits at the rim.
    for blue in [255, 0, 128] {
        folder.write(
            "rg.png",
            changed(|pixel| pixel[2] = if is_of_sphere(pixel) { blue } else { pixel[2] }),
        );
        let (found, messages) = packed("rg.png");
        let what = "rg.png: blue is the same in all of its pixels: z follows from x and y";
        assert!(messages.contains(what), "{messages}");
        let differs = found.iter().zip(&expected).filter(|(a, b)| a.abs_diff(**b) > 8).count();
        assert!(differs < expected.len() / 20, "{differs} of {}", expected.len());
    }
    // Vectors that are too long are normalized, but not silently.
    folder.write("long.png", changed(|pixel| pixel[2] = pixel[2].saturating_add(60)));
    let (_, messages) = packed("long.png");
    assert!(
        messages.contains("% of its vectors are longer or shorter than 1 by more"),
        "{messages}"
    );
    // A flat map and a cone have one blue, and are right.
    let flat = png([8, 8], BitDepth::Eight, ColorType::Rgb, &[128, 128, 255].repeat(64));
    folder.write("flat.png", flat);
    assert_eq!(packed("flat.png").1, "");
}

/// OpenEXR as old programs read it: scan lines from the top, in ZIP.
#[test]
fn pictures_are_scan_lines_in_zip() {
    let folder = Folder::new();
    for arguments in ["-s 100", "--matcap -s 70"] {
        folder.ok(&format!("render -l lobby -m chrome {arguments} -o r.exr"));
        let file = exr::meta::MetaData::read_from_file(folder.path("r.exr"), true).expect("a file");
        let header = &file.headers[0];
        assert_eq!(header.blocks, exr::meta::BlockDescription::ScanLines);
        assert_eq!(header.line_order, exr::meta::attribute::LineOrder::Increasing);
        assert_eq!(header.compression, exr::compression::Compression::ZIP16);
    }
}

/// What a map states is said on standard error, once.
#[test]
fn warnings_about_maps_are_printed() {
    let folder = Folder::new();
    let header = "#?RADIANCE\nEXPOSURE=2\nCOLORCORR=1 1 2\n\n-Y 2 +X 4\n".as_bytes();
    folder.write("m.hdr", [header, &[128, 128, 128, 129].repeat(8), b"tail"].concat());
    let (text, messages) = folder.both("light m.hdr --degree 0");
    for what in ["EXPOSURE, 2, is not divided", "COLORCORR, 1 1 2, is divided", "bytes after its"] {
        let line = format!("warning: m.hdr: {}", if what.starts_with('b') { "" } else { "its " });
        assert_eq!(messages.matches(&format!("{line}{what}")).count(), 1, "{messages}");
    }
    // 128.5 / 128 of the root of 4 pi.
    assert!(text.contains("m,0,0,3.5587"), "{text}");
    assert_eq!(folder.messages("light m.hdr --degree 0 --quiet"), "");
}

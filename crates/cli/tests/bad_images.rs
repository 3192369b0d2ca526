//! `eigenshade read`: images, masks, normals and tables that are refused.

use crate::support::files::{READ, answer, claims, get, gray_png, nearest, with_image};
use crate::support::{
    BASIS, DEGREE, assert_fails, assert_usage_errors, lights, scene, shipped_path,
};
use std::fs;

/// Inputs that would give a meaningless answer.
#[test]
fn meaningless_inputs_are_refused() {
    let folder = with_image();
    folder.write("black.csv", format!("value\n{}", "0\n".repeat(400)));
    let read = "--normals normals.csv --table b.bin --out new.csv";
    assert_fails(&folder, &format!("read black.csv {read}"), &["black.csv", "black"]);
    let twice = format!("read image.csv {read} --modes-out new.csv");
    assert_fails(&folder, &twice, &["new.csv", "two outputs"]);
    for noise in ["1e300", "1e-300", "0", "nan"] {
        assert_usage_errors(&folder, &[&format!("read image.csv {read} --noise {noise}")]);
    }
    folder.write("heavy.csv", format!("weight\n{}", "1e300\n".repeat(400)));
    assert_fails(&folder, &format!("read image.csv {read} --mask heavy.csv"), &["heavy.csv:2:"]);
}

/// A material that reflects nothing: alone it is refused, among others it is the least likely.
#[test]
fn black_materials() {
    let folder = with_image();
    let all = folder.read("materials.csv");
    let first = all.lines().filter_map(|line| line.strip_prefix("material-0"));
    let zeros: String =
        first.map(|line| format!("soot{},0\n", line.rsplit_once(',').unwrap().0)).collect();
    let soot = format!("name,o,p,q,value\n{zeros}");
    folder.write("soot.csv", &soot);
    let read = "read image.csv --normals normals.csv --out new.csv";
    for criterion in ["image-centered", "standard"] {
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        folder.write("materials.csv", &soot);
        folder.ok("basis --scene scene.toml --out night.bin");
        assert_fails(&folder, &format!("{read} --table night.bin"), &["night.bin", "black"]);
        folder.write("materials.csv", &all);
        folder.ok(BASIS);
        let with_soot = format!("{read} --table b.bin --material soot.csv");
        assert_fails(&folder, &with_soot, &["b.bin", "black", "--material"]);
    }
    folder.write("both.csv", format!("{all}{zeros}"));
    let found = answer(&folder.ok(&format!("{READ} --material both.csv")));
    assert_eq!(nearest(&found), "material-2");
    assert_eq!(get(&found, "material-evidence", "soot")[0][0], 4.0);
}

/// Missing databases with as many lights and materials as the shipped ones, but other ones.
#[test]
fn shipped_databases_replace_only_themselves() {
    let folder = with_image();
    fs::copy(shipped_path("inputs/materials.csv"), folder.path("materials.csv")).unwrap();
    folder.write("lights.csv", lights(DEGREE, 26));
    folder.ok("basis --scene scene.toml --out other.bin");
    fs::remove_file(folder.path("lights.csv")).unwrap();
    let read = "read image.csv --normals normals.csv --table other.bin --components 9";
    assert_fails(&folder, &format!("{read} --out new.csv"), &["other.bin", "--light"]);
    folder.write("lights.csv", lights(DEGREE, 26));
    folder.ok(read);
}

/// If one of three outputs cannot be written, the others are not written either.
#[test]
fn all_outputs_or_none() {
    let folder = with_image();
    fs::create_dir(folder.path("taken")).unwrap();
    folder.write("old.csv", "old");
    let places = [("out", "a.csv"), ("light-out", "old.csv"), ("modes-out", "c.csv")];
    for bad in [
        "none/new.csv",
        "taken",
        #[cfg(target_os = "linux")]
        "/dev/full",
    ] {
        for broken in 0..places.len() {
            let options = places.iter().enumerate().map(|(place, (option, file))| {
                format!(" --{option} {}", if place == broken { bad } else { file })
            });
            let arguments = format!("{READ}{}", options.collect::<String>());
            assert_fails(&folder, &arguments, &[bad]);
            assert_eq!(folder.read("old.csv"), "old", "{arguments}");
        }
    }
}

#[test]
fn bad_images() {
    let folder = with_image();
    let good = folder.read("image.csv");
    let read = "--normals normals.csv --table b.bin --out new.csv";
    for (name, text, fragments) in [
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
        assert_fails(&folder, &format!("read {name} {read}"), &[fragments]);
    }
    let gray: Vec<u8> = (0..64u32 * 64).map(|k| (k % 199) as u8).collect();
    let whole = gray_png(64, 64, &gray);
    let sphere = "--normals sphere --table curet --out new.csv";
    for cut in [8, 20, 33, whole.len() / 2, whole.len() - 20, whole.len() - 1] {
        folder.write("cut.png", &whole[..cut]);
        assert_fails(&folder, &format!("read cut.png {sphere}"), &["cut.png"]);
    }
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 0x10;
    folder.write("flipped.png", flipped);
    assert_fails(&folder, &format!("read flipped.png {sphere}"), &["flipped.png"]);
    // 2^31 - 1 pixels across and down, in 67 bytes.
    let tiny = gray_png(1, 1, &[0]);
    folder.write("absurd.png", claims(tiny.clone(), u32::MAX >> 1, u32::MAX >> 1));
    assert_fails(&folder, &format!("read absurd.png {sphere}"), &["absurd.png", "2147483647"]);
    folder.write("tiny.png", tiny);
    assert_fails(&folder, &format!("read tiny.png {sphere}"), &["tiny.png", "50 components"]);
}

#[test]
fn inputs_that_do_not_match() {
    let folder = with_image();
    folder.write("image.png", gray_png(20, 20, &[100; 400]));
    folder.write("white.png", gray_png(20, 20, &[255; 400]));
    folder.write("small.png", gray_png(10, 10, &[200; 100]));
    folder.write("few.csv", format!("weight\n{}{}", "1\n".repeat(10), "0\n".repeat(390)));
    folder.write("none.csv", format!("weight\n{}", "0\n".repeat(400)));
    folder.write("negative.csv", format!("weight\n1\n-1\n{}", "1\n".repeat(398)));
    folder.write("wide.csv", "weight\n1\n");
    folder.write("mesh.obj", "mtllib s.mtl\n");
    let read = |image: &str, rest: &str| format!("read {image} --table b.bin --normals {rest}");
    for (arguments, fragments) in [
        (format!("{READ} --mask few.csv"), &["image.csv", "10 of its pixels"][..]),
        (format!("{READ} --mask none.csv"), &["image.csv", "0 of its pixels"]),
        (format!("{READ} --mask negative.csv"), &["negative.csv:3:"]),
        (format!("{READ} --mask wide.csv"), &["wide.csv", "400 pixels"]),
        (format!("{READ} --components 60000"), &["b.bin", "60000"]),
        (format!("{READ} --transfer srgb"), &["image.csv", "--transfer"]),
        (format!("{READ} --light none.csv"), &["none.csv"]),
        (format!("{READ} --light-out nowhere/l.csv"), &["nowhere/l.csv"]),
        (read("image.csv", "sphere"), &["--normals"]),
        (read("image.png", "normals.csv --mask small.png"), &["small.png", "10 x 10"]),
        (read("image.png", "small.png"), &["small.png", "10 x 10"]),
        (read("small.png", "normals.csv"), &["normals.csv", "100"]),
        (read("white.png", "normals.csv"), &["white.png", "0 of its"]),
        (read("image.csv", "none2.csv"), &["none2.csv"]),
        (read("image.csv", "mesh.obj"), &["mesh.obj: it is a mesh", "with `render`"]),
    ] {
        assert_fails(&folder, &format!("{arguments} --out new.csv"), fragments);
    }
    for (store, arguments) in [("materials", ""), ("projection", "--modes-out m.csv")] {
        let store = format!("store = \"{store}\"\n");
        folder.write("kept.toml", folder.read("scene.toml") + &store);
        folder.ok("basis --scene kept.toml --out kept.bin");
        let read = "read image.csv --normals normals.csv --table kept.bin --out new.csv";
        assert_fails(&folder, &format!("{read} {arguments}"), &["kept.bin", "basis.store"]);
    }
    fs::rename(folder.path("lights.csv"), folder.path("elsewhere.csv")).unwrap();
    assert_fails(&folder, READ, &["lights.csv", "--light"]);
    folder.ok(&format!("{READ} --light elsewhere.csv"));
}

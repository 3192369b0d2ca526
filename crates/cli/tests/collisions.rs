//! Outputs that would replace one another or an input: refused, and every file is as it was.

use crate::support::reading::with_image;
use crate::support::{Folder, assert_fails};
use std::collections::BTreeMap;
use std::fs;

/// The bytes of all files.
fn contents(folder: &Folder) -> BTreeMap<String, Vec<u8>> {
    let names = folder.names().into_iter().filter(|name| folder.path(name).is_file());
    names.map(|name| (name.clone(), fs::read(folder.path(&name)).expect("a file"))).collect()
}

/// A folder in which every command has what it reads.
fn with_everything() -> Folder {
    let folder = with_image();
    let measured = "theta_i,phi_i,theta_r,phi_r,value\n0.1,0,0.2,0,1\n0.3,1,0.2,0,1\n";
    folder.write("m.csv", measured);
    folder.write(
        "matte.toml",
        "[[material]]\nname = \"matte\"\nmodel = \"lambertian\"\nalbedo = 1\n",
    );
    let texels = [1.0f32; 3 * 4 * 2].iter().flat_map(|value| value.to_le_bytes());
    let map: Vec<u8> = b"PF\n4 2\n-1.0\n".iter().copied().chain(texels).collect();
    folder.write("map.pfm", &map);
    fs::create_dir(folder.path("maps")).expect("a folder");
    folder.write("maps/other.pfm", &map);
    folder.write("points.csv", "o,q,rho\n2,0,0.5\n");
    folder.write("mask.csv", format!("weight\n{}", "1\n".repeat(400)));
    folder.write("s.manifest.csv", folder.read("scene.toml"));
    folder
}

const READ: &str = "read image.csv --normals normals.csv --mask mask.csv --table b.bin";

#[test]
fn two_outputs_in_one_file() {
    let folder = with_everything();
    fs::create_dir(folder.path("sub")).expect("a folder");
    #[cfg(unix)]
    for (to, link) in [("new.csv", "dangling.csv"), ("light.csv", "linked.csv"), (".", "here")] {
        std::os::unix::fs::symlink(to, folder.path(link)).expect("a link");
    }
    let before = contents(&folder);
    for (arguments, place) in [
        ("material m.csv --order 0 --out new.csv --report new.csv".to_owned(), "new.csv"),
        ("material m.csv --order 0 --out new.csv --report sub/../new.csv".to_owned(), "new.csv"),
        (format!("{READ} --out new.csv --light-out ./new.csv"), "./new.csv"),
        (format!("{READ} --out new.csv --modes-out new.csv"), "new.csv"),
        (format!("{READ} --light-out sub/new.csv --modes-out ./sub/new.csv"), "./sub/new.csv"),
        #[cfg(unix)]
        (format!("{READ} --out new.csv --light-out here/new.csv"), "here/new.csv"),
        #[cfg(unix)]
        (format!("{READ} --out new.csv --light-out dangling.csv"), "dangling.csv"),
    ] {
        assert_fails(&folder, &arguments, &[place, "two outputs go there", "its own file"]);
        assert!(contents(&folder) == before, "{arguments}");
    }
    // A link to an input is the input.
    #[cfg(unix)]
    {
        let linked = format!("{READ} --lights light.csv --materials material.csv --out linked.csv");
        assert_fails(&folder, &linked, &["linked.csv", "`light.csv`", "another name"]);
        assert!(contents(&folder) == before);
    }
}

#[test]
fn an_input_as_output() {
    let folder = with_everything();
    let before = contents(&folder);
    let pair = "--lights light.csv --materials material.csv";
    let render = "render b.bin --light light.csv:light-0 --material material.csv --size 4";
    let read = format!("{READ} {pair}");
    let inputs = |command: &str, inputs: &[&str]| -> Vec<(String, String)> {
        let row = |input: &&str| (format!("{command} --out ./{input}"), (*input).to_owned());
        inputs.iter().map(row).collect()
    };
    let mut rows = [
        inputs(&format!("project b.bin {pair}"), &["b.bin", "light.csv", "material.csv"]),
        inputs(&format!("shade b.bin {pair} --normals normals.csv"), &["b.bin", "normals.csv"]),
        inputs("pack b.bin", &["b.bin"]),
        inputs("eigenvalues b.bin", &["b.bin"]),
        inputs("evaluate zernike-radial points.csv", &["points.csv"]),
        inputs(render, &["b.bin", "light.csv", "material.csv"]),
        inputs("light light.csv --degree 4", &["light.csv"]),
        inputs("light map.pfm maps --degree 4", &["map.pfm", "maps/other.pfm"]),
        inputs("material m.csv matte.toml --order 0", &["m.csv", "matte.toml"]),
        inputs("basis --scene scene.toml", &["scene.toml", "lights.csv", "materials.csv"]),
        inputs(&read, &["image.csv", "normals.csv", "mask.csv", "b.bin", "light.csv"]),
        inputs(READ, &["lights.csv", "materials.csv"]),
    ]
    .concat();
    for (arguments, input) in [
        ("material m.csv --order 0 --out new.csv --report ./m.csv", "m.csv"),
        ("basis --scene s.manifest.csv --out s.bin", "s.manifest.csv"),
        (&format!("{READ} --out new.csv --light-out ./image.csv"), "image.csv"),
        (&format!("{READ} --out new.csv --modes-out ./b.bin"), "b.bin"),
    ] {
        rows.push((arguments.to_owned(), input.to_owned()));
    }
    for (arguments, input) in rows {
        assert_fails(&folder, &arguments, &[&input, "would replace the input", "another name"]);
        assert!(contents(&folder) == before, "{arguments}");
    }
    assert_eq!(fs::read(folder.path("maps/other.pfm")).unwrap(), before["map.pfm"]);
}

/// What looks like a collision and is none.
#[test]
fn files_of_their_own() {
    let folder = with_everything();
    folder.ok(&format!("{READ} --out sphere --light-out new.csv --modes-out maps/new.csv"));
    // Again: what was written is no input.
    folder.ok(&format!("{READ} --out sphere --light-out new.csv --modes-out maps/new.csv"));
    folder.ok("light maps --degree 2 --out maps/lights.csv");
    folder.ok("light maps --degree 2 --out maps/lights.csv");
    #[cfg(unix)]
    folder.ok(&format!("{READ} --out /dev/null --light-out /dev/null"));
}

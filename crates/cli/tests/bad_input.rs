//! Bad input: exit status 1, one line that names the file, and nothing written.

use crate::support::files::{map, with_geometry};
use crate::support::{
    BASIS, DEGREE, Folder, NEW_BASIS, ORDER, PAIR, SHADE, assert_contains, assert_fails, lights,
    materials, scene, stderr,
};
use eigenshade_testing::fixtures;
use std::fs;

#[test]
fn missing_files() {
    let folder = Folder::with_table();
    let shade = SHADE.replace("normals.csv", "none.csv");
    for (arguments, file) in [
        ("info --table none.bin", "none.bin"),
        ("eigenvalues --table none.bin", "none.bin"),
        ("basis --scene none.toml --out new.bin", "none.toml"),
        ("basis --scene scene.toml --check none.bin", "none.bin"),
        ("light none.exr --degree 2 --out new.csv", "none.exr"),
        ("light none.csv --degree 2 --out new.csv", "none.csv"),
        ("material none --order 2 --out new.csv", "none"),
        ("project -t b.bin --light none.csv --material materials.csv --out new.csv", "none.csv"),
        ("project -t b.bin --light lights.csv --material none.csv --out new.csv", "none.csv"),
        ("evaluate wigner-d none.csv --out new.csv", "none.csv"),
        ("render -t b.bin --light none.csv:a --material materials.csv --out new.png", "none.csv"),
        (&format!("{shade} --out new.csv"), "none.csv"),
    ] {
        assert_fails(&folder, arguments, &[file]);
    }
    // A scene that was copied without its databases.
    fs::create_dir(folder.path("copied")).unwrap();
    let place = folder.path("copied").canonicalize().unwrap().display().to_string();
    let object = with_geometry("normals = \"none.png\"\nmask = \"mask.png\"\n");
    folder.write("copied/scene.toml", object);
    for file in ["lights.csv", "materials.csv", "none.png", "mask.png"] {
        let fragments = ["copied/scene.toml: ", &format!("`{file}`"), &place, "copy the file"];
        assert_fails(&folder, &NEW_BASIS.replace("scene.toml", "copied/scene.toml"), &fragments);
        folder.write(&format!("copied/{file}"), "");
    }
}

/// A word that is no file and no shipped name: similar names are offered.
#[test]
fn names_of_nothing_shipped() {
    let folder = Folder::with_table();
    let render = |light: &str, material: &str| {
        format!("render --light {light} --material {material} --out new.png")
    };
    let components = format!("{} --components 9999", render("park", "chrome"));
    for (arguments, fragments) in [
        (render("parc", "07-velvet"), &["`parc`", "shipped light", "`park`"][..]),
        (render("park", "velvet"), &["`velvet`", "`07-velvet`", "list"]),
        (render("xyzzy", "07-velvet"), &["`xyzzy`", "use a name", "list"]),
        (render("park.csv", "07-velvet"), &["park.csv"]),
        (render("park", "gold-paint"), &["`gold-paint`", "`gold-metallic-paint2`"]),
        (components, &["sphere: it has 46 components"]),
        (SHADE.replace("lights.csv", "cities"), &["`cities`", "`city`"]),
    ] {
        assert_fails(&folder, &arguments, fragments);
    }
}

/// Several commands refuse a bad light; the reader's own tests have every fault.
#[test]
fn faults_of_lights() {
    let folder = Folder::with_table();
    folder.write("lights.csv", lights(DEGREE, 3) + "light-1,2,-1,1,1,1\n");
    folder.write("old.csv", "old");
    for arguments in [
        "light lights.csv --degree 4 --out old.csv".to_owned(),
        format!("project --table b.bin {PAIR} --out old.csv"),
        NEW_BASIS.to_owned(),
        format!("{SHADE} --out old.csv"),
    ] {
        assert_fails(&folder, &arguments, &["light-1", "lights.csv:77:"]);
    }
    assert_eq!(folder.read("old.csv"), "old");
    folder.write("m.csv", "theta_i,phi_i,theta_r,phi_r,value,b\n1,1,1,1,1,1\n");
    let material = "material m.csv --order 2 --out new.csv";
    assert_fails(&folder, material, &["m.csv:1:", "`value` and `b`"]);
}

/// The best coefficients of a lower order are not the first ones of a higher order.
#[test]
fn materials_of_a_higher_order_are_a_warning() {
    let folder = Folder::with_table();
    folder.write("high.csv", materials(ORDER + 2, 1));
    let fragments = [
        "warning: high.csv: its materials have order 5, the table order 3",
        "not the projection to order 3",
        "`eigenshade material --order 3`",
    ];
    let project = "project -t b.bin --light lights.csv --out d.csv --material";
    for arguments in [
        "render -t b.bin --light lights.csv:light-0 --material high.csv --size 8 --out p.png",
        &format!("{project} high.csv"),
        &SHADE.replace("materials.csv", "high.csv"),
    ] {
        let message = folder.notes(arguments);
        assert_eq!(message.lines().count(), 1, "{arguments}: {message}");
        assert_contains(&message, &fragments);
    }
    assert_eq!(folder.messages(&format!("{project} materials.csv")), "");
    folder.replace("scene.toml", "materials.csv", "high.csv");
    assert!(folder.messages(BASIS).contains(fragments[0]));
}

#[test]
fn maps_of_another_length_or_byte_order() {
    let folder = Folder::new();
    let rgbe = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x01\x02\x03\x80\x01\x02\x03\x80";
    folder.write("map.hdr", rgbe);
    folder.ok("light map.hdr --degree 0 --out l.csv");
    folder.write("map.hdr", &rgbe[..rgbe.len() - 1]);
    assert_fails(&folder, "light map.hdr --degree 0 --out new.csv", &["map.hdr", "row 0"]);
    for scale in ["0", "-0.0", "nan", "inf"] {
        let text = format!("Pf\n2 1\n{scale}\n");
        folder.write("map.pfm", [text.as_bytes(), &[0; 8]].concat());
        assert_fails(&folder, "light map.pfm --degree 0 --out new.csv", &["map.pfm", "byte order"]);
    }
}

#[test]
fn more_than_the_file_holds() {
    let folder = Folder::new();
    assert_fails(&folder, "light lights.csv --degree 5 --out new.csv", &["lights.csv", "degree 4"]);
    folder.write("lights.csv", lights(3, 2));
    assert_fails(&folder, NEW_BASIS, &["lights.csv", "degree 3"]);
    folder.write("lights.csv", lights(4, 2));
    folder.write("materials.csv", materials(2, 2));
    assert_fails(&folder, NEW_BASIS, &["materials.csv", "order 2"]);
}

#[test]
fn no_materials() {
    let folder = Folder::with_table();
    folder.write("materials.csv", "name,o,p,q,value\n");
    for arguments in [
        NEW_BASIS,
        &format!("project --table b.bin {PAIR} --out new.csv"),
        "render -t b.bin --light lights.csv:light-0 --material materials.csv --out new.png",
    ] {
        assert_fails(&folder, arguments, &["materials.csv"]);
    }
}

/// Names that there are not, and files of several entries where one is drawn.
#[test]
fn unknown_names() {
    let folder = Folder::with_table();
    for (name, fragments) in
        [("velvet", &["materials.csv", "velvet"][..]), ("matrial-1", &["`material-1`"])]
    {
        folder.write("scene.toml", scene("standard", 5, &format!("[\"{name}\"]")));
        assert_fails(&folder, NEW_BASIS, fragments);
    }
    folder.write("m.toml", "[[material]]\nname = \"a\"\nmodel = \"lambertian\"\nalbedo = 1\n");
    let names = "material-0, material-1, material-2, material-3";
    let near = "materials.csv: it has no material `matrial-1`";
    for (pair, fragments) in [
        ("-l lobby -m materials.csv:velvet", &["materials.csv", "velvet", "its names are "][..]),
        ("-l lobby -m materials.csv:matrial-1", &[near, "`material-1`"]),
        ("-l lobby -m materials.csv:", &["no material ``", "`material-0`, `material-1`"]),
        ("-l lobby -m materials.csv", &["materials.csv", "has 4 entries", names]),
        ("-l lobby -m m.toml", &["formulas", "eigenshade material"]),
        ("-l lights.csv -m materials.csv", &["lights.csv", "light-0"]),
    ] {
        assert_fails(&folder, &format!("render -t b.bin {pair} -o new.png"), fragments);
    }
    assert_fails(&folder, "info --table spere", &["`spere`", "shipped table", "`sphere`"]);
}

#[test]
fn bad_scenes() {
    let folder = Folder::new();
    let good = folder.read("scene.toml");
    for (bad, fragment) in [
        (good.replace("criterion", "criteria"), "criteria"),
        (format!("{good}color = 7\n"), "color"),
        (good.replace("degree = 4", "degree = -4"), "scene.toml:4:"),
        (good.replace("[light]", "[light"), "scene.toml:3:"),
        (good.replace("10000", "0"), "components"),
        (good.replace("components = 10000\n", ""), "tolerance"),
        (good.replace("profile_tolerance = 1e-12", "tolerance = 1e-3"), "not both"),
        (good.replace("1e-12", "0.0"), "profile_tolerance"),
        (good.replace("profile_tolerance = 1e-12", "trim = 1.0"), "basis.trim"),
        (good.replace("profile_tolerance = 1e-12", "rows = 1"), "rows"),
        (good.replace("\"any\"", "\"sideways\""), "sideways"),
        (good.replace("[]", "[\"material-0\", \"material-0\"]"), "material-0"),
    ] {
        folder.write("scene.toml", bad);
        assert_fails(&folder, NEW_BASIS, &["scene.toml", fragment]);
    }
}

#[test]
fn damaged_and_foreign_tables() {
    let folder = Folder::with_table();
    let good = folder.bytes("b.bin");
    let mut flipped = good.clone();
    flipped[good.len() / 2] ^= 0x10;
    let cases: [(&str, &[u8], &str); 4] = [
        ("flipped.bin", &flipped, "corrupt table: wrong checksum"),
        ("cut.bin", &good[..good.len() - 100], "corrupt table"),
        ("foreign.bin", b"\x89PNG\r\n\x1a\n, or whatever else begins a file", "not an eigenshade"),
        ("empty.bin", b"", "not an eigenshade"),
    ];
    folder.write("old.csv", "old");
    for (name, bytes, fragment) in cases {
        folder.write(name, bytes);
        let fragments = [name, fragment, "eigenshade basis"];
        for arguments in [
            format!("info --table {name}"),
            format!("eigenvalues --table {name} --out old.csv"),
            format!("project --table {name} {PAIR} --out old.csv"),
            format!("{} --out old.csv", SHADE.replace("b.bin", name)),
            format!("basis --scene scene.toml --check {name}"),
        ] {
            assert_fails(&folder, &arguments, &fragments);
        }
    }
    assert_eq!(folder.read("old.csv"), "old");
}

#[test]
fn outputs_that_cannot_be() {
    let folder = Folder::with_table();
    for place in ["nowhere/new.csv", "lights.csv/new.csv", "."] {
        for arguments in [
            "light lights.csv --degree 2",
            "eigenvalues --table b.bin",
            &format!("project --table b.bin {PAIR}"),
            "basis --scene scene.toml",
            "render --table b.bin --light lights.csv:light-0 --material materials.csv:material-0",
        ] {
            assert_fails(&folder, &format!("{arguments} --out {place}"), &[place]);
        }
    }
    assert_fails(&folder, "demo --size 16 --out lights.csv/demo", &["lights.csv/demo"]);
    assert_fails(&folder, "demo --size 16 --out lights.csv", &["lights.csv", "mixed up"]);
    #[cfg(target_os = "linux")]
    assert_fails(&folder, "eigenvalues --table b.bin --out /proc/new.csv", &["/proc/new.csv"]);
}

#[test]
fn more_components_than_there_are() {
    let folder = Folder::with_table();
    for command in [SHADE, &format!("project --table b.bin {PAIR}")] {
        let arguments = format!("{command} --components 60000 --out new.csv");
        assert_fails(&folder, &arguments, &["b.bin", "60000"]);
    }
    let modes = format!("{SHADE} --method modes --format f32 --out new.csv");
    assert_fails(&folder, &modes, &["modes", "f64"]);
}

#[test]
fn indices_out_of_range() {
    let folder = Folder::new();
    for (function, header, row) in [
        ("spherical-harmonic", "l,m,theta,phi", "2,3,0,0"),
        ("spherical-harmonic", "l,m,theta,phi", "-1,0,0,0"),
        ("spherical-harmonic", "l,m,theta,phi", "65,0,0,0"),
        ("spherical-harmonic", "l,m,theta,phi", "1,0,4,0"),
        ("wigner-d", "l,m,n,alpha", "2,0,-3,0"),
        ("wigner-d", "l,m,n,alpha", "2,0,0.5,0"),
        ("zernike-radial", "o,q,rho", "2,1,0.5"),
        ("zernike-radial", "o,q,rho", "2,4,0.5"),
        ("zernike-radial", "o,q,rho", "2,0,1.5"),
        ("polar-integral", "l,o,q", "1,2,2"),
        ("irradiance-mode", "l,m,o,p,q,alpha,beta", "1,0,2,1,0,0,0"),
        ("irradiance-mode", "l,m,o,p,q,alpha,beta", "1,0,2,0,0,nan,0"),
        ("irradiance-mode", "l,m,p,q,alpha,beta", "1,0,0,0,0,0"),
    ] {
        folder.write("p.csv", format!("# points\n{header}\n\n{row}\n"));
        let line = if header.contains(",m,p") { "p.csv:2:" } else { "p.csv:4:" };
        assert_fails(&folder, &format!("evaluate {function} p.csv --out new.csv"), &[line]);
    }
}

#[test]
fn messages_stay_one_line() {
    let folder = Folder::with_table();
    folder.write("lights.csv", "name,l,m,\"r\nr\",g,b\n");
    let arguments = format!("project --table b.bin {PAIR} --out new.csv");
    assert_fails(&folder, &arguments, &["lights.csv"]);
    folder.write("materials.csv", materials(3, 1).replace("material-0,1,", "material-0,one,"));
    assert_fails(&folder, NEW_BASIS, &["csv"]);
}

/// The maps and the output are checked before the search, which takes long, and sources are not
/// left without their light.
#[test]
fn sources_are_not_sought_in_vain() {
    let folder = Folder::new();
    folder.write("map.pfm", map(1.0));
    folder.write("cross.pfm", fixtures::pfm(4, &[[1.0; 3]; 12]));
    fs::create_dir(folder.path("taken.csv")).unwrap();
    let names = folder.names();
    for (arguments, error) in [
        ("--out nowhere/new.csv", "nowhere/new.csv: "),
        ("--out taken.csv", "taken.csv: "),
        ("cross.pfm --out new.csv", "cross.pfm: sources are not found in cubes"),
    ] {
        let output = folder.run(&format!("light map.pfm {arguments} --sources 1"));
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        let read_first = format!("map: 8 x 4, no negative radiance\nerror: {error}");
        assert!(said.starts_with(&read_first), "{said}");
        assert_eq!(folder.names(), names, "{arguments}");
    }
}

/// Shipped lights are converted one by one. Lights with sources are read in `paper`, and only from
/// files that end in .csv.
#[test]
fn lights_that_would_be_misread() {
    let folder = Folder::new();
    folder.write("map.pfm", map(1.0));
    for command in ["light lobby park", "light map.pfm lobby"] {
        assert_fails(&folder, command, &["lobby: it is a shipped light", "one light at a time"]);
    }
    let light = "light map.pfm --sources 1 --out";
    for convention in ["graphics", "cmgen", "filament"] {
        let arguments = format!("{light} new.csv --convention {convention} --degree 2");
        assert_fails(&folder, &arguments, &["`paper`", "leave --convention out"]);
    }
    assert_fails(&folder, &format!("{light} new.txt"), &["ends in .csv"]);
    folder.write("lights.txt", folder.read("lights.csv"));
    folder.write("lights.sources.csv", "");
    let drawn = "render -l lights.txt:light-0 -m nylon --sources 4 -o a.png";
    assert_fails(&folder, drawn, &["lights.txt: only a file whose name ends in .csv has sources"]);
}

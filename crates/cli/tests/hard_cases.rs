//! Hard cases of maps, coefficients and normals, through the command line.

use crate::support::{
    Folder, PAIR, SHADED, assert_fails, difference, lights, materials, numbers, rows, scene,
};
use crate::tolerances;
use std::f64::consts::PI;

/// An uncompressed gray OpenEXR map of half floats, given by their bits, row by row.
fn half_map(width: u32, height: u32, texels: &[u16]) -> Vec<u8> {
    let mut file = vec![0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        file.extend([name.as_bytes(), b"\0", kind.as_bytes(), b"\0"].concat());
        file.extend((value.len() as u32).to_le_bytes());
        file.extend(value);
    };
    let channel = |name: u8| {
        let ones = [1u32.to_le_bytes(), 1u32.to_le_bytes()].concat();
        [&[name, 0][..], &1u32.to_le_bytes(), &[0; 4], &ones].concat()
    };
    let channels = [&channel(b'B')[..], &channel(b'G'), &channel(b'R'), &[0]].concat();
    attribute("channels", "chlist", &channels);
    attribute("compression", "compression", &[0]);
    let window: Vec<u8> =
        [0, 0, width - 1, height - 1].iter().flat_map(|edge| edge.to_le_bytes()).collect();
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1f32.to_le_bytes());
    file.push(0);
    let row = 8 + 6 * width as usize;
    let start = file.len() + 8 * height as usize;
    (0..height as usize).for_each(|y| file.extend(((start + y * row) as u64).to_le_bytes()));
    for (y, texels) in texels.chunks(width as usize).enumerate() {
        file.extend((y as u32).to_le_bytes());
        file.extend((6 * width).to_le_bytes());
        for _ in 0..3 {
            texels.iter().for_each(|half| file.extend(half.to_le_bytes()));
        }
    }
    file
}

/// A Radiance map of `height` rows, each of one gray value 2^(e - 129): mantissa 128 and exponent
/// e.
fn row_map(width: usize, height: usize, exponent: impl Fn(usize) -> u8) -> Vec<u8> {
    let size = format!("-Y {height} +X {width}\n");
    let mut file = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}").into_bytes();
    for row in 0..height {
        file.extend([2, 2, (width >> 8) as u8, width as u8]);
        for value in [128, 128, 128, exponent(row)] {
            let mut left = width;
            while left > 0 {
                let run = left.min(127);
                file.extend([128 + run as u8, value]);
                left -= run;
            }
        }
    }
    file
}

#[test]
fn half_floats_that_are_not_finite() {
    const ONE: u16 = 0x3c00;
    let (infinity, not_a_number) = (0x7c00, 0x7e01);
    let folder = Folder::new();
    let mut texels = [ONE; 8];
    texels[2] = infinity;
    texels[5] = not_a_number;
    folder.write("map.exr", half_map(4, 2, &texels));
    assert_fails(
        &folder,
        "light map.exr --degree 2 --out new.csv",
        &[
            "map.exr: 2 of its pixels are not finite, the first in column 2 of row 0",
            "; clean the map",
        ],
    );
    // The largest and the smallest half, -0 and negative texels are finite.
    let halves = [0x7bff, 0x0001, 0x8000, 0xbc00, ONE, ONE, 0xfbff, ONE];
    let values = [65504.0, 2f64.powi(-24), 0.0, -1.0, 1.0, 1.0, -65504.0, 1.0];
    folder.write("map.exr", half_map(4, 2, &halves));
    let output = folder.run("light map.exr --degree 2");
    assert!(output.status.success());
    let report = String::from_utf8_lossy(&output.stderr);
    assert!(report.contains("negative radiance"), "{report}");
    let text = String::from_utf8(output.stdout).unwrap();
    let found = numbers(&rows(&text, "name,l,m,value"), 1);
    // Each of the 4 x 2 texels is an eighth of the sphere.
    let expected = values.iter().sum::<f64>() * 0.5 * PI * (0.25 / PI).sqrt();
    let error = (found[0] - expected).abs();
    assert!(error <= tolerances::WRITTEN_DIGITS * 65504.0, "{} {expected}", found[0]);
}

#[test]
fn a_map_of_two_texels() {
    let folder = Folder::new();
    folder.write("map.exr", half_map(2, 1, &[0x3c00, 0x4200]));
    let text = folder.ok("light map.exr --degree 1");
    let found = numbers(&rows(&text, "name,l,m,value"), 1);
    // 1 on the left and 3 on the right: the mean is 2; x at the texels' centers is ∓1.
    let root = (4.0 * PI).sqrt();
    let expected = [2.0 * root, 0.0, 0.0, -(0.75 / PI).sqrt() * 2.0 * PI * (3.0 - 1.0)];
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerances::WRITTEN_DIGITS * 2.0 * root, "{found}");
    }
}

#[test]
fn a_map_of_8192_by_4096() {
    let folder = Folder::new();
    folder.write("map.hdr", row_map(8192, 4096, |row| if row < 2048 { 130 } else { 129 }));
    let text = folder.ok("light map.hdr --degree 2");
    let found = numbers(&rows(&text, "name,l,m,value"), 1);
    // 2 above and 1 below: the ambient term, and ∫ y over the upper half, π.
    let mut expected = [0.0; 9];
    expected[0] = 1.5 * (4.0 * PI).sqrt();
    expected[1] = -(0.75 / PI).sqrt() * PI;
    for (found, of) in found.iter().zip(expected) {
        assert!((found - of).abs() <= tolerances::LARGE_MAP * expected[0], "{found}");
    }
}

/// CSV rows of one name whose coefficients are all 0.
fn zeros(name: &str, like: &str) -> String {
    let first = like.lines().nth(1).and_then(|line| line.split(',').next()).unwrap();
    let of_first = like.lines().filter(|line| line.starts_with(&format!("{first},")));
    let values = if like.starts_with("name,l,m") { 3 } else { 1 };
    of_first
        .map(|line| {
            let fields: Vec<&str> = line.split(',').skip(1).collect();
            let places = fields[..fields.len() - values].join(",");
            format!("{name},{places}{}\n", ",0".repeat(values))
        })
        .collect()
}

#[test]
fn a_light_of_zeros() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 2) + &zeros("night", &lights(4, 1)));
    let fragments = ["scene.toml", "`night`", "normalize = \"none\""];
    assert_fails(&folder, "basis --scene scene.toml --out b.bin", &fragments);
    let as_they_are = folder
        .read("scene.toml")
        .replace("rotation = \"any\"", "rotation = \"any\"\nnormalize = \"none\"");
    folder.write("scene.toml", as_they_are);
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_black(&folder, "night,");
    // No other light.
    folder.write("lights.csv", "name,l,m,r,g,b\n".to_owned() + &zeros("night", &lights(4, 1)));
    assert!(folder.ok("basis --scene scene.toml --out b.bin").contains("components   1 of 10000"));
    assert_black(&folder, "night,");
}

#[test]
fn a_material_of_zeros() {
    for count in [3, 0] {
        let folder = Folder::new();
        let some = materials(3, 1);
        let header = "name,o,p,q,value\n".to_owned();
        let others = if count == 0 { header } else { materials(3, count) };
        folder.write("materials.csv", others + &zeros("soot", &some));
        folder.ok("basis --scene scene.toml --out b.bin");
        assert_black(&folder, ",soot,");
    }
}

/// Asserts that the images of this light or material are exactly black, in every format.
fn assert_black(folder: &Folder, name: &str) {
    for options in ["", "--format f64", "--method eigen", "--method modes"] {
        let text = folder.ok(&format!("shade b.bin {PAIR} --normals normals.csv {options}"));
        let of_name: Vec<_> =
            rows(&text, SHADED).into_iter().filter(|row| row.join(",").contains(name)).collect();
        assert!(!of_name.is_empty());
        assert!(numbers(&of_name, 3).iter().all(|value| *value == 0.0), "{options}");
    }
}

#[test]
fn one_light_one_material_and_more_components_than_rank() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 1));
    folder.write("materials.csv", materials(3, 1));
    for criterion in ["image-centered", "standard"] {
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        let report = folder.ok("basis --scene scene.toml --out b.bin");
        assert!(report.contains("of 10000 requested: there are no more"), "{report}");
        let eigenvalues = folder.ok("eigenvalues b.bin");
        let values = rows(&eigenvalues, "criterion,index,m,eigenvalue");
        let values: Vec<f64> = values.iter().filter_map(|row| row[3].parse().ok()).collect();
        assert!(values.is_sorted_by(|a, b| a >= b) && values.iter().all(|value| *value > 0.0));
    }
}

/// Normals of any length are normalized; those that point away a little become the rim's.
#[test]
fn normals_that_are_not_unit() {
    let folder = Folder::with_table();
    let shaded = |normals: &str| {
        folder.write("normals.csv", format!("x,y,z\n{normals}"));
        folder.shaded("--format f64")
    };
    let unit = shaded("0.6,0,0.8\n1,0,0\n0,0,1\n");
    for scaled in
        ["6e-301,0,8e-301\n1e-320,0,0\n0,0,1e-320\n", "6e300,0,8e300\n1e308,0,0\n0,0,1e308\n"]
    {
        let found = shaded(scaled);
        let worst = difference(&found, &unit);
        assert!(worst <= tolerances::ORTHONORMAL_NODES, "{worst}");
    }
    assert_eq!(shaded("1,0,-0.0009\n"), shaded("1,0,0\n"));
    for bad in ["0,0,0", "nan,0,1", "0,inf,1", "0,0,-1", "1,0,-0.002"] {
        folder.write("normals.csv", format!("x,y,z\n0,0,1\n{bad}\n"));
        let shade = format!("shade b.bin {PAIR} --normals normals.csv --out new.csv");
        assert_fails(&folder, &shade, &["normals.csv:3:"]);
    }
}

/// Images whose squares are out of range have no table.
#[test]
fn squares_out_of_range() {
    for size in ["e155", "e-180", "e300"] {
        let folder = Folder::new();
        let line = |line: &str| match line.strip_suffix("value") {
            Some(_) => format!("{line}\n"),
            None => format!("{line}{size}\n"),
        };
        let materials: String = materials(3, 2).lines().map(line).collect();
        folder.write("materials.csv", materials);
        assert_fails(
            &folder,
            "basis --scene scene.toml --out b.bin",
            &["scene.toml", "out of range"],
        );
    }
}

/// Images are linear in light and material over the range of f64 and f32.
#[test]
fn coefficients_tiny_and_huge() {
    let folder = Folder::with_table();
    let shaded = |format: &str| folder.shaded(&format!("--format {format}"));
    let (given, on) = (folder.read("lights.csv"), folder.read("materials.csv"));
    let scaled = |text: &str, values: usize, factor: f64| -> String {
        let (header, rest) = text.split_once('\n').unwrap();
        let line = |line: &str| {
            let fields: Vec<&str> = line.split(',').collect();
            let (places, values) = fields.split_at(fields.len() - values);
            let values: Vec<String> = values
                .iter()
                .map(|value| format!("{:e}", value.parse::<f64>().unwrap() * factor))
                .collect();
            format!("{},{}\n", places.join(","), values.join(","))
        };
        format!("{header}\n{}", rest.lines().map(line).collect::<String>())
    };
    for (format, tolerance) in
        [("f64", tolerances::DENSE_PROJECTION), ("f32", tolerances::POLYNOMIAL_F32)]
    {
        folder.write("lights.csv", &given);
        folder.write("materials.csv", &on);
        let plain = shaded(format);
        for (light, material) in
            [(1e30, 1.0), (1e-30, 1.0), (1.0, 1e30), (1e30, 1e-30), (1e-30, 1e30)]
        {
            folder.write("lights.csv", scaled(&given, 3, light));
            folder.write("materials.csv", scaled(&on, 1, material));
            let found = shaded(format);
            let scaled_back: Vec<f64> =
                found.iter().map(|value| value / (light * material)).collect();
            let worst = difference(&scaled_back, &plain);
            assert!(worst <= tolerance, "{format}, {light} on {material}: {worst}");
        }
    }
}

//! The inputs that an object may be given by, through the command line.

use crate::support::objects::{
    apart, built, eigenvalues, encode, facets, normal_map, obj, ply, stl, table, with_geometry,
};
use crate::tolerances;
use std::fmt::Write;

/// Eigenvalues of one mesh read two ways, of the largest: the same facets in f64.
const SAME_MESH: f64 = 1e-14;

/// Eigenvalues of a sphere from a normal map of 64 x 64, of the largest: its rim is jagged, a
/// pixel is 3 % of the radius.
const NORMAL_MAP: f64 = 0.03;

/// Eigenvalues over normals of 16 bits, of the largest.
const SIXTEEN_BITS: f64 = 3e-5;

#[test]
fn a_mesh_is_the_list_of_its_facets() {
    let listed = table("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    let expected = eigenvalues(&listed);
    for (name, bytes, allowed) in [
        ("m.obj", obj().into_bytes(), SAME_MESH),
        ("m.ply", ply().into_bytes(), SAME_MESH),
        ("m.stl", stl(), tolerances::SAME_MESH_F32),
    ] {
        let mesh = table(&format!("normals = \"{name}\"\n"), &[(name, bytes)]);
        let found = eigenvalues(&mesh);
        let found = apart(&found, &expected);
        println!("{name}: {found:e}");
        assert!(found < allowed, "{name}: {found:e}");
    }
}

#[test]
fn a_normal_map_of_a_sphere_is_nearly_the_sphere() {
    let sphere = table("normals = \"sphere\"\n", &[]);
    let expected = eigenvalues(&sphere);
    for (bits, allowed) in
        [(png::BitDepth::Eight, NORMAL_MAP), (png::BitDepth::Sixteen, NORMAL_MAP)]
    {
        let folder = table("normals = \"n.png\"\n", &[("n.png", normal_map(bits))]);
        let found = apart(&eigenvalues(&folder), &expected);
        println!("{bits:?}: {found:e}");
        assert!(found < allowed, "{bits:?}: {found:e}");
    }
}

/// A mask leaves a piece to the right and above, as unlike its mirror images as can be:
/// under light that does not turn, as a list of those normals.
#[test]
fn a_mask_hides_normals() {
    let counts = |row: i32, column: i32| column >= 32 && row < 24;
    let map = normal_map(png::BitDepth::Sixteen);
    let mask: Vec<f64> =
        (0..64 * 64).map(|k| f64::from(u8::from(counts(k / 64, k % 64)))).collect();
    let mask = encode(64, png::ColorType::Grayscale, png::BitDepth::Eight, &mask);
    let captured = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        eigenvalues(&built(&with_geometry(geometry).replace("\"any\"", "\"none\""), files))
    };
    let list = |[sx, sy]: [f64; 2]| {
        let mut text = "x,y,z\n".to_owned();
        for row in 0..64 {
            for column in 0..64 {
                let at = |k: i32| (f64::from(k) + 0.5) / 32.0 - 1.0;
                let (x, y) = (at(column), -at(row));
                let square = 1.0 - x * x - y * y;
                if square > 0.0 && counts(row, column) {
                    writeln!(text, "{},{},{}", sx * x, sy * y, square.sqrt()).expect("text");
                }
            }
        }
        captured("normals = \"piece.csv\"\n", &[("piece.csv", text.into())])
    };
    let masked = captured(
        "normals = \"n.png\"\nmask = \"mask.png\"\n",
        &[("n.png", map), ("mask.png", mask)],
    );
    let found = apart(&masked, &list([1.0, 1.0]));
    println!("{found:e}");
    assert!(found < SIXTEEN_BITS, "{found:e}");
    for mirrored in [[-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let found = apart(&masked, &list(mirrored));
        assert!(found > 100.0 * SIXTEEN_BITS, "{mirrored:?}: {found:e}");
    }
}

/// A leading minus is weaker than a power.
#[test]
fn formulas_are_read_as_written() {
    let of = |density: &str| {
        eigenvalues(&table(&format!("normals = \"slant-density\"\ndensity = \"{density}\"\n"), &[]))
    };
    for (short, explicit) in [("exp(-a^2)", "exp(0-a*a)"), ("2 - -a^2", "2+a*a")] {
        let found = apart(&of(short), &of(explicit));
        assert!(found < SAME_MESH, "{short}: {found:e}");
    }
    let found = apart(&of("exp(-a^2)"), &of("exp(a^2)"));
    assert!(found > NORMAL_MAP, "{found:e}");
}

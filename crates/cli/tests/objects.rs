//! Objects other than the sphere, through the command line.

use crate::support::objects::{apart, built, eigenvalues, facets, shaded, table, with_geometry};
use crate::support::scene;
use crate::tolerances;
use eigenshade_shading::owned_basis::OwnedBasis;
use std::f64::consts::PI;

/// Eigenvalues of a density that is linear between 401 slants, of the largest. Chords of a cosine are
/// too low by the same share everywhere, which normalization removes; the rest falls with the fourth
/// power of the step of 4e-3.
const TABULATED_DENSITY: f64 = 9e-11;

fn luminance(colors: &[f64]) -> Vec<f64> {
    let of = |[r, g, b]: &[f64; 3]| 0.2126 * r + 0.7152 * g + 0.0722 * b;
    colors.as_chunks().0.iter().map(of).collect()
}

/// The sphere's density as a formula and as a table is the sphere; all components give
/// the direct sum for every object.
#[test]
fn every_object_shades_as_the_direct_sum() {
    let steps = (0..=400).map(|k| {
        let a = 0.5 * PI * f64::from(k) / 400.0;
        format!("{a},{}\n", a.cos().max(0.0))
    });
    let table_of_slants = format!("slant,density\n{}", steps.collect::<String>());
    let sphere = eigenvalues(&table("normals = \"sphere\"\n", &[]));
    for (geometry, files) in [
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"\n", vec![]),
        (
            "normals = \"slant-density\"\ndensity = \"d.csv\"\n",
            vec![("d.csv", table_of_slants.into_bytes())],
        ),
        ("normals = \"facets.csv\"\n", vec![("facets.csv", facets().into_bytes())]),
    ] {
        let folder = table(geometry, &files);
        let found = apart(&eigenvalues(&folder), &sphere);
        println!("{geometry:?}: eigenvalues {found:e}");
        if geometry.contains("cos(a)") {
            assert!(found < tolerances::GENERAL_SPHERE, "{found:e}");
        } else if geometry.contains("d.csv") {
            assert!(found < TABULATED_DENSITY, "{found:e}");
        }
        let truth = shaded(&folder, "--method modes");
        for method in ["polynomial", "eigen"] {
            let found = apart(&shaded(&folder, &format!("--method {method} --format f64")), &truth);
            println!("{geometry:?}, {method}: {found:e}");
            assert!(found < tolerances::GENERAL_PICTURES, "{method}: {found:e}");
            let found = apart(&shaded(&folder, &format!("--method {method}")), &truth);
            println!("{geometry:?}, {method}, f32: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS_F32, "{method}: {found:e}");
        }
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// A pixel of an object costs what one of a sphere with as many azimuths costs: the
/// polynomials are no longer.
#[test]
fn a_pixel_costs_what_it_costs_on_a_sphere() {
    let length = |geometry: &str, files: &[(&str, Vec<u8>)]| {
        let folder = built(&with_geometry(geometry).replace("1e-12", "1e-7"), files);
        let bytes = std::fs::read(folder.path("b.bin")).expect("a table");
        let owned = OwnedBasis::<f32>::new(&eigenshade_table::decode(&bytes).expect("a table"));
        owned.basis().expect("a basis").scene_len()
    };
    let sphere = length("normals = \"sphere\"\n", &[]);
    let object = length("normals = \"facets.csv\"\n", &[("facets.csv", facets().into())]);
    println!("{object} numbers, of a sphere {sphere}");
    assert!(object <= sphere, "{object} numbers, of a sphere {sphere}");
}

/// Light that does not turn, or turns about the vertical axis, has its own components,
/// which give the same pictures.
#[test]
fn light_that_does_not_turn() {
    for criterion in ["image-centered", "standard"] {
        let mut seen = Vec::new();
        for rotation in ["any", "vertical", "none"] {
            let text = scene(criterion, 10_000, "[]");
            // Exposures as they are: an image at another one differs from the mean image
            // by more than the database's images do.
            let rotated = format!("rotation = \"{rotation}\"\nnormalize = \"none\"");
            let folder = built(&text.replace("rotation = \"any\"", &rotated), &[]);
            let truth = shaded(&folder, "--method modes");
            // As captured, a few lights span no more than their luminance, which the
            // statistics are of; turned lights span every channel.
            let ours = shaded(&folder, "--method polynomial --format f64");
            let found = match rotation {
                "none" => apart(&luminance(&ours), &luminance(&truth)),
                _ => apart(&ours, &truth),
            };
            println!("{criterion}, {rotation}: {found:e}");
            assert!(found < tolerances::ALL_COMPONENTS, "{criterion}, {rotation}: {found:e}");
            let values = folder.ok("eigenvalues b.bin");
            assert!(!seen.contains(&values), "{rotation} is no other statistics");
            seen.push(values);
        }
    }
}

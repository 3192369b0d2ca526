//! Objects with shadows: the recorded errors, the statements of the paper, an oracle and hard cases.

mod bounce;
mod cases;
mod oracle;
mod statements;
mod textured;

use eigenshade::object::ShadowedObject;
use eigenshade::screen::Exposure;
use eigenshade::{Light, Rgb};
use eigenshade_generator::material::brdf::{Brdf, Ggx};
use eigenshade_generator::object::mesh_data::Mesh;
use eigenshade_generator::object::surface::{Surface, View};
use eigenshade_model::database::Lights;
use eigenshade_model::shipped;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_shadows::directions::{FINE, cells};
use eigenshade_shadows::eigenimages::{Eigenimages, eigenimages};
use eigenshade_shadows::light_root::{LightRoot, Turns};
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::{Object, RANK};
use eigenshade_shadows::packed::{Compression, packed};
use eigenshade_shadows::pixels::Pixels;
use eigenshade_shadows::transport::{Surroundings, transports};
use eigenshade_shadows::visibility::Occluders;
use eigenshade_shadows::weights::Columns;
use eigenshade_testing::fixtures::ROOT;
use faer::Mat;
use indicatif::ProgressBar;
use report::shadow_lights::Lit;
use report::shadow_shapes::SHAPES;
use report::shadows;
use report::sheet::{Record, Sheet};
use std::path::Path;

const DEGREE: usize = 9;

fn surface(mesh: &Mesh, is_flat: bool) -> Surface {
    let view = View { is_flat, ..View::default() };
    Surface::new(&"a mesh".into(), mesh, &view).unwrap()
}

/// An object, with a number of reflections between its parts.
fn object(surface: &Surface, size: usize, material: Material<'_>, bounces: usize) -> Object {
    every(1, surface, size, material, bounces)
}

/// Every `step`-th pixel of an object.
fn every(
    step: usize,
    surface: &Surface,
    size: usize,
    material: Material<'_>,
    bounces: usize,
) -> Object {
    let pixels = Pixels::new(surface, size).unwrap();
    let points: Vec<_> = pixels.points().into_iter().step_by(step).collect();
    let occluders = Occluders::new(&surface.facets);
    let around = Surroundings { occluders: &occluders, bounces };
    let harmonics = harmonics();
    let light = Columns { degree: Some(DEGREE), all: harmonics.as_ref() };
    let transports = transports(&points, Some(around), &[material], light, &());
    let pixels = pixels.covered.into_iter().step_by(step).collect();
    Object { size, degree: DEGREE, pixels, transports }
}

/// An object whose surface is black to its pixels.
fn shadowed(surface: &Surface, size: usize, brdf: &dyn Brdf) -> Object {
    object(surface, size, Material::Formula(brdf), 0)
}

/// The harmonics in the directions of the transports.
fn harmonics() -> Mat<f32> {
    let cells = cells(FINE);
    let all: Vec<Vec<f64>> =
        cells.iter().map(|(direction, _)| spherical_harmonic::all(DEGREE, *direction)).collect();
    Mat::from_fn(cells.len(), all[0].len(), |row, k| all[row][k] as f32)
}

fn lights() -> Lights {
    shipped::lights().unwrap().truncated(DEGREE)
}

/// The lobby in green.
fn lobby() -> Vec<f64> {
    let light = lights().entries.into_iter().find(|light| light.name == "lobby").unwrap();
    let [_, green, _] = light.rgb;
    green
}

fn bowl() -> Object {
    let (_, mesh) = SHAPES[5];
    shadowed(&surface(&mesh(), false), 20, &Ggx::new(0.5, 0.9, 0.0).unwrap())
}

fn images(object: &Object, rank: usize) -> Eigenimages {
    let root = LightRoot::new(&lights(), Turns::All).unwrap();
    eigenimages(&[object.transports[0].as_ref()], &[1.0], &root, rank).unwrap()
}

/// The rms of the runtime's picture in percent of the largest irradiance, and the codes of pixels.
fn drawn(object: &Object, images: &Eigenimages, compression: Compression) -> (f64, Vec<u16>) {
    let Object { size, degree, pixels, .. } = object;
    let (file, _) = packed(images, *degree, *size, pixels, &[[1.0; 3]], compression);
    let bytes = file.encode();
    let runtime = ShadowedObject::new(&bytes).unwrap();
    let light = lobby();
    let of_runtime: Vec<f32> = light.iter().map(|&one| one as f32).collect();
    let light_of_runtime = Rgb::gray(Light::new(&of_runtime).unwrap());
    let direct = object.irradiance(&light, &[1.0]);
    let white = direct.iter().copied().fold(0.0, f32::max);
    let mut of_codes = Vec::new();
    let d = runtime.coefficients(light_of_runtime).unwrap();
    let exposure = Exposure::new(0.5 / white).unwrap();
    runtime.shade(&d, exposure, |color| of_codes.push(f64::from(color.g.0) / 32_768.0));
    assert_eq!(of_codes.len(), runtime.codes());
    let codes: Vec<u16> = file.pixels.iter().map(|pixel| pixel.code).collect();
    let square: f64 = codes
        .iter()
        .zip(&direct)
        .map(|(&code, one)| (of_codes[usize::from(code)] - f64::from(one / white)).powi(2))
        .sum();
    (100.0 * (square / codes.len() as f64).sqrt(), codes)
}

#[test]
fn all_shapes_are_packed() {
    for (name, mesh) in SHAPES {
        let object = shadowed(&surface(&mesh(), false), 40, &Ggx::new(0.5, 0.9, 0.0).unwrap());
        let (rms, _) = drawn(&object, &images(&object, RANK), Compression::default());
        println!("{name}: {rms:.3} %");
        assert!(rms < 2.5, "{name}");
    }
}

#[test]
fn small_objects_and_ranks_are_drawn() {
    let object = bowl();
    let all = Compression { codes: 65_535, ..Compression::default() };
    // A rank of the number of pixels at most; more clusters and images than codes.
    // The second is that of rows of 8 bits; the first has one number that matters, which is exact.
    for (pixels, bound) in [(&[150][..], 0.1), (&[150, 160], 0.2), (&[20, 150, 160, 170, 180], 0.5)]
    {
        let few = cases::rows(&object, pixels);
        let images = images(&few, RANK);
        assert_eq!(images.pixels.ncols(), pixels.len());
        let (rms, codes) = drawn(&few, &images, all);
        println!("{} pixels: {rms:.3} %", pixels.len());
        assert!(rms < bound && codes.len() == pixels.len());
    }
    // Equal pixels share a code.
    let equal = cases::rows(&object, &[150, 20, 150, 160, 150, 20]);
    let (rms, codes) = drawn(&equal, &images(&equal, RANK), Compression { codes: 3, ..all });
    println!("three codes: {rms:.3} %");
    assert!(rms < 0.5);
    assert!(codes[0] == codes[2] && codes[2] == codes[4] && codes[1] == codes[5]);
    assert!(codes[0] != codes[1] && codes[0] != codes[3] && codes[1] != codes[3]);
    // No images at all, one component, one code.
    for (rank, compression) in [
        (1, all),
        (RANK, Compression { images: 0, ..all }),
        (RANK, Compression { codes: 1, ..all }),
    ] {
        let (rms, _) = drawn(&object, &images(&object, rank), compression);
        println!("rank {rank}, {compression:?}: {rms:.3} %");
        assert!(rms < 40.0);
    }
    // A picture of 2 x 2 pixels, the smallest.
    let (_, mesh) = SHAPES[0];
    let least = shadowed(&surface(&mesh(), false), 2, &Ggx::new(0.5, 0.9, 0.0).unwrap());
    let (rms, _) = drawn(&least, &images(&least, RANK), all);
    println!("{} pixels: {rms:.3} %", least.pixels.len());
    assert!(rms < 0.5);
}

#[test]
fn recorded_errors_are_found_again() {
    let sheet = recorded();
    let lit = Lit::new(&Path::new(ROOT).join("tables/inputs/maps")).unwrap();
    let rows = shadows::errors(&["knot"], &["metal 0.5"], &lit, &ProgressBar::hidden()).unwrap();
    assert_eq!(rows.len(), shadows::WAYS.len());
    for row in rows {
        let key = [row.shape, row.material, row.way];
        let same = |one: &&Record| ["shape", "material", "way"].map(|name| one.text(name)) == key;
        let recorded = sheet.rows.iter().find(same).unwrap();
        for (column, found) in shadows::COLUMNS.split(',').map(str::trim).zip(row.fields()).skip(3)
        {
            let (Some(recorded), Ok(found)) = (recorded.number(column), found.parse::<f64>())
            else {
                continue;
            };
            // Processors round differently, and k-means amplifies it.
            assert!((found - recorded).abs() <= 0.1 * recorded + 0.02, "{key:?} {column}: {found}");
        }
    }
}

/// The errors under tilted lights that docs/shadows.md states.
#[test]
fn tilts_are_drawn_better_by_statistics_of_tilts() {
    let lit = Lit::new(&Path::new(ROOT).join("tables/inputs/maps")).unwrap();
    let rows = shadows::of_turns("knot", "metal 0.5", &lit).unwrap();
    let [free, tilts] = rows.map(|row| row.errors[0]);
    println!("{free} {tilts}");
    assert!(tilts < 2.3 && free > 2.4 && tilts < 0.9 * free);
}

fn recorded() -> Sheet {
    Sheet::read(&Path::new(ROOT).join("docs/shadows.csv")).unwrap()
}

/// The errors that pages state, with a code for each pixel: the largest median under tilted lights over
/// all shapes, and the largest of all pictures but those of the studio.
#[test]
fn errors_are_within_the_stated_ones() {
    let sheet = recorded();
    for (material, median, worst) in
        [("matte", 1.3, 2.5), ("plastic 0.3", 2.6, 5.6), ("metal 0.5", 2.6, 4.6)]
    {
        let of_material = sheet.rows.iter().filter(|row| row.text("material") == material);
        for row in of_material.filter(|row| row.text("way") == "codes: all") {
            let number = |column| row.number(column).unwrap();
            assert!(number("tilted_rms") < median, "{material} {}", row.text("shape"));
            for light in ["apartment", "dawn", "hall", "night", "venice"] {
                assert!(number(light) < worst, "{material} {} {light}", row.text("shape"));
            }
        }
    }
    let largest = |column: &str, material: &str, way: &str| {
        let rows = sheet.rows.iter().filter(|row| row.text("material") == material);
        let rows = rows.filter(|row| row.text("way").starts_with(way));
        rows.fold(0.0, |most: f64, row| most.max(row.number(column).unwrap()))
    };
    for material in ["matte", "plastic 0.3"] {
        assert!(largest("studio", material, "transports") < 13.5);
    }
    assert!(largest("studio", "metal 0.5", "codes") < 26.5);
    assert!(largest("tilted_rms", "metal 0.3", "transports") < 3.0);
}

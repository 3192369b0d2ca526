//! `export --lang npz` holds the numbers of a table and of other commands, bit for bit; and what
//! `export` refuses.

use crate::support::files::built;
use crate::support::{Folder, PAIR, assert_fails, scene};
use eigenshade_model::database::Named;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::mode;
use std::collections::HashMap;
use std::io::{Cursor, Read};

/// An array of a file: shape, and values as bits; those of a text are its letters.
type Numbers = (Vec<usize>, Vec<u64>);

/// The arrays of an npz file.
fn arrays(folder: &Folder, name: &str) -> HashMap<String, Numbers> {
    let mut archive = zip::ZipArchive::new(Cursor::new(folder.bytes(name))).expect("an archive");
    let mut found = HashMap::new();
    for index in 0..archive.len() {
        let mut file = archive.by_index(index).expect("a file");
        let name = file.name().strip_suffix(".npy").expect("an array").to_owned();
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).expect("bytes");
        assert_eq!(&bytes[..8], b"\x93NUMPY\x01\x00");
        let start = 10 + usize::from(u16::from_le_bytes([bytes[8], bytes[9]]));
        assert_eq!(start % 64, 0);
        let header = std::str::from_utf8(&bytes[10..start]).expect("text");
        let after = |key: &str| header.split_once(key).expect("a key").1;
        let kind = after("'descr': '").split('\'').next().expect("a kind");
        let shape = after("'shape': (").split(')').next().expect("a shape");
        let lengths = shape.split(',').filter(|length| !length.trim().is_empty());
        let shape = lengths.map(|length| length.trim().parse().expect("a length")).collect();
        let values: Vec<u64> = match kind {
            "<f8" | "<i8" => {
                let words = bytes[start..].chunks_exact(8);
                words.map(|word| u64::from_le_bytes(word.try_into().expect("a word"))).collect()
            }
            _ if kind.starts_with("<U") => {
                let letters = bytes[start..].chunks_exact(4);
                let letters = letters.map(|one| u32::from_le_bytes(one.try_into().expect("one")));
                letters.filter(|&letter| letter != 0).map(u64::from).collect()
            }
            _ => panic!("{kind}"),
        };
        found.insert(name, (shape, values));
    }
    found
}

fn bits<'a>(values: impl IntoIterator<Item = &'a f64>) -> Vec<u64> {
    values.into_iter().map(|value| value.to_bits()).collect()
}

fn floats(array: &Numbers) -> Vec<f64> {
    array.1.iter().map(|&bits| f64::from_bits(bits)).collect()
}

/// The arrays that these options export.
fn exported(folder: &Folder, options: &str) -> HashMap<String, Numbers> {
    folder.ok(&format!("export --lang npz {options} --out e.npz"));
    arrays(folder, "e.npz")
}

/// The arrays of a table are the table's numbers, bit for bit, and obey the equations that they
/// stand for.
#[test]
fn arrays_are_those_of_the_table() {
    for criterion in ["image-centered", "standard"] {
        let folder = built(&scene(criterion, 20, "[]"), &[]);
        let found = exported(&folder, "--table b.bin --normals normals.csv");
        let table = folder.table("b.bin");
        let gram = &table.gram;
        let [nodes, count] = [gram.nodes.len(), table.components.len()];
        let total = mode::total(gram.degree, gram.order);
        assert_eq!(found["gram_factor"].0, [nodes, total]);
        assert_eq!(found["mode_coefficients"].0, [total, count]);
        assert_eq!(found["nodes"].1, bits(&gram.nodes));
        assert_eq!(found["root_weights"].1, bits(&gram.root_weights));
        let spectrum: Vec<f64> =
            table.spectrum.iter().map(|one| one.1.unwrap_or(f64::NAN)).collect();
        assert_eq!(found["spectrum"].1, bits(&spectrum));
        assert_eq!(found["eigenvalues"].1, bits(&spectrum[..count]));

        // Each number of U, A, U^T M and e, found by its mode.
        let modes: Vec<i64> = found["modes"].1.iter().map(|&word| word as i64).collect();
        let at = |name: &str, index: usize| f64::from_bits(found[name].1[index]);
        for (s, of_mode) in modes.chunks(5).enumerate() {
            let &[l, m, o, p, q] = of_mode else { panic!("five indices") };
            let azimuth = m.unsigned_abs() as usize;
            let [l, o, p, q] = [l, o, p, q].map(|index| index as usize);
            let mut of_azimuth = mode::indices(gram.degree, gram.order, azimuth);
            let place = of_azimuth.position(|one| one == (l, o, p, q)).expect("a mode");
            let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
            let column = &gram.columns(azimuth)[place];
            for (k, value) in column.iter().enumerate() {
                assert_eq!(at("gram_factor", k * total + s), sign * value);
            }
            let mean = if m == 0 { gram.mode_means()[place] } else { 0.0 };
            assert_eq!(at("mode_means", s), mean);
            for (i, component) in table.components.iter().enumerate() {
                let profile = &table.profiles[component.profile];
                let is_own = i64::from(component.order) == m;
                let of = |of_azimuth: &[f64]| if is_own { sign * of_azimuth[place] } else { 0.0 };
                assert_eq!(at("mode_coefficients", s * count + i), of(&profile.modes));
                assert_eq!(at("projection", i * total + s), of(&table.gram_row(profile)));
            }
        }
        for (i, component) in table.components.iter().enumerate() {
            let profile = &table.profiles[component.profile];
            assert_eq!(found["component_m"].1[i] as i64, i64::from(component.order));
            for (name, of) in [("profiles", &profile.node_values), ("series", &profile.chebyshev)] {
                for (k, value) in of.iter().enumerate() {
                    assert_eq!(at(name, k * count + i), *value);
                }
            }
        }
        assert_eq!(found.contains_key("mean_series"), criterion == "standard");

        // Eigenimages by the definition of Chebyshev polynomials, T_k(cos x) = cos kx.
        let normals = floats(&found["normals"]);
        let images = floats(&found["eigenimages"]);
        for (i, component) in table.components.iter().enumerate() {
            let profile = &table.profiles[component.profile];
            for (k, normal) in normals.as_chunks::<3>().0.iter().enumerate() {
                let &[x, y, z] = normal;
                let angle = (2.0 * z - 1.0).clamp(-1.0, 1.0).acos();
                let terms = (0..).zip(&profile.chebyshev);
                let height: f64 = terms.map(|(k, c)| c * (f64::from(k) * angle).cos()).sum();
                let wave = spherical_harmonic::azimuth(component.order as isize, y.atan2(x));
                let value = height * x.hypot(y).powi(profile.azimuth as i32) * wave;
                let found = images[i * normals.len() / 3 + k];
                assert!((found - value).abs() < 1e-11, "{criterion}, {i}, {k}: {found} {value}");
            }
        }
    }
}

/// Lights and materials are those of their files; the coefficients of a scene are those that
/// `project` writes, and its images those of `shade` in f64.
#[test]
fn arrays_of_a_scene_are_those_of_other_commands() {
    let folder = Folder::with_table();
    let found = exported(&folder, &format!("{PAIR} --table b.bin --normals normals.csv"));
    let numbers_of = |entries: &[Named]| -> Vec<u64> {
        entries.iter().flat_map(|entry| bits(entry.rgb.iter().flatten())).collect()
    };
    let lights = read_lights(folder.path("lights.csv"), None).expect("lights");
    let materials = read_materials(folder.path("materials.csv"), None).expect("materials");
    assert_eq!(found["lights"].1, numbers_of(&lights.entries));
    assert_eq!(found["materials"].1, numbers_of(&materials.entries));
    let names: String = materials.entries.iter().map(|entry| entry.name.as_str()).collect();
    let letters: Vec<u64> = names.chars().map(u64::from).collect();
    assert_eq!(found["material_names"].1, letters);

    let projected = folder.projected(&format!("--table b.bin {PAIR}"));
    let of_rows = |name: &str| {
        let (shape, values) = &found[name];
        assert_eq!(shape[..3], [3, 4, 3]);
        let length = shape[3];
        // From channel by channel to rows r, g, b.
        let pairs = values.chunks(3 * length);
        let rows = pairs.flat_map(|pair| {
            (0..length).flat_map(move |k| (0..3).map(move |c| pair[c * length + k]))
        });
        rows.collect::<Vec<u64>>()
    };
    assert_eq!(of_rows("coefficients"), bits(&projected));
    assert_eq!(of_rows("images"), bits(&folder.shaded("--format f64")));
}

/// A shipped light ends at the degree of the table, and an object's normals have pixels.
#[test]
fn normals_of_a_picture_have_pixels() {
    let folder = Folder::new();
    let options = "--light lobby --material gold-metallic-paint --normals sphere --size 8";
    let found = exported(&folder, options);
    assert_eq!(found["lights"].0, [1, 3, 100]);
    assert_eq!(found["materials"].0, [1, 3, 40]);
    assert_eq!(found["coefficients"].0, [1, 1, 3, 160]);
    let count = found["normals"].0[0];
    assert_eq!(found["pixels"].0, [count, 2]);
    assert_eq!(found["coverage"].0, [count]);
    assert!(found["pixels"].1.iter().all(|&place| place < 8));
}

/// The same file in every run.
#[test]
fn npz_files_have_no_date() {
    let folder = Folder::new();
    folder.ok("export --lang npz --light lobby --out a.npz");
    let mut archive = zip::ZipArchive::new(Cursor::new(folder.bytes("a.npz"))).unwrap();
    let file = archive.by_index(0).unwrap();
    assert_eq!(file.last_modified(), Some(zip::DateTime::default()));
}

/// A light of a higher degree than the table's, for an object with shadows.
#[test]
fn a_light_has_the_degree_that_is_asked() {
    let folder = Folder::new();
    let found = exported(&folder, "--light studio --degree 16");
    let lights = eigenshade_model::shipped::lights().expect("lights").truncated(16);
    let studio = lights.entries.iter().find(|light| light.name == "studio").expect("a light");
    assert_eq!(found["lights"], (vec![1, 3, 289], bits(studio.rgb.iter().flatten())));
    folder.write("low.csv", "name,l,m,r,g,b\na,0,0,1,1,1\n");
    assert_fails(
        &folder,
        "export --lang rust --light low.csv --degree 1",
        &["low.csv: the light has degree 0, not 1", "light --degree"],
    );
}

//! Images to read, and the answers.

use super::{DEGREE, Folder, ORDER, lights, materials, noise, rows};
use png::{BitDepth, ColorType, Encoder};
use std::collections::HashMap;
use std::fmt::Write;

const HEADER: &str = "quantity,name,index,r,g,b";

/// Numbers by quantity and name.
pub type Answer = HashMap<(String, String), Vec<[f64; 3]>>;

/// The answer's numbers by quantity and name, in the order of the index.
pub fn answer(text: &str) -> Answer {
    let mut found = Answer::new();
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

pub fn get<'a>(answer: &'a Answer, quantity: &str, name: &str) -> &'a [[f64; 3]] {
    &answer[&(quantity.to_owned(), name.to_owned())]
}

/// The nearest material.
pub fn nearest(answer: &Answer) -> &str {
    let first = |((quantity, _), list): &(&(String, String), &Vec<[f64; 3]>)| {
        quantity == "material-evidence" && list[0][0] == 0.0
    };
    &answer.iter().find(first).expect("a first material").0.1
}

pub fn png(
    width: usize,
    height: usize,
    depth: BitDepth,
    color: ColorType,
    bytes: &[u8],
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_depth(depth);
    encoder.set_color(color);
    encoder.write_header().unwrap().write_image_data(bytes).unwrap();
    file
}

/// A folder with the small table of all components, 400 normals, and `image.csv`,
/// the image of one colored light on the third material.
pub fn with_image() -> Folder {
    let folder = Folder::with_table();
    folder.write("light.csv", lights(DEGREE, 1));
    let all = materials(ORDER, 4);
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

/// Reads that image.
pub const READ: &str = "read image.csv --normals normals.csv --table b.bin";

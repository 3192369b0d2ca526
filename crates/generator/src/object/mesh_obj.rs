//! Wavefront files (.obj), read line by line.

use crate::object::mesh_data::{Attribute, MOST, Mesh, append_line, broken, fan};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;

/// The triangles of a Wavefront file; polygons are cut into fans.
///
/// In `f 1/2/3` the numbers are a corner, texture coordinates and a normal, each counted from 1, or
/// backward from the latest one if negative. Materials are named, and not read. Other lines are
/// ignored; surfaces among them are counted in a warning.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    // Count first: a growing list takes three times the memory.
    let (mut all, mut triangles, mut surfaces) = ([0; 3], 0, 0);
    each_line(file, |words| {
        match words {
            ["f", polygon @ ..] => triangles += (polygon.len() as u64).saturating_sub(2),
            ["surf" | "bzp" | "bsp" | "cdp", ..] => surfaces += 1,
            [word, ..] => count(word, &mut all),
            _ => {}
        }
        Ok(())
    })?;
    if surfaces > 0 {
        file.warn(format!("free-form surfaces are ignored: {surfaces}; export them as triangles"));
    }
    let mut mesh = Mesh::with_room(file, all[0], triangles)?;
    file.at_most(all[1].max(all[2]), 3 * MOST, "normals or texture coordinates")?;
    each_line(file, |words| {
        match words {
            ["v", numbers @ ..] => mesh.corners.push(some("v", "three", numbers)?),
            ["vt", numbers @ ..] => {
                let [u, v] = some("vt", "two", numbers)?;
                mesh.coordinates.values.push([u as f32, (1.0 - v) as f32]);
            }
            ["vn", numbers @ ..] => {
                let normal: [f64; 3] = some("vn", "three", numbers)?;
                mesh.normals.values.push(normal.map(|number| number as f32));
            }
            ["mtllib", names @ ..] => mesh.libraries.push(names.join(" ")),
            _ => {}
        }
        Ok(())
    })?;
    // A face may name corners that follow it.
    let (mut places, mut before) = ([const { Vec::new() }; 3], [0; 3]);
    each_line(file, |words| {
        match words {
            ["usemtl", names @ ..] => {
                mesh.materials.push((mesh.triangles.len() as u32, names.join(" ")));
            }
            ["f", corners @ ..] => {
                places.iter_mut().for_each(Vec::clear);
                for corner in corners {
                    let mut numbers = corner.split('/');
                    for (list, places) in places.iter_mut().enumerate() {
                        let number = numbers.next().unwrap_or_default();
                        let is_none = number.is_empty() && list > 0;
                        places.push(match is_none {
                            true => Attribute::<3>::NONE,
                            false => place(corner, number, before[list], (all[list], list))?,
                        });
                    }
                }
                let [polygon, coordinates, normals] = &places;
                let first = mesh.push_polygon(file, polygon)?;
                if all[1] > 0 {
                    mesh.coordinates.places.extend(fan(coordinates, first));
                }
                if all[2] > 0 {
                    mesh.normals.places.extend(fan(normals, first));
                }
            }
            [word, ..] => count(word, &mut before),
            _ => {}
        }
        Ok(())
    })?;
    Ok(mesh)
}

/// The words of the lists that a face refers to, and what they hold.
const LISTS: [(&str, &str); 3] =
    [("v", "corners"), ("vt", "texture coordinates"), ("vn", "normals")];

/// Counts a line that begins with this word.
fn count(word: &str, counts: &mut [u64; 3]) {
    if let Some(list) = LISTS.iter().position(|(known, _)| *known == word) {
        counts[list] += 1;
    }
}

/// Passes the words of each line to `with`, without its comment; a line that ends in a backslash
/// continues in the next one.
fn each_line(file: &InputFile, mut with: impl FnMut(&[&str]) -> Result<()>) -> Result<()> {
    let (mut reader, _) = file.open_text()?;
    let mut line = Vec::new();
    let (mut number, mut first) = (0, 1);
    loop {
        let fault =
            |error: std::io::Error| broken(format!("it is not a complete OBJ file ({error})"));
        let start = line.len();
        let is_there = append_line(&mut reader, &mut line).map_err(fault)?;
        number += 1;
        let part = &line[start..];
        // A comment that ends in a backslash, like the name of a folder, continues nothing.
        if let Some(comment) = part.iter().position(|byte| *byte == b'#') {
            line.truncate(start + comment);
        } else if is_there && let Some(part) = part.trim_ascii_end().strip_suffix(b"\\") {
            line.truncate(start + part.len());
            line.push(b' ');
            continue;
        }
        // Names may be in any encoding.
        let text = String::from_utf8_lossy(&line);
        let words: Vec<&str> = text.split_whitespace().collect();
        with(&words).map_err(|error| error.of(format_args!("line {first}")))?;
        if !is_there {
            return Ok(());
        }
        line.clear();
        first = number + 1;
    }
}

/// The first numbers of a line that begins with `word`.
fn some<const N: usize>(word: &str, how_many: &str, numbers: &[&str]) -> Result<[f64; N]> {
    let wrong = || {
        broken(format!(
            "it is not a complete OBJ file (no {how_many} numbers in `{word} {}`)",
            numbers.join(" ")
        ))
    };
    let mut found = [0.0; N];
    for (k, number) in found.iter_mut().enumerate() {
        *number = numbers.get(k).and_then(|text| text.parse().ok()).ok_or_else(wrong)?;
    }
    Ok(found)
}

/// The index, from 0, of one of `all` things of a list that `corner` names by a number, of which
/// there are `before`.
fn place(corner: &str, number: &str, before: u64, (all, list): (u64, usize)) -> Result<u32> {
    let wrong = || {
        let what = format!("`{corner}` is not one of its {all} {}", LISTS[list].1);
        broken(format!("it is not a complete OBJ file ({what})"))
    };
    let number: i64 = number.parse().map_err(|_| wrong())?;
    let place = if number < 0 { number + before as i64 } else { number - 1 };
    let place = u32::try_from(place).map_err(|_| wrong())?;
    if u64::from(place) < all { Ok(place) } else { Err(wrong()) }
}

//! Wavefront files (.obj): corners, normals and faces, read line by line.

use crate::object::mesh_data::{Attribute, MOST, Mesh, append_line, broken, fan};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;

/// The triangles of a Wavefront file; polygons are cut into fans.
///
/// In `f 1/2/3` the first number is a corner and the last one a normal, both counted from 1, or
/// backward from the latest one if negative. Lines other than `v`, `vn` and `f` are ignored;
/// surfaces among them are counted in a warning.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    // Count first: a growing list takes three times the memory.
    let (mut all, mut triangles, mut surfaces) = ([0; 2], 0, 0);
    each_line(file, |words| {
        match words {
            ["v", ..] => all[0] += 1,
            ["vn", ..] => all[1] += 1,
            ["f", polygon @ ..] => triangles += (polygon.len() as u64).saturating_sub(2),
            ["surf" | "bzp" | "bsp" | "cdp", ..] => surfaces += 1,
            _ => {}
        }
        Ok(())
    })?;
    if surfaces > 0 {
        file.warn(format!("free-form surfaces are ignored: {surfaces}; export them as triangles"));
    }
    let mut mesh = Mesh::with_room(file, all[0], triangles)?;
    file.at_most(all[1], 3 * MOST, "normals")?;
    each_line(file, |words| {
        match words {
            ["v", numbers @ ..] => mesh.corners.push(three("v", numbers)?),
            ["vn", numbers @ ..] => {
                mesh.normals.values.push(three("vn", numbers)?.map(|number| number as f32));
            }
            _ => {}
        }
        Ok(())
    })?;
    // A face may name corners that follow it.
    let (mut polygon, mut normals, mut before) = (Vec::new(), Vec::new(), [0; 2]);
    each_line(file, |words| {
        match words {
            ["v", ..] => before[0] += 1,
            ["vn", ..] => before[1] += 1,
            ["f", corners @ ..] => {
                polygon.clear();
                normals.clear();
                for corner in corners {
                    let mut numbers = corner.split('/');
                    let number = numbers.next().unwrap_or_default();
                    polygon.push(place(corner, number, before[0], (all[0], "corners"))?);
                    let normal = match numbers.nth(1) {
                        None | Some("") => Attribute::<3>::NONE,
                        Some(number) => place(corner, number, before[1], (all[1], "normals"))?,
                    };
                    normals.push(normal);
                }
                let first = mesh.push_polygon(file, &polygon)?;
                if all[1] > 0 {
                    mesh.normals.places.extend(fan(&normals, first));
                }
            }
            _ => {}
        }
        Ok(())
    })?;
    Ok(mesh)
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

/// The three numbers of a line that begins with `word`.
fn three(word: &str, numbers: &[&str]) -> Result<[f64; 3]> {
    let wrong = || {
        broken(format!(
            "it is not a complete OBJ file (no three numbers in `{word} {}`)",
            numbers.join(" ")
        ))
    };
    let axis = |k: usize| numbers.get(k).and_then(|text| text.parse().ok()).ok_or_else(wrong);
    Ok([axis(0)?, axis(1)?, axis(2)?])
}

/// The index, from 0, of one of `all` things that `corner` names by a number, of which there are
/// `before`.
fn place(corner: &str, number: &str, before: i64, (all, things): (u64, &str)) -> Result<u32> {
    let wrong = || {
        let what = format!("`{corner}` is not one of its {all} {things}");
        broken(format!("it is not a complete OBJ file ({what})"))
    };
    let number: i64 = number.parse().map_err(|_| wrong())?;
    let place = if number < 0 { number + before } else { number - 1 };
    let place = u32::try_from(place).map_err(|_| wrong())?;
    if u64::from(place) < all { Ok(place) } else { Err(wrong()) }
}

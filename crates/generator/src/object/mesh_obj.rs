//! Wavefront files (.obj): corners and faces, read line by line.

use crate::object::mesh_data::{Mesh, append_line, broken};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::input_file::InputFile;

/// The triangles of a Wavefront file; polygons are cut into fans.
///
/// In `f 1/2/3` the first number is a corner, counted from 1, or backward from the latest corner if
/// it is negative. Lines other than `v` and `f` are ignored; surfaces among them are counted in a
/// warning.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    // Count first: a growing list takes three times the memory.
    let (mut corners, mut triangles, mut surfaces) = (0, 0, 0);
    each_line(file, |words| {
        match words {
            ["v", ..] => corners += 1,
            ["f", polygon @ ..] => triangles += (polygon.len() as u64).saturating_sub(2),
            ["surf" | "bzp" | "bsp" | "cdp", ..] => surfaces += 1,
            _ => {}
        }
        Ok(())
    })?;
    if surfaces > 0 {
        file.warn(format!("free-form surfaces are ignored: {surfaces}; export them as triangles"));
    }
    let mut mesh = Mesh::with_room(file, corners, triangles)?;
    each_line(file, |words| {
        if let ["v", numbers @ ..] = words {
            mesh.corners.push(corner(numbers)?);
        }
        Ok(())
    })?;
    // A face may name corners that follow it.
    let (mut polygon, mut before) = (Vec::new(), 0);
    each_line(file, |words| {
        match words {
            ["v", ..] => before += 1,
            ["f", numbers @ ..] => {
                polygon.clear();
                for number in numbers {
                    polygon.push(place(number, before, corners)?);
                }
                mesh.push_polygon(file, &polygon)?;
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

fn corner(numbers: &[&str]) -> Result<[f64; 3]> {
    let wrong = || {
        broken(format!(
            "it is not a complete OBJ file (no three numbers in `v {}`)",
            numbers.join(" ")
        ))
    };
    let axis = |k: usize| numbers.get(k).and_then(|text| text.parse().ok()).ok_or_else(wrong);
    Ok([axis(0)?, axis(1)?, axis(2)?])
}

/// The index of a corner, from 0, for `1`, `1/2`, `1//3`, `1/2/3` or `-1`.
fn place(text: &str, before: i64, all: u64) -> Result<u32> {
    let wrong = || {
        broken(format!("it is not a complete OBJ file (`{text}` is not one of its {all} corners)"))
    };
    let first = text.split('/').next().unwrap_or_default();
    let number: i64 = first.parse().map_err(|_| wrong())?;
    let place = if number < 0 { number + before } else { number - 1 };
    let place = u32::try_from(place).map_err(|_| wrong())?;
    if u64::from(place) < all { Ok(place) } else { Err(wrong()) }
}

//! Stereolithography files (.stl), text or binary.

use crate::object::mesh_data::{Mesh, append_line, broken};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::{InputFile, MARK};
use std::io::{BufRead, Read};

/// Size of the 80-byte header with the number of facets.
const HEAD: usize = 84;
/// Bytes for each facet.
const FACET: u64 = 50;

/// The triangles of an STL file; for text, those of all solids.
///
/// STL files share no corners: each facet has three of its own. The normals in the file are not
/// used and may be any numbers. Bytes after the last facet of a binary file cause a warning, unless
/// they are whole facets, which its header does not count.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    let (mut reader, found) = file.open()?;
    let mut head = Vec::with_capacity(HEAD);
    reader.by_ref().take(HEAD as u64).read_to_end(&mut head).map_err(io)?;
    let count = head.get(HEAD - 4..).and_then(|count| count.try_into().ok());
    let count = count.map_or(0, |count| u64::from(u32::from_le_bytes(count)));
    let expected = HEAD as u64 + FACET * count;
    if is_text(&head) && found != expected {
        // Count first: a growing list takes three times the memory.
        let mut facets = 0;
        each_facet(&mut file.open_text()?.0, |_| facets += 1)?;
        let mut mesh = Mesh::with_room(file, 3 * facets, facets)?;
        each_facet(&mut file.open_text()?.0, |corners| push(&mut mesh, corners))?;
        return Ok(mesh);
    }
    let after = found.saturating_sub(expected);
    if found < expected || head.len() < HEAD || (after > 0 && after.is_multiple_of(FACET)) {
        return Err(broken(format!("{expected} bytes promised by its header, {found} found")));
    }
    if after > 0 {
        file.warn(format!("bytes after its last facet are ignored: {after}"));
    }
    let mut mesh = Mesh::with_room(file, 3 * count, count)?;
    let mut facet = [0; FACET as usize];
    for _ in 0..count {
        reader.read_exact(&mut facet).map_err(io)?;
        // The normal, which is not needed, the corners, and two unused bytes.
        let numbers = facet[12..48].as_chunks::<4>().0;
        let at = |k: usize| f32::from_le_bytes(numbers[k]);
        push(&mut mesh, [0, 3, 6].map(|k| [at(k), at(k + 1), at(k + 2)]));
    }
    Ok(mesh)
}

fn push(mesh: &mut Mesh, corners: [[f32; 3]; 3]) {
    let first = mesh.corners.len() as u32;
    mesh.corners.extend(corners.map(|corner| corner.map(f64::from)));
    mesh.triangles.push([first, first + 1, first + 2]);
}

/// Whether a file with this beginning appears to be text.
///
/// The header of a binary file may also begin with the word `solid`. But its number of facets,
/// below 2^24, contains a zero byte, which text never does.
fn is_text(head: &[u8]) -> bool {
    let text = head.strip_prefix(MARK).unwrap_or(head).trim_ascii_start();
    let word = text.get(..5).unwrap_or_default();
    word.eq_ignore_ascii_case(b"solid") && !head.contains(&0)
}

/// The words of a facet's lines, without the numbers; a vertex line occurs three times. The numbers
/// of the normal are not read.
const LINES: [&[&str]; 7] = [
    &["facet", "normal"],
    &["outer", "loop"],
    &["vertex"],
    &["vertex"],
    &["vertex"],
    &["endloop"],
    &["endfacet"],
];

/// Passes the corners of each facet of a text file to `with`; letter case is ignored.
fn each_facet(reader: &mut impl BufRead, mut with: impl FnMut([[f32; 3]; 3])) -> Result<()> {
    let fault = |what: String| broken(format!("it is not a complete STL file ({what})"));
    let without_end = || fault("no `endsolid` at its end".to_owned());
    let (mut line, mut number) = (Vec::new(), 0);
    // The next line expected in the facet, and whether a solid is open.
    let (mut next, mut is_open) = (0, false);
    let mut corners = [[0.0f32; 3]; 3];
    while append_line(reader, &mut line).map_err(|error| fault(error.to_string()))? {
        number += 1;
        line.make_ascii_lowercase();
        // Names may be in any encoding.
        let text = String::from_utf8_lossy(&line);
        let text = text.trim();
        let words: Vec<&str> = text.split_whitespace().collect();
        // In a truncated file the last line is truncated too.
        let wrong = || match line.ends_with(b"\n") {
            true => fault(format!("line {number} is `{}`", short(text))),
            false => without_end(),
        };
        match words.first() {
            None => {}
            Some(&"solid") if next == 0 && !is_open => is_open = true,
            Some(&"endsolid") if next == 0 && is_open => is_open = false,
            _ => {
                let numbers = words.strip_prefix(LINES[next]).filter(|_| is_open);
                let numbers = numbers.ok_or_else(wrong)?;
                let expected = if matches!(next, 0 | 2..=4) { 3 } else { 0 };
                if numbers.len() != expected {
                    return Err(wrong());
                }
                if let 2..=4 = next {
                    for (value, number) in corners[next - 2].iter_mut().zip(numbers) {
                        *value = number.parse().map_err(|_| wrong())?;
                        if !value.is_finite() {
                            return Err(wrong().of("a number that is not finite"));
                        }
                    }
                }
                next = (next + 1) % LINES.len();
                if next == 0 {
                    with(corners);
                }
            }
        }
        line.clear();
    }
    if is_open || number == 0 {
        return Err(without_end());
    }
    Ok(())
}

/// The part of a line that a message quotes.
fn short(text: &str) -> String {
    text.chars().take(40).collect()
}

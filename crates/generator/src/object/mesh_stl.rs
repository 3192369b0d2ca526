//! Stereolithography files (.stl), text or binary.
//!
//! Read here, since `stl_io` 0.11.0 takes texts of small letters and one solid alone, and does
//! not see what follows them.

use crate::object::mesh::{Mesh, broken};
use crate::object::text_line;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::io::{BufRead, Read, Seek};

/// A header of 80 bytes, and the number of facets.
const HEAD: usize = 84;
/// Bytes of a facet.
const FACET: u64 = 50;

/// The triangles of an STL; all solids of a text.
///
/// Files share no corners: each facet has three of its own.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    let (mut reader, found) = file.open()?;
    let mut head = Vec::with_capacity(HEAD);
    reader.by_ref().take(HEAD as u64).read_to_end(&mut head).map_err(io)?;
    let count = head.get(HEAD - 4..).and_then(|count| count.try_into().ok());
    let count = count.map_or(0, |count| u64::from(u32::from_le_bytes(count)));
    let expected = HEAD as u64 + FACET * count;
    if is_text(&head) && found != expected {
        // Counted first: a list that grows takes three times its memory.
        let mut facets = 0;
        reader.rewind().map_err(io)?;
        each_facet(&mut reader, |_| facets += 1)?;
        reader.rewind().map_err(io)?;
        let mut mesh = Mesh::with_room(file, 3 * facets, facets)?;
        each_facet(&mut reader, |corners| push(&mut mesh, corners))?;
        return Ok(mesh);
    }
    if found != expected || head.len() < HEAD {
        return Err(broken(format!("{expected} bytes promised, {found} found")));
    }
    let mut mesh = Mesh::with_room(file, 3 * count, count)?;
    let mut facet = [0; FACET as usize];
    for _ in 0..count {
        reader.read_exact(&mut facet).map_err(io)?;
        // The normal, which nothing here needs, the corners, and two bytes of no meaning.
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

/// Whether a file that begins so seems to be a text.
///
/// Headers of binary files may begin with that word too; but the number of facets, below
/// 2^24, has a zero byte, and no text has.
fn is_text(head: &[u8]) -> bool {
    let text = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head).trim_ascii_start();
    let word = text.get(..5).unwrap_or_default();
    word.eq_ignore_ascii_case(b"solid") && !head.contains(&0)
}

/// The words of a facet but for its numbers, line by line; three of a vertex.
const LINES: [&[&str]; 7] = [
    &["facet", "normal"],
    &["outer", "loop"],
    &["vertex"],
    &["vertex"],
    &["vertex"],
    &["endloop"],
    &["endfacet"],
];

/// Gives the corners of each facet of a text; words may be of capital letters.
fn each_facet(reader: &mut impl BufRead, mut with: impl FnMut([[f32; 3]; 3])) -> Result<()> {
    let fault = |what: String| broken(format!("it is no whole STL ({what})"));
    let without_end = || fault("no `endsolid` at its end".to_owned());
    let (mut line, mut number) = (Vec::new(), 0);
    // The next line of the facet, and whether a solid has begun and not ended.
    let (mut next, mut is_open) = (0, false);
    let mut corners = [[0.0; 3]; 3];
    while text_line::append(reader, &mut line).map_err(|error| fault(error.to_string()))? {
        number += 1;
        line.make_ascii_lowercase();
        // Names may be in any encoding.
        let text = String::from_utf8_lossy(&line);
        let text = text.trim_start_matches('\u{feff}').trim();
        let words: Vec<&str> = text.split_whitespace().collect();
        // Of a file that was cut short the last line is cut too.
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
                let mut vector = [0.0f32; 3];
                for (value, number) in vector.iter_mut().zip(numbers) {
                    *value = number.parse().map_err(|_| wrong())?;
                    if !value.is_finite() {
                        return Err(wrong().of("a number that is not finite"));
                    }
                }
                if let 2..=4 = next {
                    corners[next - 2] = vector;
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

/// What a message quotes of a line.
fn short(text: &str) -> String {
    text.chars().take(40).collect()
}

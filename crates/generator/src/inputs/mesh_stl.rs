//! Stereolithography files (.stl), text or binary.

use super::mesh::{Triangles, broken};
use crate::error::Result;
use std::io::Cursor;

/// A header of 80 bytes, and the number of facets.
const HEAD: usize = 84;
/// Bytes of a facet.
const FACET: u64 = 50;

/// The triangles of an STL; all solids of a text.
pub(crate) fn read(mut bytes: Vec<u8>) -> Result<Triangles> {
    let count = bytes.get(HEAD - 4..HEAD).and_then(|count| count.try_into().ok());
    let count = count.map(u32::from_le_bytes).map_or(0, u64::from);
    let (expected, found) = (HEAD as u64 + FACET * count, bytes.len() as u64);
    if let Some(text) = text(&bytes)
        && found != expected
    {
        return triangles(whole(text)?.as_bytes());
    }
    if found < expected {
        return Err(broken(format!("{expected} bytes promised, {found} found")));
    }
    // The header means nothing, but one that begins with `solid` the library takes for a text.
    bytes[..HEAD - 4].fill(0);
    triangles(&bytes)
}

/// The bytes from `solid` on, if they seem to be a text.
///
/// Headers of binary files may begin with that word too; but the number of facets, below
/// 2^24, has a zero byte, and no text has.
fn text(bytes: &[u8]) -> Option<&[u8]> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let word = bytes.get(..5)?;
    let has_zero = bytes.iter().take(HEAD).any(|&byte| byte == 0);
    (word.eq_ignore_ascii_case(b"solid") && !has_zero).then_some(bytes)
}

/// One solid in lower case without a name, as the library reads it.
fn whole(text: &[u8]) -> Result<String> {
    let text = String::from_utf8_lossy(text).to_ascii_lowercase();
    let is_frame = |line: &str, words: &[&str]| {
        line.split_whitespace().next().is_some_and(|word| words.contains(&word))
    };
    let last = text.trim_end().lines().next_back().unwrap_or_default();
    if !is_frame(last, &["endsolid"]) {
        return Err(broken("it is no whole STL (no `endsolid` at its end)"));
    }
    let mut one = "solid mesh\n".to_owned();
    for line in text.lines().filter(|line| !is_frame(line, &["solid", "endsolid"])) {
        one.push_str(line);
        one.push('\n');
    }
    one.push_str("endsolid\n");
    Ok(one)
}

fn triangles(bytes: &[u8]) -> Result<Triangles> {
    let mesh = stl_io::create_stl_reader(&mut Cursor::new(bytes))
        .and_then(Iterator::collect::<std::io::Result<Vec<_>>>)
        .map_err(|error| broken(format!("it is no whole STL ({error})")))?;
    Ok(mesh.iter().map(|facet| facet.vertices.map(|corner| corner.0.map(f64::from))).collect())
}

//! Polygon files (.ply), text or binary.
//!
//! `ply-rs-bw` reads the header and binary elements. Elements in text are read here: its grammar
//! has neither `.5` nor `nan`.

use crate::object::mesh_data::{LONGEST_LINE, Mesh, append_line, broken};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::srgb::linear;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    BeginList, ElementDef, Encoding, Header, PropertyAccess, PropertyAccessResult, PropertyType,
    ScalarType,
};
use std::io::{self, BufRead, ErrorKind};

/// Largest number of entries in a list of any type.
const MOST_NUMBERS: usize = LONGEST_LINE;

/// The triangles of a polygon file; polygons are cut into fans, and triangle strips (`tristrips`)
/// into triangles. Bytes after the last element of a binary file cause a warning.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    let (reader, length) = file.open_text()?;
    decode(reader, length, file)
}

fn decode(mut reader: impl BufRead, length: u64, file: &InputFile) -> Result<Mesh> {
    let header = header(&mut reader).map_err(fault)?;
    let mut least = 0u64;
    for (name, element) in &header.elements {
        // A number takes at least one byte, a face at least four: the number of corners and three
        // corners.
        let row = element.properties.len() + if name == "face" { 3 } else { 0 };
        least = least.saturating_add((element.count as u64).saturating_mul(row as u64));
        if least > length || element.properties.is_empty() {
            return Err(broken(format!(
                "{} of element `{name}` promised by its header in {length} bytes",
                element.count
            )));
        }
    }
    let count = |name: &str| header.elements.get(name).map_or(0, |element| element.count as u64);
    let mut mesh = Mesh::with_room(file, count("vertex"), count("face"))?;
    let place = |name: &str| header.elements.get_index_of(name);
    for facets in ["face", "tristrips"] {
        if place(facets).is_some() && place(facets) < place("vertex") {
            return Err(broken(format!("its element `{facets}` comes before its vertices")));
        }
    }
    let mut rows =
        Rows { reader: Reader::new(reader), encoding: header.encoding, line: Vec::new() };
    for (name, element) in &header.elements {
        for number in 1..=element.count {
            let mut push = || {
                let row = rows.next(element).map_err(fault)?;
                match name.as_str() {
                    "vertex" => {
                        mesh.corners.push(row.corner()?);
                        if let [Some(x), Some(y), Some(z)] = row.normal {
                            mesh.normals.values.push([x, y, z]);
                        }
                        if let [Some(r), Some(g), Some(b), a] = row.color {
                            mesh.colors.values.push([r, g, b, a.unwrap_or(1.0)]);
                        }
                    }
                    "face" => {
                        let corners = row.corners()?.iter().map(|number| corner(*number));
                        mesh.push_polygon(file, &corners.collect::<Result<Vec<_>>>()?)?;
                    }
                    "tristrips" => push_strips(&mut mesh, file, row.corners()?)?,
                    _ => {}
                }
                Ok(())
            };
            let place = format_args!("row {number} of {} of element `{name}`", element.count);
            push().map_err(|error: Error| error.of(place))?;
        }
    }
    rows.finish(file)?;
    Ok(mesh)
}

/// Adds the triangles of strips, with -1 between one strip and the next. Each corner makes a
/// triangle with the two before it, whose order alternates. A strip repeats a corner to turn, which
/// makes a triangle without an area.
fn push_strips(mesh: &mut Mesh, file: &InputFile, strips: &[f64]) -> Result<()> {
    for strip in strips.split(|number| *number == -1.0) {
        for (number, window) in strip.windows(3).enumerate() {
            let [a, b, c] = [0, 1, 2].map(|k| corner(window[k]));
            let (a, b) = if number % 2 == 0 { (a?, b?) } else { (b?, a?) };
            mesh.push_polygon(file, &[a, b, c?])?;
        }
    }
    Ok(())
}

/// The index of a corner.
fn corner(number: f64) -> Result<u32> {
    let place = number as u32;
    let missing = || broken(format!("corner {number} does not exist"));
    (f64::from(place) == number).then_some(place).ok_or_else(missing)
}

/// Reads the header, whose comments may be in any encoding.
fn header(reader: &mut impl BufRead) -> std::result::Result<Header, ParseError> {
    let (mut lines, mut line) = (Vec::new(), Vec::new());
    loop {
        line.clear();
        let goes_on = append_line(reader, &mut line)?;
        lines.extend_from_slice(&line);
        if !goes_on || !lines.starts_with(b"ply") || line.starts_with(b"end_header") {
            break;
        }
    }
    let text = String::from_utf8_lossy(&lines);
    Parser::<Element>::new().read_header(&mut Reader::new(text.as_bytes()))
}

fn fault(error: ParseError) -> Error {
    let text = match error.kind() {
        ErrorKind::UnexpectedEof => "it ends too early".to_owned(),
        _ => error.to_string(),
    };
    broken(format!("it is not a complete PLY file ({})", text.lines().next().unwrap_or_default()))
}

/// Reads the elements of a file one after another.
struct Rows<R: BufRead> {
    reader: Reader<R>,
    encoding: Encoding,
    line: Vec<u8>,
}

impl<R: BufRead> Rows<R> {
    fn next(&mut self, element: &ElementDef) -> std::result::Result<Element, ParseError> {
        let (parser, reader) = (Parser::<Element>::new(), self.reader.get_mut());
        match self.encoding {
            Encoding::BinaryBigEndian => parser.read_big_endian_element(reader, element),
            Encoding::BinaryLittleEndian => parser.read_little_endian_element(reader, element),
            Encoding::Ascii => {
                self.line.clear();
                while self.line.trim_ascii().is_empty() {
                    self.line.clear();
                    if !append_line(reader, &mut self.line)? {
                        return Err(io::Error::from(ErrorKind::UnexpectedEof).into());
                    }
                }
                let row = row_of_text(&String::from_utf8_lossy(&self.line), element);
                // In a truncated file the last line is truncated too.
                let kind = match self.line.ends_with(b"\n") {
                    true => ErrorKind::InvalidData,
                    false => ErrorKind::UnexpectedEof,
                };
                row.map_err(|what| io::Error::new(kind, what).into())
            }
        }
    }

    /// Checks that nothing follows except empty lines of a text file; bytes after a binary one are
    /// ignored with a warning.
    fn finish(mut self, file: &InputFile) -> Result<()> {
        let reader = self.reader.get_mut();
        loop {
            let rest = reader
                .fill_buf()
                .map_err(|error| broken(format!("it is not a complete PLY file ({error})")))?;
            if rest.is_empty() {
                return Ok(());
            }
            if self.encoding != Encoding::Ascii {
                file.warn("bytes after its last element are ignored");
                return Ok(());
            }
            if !rest.trim_ascii().is_empty() {
                return Err(broken("more follows than its header promises"));
            }
            let read = rest.len();
            reader.consume(read);
        }
    }
}

/// One element in text. The error is the fault.
fn row_of_text(line: &str, element: &ElementDef) -> std::result::Result<Element, String> {
    let mut words = line.split_ascii_whitespace();
    let mut row = Element::new();
    let missing = || "it has too few numbers".to_owned();
    let number = |word: &str| word.parse::<f64>().map_err(|_| format!("`{word}` is not a number"));
    for (name, property) in &element.properties {
        let first = words.next().ok_or_else(missing)?;
        match &property.data_type {
            PropertyType::Scalar(kind) => {
                let number = number(first)?;
                let set = row.set_double(name, number);
                if let Some(channel) = COLORS.iter().position(|channel| *channel == name) {
                    row.color[channel] = Some(share(number, full(kind), channel == 3));
                }
                set
            }
            PropertyType::List(..) => {
                let count =
                    first.parse().map_err(|_| format!("`{first}` is not a number of corners"))?;
                let list = words.by_ref().take(count).map(number);
                let list = list.collect::<std::result::Result<Vec<_>, _>>()?;
                if list.len() < count {
                    return Err(missing());
                }
                row.set_list_double(name, list)
            }
        };
    }
    words.next().map_or(Ok(row), |word| Err(format!("`{word}` follows its last number")))
}

/// The properties of a vertex and of a face, where present.
#[derive(Default)]
struct Element {
    /// x, y and z.
    corner: [Option<f64>; 3],
    /// nx, ny and nz.
    normal: [Option<f32>; 3],
    /// red, green and blue, linear, and alpha.
    color: [Option<f32>; 4],
    /// The list of corners.
    list: Option<Vec<f64>>,
}

impl Element {
    fn corner(&self) -> Result<[f64; 3]> {
        let number = |axis: usize, name| {
            self.corner[axis].ok_or_else(|| broken(format!("a vertex has no number `{name}`")))
        };
        Ok([number(0, "x")?, number(1, "y")?, number(2, "z")?])
    }

    /// The indices of corners; -1 separates strips.
    fn corners(&self) -> Result<&[f64]> {
        self.list.as_deref().ok_or_else(|| broken("a face has no list `vertex_indices`"))
    }
}

const COLORS: [&str; 4] = ["red", "green", "blue", "alpha"];

/// The linear value of a channel: integers up to `full` are in sRGB, unless they are opacities.
fn share(number: f64, full: Option<f64>, is_opacity: bool) -> f32 {
    let share = (number / full.unwrap_or(1.0)).clamp(0.0, 1.0);
    (if full.is_some() && !is_opacity { linear(share) } else { share }) as f32
}

/// The largest number of a type of integers.
fn full(kind: &ScalarType) -> Option<f64> {
    Some(match kind {
        ScalarType::Char => f64::from(i8::MAX),
        ScalarType::UChar => f64::from(u8::MAX),
        ScalarType::Short => f64::from(i16::MAX),
        ScalarType::UShort => f64::from(u16::MAX),
        ScalarType::Int => f64::from(i32::MAX),
        ScalarType::UInt => f64::from(u32::MAX),
        ScalarType::Float | ScalarType::Double => return None,
    })
}

/// Functions of [`Element`] that take numbers and lists of each type; too long a list is an error.
macro_rules! setters {
    ($($set:ident, $begin_list:ident, $set_list:ident: $number:ty, $kind:ident;)*) => {
        $(fn $set(&mut self, name: &str, number: $number) -> PropertyAccessResult {
            if let Some(axis) = ["x", "y", "z"].iter().position(|axis| *axis == name) {
                self.corner[axis] = Some(f64::from(number));
            } else if let Some(axis) = ["nx", "ny", "nz"].iter().position(|axis| *axis == name) {
                self.normal[axis] = Some(f64::from(number) as f32);
            } else if let Some(channel) = COLORS.iter().position(|channel| *channel == name) {
                self.color[channel] = Some(share(f64::from(number), full(&ScalarType::$kind), channel == 3));
            }
            PropertyAccessResult::Set
        }

        fn $begin_list(&mut self, _: &str, count: usize) -> BeginList<'_, $number> {
            if count <= MOST_NUMBERS { BeginList::UseSetter } else { BeginList::UnsupportedType }
        }

        fn $set_list(&mut self, name: &str, list: Vec<$number>) -> PropertyAccessResult {
            if let "vertex_indices" | "vertex_index" = name {
                self.list = Some(list.into_iter().map(f64::from).collect());
            }
            PropertyAccessResult::Set
        })*
    };
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self::default()
    }

    setters! {
        set_char, begin_list_char, set_list_char: i8, Char;
        set_uchar, begin_list_uchar, set_list_uchar: u8, UChar;
        set_short, begin_list_short, set_list_short: i16, Short;
        set_ushort, begin_list_ushort, set_list_ushort: u16, UShort;
        set_int, begin_list_int, set_list_int: i32, Int;
        set_uint, begin_list_uint, set_list_uint: u32, UInt;
        set_float, begin_list_float, set_list_float: f32, Float;
        set_double, begin_list_double, set_list_double: f64, Double;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_of_any_type() {
        type Bytes = fn(u8) -> Vec<u8>;
        let kinds: [(&str, Bytes); 8] = [
            ("char", |n| vec![n]),
            ("uchar", |n| vec![n]),
            ("short", |n| i16::from(n).to_le_bytes().into()),
            ("ushort", |n| u16::from(n).to_le_bytes().into()),
            ("int", |n| i32::from(n).to_le_bytes().into()),
            ("uint", |n| u32::from(n).to_le_bytes().into()),
            ("float", |n| f32::from(n).to_le_bytes().into()),
            ("double", |n| f64::from(n).to_le_bytes().into()),
        ];
        for (kind, bytes) in kinds {
            let header = format!(
                "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty {kind} x\n\
                 property {kind} y\nproperty {kind} z\nelement face 1\n\
                 property list uchar {kind} vertex_indices\nend_header\n"
            );
            let corners = [[0u8, 0, 1], [100, 0, 2], [0, 120, 3]];
            let numbers = corners.as_flattened().iter().flat_map(|&n| bytes(n));
            let list = [3].into_iter().chain([0, 1, 2].into_iter().flat_map(bytes));
            let file: Vec<u8> = header.bytes().chain(numbers).chain(list).collect();
            let mesh = decode(&file[..], file.len() as u64, &"mesh.ply".into()).expect("a mesh");
            let corners = corners.map(|corner| corner.map(f64::from));
            assert_eq!((mesh.corners, mesh.triangles), (corners.into(), vec![[0, 1, 2]]), "{kind}");
        }
    }
}

//! Polygon files (.ply), text or binary.
//!
//! `ply-rs-bw` reads the header and binary elements. Elements in text are read here: its grammar
//! has neither `.5` nor `nan`, which files have for numbers that are not used.

use crate::object::mesh_data::{LONGEST_LINE, Mesh, append_line, broken};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    BeginList, ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult,
    PropertyType,
};
use std::io::{self, BufRead, ErrorKind};

/// Largest number of entries in a list of any type.
const MOST_NUMBERS: usize = LONGEST_LINE;

/// Accepts lists as they come, unless they are too long.
macro_rules! bounded_lists {
    ($($begin:ident: $number:ty),*) => {
        $(fn $begin(&mut self, _: &str, count: usize) -> BeginList<'_, $number> {
            if count <= MOST_NUMBERS { BeginList::UseSetter } else { BeginList::UnsupportedType }
        })*
    };
}

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
                    "vertex" => mesh.corners.push(row.corner()?),
                    "face" => {
                        let corners = row.corners()?.into_iter().map(corner);
                        mesh.push_polygon(file, &corners.collect::<Result<Vec<_>>>()?)?;
                    }
                    "tristrips" => push_strips(&mut mesh, file, &row.corners()?)?,
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
fn push_strips(mesh: &mut Mesh, file: &InputFile, strips: &[i64]) -> Result<()> {
    for strip in strips.split(|place| *place == -1) {
        for (number, window) in strip.windows(3).enumerate() {
            let [a, b, c] = [0, 1, 2].map(|k| corner(window[k]));
            let (a, b) = if number % 2 == 0 { (a?, b?) } else { (b?, a?) };
            mesh.push_polygon(file, &[a, b, c?])?;
        }
    }
    Ok(())
}

/// The index of a corner.
fn corner(value: i64) -> Result<u32> {
    u32::try_from(value).map_err(|_| broken(format!("corner {value} does not exist")))
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
        row.set_property(
            name,
            match property.data_type {
                PropertyType::Scalar(_) => Property::Double(number(first)?),
                PropertyType::List(..) => {
                    let count = first
                        .parse()
                        .map_err(|_| format!("`{first}` is not a number of corners"))?;
                    let list = words.by_ref().take(count).map(number);
                    let list = list.collect::<std::result::Result<Vec<_>, _>>()?;
                    if list.len() < count {
                        return Err(missing());
                    }
                    Property::ListDouble(list)
                }
            },
        );
    }
    words.next().map_or(Ok(row), |word| Err(format!("`{word}` follows its last number")))
}

/// The properties of a vertex and of a face, where present.
struct Element {
    /// x, y and z.
    corner: [Option<f64>; 3],
    /// The list of corners.
    list: Option<Property>,
}

impl Element {
    fn corner(&self) -> Result<[f64; 3]> {
        let number = |axis: usize, name| {
            self.corner[axis].ok_or_else(|| broken(format!("a vertex has no number `{name}`")))
        };
        Ok([number(0, "x")?, number(1, "y")?, number(2, "z")?])
    }

    /// The indices of corners; -1 separates strips.
    fn corners(self) -> Result<Vec<i64>> {
        fn all<T: Into<i64>>(list: Vec<T>) -> Vec<i64> {
            list.into_iter().map(Into::into).collect()
        }
        Ok(match self.list {
            Some(Property::ListInt(list)) => all(list),
            Some(Property::ListShort(list)) => all(list),
            Some(Property::ListChar(list)) => all(list),
            Some(Property::ListUInt(list)) => all(list),
            Some(Property::ListUShort(list)) => all(list),
            Some(Property::ListUChar(list)) => all(list),
            // Any list in text.
            Some(Property::ListDouble(list)) if list.iter().all(|one| one.fract() == 0.0) => {
                list.into_iter().map(|one| one as i64).collect()
            }
            _ => return Err(broken("a face has no list `vertex_indices`")),
        })
    }
}

impl PropertyAccess for Element {
    fn new() -> Self {
        Self { corner: [None; 3], list: None }
    }

    bounded_lists!(
        begin_list_char: i8, begin_list_uchar: u8, begin_list_short: i16, begin_list_ushort: u16,
        begin_list_int: i32, begin_list_uint: u32, begin_list_float: f32, begin_list_double: f64
    );

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let axis = match name {
            "x" => 0,
            "y" => 1,
            "z" => 2,
            "vertex_indices" | "vertex_index" => {
                self.list = Some(property);
                return PropertyAccessResult::Set;
            }
            _ => return PropertyAccessResult::Ignored,
        };
        self.corner[axis] = match property {
            Property::Float(value) => Some(f64::from(value)),
            Property::Double(value) => Some(value),
            Property::Int(value) => Some(f64::from(value)),
            Property::UInt(value) => Some(f64::from(value)),
            Property::Short(value) => Some(f64::from(value)),
            Property::UShort(value) => Some(f64::from(value)),
            Property::Char(value) => Some(f64::from(value)),
            Property::UChar(value) => Some(f64::from(value)),
            _ => None,
        };
        PropertyAccessResult::Set
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_of_any_type() {
        for kind in ["char", "uchar", "short", "ushort", "int", "uint", "float", "double"] {
            let text = format!(
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty {kind} x\nproperty {kind} y\n\
                 property {kind} z\nelement face 1\nproperty list uchar int vertex_indices\n\
                 end_header\n0 0 1\n100 0 2\n0 120 3\n3 0 1 2\n"
            );
            let corners = [[0.0, 0.0, 1.0], [100.0, 0.0, 2.0], [0.0, 120.0, 3.0]];
            let file = "mesh.ply".into();
            let mesh = decode(text.as_bytes(), text.len() as u64, &file).expect("a mesh");
            assert_eq!(
                (mesh.corners, mesh.triangles),
                (corners.to_vec(), vec![[0, 1, 2]]),
                "{kind}"
            );
        }
    }
}

//! Polygon files (.ply), text or binary.

use crate::object::mesh_data::{LONGEST_LINE, Mesh, append_line, broken};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    BeginList, ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult,
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

/// The triangles of a polygon file; polygons are cut into fans.
pub(crate) fn read(file: &InputFile) -> Result<Mesh> {
    let (reader, length) = file.open()?;
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
    if place("face") < place("vertex") && place("face").is_some() {
        return Err(broken("its faces come before its vertices"));
    }
    let mut rows =
        Rows { reader: Reader::new(reader), encoding: header.encoding, line: Vec::new() };
    for (name, element) in &header.elements {
        for number in 1..=element.count {
            let mut push = || {
                let row = rows.next(element).map_err(fault)?;
                match name.as_str() {
                    "vertex" => mesh.corners.push(row.corner()?),
                    "face" => mesh.push_polygon(file, &row.corners()?)?,
                    _ => {}
                }
                Ok(())
            };
            let place = format_args!("row {number} of {} of element `{name}`", element.count);
            push().map_err(|error: Error| error.of(place))?;
        }
    }
    rows.finish()?;
    Ok(mesh)
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
                append_line(reader, &mut self.line)?;
                let row = parser.read_ascii_element(&String::from_utf8_lossy(&self.line), element);
                // In a truncated file the last line is truncated too.
                let is_cut = !self.line.ends_with(b"\n");
                let cut = || io::Error::from(ErrorKind::UnexpectedEof).into();
                row.map_err(|error| if is_cut { cut() } else { error })
            }
        }
    }

    /// Checks that nothing follows except empty lines of a text file.
    fn finish(mut self) -> Result<()> {
        let reader = self.reader.get_mut();
        loop {
            let rest = reader
                .fill_buf()
                .map_err(|error| broken(format!("it is not a complete PLY file ({error})")))?;
            if rest.is_empty() {
                return Ok(());
            }
            if self.encoding != Encoding::Ascii || !rest.trim_ascii().is_empty() {
                return Err(broken("more follows than its header promises"));
            }
            let read = rest.len();
            reader.consume(read);
        }
    }
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

    fn corners(self) -> Result<Vec<u32>> {
        let place = |value: i64| {
            u32::try_from(value).map_err(|_| broken(format!("corner {value} does not exist")))
        };
        match self.list {
            Some(Property::ListInt(list)) => list.iter().map(|&one| place(one.into())).collect(),
            Some(Property::ListShort(list)) => list.iter().map(|&one| place(one.into())).collect(),
            Some(Property::ListChar(list)) => list.iter().map(|&one| place(one.into())).collect(),
            Some(Property::ListUInt(list)) => Ok(list),
            Some(Property::ListUShort(list)) => Ok(list.into_iter().map(u32::from).collect()),
            Some(Property::ListUChar(list)) => Ok(list.into_iter().map(u32::from).collect()),
            _ => Err(broken("a face has no list `vertex_indices`")),
        }
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

//! Polygon files (.ply), text or binary.

use super::mesh::{Triangles, broken};
use crate::error::Result;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, Property};
use std::io::Cursor;

/// The triangles of a polygon file; polygons are cut into fans.
pub(crate) fn read(bytes: &[u8]) -> Result<Triangles> {
    let fault = |error: ParseError| {
        let text = error.to_string();
        broken(format!("it is no whole PLY ({})", text.lines().next().unwrap_or_default()))
    };
    let parser = Parser::<DefaultElement>::new();
    let mut reader = Reader::new(Cursor::new(bytes));
    let header = parser.read_header(&mut reader).map_err(fault)?;
    let mut least = 0usize;
    for (name, element) in &header.elements {
        // A number takes a byte at least, a face four: how many corners, and three of them.
        let row = element.properties.len() + if name == "face" { 3 } else { 0 };
        least = least.saturating_add(element.count.saturating_mul(row));
        if least > bytes.len() || element.properties.is_empty() {
            return Err(broken(format!(
                "{} of element `{name}` promised in {} bytes",
                element.count,
                bytes.len()
            )));
        }
    }
    let payload = parser.read_payload(&mut reader, &header).map_err(fault)?;
    let of = |name: &str| payload.get(name).map(Vec::as_slice).unwrap_or_default();
    let corners = of("vertex").iter().map(corner).collect::<Result<Vec<_>>>()?;
    let mut triangles = Vec::new();
    for face in of("face") {
        let places = indices(face)?;
        let at = |place: usize| {
            corners
                .get(place)
                .copied()
                .ok_or_else(|| broken(format!("corner {place} does not exist")))
        };
        for two in places.get(1..).unwrap_or_default().windows(2) {
            triangles.push([at(places[0])?, at(two[0])?, at(two[1])?]);
        }
    }
    Ok(triangles)
}

fn corner(vertex: &DefaultElement) -> Result<[f64; 3]> {
    let axis = |name: &str| match vertex.get(name) {
        Some(Property::Float(value)) => Ok(f64::from(*value)),
        Some(Property::Double(value)) => Ok(*value),
        Some(Property::Int(value)) => Ok(f64::from(*value)),
        Some(Property::UInt(value)) => Ok(f64::from(*value)),
        Some(Property::Short(value)) => Ok(f64::from(*value)),
        Some(Property::UShort(value)) => Ok(f64::from(*value)),
        Some(Property::Char(value)) => Ok(f64::from(*value)),
        Some(Property::UChar(value)) => Ok(f64::from(*value)),
        _ => Err(broken(format!("a vertex has no number `{name}`"))),
    };
    Ok([axis("x")?, axis("y")?, axis("z")?])
}

fn indices(face: &DefaultElement) -> Result<Vec<usize>> {
    let list = face.get("vertex_indices").or_else(|| face.get("vertex_index"));
    let signed = |value: i64| usize::try_from(value).map_err(|_| broken("a negative corner"));
    match list {
        Some(Property::ListInt(list)) => list.iter().map(|&one| signed(one.into())).collect(),
        Some(Property::ListShort(list)) => list.iter().map(|&one| signed(one.into())).collect(),
        Some(Property::ListChar(list)) => list.iter().map(|&one| signed(one.into())).collect(),
        Some(Property::ListUInt(list)) => list.iter().map(|&one| Ok(one as usize)).collect(),
        Some(Property::ListUShort(list)) => list.iter().map(|&one| Ok(one.into())).collect(),
        Some(Property::ListUChar(list)) => list.iter().map(|&one| Ok(one.into())).collect(),
        _ => Err(broken("a face has no list `vertex_indices`")),
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
            assert_eq!(read(text.as_bytes()), Ok(vec![corners]), "{kind}");
        }
    }
}

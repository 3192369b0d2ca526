//! Descriptions of packed objects, with and without shadows.

use crate::description::Description;
use eigenshade::object::{Object, ShadowedObject, TexturedObject};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::{light, object, shadowed};

/// Describes a packed object, or returns `None` for other files. Fails if the runtime refuses the bytes.
pub fn description(bytes: &[u8]) -> Option<Result<Description>> {
    let refused = |_| {
        Error::new("it is cut or damaged", "pack the object again with `eigenshade pack-object`")
    };
    if bytes.starts_with(&shadowed::MAGIC) {
        return Some(ShadowedObject::new(bytes).map(|_| with_shadows(bytes)).map_err(refused));
    }
    if bytes.starts_with(&shadowed::TINTED_MAGIC) {
        return Some(TexturedObject::new(bytes).map(|_| with_shadows(bytes)).map_err(refused));
    }
    if bytes.starts_with(&object::MAGIC) {
        return Some(Object::new(bytes).map(|_| without_shadows(bytes)).map_err(refused));
    }
    None
}

/// The number of 16 bits at a place.
fn word(bytes: &[u8], place: usize) -> usize {
    usize::from(u16::from_le_bytes([bytes[place], bytes[place + 1]]))
}

/// The size in pixels, which follows the magic bytes.
fn size(bytes: &[u8]) -> String {
    format!("{} x {}", word(bytes, 6), word(bytes, 8))
}

/// The bytes of the rows of pixels at a place: `height` + 1 numbers, and as many records as the last
/// one says.
fn rows(bytes: &[u8], place: usize, record: usize) -> usize {
    let last = place + 4 * word(bytes, 8);
    let records = word(bytes, last) + (word(bytes, last + 2) << 16);
    last + 4 + record * records - place
}

fn with_shadows(bytes: &[u8]) -> Description {
    let [codes, clusters] = [10, 12].map(|place| word(bytes, place));
    let [degree, parts, rank, images] = [14, 15, 16, 17].map(|place| usize::from(bytes[place]));
    let header = 18;
    let shares = 6 * parts;
    let of_light = parts * rank * (degree + 2 + light::count(degree));
    let mut end = header + shares + of_light;
    let start = end;
    for _ in 0..clusters {
        let count = word(bytes, end);
        end += 2 + 1 + images + 2 * rank + images * rank + images * count;
    }
    let pixels = rows(bytes, end, 2);
    let mut found = Description::default();
    let is_tinted = bytes.starts_with(&shadowed::TINTED_MAGIC);
    let materials = if is_tinted { ", in its own materials" } else { "" };
    found.field("object", format!("with shadows{materials}"));
    found.field("version", bytes[5]);
    found.field("size", size(bytes));
    found.field("degree", degree);
    found.field("parts of the material", parts);
    found.field("rank", rank);
    found.field("codes", codes);
    found.field("clusters", clusters);
    found.field("images of a cluster", images);
    found.part("header", header);
    found.part("shares of the parts", shares);
    found.part("rows of the light", of_light);
    found.part("codes in clusters", end - start);
    found.part("pixels", pixels);
    found.part("file", end + pixels);
    found
}

fn without_shadows(bytes: &[u8]) -> Description {
    let regions = word(bytes, 10);
    let (header, of_regions) = (12, object::RECORD * regions);
    let pixels = rows(bytes, header + of_regions, object::RECORD);
    let mut found = Description::default();
    found.field("object", "in its own materials");
    found.field("version", bytes[5]);
    found.field("size", size(bytes));
    found.field("regions", regions);
    found.part("header", header);
    found.part("regions", of_regions);
    found.part("pixels", pixels);
    found.part("file", header + of_regions + pixels);
    found
}

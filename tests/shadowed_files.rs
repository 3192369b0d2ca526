//! Files of objects with shadows: what is refused.

use crate::shadowed_objects::small;
use crate::textured_objects::small_textured;
use eigenshade::Error;
use eigenshade::object::{ShadowedObject, TexturedObject};
use eigenshade_table::shadowed::File;

#[test]
fn cut_files_are_refused_and_bytes_after_them_ignored() {
    let bytes = small().encode();
    for length in 0..bytes.len() {
        assert_eq!(ShadowedObject::new(&bytes[..length]), Err(Error::Object), "{length}");
    }
    let object = ShadowedObject::new(&bytes).unwrap();
    assert_eq!([object.width(), object.height(), object.codes(), object.degree()], [4, 2, 3, 0]);
    let longer = [&bytes[..], &[0xff; 101]].concat();
    assert_eq!(ShadowedObject::new(&longer), Ok(object));
}

#[test]
fn wrong_files_of_base_colors_are_refused() {
    let bytes = small_textured().encode();
    for length in 0..bytes.len() {
        assert_eq!(TexturedObject::new(&bytes[..length]), Err(Error::Object), "{length}");
    }
    let object = TexturedObject::new(&bytes).unwrap();
    assert_eq!(TexturedObject::new(&[&bytes[..], &[0xff; 101]].concat()), Ok(object));
    // Neither is the other.
    assert_eq!(ShadowedObject::new(&bytes), Err(Error::Object));
    assert_eq!(TexturedObject::new(&small().encode()), Err(Error::Object));
    let words = small().encode().len() - 22;
    // A run of two pixels, one of the rim, and one in the next row.
    assert_eq!(bytes.len(), words + 2 * (2 + 2 * 4 + 2 + 4 + 2 + 4));
    let places = [
        (5, 2),            // an object of one material
        (5, 4),            // a version after
        (6, 3),            // a run beyond the width
        (10, 4),           // more codes than those of the clusters
        (25, 13),          // a shift beyond the largest
        (words - 8, 15),   // half a pixel
        (words, 3),        // a run that ends beyond the width
        (words + 2, 0),    // an empty run
        (words + 2, 3),    // a run beyond its row
        (words + 3, 0x80), // the same
        (words + 20, 1),   // two runs at the same place
        (words + 32, 4),   // a run that begins beyond the width
    ];
    for (place, byte) in places {
        let mut changed = bytes.clone();
        assert_ne!(changed[place], byte, "{place}");
        changed[place] = byte;
        assert_eq!(TexturedObject::new(&changed), Err(Error::Object), "byte {place} = {byte}");
    }
    // Codes, base colors and coverages may be any.
    for place in 4..12 {
        let mut changed = bytes.clone();
        changed[words + place] = 0xf3;
        assert!(TexturedObject::new(&changed).is_ok(), "{place}");
    }
}

/// Each byte of the header, of the numbers of codes, of the rows and of the heads of runs.
#[test]
fn wrong_structure_is_refused() {
    let bytes = small().encode();
    let clusters = 18 + 6 + 1 + 2;
    let second = clusters + 2 + 2 + 2 + 1 + 2;
    let rows = second + 2 + 2 + 2 + 1 + 1;
    let words = rows + 3 * 4;
    assert_eq!(bytes.len(), words + 22);
    let places = [
        (0, 1),            // magic
        (5, 1),            // the version before
        (5, 3),            // pixels with base colors
        (5, 4),            // a version after
        (6, 3),            // a run beyond the width
        (8, 1),            // fewer rows than there are
        (8, 3),            // rows that are not there
        (10, 4),           // more codes than those of the clusters
        (11, 1),           // the same
        (12, 1),           // fewer clusters than there are
        (13, 1),           // clusters that are not there
        (14, 1),           // a degree of more numbers than there are
        (14, 17),          // a degree beyond the largest
        (15, 0),           // no part
        (15, 2),           // a part that is not there
        (16, 0),           // no component
        (16, 2),           // a component that is not there
        (16, 101),         // a rank beyond the largest
        (17, 0),           // fewer images than there are
        (17, 2),           // images that are not there
        (17, 17),          // more images than the most
        (25, 13),          // a shift beyond the largest
        (clusters, 1),     // fewer codes than there are
        (clusters + 1, 1), // codes that are not there
        (second, 2),       // more codes than the file has
        (rows, 1),         // the first row does not begin at 0
        (rows + 4, 7),     // half a pixel of the rim
        (rows + 4, 12),    // a row that ends after the last word
        (rows + 8, 7),     // the rows are not in order
        (rows + 8, 12),    // words that are not there
        (rows + 11, 1),    // the same
        (words, 3),        // a run that ends beyond the width
        (words + 2, 0),    // an empty run
        (words + 2, 5),    // a run beyond its row
        (words + 3, 0x80), // coverages that are not there
        (words + 8, 1),    // two runs at the same place
        (words + 10, 0),   // an empty run of the rim
        (words + 11, 0),   // a whole run with a coverage
        (words + 16, 4),   // a run that begins beyond the width
        (words + 18, 2),   // a run beyond the last word
    ];
    for (place, byte) in places {
        let mut changed = bytes.clone();
        assert_ne!(changed[place], byte, "{place}");
        changed[place] = byte;
        assert_eq!(ShadowedObject::new(&changed), Err(Error::Object), "byte {place} = {byte}");
    }
    for size in [[0, 2], [4, 0]] {
        assert_eq!(ShadowedObject::new(&File { size, ..small() }.encode()), Err(Error::Object));
    }
    // Numbers, codes and coverages may be any; a larger width is an object with more background.
    for place in [7, 18, 24, 26, clusters + 3, second - 1, words + 4, words + 15] {
        let mut changed = bytes.clone();
        changed[place] = 0xf3;
        assert!(ShadowedObject::new(&changed).is_ok(), "{place}");
    }
}

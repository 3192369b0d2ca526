//! Wire files in which one array is corrupted: such a file is refused, or everything can be done
//! with its basis. Tests have debug assertions, with which a broken invariant is a panic.

use crate::invariants;
use crate::wire::sealed;
use crate::wire_files::{INTEGERS_15, LONG, SPHERE, placed};
use eigenshade::wire::WireError;
use eigenshade::{Basis, Q15, q15};
use eigenshade_table::record::{floats, integers};
use eigenshade_table::wire::{ENTRY, HEADER};
use std::collections::BTreeMap;

/// What a file holds, and what opens it and uses its basis.
struct Kind {
    files: Vec<&'static [u8]>,
    arrays: Vec<&'static str>,
    open: fn(&[u8]) -> Result<(), WireError>,
    /// The arrays whose items are checked. The others hold numbers, of which any is valid.
    checked: &'static [&'static str],
}

fn kinds() -> [Kind; 2] {
    [
        Kind {
            files: vec![&SPHERE.0, &LONG.0],
            arrays: floats::Parts::<f32>::ARRAYS.to_vec(),
            open: |bytes| Basis::from_bytes(bytes).map(|basis| invariants::floats(&basis)),
            checked: &["profiles", "azimuths", "passes", "runs", "slots", "lengths"],
        },
        Kind {
            files: vec![&INTEGERS_15.0],
            arrays: integers::Parts::<Q15>::ARRAYS.to_vec(),
            open: |bytes| q15::Basis::from_bytes(bytes).map(|one| invariants::integers(&one)),
            checked: &["profiles", "azimuths", "lengths", "factors", "terms"],
        },
    ]
}

/// What the bytes are damaged by.
const FLIPPED: [u8; 6] = [0x01, 0x02, 0x10, 0x40, 0x80, 0xff];

fn long(file: &[u8], at: usize) -> usize {
    u32::from_le_bytes(file[at..at + 4].try_into().expect("four bytes")) as usize
}

/// Where in a file the array of a section is.
fn place(file: &[u8], section: usize) -> std::ops::Range<usize> {
    let entry = HEADER + ENTRY * section;
    let start = long(file, entry);
    start..start + long(file, entry + 4)
}

/// Number of sections: those of empty arrays at the end are left out.
fn sections(file: &[u8]) -> usize {
    usize::from(u16::from_le_bytes([file[26], file[27]]))
}

/// The file with this array, at its end, in the place of another, and with the right checksum.
fn with(file: &[u8], section: usize, array: &[u8]) -> Vec<u8> {
    let mut bytes = file[..file.len() - 4].to_vec();
    let start = bytes.len();
    bytes.extend(array);
    let length = bytes.len().next_multiple_of(4) + 4;
    bytes.resize(length, 0);
    let entry = HEADER + ENTRY * section;
    for (at, number) in [(16, length), (entry, start), (entry + 4, array.len())] {
        bytes[at..at + 4].copy_from_slice(&(number as u32).to_le_bytes());
    }
    sealed(bytes)
}

fn is_refused(kind: &Kind, bytes: &[u8]) -> bool {
    placed(bytes, kind.open).is_err()
}

/// An array may be at the file's end, but not lack its last items, or have some more.
#[test]
fn arrays_of_another_length_are_refused() {
    for kind in kinds() {
        for &file in &kind.files {
            for section in 0..sections(file) {
                let (name, array) = (kind.arrays[section], &file[place(file, section)]);
                assert!(!is_refused(&kind, &with(file, section, array)), "{name} at the end");
                for less in 1..=array.len().min(24) {
                    let shorter = with(file, section, &array[..array.len() - less]);
                    assert!(is_refused(&kind, &shorter), "{name} without its last {less} bytes");
                }
                for more in 1..=24 {
                    let longer = with(file, section, &[array, &vec![0; more]].concat());
                    assert!(is_refused(&kind, &longer), "{name} with {more} bytes more");
                }
            }
        }
    }
}

/// Each byte of each array. Arrays of indices and sizes are refused for some of the damage, and in
/// integers those of numbers whose sums could overflow. In floats no number is refused.
#[test]
fn corrupted_items_are_refused_or_harmless() {
    for kind in kinds() {
        let mut refused = BTreeMap::new();
        for &file in &kind.files {
            for section in 0..sections(file) {
                let (name, at) = (kind.arrays[section], place(file, section));
                let ever = refused.entry(name).or_insert(false);
                for byte in 0..at.len() {
                    for flipped in FLIPPED {
                        let mut array = file[at.clone()].to_vec();
                        array[byte] ^= flipped;
                        *ever |= is_refused(&kind, &with(file, section, &array));
                    }
                }
            }
        }
        let mut found = kind.arrays.clone();
        found.retain(|name| refused.get(name) == Some(&true));
        assert_eq!(found, kind.checked);
    }
}

/// Each byte of the header, which has the sizes, and of the table of sections.
#[test]
fn corrupted_headers_are_refused_or_harmless() {
    for kind in kinds() {
        for &file in &kind.files {
            for at in 0..HEADER + ENTRY * sections(file) {
                for flipped in FLIPPED {
                    let mut bytes = file.to_vec();
                    bytes[at] ^= flipped;
                    is_refused(&kind, &sealed(bytes));
                }
            }
        }
    }
}

//! Wire files: what is written is read, and any bytes give a basis or an error.

use crate::invariants::read;
use crate::wire_files::{ALL, INTEGERS_15, SPHERE, placed};
use eigenshade::wire::{Fault, Header, WireError, aligned};
use eigenshade::{Argument, Basis, Error, q15, sphere};
use eigenshade_table::wire::{ENTRY, Endian, HEADER, NumberFormat, encode};
use eigenshade_testing::fixtures::shipped_table;
use proptest::prelude::*;

fn shipped(format: NumberFormat) -> Vec<u8> {
    encode(&shipped_table("sphere"), format, Endian::Little).expect("it has every format")
}

/// The files that are compiled in are those of the shipped table.
#[test]
fn what_is_compiled_in_is_the_shipped_table() {
    for format in NumberFormat::ALL {
        let file = format!("tables/sphere.{}.esw", format.name());
        let bytes = std::fs::read(&file).expect("what build.rs reads");
        assert!(bytes == shipped(format), "{file}: make it again, as tables/README.md says");
    }
}

/// Whatever is compiled in as statics comes back from bytes, array by array.
#[test]
fn the_shipped_table_comes_back() {
    let found = placed(&shipped(NumberFormat::F32), |bytes| {
        format!("{:?}", Basis::from_bytes(bytes).expect("a wire file").parts())
    });
    assert_eq!(found, format!("{:?}", sphere::BASIS.parts()));
    let found = placed(&shipped(NumberFormat::Q15), |bytes| {
        format!("{:?}", q15::Basis::from_bytes(bytes).expect("a wire file").parts())
    });
    assert_eq!(found, format!("{:?}", sphere::q15::BASIS.parts()));
}

/// The first bytes, as `docs/formats.md` has them.
#[test]
fn a_header_is_as_written_down() {
    let header = Header::read(&INTEGERS_15.0).expect("a header");
    assert_eq!((header.version, header.length), (4, INTEGERS_15.0.len()));
    assert_eq!(NumberFormat::of(header.format), Some(NumberFormat::Q15));
    assert_eq!((header.degree, header.order, header.components), (2, 2, 6));
    assert_eq!(header.sections, 8);
    let expected = [
        b"EIGSWIRE\x04\x03\x02\x01\x04\0\x02\0".as_slice(),
        &(INTEGERS_15.0.len() as u32).to_le_bytes(),
        b"\x02\0\x02\0\x06\0\x08\0",
    ];
    assert_eq!(INTEGERS_15.0[..HEADER], expected.concat());
    let (bytes, sum) = INTEGERS_15.0.split_at(INTEGERS_15.0.len() - 4);
    assert_eq!(crc32fast::hash(bytes).to_le_bytes(), sum);
}

fn is_refused(bytes: &[u8]) -> bool {
    read(bytes).iter().all(Option::is_some)
}

#[test]
fn no_flipped_bit_goes_unseen() {
    for file in ALL {
        for place in 0..file.len() {
            for bit in 0..8 {
                let mut bytes = file.to_vec();
                bytes[place] ^= 1 << bit;
                assert!(placed(&bytes, is_refused), "{place}, {bit}");
            }
        }
    }
}

#[test]
fn no_part_is_the_whole() {
    for file in ALL {
        for length in 0..file.len() {
            assert!(is_refused(&file[..length]), "{length}");
        }
        // The rest of its page does not count.
        assert!(!placed(&[file, &[0xff; 100]].concat(), is_refused));
    }
}

/// Its checksum made right.
pub fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 4;
    let (file, sum) = bytes.split_at_mut(end);
    sum.copy_from_slice(&crc32fast::hash(file).to_le_bytes());
    bytes
}

#[test]
fn errors_say_which_they_are() {
    let of = |bytes: &[u8]| Basis::from_bytes(bytes).expect_err("a fault");
    let with = |file: &[u8], at: usize, byte: u8| {
        let mut bytes = file.to_vec();
        bytes[at] = byte;
        placed(&sealed(bytes), of)
    };
    let length = SPHERE.0.len();
    let without_terms = Error::Length { argument: Argument::Terms, expected: 27, found: 0 };
    let mut found = vec![
        (of(b""), Fault::BadMagic.into()),
        (of(b"EIGSHADE, another file altogether"), Fault::BadMagic.into()),
        (of(b"EIGSWIRE"), Fault::Length { expected: HEADER, found: 8 }.into()),
        (of(&SPHERE.0[..100]), Fault::Length { expected: length, found: 100 }.into()),
        (with(&SPHERE.0, 12, 3), Fault::Version(3).into()),
        (with(&SPHERE.0, 14, 7), Fault::Format { expected: NumberFormat::F32, found: 7 }.into()),
        (of(&INTEGERS_15.0), Fault::Format { expected: NumberFormat::F32, found: 2 }.into()),
        (with(&SPHERE.0, 21, 2), Fault::Shape { degree: 514, order: 2 }.into()),
        (with(&SPHERE.0, 26, 10), Fault::Section { number: 9 }.into()),
        (with(&SPHERE.0, 26, 8), WireError::Parts(without_terms)),
        (with(&SPHERE.0, HEADER, 2), Fault::Section { number: 0 }.into()),
        (with(&SPHERE.0, HEADER + 3, 2), Fault::Section { number: 0 }.into()),
        (with(&SPHERE.0, HEADER + 4, 1), Fault::Section { number: 0 }.into()),
    ];
    let refused = aligned(&SPHERE.0, &mut [0; 3]).expect_err("too little");
    found.push((refused.into(), Fault::Room { needed: length / 4, found: 3 }.into()));
    for (found, expected) in &found {
        assert_eq!(found, expected);
    }
    // More components than profiles serve.
    let contradiction = WireError::Parts(Error::Parts);
    let kinds: [&[u8]; 2] = [&SPHERE.0, &INTEGERS_15.0];
    for (kind, file) in kinds.into_iter().enumerate() {
        let mut bytes = file.to_vec();
        bytes[24] += 1;
        assert_eq!(placed(&sealed(bytes), read)[kind], Some(contradiction));
    }
    let mut damaged = SPHERE.0.to_vec();
    damaged[200] ^= 1;
    let damaged = placed(&damaged, of);
    assert!(matches!(damaged, WireError::File(Fault::Checksum { .. })));
    let more = [contradiction, damaged];
    for error in found.iter().map(|(found, _)| found).chain(&more) {
        let line = error.to_string();
        assert!(line.contains("; ") && !line.contains('\n'), "no remedy: {line}");
    }
}

/// A file for the other kind of machine is the same numbers, each turned round.
#[test]
fn the_other_byte_order_is_told() {
    let table = shipped_table("sphere");
    let [little, big] = [Endian::Little, Endian::Big]
        .map(|endian| encode(&table, NumberFormat::F32, endian).expect("a sphere's table"));
    let refused = placed(&big, |bytes| Basis::from_bytes(bytes).expect_err("another order"));
    assert_eq!(refused, Fault::Endianness.into());
    let long = |at: usize| u32::from_le_bytes(std::array::from_fn(|k| little[at + k])) as usize;
    let turned = |at: usize, width: usize| {
        let mut number = little[at..at + width].to_vec();
        number.reverse();
        assert_eq!(number, big[at..at + width], "{at}");
    };
    (12..16).step_by(2).chain((20..HEADER).step_by(2)).for_each(|at| turned(at, 2));
    // Polar integrals, factors and terms are four bytes each.
    for section in 6..9 {
        let (start, length) = (long(HEADER + ENTRY * section), long(HEADER + ENTRY * section + 4));
        (start..start + length).step_by(4).for_each(|at| turned(at, 4));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        prop_assert!(placed(&bytes, is_refused));
        prop_assert!(is_refused(&bytes));
    }

    /// Behind a header that is right, with a checksum that is right.
    #[test]
    fn random_sections_are_no_panic(
        file in 0..ALL.len(),
        tail in prop::collection::vec(any::<u8>(), 0..400),
        shape in prop::array::uniform4(0..12_u16),
        entries in prop::collection::vec((0..150_u32, 0..100_u32), 15),
    ) {
        let mut bytes = ALL[file][..32].to_vec();
        for (place, number) in (20..28).step_by(2).zip(shape) {
            bytes[place..place + 2].copy_from_slice(&number.to_le_bytes());
        }
        let start = 32 + 8 * u32::from(bytes[28]);
        for (at, length) in entries.iter().take(bytes[28].into()) {
            bytes.extend((start + 4 * at).to_le_bytes());
            bytes.extend((4 * length).to_le_bytes());
        }
        bytes.extend(tail);
        bytes.resize(bytes.len().next_multiple_of(4) + 4, 0);
        let length = bytes.len() as u32;
        bytes[16..20].copy_from_slice(&length.to_le_bytes());
        let found = placed(&sealed(bytes), read);
        prop_assert!(!found.contains(&Some(Fault::BadMagic.into())));
    }

    /// Of true files some places hold other bytes.
    #[test]
    fn scattered_damage_is_no_panic(
        file in 0..ALL.len(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let mut bytes = ALL[file].to_vec();
        for (place, byte) in damage {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        placed(&sealed(bytes), read);
    }
}

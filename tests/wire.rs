//! Wire files: what is written is read, version 1 for ever, and any bytes give a basis or
//! an error.

#[path = "tolerances/mod.rs"]
mod tolerances;

use eigenshade::wire::{Aligned, Header, WireError, WireFormat, aligned};
use eigenshade::{Basis, Fixed, GeneralBasis, Normal, Q15, Q31, quantised, sphere};
use eigenshade_table::quantise;
use eigenshade_table::wire::{Endian, Format, encode};
use proptest::prelude::*;

const SPHERE: &Aligned<[u8]> = &Aligned(*include_bytes!("wire/v1.sphere.f32.esw"));
const MEAN: &Aligned<[u8]> = &Aligned(*include_bytes!("wire/v1.mean.f32.esw"));
const GENERAL: &Aligned<[u8]> = &Aligned(*include_bytes!("wire/v1.general.f32.esw"));
const INTEGERS_15: &Aligned<[u8]> = &Aligned(*include_bytes!("wire/v1.sphere.q15.esw"));
const INTEGERS_31: &Aligned<[u8]> = &Aligned(*include_bytes!("wire/v1.sphere.q31.esw"));
const ALL: [&[u8]; 5] = [&SPHERE.0, &MEAN.0, &GENERAL.0, &INTEGERS_15.0, &INTEGERS_31.0];

const Q15_FORMAT: Format = Format::Integer(quantise::Format::Q15);
const Q31_FORMAT: Format = Format::Integer(quantise::Format::Q31);

fn room(bytes: &[u8]) -> Vec<u32> {
    vec![0; bytes.len().div_ceil(4)]
}

fn shipped(format: Format) -> Vec<u8> {
    let bytes = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&bytes).expect("a table");
    encode(&table, format, Endian::Little).expect("it has every format")
}

/// Whatever is compiled in as statics comes back from bytes, array by array.
#[test]
fn the_shipped_table_comes_back() {
    let bytes = shipped(Format::F32);
    let (mut a, mut b, mut c) = (room(&bytes), room(&bytes), room(&bytes));
    let floats = Basis::<f32>::from_bytes(aligned(&bytes, &mut a).expect("room"));
    let floats = floats.expect("a wire file");
    assert_eq!(format!("{:?}", floats.parts()), format!("{:?}", sphere::BASIS.parts()));
    let bytes = shipped(Q15_FORMAT);
    let integers = quantised::Basis::<Q15>::from_bytes(aligned(&bytes, &mut b).expect("room"));
    let integers = integers.expect("a wire file");
    assert_eq!(format!("{:?}", integers.parts()), format!("{:?}", sphere::q15::BASIS.parts()));
    let bytes = shipped(Q31_FORMAT);
    let integers = quantised::Basis::<Q31>::from_bytes(aligned(&bytes, &mut c).expect("room"));
    let integers = integers.expect("a wire file");
    assert_eq!(format!("{:?}", integers.parts()), format!("{:?}", sphere::q31::BASIS.parts()));
}

/// The last column of a CSV, of the rows that begin with `name`.
fn column(text: &str, name: &str) -> Vec<f32> {
    let rows = text.lines().filter(|line| line.starts_with(name));
    rows.map(|row| row.rsplit(',').next().expect("a field").parse().expect("a number")).collect()
}

fn light() -> Vec<f32> {
    column(include_str!("wire/light.csv"), "one,")
}

fn material() -> Vec<f32> {
    column(include_str!("wire/material.csv"), "one,")
}

/// Against d as it was when the files were made, of the largest.
fn assert_same(table: &str, found: &[f32], tolerance: f32) {
    let expected = column(include_str!("wire/v1.csv"), &format!("{table},"));
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0f32, |most, d| most.max(d.abs()));
    for (found, expected) in found.iter().zip(&expected) {
        assert!((found - expected).abs() <= tolerance * largest, "{table}: {found}, {expected}");
    }
}

/// d of the test's light on its material, and some pixel.
fn floats(basis: &Basis<'_, f32>) -> (Vec<f32>, f32) {
    let (light, material) = (light(), material());
    let light = eigenshade::Light::new(2, &light).expect("nine coefficients");
    let material = eigenshade::Material::new(2, &material).expect("five coefficients");
    let (light, material) = (light.truncated(basis.degree()), material.truncated(basis.order()));
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![0.0; basis.components()];
    if !basis.projects() {
        return (d, 0.0);
    }
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    let mut transfer = vec![0.0; basis.transfer_len()];
    basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    basis.relight_into(&transfer, &light, &mut d).expect("sizes");
    let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
    (d, scene.shade(Normal::new(0.6, 0.0, 0.8).expect("a normal")))
}

fn general(basis: &GeneralBasis<'_, f32>) -> Vec<f32> {
    let (light, material) = (light(), material());
    let light = eigenshade::Light::new(2, &light).expect("nine coefficients");
    let material = eigenshade::Material::new(2, &material).expect("five coefficients");
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut d = vec![0.0; basis.components()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    d
}

/// The same in integers.
fn integers<Q: Fixed>(basis: &quantised::Basis<'_, Q>, normal: quantised::Normal<Q>) -> Vec<f32> {
    let (light, material) = (light(), material());
    let (degree, order) = (basis.degree().min(2), basis.order().min(2));
    let light = &light[..(degree + 1) * (degree + 1)];
    let material = &material[..eigenshade::index::material::count(order)];
    let mut mantissas = vec![Q::default(); light.len()];
    let light = quantised::Light::quantise(degree, light, &mut mantissas).expect("sizes");
    let (mut mantissas, mut exponents) = (vec![Q::default(); material.len()], vec![0; order + 1]);
    let material = quantised::Material::quantise(order, material, &mut mantissas, &mut exponents);
    let material = material.expect("sizes");
    let mut workspace = vec![<Q as eigenshade::Format>::Wide::default(); basis.workspace_len()];
    let mut numbers = vec![Q::default(); basis.transfer_len()];
    let mut exponents = vec![0; basis.profiles()];
    let mut d = vec![0; basis.components()];
    if basis.fold_into(&material, &mut workspace, &mut numbers, &mut exponents).is_err() {
        return Vec::new();
    }
    let transfer = quantised::Transfer::new(&numbers, &exponents);
    let exponent = basis.relight_into(&transfer, &light, &mut d).expect("sizes");
    let scene = basis.collapse_into(&d, exponent, vec![0; basis.scene_len()]).expect("sizes");
    let _ = scene.shade(normal);
    d.into_iter().map(|d| d as f32 * (exponent as f32).exp2()).collect()
}

fn facing_15() -> quantised::Normal<Q15> {
    quantised::Normal::<Q15>::new(Q15(19_661), Q15(0), Q15(26_214)).expect("a unit vector")
}

fn facing_31() -> quantised::Normal<Q31> {
    let (x, z) = (Q31(1_288_490_189), Q31(1_717_986_918));
    quantised::Normal::<Q31>::new(x, Q31(0), z).expect("a unit vector")
}

/// These files stay; so does what they give.
#[test]
fn version_1_is_read() {
    for (table, bytes) in [("sphere", &SPHERE.0), ("mean", &MEAN.0)] {
        let basis = Basis::<f32>::from_bytes(bytes).expect("a wire file");
        assert_same(table, &floats(&basis).0, tolerances::WIRE_F32);
    }
    let basis = GeneralBasis::<f32>::from_bytes(&GENERAL.0).expect("a wire file");
    assert_same("general", &general(&basis), tolerances::WIRE_F32);
    let basis = quantised::Basis::<Q15>::from_bytes(&INTEGERS_15.0).expect("a wire file");
    assert_same("sphere", &integers(&basis, facing_15()), tolerances::WIRE_Q15);
    let basis = quantised::Basis::<Q31>::from_bytes(&INTEGERS_31.0).expect("a wire file");
    assert_same("sphere", &integers(&basis, facing_31()), tolerances::WIRE_Q31);
}

/// The first bytes, as `tables/README.md` has them.
#[test]
fn a_header_is_as_written_down() {
    let header = Header::read(&INTEGERS_15.0).expect("a header");
    assert_eq!((header.version, header.length), (1, INTEGERS_15.0.len()));
    assert_eq!(WireFormat::of(header.format), Some(WireFormat::Q15));
    assert_eq!((header.degree, header.order, header.components), (2, 2, 6));
    assert_eq!((header.images, header.sections), (0, 7));
    let expected = [
        b"EIGSWIRE\x04\x03\x02\x01\x01\0\x02\0".as_slice(),
        &(INTEGERS_15.0.len() as u32).to_le_bytes(),
        b"\x02\0\x02\0\x06\0\0\0\x07\0\0\0",
    ];
    assert_eq!(INTEGERS_15.0[..32], expected.concat());
    let (bytes, sum) = INTEGERS_15.0.split_at(INTEGERS_15.0.len() - 4);
    assert_eq!(crc32fast::hash(bytes).to_le_bytes(), sum);
}

/// What any reading of these bytes says, of all there are; each basis is used.
fn read(bytes: &[u8]) -> [Option<WireError>; 4] {
    let sphere = Basis::<f32>::from_bytes(bytes);
    if let Ok(basis) = &sphere {
        floats(basis);
    }
    let of_others = GeneralBasis::<f32>::from_bytes(bytes);
    if let Ok(basis) = &of_others {
        assert!(basis.components() > 0);
    }
    let of_15 = quantised::Basis::<Q15>::from_bytes(bytes);
    if let Ok(basis) = &of_15 {
        integers(basis, facing_15());
    }
    let of_31 = quantised::Basis::<Q31>::from_bytes(bytes);
    if let Ok(basis) = &of_31 {
        integers(basis, facing_31());
    }
    [sphere.err(), of_others.err(), of_15.err(), of_31.err()]
}

fn is_refused(bytes: &[u8]) -> bool {
    read(bytes).iter().all(Option::is_some)
}

#[test]
fn no_flipped_bit_goes_unseen() {
    for file in ALL {
        let mut room = room(file);
        for place in 0..file.len() {
            for bit in 0..8 {
                let mut bytes = file.to_vec();
                bytes[place] ^= 1 << bit;
                assert!(is_refused(aligned(&bytes, &mut room).expect("room")), "{place}, {bit}");
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
        let page = [file, &[0xff; 100]].concat();
        let mut room = room(&page);
        assert!(!is_refused(aligned(&page, &mut room).expect("room")));
    }
}

/// Its checksum made right.
fn sealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 4;
    let (file, sum) = bytes.split_at_mut(end);
    sum.copy_from_slice(&crc32fast::hash(file).to_le_bytes());
    bytes
}

/// Damage that the checksum does not show: an error, or a basis that everything can be
/// done with.
#[test]
fn no_forged_file_is_a_panic() {
    let mut taken = 0;
    for file in ALL {
        let mut room = room(file);
        for place in 0..file.len() - 4 {
            for flipped in [0x01, 0x02, 0x10, 0x40, 0x80, 0xff] {
                let mut bytes = file.to_vec();
                bytes[place] ^= flipped;
                let bytes = sealed(bytes);
                taken += u32::from(!is_refused(aligned(&bytes, &mut room).expect("room")));
            }
        }
    }
    assert!(taken > 1000, "{taken}: the damage reaches the numbers");
}

#[test]
fn errors_say_which_they_are() {
    let of = |bytes: &[u8]| Basis::<f32>::from_bytes(bytes).expect_err("a fault");
    let mut room = room(&GENERAL.0);
    let mut with = |file: &[u8], at: usize, byte: u8| {
        let mut bytes = file.to_vec();
        bytes[at] = byte;
        of(aligned(&sealed(bytes), &mut room).expect("room"))
    };
    let length = SPHERE.0.len();
    let mut found = vec![
        (of(b""), WireError::Foreign),
        (of(b"EIGSHADE, another file altogether"), WireError::Foreign),
        (of(b"EIGSWIRE"), WireError::Length { expected: 32, found: 8 }),
        (of(&SPHERE.0[..100]), WireError::Length { expected: length, found: 100 }),
        (with(&SPHERE.0, 12, 2), WireError::Version(2)),
        (with(&SPHERE.0, 14, 7), WireError::Format { expected: WireFormat::F32, found: 7 }),
        (of(&INTEGERS_15.0), WireError::Format { expected: WireFormat::F32, found: 2 }),
        (of(&GENERAL.0), WireError::Images { found: 4 }),
        (with(&SPHERE.0, 21, 2), WireError::Shape { degree: 514, order: 2 }),
        (with(&SPHERE.0, 28, 16), WireError::Section { number: 15 }),
        (with(&SPHERE.0, 28, 14), WireError::Section { number: 14 }),
        (with(&SPHERE.0, 32, 2), WireError::Section { number: 0 }),
        (with(&SPHERE.0, 35, 2), WireError::Section { number: 0 }),
        (with(&SPHERE.0, 36, 1), WireError::Section { number: 0 }),
    ];
    let of_sphere = GeneralBasis::<f32>::from_bytes(&SPHERE.0).expect_err("no eigenimages");
    found.push((of_sphere, WireError::Images { found: 0 }));
    let shorter = &mut [0; 3];
    let refused = aligned(&SPHERE.0, shorter).expect_err("too little");
    found.push((refused, WireError::Room { needed: length / 4, found: 3 }));
    for (found, expected) in &found {
        assert_eq!(found, expected);
    }
    let contradiction = with(&SPHERE.0, 24, 7);
    assert_eq!(contradiction, WireError::Parts(eigenshade::Error::Profile));
    let damaged = {
        let mut bytes = SPHERE.0.to_vec();
        bytes[200] ^= 1;
        bytes
    };
    let damaged = of(aligned(&damaged, &mut room).expect("room"));
    assert!(matches!(damaged, WireError::Checksum { .. }));
    let more = [contradiction, damaged];
    for error in found.iter().map(|(found, _)| found).chain(&more) {
        let line = error.to_string();
        assert!(line.contains("; ") && !line.contains('\n'), "no remedy: {line}");
    }
}

/// At every place but multiples of four, and put right.
#[test]
fn alignment_is_asked_for() {
    let mut places = vec![0_u32; SPHERE.0.len() / 4 + 1];
    for beyond in 1..4 {
        let bytes: Vec<u8> = [&vec![0; beyond], &SPHERE.0, &vec![0; 4 - beyond]].concat();
        let bytes = aligned(&bytes, &mut places).expect("room");
        let refused = Basis::<f32>::from_bytes(&bytes[beyond..]).expect_err("not aligned");
        assert_eq!(refused, WireError::Alignment { beyond });
        assert!(refused.to_string().contains("wire::aligned"));
        let mut room = room(&SPHERE.0);
        let copied = aligned(&bytes[beyond..][..SPHERE.0.len()], &mut room).expect("room");
        assert!(Basis::<f32>::from_bytes(copied).is_ok());
    }
}

/// A file for the other kind of machine is the same numbers, each turned round.
#[test]
fn the_other_byte_order_is_told() {
    let table = std::fs::read("tables/sphere.bin").expect("the shipped table");
    let table = eigenshade_table::decode(&table).expect("a table");
    let [little, big] = [Endian::Little, Endian::Big]
        .map(|endian| encode(&table, Format::F32, endian).expect("a sphere's table"));
    let mut room = room(&big);
    let refused = Basis::<f32>::from_bytes(aligned(&big, &mut room).expect("room"));
    assert_eq!(refused.expect_err("another order"), WireError::Endianness);
    let long = |at: usize| u32::from_le_bytes(std::array::from_fn(|k| little[at + k])) as usize;
    let turned = |at: usize, width: usize| {
        let mut number = little[at..at + width].to_vec();
        number.reverse();
        assert_eq!(number, big[at..at + width], "{at}");
    };
    (12..16).step_by(2).chain((20..32).step_by(2)).for_each(|at| turned(at, 2));
    // Polar integrals, factors and terms are four bytes each.
    for section in 5..8 {
        let (start, length) = (long(32 + 8 * section), long(36 + 8 * section));
        (start..start + length).step_by(4).for_each(|at| turned(at, 4));
    }
}

proptest! {
    #[test]
    fn random_bytes_are_refused(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        let mut places = room(&bytes);
        prop_assert!(is_refused(aligned(&bytes, &mut places).expect("room")));
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
        let bytes = sealed(bytes);
        let mut places = room(&bytes);
        let found = read(aligned(&bytes, &mut places).expect("room"));
        prop_assert!(!found.contains(&Some(WireError::Foreign)));
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
        let bytes = sealed(bytes);
        let mut places = room(&bytes);
        read(aligned(&bytes, &mut places).expect("room"));
    }
}

//! Decoding is total: any bytes give a consistent table or an error.

use eigenshade_table::{
    FileError, MeanImage, Profile, Table, decode, encode, file, parts, statics,
};

fn shipped() -> Vec<u8> {
    std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/sphere.bin")).unwrap()
}

/// A file with this payload and the right length and checksum.
fn sealed(payload: &[u8]) -> Vec<u8> {
    let mut bytes = b"EIGSHADE\x03\0\0\0".to_vec();
    bytes.extend((payload.len() as u64).to_le_bytes());
    bytes.extend(crc32fast::hash(payload).to_le_bytes());
    bytes.extend(payload);
    bytes
}

#[test]
fn encoded_tables_decode() {
    let bytes = shipped();
    let table = decode(&bytes).unwrap();
    assert_eq!(encode(&table), bytes);
    assert_eq!(sealed(&bytes[24..]), bytes);
}

/// With and without the optional parts of a scene.
#[test]
fn optional_fields_are_read() {
    let mut table = decode(&shipped()).unwrap();
    assert_eq!(table.scene.basis.trim, None);
    table.scene.basis.trim = Some(0.5);
    assert_eq!(decode(&encode(&table)), Ok(table.clone()));
    for trim in [0.0, 1.0, f64::NAN] {
        table.scene.basis.trim = Some(trim);
        assert!(matches!(decode(&encode(&table)), Err(FileError::Payload(_))));
    }
}

#[test]
fn headers_are_checked() {
    let bytes = shipped();
    let with = |at: usize, byte: u8| {
        let mut bytes = bytes.clone();
        bytes[at] ^= byte;
        decode(&bytes).unwrap_err()
    };
    assert_eq!(with(0, 1), FileError::BadMagic);
    assert_eq!(with(8, 1), FileError::Version(2));
    assert!(matches!(with(12, 1), FileError::Length { .. }));
    assert_eq!(with(20, 1), FileError::Checksum);
    assert_eq!(with(1000, 1), FileError::Checksum);
    for length in (0..200).chain([bytes.len() - 1]) {
        assert!(decode(&bytes[..length]).is_err());
    }
    let longer = sealed(&[&bytes[24..], b"\0"].concat());
    assert!(matches!(decode(&longer), Err(FileError::Payload(_))));
}

/// After one byte, the degree, the payload has a string, whose length precedes its bytes.
#[test]
fn claimed_lengths_allocate_nothing() {
    let payload = &shipped()[24..];
    assert_eq!(&payload[..8], b"\x09\x11inputs");
    for length in [u64::MAX, 1 << 60, 1 << 40, 1 << 32, 1 << 28] {
        let claim = [b"\x09\xfd".as_slice(), &length.to_le_bytes(), &payload[2..]].concat();
        assert!(matches!(decode(&sealed(&claim)), Err(FileError::Payload(_))), "{length}");
    }
}

/// Corruption under a right checksum gives an error or a table from which parts can be made.
#[test]
fn corrupt_payloads_do_not_panic() {
    let bytes = shipped();
    let payload = &bytes[24..];
    let mut read = 0;
    let places = (0..200).chain((200..payload.len()).step_by(1009));
    for place in places.chain(payload.len() - 100..payload.len()) {
        for flipped in [0x01, 0x80, 0xff] {
            let mut damaged = payload.to_vec();
            damaged[place] ^= flipped;
            if let Ok(table) = decode(&sealed(&damaged)) {
                read += usize::from(parts::floats(&table).components == table.components.len());
            }
        }
    }
    assert!(read > 100, "{read}: some corrupt payloads decode");
}

#[test]
fn parts_that_contradict_each_other_are_refused() {
    let table = decode(&shipped()).unwrap();
    let refused = |change: &dyn Fn(&mut Table), what: &str| {
        let mut table = table.clone();
        change(&mut table);
        let error = decode(&encode(&table)).unwrap_err().to_string();
        assert!(error.contains(what), "{what}: {error}");
    };
    refused(&|table| table.gram.degree = usize::MAX, "above 256");
    refused(&|table| table.gram.order = 6, "differ from the scene's");
    refused(&|table| table.gram.gains.truncate(39), "gains: 40 numbers expected, 39 found");
    refused(&|table| table.gram.rotations.push(0.0), "rotations");
    refused(&|table| table.selection = vec![true; 17], "selection");
    refused(&|table| table.summary.ranks.truncate(3), "ranks");
    refused(&|table| table.summary.ranks[0] = usize::MAX, "rank");
    refused(&|table| table.summary.energy = f64::NAN, "figures");
    refused(&|table| table.spectrum[4].1 = Some(f64::INFINITY), "eigenvalues");
    refused(&|table| table.components[7].profile = 1 << 40, "component 7 has no profile");
    refused(&|table| table.components[7].order = i32::MIN, "component 7");
    refused(&|table| table.components[7] = table.components[6], "component 7 is a duplicate");
    refused(&|table| table.components.clear(), "no component uses");
    refused(&|table| table.profiles.reverse(), "not sorted");
    let profile = |change: &dyn Fn(&mut Profile), what| {
        refused(&|table| change(&mut table.profiles[2]), what);
    };
    profile(&|profile| profile.azimuth = 10, "azimuth 10");
    profile(&|profile| profile.node_values.clear(), "node values");
    profile(&|profile| profile.modes[3] = f64::NAN, "modes");
    profile(&|profile| profile.factors.push(1.0), "factors");
    profile(&|profile| profile.chebyshev.clear(), "polynomial: 1 to");
    profile(&|profile| profile.chebyshev.resize(70_000, 0.0), "polynomial: 1 to");
    let mean = |count| Some(MeanImage { chebyshev: vec![1.0], coefficients: vec![0.0; count] });
    refused(&|table| table.mean = mean(table.count()), "mean image");
}

/// The section names are part of the manifest's format, and the first line of source names the
/// command that made it.
#[test]
fn outputs_begin_as_described() {
    let table = decode(&shipped()).unwrap();
    assert!(file::manifest(&table).starts_with("entry,value,bytes,crc32\nscene,,"));
    let text = statics::floats(&table, "by hand").expect("it projects");
    assert!(text.starts_with("// by hand\n// "));
}

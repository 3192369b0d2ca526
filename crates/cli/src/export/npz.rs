//! Arrays as an npz file, which `numpy.load` reads: an uncompressed zip archive with a file in
//! numpy's format 1.0 for each array.

use super::array::{Array, Values};
use eigenshade_model::error::{Error, Result};
use std::io::{Cursor, Write};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// The header of an array ends at a multiple of this many bytes.
const ALIGNMENT: usize = 64;

/// The bytes of the file, the same in every run: real numbers are `<f8`, whole numbers `<i8`, and
/// texts `<U`. Fails if the archive would exceed the limits of its format.
pub fn bytes(arrays: &[Array]) -> Result<Vec<u8>> {
    let fault = |error: &dyn std::fmt::Display| {
        Error::new(format!("the arrays do not fit an npz file: {error}"), "export fewer at once")
    };
    let mut archive = ZipWriter::new(Cursor::new(Vec::new()));
    for array in arrays {
        let file = file(array);
        let options = SimpleFileOptions::default()
            .compression_method(CompressionMethod::Stored)
            .last_modified_time(DateTime::default())
            .large_file(file.len() >= u32::MAX as usize);
        let name = format!("{}.npy", array.name);
        archive.start_file(name, options).map_err(|error| fault(&error))?;
        archive.write_all(&file).map_err(|error| fault(&error))?;
    }
    Ok(archive.finish().map_err(|error| fault(&error))?.into_inner())
}

/// One array: magic, version, length of the header, header, values.
fn file(array: &Array) -> Vec<u8> {
    let (kind, values) = match &array.values {
        Values::Floats(values) => {
            ("<f8".to_owned(), values.iter().flat_map(|value| value.to_le_bytes()).collect())
        }
        Values::Integers(values) => {
            ("<i8".to_owned(), values.iter().flat_map(|value| value.to_le_bytes()).collect())
        }
        Values::Texts(values) => texts(values),
    };
    let lengths: String = array.shape.iter().map(|length| format!("{length},")).collect();
    let mut header =
        format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': ({lengths}), }}");
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    let before = bytes.len() + size_of::<u16>();
    let padded = (before + header.len() + 1).next_multiple_of(ALIGNMENT) - before;
    header = format!("{header:<width$}\n", width = padded - 1);
    bytes.extend(u16::try_from(header.len()).expect("a few axes").to_le_bytes());
    bytes.extend(header.into_bytes());
    bytes.extend::<Vec<u8>>(values);
    bytes
}

/// Texts of one length in UTF-32, padded with zeros.
fn texts(values: &[String]) -> (String, Vec<u8>) {
    let longest = values.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
    let letters = values.iter().flat_map(|text| {
        let letters = text.chars().map(u32::from);
        letters.chain(std::iter::repeat(0)).take(longest)
    });
    (format!("<U{longest}"), letters.flat_map(u32::to_le_bytes).collect())
}

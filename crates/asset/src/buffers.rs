//! The bytes that a glTF file names: in itself, in data URIs, and in files beside it.

use crate::accessor::broken;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use percent_encoding::percent_decode_str;

/// The bytes at a URI: `data:..;base64,..`, or a file in the folder of this one.
pub(crate) fn bytes(file: &InputFile, uri: &str) -> Result<Vec<u8>> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) =
            data.split_once(";base64,").ok_or_else(|| broken("a data URI without base64"))?;
        return STANDARD.decode(text).map_err(|error| broken(format!("a data URI: {error}")));
    }
    if uri.contains("://") {
        let what = format!("it names `{uri}`, which is not on this computer");
        return Err(Error::new(what, "save it with its buffers and textures as .glb"));
    }
    beside(file, uri).bytes().map_err(|error| error.of(format_args!("`{uri}`")))
}

/// A file beside this one, with or without percent signs in its name.
pub(crate) fn beside(file: &InputFile, name: &str) -> InputFile {
    let plain = file.folder().join(name.replace('\\', "/"));
    let decoded = percent_decode_str(name).decode_utf8_lossy().into_owned();
    file.other(if plain.exists() { plain } else { file.folder().join(decoded) })
}

/// The buffers of a file.
pub(crate) fn all(
    file: &InputFile,
    document: &gltf::Document,
    mut blob: Option<Vec<u8>>,
) -> Result<Vec<Vec<u8>>> {
    let mut buffers = Vec::new();
    for buffer in document.buffers() {
        let bytes = match buffer.source() {
            gltf::buffer::Source::Bin => {
                blob.take().ok_or_else(|| broken("its binary part is missing"))?
            }
            gltf::buffer::Source::Uri(uri) => bytes(file, uri)?,
        };
        if bytes.len() < buffer.length() {
            return Err(broken(format!(
                "buffer {} has {} bytes of {}",
                buffer.index(),
                bytes.len(),
                buffer.length()
            )));
        }
        buffers.push(bytes);
    }
    Ok(buffers)
}

//! Normals as CSV: `x,y,z`, one normal per row.

use super::input_file::InputFile;
use super::sheet::Sheet;
use crate::error::Result;

/// How far below the rim, in z after normalization, a normal may lie and still be moved onto it.
pub const RIM: f64 = 1e-3;

/// Reads unit normals in the camera frame: x right, y up, z toward the camera.
///
/// Vectors of any length are normalized. A normal that points away by no more than [`RIM`] is moved
/// onto the rim, z = 0. Other columns and lines that begin with `#` are ignored.
///
/// # Errors
///
/// If the file cannot be read or contains no normal, or if a row is ragged, not finite, of length
/// zero, or points away from the camera.
pub fn read_normals(file: impl Into<InputFile>) -> Result<Vec<[f64; 3]>> {
    let sheet = Sheet::read(file, "x,y,z")?;
    let columns = sheet.columns(["x", "y", "z"]).ok_or_else(|| sheet.wrong_header("`x,y,z`"))?;
    let mut normals = Vec::with_capacity(sheet.rows().len());
    for row in sheet.rows() {
        let normal = visible(row.numbers(columns)?);
        normals.push(normal.map_err(|(what, remedy)| row.fault(what, remedy))?);
    }
    if normals.is_empty() {
        return Err(sheet.fault("it contains no normal", "add rows below the header `x,y,z`"));
    }
    Ok(normals)
}

/// The unit normal along `vector`, moved onto the rim if it is slightly behind it.
///
/// # Errors
///
/// If the length is zero or not finite, or the vector points away by more than [`RIM`]. The error
/// is the problem and the remedy.
pub fn visible(vector: [f64; 3]) -> std::result::Result<[f64; 3], (String, String)> {
    let [x, y, z] = unit(vector).ok_or_else(|| {
        (
            "the normal has no direction".to_owned(),
            "give it a finite length above zero, or remove it".to_owned(),
        )
    })?;
    if z < -RIM {
        return Err((
            format!("the normal points away from the camera, z = {z:.6} after normalizing"),
            format!("remove it: only normals with z >= -{RIM} are visible"),
        ));
    }
    let laid = if z < 0.0 { unit([x, y, 0.0]) } else { None };
    Ok(laid.unwrap_or([x, y, z]))
}

/// Divides by the largest component first to avoid overflow and underflow.
fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let largest = vector.iter().fold(0.0, |top: f64, c| top.max(c.abs()));
    if !(largest > 0.0 && vector.iter().all(|c| c.is_finite())) {
        return None;
    }
    let scaled = vector.map(|c| c / largest);
    let length = scaled.iter().map(|c| c * c).sum::<f64>().sqrt();
    Some(scaled.map(|c| c / length))
}

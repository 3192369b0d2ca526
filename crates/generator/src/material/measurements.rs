//! Measured BRDFs as plain CSV with the columns `theta_i,phi_i,theta_r,phi_r,r,g,b`, or `value`
//! instead of r, g, b for gray; in radians and 1/sr. Lines that start with `#` are comments; other
//! columns are ignored.

use std::f64::consts::FRAC_PI_2;

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::{Row, Sheet};

/// How far beyond the rim a polar angle may lie, since files round π/2.
const RIM_SLACK: f64 = 1e-9;

const COLUMNS: &str = "theta_i,phi_i,theta_r,phi_r,r,g,b";

/// One measured value of a BRDF.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Polar angle of the light, in \[0, π/2\].
    pub theta_i: f64,
    /// Polar angle of the view, in \[0, π/2\].
    pub theta_r: f64,
    /// φ_i - φ_r; zero is backscatter.
    pub delta_phi: f64,
    /// f in 1/sr. Noise can make it negative.
    pub rgb: [f64; 3],
}

/// The measurements of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Name of the material: the stem of the file name.
    pub name: String,
    /// At least one measurement, in file order.
    pub samples: Vec<Measurement>,
}

/// Reads the measurements of one material.
///
/// # Errors
///
/// If the file cannot be read, a column is missing, a row has the wrong length, a field is not a
/// finite number, a polar angle is outside \[0, π/2\] by more than 1e-9, or there is no row.
pub fn read(file: impl Into<InputFile>) -> Result<Measured> {
    let file = file.into();
    let path = file.path();
    let sheet = Sheet::read(file.clone(), COLUMNS)?;
    let wrong_header = || sheet.wrong_header("theta_i,phi_i,theta_r,phi_r and r,g,b or value");
    let angles =
        sheet.columns(["theta_i", "phi_i", "theta_r", "phi_r"]).ok_or_else(wrong_header)?;
    let values = sheet.colors()?.ok_or_else(wrong_header)?;
    let samples =
        sheet.rows().map(|row| sample(row, angles, values)).collect::<Result<Vec<_>>>()?;
    if samples.is_empty() {
        return Err(Error::new(
            "it contains no measurement",
            format!("add rows below the header `{COLUMNS}`"),
        )
        .in_file(path));
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Measured { name: name.into_owned(), samples })
}

fn sample(row: Row<'_>, angles: [usize; 4], values: [usize; 3]) -> Result<Measurement> {
    let polar = |name, column| {
        let angle = row.number(column)?;
        polar_angle(angle).ok_or_else(|| row.fault(outside(name, angle), POLAR_REMEDY))
    };
    let [theta_i, phi_i, theta_r, phi_r] = angles;
    let [r, g, b] = values;
    Ok(Measurement {
        theta_i: polar("theta_i", theta_i)?,
        theta_r: polar("theta_r", theta_r)?,
        delta_phi: row.number(phi_i)? - row.number(phi_r)?,
        rgb: [row.number(r)?, row.number(g)?, row.number(b)?],
    })
}

/// The remedy for an invalid polar angle.
pub(super) const POLAR_REMEDY: &str =
    "give radians from the normal, and leave out directions below the surface";

/// The message for an invalid polar angle.
pub(super) fn outside(name: &str, angle: f64) -> String {
    format!("{name} = {angle} is outside [0, pi/2]")
}

/// Clamps an angle to \[0, π/2\]; `None` if it is outside by more than rounding.
pub(super) fn polar_angle(angle: f64) -> Option<f64> {
    (-RIM_SLACK..=FRAC_PI_2 + RIM_SLACK).contains(&angle).then(|| angle.clamp(0.0, FRAC_PI_2))
}

//! How the samples of a PNG represent light, according to the file.

use png::Info;

/// Bytes before the first chunk.
const SIGNATURE: usize = 8;

/// The values 1 and 1 / 2.2 in a gAMA chunk, in units of 1/100,000.
const LINEAR_GAMMA: u32 = 100_000;
const SRGB_GAMMA: u32 = 45_455;

/// How a PNG's samples represent light, as declared in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Not declared.
    Unsaid,
    /// Proportional to light.
    Linear,
    /// The curve of IEC 61966-2-1.
    Srgb,
    /// Another curve, or a declaration that is not supported; the text describes it.
    Other(String),
}

impl Curve {
    /// Uses the first of the chunks cICP, sRGB, iCCP and gAMA that is present.
    ///
    /// Transfer characteristics 8 and 13 of cICP (ITU-T H.273) are linear and sRGB. A gAMA of 1 is
    /// linear and one of 0.45455 is sRGB, each within one unit of the last digit. Color profiles
    /// are not unpacked.
    pub(super) fn of(info: &Info<'_>, bytes: &[u8]) -> Self {
        let points = info.coding_independent_code_points.map(|points| points.transfer_function);
        let gamma = info.gama_chunk.map(png::ScaledFloat::into_scaled);
        match (points, gamma) {
            (Some(8), _) => Self::Linear,
            (Some(13), _) => Self::Srgb,
            (Some(other), _) => Self::Other(format!("its cICP chunk has the transfer {other}")),
            _ if info.srgb.is_some() => Self::Srgb,
            _ if has_profile(bytes) => Self::Other("it has a color profile".to_owned()),
            (None, Some(gamma)) if gamma.abs_diff(LINEAR_GAMMA) <= 1 => Self::Linear,
            (None, Some(gamma)) if gamma.abs_diff(SRGB_GAMMA) <= 1 => Self::Srgb,
            (None, Some(gamma)) => {
                Self::Other(format!("its gAMA chunk says {}", f64::from(gamma) / 1e5))
            }
            (None, None) => Self::Unsaid,
        }
    }
}

/// Whether an iCCP chunk precedes the image data.
fn has_profile(bytes: &[u8]) -> bool {
    let mut rest = bytes.get(SIGNATURE..).unwrap_or_default();
    // Each chunk has a length, a kind, contents and a checksum.
    while let Some(([a, b, c, d, kind @ ..], after)) = rest.split_first_chunk::<8>() {
        match kind {
            b"iCCP" => return true,
            b"IDAT" => return false,
            _ => {}
        }
        let length = u32::from_be_bytes([*a, *b, *c, *d]) as usize;
        rest = after.get(length.saturating_add(4)..).unwrap_or_default();
    }
    false
}

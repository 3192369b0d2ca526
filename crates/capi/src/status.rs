//! Statuses and their messages.

use core::ffi::{CStr, c_char};
use eigenshade::{Argument, Error};

/// The result of every function that can fail: 0, or the reason why it did nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// Success.
    Ok = 0,
    /// A pointer is NULL.
    NullPointer = 1,
    /// A pointer is not aligned for its type.
    Unaligned = 2,
    /// An array that is written to overlaps another.
    Overlap = 3,
    /// The degree of a light is above EIGENSHADE_DEGREE.
    LightBeyond = 4,
    /// A light does not have (degree + 1)^2 coefficients.
    LightLength = 5,
    /// The order of a material is above EIGENSHADE_ORDER.
    MaterialBeyond = 6,
    /// A material does not have the number of coefficients of its order, or an exponent for each o.
    MaterialLength = 7,
    /// More than EIGENSHADE_COMPONENTS components.
    Components = 8,
    /// An exponent is out of its range.
    Exponent = 9,
    /// A normal has a component that is not finite, length zero, or, in integers, a length other
    /// than 1.
    Normal = 10,
    /// A normal points away from the camera.
    Hidden = 11,
    /// More normals than memory can hold.
    Count = 12,
    /// A fault of the library.
    Internal = 13,
    /// A row of a transfer is so large that its sum with a light could overflow: no function of
    /// this library computed it.
    Transfer = 14,
    /// A coefficient of a light or a material is infinite or NaN.
    NotFinite = 15,
}

impl Status {
    /// The status of a result.
    pub(crate) fn of(found: impl FnOnce() -> Result<(), Self>) -> Self {
        match found() {
            Ok(()) => Self::Ok,
            Err(status) => status,
        }
    }
}

impl From<Error> for Status {
    fn from(error: Error) -> Self {
        match error {
            Error::Count { argument: Argument::Light, .. }
            | Error::Length { argument: Argument::Light, .. } => Self::LightLength,
            Error::Count { argument: Argument::Material, .. }
            | Error::Length { argument: Argument::Material, .. } => Self::MaterialLength,
            Error::Length { argument: Argument::Coefficients, .. } => Self::Components,
            Error::Beyond { argument: Argument::Light, .. } => Self::LightBeyond,
            Error::Beyond { argument: Argument::Material, .. } => Self::MaterialBeyond,
            Error::Exponent => Self::Exponent,
            Error::Normal => Self::Normal,
            Error::Hidden => Self::Hidden,
            Error::Bound => Self::Transfer,
            Error::NotFinite { .. } => Self::NotFinite,
            // The arrays are those of the table, whose lengths are constants.
            _ => Self::Internal,
        }
    }
}

/// The message of a status, with the remedy: a static string in English without a line end.
///
/// Never fails: an unknown status has a message too.
#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_message(status: i32) -> *const c_char {
    message(status).as_ptr()
}

fn message(status: i32) -> &'static CStr {
    match status {
        0 => c"success",
        1 => c"a pointer is NULL; pass the address of a value",
        2 => c"a pointer is not aligned for its type; point to a value of the type itself",
        3 => c"an array that is written to overlaps another; use separate arrays",
        4 => c"the degree of the light is above EIGENSHADE_DEGREE; leave out the coefficients above it",
        5 => c"a light has (degree + 1)^2 coefficients; check degree and length",
        6 => c"the order of the material is above EIGENSHADE_ORDER; leave out the coefficients above it",
        7 => c"the lengths of a material do not match its order; check order and lengths",
        8 => c"too many components; use at most EIGENSHADE_COMPONENTS",
        9 => c"an exponent is out of range; scale the numbers",
        10 => c"a normal is not a unit vector; scale it to length 1",
        11 => c"a normal points away from the camera; leave it out",
        12 => c"more normals than memory can hold; check the count",
        13 => c"a bug in the library; please report it",
        14 => c"a transfer could overflow the sums; use one that this library computed",
        15 => c"a coefficient is infinite or NaN; leave it out, or scale the numbers down",
        _ => c"unknown status; compare the versions of header and library",
    }
}

//! What a function answers, and what that says.

use core::ffi::{CStr, c_char};
use eigenshade::{Error, What};

/// What every function that can fail answers: 0, or why it did nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(i32)]
pub enum Status {
    /// All is well.
    Ok = 0,
    /// A pointer is NULL.
    NullPointer = 1,
    /// A pointer is not aligned to what it points to.
    Unaligned = 2,
    /// An array that is written to overlaps another.
    Overlap = 3,
    /// A light's degree is beyond EIGENSHADE_DEGREE.
    LightBeyond = 4,
    /// A light does not have (degree + 1)^2 coefficients.
    LightLength = 5,
    /// A material's order is beyond EIGENSHADE_ORDER.
    MaterialBeyond = 6,
    /// A material does not have the coefficients of its order, or an exponent for each o.
    MaterialLength = 7,
    /// More than EIGENSHADE_COMPONENTS components.
    Components = 8,
    /// An exponent is out of its range.
    Exponent = 9,
    /// A normal has a component that is not finite, length zero, or in integers another
    /// length than 1.
    Normal = 10,
    /// A normal points away from the camera.
    Hidden = 11,
    /// More normals than memory can hold.
    Count = 12,
    /// A fault of the library.
    Internal = 13,
    /// A row of a transfer is so large that its sum with a light could overflow: no
    /// material was folded into it.
    Transfer = 14,
    /// A coefficient of a light or a material is infinite or NaN.
    NotFinite = 15,
}

impl Status {
    /// What a function found.
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
            Error::Length { what: What::Light, .. } => Self::LightLength,
            Error::Length { what: What::Material, .. } => Self::MaterialLength,
            Error::Length { what: What::Coefficients, .. } => Self::Components,
            Error::Beyond { what: What::Light, .. } => Self::LightBeyond,
            Error::Beyond { what: What::Material, .. } => Self::MaterialBeyond,
            Error::Exponent => Self::Exponent,
            Error::Normal => Self::Normal,
            Error::Hidden => Self::Hidden,
            Error::Bound => Self::Transfer,
            Error::NotFinite { .. } => Self::NotFinite,
            // The arrays are the table's own, their lengths constants.
            _ => Self::Internal,
        }
    }
}

/// What a status says, and what to do: a static string in English, without a line's end.
///
/// Never fails: of a number that is no status it says so.
#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub extern "C" fn eigenshade_message(status: i32) -> *const c_char {
    message(status).as_ptr()
}

fn message(status: i32) -> &'static CStr {
    match status {
        0 => c"all is well",
        1 => c"a pointer is NULL; give the address of what it is to point to",
        2 => c"a pointer is not aligned to what it points to; point to the type itself",
        3 => c"an array that is written to overlaps another; give one of its own",
        4 => c"the light's degree is beyond EIGENSHADE_DEGREE; leave out what is above",
        5 => c"a light has (degree + 1)^2 coefficients; check degree and length",
        6 => c"the material's order is beyond EIGENSHADE_ORDER; leave out what is above",
        7 => c"a material has other lengths than its order's; check order and lengths",
        8 => c"there are not so many components; take at most EIGENSHADE_COMPONENTS",
        9 => c"an exponent is out of range; scale the numbers",
        10 => c"a normal is not a unit vector; scale it to length 1",
        11 => c"a normal points away from the camera; leave it out",
        12 => c"more normals than memory can hold; check their number",
        13 => c"a fault of the library; please report it",
        14 => c"a transfer could overflow its sums; take one that a material was folded into",
        15 => c"a coefficient is infinite or NaN; leave it out, or scale the numbers down",
        _ => c"a number that is no status of this version; compare header and library",
    }
}

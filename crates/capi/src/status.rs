//! Statuses and their messages.

use crate::table;
use core::ffi::{CStr, c_char};
use eigenshade::{Argument, Error};
use eigenshade_table::{light, material};

macro_rules! statuses {
    ($($status:ident = $number:literal: $message:literal)*) => {
        /// The result of every function that can fail: 0, or the reason why it did nothing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[repr(i32)]
        pub(crate) enum Status {
            $($status = $number,)*
        }

        #[cfg(test)]
        pub(crate) const STATUSES: &[Status] = &[$(Status::$status),*];

        fn message(status: i32) -> &'static CStr {
            match status {
                $($number => $message,)*
                _ => c"unknown status; compare the versions of header and library",
            }
        }
    };
}

statuses! {
    Ok = 0: c"success"
    NullPointer = 1: c"a pointer is NULL; pass the address of a value"
    Unaligned = 2: c"a pointer is not aligned for its type; point to a value of the type itself"
    Overlap = 3: c"an array that is written to overlaps another; use separate arrays"
    LightBeyond = 4:
        c"the degree of the light is above EIGENSHADE_DEGREE; leave out the coefficients above it"
    LightLength = 5: c"a light has (degree + 1)^2 coefficients; check degree and length"
    MaterialBeyond = 6:
        c"the order of the material is above EIGENSHADE_ORDER; leave out the coefficients above it"
    MaterialLength = 7: c"the lengths of a material do not match its order; check order and lengths"
    Components = 8: c"too many components; use at most EIGENSHADE_COMPONENTS"
    Exponent = 9: c"an exponent is out of range; scale the numbers"
    Normal = 10: c"a normal is zero, not finite, or, in integers, no unit vector; leave it out, or scale it"
    Hidden = 11: c"a normal points away from the camera; leave it out"
    Count = 12: c"more normals than memory can hold; check the count"
    Internal = 13: c"a bug in the library; please report it"
    Transfer = 14: c"a transfer could overflow the sums; use one that this library computed"
    NotFinite = 15: c"a coefficient is infinite or NaN; leave it out, or scale the numbers down"
    Outside = 16: c"a color, reflectance, metallic or roughness is not from 0 to 1; clamp it"
    Rotation = 17: c"a rotation is zero or not finite; use a quaternion, or cosine and sine"
    Row = 18: c"the object has no such row, or the buffer is shorter than one; check both"
    Diameter = 19: c"a disc has a diameter of 1 to 4096 pixels; check it"
    NormalMap = 20: c"a normal map has at least one pixel, and two bytes for each; check its size"
    Exposure = 21: c"an exposure is not a number above 0; check it"
    Baked = 22: c"a baked map has 2 to 4096 texels a side and three times its square; check both"
    Source = 23: c"a source has wrong numbers, or there are over EIGENSHADE_SOURCES; check both"
    Turn = 24: c"lights are turned to degree 12; leave out the coefficients above it"
    Scene = 25: c"a scene was never computed; call color_scene, color_relight or collapse first"
    Dark = 26: c"no pixel was metered, or all of them are black; meter the rows of a lit picture"
}

#[expect(unsafe_code, reason = "an exported symbol")]
#[unsafe(no_mangle)]
pub(crate) extern "C" fn eigenshade_message(status: i32) -> *const c_char {
    message(status).as_ptr()
}

impl From<Result<(), Self>> for Status {
    fn from(result: Result<(), Self>) -> Self {
        result.err().unwrap_or(Self::Ok)
    }
}

impl From<Error> for Status {
    fn from(error: Error) -> Self {
        match error {
            Error::Exponent => Self::Exponent,
            Error::Normal | Error::NotUnit => Self::Normal,
            Error::Hidden => Self::Hidden,
            Error::Bound => Self::Transfer,
            Error::NotFinite { argument: Argument::Exposure, .. } => Self::Exposure,
            Error::NotFinite { .. } | Error::Saturated { .. } => Self::NotFinite,
            Error::Outside { .. } => Self::Outside,
            Error::Rotation => Self::Rotation,
            Error::Source => Self::Source,
            Error::Degree { .. } => Self::Turn,
            // The lengths of lights and materials are checked below, all others are constants.
            _ => Self::Internal,
        }
    }
}

/// Checks the degree of a light and the number of its coefficients.
pub(crate) fn light_shape(degree: usize, length: usize) -> Result<(), Status> {
    if degree > table::DEGREE {
        Err(Status::LightBeyond)
    } else if length != light::count(degree) {
        Err(Status::LightLength)
    } else {
        Ok(())
    }
}

/// Checks the order of a material and the number of its coefficients.
pub(crate) fn material_shape(order: usize, length: usize) -> Result<(), Status> {
    if order > table::ORDER {
        Err(Status::MaterialBeyond)
    } else if length != material::count(order) {
        Err(Status::MaterialLength)
    } else {
        Ok(())
    }
}

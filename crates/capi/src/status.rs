//! Statuses and their messages.

use crate::table;
use core::ffi::CStr;
use eigenshade::{Argument, Error};
use eigenshade_table::{light, material};

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
    /// The degree of a light is above EIGENSHADE_DEGREE, or above that of an object with shadows.
    LightBeyond = 4,
    /// A light does not have (degree + 1)^2 coefficients.
    LightLength = 5,
    /// The order of a material is above EIGENSHADE_ORDER.
    MaterialBeyond = 6,
    /// A material does not have the number of coefficients of its order, or an exponent for each o.
    MaterialLength = 7,
    /// An exponent is out of its range.
    Exponent = 8,
    /// A normal has a component that is not finite, length zero, or, in integers, a length other
    /// than 1.
    Normal = 9,
    /// A normal points away from the camera.
    Hidden = 10,
    /// An array is larger than memory.
    Count = 11,
    /// A fault of the library.
    Internal = 12,
    /// A row of a transfer is so large that its sum with a light could overflow: no function of
    /// this library computed it.
    Transfer = 13,
    /// A coefficient of a light or a material is infinite or NaN.
    NotFinite = 14,
    /// A color, metallic or roughness is not from 0 to 1.
    Outside = 15,
    /// A quaternion, or cosine and sine, are zero or not finite; or, in f32, cosine² + sine²
    /// differs from 1 by more than 2 %.
    Rotation = 16,
    /// The object has no such row.
    Row = 17,
    /// A disc has no pixel, or more than 4096 across.
    Diameter = 18,
    /// A normal map has no pixel, or not two bytes for each.
    NormalMap = 19,
    /// An exposure is not a number above 0.
    Exposure = 20,
    /// A baked map does not have 2 to 4096 texels a side, or its length is not three times the
    /// square of a side.
    Baked = 21,
    /// A source has wrong numbers, or there are more than EIGENSHADE_SOURCES.
    Source = 22,
    /// A light above degree 12, beyond which none is turned.
    Turn = 23,
    /// A picture that was never begun, such as one of zeros.
    Picture = 24,
    /// A meter has counted no pixel, or only black ones.
    Dark = 25,
    /// A picture with highlights, which are too sharp for a baked map.
    Highlights = 26,
    /// A number that is none of `eigenshade_effect`.
    Effect = 27,
    /// A target has no pixel, its rows do not fit its stride and length, or the rows of
    /// `EIGENSHADE_ENCODING_RGB565` have an odd stride.
    Target = 28,
    /// A number that is none of `eigenshade_encoding`.
    Encoding = 29,
    /// A palette that was never filled, such as one of zeros.
    Palette = 30,
    /// Nodes that were never found, such as those of zeros.
    Nodes = 31,
    /// The bytes of an object, textured or with shadows, are something else, or were cut or changed.
    Object = 32,
    /// A textured object has no region of this number, or more regions than there are palettes.
    Region = 33,
    /// The colors of an object with shadows have the wrong number of bytes: one pixel of the encoding for
    /// each of its codes.
    Colors = 34,
    /// Coefficients of an object that were never found, such as those of zeros.
    Coefficients = 35,
}

/// The message of a status.
pub(crate) fn message(status: i32) -> &'static CStr {
    match status {
        0 => c"success",
        1 => c"a pointer is NULL; pass the address of a value",
        2 => c"a pointer is not aligned for its type; point to a value of the type itself",
        3 => c"an array that is written to overlaps another; use separate arrays",
        4 => {
            c"the degree of the light is above that of the table or object; leave out the coefficients above"
        }
        5 => c"a light has (degree + 1)^2 coefficients; check degree and length",
        6 => {
            c"the order of the material is above EIGENSHADE_ORDER; leave out the coefficients above it"
        }
        7 => c"the lengths of a material do not match its order; check order and lengths",
        8 => c"an exponent is out of range; scale the numbers",
        9 => {
            c"a normal is zero, not finite, or, in integers, no unit vector; leave it out, or scale it"
        }
        10 => c"a normal points away from the camera; leave it out",
        11 => c"more numbers than memory can hold; check the count",
        12 => c"a bug in the library; please report it",
        13 => c"a transfer could overflow the sums; use one that this library computed",
        14 => c"a coefficient is infinite or NaN; leave it out, or scale the numbers down",
        15 => c"a color, reflectance, metallic or roughness is not from 0 to 1; clamp it",
        16 => c"a rotation is zero or not finite; use a quaternion, or cosine and sine",
        17 => c"the object has no such row; check the row",
        18 => c"a disc has a diameter of 1 to 4096 pixels; check it",
        19 => c"a normal map has at least one pixel, and two bytes for each; check its size",
        20 => c"an exposure is not a number above 0; check it",
        21 => c"a baked map has 2 to 4096 texels a side and three times its square; check both",
        22 => c"a source has wrong numbers, or there are over EIGENSHADE_SOURCES; check both",
        23 => c"lights are turned to degree 12; leave out the coefficients above it",
        24 => c"a picture was never begun; call picture_begin or picture_relight first",
        25 => c"no pixel was metered, or all of them are black; meter the rows of a lit picture",
        26 => {
            c"highlights are too sharp for a baked map; bake the picture of the light without sources"
        }
        27 => c"no effect has this number; use one of eigenshade_effect",
        28 => c"a target has no pixel, or no room for its rows; check size, stride and length",
        29 => c"no encoding has this number; use one of eigenshade_encoding",
        30 => c"a palette was never filled; call palette_fill first",
        31 => c"the nodes were never found; call nodes_of_normal_map or nodes_of_region",
        32 => c"the bytes are no object of this kind, or were cut or changed; pack the object anew",
        33 => c"the object has no such region, or more regions than palettes; check the number",
        34 => c"an object has a color for each of its codes; check the encoding and the length in bytes",
        35 => c"no coefficients were found; call shadowed_object_coefficients first",
        _ => c"unknown status; compare the versions of header and library",
    }
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
            Error::Object => Self::Object,
            Error::Length { argument: Argument::Palettes, .. } => Self::Region,
            Error::Beyond { .. } => Self::Turn,
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

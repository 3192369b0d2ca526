//! Errors in the arguments of the runtime.

use crate::index::layout::{MAX_DEGREE, MAX_ORDER};
use crate::index::light;
use core::fmt;

/// An invalid argument, with the expected and the found value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A slice has the wrong length.
    Length {
        /// Which argument.
        argument: Argument,
        /// The required length.
        expected: usize,
        /// The length found.
        found: usize,
    },
    /// A light or a material does not have the number of coefficients of any degree or order.
    Count {
        /// Which argument.
        argument: Argument,
        /// The number of coefficients found.
        found: usize,
    },
    /// A buffer of fixed capacity is too small for this basis.
    Capacity {
        /// Which buffer.
        argument: Argument,
        /// The length that it has to hold.
        needed: usize,
        /// The length that it can hold.
        capacity: usize,
    },
    /// A light or a material goes beyond the degree or order of the basis, a light to be turned
    /// beyond degree 16 (12 about the view axis), or coefficients of irradiance beyond degree 2.
    Beyond {
        /// Which argument.
        argument: Argument,
        /// The largest degree or order that is taken.
        most: usize,
        /// The degree or order of the argument.
        found: usize,
    },
    /// The parts of a basis contradict each other. A profile has an azimuth beyond the degree, is
    /// out of order or belongs to a component that does not exist; a component has no profile or,
    /// in integers, two profiles; the positions of an azimuth do not match its profiles; a pass is
    /// beyond the degree or is not laid out as [`eigenshade_table::layout`] specifies; the slots do
    /// not contain the components where the profiles have their rows, or the runs differ from the
    /// profiles' rows.
    Parts,
    /// A number is not finite.
    NotFinite {
        /// Which argument.
        argument: Argument,
        /// The index of the number.
        index: usize,
    },
    /// A number exceeds the range of its integer.
    Saturated {
        /// Which argument.
        argument: Argument,
    },
    /// A normal has a component that is not finite, or has length zero.
    Normal,
    /// A normal that is used as it is does not have length 1.
    NotUnit,
    /// One of many normals has no direction, points away from the camera or, where normals are not
    /// scaled, does not have length 1.
    Normals {
        /// The index of the normal.
        index: usize,
    },
    /// A normal points away from the camera.
    Hidden,
    /// A basis that holds only transfers was asked to project a material.
    TransfersOnly,
    /// An exponent of Q15 numbers is beyond ±128, or one of coefficients beyond ±2^16.
    Exponent,
    /// A row of an integer table or transfer has a sum that could overflow its accumulator.
    Bound,
    /// The weights of an estimate's pixels do not have a finite sum above zero.
    Weight,
    /// The size of a square picture is out of range: a baked map has 2 to 4096 texels a side, a
    /// [`Disc`](crate::object::Disc) 1 to 4096 pixels, and a [`Matcap`](crate::object::Matcap) at least one.
    Size {
        /// The number of pixels a side.
        found: usize,
    },
    /// A picture has no pixel.
    Empty {
        /// Which argument.
        argument: Argument,
    },
    /// A parameter of a material is not from 0 to 1.
    Outside {
        /// Which parameter.
        argument: Argument,
    },
    /// The bytes of an object are not those of a file that `pack-object` of this version wrote, or
    /// were cut or changed.
    Object,
    /// Angles, cosine and sine, a quaternion or a matrix do not describe a rotation.
    Rotation,
    /// A light's direction has no length or is not finite, or its radius is not above 0 and at most
    /// π.
    Direction,
    /// A basis goes beyond degree 12 or order 12.
    High {
        /// The degree of the basis.
        degree: usize,
        /// The order of the basis.
        order: usize,
    },
    /// A tolerance is not finite or not above zero.
    Tolerance,
    /// A source of light is not a small blob of positive energy: its direction is not a unit vector
    /// to within 1e-3, a number is not finite, a channel of its energy is below 0, or its spread
    /// is not from 0 to 0.5 rad.
    Source,
}

/// The argument or part of a basis that an [`Error`] refers to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Argument {
    /// Coefficients of a light.
    Light,
    /// Coefficients of a material.
    Material,
    /// Coefficients of irradiance.
    Irradiance,
    /// A color that tints a material, its base color, or the albedo of its matte base.
    Color,
    /// The share of a material that is metal.
    Metallic,
    /// The roughness of a material.
    Roughness,
    /// The exposure of a picture.
    Exposure,
    /// The radius of a matcap's disc.
    Radius,
    /// Coefficients of eigenimages.
    Coefficients,
    /// The workspace of a projection.
    Workspace,
    /// A transfer: a material combined with a basis.
    Transfer,
    /// A collapsed scene.
    Scene,
    /// A slice of normals or of their irradiances.
    Normals,
    /// The bytes of a normal map, two for each pixel.
    NormalMap,
    /// The palettes of an object's regions.
    Palettes,
    /// The colors of the codes of an object with shadows.
    Colors,
    /// The pixels of a picture that a disc is drawn into.
    Picture,
    /// Images of a set, and the values reported for each.
    Images,
    /// Texels of a baked map.
    Texels,
    /// Sources of light.
    Sources,
    /// The reflectance of a material at normal incidence, f0.
    Reflectance,
    /// Part of a basis: polar integrals.
    Polar,
    /// Part of a basis: factors of UᵀM.
    Factors,
    /// Part of a basis: the components of the lanes of a transfer.
    Slots,
    /// Part of a basis: polynomial terms.
    Terms,
    /// Part of a basis: lengths of the polynomials.
    Lengths,
}

impl Error {
    pub(crate) const fn check(
        argument: Argument,
        expected: usize,
        found: usize,
    ) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self::Length { argument, expected, found }) }
    }

    /// `Ok` if there are not more coefficients of eigenimages than a basis has components.
    pub(crate) fn check_components(components: usize, found: usize) -> Result<(), Self> {
        let (argument, expected) = (Argument::Coefficients, components);
        if found > components { Err(Self::Length { argument, expected, found }) } else { Ok(()) }
    }

    /// `Ok` if a basis of this degree and order is one of the runtime.
    pub(crate) const fn check_shape(degree: usize, order: usize) -> Result<(), Self> {
        let fits = degree <= MAX_DEGREE && order <= MAX_ORDER;
        if fits { Ok(()) } else { Err(Self::High { degree, order }) }
    }

    /// `Ok` for a degree or order of at most `most`.
    pub(crate) fn check_beyond(argument: Argument, most: usize, found: usize) -> Result<(), Self> {
        if found > most { Err(Self::Beyond { argument, most, found }) } else { Ok(()) }
    }

    /// The first error of several checks.
    pub(crate) const fn first(mut checks: &[Result<(), Self>]) -> Result<(), Self> {
        while let [check, rest @ ..] = checks {
            if check.is_err() {
                return *check;
            }
            checks = rest;
        }
        Ok(())
    }

    /// `Ok` if all numbers are from the first of the range to the last.
    pub(crate) fn check_range<T: PartialOrd, const P: usize>(
        argument: Argument,
        numbers: [T; P],
        [least, most]: [T; 2],
    ) -> Result<(), Self> {
        let fits = numbers.iter().all(|number| *number >= least && *number <= most);
        if fits { Ok(()) } else { Err(Self::Outside { argument }) }
    }

    /// `Ok` for the degree of a light that can be turned by any rotation.
    #[inline]
    pub(crate) fn check_turned(degree: usize) -> Result<(), Self> {
        Self::check_beyond(Argument::Light, light::MAX_DEGREE, degree)
    }

    /// `Ok` for the degree of a light that can be turned about the view axis.
    #[inline]
    pub(crate) fn check_degree(degree: usize) -> Result<(), Self> {
        Self::check_beyond(Argument::Light, MAX_DEGREE, degree)
    }

    pub(crate) fn check_finite(argument: Argument, numbers: &[f32]) -> Result<(), Self> {
        match numbers.iter().position(|number| !number.is_finite()) {
            None => Ok(()),
            Some(index) => Err(Self::NotFinite { argument, index }),
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { argument: Argument::Picture, expected, found } => write!(
                f,
                "Picture: {expected} pixels expected, {found} found; give a square as wide as the \
                 disc"
            ),
            Self::Length { argument: Argument::Palettes, expected, found } => write!(
                f,
                "{expected} palettes expected, {found} found; give one for each region of the object"
            ),
            Self::Length { argument: Argument::Colors, expected, found } => write!(
                f,
                "{expected} colors expected, {found} found; give one for each code of the object"
            ),
            Self::Length { argument, expected, found } => {
                write!(f, "{argument:?}: {expected} numbers expected, {found} found")
            }
            Self::Count { argument: Argument::Material, found } => write!(
                f,
                "Material: {found} coefficients do not fill all orders up to any o; give 1, 2, 5, \
                 8, 14, 20, 30, 40, ... of them"
            ),
            Self::Count { argument, found } => write!(
                f,
                "{argument:?}: {found} coefficients do not fill all degrees up to any l; give \
                 (l + 1)² of them"
            ),
            Self::Capacity { argument: Argument::Sources, needed, capacity } => write!(
                f,
                "Sources: {needed} of them, room for {capacity}; give the strongest, or make room for \
                 more"
            ),
            Self::Capacity { argument, needed, capacity } => write!(
                f,
                "{argument:?}: {needed} numbers needed, room for {capacity}; take the capacity that \
                 the basis states"
            ),
            Self::Beyond { argument: Argument::Irradiance, most, found } => write!(
                f,
                "coefficients of irradiance of degree {found}: above degree {most} the cosine leaves \
                 too little of the light; give the first 9"
            ),
            Self::Beyond { argument, most, found } => write!(
                f,
                "{argument:?}: {} {most} at most, {found} found; truncate it, or make a larger basis",
                if matches!(argument, Argument::Material) { "order" } else { "degree" }
            ),
            Self::Parts => f.write_str(
                "the profiles, azimuths, passes, runs or slots of the basis contradict each other; \
                 take all parts from one table",
            ),
            Self::NotFinite { argument: Argument::Exposure, .. } => {
                f.write_str("an exposure must be a finite number above zero; give one such as 1")
            }
            Self::NotFinite { argument, index } => write!(
                f,
                "{argument:?}: number {index} (from 0) is not finite; leave it out, or scale the numbers \
                 down"
            ),
            Self::Empty { argument } => {
                write!(f, "{argument:?}: no pixel; give it a width and a height above 0")
            }
            Self::Outside { argument } => {
                write!(f, "{argument:?} is outside [0, 1]; give a number from 0 to 1")
            }
            Self::Saturated { argument } => write!(
                f,
                "{argument:?}: a number exceeds its integer format; scale the light or the weights down"
            ),
            Self::Normal => f.write_str("a normal has length zero or a component that is not finite; leave it out"),
            Self::NotUnit => f.write_str("a normal's length is not 1; scale it by `Normal::new`"),
            Self::Normals { index } => write!(
                f,
                "normal {index} (from 0) is no unit vector with z from 0 to 1; scale it by \
                 `Normals::normalized`, or leave it out if it points away from the camera"
            ),
            Self::Hidden => f.write_str("a normal points away from the camera (z < -1/8); leave it out"),
            Self::TransfersOnly => f.write_str(
                "the basis stores only the transfers of some materials; make one with store = \
                 \"projection\" to project others",
            ),
            Self::Exponent => f.write_str(
                "an exponent is beyond ±128, or ±65536 for coefficients; scale the numbers",
            ),
            Self::Bound => f.write_str(
                "a row of an integer table or transfer could overflow its sum; use it unchanged, as \
                 it was made",
            ),
            Self::Weight => f.write_str(
                "an estimate needs pixels whose weights have a finite sum above zero; add some",
            ),
            Self::High { degree, order } => write!(
                f,
                "the basis has degree {degree} and order {order}, of at most {MAX_DEGREE} and {MAX_ORDER}; \
                 make a smaller one, and give what is sharper as sources"
            ),
            Self::Tolerance => f.write_str("a tolerance must be finite and above zero; give one such as 0.01"),
            Self::Object => f.write_str(
                "the bytes are no object, or were cut or changed; take a file that `eigenshade \
                 pack-object` of this version wrote",
            ),
            Self::Rotation => f.write_str(
                "a rotation needs finite angles, the cosine and sine of one, a quaternion that is not \
                 zero, or an orthonormal right-handed matrix",
            ),
            Self::Direction => f.write_str(
                "a light needs a finite direction of some length, and an angular radius above 0 and \
                 at most π",
            ),
            Self::Source => f.write_str(
                "a source needs a unit direction, finite energies of at least 0, and a spread of \
                 0 to 0.5 rad; leave a wider one in the light",
            ),
            Self::Size { found } => {
                write!(f, "a picture of {found} pixels a side; take 1 to 4096 for a disc, 2 to 4096 for a \
                 baked map, at least 1 for a matcap")
            }
        }
    }
}

impl core::error::Error for Error {}

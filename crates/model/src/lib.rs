//! The model from which eigenshade tables are computed, the evaluation of tables in f64, the
//! coefficient files, and the shipped data.
//!
//! The modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", ICCV 2003; "(n)" in these pages is equation n of that paper.
//!
//! The irradiance of a matte white sphere where it faces the camera and at its rim, by the direct
//! sum over all modes:
//!
//! ```
//! use eigenshade_model::reference::DirectSum;
//!
//! let (light, white) = ([3.5, 0.0, 1.0, 0.0], [2.0]);
//! let sum = DirectSum::new(1, 0);
//! let [facing, rim] = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]].map(|normal| {
//!     let modes = sum.at(normal);
//!     modes.irradiance(&light, &modes.scatter(&white))
//! });
//! assert!(facing > rim && rim > 0.0);
//! ```

pub mod special {
    //! Special functions by normalized recurrences: accurate to degree 64 and more, at the poles
    //! and at tiny angles.

    pub mod quadrature;
    pub mod spherical_harmonic;
    pub mod wigner;
    pub mod zernike;
}

pub mod vector;

pub mod rotation;

pub mod sphere_rings;

pub mod polar_integral;

pub mod scattering;

pub mod irradiance;

pub mod selection;

pub mod reference;

pub mod task;

pub mod parallel;

pub mod reference_image;

mod orthogonal_series;

pub mod evaluation;

pub mod window;

pub mod error;

pub mod database;

pub mod overflow;

pub mod source;

pub mod highlights;

pub mod highlight_constants;

pub mod srgb;

pub mod screen;

pub mod inputs {
    //! Coefficients, sources and normals as files.

    pub mod coefficient_csv;
    pub mod coefficient_text;
    pub mod gloss_csv;
    pub mod input_file;
    pub mod normals;
    pub mod sheet;
    pub mod source_csv;
    pub mod source_error_csv;
}

pub mod shipped;

pub mod output;

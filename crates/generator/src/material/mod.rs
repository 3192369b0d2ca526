//! Materials: BRDFs as functions or measurements, and their coefficients.

pub mod analytic;
pub mod brdf;
pub mod curet;
pub mod files;
pub mod fit;
pub(crate) mod fit_channel;
pub mod fit_constraints;
pub(crate) mod fit_program;
pub mod measurements;
pub mod merl;

//! Every tolerance of the project's tests, one line each, with its reason.
#![allow(dead_code, reason = "each test takes the tolerances that it needs")]

/// Special functions up to degree 9: a few hundred roundings of numbers of order one.
pub const SPECIAL_LOW: f64 = 1e-13;
/// Special functions up to degree 64: some 64 recurrence steps whose errors add.
pub const SPECIAL_HIGH: f64 = 1e-11;

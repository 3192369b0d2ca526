//! Objects with materials of their own.

mod bad_files;
mod drawn;
mod formats;
mod hard_cases;
mod support;

//! The Python package `eigenshade`: light, materials and eigenimages as numpy arrays.
//!
//! Its classes are those of the host's crates; arrays are in f64 unless they state otherwise.

mod arrays;
mod light;
mod material;
mod picture;
mod reading;
mod shipped;
mod table;
mod table_arrays;
mod work;

use pyo3::prelude::*;

#[pymodule]
mod _eigenshade {
    /// The version of the package.
    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "its name in Python")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
    #[pymodule_export]
    use crate::light::Light;
    #[pymodule_export]
    use crate::material::Material;
    #[pymodule_export]
    use crate::reading::Reading;
    #[pymodule_export]
    use crate::shipped::{lights, materials, missing};
    #[pymodule_export]
    use crate::table::Table;
}

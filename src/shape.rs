//! Tables whose sizes are known when the program is compiled.
//!
//! Each step of the runtime is one function of a place, such as [`Run`]: what the table says about
//! one part of the work. For a table that is known only at run time, a loop asks for one place
//! after the other. For a [`Shape`] the places are constants, and the compiler specializes the same
//! function for each of them.

/// A table that is known when the program is compiled, with a basis of type `B`.
pub trait Shape<B: 'static> {
    /// The basis.
    const BASIS: &'static B;
}

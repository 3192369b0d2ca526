//! The command line of eigenshade, as a library: what its tests and benches
//! share with the program.

pub mod owned_basis;

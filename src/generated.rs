//! The table of a scene, made when this crate was built: of the scene file that the
//! environment variable `EIGENSHADE_SCENE` named then, or of the shipped one.
//!
//! It has what the module `sphere` has, with the sizes of its scene; the modules
//! `q15` and `q31` are there if integers serve the scene.

include!(concat!(env!("OUT_DIR"), "/generated.rs"));

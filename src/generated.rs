//! The table of a scene, generated when this crate was built. The environment variable
//! `EIGENSHADE_SCENE` names the scene file at build time; without it, the shipped one is used.
//!
//! This module has the same items as the module `sphere`, with the sizes of its own scene. The
//! modules `q15` and `q31` exist if the scene can be represented in integers.

include!(concat!(env!("OUT_DIR"), "/generated.rs"));

//! Finds the small bright sources of captured light.
//!
//! Spherical harmonics describe a lamp, a window or the sun as a wide patch, whose reflection on a
//! glossy material is as wide. The runtime can shade a few such sources by the microfacet formula
//! instead: see [`eigenshade::Source`] and [`eigenshade::Highlights`]. [`find`](pursuit::find)
//! chooses them so that pictures of glossy materials are as near as possible to direct integration
//! of the whole map.
//!
//! Direct integration of maps, without harmonics, is here too: [`light_tree`], at the normals of
//! [`mirrored`].

pub mod sphere;

pub mod screen;

pub mod texels;

pub mod light_tree;

pub mod mirrored;

pub mod response;

pub mod view;

pub mod sample;

pub mod pursuit;

pub mod remaining;

pub mod gloss;

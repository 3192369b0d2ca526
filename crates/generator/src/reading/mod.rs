//! Reading an image: from pixels and their normals back to the components d, the
//! modes c, the light L and the material b.
//!
//! The pixels are taken into an [`Observation`](observation::Observation) once, which
//! then stands for them in every estimate: it has no more rows than a few above the
//! number of components. One channel is one image; channels are read by themselves.
//!
//! Tables of any object and any rotation of the light are read alike: where components
//! are sums over a span, so are their images, transfers and modes.
//!
//! The derivations are in `docs/reading.md`.

pub mod eigenimage_values;

pub mod reduction;

pub mod observation;

pub mod coefficients;

pub mod fit;

pub mod transfer;

pub mod light_prior;

pub mod prior;

pub mod posterior;

pub mod modes;

pub mod rank_one;

pub mod light_estimate;

pub mod nearest;

//! Makes eigenshade tables from captured light and measured materials, using the model of
//! [`eigenshade_model`].
//!
//! The modules follow the mathematics of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", ICCV 2003. In these pages, "(n)" is equation n of that paper.
//!
//! * [`light::projection`] projects environment maps.
//! * [`material`] fits measured BRDFs and projects formulas.
//! * [`scene_file`] reads a scene and makes its table; [`build`] does this in a build script.
//! * [`object`] draws the normals of meshes and normal maps.
//! * [`reading`] estimates light and material from an image.
//!
//! The light of an environment map:
//!
//! ```
//! use eigenshade_generator::light::environment::EnvironmentMap;
//! use eigenshade_generator::light::projection::project;
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/maps");
//! let rgb = project(&EnvironmentMap::from_path(format!("{folder}/sky.exr"))?, 2);
//! assert_eq!(rgb[0].len(), 9);
//! # Ok::<(), eigenshade_model::error::Error>(())
//! ```

pub mod orientation;

pub mod png_samples;

pub mod light {
    //! Captured light: environment maps and their coefficients.

    pub mod cube;
    pub mod environment;
    pub(crate) mod exr_layer;
    pub mod frame;
    pub mod map;
    pub(crate) mod map_exr;
    pub mod map_file;
    pub(crate) mod map_hdr;
    pub(crate) mod map_picture;
    pub(crate) mod primaries;
    pub mod projection;
}

pub mod material {
    //! Materials: BRDFs as functions or measurements, and their coefficients.

    pub mod analytic;
    pub mod brdf;
    pub mod files;
    pub mod fit;
    pub(crate) mod fit_channel;
    pub mod fit_constraints;
    pub mod measurements;
    pub mod merl;
    pub mod published_fits;
}

pub mod object {
    //! Objects: the normals that a camera sees.

    pub(crate) mod depth_buffer;
    pub mod facet;
    pub mod mesh;
    pub mod mesh_data;
    pub(crate) mod mesh_obj;
    pub(crate) mod mesh_ply;
    pub(crate) mod mesh_stl;
    pub mod normal_map;
    pub mod picture;
    pub mod points;
    pub mod smooth;
    pub mod surface;
}

pub mod basis;

pub mod highlights;

pub mod scene_file;

pub mod reading {
    //! Inverse rendering: from pixels and their normals back to the components d, the modes c, the
    //! light L and the material b.
    //!
    //! The pixels are collected once into an [`Observation`](observation::Observation), which then
    //! represents them in every estimate. It has at most a few rows more than the number of
    //! components. Each channel is an independent image.
    //!
    //! The derivations are in `docs/reading.md`.

    pub mod coefficients;
    pub mod light_estimate;
    mod linear;
    pub mod modes;
    pub mod observation;
    pub mod posterior;
    pub mod rank_one;
    pub mod reader;
    pub mod transfer;
}

pub mod build;

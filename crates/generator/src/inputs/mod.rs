//! What comes in from the world, and goes out to it as text.

pub mod analytic;
pub mod coefficient_csv;
mod coefficient_kind;
pub mod convention;
pub mod curet;
pub mod density;
pub mod environment;
pub mod fit;
mod fit_channel;
pub mod fit_constraints;
mod fit_programme;
pub mod light_projection;
mod map_exr;
mod map_exr_check;
mod map_hdr;
mod map_pfm;
pub mod material_files;
pub mod measurements;
pub mod merl;
pub mod mesh;
mod mesh_ply;
pub mod normal_map;
pub mod normals;
pub mod object;
pub mod png_samples;
pub mod rounding;
pub mod sheet;

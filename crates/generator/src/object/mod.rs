//! Objects: the normals that a camera sees.

pub mod density;
pub(crate) mod depth_buffer;
pub mod facet;
pub(crate) mod facet_samples;
pub mod geometry;
pub mod mesh;
pub(crate) mod mesh_obj;
pub(crate) mod mesh_ply;
pub(crate) mod mesh_stl;
pub mod normal_map;
pub mod source;
pub(crate) mod text_line;
pub mod visibility;

//! Every test of the generator except one that measures the memory of its process, in one binary:
//! linking each file separately takes longer than the tests do.

use eigenshade_testing::tolerances;

mod brdf;
mod brdf_projection;
mod build;
mod environment_maps;
mod light_csv;
mod material_files;
mod material_fits;
mod mesh_files;
mod shapes;
mod smooth_normals;
mod special_functions;
mod statistics;
mod visible_facets;

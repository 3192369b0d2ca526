//! Every test of the generator but one that weighs its process, in one binary: to link each file
//! by itself takes longer than the tests do.

use eigenshade_testing::tolerances;

mod any_object;
mod brdf;
mod build;
mod environment_maps;
mod light_csv;
mod material_fits;
mod measurements;
mod merl;
mod reference_values;
mod rotation;
mod scattering;
mod visible_facets;
mod weights;

//! `experiments glossy-materials`: the materials of the hardest case.

use clap::Args;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_testing::glossy;
use std::path::PathBuf;

/// GGX lobes at order 32, as a material CSV
#[derive(Args, Debug)]
pub struct GlossyMaterials {
    /// The file to write
    #[arg(value_name = "FILE")]
    out: PathBuf,
}

impl GlossyMaterials {
    pub fn run(self) -> Result<()> {
        let file =
            std::fs::File::create(&self.out).map_err(|error| Error::io(&self.out, &error))?;
        write_materials(&glossy::materials(32), &mut std::io::BufWriter::new(file))
    }
}

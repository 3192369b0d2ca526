//! The table from which the runtime computes materials of metallic and roughness.

use clap::Args;
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::output::{self, Rows};
use eigenshade_generator::material::brdf::projection::project_orders;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_index::material::indices;
use eigenshade_model::error::Result;
use eigenshade_shading::parallel;
use experiments::numbers::digits;
use std::f64::consts::PI;
use std::path::PathBuf;

/// Orders, with the number of Chebyshev polynomials in roughness that each takes: what these leave
/// out is below 1e-3 of a picture's peak.
const ORDERS: [(usize, usize); 2] = [(7, 12), (12, 14)];
/// The range of roughness.
const LEAST: f64 = 0.2;
const MOST: f64 = 1.0;
/// Nodes of the interpolation, from which the polynomials that are kept are taken.
const NODES: usize = 24;
/// Significant digits: those of f32.
const DIGITS: usize = 8;

/// Coefficients of glTF materials, tables/inputs/metallic-roughness.csv
///
/// A material's coefficients are albedo (1 - f0) `matte` + `rim` + f0 `metal`. `matte` does not
/// depend on roughness; `rim` and `metal` are sums of Chebyshev polynomials T_k in
/// (roughness - 0.6) / 0.4. Writes the CSV `order,k,o,p,q,matte,rim,metal`.
#[derive(Args, Debug)]
pub struct MetallicRoughness {
    /// The file to write
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
}

impl MetallicRoughness {
    pub fn run(self) -> Result<()> {
        let orders = ORDERS.map(|(order, _)| order);
        let angles: Vec<f64> = (0..NODES).map(|j| PI * (j as f64 + 0.5) / NODES as f64).collect();
        let project = |roughness: f64, f0: f64, albedo: f64| -> Result<Vec<Vec<f64>>> {
            let lobe = Ggx::new(roughness, f0, albedo)?;
            let projections = project_orders(&lobe, &orders, Measure::Projected);
            Ok(projections.into_iter().map(|one| one.coefficients).collect())
        };
        let progress = progress_bar("roughnesses", NODES);
        let nodes = parallel::map(NODES, &progress, |j| {
            let roughness = 0.5 * (MOST + LEAST + (MOST - LEAST) * angles[j].cos());
            Ok([project(roughness, 0.0, 0.0)?, project(roughness, 1.0, 0.0)?])
        });
        progress.finish_and_clear();
        let nodes = nodes.into_iter().collect::<Result<Vec<_>>>()?;
        // The matte part is the same at any roughness.
        let [over_matte, bare] = [project(MOST, 0.0, 1.0)?, project(MOST, 0.0, 0.0)?];
        output::write(Some(&self.out), |out| {
            output::write_command_line(out)?;
            let mut rows = Rows::new(out, ["order", "k", "o", "p", "q", "matte", "rim", "metal"])?;
            for (of_order, (order, terms)) in ORDERS.into_iter().enumerate() {
                for k in 0..terms {
                    // The coefficient of T_k in a function of roughness, from its values at the nodes.
                    let coefficient = |value: &dyn Fn(usize) -> f64| -> f64 {
                        let cosines = angles.iter().enumerate();
                        let sum: f64 = cosines.map(|(j, t)| value(j) * (k as f64 * t).cos()).sum();
                        sum * if k == 0 { 1.0 } else { 2.0 } / NODES as f64
                    };
                    for (i, (o, p, q)) in indices(order).enumerate() {
                        let rim = |j: usize| nodes[j][0][of_order][i];
                        let metal = |j: usize| nodes[j][1][of_order][i] - rim(j);
                        let matte = over_matte[of_order][i] - bare[of_order][i];
                        let matte = if k == 0 { matte } else { 0.0 };
                        let numbers = [matte, coefficient(&rim), coefficient(&metal)];
                        let places = [order, k, o, p, q].map(|place| place.to_string());
                        let numbers = numbers.map(|number| digits(number, DIGITS));
                        rows.row(places.into_iter().chain(numbers))?;
                    }
                }
            }
            rows.finish()
        })
    }
}

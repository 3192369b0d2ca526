//! `experiments float-errors`: the runtime in floats against the direct sum.

use clap::Args;
use eigenshade_model::error::Result;
use experiments::float_errors::{Errors, SHAPES, errors};

/// Errors of the runtime in floats against the direct sum over modes, with all components
///
/// Writes CSV to standard output: the largest and the root mean square error of a pixel, as shares
/// of the image's peak, for the worst pair of a light and a material.
#[derive(Args, Debug)]
pub struct FloatErrors {
    /// Degrees and orders [default: from 9,7 to 32,32]
    #[arg(value_name = "DEGREE,ORDER", value_parser = shape)]
    shapes: Vec<[usize; 2]>,
}

impl FloatErrors {
    pub fn run(self) -> Result<()> {
        let shapes = if self.shapes.is_empty() { SHAPES.to_vec() } else { self.shapes };
        println!("degree,order,components,method,format,max,rms");
        for [degree, order] in shapes {
            for one in errors([degree, order]) {
                let Errors { components, method, format, largest, rms } = one;
                println!("{degree},{order},{components},{method},{format},{largest:.1e},{rms:.1e}");
            }
        }
        Ok(())
    }
}

fn shape(text: &str) -> std::result::Result<[usize; 2], String> {
    let numbers = text.split_once(',').and_then(|(degree, order)| {
        Some([degree.parse::<usize>().ok()?, order.parse::<usize>().ok()?])
    });
    numbers.ok_or_else(|| "two whole numbers like 9,7 are wanted".to_owned())
}

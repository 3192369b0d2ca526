//! Materials that are formulas, on the command line.

use super::count;
use clap::{Args, Subcommand};
use eigenshade_generator::brdf::Surface;
use eigenshade_generator::error::Result;
use eigenshade_generator::inputs::analytic::{Analytic, Model, Shares};
use std::path::PathBuf;

/// One formula and its parameters.
#[derive(Debug, Subcommand)]
pub enum Formula {
    /// Perfectly matte: albedo / pi
    Lambertian {
        /// Share of the light that is reflected: a number, or r,g,b
        #[arg(long, value_name = "A", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
    /// Rough and matte: the qualitative model of Oren and Nayar, 1994
    OrenNayar {
        /// Deviation of the facets' angle, radians, 0 to pi/2
        #[arg(long, value_name = "S")]
        sigma: f64,
        /// Albedo: a number, or r,g,b
        #[arg(long, value_name = "A", default_value = "1", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
    /// What a glTF metallic-roughness material says: a GGX lobe over a matte base
    ///
    /// A dielectric has f0 0.04 and its base colour as albedo; a metal has its base
    /// colour as f0 and no albedo.
    Ggx {
        /// Perceptual roughness, 0.01 to 1; alpha is its square
        #[arg(long, value_name = "R")]
        roughness: f64,
        /// Reflectance at normal incidence: a number, or r,g,b
        #[arg(long, value_name = "F", value_parser = shares)]
        f0: Shares,
        /// Albedo of the matte base: a number, or r,g,b
        #[arg(long, value_name = "A", default_value = "0", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
}

/// What is wanted of it.
#[derive(Args, Debug)]
pub struct Answer {
    /// Largest order o of the coefficients, 0 to 64
    #[arg(long, value_name = "O", value_parser = count(0, 64))]
    order: usize,
    /// What the material is called, instead of after its model
    #[arg(long, value_name = "NAME")]
    name: Option<String>,
    /// Where the CSV goes, instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Formula {
    /// The material as functions, the order, and where the answer goes.
    ///
    /// # Errors
    ///
    /// A parameter out of range.
    pub fn surface(self) -> Result<(Surface, usize, Option<PathBuf>)> {
        let of = |model, name: &str| Analytic {
            name: name.to_owned(),
            model,
            albedo: None,
            sigma: None,
            roughness: None,
            f0: None,
        };
        let (analytic, answer) = match self {
            Self::Lambertian { albedo, answer } => {
                let base = of(Model::Lambertian, "lambertian");
                (Analytic { albedo: Some(albedo), ..base }, answer)
            }
            Self::OrenNayar { sigma, albedo, answer } => {
                let base = of(Model::OrenNayar, "oren-nayar");
                (Analytic { albedo: Some(albedo), sigma: Some(sigma), ..base }, answer)
            }
            Self::Ggx { roughness, f0, albedo, answer } => {
                let base = of(Model::Ggx, "ggx");
                let roughness = Some(roughness);
                (Analytic { albedo: Some(albedo), roughness, f0: Some(f0), ..base }, answer)
            }
        };
        let name = answer.name.unwrap_or_else(|| analytic.name.clone());
        let surface = Analytic { name, ..analytic }.surface()?;
        Ok((surface, answer.order, answer.out))
    }
}

/// Clap's reader of a number, or of three with commas between.
fn shares(text: &str) -> std::result::Result<Shares, String> {
    let numbers: std::result::Result<Vec<f64>, _> =
        text.split(',').map(|field| field.trim().parse::<f64>()).collect();
    match numbers.as_deref() {
        Ok(&[grey]) => Ok(Shares::Grey(grey)),
        Ok(&[r, g, b]) => Ok(Shares::Rgb([r, g, b])),
        _ => Err("a number is wanted, or three: r,g,b".to_owned()),
    }
}

//! Formulas of materials on the command line.

use super::count;
use clap::{Args, Subcommand, ValueEnum};
use eigenshade_generator::material::analytic::{Analytic, Model, Shares};
use eigenshade_generator::material::brdf::{Measure, Surface};
use eigenshade_model::error::Result;
use std::path::PathBuf;

/// One formula and its parameters.
#[derive(Debug, Subcommand)]
pub enum Formula {
    /// Perfectly diffuse: albedo / pi
    Lambertian {
        /// Reflected share of the light: a number, or r,g,b
        #[arg(long, value_name = "A", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
    /// Rough diffuse: the qualitative model of Oren and Nayar, 1994
    OrenNayar {
        /// Standard deviation of the facets' angle, radians, 0 to pi/2
        #[arg(long, value_name = "S")]
        sigma: f64,
        /// Albedo: a number, or r,g,b
        #[arg(long, value_name = "A", default_value = "1", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
    /// A glTF metallic-roughness material: a GGX lobe over a diffuse base
    ///
    /// A dielectric has f0 0.04 and its base color as albedo; a metal has its base color as f0 and
    /// no albedo.
    Ggx {
        /// Perceptual roughness, 0.03 to 1; alpha is its square
        #[arg(long, value_name = "R")]
        roughness: f64,
        /// Reflectance at normal incidence: a number, or r,g,b
        #[arg(long, value_name = "F", value_parser = shares)]
        f0: Shares,
        /// Albedo of the diffuse base: a number, or r,g,b
        #[arg(long, value_name = "A", default_value = "0", value_parser = shares)]
        albedo: Shares,
        #[command(flatten)]
        answer: Answer,
    },
}

/// Options of the projection.
#[derive(Args, Debug)]
pub struct Answer {
    /// Largest order o of the coefficients, 0 to 64
    #[arg(long, value_name = "O", value_parser = count(0, 64))]
    pub order: usize,
    /// Name of the material [default: the model]
    #[arg(long, value_name = "NAME", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    name: Option<String>,
    /// Measure under which the coefficients approximate the function best
    #[arg(long, value_enum, default_value_t)]
    pub measure: Nearness,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

/// The measure under which coefficients approximate a function best.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
pub enum Nearness {
    /// cos theta_i cos theta_r dw_i dw_r, as the irradiance of a sphere sees it
    #[default]
    Projected,
    /// dw_i dw_r, in which the modes are orthonormal
    SolidAngle,
}

impl From<Nearness> for Measure {
    fn from(nearness: Nearness) -> Self {
        match nearness {
            Nearness::Projected => Self::Projected,
            Nearness::SolidAngle => Self::SolidAngle,
        }
    }
}

impl Formula {
    /// The material as functions, and the options.
    ///
    /// # Errors
    ///
    /// A parameter out of range.
    pub fn surface(self) -> Result<(Surface, Answer)> {
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
        let name = answer.name.clone().unwrap_or_else(|| analytic.name.clone());
        let surface = Analytic { name, ..analytic }.surface()?;
        Ok((surface, answer))
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

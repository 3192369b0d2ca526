//! `eigenshade material`: converts measured, tabulated or analytic BRDFs to coefficients.

use super::options::{Destination, choice, count, input_file, width};
use clap::builder::TypedValueParser;
use clap::{Args, Subcommand};
use eigenshade_cli::messages::{albedo_warning, print_message, progress_bar};
use eigenshade_cli::output;
use eigenshade_generator::material;
use eigenshade_generator::material::analytic::{Analytic, Model, Shares};
use eigenshade_generator::material::brdf::{Measure, Projected, Surface};
use eigenshade_generator::material::files::Source;
use eigenshade_generator::material::fit::{Fit, LOWEST, fit, write_figures};
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_model::inputs::gloss_csv::write_glosses;
use eigenshade_model::parallel;
use eigenshade_model::source::NamedGloss;
use eigenshade_model::window::Window;
use eigenshade_shading::presets::{self, GLOSS};
use eigenshade_shading::sources::gloss::{Fitter, of_measured};
use eigenshade_table::material::count as count_of_orders;
use std::collections::HashSet;
use std::path::PathBuf;
use std::str::FromStr;

/// The order of the shipped table.
const ORDER: usize = 7;

/// Convert BRDFs (measurements, tables or formulas) to material coefficients
///
/// Writes the CSV `name,o,p,q,r,g,b` (`name,o,p,q,value` if all are gray). Measurements are fitted.
/// For each fit, standard error shows the residual relative to the measurements, the range of the
/// fitted values relative to the largest measured one, and the condition number. MERL files and
/// formulas are projected by quadrature. For each projection, standard error shows the share of the
/// energy, f^2 cos theta_i cos theta_r over both hemispheres, that the order leaves out.
///
/// With --out FILE.csv, the gloss of each material is written to FILE.gloss.csv, for `render
/// --sources`: one GGX lobe over a matte base, exact for `lambertian`, `gltf` and `ggx`, fitted to
/// others.
///
/// The parameters of a formula follow its name: `material ggx --roughness 0.3 --f0 0.9 --order 12`.
#[derive(Args, Debug)]
#[command(subcommand_negates_reqs = true)]
pub struct Material {
    #[command(subcommand)]
    formula: Option<Formula>,
    /// A CUReT folder (abrdf.dat, table.txt), a CSV
    /// `theta_i,phi_i,theta_r,phi_r,r,g,b`, a MERL .binary, a .toml of formulas, or a
    /// folder of such files; several are combined
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,
    #[command(flatten)]
    projection: Projection,
    /// Also write the quality of the fits to this file:
    /// `name,samples,maximum,residual,lowest,highest,condition`, the maximum in 1/sr
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

impl Material {
    pub fn run(self) -> Result<()> {
        let Self { formula, paths, projection, report } = self;
        let Projection { order, measure, window, out } = projection;
        let beside = out.path.as_deref().and_then(|out| presets::beside(out, GLOSS));
        let inputs = paths.iter().flat_map(|path| material::files::files(path));
        output::refuse_collisions([&out.path, &report, &beside].into_iter().flatten(), inputs)?;
        let sources = match formula {
            Some(_) if !paths.is_empty() || report.is_some() => {
                let what = "a formula takes neither paths nor --report";
                return Err(Error::new(what, "leave them out, or the formula"));
            }
            Some(formula) => vec![Source::Surface(formula.surface()?)],
            None => {
                let mut sources = Vec::new();
                for path in &paths {
                    sources.extend(material::files::read(input_file(path))?);
                }
                sources
            }
        };
        let mut names = HashSet::new();
        if let Some(source) = sources.iter().find(|source| !names.insert(source.name())) {
            let what = format!("two materials are called `{}`", source.name());
            return Err(Error::new(what, "rename one of the two"));
        }
        let negative = negative_values(&sources);
        let glosses = if beside.is_some() { glosses(&sources)? } else { Vec::new() };
        let (mut materials, fits) = coefficients(sources, order, measure)?;
        if let Some(width) = window {
            attenuate(&mut materials, Window::SincFourth { width });
        }
        let out = out.path.as_deref();
        match &beside {
            Some(beside) => output::write_before(
                out,
                |to| write_materials(&materials, to),
                || output::write(Some(beside), |to| write_glosses(&glosses, to)),
            )?,
            None => output::write(out, |to| write_materials(&materials, to))?,
        }
        if let Some(path) = &report {
            output::write(Some(path), |out| write_figures(&fits, out))?;
        }
        albedo_warning(&materials).into_iter().chain(negative).for_each(print_message);
        Ok(())
    }
}

/// The condition number above which the small term that a fit adds, and not the measurements,
/// decides a coefficient.
const UNDETERMINED: f64 = 1e5;

/// The share of energy that an order leaves out above which a picture lacks a highlight.
const SHARP: f64 = 0.05;

/// The gloss of each material: exact for `lambertian`, `gltf` and `ggx`, fitted to others.
fn glosses(sources: &[Source]) -> Result<Vec<NamedGloss>> {
    let mut fitter = Fitter::default();
    let of = |source: &Source| match source {
        Source::Measured(measured) => of_measured(measured),
        Source::Surface(surface) => fitter.named(surface),
    };
    sources.iter().map(of).collect()
}

/// The coefficients of all sources, in order, and the fits among them.
fn coefficients(
    sources: Vec<Source>,
    order: usize,
    measure: Measure,
) -> Result<(Materials, Vec<Fit>)> {
    let (mut measured, mut surfaces, mut places) = (Vec::new(), Vec::new(), Vec::new());
    for source in sources {
        places.push(matches!(source, Source::Measured(_)));
        match source {
            Source::Measured(samples) => measured.push(samples),
            Source::Surface(surface) => surfaces.push(surface),
        }
    }
    let progress = progress_bar("fits", measured.len());
    let (_, fits) = fit(&measured, order, &mut |done, _| progress.set_position(done as u64))?;
    progress.finish_and_clear();
    let progress = progress_bar("projections", surfaces.len());
    let projected: Vec<Projected> =
        parallel::map(surfaces.len(), &progress, |k| surfaces[k].project(order, measure));
    progress.finish_and_clear();
    for fit in &fits {
        let Fit { samples, residual, lowest, highest, condition, .. } = fit;
        print_message(format_args!(
            "{}: {samples} samples, residual {residual:.4}, range {lowest:.3} to {highest:.3}, \
             condition {condition:.1}",
            fit.material.name
        ));
        if *condition > UNDETERMINED {
            let count = count_of_orders(order);
            print_message(format_args!(
                "warning: {samples} measurements of `{}` do not determine {count} coefficients; \
                 measure more directions, or give a lower --order",
                fit.material.name
            ));
        }
    }
    for one in &projected {
        let (name, left) = (&one.material.name, one.left_out);
        print_message(format_args!("{name}: order {order} leaves out {left:.2e} of the energy"));
    }
    if projected.iter().any(|one| one.left_out > SHARP) {
        print_message(
            "note: what an order leaves out is mostly highlight, and pictures are nearer than this \
             share. `render` adds it by sources of the light, if the gloss is beside --out FILE.csv; \
             from roughness 0.5 on, --order 12 and `render --table tables/pbr.bin` do without",
        );
    }
    let (mut fitted, mut others) = (
        fits.iter().map(|fit| fit.material.clone()),
        projected.into_iter().map(|one| one.material),
    );
    let entries: Vec<Named> = places
        .into_iter()
        .filter_map(|is_fit| if is_fit { fitted.next() } else { others.next() })
        .collect();
    Ok((Materials { order, entries }, fits))
}

/// Multiplies the coefficients of each order by the window's factor.
fn attenuate(materials: &mut Materials, window: Window) {
    for channel in materials.entries.iter_mut().flat_map(|entry| &mut entry.rgb) {
        for o in 0..=materials.order {
            let start = if o == 0 { 0 } else { count_of_orders(o - 1) };
            let factor = window.factor(o);
            channel[start..count_of_orders(o)].iter_mut().for_each(|b| *b *= factor);
        }
    }
}

/// A warning of measurements that are further below zero than a fit may be.
fn negative_values(sources: &[Source]) -> Option<String> {
    let range = |source: &Source| {
        let Source::Measured(measured) = source else { return None };
        let values = measured.samples.iter().flat_map(|sample| sample.rgb);
        let (lowest, highest) = values.fold((0.0f64, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
        (lowest < LOWEST * highest).then(|| (measured.name.clone(), lowest, highest))
    };
    let found: Vec<(String, f64, f64)> = sources.iter().filter_map(range).collect();
    let (name, lowest, highest) =
        found.iter().min_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)))?;
    let (count, all) = (found.len(), sources.len());
    Some(format!(
        "warning: material `{name}` has measurements down to {lowest:.4}, where the largest is \
         {highest:.4} (so in {count} of {all} materials): only noise makes a measured BRDF negative"
    ))
}

/// One formula and its parameters.
#[derive(Debug, Subcommand)]
pub enum Formula {
    /// Perfectly diffuse: albedo / pi
    Lambertian {
        /// Reflected share of the light: a number or r,g,b, linear; or '#rrggbb' or '#rgb', sRGB
        #[arg(long, value_name = "A", value_parser = Shares::from_str)]
        albedo: Shares,
        #[command(flatten)]
        options: Options,
    },
    /// Rough diffuse: the qualitative model of Oren and Nayar, 1994
    OrenNayar {
        /// Standard deviation of the facets' angle, radians, 0 to pi/2
        #[arg(long, value_name = "S")]
        sigma: f64,
        /// Albedo: a number or r,g,b, linear; or '#rrggbb' or '#rgb', sRGB
        #[arg(long, value_name = "A", default_value = "1", value_parser = Shares::from_str)]
        albedo: Shares,
        #[command(flatten)]
        options: Options,
    },
    /// A glTF metallic-roughness material by its own parameters
    ///
    /// It is `ggx` with f0 = 0.04 + (base color - 0.04) metallic and the albedo base color (1 -
    /// metallic).
    Gltf {
        /// Base color, 0 to 1: a number or r,g,b, linear; or '#rrggbb' or '#rgb', sRGB
        #[arg(long, value_name = "C", value_parser = color)]
        base_color: Shares,
        /// 0 for a dielectric to 1 for a metal
        #[arg(long, value_name = "M", value_parser = share)]
        metallic: f64,
        /// Perceptual roughness, 0.03 to 1; alpha is its square
        #[arg(long, value_name = "R")]
        roughness: f64,
        #[command(flatten)]
        options: Options,
    },
    /// A GGX lobe over a diffuse base
    ///
    /// A dielectric has f0 0.04 and its color as albedo; a metal has its color as f0 and no albedo.
    Ggx {
        /// Perceptual roughness, 0.03 to 1; alpha is its square
        #[arg(long, value_name = "R")]
        roughness: f64,
        /// Reflectance at normal incidence: a number or r,g,b, linear; or '#rrggbb' or '#rgb', sRGB
        #[arg(long, value_name = "F", value_parser = Shares::from_str)]
        f0: Shares,
        /// Albedo of the diffuse base: a number or r,g,b, linear; or '#rrggbb' or '#rgb', sRGB
        #[arg(long, value_name = "A", default_value = "0", value_parser = Shares::from_str)]
        albedo: Shares,
        #[command(flatten)]
        options: Options,
    },
}

/// Options of a formula.
#[derive(Args, Debug)]
pub struct Options {
    /// Name of the material [default: the model]
    #[arg(long, value_name = "NAME", value_parser = clap::builder::NonEmptyStringValueParser::new())]
    name: Option<String>,
}

/// Options of the coefficients, before or after the name of a formula.
#[derive(Args, Debug)]
#[command(mut_arg("out", |out| out.global(true)))]
pub struct Projection {
    /// Largest order o of the coefficients, 0 to 64; 16 at most for measurements
    #[arg(long, global = true, value_name = "O", value_parser = count(0, 64),
        default_value_t = ORDER)]
    order: usize,
    /// Measure under which projected coefficients approximate the function best
    #[arg(long, global = true, value_parser = measures(), default_value = "projected")]
    measure: Measure,
    /// Multiply the coefficients of order o by sinc^4, (sin x / x)^4 with x = pi o / W, zero from
    /// order W on: less ringing of gloss that the order cannot represent. 40 suits order 7
    #[arg(long, global = true, value_name = "W", value_parser = width)]
    window: Option<f64>,
    #[command(flatten)]
    out: Destination,
}

fn measures() -> impl TypedValueParser<Value = Measure> {
    let projected = "cos theta_i cos theta_r dw_i dw_r, as the irradiance of a sphere sees it";
    let solid_angle = "dw_i dw_r, in which the modes are orthonormal";
    choice([
        ("projected", projected, Measure::Projected),
        ("solid-angle", solid_angle, Measure::SolidAngle),
    ])
}

impl Formula {
    /// The BRDF. Fails if a parameter is out of range.
    fn surface(self) -> Result<Surface> {
        let of = |model, name: &str| Analytic {
            name: name.to_owned(),
            model,
            albedo: None,
            sigma: None,
            roughness: None,
            f0: None,
        };
        let (analytic, options) = match self {
            Self::Lambertian { albedo, options } => {
                let base = of(Model::Lambertian, "lambertian");
                (Analytic { albedo: Some(albedo), ..base }, options)
            }
            Self::OrenNayar { sigma, albedo, options } => {
                let base = of(Model::OrenNayar, "oren-nayar");
                (Analytic { albedo: Some(albedo), sigma: Some(sigma), ..base }, options)
            }
            Self::Gltf { base_color, metallic, roughness, options } => {
                (Analytic::gltf("gltf", base_color, metallic, roughness), options)
            }
            Self::Ggx { roughness, f0, albedo, options } => {
                let (roughness, f0, albedo) = (Some(roughness), Some(f0), Some(albedo));
                (Analytic { roughness, f0, albedo, ..of(Model::Ggx, "ggx") }, options)
            }
        };
        let name = options.name.unwrap_or_else(|| analytic.name.clone());
        Analytic { name, ..analytic }.surface()
    }
}

/// Parses a number from 0 to 1.
fn share(text: &str) -> std::result::Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| (0.0..=1.0).contains(number));
    number.ok_or_else(|| "expected a number from 0 to 1".to_owned())
}

/// Parses a color: [`Shares`] from 0 to 1.
fn color(text: &str) -> std::result::Result<Shares, String> {
    if !text.starts_with('#') {
        text.split(',').try_for_each(|field| share(field).map(drop))?;
    }
    text.parse()
}

//! `eigenshade shade`: the irradiance of given normals.

use super::count;
use clap::{Args, ValueEnum};
use eigenshade::Scalar;
use eigenshade_cli::message::bar;
use eigenshade_cli::number::exact;
use eigenshade_cli::owned_basis::OwnedBasis;
use eigenshade_cli::rows::Rows;
use eigenshade_cli::shader::{OwnedNormals, Shader, fault, fitted};
use eigenshade_cli::{destination, table_file, truth_image};
use eigenshade_generator::database::{Lights, Materials, Named};
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_generator::inputs::normals::read_normals;
use eigenshade_generator::rotation::Rotation;
use eigenshade_table::Table;
use std::io::Write;
use std::path::PathBuf;

/// Every light on every material at given normals
///
/// Writes the CSV `light,material,normal,r,g,b`; normals are counted from 0. Each
/// number reads back exactly.
#[derive(Args, Debug)]
pub struct Shade {
    /// The table
    #[arg(value_name = "B.bin")]
    table: PathBuf,
    /// Light CSV
    #[arg(long, value_name = "FILE")]
    lights: PathBuf,
    /// Material CSV
    #[arg(long, value_name = "FILE")]
    materials: PathBuf,
    /// Normals CSV, `x,y,z`
    #[arg(long, value_name = "FILE")]
    normals: PathBuf,
    /// Only the first K components; the method modes has none
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    components: Option<usize>,
    /// Number format: f32, but for the method modes f64
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// How the images are summed
    #[arg(long, value_enum, default_value_t = Method::Polynomial)]
    method: Method,
    /// Turns the light by Rz(A) Ry(B) Rz(C), radians
    #[arg(long, value_name = "A,B,C", value_parser = angles, allow_hyphen_values = true)]
    rotate: Option<Rotation>,
    /// Where the CSV goes, instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    F64,
    F32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    /// The direct sum over modes, f64, at the table's degree and order: the truth
    Modes,
    /// Eigenimage by eigenimage
    Eigen,
    /// One polynomial for each azimuth, as on a device
    Polynomial,
}

fn angles(text: &str) -> std::result::Result<Rotation, String> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()))
        .collect();
    match numbers.as_deref() {
        // R = Rz(A) Ry(B) Rz(C).
        Some(&[a, b, c]) => Ok(Rotation { alpha: b, beta: a, gamma: c }),
        _ => Err("three angles in radians are wanted, as in 0.5,1.2,-0.3".to_owned()),
    }
}

/// What is to be shaded.
struct Work {
    table: Table,
    lights: Lights,
    materials: Materials,
    normals: Vec<[f64; 3]>,
    components: usize,
}

impl Shade {
    pub fn run(self) -> Result<()> {
        if self.method == Method::Modes && self.format == Some(Format::F32) {
            let what = "the method modes is in f64 only";
            return Err(Error::new(what, "leave --format out, or choose another method"));
        }
        let table = table_file::read(&self.table)?;
        let components = table_file::components(&table, self.components, &self.table)?;
        let (mut lights, materials) = fitted(
            &table,
            &read_lights(&self.lights, None)?,
            &read_materials(&self.materials, None)?,
        );
        if let Some(rotation) = self.rotate {
            let degree = lights.degree;
            for channel in lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb) {
                *channel = rotation.turn(degree, channel);
            }
        }
        let normals = read_normals(&self.normals)?;
        let work = Work { table, lights, materials, normals, components };
        destination::write(self.out.as_deref(), |out| match (self.method, self.format) {
            (Method::Modes, _) => work.modes(out),
            (method, Some(Format::F64)) => work.shade::<f64>(method, out),
            (method, _) => work.shade::<f32>(method, out),
        })
    }
}

impl Work {
    fn pairs(&self) -> impl Iterator<Item = (&Named, &Named)> {
        let materials = &self.materials.entries;
        let lights = self.lights.entries.iter();
        lights.flat_map(move |light| materials.iter().map(move |material| (light, material)))
    }

    fn modes(&self, out: &mut dyn Write) -> Result<()> {
        let progress = bar("normals", self.normals.len());
        let images = truth_image::images(&self.lights, &self.materials, &self.normals, &progress);
        progress.finish_and_clear();
        let mut rows = header(out)?;
        for (pair, names) in self.pairs().enumerate() {
            for (normal, of_pairs) in images.iter().enumerate() {
                row(&mut rows, names, normal, of_pairs[pair])?;
            }
        }
        rows.finish()
    }

    fn shade<S: Scalar + Into<f64>>(&self, method: Method, out: &mut dyn Write) -> Result<()> {
        let basis = OwnedBasis::<S>::new(&self.table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, self.components);
        let normals = OwnedNormals::<S>::new(&self.normals);
        let each = normals.each()?;
        let mut rows = header(out)?;
        let progress = bar("images", self.lights.entries.len() * self.materials.entries.len());
        for (light, material) in self.pairs() {
            let mut channel = |c: usize| {
                let of_light = (self.lights.degree, light.rgb[c].as_slice());
                let of_material = (self.materials.order, material.rgb[c].as_slice());
                match method {
                    Method::Eigen => shader.eigen(of_light, of_material, &each),
                    _ => shader.polynomial(of_light, of_material, &normals),
                }
            };
            let (red, green, blue) = (channel(0)?, channel(1)?, channel(2)?);
            for (normal, ((&r, &g), &b)) in red.iter().zip(&green).zip(&blue).enumerate() {
                row(&mut rows, (light, material), normal, [r.into(), g.into(), b.into()])?;
            }
            progress.inc(1);
        }
        progress.finish_and_clear();
        rows.finish()
    }
}

fn header(out: &mut dyn Write) -> Result<Rows<'_>> {
    Rows::new(out, ["light", "material", "normal", "r", "g", "b"])
}

fn row(
    rows: &mut Rows<'_>,
    (light, material): (&Named, &Named),
    normal: usize,
    rgb: [f64; 3],
) -> Result<()> {
    let [r, g, b] = rgb.map(exact);
    rows.row([&light.name, &material.name, &normal.to_string(), &r, &g, &b])
}

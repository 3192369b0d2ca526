//! `eigenshade shade`: writes the irradiance of given normals.

use super::shade_options::{angles, effect, tolerance, width};
use super::{Memory, count};
use clap::{Args, ValueEnum};
use eigenshade::mathematics::Libm;
use eigenshade::{Economy, Effect, Effects, Negatives, Q15, Q31, Scalar, Tolerance, Window};
use eigenshade_cli::notes::ringing::Ringing;
use eigenshade_cli::notes::{albedo, economy};
use eigenshade_cli::output::message::{bar, say};
use eigenshade_cli::output::number::exact;
use eigenshade_cli::output::rows::Rows;
use eigenshade_cli::output::{collision, destination};
use eigenshade_cli::table::{rounding, table_file, wire_file};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_model::rotation::Rotation;
use eigenshade_shading::integer_shader::{self, IntegerShader};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::owned_quantised::Integer;
use eigenshade_shading::shader::{
    Lit, LookUp, OwnedNormals, Shader, fault, fitted, of_higher_order,
};
use eigenshade_shading::{overflow, reference_image};
use eigenshade_table::{Table, quantize, wire};
use std::io::Write;
use std::path::PathBuf;

/// Shade given normals for every light on every material
///
/// Writes the CSV `light,material,normal,r,g,b`; normals are counted from 0. Each number is written
/// with all digits.
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
    /// Only the first K components; not for the method modes
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    components: Option<usize>,
    /// Number format [default: f32, and f64 for the method modes]
    #[arg(long, value_enum)]
    format: Option<Format>,
    /// How a pixel is computed
    #[arg(long, value_enum, default_value_t = Method::Polynomial)]
    method: Method,
    /// Turn the light by Rz(A) Ry(B) Rz(C), radians
    #[arg(long, value_name = "A,B,C", value_parser = angles, allow_hyphen_values = true)]
    rotate: Option<Rotation>,
    /// Method table: knots of each azimuth, 8 to 65536 [default: the scene's, or 64 times the
    /// degree, rounded up to a power of two]
    #[arg(long, value_name = "N", value_parser = count(8, 65_536))]
    knots: Option<usize>,
    /// Method baked: texels a side, 2 to 4096 [default: 64]
    #[arg(long, value_name = "N", value_parser = count(2, 4_096))]
    size: Option<usize>,
    /// Interpolation: linear or cubic for table [default: cubic], nearest or linear for baked
    /// [default: linear]
    #[arg(long, value_enum)]
    interpolation: Option<Interpolation>,
    /// Only these effects: ambient, diffuse, broad, gloss; their pictures sum to the whole
    /// [default: all]
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = effect)]
    effects: Vec<Effect>,
    /// Shade with fewer polynomial terms, as long as the rms difference over a picture of a sphere
    /// stays within this share of the brightest channel's peak (1e-3) or this many decibels below
    /// it (60dB). Needs the method polynomial in f32 or f64. The error of the components in use
    /// comes on top
    #[arg(long, value_name = "T", value_parser = tolerance, allow_negative_numbers = true)]
    tolerance: Option<Tolerance<f64>>,
    /// Weaken degree l of the light by sinc^4, (sin x / x)^4 with x = pi l / W, to zero from degree
    /// W on
    #[arg(long, value_name = "W", value_parser = width)]
    window: Option<f64>,
    /// Set irradiance below zero to zero, and report the least value on standard error
    #[arg(long)]
    clamp: bool,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    F64,
    F32,
    /// Integers: mantissas of 31 bits
    Q31,
    /// Integers: mantissas of 15 bits
    Q15,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Method {
    /// The direct sum over modes at the table's degree and order, in f64: the reference
    Modes,
    /// Eigenimage by eigenimage
    Eigen,
    /// One polynomial for each azimuth, as on a device
    Polynomial,
    /// The polynomials sampled at --knots, and looked up
    Table,
    /// The image baked on a paraboloid map of --size, and looked up
    Baked,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Interpolation {
    Nearest,
    Linear,
    Cubic,
}

/// The inputs of the shading.
struct Work {
    table: Table,
    lights: Lights,
    materials: Materials,
    normals: Vec<[f64; 3]>,
    components: usize,
    effects: Effects,
    tolerance: Option<Tolerance<f64>>,
    /// A warning of the number format's error.
    rounding: f64,
}

impl Shade {
    pub fn run(self, memory: Memory) -> Result<()> {
        let is_integer = matches!(self.format, Some(Format::Q31 | Format::Q15));
        if self.method == Method::Modes && !matches!(self.format, None | Some(Format::F64)) {
            let what = "the method modes is in f64 only";
            return Err(Error::new(what, "leave --format out, or choose another method"));
        }
        if is_integer && self.method != Method::Polynomial {
            let what = "integers shade by polynomials only";
            return Err(Error::new(what, "take --method polynomial, or --format f32"));
        }
        if self.tolerance.is_some() && (is_integer || self.method != Method::Polynomial) {
            let what = "--tolerance is of the method polynomial in f32 or f64";
            return Err(Error::new(what, "leave it out, or ask for those"));
        }
        let inputs = [&self.table, &self.lights, &self.materials, &self.normals];
        collision::refuse(&self.out, inputs)?;
        let table = table_file::read(memory.file(&self.table))?;
        let effects = self.wanted(&table)?;
        if self.rotate.is_some() && !table.scene.effects.rotation {
            let what = "the table is for light that does not turn: effects.rotation = false";
            return Err(Error::new(
                what,
                "leave --rotate out, or make a table for light that does",
            ));
        }
        if is_integer && effects != table.effects() {
            let what = "integers shade all effects of their table";
            return Err(Error::new(what, "make a table of those effects, or take --format f32"));
        }
        let way = self.way(table.scene.basis.knots, table.gram.degree)?;
        let components = table_file::components(&table, self.components, &self.table)?;
        let lights = read_lights(memory.file(&self.lights), None)?;
        let materials = read_materials(memory.file(&self.materials), None)?;
        let higher = of_higher_order(&self.materials, materials.order, table.gram.order);
        let warnings = higher.into_iter().chain(albedo::warning(&materials));
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        if let Some(rotation) = self.rotate {
            let degree = lights.degree;
            for channel in lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb) {
                *channel = rotation.turn(degree, channel);
            }
        }
        if let Some(width) = self.window {
            let window = Window::SincFourth { width };
            for channel in lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb) {
                window.apply::<Libm>(channel);
            }
        }
        let warnings = warnings.chain(self.stored().and_then(|one| rounding::warning(&table, one)));
        let normals = read_normals(memory.file(&self.normals))?;
        let tolerance = self.tolerance;
        let rounding = self.stored().and_then(|format| table.rounding(format));
        let rounding = rounding.map_or(0.0, |rounding| rounding.largest);
        let work =
            Work { table, lights, materials, normals, components, effects, tolerance, rounding };
        let negatives = if self.clamp { Negatives::Clamped } else { Negatives::Kept };
        let (mut least, mut ringing) = (f64::INFINITY, Ringing::default());
        destination::write(self.out.as_deref(), |out| {
            let ringing = &mut ringing;
            let mut rows = Output { rows: header(out)?, negatives, least: &mut least, ringing };
            match (self.method, self.format) {
                (Method::Modes, _) => work.modes(&mut rows),
                (_, Some(Format::F64)) => work.shade::<f64>(way, &mut rows),
                (_, Some(Format::Q31)) => work.integers::<Q31>(&mut rows),
                (_, Some(Format::Q15)) => work.integers::<Q15>(&mut rows),
                (_, _) => work.shade::<f32>(way, &mut rows),
            }?;
            rows.rows.finish()
        })?;
        if self.clamp && least < 0.0 {
            say(format_args!("least irradiance {}, clamped", exact(least)));
        }
        // Some of the effects alone may well be negative.
        let note = ringing.note().filter(|_| self.effects.is_empty());
        warnings.chain(note).for_each(say);
        Ok(())
    }

    /// The format that the table's numbers are rounded to, if any.
    fn stored(&self) -> Option<wire::Format> {
        match (self.method, self.format) {
            (Method::Modes, _) | (_, Some(Format::F64)) => None,
            (_, None | Some(Format::F32)) => Some(wire::Format::F32),
            (_, Some(Format::Q31)) => Some(wire::Format::Integer(quantize::Format::Q31)),
            (_, Some(Format::Q15)) => Some(wire::Format::Integer(quantize::Format::Q15)),
        }
    }

    /// The requested effects that the table has.
    fn wanted(&self, table: &Table) -> Result<Effects> {
        let asked: Effects = self.effects.iter().copied().collect();
        let all = table.effects();
        let missing = |effect: &&Effect| !all.has(**effect);
        if let Some(effect) = self.effects.iter().find(missing) {
            let what = format!("the table has no {}", effect.name());
            return Err(Error::new(what, format!("it has {}", wire_file::named(all))));
        }
        Ok(if self.effects.is_empty() { all } else { asked })
    }

    /// The way to a pixel; options of another method are errors.
    fn way(&self, of_scene: Option<usize>, degree: usize) -> Result<Way> {
        let (table, baked) = (self.method == Method::Table, self.method == Method::Baked);
        let stray = |option: &str, method: &str| {
            let what = format!("{option} is of the method {method}, which is not asked for");
            Err(Error::new(what, format!("leave {option} out, or ask for --method {method}")))
        };
        if self.knots.is_some() && !table {
            return stray("--knots", "table");
        }
        if self.size.is_some() && !baked {
            return stray("--size", "baked");
        }
        if self.interpolation.is_some() && !(table || baked) {
            return stray("--interpolation", "table");
        }
        let knots = self.knots.or(of_scene).unwrap_or_else(|| enough_knots(degree));
        let size = self.size.unwrap_or(64);
        match (self.method, self.interpolation) {
            (Method::Eigen, _) => Ok(Way::Eigen),
            (Method::Table, Some(Interpolation::Linear)) => {
                Ok(Way::LookUp(LookUp::Linear { knots }))
            }
            (Method::Table, None | Some(Interpolation::Cubic)) => {
                Ok(Way::LookUp(LookUp::Cubic { knots }))
            }
            (Method::Table, Some(Interpolation::Nearest)) => Err(Error::new(
                "the method table has no interpolation nearest",
                "take linear or cubic",
            )),
            (Method::Baked, Some(Interpolation::Nearest)) => {
                Ok(Way::LookUp(LookUp::Nearest { size }))
            }
            (Method::Baked, None | Some(Interpolation::Linear)) => {
                Ok(Way::LookUp(LookUp::Bilinear { size }))
            }
            (Method::Baked, Some(Interpolation::Cubic)) => Err(Error::new(
                "the method baked has no interpolation cubic",
                "take nearest or linear",
            )),
            (Method::Modes | Method::Polynomial, _) => Ok(Way::Polynomial),
        }
    }
}

/// Knots whose cubics are off by what rounding is: the images of a degree and its order change as
/// fast as that degree's harmonics.
fn enough_knots(degree: usize) -> usize {
    (64 * degree).next_power_of_two().max(128)
}

/// A way of the runtime to a pixel.
#[derive(Clone, Copy, Debug)]
enum Way {
    Eigen,
    Polynomial,
    LookUp(LookUp),
}

/// The output of irradiance.
struct Output<'a, 'b> {
    rows: Rows<'b>,
    negatives: Negatives,
    /// The least so far, before it was clamped.
    least: &'a mut f64,
    ringing: &'a mut Ringing,
}

impl Work {
    fn pairs(&self) -> impl Iterator<Item = (&Named, &Named)> {
        let materials = &self.materials.entries;
        let lights = self.lights.entries.iter();
        lights.flat_map(move |light| materials.iter().map(move |material| (light, material)))
    }

    fn modes(&self, out: &mut Output<'_, '_>) -> Result<()> {
        let progress = bar("normals", self.normals.len());
        let (lights, materials) = (&self.lights, &self.materials);
        let (effects, normals) = (self.effects, &self.normals);
        let images =
            reference_image::images_of_effects(lights, materials, effects, normals, &progress);
        progress.finish_and_clear();
        for (pair, (light, material)) in self.pairs().enumerate() {
            out.see((light, material), images.iter().flat_map(|of_pairs| of_pairs[pair]));
            for (normal, of_pairs) in images.iter().enumerate() {
                for (channel, value) in of_pairs[pair].iter().enumerate() {
                    overflow::check(&[*value], &light.rgb[channel], &material.rgb[channel])
                        .map_err(|error| error.of(overflow::pair(light, material)))?;
                }
                out.row((light, material), normal, of_pairs[pair])?;
            }
        }
        Ok(())
    }

    fn integers<Q: Integer>(&self, out: &mut Output<'_, '_>) -> Result<()> {
        let mut shader = IntegerShader::<Q>::new(&self.table, self.components)?;
        let normals = integer_shader::normals(&self.normals)?;
        self.channels(out, |light, material| shader.polynomial(light, material, &normals))
    }

    fn shade<S: Scalar + Into<f64>>(&self, way: Way, out: &mut Output<'_, '_>) -> Result<()> {
        let basis = OwnedBasis::<S>::new(&self.table);
        let mut shader = Shader::new(basis.any().map_err(fault)?, self.components)
            .with_folded(basis.folded())
            .with_effects(self.effects)?;
        if let Some(tolerance) = self.tolerance {
            return self.within(&mut shader, tolerance, out);
        }
        let normals = OwnedNormals::<S>::new(&self.normals);
        let each = normals.each()?;
        self.channels(out, |light, material| match way {
            Way::Eigen => shader.eigen(light, material, &each),
            Way::Polynomial => shader.polynomial(light, material, &normals),
            Way::LookUp(way) => shader.looked_up(light, material, &each, way),
        })
    }

    /// Polynomials within a tolerance; reports the choice.
    fn within<S: Scalar + Into<f64>>(
        &self,
        shader: &mut Shader<'_, S>,
        tolerance: Tolerance<f64>,
        out: &mut Output<'_, '_>,
    ) -> Result<()> {
        let normals = OwnedNormals::<S>::new(&self.normals);
        let tolerance = match tolerance {
            Tolerance::OfPeak(share) => Tolerance::OfPeak(S::from_f64(share)),
            Tolerance::Decibels(decibels) => Tolerance::Decibels(decibels),
            other => unreachable!("{other:?} is no option"),
        };
        let mut chosen: Vec<Economy<S>> = Vec::new();
        self.colors(out, |channels| {
            let shaded = shader.within(&channels, &normals, tolerance)?;
            let mut rgb = [const { Vec::new() }; 3];
            for (channel, (irradiance, economy)) in rgb.iter_mut().zip(shaded) {
                *channel = irradiance;
                chosen.push(economy);
            }
            Ok(rgb)
        })?;
        for line in economy::lines(&chosen, self.components, self.rounding) {
            say(line);
        }
        Ok(())
    }

    /// Writes every light on every material, `irradiance` of one channel at a time.
    fn channels<S: Copy + Into<f64>>(
        &self,
        out: &mut Output<'_, '_>,
        mut irradiance: impl FnMut((usize, &[f64]), (usize, &[f64])) -> Result<Vec<S>>,
    ) -> Result<()> {
        self.colors(out, |[red, green, blue]| {
            let mut channel = |(light, material): Lit<'_>| irradiance(light, material);
            Ok([channel(red)?, channel(green)?, channel(blue)?])
        })
    }

    /// Writes every light on every material, `irradiance` of all three channels.
    fn colors<S: Copy + Into<f64>>(
        &self,
        out: &mut Output<'_, '_>,
        mut irradiance: impl FnMut([Lit<'_>; 3]) -> Result<[Vec<S>; 3]>,
    ) -> Result<()> {
        let progress = bar("images", self.lights.entries.len() * self.materials.entries.len());
        let (degree, order) = (self.lights.degree, self.materials.order);
        for (light, material) in self.pairs() {
            let channel =
                |c: usize| ((degree, light.rgb[c].as_slice()), (order, material.rgb[c].as_slice()));
            let [red, green, blue] = irradiance([0, 1, 2].map(channel))
                .map_err(|error| error.of(overflow::pair(light, material)))?;
            let all = red.iter().chain(&green).chain(&blue);
            out.see((light, material), all.map(|&value| value.into()));
            for (normal, ((&r, &g), &b)) in red.iter().zip(&green).zip(&blue).enumerate() {
                out.row((light, material), normal, [r.into(), g.into(), b.into()])?;
            }
            progress.inc(1);
        }
        progress.finish_and_clear();
        Ok(())
    }
}

fn header(out: &mut dyn Write) -> Result<Rows<'_>> {
    Rows::new(out, ["light", "material", "normal", "r", "g", "b"])
}

impl Output<'_, '_> {
    /// Looks at all values of an image, before they are clamped.
    fn see(&mut self, (light, material): (&Named, &Named), values: impl Iterator<Item = f64>) {
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (least, largest) = values.fold(none, |(a, b), one| (a.min(one), b.max(one)));
        self.ringing.see(|| overflow::pair(light, material), least, largest);
    }

    fn row(
        &mut self,
        (light, material): (&Named, &Named),
        normal: usize,
        mut rgb: [f64; 3],
    ) -> Result<()> {
        if let Some(least) = self.negatives.apply(&mut rgb) {
            *self.least = self.least.min(least);
        }
        let [r, g, b] = rgb.map(exact);
        self.rows.row([&light.name, &material.name, &normal.to_string(), &r, &g, &b])
    }
}

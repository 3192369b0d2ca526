//! `eigenshade shade`: writes the irradiance of given normals.

use super::choices::Choices;
use super::options::{
    Destination, Inputs, TableChoice, WindowChoice, count, input_file, tolerance,
};
use super::shade_images::{Images, Output, Way};
use clap::{Args, ValueEnum};
use eigenshade::screen::NegativePolicy;
use eigenshade_cli::messages::{Ringing, albedo_warning, dark_light_warning, print_message};
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_cli::table::rounding;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_model::window::Window;
use eigenshade_shading::integer_shader::IntegerShader;
use eigenshade_shading::shader::{fitted, of_higher_order};
use eigenshade_table::reduce::with_components;
use eigenshade_table::wire;
use std::path::{Path, PathBuf};

/// Shade given normals for every light on every material
///
/// Writes the CSV `light,material,normal,r,g,b`; normals are counted from 0. Each number is written
/// with all digits.
#[derive(Args, Debug)]
pub struct Shade {
    #[command(flatten)]
    table: TableChoice,
    #[command(flatten)]
    inputs: Inputs,
    /// Normals CSV, `x,y,z`
    #[arg(short, long, value_name = "FILE")]
    normals: PathBuf,
    #[command(flatten)]
    choices: Choices,
    /// Number format [default: f32, and f64 for the method modes]
    #[arg(short, long, value_enum)]
    format: Option<Format>,
    /// How a pixel is computed
    #[arg(long, value_enum, default_value_t = Method::Polynomial)]
    method: Method,
    /// Method baked: texels on each side, 2 to 4096 [default: 64]
    #[arg(short, long, value_name = "N", value_parser = count(2, 4_096))]
    size: Option<usize>,
    /// Shade with fewer polynomial terms, as long as the rms difference over a picture of a sphere
    /// stays within this share of white under its metered exposure, like 2e-3. Needs the method
    /// polynomial in f32. The error of the components in use is not included
    #[arg(long, value_name = "T", value_parser = tolerance)]
    tolerance: Option<f64>,
    /// Set irradiance below zero to zero, and report the least value on standard error
    #[arg(long)]
    clamp: bool,
    #[command(flatten)]
    out: Destination,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Format {
    /// The sum of the eigenimages in double precision, for comparison
    F64,
    F32,
    /// Integers of 16 bits
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
    /// The image baked on a paraboloid map of --size, and looked up
    Baked,
}

impl Shade {
    pub fn run(self) -> Result<()> {
        let is_integer = self.format == Some(Format::Q15);
        if self.method == Method::Modes && !matches!(self.format, None | Some(Format::F64)) {
            let what = "the method modes supports only f64";
            return Err(Error::new(what, "leave --format out, or choose another method"));
        }
        if self.method == Method::Modes && self.choices.components.is_some() {
            let what = "the method modes sums modes, not components";
            return Err(Error::new(what, "leave --components out, or choose another method"));
        }
        if is_integer && self.method != Method::Polynomial {
            let what = "q15 supports only the method polynomial";
            return Err(Error::new(what, "use --method polynomial, or --format f32"));
        }
        let is_f32 = matches!(self.format, None | Some(Format::F32));
        if self.tolerance.is_some() && (!is_f32 || self.method != Method::Polynomial) {
            let what = "--tolerance needs the method polynomial in f32";
            return Err(Error::new(what, "leave it out, or use those"));
        }
        if self.method == Method::Baked && !is_f32 {
            let what = "the method baked supports only f32";
            return Err(Error::new(what, "leave --format out, or choose another method"));
        }
        refuse_object(&self.normals)?;
        let inputs = self.inputs.files(&[&self.normals, self.table.path()]);
        output::refuse_collisions(&self.out.path, inputs)?;
        let table = self.table.read()?;
        let effects = self.choices.effects(&table)?;
        self.choices.check_rotation(&table)?;
        let way = self.way()?;
        let components = self.choices.components(&table, self.table.path())?;
        // Integers of some components are scaled without the others, as `pack` scales them.
        let is_part = is_integer && components < table.count() && table.has_projection();
        let table =
            if is_part { with_components(&table, |number, _| number < components) } else { table };
        // The rounding of all components was measured, but not that of fewer.
        let stored = self.stored().filter(|_| !is_part);
        let lights = self.inputs.light.lights()?;
        let materials = self.inputs.material.materials(table.gram.order)?;
        let higher =
            of_higher_order(self.inputs.material.named(), materials.order, table.gram.order);
        let dark = dark_light_warning(&lights);
        let is_dark = dark.is_some();
        let warnings = higher.into_iter().chain(albedo_warning(&materials)).chain(dark);
        let (mut lights, materials) = fitted(&table, &lights, &materials);
        self.choices.rotate(&mut lights);
        if let Some(window) = self.window()? {
            let channels = lights.entries.iter_mut().flat_map(|entry| &mut entry.rgb);
            channels.for_each(|channel| window.apply(channel));
        }
        let warnings = warnings.chain(stored.and_then(|one| rounding::warning(&table, one)));
        let normals = read_normals(input_file(&self.normals))?;
        let tolerance = self.tolerance;
        let rounding = stored.and_then(|format| table.rounding(format));
        let rounding = rounding.map_or(0.0, |rounding| rounding.largest);
        let images =
            Images { table, lights, materials, normals, components, effects, tolerance, rounding };
        let negatives = if self.clamp { NegativePolicy::Clamped } else { NegativePolicy::Kept };
        let (mut least, mut ringing) = (f64::INFINITY, Ringing::default());
        let mut write = |draw: &mut dyn FnMut(&mut Output<'_>) -> Result<()>| {
            output::write(self.out.path.as_deref(), |out| {
                let rows = Rows::new(out, ["light", "material", "normal", "r", "g", "b"])?;
                let mut out = Output { rows, negatives, least, ringing: Ringing::default() };
                draw(&mut out)?;
                (least, ringing) = (out.least, out.ringing);
                out.rows.finish()
            })
        };
        match (self.method, self.format) {
            (Method::Modes, _) => write(&mut |out| images.modes(out)),
            (_, Some(Format::F64)) => write(&mut |out| images.doubles(out)),
            (_, Some(Format::Q15)) => {
                let mut shader = self.integer_shader(&images)?;
                write(&mut |out| images.integers(&mut shader, out))
            }
            (_, _) => write(&mut |out| images.floats(way, out)),
        }?;
        if self.clamp && least < 0.0 {
            print_message(format_args!("least irradiance {}, clamped", exact(least)));
        }
        let note = ringing.note().filter(|_| self.choices.has_all_effects() && !is_dark);
        warnings.chain(note).for_each(print_message);
        Ok(())
    }

    /// The window that is asked for, which cannot depend on a picture: there are only normals.
    fn window(&self) -> Result<Option<Window>> {
        match self.choices.window() {
            None => Ok(None),
            Some(WindowChoice::Given(window)) => Ok(Some(window)),
            Some(WindowChoice::Auto) => {
                let what = "--window auto is for a picture, and `shade` has normals only";
                Err(Error::new(what, "give a width, which `render` prints, or leave it out"))
            }
        }
    }

    /// The shader in integers, before anything is written.
    fn integer_shader(&self, images: &Images) -> Result<IntegerShader> {
        IntegerShader::new(&images.table, images.components)
            .map_err(|error| error.in_file(self.table.path()))
    }

    /// The format that the table's numbers are rounded to, if any.
    fn stored(&self) -> Option<wire::NumberFormat> {
        match (self.method, self.format) {
            (Method::Modes, _) | (_, Some(Format::F64)) => None,
            (_, None | Some(Format::F32)) => Some(wire::NumberFormat::F32),
            (_, Some(Format::Q15)) => Some(wire::NumberFormat::Q15),
        }
    }

    /// How a pixel is computed. An option of another method is an error.
    fn way(&self) -> Result<Way> {
        match (self.method, self.size) {
            (Method::Baked, size) => Ok(Way::Baked { size: size.unwrap_or(64) }),
            (_, Some(_)) => {
                let what = "--size belongs to the method baked, which is not selected";
                Err(Error::new(what, "leave --size out, or use --method baked"))
            }
            (Method::Eigen, None) => Ok(Way::Eigen),
            (Method::Modes | Method::Polynomial, None) => Ok(Way::Polynomial),
        }
    }
}

/// Refuses what `render` draws.
fn refuse_object(normals: &Path) -> Result<()> {
    let file = InputFile::from(normals);
    let kind = match file.extension().as_str() {
        "png" => "a normal map",
        _ if file.is_mesh() => "a mesh",
        _ if normals.as_os_str() == "sphere" && !normals.exists() => "a sphere",
        _ => return Ok(()),
    };
    let what = format!("it is {kind}, and `shade` takes a normals CSV, `x,y,z`");
    let remedy = format!("give a CSV, or draw {kind} with `render`");
    Err(Error::new(what, remedy).in_file(normals))
}

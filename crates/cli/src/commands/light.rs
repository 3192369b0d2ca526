//! `eigenshade light`: projects environment maps onto spherical harmonics.

use super::options::{Memory, count};
use clap::{Args, ValueEnum};
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::map_file::is_picture;
use eigenshade_generator::light::projection::{exchanged, named_maps, project};
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::{read_lights, write_lights};
use eigenshade_model::inputs::coefficient_text::{LIGHT_DIGITS, rounded};
use std::path::{Path, PathBuf};

/// The degree of the shipped table.
const DEGREE: usize = 9;

/// Project environment maps onto light coefficients, or convert coefficients
///
/// Writes the CSV `name,l,m,r,g,b` with nine significant digits. Maps are equirectangular, with row
/// 0 at the top. Pictures (.png, .jpg) are decoded by the curve of sRGB, white to a radiance of 1;
/// the other kinds are linear. The share of each map's radiance that is negative is reported on
/// standard error. The file of --out begins with a comment line, `#` and the command.
///
/// A single light CSV in place of maps is converted from the OTHER convention to the one of
/// --convention: `light graphics.csv --convention paper` reads coefficients in the graphics
/// convention. --degree then drops higher degrees; a degree that the file does not reach is an
/// error.
#[derive(Args, Debug)]
pub struct Light {
    /// Maps (.exr, .hdr, .pfm, .png, .jpg), folders of maps, or one light CSV
    #[arg(value_name = "MAP", required = true)]
    maps: Vec<PathBuf>,
    /// Largest degree l of the coefficients, 0 to 256 [default: 9, or that of the light CSV]
    #[arg(long, value_name = "L", value_parser = count(0, 256))]
    degree: Option<usize>,
    /// Convention of the output
    #[arg(long, value_enum, default_value_t = Convention::Paper)]
    convention: Convention,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Convention {
    /// Nillius and Eklundh's: Condon-Shortley phase, signed m in sin(m phi)
    Paper,
    /// The convention of three.js, Filament and Ramamoorthi
    Graphics,
}

impl Light {
    pub fn run(self, memory: Memory) -> Result<()> {
        let lights = match self.maps.as_slice() {
            [file] if is_csv(file) => {
                output::refuse_collisions(&self.out, [file])?;
                exchanged(&read_lights(memory.file(file), self.degree)?)
            }
            maps => {
                let files = files(maps)?;
                output::refuse_collisions(&self.out, files.iter().map(|(_, path)| path))?;
                let lights = projected(files, self.degree.unwrap_or(DEGREE), memory)?;
                match self.convention {
                    Convention::Paper => lights,
                    Convention::Graphics => exchanged(&lights),
                }
            }
        };
        output::write(self.out.as_deref(), |out| {
            if self.out.is_some() {
                output::write_command_line(out)?;
            }
            write_lights(&lights, out)
        })
    }
}

fn is_csv(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

/// The maps with their names.
fn files(maps: &[PathBuf]) -> Result<Vec<(String, PathBuf)>> {
    if let Some(file) = maps.iter().find(|file| is_csv(file)) {
        let what = "a light CSV among other inputs";
        return Err(Error::new(what, "convert one CSV at a time, without maps").in_file(file));
    }
    named_maps(maps)
}

/// The lights of the maps, with the digits of the shipped files.
fn projected(files: Vec<(String, PathBuf)>, degree: usize, memory: Memory) -> Result<Lights> {
    let progress = progress_bar("maps", files.len());
    let mut entries = Vec::new();
    for (name, path) in files {
        let map = EnvironmentMap::from_path(memory.file(&path))?;
        let share = map.negative_integral().negative_share();
        progress.suspend(|| report(&name, &path, &map, share));
        entries.push(Named { name, rgb: project(&map, degree) });
        progress.inc(1);
    }
    progress.finish_and_clear();
    Ok(rounded(&Lights { degree, entries }, LIGHT_DIGITS))
}

fn report(name: &str, path: &Path, map: &EnvironmentMap, share: f64) {
    // The share of a map without negative texels is -0.
    let (width, height, share) = (map.width, map.height, share + 0.0);
    if share.is_nan() {
        print_message(format_args!("{name}: {width} x {height}, black"));
    } else {
        print_message(format_args!(
            "{name}: {width} x {height}, negative radiance {share:.2e} of the whole"
        ));
    }
    let shown = path.display();
    if is_picture(path) {
        print_message(format_args!(
            "warning: {shown} is a picture: what is brighter than white is missing, such as lamps \
             and the sun; an .hdr or .exr map keeps it"
        ));
    }
    if !map.is_twice_as_wide_as_high() {
        print_message(format_args!(
            "warning: {shown} is not twice as wide as high; it is read as equirectangular"
        ));
    }
}

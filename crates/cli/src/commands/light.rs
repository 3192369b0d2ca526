//! `eigenshade light`: projects environment maps onto spherical harmonics.

use super::light_coefficients::{self, Convention, is_of_coefficients};
use super::options::{Destination, choice, count, input_file, number};
use clap::Args;
use clap::builder::TypedValueParser;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output;
use eigenshade_generator::light::cube::{FACES, are_faces, face_files};
use eigenshade_generator::light::frame::Frame;
use eigenshade_generator::light::map::{Layout, Map};
use eigenshade_generator::light::projection::{coefficients, named_maps};
use eigenshade_model::database::{Lights, Named, name_remedy};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_lights;
use eigenshade_model::inputs::coefficient_text::{LIGHT_DIGITS, rounded};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::source_csv::write_sources;
use eigenshade_model::inputs::source_error_csv::write_source_errors;
use eigenshade_model::shipped;
use eigenshade_model::source::{Base, NamedSources, Source, SourceError};
use eigenshade_shading::presets::{
    SOURCE_ERRORS, SOURCES, Source as Preset, beside, refuse_stale_sources,
};
use eigenshade_shading::sources::light_tree::BLOCK;
use eigenshade_shading::sources::pursuit::{self, FITTED};
use eigenshade_shading::sources::remaining;
use eigenshade_table::highlights::{MAX_SOURCES, ROUGHNESS};
use std::path::{Path, PathBuf};

/// Digits of the numbers of a source.
const DIGITS: usize = 6;

/// The degree of the shipped table.
const DEGREE: usize = 9;

/// Project environment maps onto light coefficients, or convert coefficients
///
/// Writes the CSV `name,l,m,r,g,b` with nine significant digits. Maps are equirectangular, with row
/// 0 at the top, or cubes. The middle of a map, or the face pz, is -z, in front of the camera.
/// Pictures (.png, .jpg) are decoded by the curve of sRGB, white to a radiance of 1, and turned as
/// their EXIF data state; the other kinds are linear. Colors of other primaries are converted to
/// linear sRGB. Standard error reports what a file states and is not applied, like opacity, color
/// profiles and exposure, and the share of negative radiance in each map.
///
/// A single light CSV in place of maps is converted from the convention --from to --convention, one
/// of which must be given, or --degree: it drops higher degrees, and must not exceed that of the
/// file. The name of a shipped light stands for its CSV, in `paper`. The text of cmgen (.txt) and
/// the `LightProbe` of three.js (.json) state their convention, so that --from may be left out.
/// `cmgen-irradiance` and `filament` hold irradiance, up to degree 2.
#[derive(Args, Debug)]
pub struct Light {
    /// Maps (.exr, .hdr, .pfm, .png, .jpg), folders of maps, or one light: a CSV, cmgen's text
    /// (.txt), three.js' `LightProbe` (.json), or a shipped one
    #[arg(value_name = "MAP", required = true)]
    maps: Vec<PathBuf>,
    /// Layout of the maps [default: the `envmap` of an .exr, `cube` for a folder of only px, nx, py,
    /// ny, pz and nz, `cross` for a picture of 4:3 or 3:4 with square faces, else
    /// `equirectangular`]
    #[arg(long, value_parser = layouts())]
    layout: Option<Layout>,
    /// Program whose placement of maps to follow. The camera looks along -z with y up. Cubes are
    /// placed by `eigenshade`, `threejs` and `filament` only; the cube of an .exr is placed as the
    /// equirectangular map that OpenEXR makes of it
    #[arg(long, value_parser = frames(), default_value = "eigenshade")]
    frame: Frame,
    /// Largest degree l of the coefficients, 0 to 256 [default: 9, or that of the light CSV]
    #[arg(long, value_name = "L", value_parser = count(0, 256))]
    degree: Option<usize>,
    /// Convention of the output
    #[arg(long, value_enum, default_value_t = Convention::Paper)]
    convention: Convention,
    /// Convention of a light's coefficients [default: `paper` for a CSV, else what the file states]
    #[arg(long, value_enum)]
    from: Option<Convention>,
    /// Find up to K small bright sources, K from 1 to 32, in the order of their worth, for the
    /// highlights of glossy materials: see `render --sources`. They are written beside the output,
    /// to FILE.sources.csv for FILE.csv, and the errors of pictures with the first ones to
    /// FILE.sources.errors.csv. Maps must be equirectangular, and the convention `paper`. Takes
    /// half a minute a map
    #[arg(long, value_name = "K", value_parser = count(1, MAX_SOURCES as u64), requires = "out")]
    sources: Option<usize>,
    /// Roughness of the materials that sources are found for, 0.1 to 1
    #[arg(long = "for", value_name = "R,R", value_delimiter = ',', requires = "sources",
        value_parser = number(0.1..=1.0, "a roughness from 0.1 to 1"), default_values_t = FITTED)]
    roughness: Vec<f64>,
    #[command(flatten)]
    out: Destination,
}

fn layouts() -> impl TypedValueParser<Value = Layout> {
    let cross = "A cube in one picture of 4 x 3 or 3 x 4 faces: pz in the middle, py above it, px \
                 right of it";
    let cube = "A folder with the faces px, nx, py, ny, pz and nz, seen from inside, as of OpenGL";
    choice([
        ("equirectangular", "One picture, twice as wide as high", Layout::Equirectangular),
        ("cross", cross, Layout::Cross),
        ("cube", cube, Layout::Cube),
    ])
}

fn frames() -> impl TypedValueParser<Value = Frame> {
    let blender = "The middle of the map is Blender's +x, right of the camera of the front view";
    let threejs = "The middle of the map is +x; of a cube, pz is +z and px is -x";
    let filament = "That of cmgen: the middle of the map is +z; of a cube, pz is +z and px is -x";
    choice([
        ("eigenshade", "The middle of the map is -z", Frame::Eigenshade),
        ("threejs", threejs, Frame::ThreeJs),
        ("blender", blender, Frame::Blender),
        ("mitsuba", "The middle of the map is +z", Frame::Mitsuba),
        ("openexr", "The middle of the map is +z", Frame::OpenExr),
        ("filament", filament, Frame::Filament),
    ])
}

impl Light {
    pub fn run(self) -> Result<()> {
        let out = self.out.path.as_deref();
        let beside = out.and_then(|out| beside(out, SOURCES).zip(beside(out, SOURCE_ERRORS)));
        if self.sources.is_none() {
            refuse_stale_sources(out)?;
        } else if self.convention != Convention::Paper {
            let what = "--sources needs the convention `paper`, in which its lights are read";
            return Err(Error::new(what, "leave --convention out, or --sources"));
        } else if beside.is_none() {
            let what = "--sources writes FILE.sources.csv beside FILE.csv only";
            return Err(Error::new(what, "give --out a name that ends in .csv"));
        }
        let shipped = match self.maps.as_slice() {
            [name] if !name.exists() => self.shipped(name)?,
            _ => None,
        };
        let lights = match self.maps.as_slice() {
            [file] if shipped.is_some() || is_of_coefficients(&input_file(file)) => {
                if self.sources.is_some() {
                    let what = "--sources needs a map: coefficients are harmonics only";
                    return Err(Error::new(what, "give the map").in_file(file));
                }
                if self.layout.is_some() || self.frame != Frame::Eigenshade {
                    let what = "coefficients have neither a layout nor a frame";
                    let remedy = "leave --layout and --frame out, or give maps";
                    return Err(Error::new(what, remedy).in_file(file));
                }
                output::refuse_collisions(&self.out.path, [file])?;
                let (from, lights) = match (shipped, self.from, self.convention) {
                    (Some(_), Some(_), _) => {
                        let what = "--from is for files: a shipped light is in `paper`";
                        return Err(Error::new(what, "leave it out").in_file(file));
                    }
                    (Some(lights), None, _) => (Convention::Paper, lights),
                    (None, from, to) => {
                        let (lights, from) =
                            light_coefficients::read(input_file(file), self.degree, from)?;
                        if from.is_none() && to == Convention::Paper && self.degree.is_none() {
                            let what = "nothing to convert: it is taken to be in `paper` already";
                            let remedy = "give its convention, as --from graphics, another \
                                          --convention, or --degree";
                            return Err(Error::new(what, remedy).in_file(file));
                        }
                        (from.unwrap_or(Convention::Paper), lights)
                    }
                };
                from.convert(lights, self.convention).map_err(|error| error.in_file(file))?
            }
            maps => {
                if self.from.is_some() {
                    let what = "--from is the convention of a light's coefficients";
                    return Err(Error::new(what, "leave it out, or give one light"));
                }
                let files = files(maps)?;
                let inputs: Result<Vec<_>> = files.iter().map(|(_, path)| pictures(path)).collect();
                let all_beside = beside.iter().flat_map(|(sources, errors)| [sources, errors]);
                let outputs = self.out.path.iter().chain(all_beside);
                output::refuse_collisions(outputs, inputs?.concat())?;
                let lights = self.projected(&files)?;
                if let (Some(most), Some((of_sources, of_errors))) = (self.sources, beside) {
                    // The search takes long, and runs once the maps are read and the files open.
                    let search = || {
                        output::write(Some(&of_sources), |out| {
                            let (sources, errors) = self.found(&files, most)?;
                            write_sources(&sources, out)?;
                            output::write(Some(&of_errors), |out| write_source_errors(&errors, out))
                        })
                    };
                    return output::write_before(out, |out| write_lights(&lights, out), search);
                }
                Convention::Paper.convert(lights, self.convention)?
            }
        };
        output::write(out, |out| write_lights(&lights, out))
    }

    /// The shipped light of this name, to the degree that is asked for. `None` if it cannot be one.
    fn shipped(&self, name: &Path) -> Result<Option<Lights>> {
        let text = name.to_string_lossy();
        let Ok(named) = text.parse::<Preset>();
        if !named.is_shipped() {
            return Ok(None);
        }
        let mut lights = shipped::lights()?;
        let names = lights.entries.iter().map(|light| light.name.as_str());
        let remedy = name_remedy(&text, names, "the path of a map, a folder or a light CSV");
        lights.entries.retain(|light| text == light.name);
        if lights.entries.is_empty() {
            let what = format!("`{text}` is neither a file nor a shipped light");
            return Err(Error::new(what, remedy));
        }
        match self.degree {
            Some(degree) if degree > lights.degree => {
                let what = format!("the shipped lights end at degree {}", lights.degree);
                Err(Error::new(what, "give a --degree up to that").in_file(name))
            }
            degree => Ok(Some(lights.truncated(degree.unwrap_or(lights.degree)))),
        }
    }

    /// The lights of the maps, with the digits of the shipped files.
    fn projected(&self, files: &[(String, PathBuf)]) -> Result<Lights> {
        let degree = self.degree.unwrap_or(DEGREE);
        let progress = progress_bar("maps", files.len());
        let mut entries = Vec::new();
        for (name, path) in files {
            let map = progress.suspend(|| Map::read(input_file(path), self.layout))?;
            if self.sources.is_some() && map.is_cube() {
                return Err(in_cube(path));
            }
            let rgb =
                coefficients(&map, self.frame, degree).map_err(|error| error.in_file(path))?;
            progress.suspend(|| self.report(name, path, &map));
            entries.push(Named { name: name.clone(), rgb });
            progress.inc(1);
        }
        Ok(rounded(&Lights { degree, entries }, LIGHT_DIGITS))
    }

    /// The sources of the maps, in the frame of the lights, and the errors that they leave.
    fn found(
        &self,
        files: &[(String, PathBuf)],
        most: usize,
    ) -> Result<(Vec<NamedSources>, Vec<SourceError>)> {
        let progress = progress_bar("maps", files.len());
        let materials = pursuit::metals(&self.roughness)?;
        let of = |base| Ok((base, remaining::materials(base, &ROUGHNESS)?));
        let compared = Base::ALL.into_iter().map(of).collect::<Result<Vec<_>>>()?;
        let (mut lights, mut errors) = (Vec::new(), Vec::new());
        for (name, path) in files {
            // Its warnings are known already.
            let map = Map::read(InputFile::new(path), self.layout)?;
            let Map::Equirectangular(map) = map else { return Err(in_cube(path)) };
            let map = &map.in_blocks(BLOCK);
            let turn = self.frame.turn(false)?.matrix();
            let sources = pursuit::find(map, &materials, most);
            let sources = sources.map_err(|error| error.in_file(path))?;
            let rounded = |source: Source| source.rounded(DIGITS);
            let sources: Vec<Source> = sources.into_iter().map(rounded).collect();
            let left = remaining::errors(map, name, &sources, &compared);
            errors.extend(left.map_err(|error| error.in_file(path))?);
            let turned = sources.iter().map(|source| rounded(source.turned(turn)));
            lights.push(NamedSources { name: name.clone(), sources: turned.collect() });
            progress.inc(1);
        }
        Ok((lights, errors))
    }

    /// Describes a map that was read, with warnings, on standard error.
    fn report(&self, name: &str, path: &Path, map: &Map) {
        let shape = match map {
            Map::Equirectangular(map) => format!("{} x {}", map.width, map.height),
            Map::Cube(cube) if path.is_dir() || cube.is_of_openexr() => {
                format!("a cube of faces of {0} x {0}", cube.size())
            }
            Map::Cube(cube) => {
                let is_given = self.layout.is_some();
                let hint = if is_given { "" } else { " (else give --layout equirectangular)" };
                format!("read as a cross of faces of {0} x {0}{hint}", cube.size())
            }
        };
        // The share of a map without negative texels is -0.
        let share = map.negative_integral().negative_share() + 0.0;
        let negative = match 100.0 * share {
            percent if percent.is_nan() => "black".to_owned(),
            0.0 => "no negative radiance".to_owned(),
            percent => format!(
                "{} % of the radiance is negative, which filters and color conversions of a map \
                 leave; it is kept",
                if percent < 0.01 { "less than 0.01".to_owned() } else { format!("{percent:.2}") }
            ),
        };
        print_message(format_args!("{name}: {shape}, {negative}"));
        map.warn(&input_file(path));
    }
}

/// The error of a map in which no sources are found.
fn in_cube(path: &Path) -> Error {
    let remedy = "leave --sources out, or give an equirectangular map";
    Error::new("sources are not found in cubes", remedy).in_file(path)
}

/// The maps with their names.
fn files(maps: &[PathBuf]) -> Result<Vec<(String, PathBuf)>> {
    if let Some(file) = maps.iter().find(|file| is_of_coefficients(&InputFile::from(file))) {
        let what = "coefficients of a light among other inputs";
        return Err(Error::new(what, "convert one light at a time, without maps").in_file(file));
    }
    if let Some(missing) = maps.iter().find(|map| !map.exists())
        && shipped::lights()?.entries.iter().any(|light| missing.as_os_str() == light.name.as_str())
    {
        let what = "it is a shipped light, which is converted by itself";
        let remedy = "convert one light at a time, without maps";
        return Err(Error::new(what, remedy).in_file(missing));
    }
    if maps.len() == FACES.len() && are_faces(maps) {
        return Err(Error::new("six faces of a cube as six maps", "give the folder that has them"));
    }
    named_maps(maps)
}

/// The files of a map: one picture, or the faces of a cube in a folder.
fn pictures(path: &Path) -> Result<Vec<PathBuf>> {
    if path.is_dir() { face_files(path) } else { Ok(vec![path.to_owned()]) }
}

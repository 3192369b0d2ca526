//! A light.

use crate::arrays::{Numbers, channels, of_channels, of_rows, refused};
use crate::work::{done, input_file};
use eigenshade_generator::light::frame::Frame;
use eigenshade_generator::light::map::Map;
use eigenshade_generator::light::projection::coefficients;
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source;
use eigenshade_model::window::Window;
use eigenshade_shading::presets;
use eigenshade_shading::sources::light_tree::BLOCK;
use eigenshade_shading::sources::pursuit::{self, FITTED};
use eigenshade_table::highlights::MAX_SOURCES;
use numpy::PyArray2;
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Distant light: radiance as real spherical harmonics, in the frame of the camera, which looks
/// along -z with y up.
///
/// ``Light(coefficients, name="light")`` takes an array of shape (n,) or (3, n) with n = (degree +
/// 1)²; L_l^m is at l² + l + m.
#[pyclass(module = "eigenshade", frozen)]
#[derive(Clone)]
pub struct Light {
    pub entry: Named,
    pub degree: usize,
    pub sources: Vec<Source>,
}

#[pymethods]
impl Light {
    #[new]
    #[pyo3(signature = (coefficients, name = "light"))]
    fn new(coefficients: Numbers<'_>, name: &str) -> PyResult<Self> {
        let rgb = channels(&coefficients, "coefficients of a light")?;
        let degree = rgb[0].len().isqrt().saturating_sub(1);
        if degree > MOST_DEGREE || (degree + 1).pow(2) != rgb[0].len() {
            let what = format!("a light of {} coefficients", rgb[0].len());
            return Err(refused(
                what,
                "give 1, 4, 9, .. (degree + 1)² for each channel, up to degree 256",
            ));
        }
        Ok(Self { entry: Named { name: name.to_owned(), rgb }, degree, sources: Vec::new() })
    }

    /// Reads an environment map (.exr, .hdr, .pfm, .png, .jpg), or a light CSV of the program.
    ///
    /// A map is projected to harmonics up to ``degree``, by default 9, the degree of the shipped
    /// table. Up to ``sources`` small bright sources are found in it for highlights, which takes
    /// half a minute.
    ///
    /// A CSV may have several lights: ``name`` selects one. ``degree`` is at most that of the file.
    /// Up to ``sources`` sources are read from the file beside it.
    #[staticmethod]
    #[pyo3(signature = (path, *, degree = None, sources = 0, name = None))]
    fn load(
        py: Python<'_>,
        path: PathBuf,
        degree: Option<usize>,
        sources: usize,
        name: Option<String>,
    ) -> PyResult<Self> {
        if sources > MAX_SOURCES {
            let what = format!("{sources} sources");
            return Err(refused(what, &format!("ask for at most {MAX_SOURCES}")));
        }
        let is_csv = path.extension().is_some_and(|end| end.eq_ignore_ascii_case("csv"));
        done(py, "light", move || match (is_csv, name) {
            (true, name) => of_csv(&path, degree, sources, name),
            (false, None) => of_map(&path, degree.unwrap_or(DEGREE), sources),
            (false, Some(_)) => {
                let error = Error::new("a map has one light", "leave `name` out");
                Err(error.in_file(path))
            }
        })
    }

    /// Its name.
    #[getter]
    fn name(&self) -> &str {
        &self.entry.name
    }

    /// The largest l.
    #[getter]
    fn degree(&self) -> usize {
        self.degree
    }

    /// L_l^m at l² + l + m: float64 (3, (degree + 1)²), radiance.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        of_channels(py, &self.entry.rgb)
    }

    /// Its small bright sources: float64 (n, 7) with the unit vector toward a source, its energy in
    /// red, green and blue, and its standard deviation in radians.
    #[getter]
    fn sources<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<f64>> {
        let row =
            |source: &Source| [&source.direction[..], &source.energy, &[source.spread]].concat();
        of_rows(py, &self.sources.iter().map(row).collect::<Vec<_>>())
    }

    /// The light turned by R = Ry(yaw) Rx(pitch) Rz(roll), radians, in the camera's frame: x to the
    /// right, y up, z toward the camera.
    #[pyo3(signature = (*, yaw = 0.0, pitch = 0.0, roll = 0.0))]
    fn rotated(&self, yaw: f64, pitch: f64, roll: f64) -> PyResult<Self> {
        if ![yaw, pitch, roll].iter().all(|angle| angle.is_finite()) {
            return Err(refused("an angle is not finite", "give angles in radians"));
        }
        let ((sy, cy), (sx, cx)) = (yaw.sin_cos(), pitch.sin_cos());
        // Ry Rx, then the roll about z is the first angle of Rz Ry Rz.
        let tilt = [[cy, sy * sx, sy * cx], [0.0, cx, -sx], [-sy, cy * sx, cy * cx]];
        let alpha = tilt[0][2].hypot(tilt[1][2]).atan2(tilt[2][2]);
        let beta = tilt[1][2].atan2(tilt[0][2]);
        // What Rz(beta) Ry(alpha) leaves of the tilt is a turn about z.
        let (sb, cb) = beta.sin_cos();
        let gamma = (cb * tilt[1][0] - sb * tilt[0][0]).atan2(cb * tilt[1][1] - sb * tilt[0][1]);
        let rotation = Rotation { alpha, beta, gamma: gamma + roll };
        let rgb = self.entry.rgb.each_ref().map(|channel| rotation.turn(self.degree, channel));
        let sources = self.sources.iter().map(|source| source.turned(rotation.matrix())).collect();
        Ok(Self { entry: Named { rgb, ..self.entry.clone() }, degree: self.degree, sources })
    }

    /// The light without the degrees above ``degree``.
    fn truncated(&self, degree: usize) -> Self {
        let lights = Lights { degree: self.degree, entries: vec![self.entry.clone()] };
        let Lights { degree, mut entries } = lights.truncated(degree);
        Self { entry: entries.remove(0), degree, sources: self.sources.clone() }
    }

    /// The light with degree l times sinc⁴, (sin x / x)⁴ with x = π l / width, zero from ``width``
    /// on: less ringing, and softer. It has no sources: they are in the harmonics.
    fn windowed(&self, width: f64) -> PyResult<Self> {
        if !(width > 0.0 && width.is_finite()) {
            return Err(refused(format!("a window of width {width}"), "give a width above 0"));
        }
        let mut light = Self { sources: Vec::new(), ..self.clone() };
        let window = Window::SincFourth { width };
        light.entry.rgb.iter_mut().for_each(|channel| window.apply(channel));
        Ok(light)
    }

    fn __repr__(&self) -> String {
        let Self { entry, degree, sources } = self;
        format!("<Light {}, degree {degree}, {} sources>", entry.name, sources.len())
    }
}

/// The degree of the shipped table.
const DEGREE: usize = 9;

fn of_csv(path: &Path, degree: Option<usize>, most: usize, name: Option<String>) -> Result<Light> {
    let source = presets::Source::of_file(path, name);
    let Lights { degree: found, entries } = source.lights()?;
    let entry = source.only(entries)?;
    let sources = if most > 0 { source.sources(&entry.name, most)? } else { Vec::new() };
    let light = Light { entry, degree: found, sources };
    match degree {
        Some(degree) if degree > found => {
            let what = format!("its lights end at degree {found}");
            Err(Error::new(what, "give a `degree` up to that").in_file(path))
        }
        degree => Ok(light.truncated(degree.unwrap_or(found))),
    }
}

fn of_map(path: &Path, degree: usize, most: usize) -> Result<Light> {
    if degree > MOST_DEGREE {
        let what = format!("a light of degree {degree}");
        return Err(Error::new(what, format!("ask for at most {MOST_DEGREE}")));
    }
    let file = input_file(path);
    let map = Map::read(file.clone(), None)?;
    map.warn(&file);
    let frame = Frame::Eigenshade;
    let rgb = coefficients(&map, frame, degree).map_err(|error| error.in_file(path))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let sources = match (most, map) {
        (0, _) => Vec::new(),
        (most, Map::Equirectangular(map)) => {
            pursuit::find(&map.in_blocks(BLOCK), &pursuit::metals(&FITTED)?, most)
                .map_err(|error| error.in_file(path))?
        }
        (_, Map::Cube(_)) => {
            let error = Error::new("sources are not found in cubes", "give an equirectangular map");
            return Err(error.in_file(path));
        }
    };
    Ok(Light { entry: Named { name, rgb }, degree, sources })
}

/// The largest degree of a light.
const MOST_DEGREE: usize = 256;

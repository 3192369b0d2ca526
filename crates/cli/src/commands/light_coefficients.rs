//! The coefficients of a light in files of other programs, and their conventions.

use clap::ValueEnum;
use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::inputs::input_file::InputFile;
use serde::Deserialize;

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Convention {
    /// Nillius and Eklundh's: Condon-Shortley phase, signed m in sin(m phi)
    Paper,
    /// Radiance, as three.js (`LightProbe`) and Ramamoorthi have it
    #[value(alias = "three")]
    Graphics,
    /// Radiance, as `cmgen --sh` prints it
    Cmgen,
    /// Irradiance, as `cmgen --sh --sh-irradiance` prints it
    CmgenIrradiance,
    /// Irradiance over pi as a polynomial: Filament's `irradiance`, cmgen's sh.txt
    Filament,
}

impl Convention {
    /// The runtime's; `None` for its own.
    fn other(self) -> Option<eigenshade::lights::Convention> {
        match self {
            Self::Paper => None,
            Self::Graphics => Some(eigenshade::lights::Convention::ThreeJs),
            Self::Cmgen => Some(eigenshade::lights::Convention::Cmgen),
            Self::CmgenIrradiance => Some(eigenshade::lights::Convention::CmgenIrradiance),
            Self::Filament => Some(eigenshade::lights::Convention::Filament),
        }
    }

    /// The name of the option's value.
    fn name(self) -> String {
        self.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
    }

    /// Converts lights to another convention. Factors of irradiance are rounded to f32.
    pub fn convert(self, mut lights: Lights, to: Self) -> Result<Lights> {
        for channel in lights.entries.iter_mut().flat_map(|light| &mut light.rgb) {
            let [from, to] = [self, to].map(|convention| convention.factors(channel.len()));
            for (number, (from, to)) in channel.iter_mut().zip(from?.into_iter().zip(to?)) {
                *number *= f64::from(to) / f64::from(from);
            }
        }
        Ok(lights)
    }

    /// The coefficients of this convention for coefficients of 1 of ours.
    fn factors(self, count: usize) -> Result<Vec<f32>> {
        let mut ones = vec![1.0; count];
        self.other().map_or(Ok(()), |other| other.encode(&mut ones)).map_err(|fault| {
            Error::new(fault.to_string(), "give --degree 2, or another convention")
        })?;
        Ok(ones)
    }
}

/// Whether a file has coefficients, and is no map: a light CSV, cmgen's text or a `LightProbe`.
pub fn is_of_coefficients(file: &InputFile) -> bool {
    ["csv", "txt", "json"].contains(&file.extension().as_str())
}

/// The lights of a file up to `degree`, or all of it, and their convention: the given one, or the
/// one that the file states; a CSV states none. Fails if the two differ.
pub fn read(
    file: InputFile,
    degree: Option<usize>,
    given: Option<Convention>,
) -> Result<(Lights, Option<Convention>)> {
    let path = file.path().to_owned();
    let (rows, stated) = match file.extension().as_str() {
        "txt" => of_cmgen(&file.text()?),
        "json" => of_probe(&file),
        _ => return Ok((read_lights(file, degree)?, given)),
    }
    .map_err(|error| error.in_file(&path))?;
    if let Some(given) = given
        && given != stated
    {
        let what = format!("--from is {}, and the file is in {}", given.name(), stated.name());
        return Err(Error::new(what, "leave --from out").in_file(path));
    }
    let largest = rows.len().isqrt().saturating_sub(1);
    if rows.is_empty() || (largest + 1).pow(2) != rows.len() {
        let what = format!("it has {} coefficients, and a light has 1, 4, 9, ..", rows.len());
        return Err(Error::new(what, "save it again").in_file(path));
    }
    if let Some(row) = rows.iter().position(|row| !row.iter().all(|value| value.is_finite())) {
        let what = format!("coefficient {row} is not finite");
        return Err(Error::new(what, "save it again").in_file(path));
    }
    let rgb = [0, 1, 2].map(|channel| rows.iter().map(|row| row[channel]).collect());
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let lights = Lights { degree: largest, entries: vec![Named { name, rgb }] };
    match degree {
        Some(degree) if degree > largest => {
            let what = format!("it has degree {largest}, but degree {degree} is needed");
            Err(Error::new(what, format!("ask for at most degree {largest}")).in_file(path))
        }
        degree => Ok((lights.truncated(degree.unwrap_or(largest)), Some(stated))),
    }
}

/// Red, green and blue of each coefficient, in the order of degrees and orders, and the convention.
type Coefficients = (Vec<[f64; 3]>, Convention);

/// The text that cmgen prints: lines like `( 0.8,  0.7,  0.6); // L00, irradiance, pre-scaled base`.
/// Their comments state the convention.
fn of_cmgen(text: &str) -> Result<Coefficients> {
    let fault = |number: usize, line: &str| {
        let what =
            format!("line {} is `{}`", number + 1, line.chars().take(60).collect::<String>());
        Error::new(what, "give what `cmgen --sh` prints: `( r, g, b); // L00` and so on")
    };
    let (mut rows, mut stated) = (Vec::new(), None);
    for (number, line) in text.lines().map(str::trim).enumerate() {
        if line.is_empty() {
            continue;
        }
        let mut row = || {
            let (numbers, comment) = line.strip_prefix('(')?.split_once(')')?;
            let numbers: Option<Vec<f64>> =
                numbers.split(',').map(|number| number.trim().parse().ok()).collect();
            let mut words = comment.trim_start_matches(';').trim().strip_prefix("//")?.split(',');
            let degree = rows.len().isqrt();
            let order = rows.len() as i64 - (degree * (degree + 1)) as i64;
            let label = format!("L{degree}{order}");
            let is_label = words.next()?.trim() == label;
            let words: Vec<&str> = words.map(str::trim).collect();
            let convention = match words.as_slice() {
                [] => Convention::Cmgen,
                ["irradiance"] => Convention::CmgenIrradiance,
                ["irradiance", "pre-scaled base"] => Convention::Filament,
                _ => return None,
            };
            let is_same = *stated.get_or_insert(convention) == convention;
            (is_label && is_same).then_some(<[f64; 3]>::try_from(numbers?).ok()?)
        };
        let row = row().ok_or_else(|| fault(number, line))?;
        rows.push(row);
    }
    Ok((rows, stated.unwrap_or(Convention::Cmgen)))
}

/// A `LightProbe` as three.js writes it by `toJSON`.
#[derive(Deserialize)]
struct Probe {
    object: ProbeObject,
}

#[derive(Deserialize)]
struct ProbeObject {
    sh: Vec<f64>,
    #[serde(default = "one")]
    intensity: f64,
}

fn one() -> f64 {
    1.0
}

fn of_probe(file: &InputFile) -> Result<Coefficients> {
    let fault = |error: &dyn std::fmt::Display| {
        let remedy = "give what three.js' `LightProbe.toJSON` returns, with `object.sh`";
        Error::new(format!("it is not a LightProbe ({error})"), remedy)
    };
    let Probe { object } = serde_json::from_str(&file.text()?).map_err(|error| fault(&error))?;
    let (rows, rest) = object.sh.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(fault(&format_args!("`sh` has {} numbers", object.sh.len())));
    }
    if object.intensity != 1.0 {
        file.warn(format!("its intensity, {}, multiplies the coefficients", object.intensity));
    }
    let rows = rows.iter().map(|row| row.map(|value| object.intensity * value)).collect();
    Ok((rows, Convention::Graphics))
}

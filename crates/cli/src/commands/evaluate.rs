//! `eigenshade evaluate`: evaluates functions of the paper.

use super::options::{Destination, input_file};
use clap::{Args, ValueEnum};
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_model::{irradiance, polar_integral};
use std::f64::consts::{FRAC_PI_2, PI};
use std::path::PathBuf;

/// The largest index. The functions are tested up to it, irradiance modes as products of them.
const LARGEST: i64 = 64;

/// How far an angle may exceed its range, because files round π.
const SLACK: f64 = 1e-9;

/// Evaluate a function of the paper at given points
///
/// Writes the points with the function's value in the last column, `value`, with all digits. An
/// existing column `value` is replaced; the other columns keep their order. Indices go up to 64;
/// angles are in radians.
#[derive(Args, Debug)]
pub struct Evaluate {
    /// The function
    #[arg(value_enum)]
    function: Function,
    /// CSV with one column for each index and argument
    #[arg(value_name = "POINTS.csv")]
    points: PathBuf,
    #[command(flatten)]
    out: Destination,
}

impl Evaluate {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions(&self.out.path, [&self.points])?;
        let function = self.function;
        let (indices, arguments) = function.columns();
        let columns = [indices, arguments].concat().join(",");
        let sheet = Sheet::read(input_file(&self.points), &columns)?;
        let places = |names: &[&str]| -> Result<Vec<usize>> {
            let places = names.iter().map(|name| sheet.column(name)).collect::<Option<_>>();
            places.ok_or_else(|| sheet.wrong_header(&format!("`{columns}`")))
        };
        let (indices, arguments) = (places(indices)?, places(arguments)?);
        // All values are computed before anything is written.
        let values = sheet
            .rows()
            .map(|row| value(function, row, &indices, &arguments))
            .collect::<Result<Vec<_>>>()?;
        let replaced = sheet.column("value");
        let is_kept = |(place, _): &(usize, &str)| Some(*place) != replaced;
        output::write(self.out.path.as_deref(), |out| {
            let kept = sheet.header().enumerate().filter(is_kept).map(|(_, name)| name);
            let mut rows = Rows::new(out, kept.chain(["value"]))?;
            for (row, value) in sheet.rows().zip(values) {
                let value = exact(value);
                let kept = row.texts().enumerate().filter(is_kept).map(|(_, text)| text);
                rows.row(kept.chain([value.as_str()]))?;
            }
            rows.finish()
        })
    }
}

fn value(function: Function, row: Row<'_>, indices: &[usize], arguments: &[usize]) -> Result<f64> {
    let indices = indices.iter().map(|&place| row.integer(place)).collect::<Result<Vec<_>>>()?;
    let arguments = arguments.iter().map(|&place| row.number(place)).collect::<Result<Vec<_>>>()?;
    let value = function.value(&indices, &arguments);
    match value.map_err(|(what, remedy)| row.fault(what, remedy))? {
        value if value.is_finite() => Ok(value),
        value => Err(row.fault(format!("the value is {value}"), "use smaller indices")),
    }
}

/// A function of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Function {
    /// Y_l^m(theta, phi), (46): columns l,m,theta,phi
    SphericalHarmonic,
    /// d^l_mn(alpha), the P_l^mn of (45): columns l,m,n,alpha
    WignerD,
    /// R_o^q(rho) of (8): columns o,q,rho
    ZernikeRadial,
    /// C_lo^q, (11): columns l,o,q
    PolarIntegral,
    /// E_lop^mq(alpha, beta), (14): columns l,m,o,p,q,alpha,beta
    IrradianceMode,
}

/// The error of a point, and the remedy.
type Fault = (String, String);

type Checked<T> = std::result::Result<T, Fault>;

impl Function {
    /// The columns of its indices, and of its arguments.
    fn columns(self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Self::SphericalHarmonic => (&["l", "m"], &["theta", "phi"]),
            Self::WignerD => (&["l", "m", "n"], &["alpha"]),
            Self::ZernikeRadial => (&["o", "q"], &["rho"]),
            Self::PolarIntegral => (&["l", "o", "q"], &[]),
            Self::IrradianceMode => (&["l", "m", "o", "p", "q"], &["alpha", "beta"]),
        }
    }

    /// The value of the function. Fails if indices or arguments are outside its domain.
    fn value(self, indices: &[i64], arguments: &[f64]) -> Checked<f64> {
        match (self, indices, arguments) {
            (Self::SphericalHarmonic, &[l, m], &[theta, phi]) => {
                let l = degree("l", l)?;
                let theta = within("theta", theta, (PI, "pi"))?;
                Ok(spherical_harmonic::value(l, order("m", m, l)?, theta, phi))
            }
            (Self::WignerD, &[l, m, n], &[alpha]) => {
                let l = degree("l", l)?;
                let alpha = within("alpha", alpha, (PI, "pi"))?;
                Ok(wigner::value(l, order("m", m, l)?, order("n", n, l)?, alpha))
            }
            (Self::ZernikeRadial, &[o, q], &[rho]) => {
                let o = degree("o", o)?;
                let q = frequency(("o", o), ("q", q))?;
                Ok(zernike::value(o, q, within("rho", rho, (1.0, "1"))?))
            }
            (Self::PolarIntegral, &[l, o, q], []) => {
                let (l, o) = (degree("l", l)?, degree("o", o)?);
                let q = below(l, frequency(("o", o), ("q", q))?)?;
                Ok(polar_integral::value(l, o, q))
            }
            (Self::IrradianceMode, &[l, m, o, p, q], &[alpha, beta]) => {
                let (l, o) = (degree("l", l)?, degree("o", o)?);
                let p = frequency(("o", o), ("p", p))?;
                let q = below(l, frequency(("p", p), ("q", q))?)?;
                let alpha = within("alpha", alpha, (FRAC_PI_2, "pi/2"))?;
                Ok(irradiance::value(l, order("m", m, l)?, o, p, q, alpha, beta))
            }
            _ => Err(("a wrong number of fields".into(), "give every column".into())),
        }
    }
}

/// A degree l or an order o.
fn degree(name: &str, index: i64) -> Checked<usize> {
    let found = usize::try_from(index).ok().filter(|_| index <= LARGEST);
    let remedy = || format!("use 0 <= {name} <= {LARGEST}");
    found.ok_or_else(|| (format!("{name} = {index} is out of range"), remedy()))
}

/// A signed order of degree l.
fn order(name: &str, index: i64, l: usize) -> Checked<isize> {
    if index.unsigned_abs() > l as u64 {
        let what = format!("{name} = {index} is out of range for l = {l}");
        return Err((what, format!("use -l <= {name} <= l")));
    }
    Ok(index as isize)
}

/// An index below another of the same parity.
fn frequency((above, o): (&str, usize), (name, index): (&str, i64)) -> Checked<usize> {
    let found = usize::try_from(index).ok().filter(|&q| q <= o && (o - q) % 2 == 0);
    found.ok_or_else(|| {
        let what = format!("{name} = {index} is not possible with {above} = {o}");
        (what, format!("use 0 <= {name} <= {above}, both even or both odd"))
    })
}

/// q of a mode that the light's degree reaches.
fn below(l: usize, q: usize) -> Checked<usize> {
    if q > l {
        let what = format!("q = {q} is out of range for l = {l}");
        return Err((what, "use q <= l; there are no other modes".into()));
    }
    Ok(q)
}

/// An argument from 0 to a limit, which messages call `limit`.
fn within(name: &str, value: f64, (high, limit): (f64, &str)) -> Checked<f64> {
    if (-SLACK..=high + SLACK).contains(&value) {
        return Ok(value.clamp(0.0, high));
    }
    let what = format!("{name} = {} is out of range", exact(value));
    Err((what, format!("use 0 <= {name} <= {limit}")))
}

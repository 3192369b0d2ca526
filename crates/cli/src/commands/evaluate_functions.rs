//! The functions of `eigenshade evaluate`: columns, domains, values.

use clap::ValueEnum;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_model::{irradiance, polar_integral};
use std::f64::consts::{FRAC_PI_2, PI};

/// The largest index. The functions are tested up to it, irradiance modes as products of them.
const LARGEST: i64 = 64;

/// How far an angle may exceed its range, because files round π.
const SLACK: f64 = 1e-9;

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

/// The fault of a point, and the remedy.
type Fault = (String, String);

impl Function {
    /// The columns of its indices, and of its arguments.
    pub fn columns(self) -> (&'static [&'static str], &'static [&'static str]) {
        match self {
            Self::SphericalHarmonic => (&["l", "m"], &["theta", "phi"]),
            Self::WignerD => (&["l", "m", "n"], &["alpha"]),
            Self::ZernikeRadial => (&["o", "q"], &["rho"]),
            Self::PolarIntegral => (&["l", "o", "q"], &[]),
            Self::IrradianceMode => (&["l", "m", "o", "p", "q"], &["alpha", "beta"]),
        }
    }

    /// Its value.
    ///
    /// # Errors
    ///
    /// Indices or arguments outside its domain.
    pub fn value(self, indices: &[i64], arguments: &[f64]) -> Result<f64, Fault> {
        match (self, indices, arguments) {
            (Self::SphericalHarmonic, &[l, m], &[theta, phi]) => {
                let l = degree("l", l)?;
                let theta = within("theta", theta, 0.0, PI)?;
                Ok(spherical_harmonic::value(l, order("m", m, l)?, theta, phi))
            }
            (Self::WignerD, &[l, m, n], &[alpha]) => {
                let l = degree("l", l)?;
                let alpha = within("alpha", alpha, 0.0, PI)?;
                Ok(wigner::value(l, order("m", m, l)?, order("n", n, l)?, alpha))
            }
            (Self::ZernikeRadial, &[o, q], &[rho]) => {
                let o = degree("o", o)?;
                let q = frequency(("o", o), ("q", q))?;
                Ok(zernike::value(o, q, within("rho", rho, 0.0, 1.0)?))
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
                let alpha = within("alpha", alpha, 0.0, FRAC_PI_2)?;
                Ok(irradiance::value(l, order("m", m, l)?, o, p, q, alpha, beta))
            }
            _ => Err(("a wrong number of fields".into(), "give every column".into())),
        }
    }
}

/// A degree l or an order o.
fn degree(name: &str, index: i64) -> Result<usize, Fault> {
    let found = usize::try_from(index).ok().filter(|_| index <= LARGEST);
    let remedy = || format!("keep to 0 <= {name} <= {LARGEST}");
    found.ok_or_else(|| (format!("{name} = {index} is out of range"), remedy()))
}

/// A signed order of degree l.
fn order(name: &str, index: i64, l: usize) -> Result<isize, Fault> {
    if index.unsigned_abs() > l as u64 {
        let what = format!("{name} = {index} is out of range for l = {l}");
        return Err((what, format!("keep to -l <= {name} <= l")));
    }
    Ok(index as isize)
}

/// An index below another of the same parity.
fn frequency((above, o): (&str, usize), (name, index): (&str, i64)) -> Result<usize, Fault> {
    let found = usize::try_from(index).ok().filter(|&q| q <= o && (o - q) % 2 == 0);
    found.ok_or_else(|| {
        let what = format!("{name} = {index} does not go with {above} = {o}");
        (what, format!("keep to 0 <= {name} <= {above}, both even or both odd"))
    })
}

/// q of a mode that the light's degree reaches.
fn below(l: usize, q: usize) -> Result<usize, Fault> {
    if q > l {
        let what = format!("q = {q} is out of range for l = {l}");
        return Err((what, "keep to q <= l: beyond it there is no such mode".into()));
    }
    Ok(q)
}

fn within(name: &str, value: f64, low: f64, high: f64) -> Result<f64, Fault> {
    if (low - SLACK..=high + SLACK).contains(&value) {
        return Ok(value.clamp(low, high));
    }
    let what = format!("{name} = {value} is out of range");
    Err((what, format!("keep to {low:.4} <= {name} <= {high:.4}")))
}

//! Parameters of published fits to measured BRDFs, as CSV with one material in each row.
//!
//! | model | columns |
//! |---|---|
//! | [`Abc`] | `name,kd_r,kd_g,kd_b,a_r,a_g,a_b,b,c,ior` |
//! | [`Sgd`] | `name` and, each with `_r`, `_g` and `_b`, `rho_d`, `rho_s`, `alpha`, `p`, `f0`, `f1`, `kappa`, `lambda`, `c`, `k`, `theta0` |
//!
//! The columns may come in any order. Others are ignored.

use crate::material::brdf::{Abc, Brdf, Sgd, Surface};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::{Row, Sheet};

/// The materials of a sheet; `None` if its columns are those of neither model.
///
/// # Errors
///
/// If the sheet has no rows, a name is empty, a field is not a number, or a parameter is out of
/// range.
pub fn of_sheet(sheet: &Sheet) -> Result<Option<Vec<Surface>>> {
    let found = (sheet.column("name"), Abc::columns(sheet), Sgd::columns(sheet));
    let surfaces = match found {
        (Some(name), Some(columns), _) => surfaces::<Abc>(sheet, name, &columns),
        (Some(name), None, Some(columns)) => surfaces::<Sgd>(sheet, name, &columns),
        _ => return Ok(None),
    }?;
    if surfaces.is_empty() {
        return Err(sheet.fault("it contains no material", "add rows below the header"));
    }
    Ok(Some(surfaces))
}

/// A model whose parameters are columns.
trait Published: Brdf + Sized + 'static {
    /// Its parameters, and whether each channel has its own.
    const PARAMETERS: &'static [(&'static str, bool)];

    /// From the parameters of one channel.
    fn of(parameters: &[f64]) -> Result<Self>;

    /// The surface of three channels.
    fn surface(name: String, rgb: [Self; 3]) -> Surface {
        let [r, g, b] = rgb;
        Surface::colored(name, [Box::new(r), Box::new(g), Box::new(b)])
    }

    /// The columns of each channel's parameters, if the sheet has them all.
    fn columns(sheet: &Sheet) -> Option<[Vec<usize>; 3]> {
        let of_channel = |channel: &str| -> Option<Vec<usize>> {
            let column = |&(name, is_colored): &(&str, bool)| {
                let suffix = if is_colored { channel } else { "" };
                sheet.column(&format!("{name}{suffix}"))
            };
            Self::PARAMETERS.iter().map(column).collect()
        };
        Some([of_channel("_r")?, of_channel("_g")?, of_channel("_b")?])
    }
}

impl Published for Abc {
    const PARAMETERS: &'static [(&'static str, bool)] =
        &[("kd", true), ("a", true), ("b", false), ("c", false), ("ior", false)];

    fn of(parameters: &[f64]) -> Result<Self> {
        let [matte, a, b, c, index] = take(parameters);
        Self::new(matte, [a, b, c], index)
    }

    fn surface(name: String, rgb: [Self; 3]) -> Surface {
        let lobe = Self::lobe(&rgb);
        let surface = Surface::colored(name, rgb.map(|channel| Box::new(channel) as Box<dyn Brdf>));
        match lobe {
            Some((lobe, shares)) => surface.of_lobe(Box::new(lobe), shares),
            None => surface,
        }
    }
}

impl Published for Sgd {
    const PARAMETERS: &'static [(&'static str, bool)] = &[
        ("rho_d", true),
        ("rho_s", true),
        ("alpha", true),
        ("p", true),
        ("f0", true),
        ("f1", true),
        ("kappa", true),
        ("lambda", true),
        ("c", true),
        ("k", true),
        ("theta0", true),
    ];

    fn of(parameters: &[f64]) -> Result<Self> {
        let [matte, glossy, alpha, power, f0, f1, scale, lambda, c, k, theta] = take(parameters);
        let (fresnel, shadowing) = ([f0, f1], [lambda, c, k, theta]);
        Self { matte, glossy, alpha, power, fresnel, scale, shadowing }.checked()
    }
}

/// The parameters, whose number is that of the model's columns.
fn take<const N: usize>(parameters: &[f64]) -> [f64; N] {
    std::array::from_fn(|k| parameters[k])
}

fn surfaces<M: Published>(
    sheet: &Sheet,
    name: usize,
    columns: &[Vec<usize>; 3],
) -> Result<Vec<Surface>> {
    let surface = |row: Row<'_>| {
        let name = row.text(name);
        if name.is_empty() {
            return Err(row.fault("the name is empty", "give every row a name"));
        }
        let channel = |columns: &[usize]| -> Result<M> {
            let parameters: Vec<f64> =
                columns.iter().map(|&column| row.number(column)).collect::<Result<_>>()?;
            M::of(&parameters).map_err(|error| row.locate(error))
        };
        let [r, g, b] = columns;
        Ok(M::surface(name.to_owned(), [channel(r)?, channel(g)?, channel(b)?]))
    };
    sheet.rows().map(surface).collect()
}

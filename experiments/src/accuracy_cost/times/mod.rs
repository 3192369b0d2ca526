//! Times of a pixel and a new light on this machine, in the same run as the nine-term formula.

mod floats;
mod integers;

use super::images::Image;
use super::setting::{Format, Scaling, Setting, Way};
use super::shading::hemisphere;
use crate::median::median;
use eigenshade::{Q15, Q31, quantised};
use eigenshade_model::error::Result;
use eigenshade_shading::integer_shader;
use eigenshade_table::Table;
use floats::Floats;
use integers::Integers;
use std::time::Instant;

/// Pixels per run.
const PIXELS: usize = 4096;
/// The least duration of a timing in seconds; shorter operations are repeated.
const SHORTEST: f64 = 3e-5;

/// Median times in nanoseconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// A pixel.
    pub pixel: f64,
    /// A new light on a transferred material, up to the first pixel.
    pub light: f64,
}

/// An operation to be timed.
pub type Work<'a> = Box<dyn FnMut() + 'a>;

/// A setting ready to be timed.
pub struct Case {
    way: Way,
    scaling: Scaling,
    numbers: Numbers,
    /// Buffer for the lengths of a scene within a tolerance.
    lengths: Vec<u16>,
}

enum Numbers {
    Double(Floats<f64>),
    Single(Floats<f32>),
    Maps(Floats<f32>, Vec<quantised::Normal<Q15>>),
    Q31(Integers<Q31>),
    Q15(Integers<Q15>),
}

impl Case {
    /// Prepares the setting on one image.
    ///
    /// # Errors
    ///
    /// If the table cannot be represented in the setting's number format.
    pub fn new(setting: &Setting, table: &Table, image: &Image) -> Result<Self> {
        let numbers = match (setting.format, setting.way) {
            (Format::F64, _) => Numbers::Double(Floats::new(table, image)?),
            (Format::F32, _) => Numbers::Single(Floats::new(table, image)?),
            (Format::Q15, Way::Bilinear(_)) => {
                let normals = integer_shader::normals(&hemisphere(PIXELS))?;
                Numbers::Maps(Floats::new(table, image)?, normals)
            }
            (Format::Q31, _) => Numbers::Q31(Integers::new(table, image)?),
            (Format::Q15, _) => Numbers::Q15(Integers::new(table, image)?),
        };
        let lengths = vec![0; table.gram.degree + 1];
        Ok(Self { way: setting.way, scaling: setting.scaling, numbers, lengths })
    }

    /// All pixels, and a new light.
    fn works(&mut self) -> Result<[Work<'_>; 2]> {
        let lengths = &mut self.lengths;
        match &self.numbers {
            Numbers::Double(floats) => {
                Ok([floats.pixels(self.way, lengths)?, floats.relit(self.way)?])
            }
            Numbers::Single(floats) => {
                let pixels = match (self.way, self.scaling) {
                    (Way::NineTerms, _) => floats.nine_terms()?,
                    (way, Scaling::None) => floats.pixels(way, lengths)?,
                    (_, scaling) => floats.scaled(scaling)?,
                };
                Ok([pixels, floats.relit(self.way)?])
            }
            Numbers::Maps(floats, normals) => floats.maps(self.way, normals),
            Numbers::Q31(integers) => integers.works(),
            Numbers::Q15(integers) => integers.works(),
        }
    }
}

/// Medians over interleaved rounds for each case.
///
/// # Errors
///
/// Never in practice.
pub fn costs(cases: &mut [Case], rounds: usize) -> Result<Vec<Cost>> {
    let mut works = Vec::new();
    for case in cases.iter_mut() {
        works.extend(case.works()?);
    }
    let times = interleaved(works, rounds);
    let medians: Vec<f64> = times.iter().map(|times| median(times)).collect();
    let cost = |pair: &[f64]| Cost { pixel: pair[0] / PIXELS as f64, light: pair[1] };
    Ok(medians.chunks_exact(2).map(cost).collect())
}

/// Nanoseconds of each work in each round. The works run one after the other, so that a temporary
/// slowdown of the machine affects all of them. Each first runs untimed, because the others have
/// replaced the contents of the cache.
#[must_use]
pub fn interleaved(works: Vec<Work<'_>>, rounds: usize) -> Vec<Vec<f64>> {
    let timed = |work: &mut Work<'_>, repeats: u32| {
        let start = Instant::now();
        (0..repeats).for_each(|_| work());
        start.elapsed().as_secs_f64() / f64::from(repeats)
    };
    let mut works: Vec<_> = works
        .into_iter()
        .map(|mut work| {
            work();
            let once = timed(&mut work, 1).max(1e-9);
            let repeats = (SHORTEST / once).ceil().clamp(1.0, 1e4) as u32;
            (work, repeats, Vec::new())
        })
        .collect();
    for _ in 0..rounds {
        for (work, repeats, times) in &mut works {
            work();
            times.push(1e9 * timed(work, *repeats));
        }
    }
    works.into_iter().map(|(_, _, times)| times).collect()
}

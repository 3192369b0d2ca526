//! The normals at which sources are fitted, what truncated pictures lack there, and what a source
//! would add.

use crate::highlights;
use crate::shader::fault;
use crate::sources::response::{Glossy, Response};
use crate::sources::view::View;
use eigenshade::{Highlights, Normals, Rgb};
use eigenshade_model::error::Result;
use eigenshade_model::source::Source;
use eigenshade_model::task::Steps;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, Par};

/// The normals of a part: those with the largest errors, and evenly chosen ones of the rest.
const WORST: usize = 250;
const OTHERS: usize = 600;
/// The least weight of a normal, of the mean of all. Normals that mirror a lamp stand for little of
/// the picture, but are where it is worst.
const LEAST: f64 = 0.1;
/// How often the pictures of the material of median roughness count. A few sources improve pictures
/// of a smoother material least, and pictures of a rougher one need sources least. Of 3, 6 and 8,
/// this number has the least error at a roughness of 0.3.
const MIDDLE: f32 = 8.0;
/// An error of a picture below this, of the peak, is rounding.
const ROUNDING: f32 = 1e-6;

/// The pictures to fit: a part for each view, material and size, with their rows one after another.
pub struct Sample<'a> {
    views: &'a [View],
    materials: &'a [Glossy],
    parts: Vec<Part>,
    /// Reference less truncated picture, relative to the peak, by channel.
    pub lack: [Vec<f32>; 3],
    /// The weight of each row in the sum of squares.
    pub weights: Vec<f32>,
}

struct Part {
    view: usize,
    material: usize,
    normals: [Vec<f32>; 3],
    /// The irradiance at each normal under each harmonic.
    response: Mat<f32>,
    peak: f32,
}

impl<'a> Sample<'a> {
    /// Samples pictures at the normals of [`View::sphere`], at all sizes of the materials, with a
    /// step for each view of each material.
    #[must_use]
    pub fn new(views: &'a [View], materials: &'a [Glossy], spacing: f64, steps: &Steps) -> Self {
        let mut sample = Self {
            views,
            materials,
            parts: Vec::new(),
            lack: [const { Vec::new() }; 3],
            weights: Vec::new(),
        };
        let mut by_roughness: Vec<usize> = (0..materials.len()).collect();
        let roughness = |m: usize| materials[m].gloss.roughness;
        by_roughness.sort_by(|&a, &b| roughness(a).total_cmp(&roughness(b)));
        let middle = by_roughness.get(materials.len() / 2).copied().unwrap_or(0);
        for (v, view) in views.iter().enumerate() {
            let sphere = view.sphere(spacing);
            for (m, material) in materials.iter().enumerate() {
                let pictures = steps.take(|| view.pictures(material, &sphere.normals));
                for (size, truncated) in pictures.truncated.iter().enumerate() {
                    let lack = |c: usize, k: usize| pictures.reference[c][k] - truncated[c][k];
                    let lack = |c: usize, k: usize| (lack(c, k) / pictures.peak) as f32;
                    let most = |k: usize| (0..3).map(|c| lack(c, k).abs()).fold(0.0, f32::max);
                    let chosen = chosen(sphere.normals.len(), most);
                    let squares = chosen.iter().flat_map(|&k| (0..3).map(move |c| lack(c, k)));
                    let count = (3 * chosen.len()) as f32;
                    let rms = (squares.map(|lack| lack * lack).sum::<f32>() / count).sqrt();
                    for (c, to) in sample.lack.iter_mut().enumerate() {
                        to.extend(chosen.iter().map(|&k| lack(c, k)));
                    }
                    // Large errors of a pixel count more. A picture counts in relation to its error
                    // without sources: else the smoothest material and the lower degree decide.
                    let rms = rms.max(ROUNDING);
                    let times = if m == middle { MIDDLE / rms } else { 1.0 / rms };
                    let share = |k: usize| {
                        let of_mean = sphere.weights[k] * sphere.normals.len() as f64;
                        times * (of_mean + LEAST) as f32
                    };
                    let weights = chosen.iter().map(|&k| share(k) * (rms + most(k)) / rms);
                    sample.weights.extend(weights);
                    let normals: Vec<_> = chosen.iter().map(|&k| sphere.normals[k]).collect();
                    let rows = material.responses[size].at_all(&normals);
                    let columns = rows.first().map_or(0, Vec::len);
                    let axis = |a: usize| normals.iter().map(|normal| normal[a] as f32).collect();
                    sample.parts.push(Part {
                        view: v,
                        material: m,
                        normals: [0, 1, 2].map(axis),
                        response: Mat::from_fn(rows.len(), columns, |i, j| rows[i][j] as f32),
                        peak: pictures.peak as f32,
                    });
                }
            }
        }
        sample
    }

    /// What each source adds with energy 1 at each row, of the peaks: its highlight less the
    /// response to its harmonics.
    ///
    /// # Errors
    ///
    /// If the runtime refuses a source or a material.
    pub fn additions(&self, sources: &[Source]) -> Result<Vec<Vec<f32>>> {
        let degree = self.materials.iter().flat_map(|material| &material.responses);
        let degree = degree.map(Response::degree).max().unwrap_or(0);
        let mut additions = vec![Vec::with_capacity(self.weights.len()); sources.len()];
        for (v, view) in self.views.iter().enumerate() {
            let turned = sources.iter().map(|source| {
                let source = Source { energy: [1.0; 3], ..view.turned(source) };
                let harmonics = highlights::harmonics(&source, degree)?;
                Ok((highlights::source(&source)?, harmonics))
            });
            let turned = turned.collect::<Result<Vec<(eigenshade::Source, _)>>>()?;
            for part in self.parts.iter().filter(|part| part.view == v) {
                let gloss = highlights::gloss(&self.materials[part.material].gloss)?;
                let [x, y, z] = &part.normals;
                let normals = Normals::new(x, y, z).map_err(fault)?;
                let columns = part.response.ncols();
                let harmonics = Mat::from_fn(columns, sources.len(), |k, j| turned[j].1[k]);
                let mut low = Mat::<f32>::zeros(x.len(), sources.len());
                matmul(&mut low, Accum::Replace, &part.response, &harmonics, 1.0, Par::Seq);
                for (j, ((source, _), addition)) in turned.iter().zip(&mut additions).enumerate() {
                    let mut colors = vec![Rgb::gray(0.0); x.len()];
                    let highlight = Highlights::<1>::new(&gloss, &[*source]);
                    highlight.and_then(|h| h.add_slice(normals, &mut colors)).map_err(fault)?;
                    let rows = colors.iter().zip(low.col(j).iter());
                    addition.extend(rows.map(|(color, low)| (color.r - low) / part.peak));
                }
            }
        }
        Ok(additions)
    }
}

/// The numbers of the worst of `count` normals, and of evenly chosen ones of the rest.
fn chosen(count: usize, error: impl Fn(usize) -> f32) -> Vec<usize> {
    let mut all: Vec<usize> = (0..count).collect();
    all.sort_by(|&a, &b| error(b).total_cmp(&error(a)));
    let rest = all.split_off(WORST.min(count));
    let step = (rest.len() / OTHERS).max(1);
    all.extend(rest.into_iter().step_by(step));
    all
}

//! Chooses sources by matching pursuit in pictures.
//!
//! The lack of a picture is its direct integral less the truncated sum, at normals of spheres of
//! glossy materials under several rotations of the light. A source adds its highlight less the
//! response to its harmonics. One source after the other is taken that reduces the weighted sum of
//! squares most, first from a grid of directions and widths, then moved and widened as long as that
//! helps. Sources that are taken stay as they are, so the first n of a list are the set of n.
//!
//! Then each source is moved again, to fit what all lists that contain it lack.
//!
//! The list ends where more sources no longer help at normals and under a rotation that it was not
//! fitted to.

use crate::sources::response::Glossy;
use crate::sources::sample::Sample;
use crate::sources::view::View;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::error::Result;
use eigenshade_model::parallel;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source;
use eigenshade_model::task::Steps;
use eigenshade_model::vector::{cross, plus, times, unit};
use std::f64::consts::{PI, TAU};

/// The degrees and orders at which sources are fitted.
pub const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// The roughness of the metals that sources are fitted to.
pub const FITTED: [f64; 3] = [0.2, 0.3, 0.5];

/// Rotations of the light: none, and views of other sides. The last is not fitted to.
const ROTATIONS: [[f64; 3]; 4] = [[0.0; 3], [0.4, 1.1, 2.0], [-1.0, 2.2, 0.7], [2.5, 1.7, -1.4]];

/// Spacing of the normals in radians.
const SPACING: f64 = 0.06;
/// Spacing of the normals to which a list is not fitted.
const OTHER_SPACING: f64 = 0.083;
/// The squares of a list there may be this times the least squares of a shorter list.
const WORSE: f64 = 1.1;
/// A light has sources if they leave at most this share of the squares there.
const USEFUL: f64 = 0.9;

/// Directions of the grid.
const DIRECTIONS: usize = 2000;
/// The best sources of the grid that are tried after the first one, and sources tried at once.
const KEPT: usize = 2000;
const BATCH: usize = 50;
/// Standard deviations of the grid, radians.
const WIDTHS: [f64; 5] = [0.01, 0.025, 0.05, 0.1, 0.16];
/// Limits of standard deviations, radians. A narrower source is as a point for a roughness of 0.2;
/// a wider one is in the harmonics of degree 9.
const SPREADS: [f64; 2] = [0.004, 0.2];

/// A step of 1 moves a source by this many radians, and widens it by this factor.
const MOVE: f64 = 0.04;
const WIDEN: f64 = 2.0;
/// The last step.
const LAST: f64 = 0.02;
/// A move is taken if it raises the score by this share.
const GAIN: f64 = 1e-5;
/// Times that every source is moved again, and the first step of that.
const ROUNDS: usize = 2;
const AGAIN: f64 = 0.25;

/// A source, what it adds with energy 1, and how much its energies reduce the sum of squares.
#[derive(Clone)]
struct Trial {
    source: Source,
    addition: Vec<f32>,
    score: f64,
}

/// What pictures lack, by channel.
type Lack = [Vec<f32>; 3];

/// Chooses up to `most` sources for a map, in the order of their worth, for metals of these
/// roughnesses.
///
/// Time: about 20 s on two cores for a map of 512 x 256 and 16 sources.
///
/// # Errors
///
/// As [`View::new`] and [`Glossy::new`].
pub fn find(map: &EnvironmentMap, materials: &[Glossy], most: usize) -> Result<Vec<Source>> {
    // Steps of about a second: pictures, the grid, and each source.
    let steps = Steps::new(ROTATIONS.len() * materials.len() + 1 + (1 + ROUNDS) * most);
    let _within = steps.enter();
    let degree = SIZES.iter().map(|size| size.0).max().unwrap_or(0);
    let rotation = |[beta, alpha, gamma]: [f64; 3]| Rotation { alpha, beta, gamma };
    let view = |k: usize| View::new(map, (k > 0).then(|| rotation(ROTATIONS[k])), degree);
    let mut views = (0..ROTATIONS.len()).map(view).collect::<Result<Vec<_>>>()?;
    let other = views.split_off(ROTATIONS.len() - 1);
    let sample = Sample::new(&views, materials, SPACING, &steps);
    let mut chosen = pursue(&sample, most, &steps)?;
    for _ in 0..ROUNDS {
        move_again(&sample, &mut chosen, &steps)?;
    }
    let mut sources: Vec<Source> = chosen.iter().map(|trial| trial.source).collect();
    let held_out = Sample::new(&other, materials, OTHER_SPACING, &steps);
    let left = lacks(&held_out, &trials(&held_out, &sources, None)?);
    let left: Vec<f64> = left.iter().map(|lack| squares(&held_out, lack)).collect();
    let least = left.iter().copied().fold(f64::INFINITY, f64::min);
    let helps = left.first().is_some_and(|&without| least <= USEFUL * without);
    let last = left.iter().rposition(|&left| left <= WORSE * least);
    sources.truncate(last.filter(|_| helps).unwrap_or(0));
    Ok(sources)
}

/// The materials that sources are fitted to.
///
/// # Errors
///
/// As [`Glossy::new`].
pub fn metals(roughness: &[f64]) -> Result<Vec<Glossy>> {
    roughness.iter().map(|&roughness| Glossy::new([roughness, 1.0, 0.0], &SIZES)).collect()
}

/// Takes one source after the other, up to a number.
fn pursue(sample: &Sample<'_>, most: usize, steps: &Steps) -> Result<Vec<Trial>> {
    let (mut chosen, mut lack) = (Vec::new(), sample.lack.clone());
    if lack.iter().flatten().all(|&lack| lack == 0.0) {
        return Ok(chosen);
    }
    let grid = steps.take(|| grid(sample))?;
    while chosen.len() < most {
        let scores = parallel::map(grid.len(), &(), |k| score(sample, &grid[k].addition, &lack));
        let best = (0..grid.len()).max_by(|&a, &b| scores[a].total_cmp(&scores[b]));
        let Some(best) = best.filter(|&best| scores[best] > 0.0) else { break };
        let trial = steps.take(|| tuned(sample, &grid[best].source, &lack, 1.0))?;
        subtract(&mut lack, &trial.addition, trial.source.energy);
        chosen.push(trial);
    }
    Ok(chosen)
}

/// Moves each source to fit the lists that contain it at once. A list of n counts by 1 / n of the
/// inverse of its remaining squares.
fn move_again(sample: &Sample<'_>, chosen: &mut [Trial], steps: &Steps) -> Result<()> {
    for k in 0..chosen.len() {
        let mut mean: Lack = [0, 1, 2].map(|_| vec![0.0; sample.weights.len()]);
        let mut total = 0.0;
        for (n, lack) in lacks(sample, chosen).iter().enumerate().skip(k + 1) {
            let weight = (n as f64 * squares(sample, lack)).recip();
            total += weight;
            lack.iter().zip(&mut mean).for_each(|(lack, mean)| add(mean, lack, weight as f32));
        }
        let inverse = (total as f32).recip();
        mean.iter_mut().flatten().for_each(|mean| *mean *= inverse);
        // As if the source were not there.
        subtract(&mut mean, &chosen[k].addition, chosen[k].source.energy.map(|energy| -energy));
        chosen[k] = steps.take(|| tuned(sample, &chosen[k].source, &mean, AGAIN))?;
    }
    Ok(())
}

/// The lack without sources, and after each one.
fn lacks(sample: &Sample<'_>, chosen: &[Trial]) -> Vec<Lack> {
    let mut all = vec![sample.lack.clone()];
    for (k, trial) in chosen.iter().enumerate() {
        let mut lack = all[k].clone();
        subtract(&mut lack, &trial.addition, trial.source.energy);
        all.push(lack);
    }
    all
}

fn squares(sample: &Sample<'_>, lack: &Lack) -> f64 {
    lack.iter().map(|channel| inner(&sample.weights, channel, channel)).sum()
}

fn subtract(lack: &mut Lack, addition: &[f32], energy: [f64; 3]) {
    lack.iter_mut().zip(energy).for_each(|(lack, energy)| add(lack, addition, -energy as f32));
}

fn add(to: &mut [f32], from: &[f32], factor: f32) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to += factor * from);
}

/// Σ w a b, in f32 but for sums of many numbers.
fn inner(weights: &[f32], a: &[f32], b: &[f32]) -> f64 {
    const LANES: usize = 16;
    const CHUNK: usize = 64 * LANES;
    let chunks = weights.chunks(CHUNK).zip(a.chunks(CHUNK)).zip(b.chunks(CHUNK));
    let sum = |((w, a), b): ((&[f32], &[f32]), &[f32])| {
        let mut sums = [0.0; LANES];
        for ((w, a), b) in w.chunks(LANES).zip(a.chunks(LANES)).zip(b.chunks(LANES)) {
            let products = w.iter().zip(a).zip(b);
            sums.iter_mut().zip(products).for_each(|(sum, ((w, a), b))| *sum += w * a * b);
        }
        f64::from(sums.iter().sum::<f32>())
    };
    chunks.map(sum).sum()
}

/// The energies with which a source reduces the weighted sum of squares most, none negative.
fn energies(sample: &Sample<'_>, addition: &[f32], lack: &Lack) -> [f64; 3] {
    let square = inner(&sample.weights, addition, addition);
    let of = |c: usize| inner(&sample.weights, addition, &lack[c]).max(0.0);
    [0, 1, 2].map(|c| if square > 0.0 { of(c) / square } else { 0.0 })
}

/// How much these energies reduce it.
fn score(sample: &Sample<'_>, addition: &[f32], lack: &Lack) -> f64 {
    let square = inner(&sample.weights, addition, addition);
    energies(sample, addition, lack).iter().map(|energy| energy * energy * square).sum()
}

/// The most promising of sources all around, in a spiral.
fn grid(sample: &Sample<'_>) -> Result<Vec<Trial>> {
    let golden = PI * (3.0 - 5f64.sqrt());
    let sources = (0..DIRECTIONS).flat_map(|k| {
        let z = 1.0 - (2.0 * k as f64 + 1.0) / DIRECTIONS as f64;
        let (sine, cosine) = (golden * k as f64 % TAU).sin_cos();
        let across = (1.0 - z * z).sqrt();
        let direction = [across * cosine, across * sine, z];
        WIDTHS.map(|spread| Source { direction, energy: [1.0; 3], spread })
    });
    let sources: Vec<Source> = sources.collect();
    let mut trials = in_batches(sample, &sources, BATCH, &sample.lack)?;
    trials.sort_by(|a, b| b.score.total_cmp(&a.score));
    trials.truncate(KEPT);
    Ok(trials)
}

/// What these sources add, with the energies that fit a lack best, or with their own.
fn trials(sample: &Sample<'_>, sources: &[Source], lack: Option<&Lack>) -> Result<Vec<Trial>> {
    let trial = |(&source, addition): (&Source, Vec<f32>)| {
        let Some(lack) = lack else { return Trial { source, addition, score: 0.0 } };
        let source = Source { energy: energies(sample, &addition, lack), ..source };
        Trial { source, score: score(sample, &addition, lack), addition }
    };
    Ok(sources.iter().zip(sample.additions(sources)?).map(trial).collect())
}

/// What these sources add, with the energies that fit a lack best; some of them at once.
fn in_batches(
    sample: &Sample<'_>,
    sources: &[Source],
    size: usize,
    lack: &Lack,
) -> Result<Vec<Trial>> {
    let batches: Vec<&[Source]> = sources.chunks(size).collect();
    let found = parallel::map(batches.len(), &(), |k| trials(sample, batches[k], Some(lack)));
    Ok(found.into_iter().collect::<Result<Vec<_>>>()?.into_iter().flatten().collect())
}

/// The source after all moves that raise its score.
fn tuned(sample: &Sample<'_>, source: &Source, lack: &Lack, mut step: f64) -> Result<Trial> {
    let mut best = trials(sample, &[*source], Some(lack))?.remove(0);
    while step > LAST {
        let moved = moved(&best.source, step);
        let tried = in_batches(sample, &moved, moved.len() / 2, lack)?.into_iter();
        let top = tried.max_by(|a, b| a.score.total_cmp(&b.score));
        match top.filter(|top| top.score > best.score * (1.0 + GAIN)) {
            Some(top) => best = top,
            None => step *= 0.5,
        }
    }
    Ok(best)
}

/// The sources one step away: on four sides, narrower and wider.
fn moved(source: &Source, step: f64) -> [Source; 6] {
    let [x, y, z] = source.direction;
    let along = unit(if x * x + y * y > z * z { [-y, x, 0.0] } else { [0.0, -z, y] });
    let across = cross(source.direction, along);
    let (far, wider) = (MOVE * step, WIDEN.powf(step));
    let beside =
        |axis, far| Source { direction: unit(plus(source.direction, times(far, axis))), ..*source };
    let widened = |factor: f64| Source {
        spread: (source.spread * factor).clamp(SPREADS[0], SPREADS[1]),
        ..*source
    };
    [
        beside(along, far),
        beside(across, far),
        widened(wider),
        beside(along, -far),
        beside(across, -far),
        widened(wider.recip()),
    ]
}

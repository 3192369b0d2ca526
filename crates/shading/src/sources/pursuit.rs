//! Chooses sources by matching pursuit in pictures.
//!
//! The lack of a picture is its direct integral less the truncated sum, at normals of spheres of
//! glossy materials under several rotations of the light. A source adds its highlight less the
//! response to its harmonics. One source after the other is taken that reduces the weighted sum of
//! squares most, first from a grid of directions and widths, then moved, stretched and turned as
//! long as that helps. After each, the energies of all are the non-negative least squares solution,
//! and every source is moved again with the others kept.
//!
//! A larger set is kept only if it leaves less at normals and under a rotation that it was not
//! fitted to.

use crate::sources::response::Glossy;
use crate::sources::sample::Sample;
use crate::sources::view::View;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_model::error::Result;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::source::Source;
use eigenshade_model::vector::{cross, dot, plus, times, unit};
use eigenshade_table::highlights::SETS;
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use rayon::slice::ParallelSlice;
use std::f64::consts::{PI, TAU};

/// The degrees and orders at which sources are fitted.
pub const SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// Sets up to this size are fitted at all of [`SIZES`], larger ones at the last alone: degree 9
/// lacks so much of some lights that eight sources which mend it do little for degree 12.
const SMALL: usize = 4;

/// The roughness of the metals that sources are fitted to.
pub const FITTED: [f64; 3] = [0.2, 0.3, 0.5];

/// Rotations of the light: none, and views of other sides. The last is not fitted to.
const ROTATIONS: [[f64; 3]; 4] = [[0.0; 3], [0.4, 1.1, 2.0], [-1.0, 2.2, 0.7], [2.5, 1.7, -1.4]];

/// Spacing of the normals in radians.
const SPACING: f64 = 0.06;
/// That of the normals to which a set is not fitted.
const OTHER_SPACING: f64 = 0.083;

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

/// Iterations of the least squares solution.
const ITERATIONS: usize = 1000;

/// A source of energy 1 and what it adds.
#[derive(Clone)]
struct Trial {
    source: Source,
    addition: Vec<f32>,
    score: f64,
}

/// Chooses the sets of [`SETS`] up to `most` sources for a map, for metals of these roughnesses.
///
/// Time: about 10 s on two cores for a map of 512 x 256 and 8 sources.
///
/// # Errors
///
/// Those of [`View::new`] and [`Glossy::new`].
pub fn find(
    map: &EnvironmentMap,
    materials: &[Glossy],
    most: usize,
) -> Result<Vec<(usize, Vec<Source>)>> {
    let degree = SIZES.iter().map(|size| size.0).max().unwrap_or(0);
    let rotation = |[beta, alpha, gamma]: [f64; 3]| Rotation { alpha, beta, gamma };
    let view = |k: usize| View::new(map, (k > 0).then(|| rotation(ROTATIONS[k])), degree);
    let mut views = (0..ROTATIONS.len()).map(view).collect::<Result<Vec<_>>>()?;
    let other = views.split_off(ROTATIONS.len() - 1);
    let mut sets: Vec<(usize, Vec<Source>)> = Vec::new();
    let mut chosen = Vec::new();
    for (first, until) in [(0, most.min(SMALL)), (SIZES.len() - 1, most)] {
        let sample = Sample::new(&views, materials, SPACING, first);
        let held_out = Sample::new(&other, materials, OTHER_SPACING, first);
        let mut best = sets.last().map_or(Vec::new(), |(_, set)| set.clone());
        let mut least = left(&held_out, &best)?;
        for (count, sources) in pursue(&sample, &chosen, until)? {
            if SETS.contains(&count) || count == most {
                let left = left(&held_out, &sources)?;
                if left < least {
                    let is_lit = |source: &&Source| source.energy != [0.0; 3];
                    (best, least) = (sources.iter().filter(is_lit).copied().collect(), left);
                }
                sets.push((count, best.clone()));
            }
            chosen = sources;
        }
    }
    Ok(sets)
}

/// The materials that sources are fitted to.
///
/// # Errors
///
/// Those of [`Glossy::new`].
pub fn metals(roughness: &[f64]) -> Result<Vec<Glossy>> {
    roughness.iter().map(|&roughness| Glossy::new([roughness, 1.0, 0.0], &SIZES)).collect()
}

/// The weighted sum of squares that sources leave.
fn left(sample: &Sample<'_>, sources: &[Source]) -> Result<f64> {
    let mut lack = sample.lack.clone();
    for (source, addition) in sources.iter().zip(sample.additions(sources)?) {
        subtract(&mut lack, &addition, source.energy);
    }
    let of = |channel: &Vec<f32>| inner(&sample.weights, channel, channel);
    Ok(lack.iter().map(of).sum())
}

/// Adds one source after the other to some, up to a number: the sources after each step. A source
/// whose energy is zero stays, and may get some later.
fn pursue(sample: &Sample<'_>, start: &[Source], most: usize) -> Result<Vec<(usize, Vec<Source>)>> {
    let mut sets = Vec::new();
    if start.len() >= most || sample.lack.iter().flatten().all(|&lack| lack == 0.0) {
        return Ok(sets);
    }
    let grid = grid(sample)?;
    let mut chosen = trials(sample, start, &sample.lack)?;
    let energies = solved(sample, &chosen);
    let mut lack = rest(sample, chosen.iter().enumerate(), &energies);
    while chosen.len() < most {
        let scores = grid.par_iter().map(|trial| score(sample, &trial.addition, &lack));
        let scores: Vec<f64> = scores.collect();
        let best = (0..grid.len()).max_by(|&a, &b| scores[a].total_cmp(&scores[b]));
        let Some(best) = best.filter(|&best| scores[best] > 0.0) else { break };
        chosen.push(tuned(sample, &grid[best].source, &lack, 1.0)?);
        let mut energies = solved(sample, &chosen);
        for _ in 0..if chosen.len() > 1 { ROUNDS } else { 0 } {
            for k in 0..chosen.len() {
                let others = |&(j, _): &(usize, &Trial)| j != k;
                let lack = rest(sample, chosen.iter().enumerate().filter(others), &energies);
                chosen[k] = tuned(sample, &chosen[k].source, &lack, AGAIN)?;
                energies = solved(sample, &chosen);
            }
        }
        lack = rest(sample, chosen.iter().enumerate(), &energies);
        let lit = chosen.iter().zip(&energies);
        let lit = lit.map(|(trial, &energy)| Source { energy, ..trial.source });
        sets.push((chosen.len(), lit.collect()));
    }
    Ok(sets)
}

/// The lack of the pictures with these sources.
fn rest<'a>(
    sample: &Sample<'_>,
    sources: impl Iterator<Item = (usize, &'a Trial)>,
    energies: &[[f64; 3]],
) -> [Vec<f32>; 3] {
    let mut lack = sample.lack.clone();
    sources.for_each(|(k, trial)| subtract(&mut lack, &trial.addition, energies[k]));
    lack
}

fn subtract(lack: &mut [Vec<f32>; 3], addition: &[f32], energy: [f64; 3]) {
    for (channel, energy) in lack.iter_mut().zip(energy) {
        let energy = energy as f32;
        channel.iter_mut().zip(addition).for_each(|(lack, add)| *lack -= energy * add);
    }
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

/// How much the best energies of a source reduce the weighted sum of squares.
fn score(sample: &Sample<'_>, addition: &[f32], lack: &[Vec<f32>; 3]) -> f64 {
    let square = inner(&sample.weights, addition, addition);
    let of = |channel: &Vec<f32>| inner(&sample.weights, addition, channel).max(0.0).powi(2);
    if square > 0.0 { lack.iter().map(of).sum::<f64>() / square } else { 0.0 }
}

/// The most promising of round sources all around, in a spiral.
fn grid(sample: &Sample<'_>) -> Result<Vec<Trial>> {
    let golden = PI * (3.0 - 5f64.sqrt());
    let sources = (0..DIRECTIONS).flat_map(|k| {
        let z = 1.0 - (2.0 * k as f64 + 1.0) / DIRECTIONS as f64;
        let (sine, cosine) = (golden * k as f64 % TAU).sin_cos();
        let across = (1.0 - z * z).sqrt();
        let direction = [across * cosine, across * sine, z];
        WIDTHS.map(|width| {
            let major = times(width, [-sine, cosine, 0.0]);
            Source { direction, energy: [1.0; 3], major, minor: width }
        })
    });
    let sources: Vec<Source> = sources.collect();
    let trials = sources.par_chunks(BATCH).map(|batch| trials(sample, batch, &sample.lack));
    let mut trials = trials.collect::<Result<Vec<_>>>()?.concat();
    trials.sort_by(|a, b| b.score.total_cmp(&a.score));
    trials.truncate(KEPT);
    Ok(trials)
}

fn trials(sample: &Sample<'_>, sources: &[Source], lack: &[Vec<f32>; 3]) -> Result<Vec<Trial>> {
    let additions = sample.additions(sources)?.into_iter();
    let trial = |(&source, addition): (&Source, Vec<f32>)| Trial {
        source,
        score: score(sample, &addition, lack),
        addition,
    };
    Ok(sources.iter().zip(additions).map(trial).collect())
}

/// The source after all moves that raise its score.
fn tuned(
    sample: &Sample<'_>,
    source: &Source,
    lack: &[Vec<f32>; 3],
    mut step: f64,
) -> Result<Trial> {
    let mut best = trials(sample, &[*source], lack)?.remove(0);
    while step > LAST {
        let moved = moved(&best.source, step);
        let tried = moved.par_chunks(moved.len().div_ceil(2));
        let tried = tried.map(|moved| trials(sample, moved, lack)).collect::<Result<Vec<_>>>()?;
        let top = tried.into_iter().flatten().max_by(|a, b| a.score.total_cmp(&b.score));
        match top.filter(|top| top.score > best.score * (1.0 + GAIN)) {
            Some(top) => best = top,
            None => step *= 0.5,
        }
    }
    Ok(best)
}

/// The sources one step away.
fn moved(source: &Source, step: f64) -> Vec<Source> {
    let long = dot(source.major, source.major).sqrt();
    let minor = source.minor;
    let along = times(1.0 / long, source.major);
    let across = cross(source.direction, along);
    let (far, wider) = (MOVE * step, WIDEN.powf(step));
    let place = |direction: [f64; 3], axis: [f64; 3], [long, minor]: [f64; 2]| {
        let direction = unit(direction);
        let axis = unit(plus(axis, times(-dot(axis, direction), direction)));
        let [long, minor] = [long, minor].map(|spread| spread.clamp(SPREADS[0], SPREADS[1]));
        let (axis, long, minor) =
            if minor > long { (cross(direction, axis), minor, long) } else { (axis, long, minor) };
        Source { direction, energy: [1.0; 3], major: times(long, axis), minor }
    };
    let from = source.direction;
    let mut all = Vec::new();
    for sign in [-1.0, 1.0] {
        let factor = if sign > 0.0 { wider } else { 1.0 / wider };
        all.extend([
            place(plus(from, times(sign * far, along)), along, [long, minor]),
            place(plus(from, times(sign * far, across)), along, [long, minor]),
            place(from, along, [long * factor, minor]),
            place(from, along, [long, minor * factor]),
            place(from, along, [long * factor, minor * factor]),
            place(from, plus(along, times(sign * step, across)), [long, minor]),
            // A round source stretches along a diagonal.
            place(from, plus(along, times(sign, across)), [long * wider, minor]),
        ]);
    }
    all
}

/// The energies of least squares, none negative, by coordinate descent.
fn solved(sample: &Sample<'_>, sources: &[Trial]) -> Vec<[f64; 3]> {
    let product = |a: &Trial, b: &[f32]| inner(&sample.weights, &a.addition, b);
    let gram: Vec<Vec<f64>> =
        sources.iter().map(|a| sources.iter().map(|b| product(a, &b.addition)).collect()).collect();
    let mut energies = vec![[0.0; 3]; sources.len()];
    for (c, lack) in sample.lack.iter().enumerate() {
        let right: Vec<f64> = sources.iter().map(|source| product(source, lack)).collect();
        for _ in 0..ITERATIONS {
            for (i, row) in gram.iter().enumerate() {
                let all: f64 = row.iter().zip(&energies).map(|(g, energy)| g * energy[c]).sum();
                let alone = right[i] - all + row[i] * energies[i][c];
                energies[i][c] = if row[i] > 0.0 { (alone / row[i]).max(0.0) } else { 0.0 };
            }
        }
    }
    energies
}

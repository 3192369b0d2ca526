//! Codes for the rows of eigenimages: similar pixels share a code, and codes of a cluster are its mean
//! and a few images of its own, in whole numbers.

use eigenshade_model::parallel;
use faer::{Mat, MatRef, Side};

/// Rounds of k-means.
const ROUNDS: usize = 10;

/// Codes in clusters.
pub struct Codebook {
    /// The code of each pixel. Codes are in the order of their clusters.
    pub of_pixel: Vec<u32>,
    /// The clusters, none of which is empty.
    pub clusters: Vec<Cluster>,
}

/// Codes with a mean and images of their own.
pub struct Cluster {
    /// The mean of its codes, r numbers.
    pub mean: Vec<f32>,
    /// K images of r numbers, each times the unit of its weights.
    pub images: Vec<Vec<f32>>,
    /// The weights of each code, K each.
    pub weights: Vec<Vec<i8>>,
}

/// A codebook for the rows of a matrix: at most `codes` codes in at most `clusters` clusters with
/// `images` images.
#[must_use]
pub fn codebook(rows: MatRef<'_, f32>, codes: usize, clusters: usize, images: usize) -> Codebook {
    let count = rows.nrows();
    let (of_pixel, centers) =
        if codes >= count { ((0..count).collect(), rows.to_owned()) } else { kmeans(rows, codes) };
    let (cluster_of, _) = kmeans(centers.as_ref(), clusters);
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); clusters];
    cluster_of.iter().enumerate().for_each(|(code, &cluster)| members[cluster].push(code));
    members.retain(|members| !members.is_empty());
    // The codes in the order of their clusters.
    let mut place = vec![0_u32; centers.nrows()];
    members.iter().flatten().zip(0..).for_each(|(&code, to)| place[code] = to);
    let found = parallel::map(members.len(), &(), |k| of_members(&centers, &members[k], images));
    Codebook { of_pixel: of_pixel.into_iter().map(|code| place[code]).collect(), clusters: found }
}

fn of_members(centers: &Mat<f32>, members: &[usize], images: usize) -> Cluster {
    let rank = centers.ncols();
    let count = members.len() as f32;
    let mean: Vec<f32> = (0..rank)
        .map(|k| members.iter().map(|&one| centers[(one, k)]).sum::<f32>() / count)
        .collect();
    let away = Mat::from_fn(members.len(), rank, |one, k| centers[(members[one], k)] - mean[k]);
    let gram = away.transpose() * &away;
    let images = images.min(members.len().saturating_sub(1)).min(rank);
    let Ok(decomposed) = gram.self_adjoint_eigen(Side::Lower) else {
        return Cluster { mean, images: Vec::new(), weights: vec![Vec::new(); members.len()] };
    };
    let axes = Mat::from_fn(rank, images, |row, k| decomposed.U()[(row, rank - 1 - k)]);
    let along = &away * &axes;
    let mut cluster =
        Cluster { mean, images: Vec::new(), weights: vec![Vec::new(); members.len()] };
    for k in 0..images {
        let largest = (0..members.len()).fold(0.0_f32, |most, one| most.max(along[(one, k)].abs()));
        if largest <= 0.0 {
            break;
        }
        let unit = largest / 127.0;
        cluster.images.push((0..rank).map(|row| unit * axes[(row, k)]).collect());
        for (one, weights) in cluster.weights.iter_mut().enumerate() {
            weights.push((along[(one, k)] / unit).round() as i8);
        }
    }
    cluster
}

/// The cluster of each row, and the centers, at most `count`.
fn kmeans(rows: MatRef<'_, f32>, count: usize) -> (Vec<usize>, Mat<f32>) {
    let (all, rank) = (rows.nrows(), rows.ncols());
    let count = count.min(all);
    // Spread over the rows; a step that has no factor in common with most counts.
    let step = 0.618_034_f64;
    let mut centers = Mat::from_fn(count, rank, |center, k| {
        let place = (((center as f64 + 0.5) * step).fract() * all as f64) as usize;
        rows[(place.min(all - 1), k)]
    });
    let mut labels = vec![0; all];
    for _ in 0..ROUNDS {
        let found = nearest(rows, &centers);
        let mut sums = Mat::<f64>::zeros(count, rank);
        let mut counts = vec![0.0_f64; count];
        for (row, (label, _)) in found.iter().enumerate() {
            counts[*label] += 1.0;
            for k in 0..rank {
                sums[(*label, k)] += f64::from(rows[(row, k)]);
            }
        }
        // Empty clusters get the rows farthest from their centers.
        let mut far: Vec<usize> = (0..all).collect();
        far.sort_by(|&a, &b| found[b].1.total_cmp(&found[a].1));
        let mut far = far.into_iter();
        for center in 0..count {
            let place = if counts[center] > 0.0 { None } else { far.next() };
            for k in 0..rank {
                centers[(center, k)] = match place {
                    Some(row) => rows[(row, k)],
                    None => (sums[(center, k)] / counts[center]) as f32,
                };
            }
        }
        labels = found.into_iter().map(|(label, _)| label).collect();
    }
    (labels, centers)
}

/// The nearest center of each row, and the square of the distance.
fn nearest(rows: MatRef<'_, f32>, centers: &Mat<f32>) -> Vec<(usize, f32)> {
    const BATCH: usize = 256;
    let square = |row: faer::RowRef<'_, f32>| row.iter().map(|one| one * one).sum::<f32>();
    let squares: Vec<f32> = (0..centers.nrows()).map(|k| square(centers.row(k))).collect();
    let batches = rows.nrows().div_ceil(BATCH);
    let found = parallel::map(batches, &(), |batch| {
        let start = batch * BATCH;
        let part = rows.subrows(start, BATCH.min(rows.nrows() - start));
        // A column for each row, so that its products lie together.
        let mut products = Mat::<f32>::zeros(centers.nrows(), part.nrows());
        faer::linalg::matmul::matmul(
            &mut products,
            faer::Accum::Replace,
            centers,
            part.transpose(),
            1.0,
            faer::Par::Seq,
        );
        let of_row = |row: usize| {
            let own = square(part.row(row));
            let distances = products.col_as_slice(row).iter().zip(&squares);
            let distances = distances.map(|(product, square)| square - 2.0 * product).enumerate();
            let least = distances.min_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0));
            (least.0, own + least.1)
        };
        (0..part.nrows()).map(of_row).collect::<Vec<_>>()
    });
    found.into_iter().flatten().collect()
}

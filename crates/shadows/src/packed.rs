//! Packs an object with its shadows for the runtime.

use crate::codebook::{Cluster, Codebook, codebook};
use crate::eigenimages::Eigenimages;
use eigenshade_table::light;
use eigenshade_table::shadowed::{self, File, MOST_IMAGES, MOST_SHIFT, Pixel, Rows};
use faer::{Mat, MatRef};

/// How an object is compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Compression {
    /// The most codes, at most 65,535.
    pub codes: usize,
    /// The most clusters.
    pub clusters: usize,
    /// Images of a cluster, at most 16.
    pub images: usize,
}

impl Default for Compression {
    fn default() -> Self {
        Self { codes: 4096, clusters: 32, images: 8 }
    }
}

/// The file of an object, and its codebook.
///
/// `pixels` are those of the rows of the eigenimages, with their coverage of 255; `shares` the shares
/// of the parts of the material, from -1 to 1.
#[must_use]
pub fn packed(
    images: &Eigenimages,
    degree: usize,
    size: usize,
    pixels: &[([usize; 2], u8)],
    shares: &[[f64; 3]],
    compression: Compression,
) -> (File, Codebook) {
    let Compression { codes, clusters, images: own } = compression;
    let own = own.min(MOST_IMAGES);
    let rows = Mat::from_fn(images.pixels.nrows(), images.pixels.ncols(), |row, k| {
        images.pixels[(row, k)] as f32
    });
    let book = codebook(rows.as_ref(), codes.min(65_535), clusters, own);
    let file = File {
        size: [size as u16; 2],
        degree: degree as u8,
        shares: shares
            .iter()
            .map(|share| share.map(|one| (32_767.0 * one.clamp(-1.0, 1.0)).round() as i16))
            .collect(),
        rows: images.rows.iter().map(|rows| of_part(rows.as_ref(), degree)).collect(),
        clusters: book.clusters.iter().map(|cluster| quantized(cluster, own)).collect(),
        pixels: pixels
            .iter()
            .zip(&book.of_pixel)
            .map(|(&([column, row], coverage), &code)| Pixel {
                column: column as u16,
                row: row as u16,
                code: code as u16,
                coverage,
            })
            .collect(),
    };
    (file, book)
}

/// The rows of a part. Light has less of high degrees, whose numbers are larger for it: each degree is
/// shifted, so that all have numbers of about the same size.
fn of_part(rows: MatRef<'_, f64>, degree: usize) -> Rows {
    let largest: Vec<f64> = (0..=degree)
        .map(|l| {
            let of_degree = rows.subcols(l * l, 2 * l + 1);
            of_degree.norm_max()
        })
        .collect();
    let least = largest.iter().copied().filter(|one| *one > 0.0).fold(f64::INFINITY, f64::min);
    let shift = |one: &f64| (one / least).log2().round().clamp(0.0, f64::from(MOST_SHIFT)) as u8;
    let shifts: Vec<u8> = largest.iter().map(shift).collect();
    let shifted = |j: usize| -> Vec<f64> {
        let numbers = light::indices(degree).zip(rows.row(j).iter());
        numbers.map(|((l, _), one)| one / f64::from(1 << shifts[l])).collect()
    };
    let of_components = (0..rows.nrows()).map(|j| bytes(&shifted(j))).collect();
    Rows { shifts, of_components }
}

/// A cluster with exactly `own` images.
fn quantized(cluster: &Cluster, own: usize) -> shadowed::Cluster {
    let wide = |row: &[f32]| row.iter().map(|&one| f64::from(one)).collect::<Vec<f64>>();
    let rank = cluster.mean.len();
    let mut images: Vec<(i8, Vec<i8>)> =
        cluster.images.iter().map(|image| bytes(&wide(image))).collect();
    images.resize(own, (0, vec![0; rank]));
    let weights = cluster.weights.iter().map(|weights| {
        let mut weights = weights.clone();
        weights.resize(own, 0);
        weights
    });
    shadowed::Cluster {
        mean: mantissas(&wide(&cluster.mean), 15),
        images,
        weights: weights.collect(),
    }
}

/// Numbers as mantissas of 8 bits, and their exponent.
fn bytes(numbers: &[f64]) -> (i8, Vec<i8>) {
    let (exponent, mantissas) = mantissas(numbers, 7);
    (exponent, mantissas.into_iter().map(|one| one as i8).collect())
}

/// Numbers as mantissas of `bits` bits and a sign, and their exponent.
fn mantissas(numbers: &[f64], bits: i32) -> (i8, Vec<i16>) {
    let largest = numbers.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    if largest <= 0.0 {
        return (0, vec![0; numbers.len()]);
    }
    let most = f64::from((1 << bits) - 1);
    let exponent = (largest / most).log2().ceil().clamp(-128.0, 127.0);
    let unit = exponent.exp2();
    let whole = |one: &f64| (one / unit).round().clamp(-most, most) as i16;
    (exponent as i8, numbers.iter().map(whole).collect())
}

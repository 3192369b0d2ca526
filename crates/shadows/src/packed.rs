//! Packs an object with its shadows for the runtime.

use crate::codebook::{Cluster, Codebook, codebook};
use crate::eigenimages::Eigenimages;
use eigenshade_table::light;
use eigenshade_table::shadowed::{self, File, MOST_IMAGES, MOST_SHIFT, Pixel, Row};
use faer::Mat;

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
    let scales = scales(&images.rows);
    let of_part = |rows: &Mat<f64>| -> Vec<Row> {
        let numbers =
            |j: usize| rows.row(j).iter().map(|one| one * scales[j]).collect::<Vec<f64>>();
        (0..rows.nrows()).map(|j| row(&numbers(j), degree)).collect()
    };
    let file = File {
        size: [size as u16; 2],
        degree: degree as u8,
        shares: shares
            .iter()
            .map(|share| share.map(|one| (32_767.0 * one.clamp(-1.0, 1.0)).round() as i16))
            .collect(),
        rows: images.rows.iter().map(of_part).collect(),
        clusters: book.clusters.iter().map(|cluster| quantized(cluster, own, &scales)).collect(),
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
        tints: Vec::new(),
    };
    (file, book)
}

/// The units of the coefficients. All light has much of degree 0, and the number of a row for it is a
/// power of two in its coefficient's unit, without a rounding error.
fn scales(rows: &[Mat<f64>]) -> Vec<f64> {
    let components = rows.first().map_or(0, Mat::nrows);
    let scale = |j: usize| {
        let ambient = rows.iter().fold(0.0, |most: f64, part| most.max(part[(j, 0)].abs()));
        if ambient > 0.0 { ambient.log2().round().exp2() / ambient } else { 1.0 }
    };
    (0..components).map(scale).collect()
}

/// A row that gives a coefficient from a light. Light has less of high degrees, whose numbers are larger
/// for it, and a row may have much of one: each degree has its own unit, down to 2^-12 of the largest.
fn row(numbers: &[f64], degree: usize) -> Row {
    let of_degree = |l: usize| &numbers[l * l..(l + 1) * (l + 1)];
    let exponents: Vec<i8> = (0..=degree).map(|l| bytes(of_degree(l)).0).collect();
    let used = (0..=degree).filter(|&l| of_degree(l).iter().any(|&one| one != 0.0));
    let largest = used.clone().map(|l| exponents[l]).max().unwrap_or(0);
    let least = used.map(|l| exponents[l]).min().unwrap_or(0);
    let exponent = least.max(largest.saturating_sub(MOST_SHIFT as i8));
    let shifts: Vec<u8> = exponents
        .iter()
        .map(|one| one.saturating_sub(exponent).clamp(0, MOST_SHIFT as i8).cast_unsigned())
        .collect();
    let mantissas = light::indices(degree).zip(numbers).map(|((l, _), one)| {
        let unit = f64::from(i32::from(exponent) + i32::from(shifts[l])).exp2();
        (one / unit).round().clamp(-127.0, 127.0) as i8
    });
    Row { exponent, mantissas: mantissas.collect(), shifts }
}

/// A cluster with exactly `own` images, for coefficients in these units.
fn quantized(cluster: &Cluster, own: usize, scales: &[f64]) -> shadowed::Cluster {
    let wide = |row: &[f32]| -> Vec<f64> {
        row.iter().zip(scales).map(|(&one, scale)| f64::from(one) / scale).collect()
    };
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

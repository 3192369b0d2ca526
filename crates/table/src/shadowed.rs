//! The file of an object with shadows: its eigenimages, compressed, and the rows that give their
//! coefficients from a light.
//!
//! Numbers have the low byte first. r is the rank, K the number of images of a cluster, and
//! n = (degree + 1)².
//!
//! | bytes | |
//! |---|---|
//! | 6 | `eigsh` and the version: 2 of an object of one material, 3 of one with base colors |
//! | 8 | width, height, number of codes, number of clusters: 16 bits each |
//! | 4 | degree, number of parts of the material, r, K: 8 bits each |
//! | 6 for each part | its share in red, green and blue: 16 bits each, in units of 1 / 32,767 |
//! | degree + 2 + n for each part and component | the exponent of a row, a shift of at most 12 for each degree, and n mantissas: 8 bits each |
//! | clusters | for each: the number of its codes, 16 bits; the exponents of its mean and of its K images, 8 bits each; the mean, r mantissas of 16 bits; the images, K r mantissas of 8 bits; K weights of 8 bits for each code |
//! | 4 for each row of pixels, and 4 | the number of the row's first word, counted from the end of this table; the last one is the number of words |
//! | 2 for each word | of each row its runs from left to right: the first column, the number of pixels, plus 2^15 if their coverage follows, then for each pixel its code and, if so, its coverage of 255 |
//!
//! With the mantissas times 2 to their exponent, and in rows to the shift of their degree too, the
//! irradiance of a code is
//! Σ_j (mean_j + Σ_k weight_k image_kj) d_j, where d = Σ_parts share x row · L in each channel.
//!
//! With base colors, a run has no bit for coverage, and a pixel has four words: the code of T, the code of
//! P, then four bytes, which are its base color in sRGB (r, g, b) and its coverage of 255. Its irradiance
//! is base color x T + P.

/// The first bytes of a file of an object of one material.
pub const MAGIC: [u8; 6] = *b"eigsh\x02";

/// The first bytes of a file of an object with base colors.
pub const TINTED_MAGIC: [u8; 6] = *b"eigsh\x03";

/// The words of a pixel with a base color.
pub const TINTED_WORDS: usize = 4;

/// The largest rank.
pub const MOST_RANK: usize = 100;

/// The most images of a cluster.
pub const MOST_IMAGES: usize = 16;

/// The largest shift of a degree.
pub const MOST_SHIFT: u8 = 12;

/// The bit of a run's number of pixels that says that their coverage follows.
pub const RIM: u16 = 1 << 15;

#[cfg(feature = "alloc")]
pub use encoding::{Cluster, File, Pixel, Row, Tint};

#[cfg(feature = "alloc")]
mod encoding {
    use super::{MAGIC, RIM, TINTED_MAGIC};
    use alloc::vec::Vec;

    /// The contents of a file.
    #[derive(Clone, Debug, Default, PartialEq)]
    pub struct File {
        /// Pixels across and down.
        pub size: [u16; 2],
        /// The degree of the light.
        pub degree: u8,
        /// The shares of the parts of the material in units of 1 / 32,767.
        pub shares: Vec<[i16; 3]>,
        /// For each part, for each component, the row that gives its coefficient.
        pub rows: Vec<Vec<Row>>,
        /// The clusters.
        pub clusters: Vec<Cluster>,
        /// The pixels in the order of their rows and columns.
        pub pixels: Vec<Pixel>,
        /// What each pixel has beside, or none if the object is of one material.
        pub tints: Vec<Tint>,
    }

    /// A row that gives a coefficient from a light.
    #[derive(Clone, Debug, Default, PartialEq)]
    pub struct Row {
        /// The exponent of all numbers.
        pub exponent: i8,
        /// For each degree, the exponent of 2 by which its numbers are larger.
        pub shifts: Vec<u8>,
        /// n mantissas.
        pub mantissas: Vec<i8>,
    }

    /// A cluster of codes.
    #[derive(Clone, Debug, Default, PartialEq)]
    pub struct Cluster {
        /// An exponent and r mantissas.
        pub mean: (i8, Vec<i16>),
        /// K images, each an exponent and r mantissas.
        pub images: Vec<(i8, Vec<i8>)>,
        /// The K weights of each code.
        pub weights: Vec<Vec<i8>>,
    }

    /// A pixel.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Pixel {
        /// The column, from the left.
        pub column: u16,
        /// The row, from the top.
        pub row: u16,
        /// The number of its code over all clusters; with base colors, that of T.
        pub code: u16,
        /// The covered share of 255.
        pub coverage: u8,
    }

    /// The second code and the base color of a pixel of a textured object.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Tint {
        /// The code of P.
        pub code: u16,
        /// The base color in sRGB.
        pub base_color: [u8; 3],
    }

    impl File {
        /// The bytes.
        #[must_use]
        pub fn encode(&self) -> Vec<u8> {
            let rank = self.rows.first().map_or(0, Vec::len);
            let images = self.clusters.first().map_or(0, |cluster| cluster.images.len());
            let codes: usize = self.clusters.iter().map(|one| one.weights.len()).sum();
            let mut bytes = if self.tints.is_empty() { MAGIC } else { TINTED_MAGIC }.to_vec();
            let [width, height] = self.size;
            for word in [width, height, codes as u16, self.clusters.len() as u16] {
                bytes.extend(word.to_le_bytes());
            }
            bytes.extend([self.degree, self.shares.len() as u8, rank as u8, images as u8]);
            bytes.extend(self.shares.iter().flatten().flat_map(|one| one.to_le_bytes()));
            for row in self.rows.iter().flatten() {
                bytes.push(row.exponent.cast_unsigned());
                bytes.extend(&row.shifts);
                bytes.extend(row.mantissas.iter().map(|one| one.cast_unsigned()));
            }
            for cluster in &self.clusters {
                bytes.extend((cluster.weights.len() as u16).to_le_bytes());
                let (exponent, mean) = &cluster.mean;
                let exponents = cluster.images.iter().map(|(exponent, _)| exponent);
                bytes.push(exponent.cast_unsigned());
                bytes.extend(exponents.map(|one| one.cast_unsigned()));
                bytes.extend(mean.iter().flat_map(|one| one.to_le_bytes()));
                let images = cluster.images.iter().flat_map(|(_, image)| image);
                let weights = cluster.weights.iter().flatten();
                bytes.extend(images.chain(weights).map(|one| one.cast_unsigned()));
            }
            self.push_pixels(&mut bytes);
            bytes
        }

        fn push_pixels(&self, bytes: &mut Vec<u8>) {
            let (mut starts, mut words) = (Vec::new(), Vec::new());
            let [_, height] = self.size;
            for row in 0..height {
                starts.push(words.len() as u32);
                let start = self.pixels.partition_point(|pixel| pixel.row < row);
                let end = self.pixels.partition_point(|pixel| pixel.row <= row);
                let is_tinted = !self.tints.is_empty();
                let is_whole = |pixel: &Pixel| is_tinted || pixel.coverage == u8::MAX;
                let follow =
                    |a: &Pixel, b: &Pixel| b.column == a.column + 1 && is_whole(a) == is_whole(b);
                let mut tints = self.tints.iter().skip(start);
                for run in self.pixels[start..end].chunk_by(follow) {
                    let is_whole = is_whole(&run[0]);
                    let count = run.len() as u16 | if is_whole { 0 } else { RIM };
                    words.extend([run[0].column, count]);
                    for pixel in run {
                        words.push(pixel.code);
                        words.extend((!is_whole).then_some(u16::from(pixel.coverage)));
                        if let Some(Tint { code, base_color: [r, g, b] }) = tints.next() {
                            let pairs = [[*r, *g], [*b, pixel.coverage]].map(u16::from_le_bytes);
                            words.extend([*code, pairs[0], pairs[1]]);
                        }
                    }
                }
            }
            starts.push(words.len() as u32);
            bytes.extend(starts.iter().flat_map(|one| one.to_le_bytes()));
            bytes.extend(words.iter().flat_map(|one| one.to_le_bytes()));
        }
    }
}

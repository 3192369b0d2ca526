//! Objects with shadows: their eigenimages in clusters.

use crate::color::Rgb;
use crate::display::{Display, Exposure, Linear};
use crate::error::{Argument, Error};
use crate::index::light;
use crate::index::shadowed::{MAGIC, MOST_IMAGES, MOST_RANK, RIM};
use crate::light::Light;
use crate::pixel::Pixel;
use crate::q15;
use crate::target::Target;

/// The threshold that rounds to the nearest level of a display.
const NEAREST: u32 = 1 << 15;

/// Bits of an exposed irradiance after the binary point.
const POINT: i32 = 20;
/// The largest mean and the largest image: a mean and [`MOST_IMAGES`] images times -128 fit an `i32`.
const MEAN: i64 = 1 << 28;
const IMAGE: i64 = 1 << 19;

/// An object of one material that shadows itself, seen from one side: its eigenimages U in
/// compressed form, and the rows UᵀM that give their coefficients d from a light.
///
/// `eigenshade pack-object --shadows` makes one. A frame takes a matrix product for d, a sum of a few
/// images for each code, of which an object has some thousand, and a look-up for each pixel. Light is
/// harmonics alone: sources stay in it.
///
/// ```no_run
/// # static FILE: [u8; 6] = *b"eigsh\x01";
/// use eigenshade::object::ShadowedObject;
/// use eigenshade::screen::{Display, Exposure, Target, Tone};
/// use eigenshade::{Light, Rgb};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let coin = ShadowedObject::new(&FILE)?;
/// let light = [[1.0, 0.2, 0.5, -0.1], [0.9, 0.2, 0.5, -0.1], [0.8, 0.2, 0.5, -0.1]];
/// let light = Rgb::from(&light).try_map(|channel| Light::new(channel))?;
/// let mut colors = [0_u16; 4096]; // as many as it has codes
/// let mut screen = [0_u16; 96 * 96];
///
/// // Every frame:
/// let d = coin.coefficients(light)?;
/// coin.colors(&d, Exposure::new(0.5)?, &DISPLAY, &mut colors)?;
/// coin.draw(&colors, &mut Target::new(&mut screen, 96)?);
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShadowedObject<'a> {
    width: u16,
    height: u16,
    codes: u16,
    degree: usize,
    rank: usize,
    images: usize,
    /// Of each part of the material, its shares in the channels.
    shares: &'a [[u8; 6]],
    /// Of each part and component, an exponent and mantissas.
    rows: &'a [u8],
    clusters: &'a [u8],
    /// The first word of each row, and the number of all.
    starts: &'a [[u8; 4]],
    words: &'a [[u8; 2]],
}

/// The coefficients d of one channel: mantissas times a power of two.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ObjectCoefficients {
    mantissas: [i16; MOST_RANK],
    exponent: i32,
}

/// Reading.
impl<'a> ShadowedObject<'a> {
    /// The object of a file that `eigenshade pack-object --shadows` wrote. Bytes after it are ignored.
    ///
    /// Cost: some instructions for each row of pixels, each run and each cluster.
    ///
    /// # Errors
    ///
    /// [`Error::Object`] if the bytes are something else, were cut or changed.
    pub const fn new(bytes: &'a [u8]) -> Result<Self, Error> {
        match Self::read(bytes) {
            Some(object) => Ok(object),
            None => Err(Error::Object),
        }
    }

    const fn read(bytes: &'a [u8]) -> Option<Self> {
        let Some((&MAGIC, rest)) = bytes.split_first_chunk() else { return None };
        let Some((&[a, b, c, d, e, f, g, h], rest)) = rest.split_first_chunk() else { return None };
        let (width, height) = (u16::from_le_bytes([a, b]), u16::from_le_bytes([c, d]));
        let (codes, count) = (u16::from_le_bytes([e, f]), u16::from_le_bytes([g, h]));
        let Some((&[degree, parts, rank, images], rest)) = rest.split_first_chunk() else {
            return None;
        };
        let (degree, rank, images) = (degree as usize, rank as usize, images as usize);
        let parts = parts as usize;
        let is_fit = width > 0
            && height > 0
            && parts > 0
            && rank > 0
            && rank <= MOST_RANK
            && images <= MOST_IMAGES
            && degree <= crate::index::layout::MAX_DEGREE;
        if !is_fit {
            return None;
        }
        let Some((shares, rest)) = rest.split_at_checked(6 * parts) else { return None };
        let of_rows = parts * rank * (1 + 2 * light::count(degree));
        let Some((rows, rest)) = rest.split_at_checked(of_rows) else { return None };
        let Some((clusters, rest)) = split_clusters(rest, count, codes, rank, images) else {
            return None;
        };
        let Some((starts, rest)) = rest.split_at_checked((height as usize + 1) * 4) else {
            return None;
        };
        let shares: &[[u8; 6]] = shares.as_chunks().0;
        let starts: &[[u8; 4]] = starts.as_chunks().0;
        let words: &[[u8; 2]] = rest.as_chunks().0;
        let [[0, 0, 0, 0], .., end] = starts else { return None };
        let Some((words, _)) = words.split_at_checked(u32::from_le_bytes(*end) as usize) else {
            return None;
        };
        let object = Self {
            width,
            height,
            codes,
            degree,
            rank,
            images,
            shares,
            rows,
            clusters,
            starts,
            words,
        };
        if object.has_rows() { Some(object) } else { None }
    }

    /// Whether each row has whole runs from left to right.
    const fn has_rows(&self) -> bool {
        let (mut starts, mut words, mut place) = (self.starts, self.words, 0);
        while let [_, rest @ ..] = starts
            && let [end, ..] = rest
        {
            let end = u32::from_le_bytes(*end) as usize;
            let Some(count) = end.checked_sub(place) else { return false };
            let Some((row, after)) = words.split_at_checked(count) else { return false };
            if !self.has_runs(row) {
                return false;
            }
            (starts, words, place) = (rest, after, end);
        }
        true
    }

    const fn has_runs(&self, mut row: &[[u8; 2]]) -> bool {
        let mut column = 0;
        while let [first, count, rest @ ..] = row {
            let (first, count) = (u16::from_le_bytes(*first), u16::from_le_bytes(*count));
            let each = if count & RIM == 0 { 1 } else { 2 };
            let count = (count & !RIM) as usize;
            let end = first as usize + count;
            let Some((_, after)) = rest.split_at_checked(each * count) else { return false };
            if count == 0 || (first as usize) < column || end > self.width as usize {
                return false;
            }
            (row, column) = (after, end);
        }
        row.is_empty()
    }

    /// Pixels across.
    #[must_use]
    pub const fn width(&self) -> usize {
        self.width as usize
    }

    /// Pixels down.
    #[must_use]
    pub const fn height(&self) -> usize {
        self.height as usize
    }

    /// The number of codes: as many colors a frame has.
    #[must_use]
    pub const fn codes(&self) -> usize {
        self.codes as usize
    }

    /// The degree of the light that it takes. Lights of a lower degree fit as well.
    #[must_use]
    pub const fn degree(&self) -> usize {
        self.degree
    }
}

/// The bytes of so many clusters, which have so many codes together, and the rest.
const fn split_clusters(
    bytes: &[u8],
    mut clusters: u16,
    codes: u16,
    rank: usize,
    images: usize,
) -> Option<(&[u8], &[u8])> {
    let (mut rest, mut found) = (bytes, 0);
    while clusters > 0 {
        let Some((&count, after)) = rest.split_first_chunk() else { return None };
        let count = u16::from_le_bytes(count) as usize;
        let size = 1 + images + 2 * rank + images * rank + images * count;
        let Some((_, after)) = after.split_at_checked(size) else { return None };
        found += count;
        clusters -= 1;
        rest = after;
    }
    if found == codes as usize { bytes.split_at_checked(bytes.len() - rest.len()) } else { None }
}

/// Coefficients.
impl ShadowedObject<'_> {
    /// d of a light on the object's material.
    ///
    /// Cost: (degree + 1)² products for each component, part of the material and channel: 64 x 100 x 3
    /// for a gray material at degree 9.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients(&self, light: Rgb<Light<'_>>) -> Result<Rgb<ObjectCoefficients>, Error> {
        self.each_channel(light, |light, share| {
            let coefficients = light.coefficients();
            Error::check_beyond(Argument::Light, self.degree, light.degree())?;
            let mut sums = [0.0_f32; MOST_RANK];
            for (part, rows) in self.parts().enumerate() {
                let share = f32::from(share(part)) / 32_767.0;
                for ((exponent, row), sum) in rows.zip(&mut sums) {
                    let products = row.iter().zip(coefficients);
                    let product: f32 =
                        products.map(|(q, one)| f32::from(i16::from_le_bytes(*q)) * one).sum();
                    *sum += share * product * power(exponent);
                }
            }
            Ok(ObjectCoefficients::of_floats(sums.get(..self.rank).unwrap_or_default()))
        })
    }

    /// [`coefficients`](Self::coefficients) in integers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light has a higher degree.
    pub fn coefficients_q15(
        &self,
        light: Rgb<q15::Light<'_>>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        self.each_channel(light, |light, share| {
            let mantissas = light.mantissas();
            Error::check_beyond(Argument::Light, self.degree, light.degree)?;
            // Of each component a sum, of at most 38 bits for each part, and its exponent.
            let mut sums = [(0_i64, i32::from(i8::MIN)); MOST_RANK];
            for (part, rows) in self.parts().enumerate() {
                let share = i64::from(share(part));
                for ((exponent, row), sum) in rows.zip(&mut sums) {
                    let products = row.iter().zip(mantissas);
                    let product: i64 = products
                        .map(|(q, one)| {
                            i64::from(i32::from(i16::from_le_bytes(*q)) * i32::from(one.0))
                        })
                        .sum();
                    *sum = added(*sum, ((product * share) >> 15, exponent));
                }
            }
            let sums = sums.get(..self.rank).unwrap_or_default();
            Ok(ObjectCoefficients::of_sums(sums, light.exponent()))
        })
    }

    fn each_channel<L>(
        &self,
        light: Rgb<L>,
        of: impl Fn(L, &dyn Fn(usize) -> i16) -> Result<ObjectCoefficients, Error>,
    ) -> Result<Rgb<ObjectCoefficients>, Error> {
        let share = |channel: usize| {
            move |part: usize| {
                let share =
                    self.shares.get(part).and_then(|share| share.as_chunks().0.get(channel));
                share.map_or(0, |&share| i16::from_le_bytes(share))
            }
        };
        let Rgb { r, g, b } = light;
        Ok(Rgb { r: of(r, &share(0))?, g: of(g, &share(1))?, b: of(b, &share(2))? })
    }

    /// The rows of each part: exponents and mantissas.
    fn parts(&self) -> impl Iterator<Item = impl Iterator<Item = (i32, &[[u8; 2]])>> {
        let size = 1 + 2 * light::count(self.degree);
        // At least 1, so that no panic is linked.
        self.rows.chunks_exact((self.rank * size).max(1)).map(move |part| {
            part.chunks_exact(size.max(1)).map(|row| {
                let (exponent, mantissas) = row.split_first().unwrap_or((&0, &[]));
                (i32::from(exponent.cast_signed()), mantissas.as_chunks().0)
            })
        })
    }
}

/// 2 to an exponent of eight bits.
fn power(exponent: i32) -> f32 {
    f32::from_bits((127 + exponent.clamp(-126, 127)).cast_unsigned() << 23)
}

/// The sum of two numbers, each a mantissa and an exponent.
fn added(a: (i64, i32), b: (i64, i32)) -> (i64, i32) {
    let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
    if high.0 == 0 {
        return low;
    }
    ((low.0 >> (high.1 - low.1).min(63)) + high.0, high.1)
}

impl ObjectCoefficients {
    fn of_floats(numbers: &[f32]) -> Self {
        let largest = numbers.iter().fold(0.0_f32, |most, one| most.max(one.abs()));
        // The exponent with which the largest number has 15 bits, unless it is below 2^-113.
        let exponent = ((largest.to_bits() >> 23).cast_signed() - 126 - 15).max(-127);
        let scale = power(-exponent);
        let mantissa = |one: &f32| {
            let scaled = one * scale;
            (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }).clamp(-32_767.0, 32_767.0) as i16
        };
        Self { mantissas: filled(numbers.iter().map(mantissa)), exponent }
    }

    fn of_sums(sums: &[(i64, i32)], of_light: i32) -> Self {
        let bits =
            |sum: &(i64, i32)| 64 - sum.0.unsigned_abs().leading_zeros().cast_signed() + sum.1;
        let nonzero = sums.iter().filter(|sum| sum.0 != 0);
        let exponent = nonzero.map(bits).max().unwrap_or_default() - 15;
        let mantissa = |&(sum, own): &(i64, i32)| {
            let down = exponent - own;
            let mantissa = if down > 0 {
                let down = down.min(62);
                (sum + (1 << (down - 1))) >> down
            } else {
                // A sum of at most 15 bits, or 0 of any exponent.
                sum << (-down).min(15)
            };
            mantissa.clamp(-32_767, 32_767) as i16
        };
        Self { mantissas: filled(sums.iter().map(mantissa)), exponent: exponent + of_light }
    }
}

/// Numbers, and zeros after them.
fn filled(numbers: impl Iterator<Item = i16>) -> [i16; MOST_RANK] {
    let mut all = [0; MOST_RANK];
    all.iter_mut().zip(numbers).for_each(|(to, one)| *to = one);
    all
}

/// Colors.
impl ShadowedObject<'_> {
    /// Exposes the irradiance of each code and calls a function with it, in the order of the codes.
    ///
    /// Cost: for each code, K products a channel; for each of the clusters, (K + 1) r products a
    /// channel.
    ///
    /// # Errors
    ///
    /// None: an exposure that was made can be exposed with.
    pub fn shade(
        &self,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
        mut with: impl FnMut(Rgb<Linear>),
    ) -> Result<(), Error> {
        let mut rest = self.clusters;
        while let Some((cluster, after)) = Cluster::split(rest, self.rank, self.images) {
            rest = after;
            let shown = Shown::new(&cluster, d, exposure)?;
            if self.images == 0 {
                (0..cluster.codes).for_each(|_| with(shown.color(&[])));
                continue;
            }
            for weights in cluster.weights.chunks_exact(self.images) {
                with(shown.color(weights));
            }
        }
        Ok(())
    }

    /// The colors of all codes on a display.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are as many colors as codes; those of [`shade`](Self::shade).
    pub fn colors<P: Pixel>(
        &self,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
        display: &Display,
        colors: &mut [P],
    ) -> Result<(), Error> {
        Error::check(Argument::Colors, self.codes(), colors.len())?;
        let mut colors = colors.iter_mut();
        self.shade(d, exposure, |color| {
            if let Some(to) = colors.next() {
                *to = P::of_display(color.map(|channel| display.encode(channel)), NEAREST);
            }
        })
    }

    /// Draws the rows of the object that the target has, in the colors of its codes. A pixel of a code
    /// without a color is not drawn.
    pub fn draw<P: Pixel>(&self, colors: &[P], target: &mut Target<'_, P>) {
        for row in target.rows(self.height()) {
            let (first, pixels) = target.row(row);
            let mut words = self.row(row);
            while let [start, count, rest @ ..] = words {
                let [start, count] = [*start, *count].map(u16::from_le_bytes);
                let is_rim = count & RIM != 0;
                let (start, count) = (usize::from(start), usize::from(count & !RIM));
                let (run, after) = rest
                    .split_at_checked(if is_rim { 2 * count } else { count })
                    .unwrap_or_default();
                words = after;
                let skipped = first.saturating_sub(start);
                let to = pixels.get_mut((start + skipped).saturating_sub(first)..);
                let to = to.unwrap_or_default();
                if is_rim {
                    let run = run.as_chunks().0.get(skipped..).unwrap_or_default();
                    blended(colors, run, to);
                } else {
                    copied(colors, run.get(skipped..).unwrap_or_default(), to);
                }
            }
        }
    }

    /// The words of a row.
    fn row(&self, row: usize) -> &[[u8; 2]] {
        match self.starts.get(row..).and_then(|starts| starts.first_chunk()) {
            Some(&[start, end]) => {
                let [start, end] = [start, end].map(|place| u32::from_le_bytes(place) as usize);
                self.words.get(start..end).unwrap_or_default()
            }
            None => &[],
        }
    }
}

// Apart, so that the loop has all registers.
#[inline(never)]
fn copied<P: Pixel>(colors: &[P], run: &[[u8; 2]], pixels: &mut [P]) {
    for (pixel, code) in pixels.iter_mut().zip(run) {
        if let Some(&color) = colors.get(usize::from(u16::from_le_bytes(*code))) {
            *pixel = color;
        }
    }
}

fn blended<P: Pixel>(colors: &[P], run: &[[[u8; 2]; 2]], pixels: &mut [P]) {
    for (pixel, [code, [coverage, _]]) in pixels.iter_mut().zip(run) {
        if let Some(&color) = colors.get(usize::from(u16::from_le_bytes(*code))) {
            *pixel = color.over(*pixel, *coverage);
        }
    }
}

/// A cluster of a file.
struct Cluster<'a> {
    codes: usize,
    /// Of the mean, then of the images.
    exponents: &'a [u8],
    mean: &'a [[u8; 2]],
    images: &'a [u8],
    weights: &'a [u8],
}

impl<'a> Cluster<'a> {
    fn split(bytes: &'a [u8], rank: usize, images: usize) -> Option<(Self, &'a [u8])> {
        let (&codes, rest) = bytes.split_first_chunk()?;
        let codes = usize::from(u16::from_le_bytes(codes));
        let (exponents, rest) = rest.split_at_checked(1 + images)?;
        let (mean, rest) = rest.split_at_checked(2 * rank)?;
        let (of_images, rest) = rest.split_at_checked(images * rank)?;
        let (weights, rest) = rest.split_at_checked(images * codes)?;
        let mean = mean.as_chunks().0;
        Some((Self { codes, exponents, mean, images: of_images, weights }, rest))
    }
}

/// The exposed irradiances of a cluster's mean and of its images, in units of 2^-20 of white.
struct Shown {
    mean: [i32; 3],
    images: [[i32; 3]; MOST_IMAGES],
}

impl Shown {
    fn new(
        cluster: &Cluster<'_>,
        d: &Rgb<ObjectCoefficients>,
        exposure: Exposure,
    ) -> Result<Self, Error> {
        let channels = <[_; 3]>::from(d.each_ref());
        let mut exponents = cluster.exponents.iter().map(|one| i32::from(one.cast_signed()));
        let exposed = |sum: i64, exponent: i32, most: i64| {
            let exposure = q15::Exposure::new(exposure.factor(), exponent + POINT - 16)?;
            Ok::<i32, Error>(exposure.signed(sum).min(most).max(-most) as i32)
        };
        let (of_mean, mut shown) = (
            exponents.next().unwrap_or_default(),
            Self { mean: [0; 3], images: [[0; 3]; MOST_IMAGES] },
        );
        for (to, d) in shown.mean.iter_mut().zip(channels) {
            let products = cluster.mean.iter().zip(&d.mantissas);
            let sum = products
                .map(|(q, &one)| i64::from(i32::from(i16::from_le_bytes(*q)) * i32::from(one)))
                .sum();
            *to = exposed(sum, of_mean + d.exponent, MEAN)?;
        }
        let rank = cluster.mean.len().max(1);
        let images = cluster.images.chunks_exact(rank).zip(exponents);
        for ((image, exponent), to) in images.zip(&mut shown.images) {
            for (to, d) in to.iter_mut().zip(channels) {
                let sum = product(image, &d.mantissas);
                *to = exposed(i64::from(sum), exponent + d.exponent, IMAGE)?;
            }
        }
        Ok(shown)
    }

    /// The color of a code with these weights.
    #[inline(always)]
    fn color(&self, weights: &[u8]) -> Rgb<Linear> {
        let mut sums = self.mean;
        for (image, weight) in self.images.iter().zip(weights) {
            let weight = i32::from(weight.cast_signed());
            for (sum, image) in sums.iter_mut().zip(image) {
                *sum += weight * image;
            }
        }
        Rgb::from(sums).map(|sum| Linear((sum.max(0) >> (POINT - 16)).cast_unsigned()))
    }
}

/// At most 2^7 x 2^15 x 100.
#[inline(never)]
fn product(image: &[u8], mantissas: &[i16]) -> i32 {
    image.iter().zip(mantissas).map(|(q, &one)| i32::from(q.cast_signed()) * i32::from(one)).sum()
}

//! Objects with shadows: their eigenimages in clusters.

use crate::error::Error;
use crate::index::light;
use crate::index::shadowed::{
    MAGIC, MOST_IMAGES, MOST_RANK, MOST_SHIFT, RIM, TINTED_MAGIC, TINTED_WORDS,
};
use crate::pixel::Pixel;
use crate::rows::Rows;
use crate::target::Target;

/// An object of one material that shadows itself, seen from one side: its eigenimages U in
/// compressed form, and the rows UᵀM that give their coefficients d from a light.
///
/// `eigenshade pack-object --shadows` makes one. A frame takes a matrix product for d, a sum of a few
/// images for each code, of which an object has a few thousand, and a look-up for each pixel. Light is
/// harmonics alone: sources stay in it.
///
/// ```no_run
/// # static FILE: [u8; 6] = *b"eigsh\x02";
/// use eigenshade::object::ShadowedObject;
/// use eigenshade::screen::{Display, Exposure, Target, Tone};
/// use eigenshade::{Light, Rgb};
///
/// static DISPLAY: Display = Display::new(Tone::Filmic);
/// let coin = ShadowedObject::new(&FILE)?;
/// let light = [[1.0, 0.2, 0.5, -0.1], [0.9, 0.2, 0.5, -0.1], [0.8, 0.2, 0.5, -0.1]];
/// let light = Rgb::from(light.each_ref()).try_map(|channel| Light::new(channel))?;
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
    pub(crate) rank: usize,
    pub(crate) images: usize,
    /// Of each part of the material, its shares in the channels.
    pub(crate) shares: &'a [[u8; 6]],
    /// Of each part and component an exponent, the shifts of the degrees, and mantissas.
    pub(crate) rows: &'a [u8],
    pub(crate) clusters: &'a [u8],
    pub(crate) words: Rows<'a, 2>,
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
            Some((object, false)) => Ok(object),
            _ => Err(Error::Object),
        }
    }

    /// The object of a file, and whether its pixels have base colors.
    pub(crate) const fn read(bytes: &'a [u8]) -> Option<(Self, bool)> {
        let Some((magic, rest)) = bytes.split_first_chunk() else { return None };
        let is_tinted = match *magic {
            MAGIC => false,
            TINTED_MAGIC => true,
            _ => return None,
        };
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
            && degree <= light::MAX_DEGREE;
        if !is_fit {
            return None;
        }
        let Some((shares, rest)) = rest.split_at_checked(6 * parts) else { return None };
        let of_rows = parts * rank * row_bytes(degree);
        let Some((rows, rest)) = rest.split_at_checked(of_rows) else { return None };
        if !have_shifts(rows, degree) {
            return None;
        }
        let Some((clusters, rest)) = split_clusters(rest, count, codes, rank, images) else {
            return None;
        };
        let Some(words) = Rows::read(rest, height) else { return None };
        let shares = shares.as_chunks().0;
        let object =
            Self { width, height, codes, degree, rank, images, shares, rows, clusters, words };
        if object.has_rows(is_tinted) { Some((object, is_tinted)) } else { None }
    }

    /// Whether each row has whole runs from left to right.
    const fn has_rows(&self, is_tinted: bool) -> bool {
        let mut row = 0;
        while row < self.height() {
            match self.words.get(row) {
                Some(words) if self.has_runs(words, is_tinted) => {}
                _ => return false,
            }
            row += 1;
        }
        true
    }

    const fn has_runs(&self, mut row: &[[u8; 2]], is_tinted: bool) -> bool {
        let mut column = 0;
        while let [first, count, rest @ ..] = row {
            let (first, count) = (u16::from_le_bytes(*first), u16::from_le_bytes(*count));
            let (each, count) = if is_tinted {
                (TINTED_WORDS, count as usize)
            } else {
                (if count & RIM == 0 { 1 } else { 2 }, (count & !RIM) as usize)
            };
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

/// The bytes of a row that gives a coefficient.
pub(crate) const fn row_bytes(degree: usize) -> usize {
    1 + (degree + 1) + light::count(degree)
}

/// Whether the shifts of each row are within their range.
const fn have_shifts(mut rows: &[u8], degree: usize) -> bool {
    while let Some((row, rest)) = rows.split_at_checked(row_bytes(degree)) {
        let Some(([_, shifts @ ..], _)) = row.split_at_checked(degree + 2) else { return false };
        let mut shifts: &[u8] = shifts;
        while let [shift, after @ ..] = shifts {
            if *shift > MOST_SHIFT {
                return false;
            }
            shifts = after;
        }
        rows = rest;
    }
    true
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

/// Drawing.
impl ShadowedObject<'_> {
    /// Draws the rows of the object that the target has, in the colors of its codes. A pixel of a code
    /// without a color is not drawn.
    pub fn draw<P: Pixel>(&self, colors: &[P], target: &mut Target<'_, P>) {
        for row in target.rows(self.height()) {
            let (first, pixels) = target.row(row);
            let mut words = self.words.get(row).unwrap_or_default();
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

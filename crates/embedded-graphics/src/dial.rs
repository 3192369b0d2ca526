//! The dial of a watch or a gauge: a domed face with raised marks in a round bezel.

use crate::paint::{DisplayColor, Place, Shader, places};
use crate::rows;
use eigenshade::object::{Disc, DiscPixel, NormalCode, NormalMap};
use eigenshade::{Argument, Error, Normal, Q15, q15};
use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::primitives::Rectangle;

/// 1 in lengths of normals.
const ONE: i32 = 1 << 15;

/// The sine of 30 degrees, in units of 2^-14.
const SINE: i32 = 8_192;
/// See [`SINE`].
const COSINE: i32 = 14_189;

/// A dial: twelve raised marks on a domed face, in a bezel with the profile of a half circle.
///
/// Normals are computed in integers: two divisions for a pixel of the face, a root and a division
/// for one of a mark, two roots and three divisions for one of the bezel.
#[derive(Debug)]
pub struct Dial<'p, P, C> {
    top_left: Point,
    disc: Disc,
    shape: Shape,
    paint: &'p P,
    below: Option<C>,
}

/// Lengths in half pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Shape {
    diameter: i32,
    /// Half the width of the bezel.
    bezel: i32,
    /// Half the width of a mark.
    mark: i32,
}

impl<'p, P: Shader, C: DisplayColor> Dial<'p, P, C> {
    /// A dial that fills a square of `diameter` pixels, with a bezel and marks of these widths in
    /// pixels; 0 for none. A bezel takes at most half the radius, and a mark at most a quarter of
    /// what is left.
    ///
    /// # Errors
    ///
    /// As [`Disc::new`].
    pub fn new(
        top_left: Point,
        diameter: u32,
        bezel: u32,
        mark: u32,
        paint: &'p P,
    ) -> Result<Self, Error> {
        let disc = Disc::new(diameter as usize)?;
        let shape = Shape::new(diameter, bezel, mark);
        Ok(Self { top_left, disc, shape, paint, below: None })
    }

    /// The dial on a background of one color, with which the pixels of the rim are mixed.
    #[must_use]
    pub fn over(self, background: C) -> Self {
        Self { below: Some(background), ..self }
    }
}

impl Dial<'_, (), ()> {
    /// Writes the codes of the pixels of a dial, row by row from the top, with the arguments of
    /// [`new`](Self::new). A [`NormalMap`] of them, made once, is drawn from a
    /// [`Palette`](eigenshade::screen::Palette) in every frame. The pixels of the rim have a coverage,
    /// and those on an edge inside the mean normal of 4 x 4 points.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there is a code for each pixel of the square around the dial; as
    /// [`Disc::new`].
    pub fn codes(diameter: u32, bezel: u32, mark: u32, codes: &mut [[u8; 2]]) -> Result<(), Error> {
        let (disc, shape) = (Disc::new(diameter as usize)?, Shape::new(diameter, bezel, mark));
        let size = diameter as usize;
        let expected = size * size;
        if codes.len() != expected {
            let (argument, found) = (Argument::NormalMap, codes.len());
            return Err(Error::Length { argument, expected, found });
        }
        codes.fill(NormalMap::BACKGROUND);
        let pixels = || disc.clone();
        for pixel in pixels().filter(|pixel| pixel.coverage() == u8::MAX) {
            if let Some(to) = codes.get_mut(pixel.index()) {
                *to = NormalCode::of(shape.mean_normal(pixel)).bytes();
            }
        }
        for pixel in pixels().filter(|pixel| pixel.coverage() < u8::MAX) {
            // The neighbor toward the center.
            let [right, down] =
                [pixel.column(), pixel.row()].map(|place| if 2 * place < size { 1 } else { -1 });
            let neighbor = pixel.index().checked_add_signed(down * size as isize + right);
            let neighbor = neighbor.and_then(|index| codes.get(index));
            // One with a normal of its own.
            if neighbor.is_some_and(|code| code[0] != NormalMap::BACKGROUND[0])
                && let Some(to) = codes.get_mut(pixel.index())
            {
                *to = NormalMap::edge_code(pixel.coverage(), [right as i8, down as i8]);
            }
        }
        Ok(())
    }
}

impl<P, C> Dimensions for Dial<'_, P, C> {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(self.top_left, Size::new_equal(self.shape.diameter.cast_unsigned()))
    }
}

impl<P: Shader, C: DisplayColor> Drawable for Dial<'_, P, C> {
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let (area, shape) = (self.bounding_box(), self.shape);
        rows::draw(target, area, self.below, self.paint, |row| {
            self.disc.row(row).map(move |place| DialPixel { place, shape })
        })
    }
}

/// A pixel of a [`Dial`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DialPixel {
    place: DiscPixel,
    shape: Shape,
}

places! {
    DialPixel, |pixel| pixel.place.coverage();
}

impl DialPixel {
    /// The column, from 0 at the left.
    #[must_use]
    pub const fn column(self) -> usize {
        self.place.column()
    }

    /// The row, from 0 at the top.
    #[must_use]
    pub const fn row(self) -> usize {
        self.place.row()
    }

    /// The normal.
    #[must_use]
    pub fn normal(self) -> Normal {
        let [x, y, z] = self.vector().map(|along| along as f32);
        Normal::new(x, y, z).unwrap_or(self.place.normal())
    }

    /// The normal in integers.
    #[must_use]
    pub fn normal_q15(self) -> q15::Normal {
        let [x, y, z] = self.vector().map(|along| Q15(along.clamp(1 - ONE, ONE - 1) as i16));
        q15::Normal::from_unit(x, y, z).unwrap_or(self.place.normal_q15())
    }

    /// The code of the normal.
    #[must_use]
    pub fn code(self) -> NormalCode {
        NormalCode::of_q15(self.normal_q15())
    }

    /// The normal in units of 2^-15.
    fn vector(self) -> [i32; 3] {
        let Shape { diameter, .. } = self.shape;
        let [x, y] = [self.column(), self.row()].map(|place| 2 * place as i32 + 1 - diameter);
        self.shape.vector([x, -y])
    }
}

impl Shape {
    fn new(diameter: u32, bezel: u32, mark: u32) -> Self {
        let bezel = bezel.min(diameter / 4);
        let mark = mark.min((diameter - 2 * bezel) / 8);
        let [diameter, bezel, mark] = [diameter, bezel, mark].map(u32::cast_signed);
        Self { diameter, bezel, mark }
    }

    /// The mean of the normals of 4 x 4 points of a pixel.
    fn mean_normal(self, pixel: DiscPixel) -> Normal {
        let [diameter, bezel, mark] =
            [self.diameter, self.bezel, self.mark].map(|length| 4 * length);
        let fine = Self { diameter, bezel, mark };
        let mut sum = [0; 3];
        for (down, right) in (0..4).flat_map(|down| (0..4).map(move |right| (down, right))) {
            let places = [(pixel.column(), right), (pixel.row(), down)];
            let [x, y] = places.map(|(place, part)| 2 * (4 * place as i32 + part) + 1 - diameter);
            let vector = fine.vector([x, -y]);
            sum.iter_mut().zip(vector).for_each(|(sum, along)| *sum += along);
        }
        let [x, y, z] = sum.map(|along| along as f32);
        Normal::new(x, y, z).unwrap_or(pixel.normal())
    }

    /// The normal at a point, in half pixels to the right of the center and above it, in units of
    /// 2^-15.
    fn vector(self, [x, y]: [i32; 2]) -> [i32; 3] {
        let Self { diameter, bezel, mark } = self;
        let square = (x * x + y * y).cast_unsigned();
        let inner = diameter - 2 * bezel;
        if bezel > 0 && square > (inner * inner).cast_unsigned() {
            // The root has 16 bits, `bits` of them below half a pixel.
            let bits = square.leading_zeros() / 2;
            let distance = (square << (2 * bits)).isqrt().cast_signed();
            let [middle, half_width] = [diameter - bezel, bezel].map(|length| length << bits);
            let from_middle = (distance - middle).max(-half_width).min(half_width);
            let across = quotient(from_middle * ONE, half_width);
            let [x, y] = [x, y].map(|along| quotient(across * (along << bits), distance));
            return [x, y, rest(across)];
        }
        if let Some([across, direction @ ..]) = mark_at([x, y], inner, mark) {
            let [x, y] = direction.map(|along| (across * along) >> 14);
            return [x, y, rest(across)];
        }
        // A dome with a sine of 1/4 at the rim: 1 - s/2 - s²/8 for √(1 - s).
        let [x, y] = [x, y].map(|along| quotient(along * (ONE / 4), diameter));
        let square = (x * x + y * y) >> 15;
        [x, y, ONE - (square >> 1) - ((square * square) >> 18)]
    }
}

/// √(1 - x²).
fn rest(x: i32) -> i32 {
    (ONE * ONE - x * x).cast_unsigned().isqrt().cast_signed()
}

/// The place across a mark, from -1 to 1 in units of 2^-15, and the direction across it in units of
/// 2^-14; `None` where there is no mark. Marks are 30 degrees apart and end at a distance of two
/// widths from `inner`, lengths in half pixels.
fn mark_at([x, y]: [i32; 2], inner: i32, half_width: i32) -> Option<[i32; 3]> {
    if half_width == 0 {
        return None;
    }
    // The eighth of the plane between 0 and 45 degrees has the marks at 0 and 30 degrees.
    let (a, b) = (x.abs().max(y.abs()), x.abs().min(y.abs()));
    let aslant = b * COSINE - a * SINE;
    let (across, along, direction) = if b << 14 <= aslant.abs() {
        (b << 14, a << 14, [0, 1 << 14])
    } else {
        (aslant, a * COSINE + b * SINE, [-SINE, COSINE])
    };
    let outer = inner - 4 * half_width;
    if across.abs() >= half_width << 14 || !((outer * 3 / 4) << 14..outer << 14).contains(&along) {
        return None;
    }
    let [of_a, of_b] = direction;
    let [of_x, of_y] = if x.abs() >= y.abs() { [of_a, of_b] } else { [of_b, of_a] };
    Some([quotient(across * 2, half_width), of_x * sign(x), of_y * sign(y)])
}

/// a / b, where b is above 0: the compiler cannot prove it, and would link a panic.
fn quotient(a: i32, b: i32) -> i32 {
    a.checked_div(b).unwrap_or_default()
}

const fn sign(x: i32) -> i32 {
    if x < 0 { -1 } else { 1 }
}

//! Turns light about the view axis: a rotation of each pair of orders m and -m.

use super::exchange::LARGEST;
use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::float;
use crate::index::light;
use crate::light::{Light, degree};

/// Up to a degree of at most 12, for each order m a first step, then one for each degree l from m
/// on. All are literals: the compiler would keep the longest loops, and addresses with them.
macro_rules! unrolled {
    ($m:ident in 1..=$degree:ident { $first:block $l:ident => $step:expr }) => {
        $crate::turn::about_view::unrolled!(@ $m $degree $l $first $step;
            1 [0 1 2 3 4 5 6 7 8 9 10 11] 2 [0 1 2 3 4 5 6 7 8 9 10] 3 [0 1 2 3 4 5 6 7 8 9]
            4 [0 1 2 3 4 5 6 7 8] 5 [0 1 2 3 4 5 6 7] 6 [0 1 2 3 4 5 6] 7 [0 1 2 3 4 5]
            8 [0 1 2 3 4] 9 [0 1 2 3] 10 [0 1 2] 11 [0 1] 12 [0])
    };
    (@ $m:ident $degree:ident $l:ident $first:block $step:expr; $($order:literal $above:tt)*) => {
        $({
            let $m: usize = $order;
            if $m <= $degree {
                $first
                $crate::turn::about_view::unrolled!(# $m $degree $l $step; $above);
            }
        })*
    };
    (# $m:ident $degree:ident $l:ident $step:expr; [$($above:literal)*]) => {
        $({
            let $l: usize = $m + $above;
            if $l <= $degree {
                $step;
            }
        })*
    };
}
pub(crate) use unrolled;

impl Light<'_> {
    /// The coefficients of this light after a rotation about the view axis z, from x toward y, by
    /// the angle with this cosine and sine: [`turned`](Self::turned) at a fraction of its cost. Cosine
    /// and sine are scaled to length 1.
    ///
    /// ```
    /// use eigenshade::Light;
    ///
    /// let light = Light::new(&[3.5, 0.0, 0.0, 1.0])?; // brightest at the left
    /// let turned = light.turned_about_view::<4>([0.0, 1.0])?; // now from below
    /// assert_eq!(turned.as_slice(), [3.5, 1.0, 0.0, 0.0]);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: four products for each degree and order above 0. If `N` is (degree + 1)² itself, no
    /// loop is left to degree 12.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is below (degree + 1)², [`Error::Rotation`] if cosine² + sine²
    /// differs from 1 by more than 2 %.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [f32; 2],
    ) -> Result<Buffer<f32, N>, Error> {
        let mut turned = zeros::<f32, N>(Argument::Light, light::count(self.degree()))?;
        match turned.as_mut_slice().try_into() {
            Ok(all) => self.turn_about_view_into::<N>(angle, all)?,
            Err(_) => self.turn_in_loops(unit(angle)?, &mut turned),
        }
        Ok(turned)
    }

    /// [`turned_about_view`](Self::turned_about_view) into existing coefficients, without moving
    /// them.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `N` is (degree + 1)², [`Error::Rotation`] as above.
    pub fn turn_about_view_into<const N: usize>(
        &self,
        angle: [f32; 2],
        turned: &mut [f32; N],
    ) -> Result<(), Error> {
        let Ok(from) = <&[f32; N]>::try_from(self.coefficients()) else {
            let expected = light::count(self.degree());
            return Err(Error::Length { argument: Argument::Light, expected, found: N });
        };
        // No light has another length.
        let degree = const { if let Ok(degree) = degree(N) { degree } else { 0 } };
        let angle = unit(angle)?;
        if degree > LARGEST {
            self.turn_in_loops(angle, turned);
            return Ok(());
        }
        let mut multiple = [1.0, 0.0];
        means(degree, from, turned);
        unrolled!(m in 1..=degree {
            { multiple = product(multiple, angle) }
            l => pair(m, l, multiple, from, turned)
        });
        Ok(())
    }

    /// The same for a degree that is known at run time.
    #[inline(never)]
    fn turn_in_loops(&self, angle: [f32; 2], turned: &mut [f32]) {
        let (degree, from) = (self.degree(), self.coefficients());
        means(degree, from, turned);
        let mut multiple = angle;
        for m in 1..=degree {
            (m..=degree).for_each(|l| pair(m, l, multiple, from, turned));
            multiple = product(multiple, angle);
        }
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned_about_view`] in each channel.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [f32; 2],
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        self.each_ref().try_map(|light| light.turned_about_view::<N>(angle))
    }
}

/// A vector scaled to length 1, from which its square may be off by 2 %: 1/√(1 + e) by its first
/// terms, to within 3e-6.
fn unit([c, s]: [f32; 2]) -> Result<[f32; 2], Error> {
    let [most, half, next] = [0.02, -0.5, 0.375];
    let off = c * c + s * s - 1.0;
    if !(-most..=most).contains(&off) {
        return Err(Error::Rotation);
    }
    let scale = float::add_product(1.0, off, float::add_product(half, off, next));
    Ok([scale * c, scale * s])
}

/// Copies the coefficients of order 0.
#[inline(always)]
fn means(degree: usize, from: &[f32], turned: &mut [f32]) {
    for l in 0..=degree {
        let place = light::position(l, 0);
        if let (Some(to), Some(&mean)) = (turned.get_mut(place), from.get(place)) {
            *to = mean;
        }
    }
}

/// Turns the orders -m and m of degree l by this multiple of the angle.
#[inline(always)]
fn pair(m: usize, l: usize, [c, s]: [f32; 2], from: &[f32], turned: &mut [f32]) {
    // The harmonics of odd m > 0 have the sign -1.
    let s = if m.is_multiple_of(2) { s } else { -s };
    let first = light::position(l, -m.cast_signed());
    let pair = first..=first + 2 * m;
    if let (Some(&[minus, .., plus]), Some([to_minus, .., to_plus])) =
        (from.get(pair.clone()), turned.get_mut(pair))
    {
        *to_minus = minus * c - plus * s;
        *to_plus = plus * c + minus * s;
    }
}

/// The product of two complex numbers.
#[inline(always)]
fn product([a, b]: [f32; 2], [c, d]: [f32; 2]) -> [f32; 2] {
    [a * c - b * d, b * c + a * d]
}

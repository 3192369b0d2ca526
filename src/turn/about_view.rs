//! Turns light about the view axis.

use super::twist::{self, Twist};
use crate::buffer::{Buffer, zeros};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::float;
use crate::index::light;
use crate::light::Light;

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
    /// loop is left.
    ///
    /// # Errors
    ///
    /// As [`turned`](Self::turned), but [`Error::Beyond`] if the degree is above 12;
    /// [`Error::Rotation`] if cosine² + sine² differs from 1 by more than 2 %.
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [f32; 2],
    ) -> Result<Buffer<f32, N>, Error> {
        Error::check_degree(self.degree())?;
        let mut turned = zeros::<f32, N>(Argument::Light, light::count(self.degree()))?;
        match turned.as_mut_slice().try_into() {
            Ok(all) => self.turn_about_view_into::<N>(angle, all)?,
            Err(_) => self.turn_in_loops(Multiple::of(unit(angle)?), &mut turned),
        }
        Ok(turned)
    }

    /// [`turned_about_view`](Self::turned_about_view) into existing coefficients, without moving
    /// them.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `N` is (degree + 1)², [`Error::Beyond`] and [`Error::Rotation`] as
    /// above.
    pub fn turn_about_view_into<const N: usize>(
        &self,
        angle: [f32; 2],
        turned: &mut [f32; N],
    ) -> Result<(), Error> {
        let Ok(from) = <&[f32; N]>::try_from(self.coefficients()) else {
            let expected = light::count(self.degree());
            return Err(Error::Length { argument: Argument::Light, expected, found: N });
        };
        Error::check_degree(self.degree())?;
        twist::turn_unrolled(Multiple::of(unit(angle)?), from, turned);
        Ok(())
    }

    /// The same for a degree that is known at run time.
    #[inline(never)]
    fn turn_in_loops(&self, multiple: Multiple, turned: &mut [f32]) {
        twist::turn(multiple, self.degree(), self.coefficients(), turned);
    }
}

impl Rgb<Light<'_>> {
    /// [`Light::turned_about_view`] in each channel.
    ///
    /// # Errors
    ///
    /// As [`Light::turned_about_view`].
    pub fn turned_about_view<const N: usize>(
        &self,
        angle: [f32; 2],
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        self.each_ref().try_map(|light| light.turned_about_view::<N>(angle))
    }
}

/// Cosine and sine of an angle and of a multiple of it.
struct Multiple {
    angle: [f32; 2],
    multiple: [f32; 2],
}

impl Multiple {
    #[inline(always)]
    const fn of(angle: [f32; 2]) -> Self {
        Self { angle, multiple: [1.0, 0.0] }
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

impl Twist for Multiple {
    type Coefficient = f32;
    type Factor = [f32; 2];
    #[inline(always)]
    fn zonal(&self, coefficient: f32) -> f32 {
        coefficient
    }
    #[inline(always)]
    fn factor(&mut self, _: usize) -> [f32; 2] {
        let ([a, b], [c, s]) = (self.multiple, self.angle);
        self.multiple = [a * c - b * s, b * c + a * s];
        self.multiple
    }
    #[inline(always)]
    fn pair(&self, [c, s]: [f32; 2], [x, y]: [f32; 2]) -> ([f32; 2], bool) {
        ([x * c - y * s, y * c + x * s], true)
    }
}

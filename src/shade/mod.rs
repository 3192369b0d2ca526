//! Shades many normals at a time, in loops that the compiler can vectorize.

mod color;

use crate::checked_slice::padded;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::float;
use crate::normal::{Normal, Normals};
use crate::polynomial;
use crate::polynomial::argument;
use crate::scene::{Descent, Scene};

/// Normals in one block: enough to keep the vector registers of the target busy.
const BLOCK: usize = if cfg!(target_feature = "avx512f") {
    64
} else if cfg!(target_feature = "avx2") {
    32
} else if cfg!(target_arch = "x86_64") {
    20
} else if cfg!(any(target_arch = "aarch64", target_feature = "simd128")) {
    16
} else {
    SCALAR
};

/// Normals in one block without vector registers.
const SCALAR: usize = 4;

/// Whether normals are shaded faster one by one, in loops specialized for a table.
pub(crate) const ONE_BY_ONE: bool = BLOCK == SCALAR;

/// Whether blocks are inlined and many: on targets where code may be large.
const LARGE: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

impl<B> Scene<'_, B> {
    /// The irradiance of one normal, in the unit of the light's radiance times steradian times the
    /// material's 1/sr.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> f32
    where
        B: AsRef<[f32]>,
    {
        let Normal { x, y, z } = normal;
        let [irradiance] = block(self.descent(), &[x], &[y], &[z]);
        irradiance
    }

    /// Writes the irradiance of each normal into `irradiance`.
    ///
    /// The sums have the same order as in [`shade`](Self::shade), so the results agree to the last
    /// bit. With WebAssembly's `relaxed-simd`, `shade` of a generated table may differ in the last
    /// bits.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, Normals, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let scene = sphere::collapse(&sphere::project(&light, &Material::new(&[2.0])?)?);
    /// let mut irradiance = [0.0; 2];
    /// let normals = Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.8])?;
    /// scene.shade_slice(normals, &mut irradiance)?;
    /// assert!(irradiance[0] > irradiance[1]);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(&self, normals: Normals<'_>, irradiance: &mut [f32]) -> Result<(), Error>
    where
        B: AsRef<[f32]>,
    {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        blocks(self.descent(), normals, irradiance);
        Ok(())
    }
}

impl<C> Rgb<Scene<'_, C>> {
    /// [`Scene::shade`] in each channel.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> Rgb<f32>
    where
        C: AsRef<[f32]>,
    {
        self.each_ref().map(|scene| scene.shade(normal))
    }
}

/// Shades normals block by block.
#[inline(never)]
fn blocks(polynomials: Descent<'_>, normals: Normals<'_>, irradiance: &mut [f32]) {
    let block = if LARGE { block::<BLOCK> } else { one_block };
    let [(x, x_rest), (y, y_rest), (z, z_rest)] =
        [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<BLOCK>);
    let (out, out_rest) = irradiance.as_chunks_mut::<BLOCK>();
    for (((x, y), z), out) in x.iter().zip(y).zip(z).zip(out) {
        *out = block(polynomials, x, y, z);
    }
    if !out_rest.is_empty() {
        let [x, y, z] = [padded(x_rest), padded(y_rest), padded(z_rest)];
        for (out, value) in out_rest.iter_mut().zip(block(polynomials, &x, &y, &z)) {
            *out = value;
        }
    }
}

/// [`block`], compiled once per program, for targets where code must be small.
#[inline(never)]
fn one_block(
    polynomials: Descent<'_>,
    x: &[f32; BLOCK],
    y: &[f32; BLOCK],
    z: &[f32; BLOCK],
) -> [f32; BLOCK] {
    block(polynomials, x, y, z)
}

/// The irradiances of a block of normals: Re Σ_m (P_m + i Q_m) w̄^m with w = n_x + i n_y, by
/// Horner's rule from the highest azimuth down.
#[inline(always)]
pub(crate) fn block<const N: usize>(
    mut polynomials: Descent<'_>,
    x: &[f32; N],
    y: &[f32; N],
    z: &[f32; N],
) -> [f32; N] {
    let block = Block::new([x, y, z]);
    let Some((plus, minus)) = polynomials.next() else {
        return block.values(polynomials.pole);
    };
    let mut above = [block.values(plus), block.values(minus)];
    for (plus, minus) in polynomials.by_ref() {
        above = block.azimuth(plus, minus, Some(above));
    }
    block.pole(polynomials.pole, Some(above))
}

/// A block of normals, with the arguments of the polynomials.
#[derive(Clone, Copy, Debug)]
pub struct Block<'n, const N: usize> {
    x: &'n [f32; N],
    y: &'n [f32; N],
    t: [f32; N],
    u: [f32; N],
}

impl<'n, const N: usize> Block<'n, N> {
    /// The block of these normals, axis by axis.
    #[inline(always)]
    #[must_use]
    pub fn new([x, y, z]: [&'n [f32; N]; 3]) -> Self {
        let t = if LARGE { vectorized(z) } else { z.map(argument) };
        let mut u = t;
        for u in &mut u {
            *u = polynomial::doubled(*u);
        }
        Self { x, y, t, u }
    }

    /// The values of a polynomial.
    #[inline(always)]
    fn values(&self, terms: &[f32]) -> [f32; N] {
        polynomial::values(terms, [&self.t, &self.u])
    }

    /// P_m + i Q_m + w̄ `above`, from the polynomials of +m and of -m. The highest azimuth has
    /// nothing above it.
    #[inline(always)]
    #[must_use]
    pub fn azimuth(
        &self,
        plus: &[f32],
        minus: &[f32],
        above: Option<[[f32; N]; 2]>,
    ) -> [[f32; N]; 2] {
        let here = [self.values(plus), self.values(minus)];
        let Some([mut real, mut imaginary]) = above else { return here };
        float::descend([&mut real, &mut imaginary], here, [self.x, self.y]);
        [real, imaginary]
    }

    /// P_0 + Re w̄ `above`.
    #[inline(always)]
    #[must_use]
    pub fn pole(&self, terms: &[f32], above: Option<[[f32; N]; 2]>) -> [f32; N] {
        let mut sums = self.values(terms);
        let Some([real, imaginary]) = above else { return sums };
        let above = real.iter().zip(&imaginary).zip(self.x.iter().zip(self.y));
        for (sum, ((&real, &imaginary), (&x, &y))) in sums.iter_mut().zip(above) {
            *sum = float::add_product(float::add_product(*sum, real, x), imaginary, y);
        }
        sums
    }
}

/// The argument t of each normal. A loop, because `map` may become a call.
#[inline(always)]
fn vectorized<const N: usize>(z: &[f32; N]) -> [f32; N] {
    let mut t = [0.0; N];
    for (t, &z) in t.iter_mut().zip(z) {
        *t = argument(z);
    }
    t
}

/// How to handle irradiance below zero.
///
/// No light gives negative irradiance. Negative values result from lights and materials that end at
/// some degree and order, from fits, and from few components. Values are clamped only on request:
/// negative values show that an image is at its limits, and estimates from pixels need them.
///
/// ```
/// use eigenshade::screen::NegativePolicy;
///
/// let mut image = [0.5, -0.25];
/// assert_eq!(NegativePolicy::Clamped.apply(&mut image), Some(-0.25));
/// assert_eq!(image, [0.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum NegativePolicy {
    /// Keep negative values.
    #[default]
    Kept,
    /// Set negative values to zero.
    Clamped,
}

impl NegativePolicy {
    /// Applies this policy to one irradiance, a float or an integer. NaN stays NaN.
    #[inline]
    #[must_use]
    pub fn of<T: Copy + Default + PartialOrd>(self, irradiance: T) -> T {
        let zero = T::default();
        if self == Self::Clamped && irradiance < zero { zero } else { irradiance }
    }

    /// Applies this policy to many irradiances in place. Returns the smallest of the original
    /// values, ignoring NaN, or `None` if there are none.
    pub fn apply<T: Copy + Default + PartialOrd>(self, irradiance: &mut [T]) -> Option<T> {
        let mut least = None;
        for value in irradiance {
            let is_number = value.partial_cmp(&value).is_some();
            if is_number && least.is_none_or(|least| *value < least) {
                least = Some(*value);
            }
            *value = self.of(*value);
        }
        least
    }
}

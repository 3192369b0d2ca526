//! Materials of glTF: base color, metallic and roughness.
//!
//! With f0 = 0.04 + (base color - 0.04) metallic and albedo = base color (1 - metallic), the BRDF
//! of appendix B of the glTF 2.0 specification is linear in albedo (1 - f0), 1 and f0. The
//! coefficients of the BRDF are therefore
//!
//! b = albedo (1 - f0) matte + rim(roughness) + f0 metal(roughness),
//!
//! where rim and metal are smooth in roughness: sums of Chebyshev polynomials over \[0.2, 1\].

use crate::buffer::Buffer;
use crate::checked_slice::{part, part_mut};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::gloss::Gloss;
use crate::index::material::count;
use crate::material::Material;
use crate::q15;
use crate::q15::Q15;
use crate::q15::{MaterialBuffer, mantissas};

include!(concat!(env!("OUT_DIR"), "/metallic_roughness.rs"));

/// The least roughness of the series.
const LEAST: f32 = 0.2;

/// The parts of `N` coefficients, as sums of `K` polynomials.
struct Series<const N: usize, const K: usize> {
    matte: [f32; N],
    rim: [[f32; N]; K],
    metal: [[f32; N]; K],
}

/// A [`Series`] in integers, in which rim and metal are multiplied by roughness²: mantissas as
/// fractions of 2^15, for each part and order an exponent, and for each polynomial the bits by
/// which its mantissas are finer.
struct IntegerSeries<const N: usize, const O: usize, const K: usize> {
    exponents: [[i8; O]; 3],
    finer: [u8; K],
    matte: [i16; N],
    rim: [[i16; N]; K],
    metal: [[i16; N]; K],
}

impl Material<'_> {
    /// A glTF material of order 7: a GGX lobe over a matte base, from its linear base color,
    /// metallic and roughness, all from 0 to 1.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::presets::light::LOBBY;
    /// use eigenshade::{Material, Normal, sphere};
    ///
    /// let copper = Material::metallic_roughness([0.93, 0.52, 0.38], 1.0, 0.4)?;
    /// let scene = sphere::color::scene(LOBBY, copper.materials()?)?;
    /// let color = scene.shade(Normal::new(0.0, 0.0, 1.0)?);
    /// assert!(color.r > color.g && color.g > color.b);
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// A picture differs by at most 2e-4 of its largest irradiance from one with the coefficients
    /// of the program's `eigenshade material ggx`. A roughness below 0.2 is drawn as 0.2: its
    /// highlight is narrower than order 7 can represent. Cost: some 1,000 multiplications, and 4 KB
    /// of tables.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn metallic_roughness(
        base_color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Rgb<Buffer<f32, 40>>, Error> {
        ORDER_7.material(base_color, metallic, roughness)
    }

    /// The parts matte, rim and metal, to order 7. Every glTF material of a roughness is a weighted
    /// sum of the three parts.
    ///
    /// Transfers are linear in the material. A material of another color or share of metal needs no
    /// new transfer, only a sum of the transfers of the three parts. A material of another
    /// roughness needs two new transfers, of rim and of metal, however many channels the material
    /// has.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::presets::light::PARK;
    /// use eigenshade::{Material, Transfer, sphere};
    ///
    /// let [matte, rim, metal] = Material::metallic_roughness_parts(0.4)?;
    /// let parts = [
    ///     sphere::transfer(&Material::new(&matte)?)?, // the same for every roughness
    ///     sphere::transfer(&Material::new(&rim)?)?,
    ///     sphere::transfer(&Material::new(&metal)?)?,
    /// ];
    /// for color in [[0.93, 0.52, 0.38], [1.0, 0.78, 0.34]] {
    ///     let shares = Material::metallic_roughness_shares(color, 1.0)?;
    ///     let transfer = shares.try_map(|shares| Transfer::sum(parts.each_ref(), shares))?;
    ///     let scene = sphere::color::relight(&transfer, PARK)?;
    ///     assert!(scene.shade(eigenshade::Normal::new(0.0, 0.6, 0.8)?).r > 0.0);
    /// }
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// A roughness below 0.2 counts as 0.2. Cost: 960 multiplications; with the shipped table,
    /// 1,704 for a sum of three transfers, where a transfer takes 5,400.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if the roughness is not from 0 to 1.
    pub fn metallic_roughness_parts(roughness: f32) -> Result<[Buffer<f32, 40>; 3], Error> {
        ORDER_7.parts(roughness)
    }

    /// [`metallic_roughness_parts`](Self::metallic_roughness_parts) for tables of order 12: 3,920
    /// multiplications; the same errors.
    pub fn metallic_roughness_parts_of_order_12(
        roughness: f32,
    ) -> Result<[Buffer<f32, 140>; 3], Error> {
        ORDER_12.parts(roughness)
    }

    /// How much of the [parts](Self::metallic_roughness_parts) matte, rim and metal a glTF material
    /// has in each channel, from its linear base color and metallic.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is not from 0 to 1.
    pub fn metallic_roughness_shares(
        base_color: [f32; 3],
        metallic: f32,
    ) -> Result<Rgb<[f32; 3]>, Error> {
        shares(base_color, metallic)
    }

    /// [`metallic_roughness`](Self::metallic_roughness) for tables of order 12: some 4,000
    /// multiplications, and 16 KB of tables; the same errors.
    pub fn metallic_roughness_of_order_12(
        base_color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Rgb<Buffer<f32, 140>>, Error> {
        ORDER_12.material(base_color, metallic, roughness)
    }
}

impl q15::Material<'_> {
    /// [`Material::metallic_roughness`](crate::Material::metallic_roughness) in integers: a picture
    /// of the coefficients differs by at most 6e-4 of its largest irradiance from the picture of
    /// the formula's coefficients.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is below 0.
    pub fn metallic_roughness(
        base_color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<40, 8>>, Error> {
        ORDER_7_Q15.material(base_color, metallic, roughness)
    }

    /// Sums of matte, rim and metal with these shares; that of rim is 0 or counts as 1.
    pub(crate) fn metallic_roughness_sums(
        roughness: Q15,
        shares: [[Q15; 3]; 2],
    ) -> Result<[MaterialBuffer<40, 8>; 2], Error> {
        ORDER_7_Q15.sums(roughness, shares.map(|shares| shares.map(|Q15(share)| i32::from(share))))
    }

    /// [`metallic_roughness`](Self::metallic_roughness) for tables of order 12; the same error.
    pub fn metallic_roughness_of_order_12(
        base_color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<140, 13>>, Error> {
        ORDER_12_Q15.material(base_color, metallic, roughness)
    }
}

impl<const N: usize, const K: usize> Series<N, K> {
    fn material(
        &self,
        color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        let shares = shares(color, metallic)?;
        let [rim, metal] = self.at(roughness)?;
        Ok(shares.map(|[of_matte, _, of_metal]| {
            let mut sum = rim;
            for ((sum, matte), metal) in sum.iter_mut().zip(&self.matte).zip(metal) {
                *sum += of_matte * matte + of_metal * metal;
            }
            Buffer::from(sum)
        }))
    }

    /// The parts rim and metal at a roughness. Inlined: the arrays would be copied.
    #[inline(always)]
    fn at(&self, roughness: f32) -> Result<[[f32; N]; 2], Error> {
        Error::check_range(Argument::Roughness, [roughness], [0.0, 1.0])?;
        let x = 2.5 * roughness.max(LEAST) - 1.5;
        let [mut before, mut now] = [x, 1.0];
        let (mut rim, mut metal) = ([0.0; N], [0.0; N]);
        for (of_rim, of_metal) in self.rim.iter().zip(&self.metal) {
            for (sum, part) in rim.iter_mut().zip(of_rim) {
                *sum += now * part;
            }
            for (sum, part) in metal.iter_mut().zip(of_metal) {
                *sum += now * part;
            }
            // T_1 = x T_0, T_(k+1) = 2 x T_k - T_(k-1), where T_(-1) = T_1.
            (before, now) = (now, 2.0 * x * now - before);
        }
        Ok([rim, metal])
    }

    fn parts(&self, roughness: f32) -> Result<[Buffer<f32, N>; 3], Error> {
        let [rim, metal] = self.at(roughness)?;
        Ok([self.matte, rim, metal].map(Buffer::from))
    }
}

/// How much of matte, rim and metal each channel of a material has.
fn shares(color: [f32; 3], metallic: f32) -> Result<Rgb<[f32; 3]>, Error> {
    Error::check_range(Argument::Color, color, [0.0, 1.0])?;
    Error::check_range(Argument::Metallic, [metallic], [0.0, 1.0])?;
    Ok(Rgb::from(color).map(|base| {
        let f0 = Gloss::DIELECTRIC + (base - Gloss::DIELECTRIC) * metallic;
        [base * (1.0 - metallic) * (1.0 - f0), 1.0, f0]
    }))
}

impl<const N: usize, const O: usize, const K: usize> IntegerSeries<N, O, K> {
    fn material(
        &self,
        color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<N, O>>, Error> {
        const OF_DIELECTRIC: i32 = (Gloss::DIELECTRIC * ONE as f32 + 0.5) as i32;
        let range = [Q15(0), Q15(i16::MAX)];
        Error::check_range(Argument::Color, color, range)?;
        Error::check_range(Argument::Metallic, [metallic], range)?;
        let metallic = i32::from(metallic.0);
        let shares = color.map(|base| {
            let base = i32::from(base.0);
            let f0 = OF_DIELECTRIC + times(base - OF_DIELECTRIC, metallic);
            [times(times(base, ONE - metallic), ONE - f0), ONE, f0]
        });
        self.sums(roughness, shares).map(Rgb::from)
    }

    /// Sums of matte, rim and metal with these shares, in units of 2^-15. That of rim is 0 or 1.
    fn sums<const C: usize>(
        &self,
        roughness: Q15,
        shares: [[i32; 3]; C],
    ) -> Result<[MaterialBuffer<N, O>; C], Error> {
        const OF_LEAST: i32 = (LEAST * ONE as f32 + 0.5) as i32;
        Error::check_range(Argument::Roughness, [roughness], [Q15(0), Q15(i16::MAX)])?;
        let roughness = i32::from(roughness.0).max(OF_LEAST);
        // 1 / roughness² is this fraction of 2^16, between a half and one, times 2^raised.
        let square = (roughness * roughness).cast_unsigned();
        let zeros = square.leading_zeros();
        let raised = zeros as i8 - 1;
        let weight = i64::from((1u32 << 31).checked_div(square >> (16 - zeros)).unwrap_or(0));
        // Polynomials as fractions of 2^30.
        let x = (i64::from(5 * roughness) << 14) - (3 << 29);
        let [mut before, mut now] = [x, 1 << 30];
        let (mut rim, mut metal) = ([0; N], [0; N]);
        for ((of_rim, of_metal), finer) in self.rim.iter().zip(&self.metal).zip(self.finer) {
            let term = ((now * weight + (1 << 30)) >> 31) as i32;
            for (sum, &part) in rim.iter_mut().zip(of_rim) {
                *sum += (term * i32::from(part)) >> finer;
            }
            for (sum, &part) in metal.iter_mut().zip(of_metal) {
                *sum += (term * i32::from(part)) >> finer;
            }
            (before, now) = (now, ((x * now) >> 29) - before);
        }
        Ok(shares.map(|[matte, of_rim_share, f0]| {
            let mut material = MaterialBuffer { exponents: [0; O], mantissas: [Q15(0); N] };
            let [of_matte, of_rim, of_metal] = &self.exponents;
            let exponents = of_matte.iter().zip(of_rim).zip(of_metal);
            let mut start = 0;
            for (o, (((&of_matte, &of_rim), &of_metal), to)) in
                exponents.zip(&mut material.exponents).enumerate()
            {
                let places = start..count(o);
                start = places.end;
                let [of_rim, of_metal] = [of_rim, of_metal].map(|exponent| exponent + raised);
                // A sum of three parts has two bits more than the largest.
                let top = of_matte.max(of_rim).max(of_metal) + 2;
                let down = |number: i32, of_part: i8| number >> (top - of_part).min(31);
                let parts = part(&self.matte, places.clone())
                    .iter()
                    .zip(part(&rim, places.clone()))
                    .zip(part(&metal, places.clone()));
                let sums = parts.map(|((&in_matte, &in_rim), &in_metal)| {
                    let in_metal = f0 * ((in_metal + (ONE >> 1)) >> 15);
                    let in_matte = matte * i32::from(in_matte);
                    let in_rim = if of_rim_share > 0 { in_rim } else { 0 };
                    let sum =
                        down(in_matte, of_matte) + down(in_rim, of_rim) + down(in_metal, of_metal);
                    (sum, i32::from(top) - 30)
                });
                let exponent = mantissas(sums, part_mut(&mut material.mantissas, places));
                *to = exponent as i8;
            }
            material
        }))
    }
}

/// 1 in units of 2^-15.
const ONE: i32 = 1 << 15;

/// The rounded product of two numbers in units of 2^-15.
fn times(a: i32, b: i32) -> i32 {
    (a * b + (ONE >> 1)) >> 15
}

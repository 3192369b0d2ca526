//! Materials of glTF: base color, metallic and roughness.
//!
//! With f0 = 0.04 + (base color - 0.04) metallic and albedo = base color (1 - metallic), the BRDF of
//! appendix B of the glTF 2.0 specification is linear in albedo (1 - f0), 1 and f0. Its coefficients
//! are therefore
//!
//! b = albedo (1 - f0) matte + rim(roughness) + f0 metal(roughness),
//!
//! where rim and metal are smooth in roughness: sums of Chebyshev polynomials over \[0.2, 1\].

use crate::buffer::Buffer;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::format::Q15;
use crate::index::material::count;
use crate::invariant::{part, part_mut};
use crate::material::Material;
use crate::quantized::{self, MaterialBuffer, mantissas};

include!(concat!(env!("OUT_DIR"), "/metallic_roughness.rs"));

/// The reflectance of dielectrics at normal incidence.
const DIELECTRIC: f32 = 0.04;

/// The least roughness of the series.
const LEAST: f32 = 0.2;

/// The parts of `N` coefficients, as sums of `K` polynomials.
struct Series<const N: usize, const K: usize> {
    matte: [f32; N],
    rim: [[f32; N]; K],
    metal: [[f32; N]; K],
}

/// A [`Series`] in integers: mantissas as fractions of 2^15, for each part and order an exponent, and
/// for each polynomial the bits by which its mantissas are finer.
struct IntegerSeries<const N: usize, const O: usize, const K: usize> {
    exponents: [[i8; O]; 3],
    finer: [u8; K],
    matte: [i16; N],
    rim: [[i16; N]; K],
    metal: [[i16; N]; K],
}

impl Material<'_, f32> {
    /// A glTF material of order 7: a GGX lobe over a matte base, from its linear base color, metallic
    /// and roughness, all from 0 to 1.
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
    /// A picture differs by at most 1e-3 of its largest irradiance from one with the coefficients of
    /// the program's `eigenshade material ggx`. A roughness below 0.2 is drawn as 0.2: its highlight
    /// is narrower than order 7 can represent. Cost: some 1,000 multiplications, and 4 KB of tables.
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

    /// [`metallic_roughness`](Self::metallic_roughness) for tables of order 12: some 4,000
    /// multiplications, and 16 KB of tables.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn metallic_roughness_of_order_12(
        base_color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Rgb<Buffer<f32, 140>>, Error> {
        ORDER_12.material(base_color, metallic, roughness)
    }
}

impl quantized::Material<'_, Q15> {
    /// [`Material::metallic_roughness`](crate::Material::metallic_roughness) in integers: a picture
    /// of the coefficients differs by at most 1.5e-3 of its largest irradiance from that of the
    /// formula's.
    ///
    /// # Errors
    ///
    /// [`Error::Outside`] if a number is below 0.
    pub fn metallic_roughness(
        base_color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<Q15, 40, 8>>, Error> {
        ORDER_7_Q15.material(base_color, metallic, roughness)
    }

    /// [`metallic_roughness`](Self::metallic_roughness) for tables of order 12.
    ///
    /// # Errors
    ///
    /// The same.
    pub fn metallic_roughness_of_order_12(
        base_color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<Q15, 140, 13>>, Error> {
        ORDER_12_Q15.material(base_color, metallic, roughness)
    }
}

/// Checks that all parameters are from 0 to the number one.
fn check<T: PartialOrd + Copy>(
    color: [T; 3],
    metallic: T,
    roughness: T,
    [zero, one]: [T; 2],
) -> Result<(), Error> {
    let fits = |number: T| number >= zero && number <= one;
    let parameters = [
        (Argument::Color, color.into_iter().all(fits)),
        (Argument::Metallic, fits(metallic)),
        (Argument::Roughness, fits(roughness)),
    ];
    match parameters.into_iter().find(|(_, fits)| !fits) {
        Some((argument, _)) => Err(Error::Outside { argument }),
        None => Ok(()),
    }
}

impl<const N: usize, const K: usize> Series<N, K> {
    fn material(
        &self,
        color: [f32; 3],
        metallic: f32,
        roughness: f32,
    ) -> Result<Rgb<Buffer<f32, N>>, Error> {
        check(color, metallic, roughness, [0.0, 1.0])?;
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
        Ok(Rgb::from(color).map(|base| {
            let f0 = DIELECTRIC + (base - DIELECTRIC) * metallic;
            let matte = base * (1.0 - metallic) * (1.0 - f0);
            let mut sum = rim;
            for ((sum, of_matte), of_metal) in sum.iter_mut().zip(&self.matte).zip(metal) {
                *sum += matte * of_matte + f0 * of_metal;
            }
            Buffer::from(sum)
        }))
    }
}

impl<const N: usize, const O: usize, const K: usize> IntegerSeries<N, O, K> {
    fn material(
        &self,
        color: [Q15; 3],
        metallic: Q15,
        roughness: Q15,
    ) -> Result<Rgb<MaterialBuffer<Q15, N, O>>, Error> {
        const ONE: i32 = 1 << 15;
        const OF_DIELECTRIC: i32 = (DIELECTRIC * ONE as f32 + 0.5) as i32;
        const OF_LEAST: i32 = (LEAST * ONE as f32 + 0.5) as i32;
        check(color, metallic, roughness, [Q15(0), Q15(i16::MAX)])?;
        // Polynomials as fractions of 2^30.
        let roughness = i32::from(roughness.0).max(OF_LEAST);
        let x = (i64::from(5 * roughness) << 14) - (3 << 29);
        let [mut before, mut now] = [x, 1 << 30];
        let (mut rim, mut metal) = ([0; N], [0; N]);
        for ((of_rim, of_metal), finer) in self.rim.iter().zip(&self.metal).zip(self.finer) {
            let term = ((now + (1 << 14)) >> 15) as i32;
            for (sum, &part) in rim.iter_mut().zip(of_rim) {
                *sum += (term * i32::from(part)) >> finer;
            }
            for (sum, &part) in metal.iter_mut().zip(of_metal) {
                *sum += (term * i32::from(part)) >> finer;
            }
            (before, now) = (now, ((x * now) >> 29) - before);
        }
        let times = |a: i32, b: i32| (a * b + (ONE >> 1)) >> 15;
        let metallic = i32::from(metallic.0);
        Ok(Rgb::from(color).map(|base| {
            let base = i32::from(base.0);
            let f0 = OF_DIELECTRIC + times(base - OF_DIELECTRIC, metallic);
            let matte = times(times(base, ONE - metallic), ONE - f0);
            let mut material = MaterialBuffer { exponents: [0; O], mantissas: [Q15(0); N] };
            let [of_matte, of_rim, of_metal] = &self.exponents;
            let exponents = of_matte.iter().zip(of_rim).zip(of_metal);
            let mut start = 0;
            for (o, (((&of_matte, &of_rim), &of_metal), to)) in
                exponents.zip(&mut material.exponents).enumerate()
            {
                let places = start..count(o);
                start = places.end;
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

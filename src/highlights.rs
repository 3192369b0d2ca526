//! Shades small sources by a microfacet formula, one lobe for each source.

use crate::buffer::{Buffer, zeros};
use crate::checked_slice::padded;
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::float;
use crate::gloss::Gloss;
use crate::mathematics;
use crate::normal::{Normal, Normals};
use crate::rotation::{cross, dot};
use crate::source::Source;
use core::f32::consts::FRAC_1_PI;

/// The least cosine of the angle between view and half-way direction: a source nearly behind the
/// object would have no half-way direction.
const LEAST_COSINE: f32 = 1.0 / 32.0;

/// A normal with a smaller cosine to a source is not lit. No lobe then divides by 0.
const UNLIT: f32 = 1e-12;

/// Normals that are shaded for one source before the next.
const BLOCK: usize =
    if cfg!(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128")) {
        64
    } else {
        1
    };

/// The reflections of up to `N` small sources on a glossy material.
///
/// The irradiance of one source s at a normal n is
///
/// E (F D V n·s + (1 - F) albedo / π n·s), and 0 where n·s <= 0,
///
/// by the formulas of [`Gloss`] with the half-way direction h of source and view. F is the same for
/// all normals. The source's spread σ blurs the lobe: instead of α² I, D has the matrix
/// A = α² I + κ σ² J² in the plane tangent to h, where J = diag(1/2, 1/(2 cos θ_d)) is how far h
/// moves along and across the plane of source and view, with the angle θ_d between h and the view.
/// So D = 1 / (π √det A (nᵀ Q n)² (1 + c²/2)), Q = h hᵀ + T A⁻¹ Tᵀ with the tangents T at h, and
/// c = σ² / cos² θ_d, which fades a source that spreads around the object's back. Across the plane,
/// A is at most 1.
///
/// A GGX lobe blurred by a normal distribution is not a GGX lobe. κ = 2 + α² / (α² + σ² tr(J²)/2)
/// keeps the error of the peak's height to at most 7.5 %, from points to sources that are much
/// wider than the lobe. A pixel on the flank may be off by more: for spreads to 0.2 rad and a
/// roughness of 0.2, by 20 % of the peak up to 110 degrees from the view, and by 25 % at 140.
///
/// ```
/// # #[cfg(feature = "presets")] {
/// use eigenshade::presets::light::LOBBY;
/// use eigenshade::{Gloss, Highlights, Material, Normal, Source, sphere};
///
/// let (color, metallic, roughness) = ([0.93, 0.52, 0.38], 1.0, 0.25);
/// let lamp = Source::new([0.0, 0.6, 0.8], [0.5; 3], 0.03)?;
///
/// // All light but the lamp.
/// let rest = LOBBY.residual::<100>(&[lamp])?;
/// let copper = Material::metallic_roughness(color, metallic, roughness)?;
/// let scene = sphere::color::scene(rest.lights()?, copper.materials()?)?;
///
/// let gloss = Gloss::metallic_roughness(color, metallic, roughness)?;
/// let highlights = Highlights::<4>::new(&gloss, &[lamp])?;
/// let color = |normal| scene.shade(normal) + highlights.shade(normal);
/// // Half-way between lamp and camera, and elsewhere.
/// let mirrored = color(Normal::new(0.0, 0.316, 0.949)?);
/// assert!(mirrored.r > 2.0 * color(Normal::new(0.0, -0.316, 0.949)?).r);
/// # }
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Highlights<const N: usize> {
    /// Halves of α² and 1 - α².
    pub(crate) masking: [f32; 2],
    pub(crate) lobes: Buffer<Lobe, N>,
}

/// The reflection of one source.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(crate) struct Lobe {
    /// The upper triangle R of Q = Rᵀ R, row by row. Its elements are of the size of the roots of
    /// Q's, so nᵀ Q n as a sum of squares loses half as many digits as by Q.
    pub(crate) form: [f32; 6],
    pub(crate) direction: [f32; 3],
    /// E F / (4 π √det A).
    pub(crate) specular: Rgb<f32>,
    /// E (1 - F) albedo / π.
    pub(crate) matte: Rgb<f32>,
}

impl<const N: usize> Highlights<N> {
    /// The reflections of these sources. Cost: some ten roots for each source.
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if there are more than `N` sources.
    pub fn new(gloss: &Gloss, sources: &[Source]) -> Result<Self, Error> {
        let mut lobes = zeros::<Lobe, N>(Argument::Sources, sources.len())?;
        for (lobe, source) in lobes.iter_mut().zip(sources) {
            *lobe = Lobe::new(gloss, source);
        }
        let half = 0.5;
        let square = gloss.alpha() * gloss.alpha();
        Ok(Self { masking: [half * square, half - half * square], lobes })
    }

    /// The irradiance of one normal by the sources alone, to be added to
    /// [`Scene::shade`](crate::Scene::shade).
    ///
    /// The difference from the formula in exact arithmetic is at most 3e-5 of the peak for the
    /// least roughness, 1e-5 for 0.1, and 3e-6 from 0.3 on. Cost: a root, and for each source that
    /// the normal faces a division and 31 products, including the products of a second root.
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> Rgb<f32> {
        let Rgb { r: [r], g: [g], b: [b] } = self.block(&[normal.x], &[normal.y], &[normal.z]);
        Rgb::new(r, g, b)
    }

    /// Adds the sources' irradiance at each normal to `irradiance`, where `shade_slice` of a scene
    /// has written the irradiance of the rest of the light. The sums equal [`shade`](Self::shade)
    /// to the last bit.
    ///
    /// ```
    /// use eigenshade::{Gloss, Highlights, Normals, Rgb, Source};
    ///
    /// let sun = Source::new([0.6, 0.0, 0.8], [1.0, 0.9, 0.8], 0.005)?;
    /// let gloss = Gloss::metallic_roughness([0.1, 0.1, 0.2], 0.0, 0.3)?;
    /// let highlights = Highlights::<1>::new(&gloss, &[sun])?;
    /// let mut colors = [Rgb::gray(0.25); 2]; // of ambient light
    /// let normals = Normals::new(&[0.0, 0.6], &[0.0, 0.0], &[1.0, 0.8])?;
    /// highlights.add_slice(normals, &mut colors)?;
    /// assert!(colors[1].r > 0.25);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn add_slice(
        &self,
        normals: Normals<'_>,
        irradiance: &mut [Rgb<f32>],
    ) -> Result<(), Error> {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        if self.lobes.is_empty() {
            return Ok(());
        }
        let [(x, x_rest), (y, y_rest), (z, z_rest)] =
            [normals.x, normals.y, normals.z].map(<[f32]>::as_chunks::<BLOCK>);
        let (colors, rest) = irradiance.as_chunks_mut::<BLOCK>();
        for (((x, y), z), colors) in x.iter().zip(y).zip(z).zip(colors) {
            add(&self.block(x, y, z), colors);
        }
        if !rest.is_empty() {
            let [x, y, z] = [padded(x_rest), padded(y_rest), padded(z_rest)];
            add(&self.block(&x, &y, &z), rest);
        }
        Ok(())
    }

    /// The difference from the highlights of the same sources and roughness in another color.
    pub(crate) fn less(mut self, other: &Self) -> Self {
        for (lobe, other) in self.lobes.iter_mut().zip(&other.lobes) {
            let difference = |(a, b): (f32, f32)| a - b;
            lobe.specular = lobe.specular.zip(other.specular).map(difference);
            lobe.matte = lobe.matte.zip(other.matte).map(difference);
        }
        self
    }

    /// The sources that are shaded.
    #[must_use]
    pub fn len(&self) -> usize {
        self.lobes.len()
    }

    /// Whether there are no sources.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lobes.is_empty()
    }

    /// The constants as vectors of a shader: α² and 1 - α², then four of each source. These are the
    /// first row of R and R_22; the direction and R_23; twice the specular color and R_33; the
    /// matte color and 0. Doubled colors leave the root and the divisor without halves.
    pub(crate) fn vectors(&self) -> impl Iterator<Item = [f32; 4]> {
        let [square, rest] = self.masking.map(|half| half + half);
        let lobes = self.lobes.iter().flat_map(|lobe| {
            let ([xx, xy, xz, yy, yz, zz], [x, y, z]) = (lobe.form, lobe.direction);
            let Rgb { r, g, b } = lobe.specular.map(|half| half + half);
            let matte = lobe.matte;
            [[xx, xy, xz, yy], [x, y, z, yz], [r, g, b, zz], [matte.r, matte.g, matte.b, 0.0]]
        });
        core::iter::once([square, rest, 0.0, 0.0]).chain(lobes)
    }

    #[inline(always)]
    fn block<const B: usize>(&self, x: &[f32; B], y: &[f32; B], z: &[f32; B]) -> Rgb<[f32; B]> {
        let mut sums = Rgb::gray([0.0; B]);
        let mut facing = [0.0; B];
        for (facing, &z) in facing.iter_mut().zip(z) {
            *facing = masked(self.masking, positive(z));
        }
        for lobe in &self.lobes {
            let Rgb { r, g, b } = &mut sums;
            let sums = r.iter_mut().zip(g).zip(b);
            let normals = x.iter().zip(y).zip(z).zip(&facing);
            for (((r, g), b), (((&x, &y), &z), &facing)) in sums.zip(normals) {
                let cosine = dot(lobe.direction, [x, y, z]);
                let lit = cosine > UNLIT;
                // Without vectors, a branch is faster than products with zero.
                if B == 1 && !lit {
                    continue;
                }
                let divisor = lobe.divisor(self.masking, [x, y, z], cosine, facing);
                let weight = if lit { cosine / (divisor) } else { 0.0 };
                let cosine = if lit { cosine } else { 0.0 };
                let Lobe { specular, matte, .. } = lobe;
                *r =
                    float::add_product(float::add_product(*r, specular.r, weight), matte.r, cosine);
                *g =
                    float::add_product(float::add_product(*g, specular.g, weight), matte.g, cosine);
                *b =
                    float::add_product(float::add_product(*b, specular.b, weight), matte.b, cosine);
            }
        }
        sums
    }
}

impl Lobe {
    fn new(gloss: &Gloss, source: &Source) -> Self {
        let direction = source.direction();
        let [half, one] = [0.5, 1.0];
        let [x, y, z] = direction;

        // The azimuth of the plane of source and view; any where both are the same line.
        let planar = x * x + y * y;
        let ([ex, ey], radius) = if planar > 1e-30 {
            let scale = mathematics::inverse_root(planar);
            ([x * scale, y * scale], planar * scale)
        } else {
            ([one, 0.0], 0.0)
        };
        // Half the angle between them. The larger of sine and cosine comes from a root, the other
        // one from sin θ, which keeps its digits.
        let root = mathematics::square_root(half + half * if z < 0.0 { -z } else { z });
        let other = half * radius * root.recip();
        let [cosine, sine] = if z < 0.0 { [other, root] } else { [root, other] };
        let least = LEAST_COSINE;
        let cosine = if cosine > least { cosine } else { least };
        let halfway = [sine * ex, sine * ey, cosine];
        let across = [-ey, ex, 0.0];
        let along_half = [cosine * ex, cosine * ey, -sine];

        // A = diag(a11, a22): the blob's covariance spread² I widens the lobe by J Jᵀ. A wider lobe
        // than a uniform one would be brightest far from its middle.
        let wide = source.spread() * source.spread();
        let square = gloss.alpha() * gloss.alpha();
        let quarter = 0.25;
        let far = wide * (cosine * cosine).recip();
        let mean = half * quarter * (wide + far);
        let blur = quarter * (one + one + square * (square + mean).recip());
        let a11 = square + blur * wide;
        let a22 = square + blur * far;
        let a22 = if a22 > one { one } else { a22 };

        // The rows h and A^(-1/2) Tᵀ, whose squares add up to Q.
        let [first, second] = [mathematics::inverse_root(a11), mathematics::inverse_root(a22)];
        let one_row = along_half.map(|t| t * first);
        let other_row = across.map(|t| t * second);

        let fresnel = {
            let rest = one - cosine;
            let square = rest * rest;
            square * square * rest
        };
        // Less of a source that spreads around the object's back, where h is not linear in s.
        let fade = (one + half * far * far).recip();
        let peak = (0.25 * FRAC_1_PI) * first * second * fade;
        let matte = FRAC_1_PI;
        let reflectance = gloss.reflectance().zip(gloss.grazing());
        let parts = source.energy().zip(reflectance).zip(gloss.albedo());
        let parts = parts.map(|((energy, (f0, f90)), albedo)| {
            let reflected = f0 + (f90 - f0) * fresnel;
            [energy * reflected * peak, energy * (one - reflected) * albedo * matte]
        });
        Self {
            form: triangle([halfway, one_row, other_row]),
            direction,
            specular: parts.map(|[specular, _]| specular),
            matte: parts.map(|[_, matte]| matte),
        }
    }

    /// ½ (nᵀ Q n)² (n·s √(α² + (1 - α²) n_z²) + n_z √(α² + (1 - α²) (n·s)²)).
    #[inline(always)]
    fn divisor(&self, masking: [f32; 2], [x, y, z]: [f32; 3], cosine: f32, facing: f32) -> f32 {
        let [xx, xy, xz, yy, yz, zz] = self.form;
        let first = float::add_product(float::add_product(xx * x, xy, y), xz, z);
        let second = float::add_product(yy * y, yz, z);
        let third = zz * z;
        let form =
            float::add_product(float::add_product(third * third, first, first), second, second);
        let masked = float::add_product(cosine * facing, positive(z), masked(masking, cosine));
        form * form * masked
    }
}

/// ½ √(α² + (1 - α²) c²).
#[inline(always)]
fn masked([square, rest]: [f32; 2], cosine: f32) -> f32 {
    float::root_of_half(float::add_product(square, rest, cosine * cosine))
}

/// The number, or 0 if it is negative or NaN.
#[inline(always)]
fn positive(number: f32) -> f32 {
    if number > 0.0 { number } else { 0.0 }
}

/// The upper triangle R with Rᵀ R = Bᵀ B, row by row, from the rows of B, by Gram and Schmidt.
fn triangle(rows: [[f32; 3]; 3]) -> [f32; 6] {
    let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = rows;
    let unit = |column: [f32; 3]| {
        let square = dot(column, column);
        let scale = mathematics::inverse_root(square);
        (square * scale, column.map(|element| element * scale))
    };
    let less = |[a, b, c]: [f32; 3], factor: f32, [u, v, w]: [f32; 3]| {
        [a - factor * u, b - factor * v, c - factor * w]
    };
    let (xx, first) = unit([x0, x1, x2]);
    let [y, z] = [[y0, y1, y2], [z0, z1, z2]];
    let [xy, xz] = [dot(first, y), dot(first, z)];
    let (yy, second) = unit(less(y, xy, first));
    let z = less(z, xz, first);
    // The third column is perpendicular to the first two.
    [xx, xy, xz, yy, dot(second, z), dot(cross(first, second), z)]
}

#[inline(always)]
fn add(planes: &Rgb<[f32; BLOCK]>, colors: &mut [Rgb<f32>]) {
    let pixels = planes.r.iter().zip(&planes.g).zip(&planes.b);
    for (color, ((&r, &g), &b)) in colors.iter_mut().zip(pixels) {
        *color = Rgb::new(color.r + r, color.g + g, color.b + b);
    }
}

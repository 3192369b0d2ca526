//! Sums the components of each azimuth into the polynomials of a [`Scene`]: H_m = Σ_i d_i H_i over
//! the components i of azimuth m.

use crate::basis::Basis;
use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::index::layout::LANES;
use crate::invariant::{part_mut, split_mut};
use crate::places::{AzimuthPlace, Shape};
use crate::scalar::Scalar;
use crate::scene::{Scene, SceneBuffer};

impl<'a, S: Scalar> Basis<'a, S> {
    /// Sums the components of each azimuth.
    ///
    /// `N` must be at least [`scene_len`](Self::scene_len). `coefficients` holds the leading
    /// components; missing ones count as zero.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, [`Error::Capacity`] if `N`
    /// is too small.
    pub fn collapse<const N: usize>(
        &self,
        coefficients: &[S],
    ) -> Result<Scene<'a, SceneBuffer<S, N>>, Error> {
        self.collapse_into(coefficients, zeros::<S, N>(Argument::Scene, self.scene_len())?)
    }

    /// [`collapse`](Self::collapse) into a buffer that the caller provides, of length
    /// [`scene_len`](Self::scene_len).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, or if the buffer has
    /// another length.
    pub fn collapse_into<B: AsMut<[S]>>(
        &self,
        coefficients: &[S],
        mut buffer: B,
    ) -> Result<Scene<'a, B>, Error> {
        let sums = buffer.as_mut();
        Error::check(Argument::Scene, self.scene_len(), sums.len())?;
        if coefficients.len() > self.components() {
            let (expected, found) = (self.components(), coefficients.len());
            return Err(Error::Length { argument: Argument::Coefficients, expected, found });
        }
        sums.fill(S::ZERO);
        self.write_mean(sums);
        let (mut sums, mut azimuth) = (sums, 0);
        for (place, terms) in self.profiles() {
            while azimuth < place.azimuth() {
                let signs = if azimuth == 0 { 1 } else { 2 };
                sums = part_mut(sums, signs * self.length(azimuth)..);
                azimuth += 1;
            }
            let length = terms.len();
            let [plus, minus] = [place.plus(), place.minus()]
                .map(|index| index.and_then(|index| weight(coefficients, index)));
            if let Some(plus) = plus {
                add_profiles(terms, length, &[[plus]], true, sums);
            }
            if let Some(minus) = minus {
                add_profiles(terms, length, &[[of_minus(minus)]], true, part_mut(sums, length..));
            }
        }
        Ok(Scene::of(self.parts.lengths, self.recurrences, buffer))
    }

    /// Writes the polynomial of the mean image, if there is one, to the start of a scene.
    #[inline(always)]
    fn write_mean(&self, scene: &mut [S]) {
        for (sum, &mean) in scene.iter_mut().zip(self.parts.mean) {
            *sum = mean;
        }
    }
}

/// Writes the polynomials of azimuth `M`, which has `P` profiles. A component that the basis does
/// not have counts as zero.
///
/// Not inlined: a compiler that sees several azimuths at once runs out of registers.
#[inline(never)]
pub fn azimuth<
    B: Shape<Basis<'static, S>>,
    S: Scalar,
    const M: usize,
    const P: usize,
    const K: usize,
    const N: usize,
>(
    coefficients: &[S; K],
    scene: &mut [S; N],
) {
    const { assert!(azimuth_of::<B, S>(M).profiles == P, "the azimuth has other profiles") };
    let AzimuthPlace { start, length, .. } = const { azimuth_of::<B, S>(M) };
    let components = const { &B::BASIS.components_of::<P>(M) };
    let terms = const { B::BASIS.parts.terms.split_at(azimuth_of::<B, S>(M).terms).1 };
    let (_, scene) = split_mut(scene, start);
    let weight = |component| weight(coefficients, component).unwrap_or(S::ZERO);
    if M == 0 {
        B::BASIS.write_mean(scene);
        let weights = components.map(|[plus, _]| [weight(plus)]);
        add_profiles(terms, length, &weights, !B::BASIS.parts.mean.is_empty(), scene);
    } else {
        let weights = components.map(|[plus, minus]| [weight(plus), of_minus(weight(minus))]);
        add_profiles(terms, length, &weights, false, scene);
    }
}

const fn azimuth_of<B: Shape<Basis<'static, S>>, S: 'static>(azimuth: usize) -> AzimuthPlace {
    B::BASIS.azimuth_at(azimuth)
}

#[inline(always)]
fn weight<S: Scalar>(coefficients: &[S], component: u16) -> Option<S> {
    coefficients.get(usize::from(component)).copied()
}

/// The weight of -m: Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
#[inline(always)]
fn of_minus<S: Scalar>(coefficient: S) -> S {
    -coefficient
}

/// Writes the sums of the terms of `P` profiles, each times its weights, to `W` polynomials of this
/// length. With `adds`, adds them to these polynomials.
#[inline(always)]
fn add_profiles<S: Scalar, const W: usize, const P: usize>(
    terms: &[S],
    length: usize,
    weights: &[[S; W]; P],
    adds: bool,
    polynomials: &mut [S],
) {
    let (Some(terms), Some(polynomials)) =
        (terms.get(..P * length), polynomials.get_mut(..W * length))
    else {
        return;
    };
    // Small code for targets without lanes to fill.
    let alone = if cfg!(target_pointer_width = "64") { length % LANES } else { length };
    let mut term = 0;
    while alone < length && term + LANES <= length {
        add_terms::<S, W, P, LANES>(term, length, terms, weights, adds, polynomials);
        term += LANES;
    }
    for term in length - alone..length {
        add_terms::<S, W, P, 1>(term, length, terms, weights, adds, polynomials);
    }
}

/// [`add_profiles`] for `G` terms, the first of which is number `first`.
#[inline(always)]
fn add_terms<S: Scalar, const W: usize, const P: usize, const G: usize>(
    first: usize,
    length: usize,
    terms: &[S],
    weights: &[[S; W]; P],
    adds: bool,
    polynomials: &mut [S],
) {
    let of_row = |row: usize| row * length + first..row * length + first + G;
    let mut sums = [[S::ZERO; G]; W];
    for (sign, sum) in sums.iter_mut().enumerate() {
        let before = polynomials.get(of_row(sign)).and_then(<[S]>::first_chunk);
        if let Some(&before) = before.filter(|_| adds) {
            *sum = before;
        }
    }
    for (profile, weights) in weights.iter().enumerate() {
        let terms = terms.get(of_row(profile)).and_then(<[S]>::first_chunk::<G>);
        let Some(terms) = terms else { continue };
        for (sum, &weight) in sums.iter_mut().zip(weights) {
            let mut before = sum.iter();
            *sum = terms.map(|term| match before.next() {
                Some(before) if adds || profile > 0 => before.add_product(weight, term),
                _ => weight * term,
            });
        }
    }
    for (sign, sum) in sums.into_iter().enumerate() {
        if let Some(to) = polynomials.get_mut(of_row(sign)).and_then(<[S]>::first_chunk_mut) {
            *to = sum;
        }
    }
}

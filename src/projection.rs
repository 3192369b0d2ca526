//! d = UᵀMc, azimuth by azimuth, without ever forming c or UᵀM.
//!
//! c = L (x) b has rank one. The material is folded into the basis's factors,
//! T_i,l = Σ_pq factor_i,l,pq S_l,pq; then d_i = Σ_l T_i,l L_l^m. +m and -m share
//! the row: theirs differ by (-1)^m.

use crate::basis::{Basis, ProfilePlace};
use crate::error::{Error, What};
use crate::index::{layout, light};
use crate::light::Light;
use crate::material::Material;
use crate::scalar::Scalar;

const LANES: usize = layout::LANES;

/// Groups of a row that are summed at a time: degrees up to 15 take one pass.
const PASS: usize = 4;

/// The coefficients d of one image, component by component.
pub type Coefficients<S, const K: usize> = heapless::Vec<S, K>;

/// One material folded into a basis: see [`Basis::transfer`].
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer<S, const N: usize>(heapless::Vec<S, N>);

impl<S: Scalar> Basis<'_, S> {
    /// d = UᵀMc of a light on a material: the image's coefficients in the
    /// eigenimages, less those of the mean image if the basis has one.
    ///
    /// `N` is at least [`scattering_len`](Self::scattering_len), `K` at least
    /// [`components`](Self::components). A light or material of a lower degree or
    /// order than the basis's counts as zero above.
    ///
    /// Cost, for a basis with R profiles and P pairs (p, q): about R P (degree/2)
    /// multiplications, plus twice the material's coefficients times the degree.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if light or material go beyond the basis,
    /// [`Error::Capacity`] if `N` or `K` is too small.
    pub fn project<const N: usize, const K: usize>(
        &self,
        light: &Light<'_, S>,
        material: &Material<'_, S>,
    ) -> Result<Coefficients<S, K>, Error> {
        let mut scattering = zeros::<S, N>(What::Scattering, self.scattering_len())?;
        let mut coefficients = zeros::<S, K>(What::Coefficients, self.components())?;
        self.project_into(light, material, &mut scattering, &mut coefficients)?;
        Ok(coefficients)
    }

    /// [`project`](Self::project) into slices: room for
    /// [`scattering_len`](Self::scattering_len) numbers, and
    /// [`components`](Self::components) for the answer.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if light or material go beyond the basis,
    /// [`Error::Length`] if a slice has another length.
    pub fn project_into(
        &self,
        light: &Light<'_, S>,
        material: &Material<'_, S>,
        scattering: &mut [S],
        coefficients: &mut [S],
    ) -> Result<(), Error> {
        self.accept_light(light)?;
        self.accept_material(material)?;
        Error::check(What::Scattering, self.scattering_len(), scattering.len())?;
        Error::check(What::Coefficients, self.components(), coefficients.len())?;
        self.start(coefficients);
        self.scatter(material, 0, scattering);
        for pass in self.passes() {
            self.scatter_again(material, &pass, scattering);
            match pass.count {
                1 => self.project_pass::<1>(&pass, light, scattering, coefficients),
                2 => self.project_pass::<2>(&pass, light, scattering, coefficients),
                3 => self.project_pass::<3>(&pass, light, scattering, coefficients),
                _ => self.project_pass::<PASS>(&pass, light, scattering, coefficients),
            }
        }
        Ok(())
    }

    /// Folds a material into the basis: T_i,l for every profile.
    ///
    /// `N` is at least [`scattering_len`](Self::scattering_len), `T` at least
    /// [`transfer_len`](Self::transfer_len).
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis,
    /// [`Error::Capacity`] if `N` or `T` is too small.
    pub fn transfer<const N: usize, const T: usize>(
        &self,
        material: &Material<'_, S>,
    ) -> Result<Transfer<S, T>, Error> {
        let mut scattering = zeros::<S, N>(What::Scattering, self.scattering_len())?;
        let mut transfer = zeros::<S, T>(What::Transfer, self.transfer_len())?;
        self.transfer_into(material, &mut scattering, &mut transfer)?;
        Ok(Transfer(transfer))
    }

    /// [`transfer`](Self::transfer) into slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the material goes beyond the basis,
    /// [`Error::Length`] if a slice is not as long as
    /// [`scattering_len`](Self::scattering_len) and
    /// [`transfer_len`](Self::transfer_len) say.
    pub fn transfer_into(
        &self,
        material: &Material<'_, S>,
        scattering: &mut [S],
        transfer: &mut [S],
    ) -> Result<(), Error> {
        self.accept_material(material)?;
        Error::check(What::Scattering, self.scattering_len(), scattering.len())?;
        Error::check(What::Transfer, self.transfer_len(), transfer.len())?;
        let (transfer, _) = transfer.as_chunks_mut::<LANES>();
        self.scatter(material, 0, scattering);
        for pass in self.passes() {
            self.scatter_again(material, &pass, scattering);
            match pass.count {
                1 => self.transfer_pass::<1>(&pass, scattering, transfer),
                2 => self.transfer_pass::<2>(&pass, scattering, transfer),
                3 => self.transfer_pass::<3>(&pass, scattering, transfer),
                _ => self.transfer_pass::<PASS>(&pass, scattering, transfer),
            }
        }
        Ok(())
    }

    /// d of a new light on a material that was folded in: R (degree/2)
    /// multiplications for R profiles, each for both signs of m.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis, [`Error::Length`] if
    /// the transfer is another basis's, [`Error::Capacity`] if `K` is too small.
    pub fn relight<const T: usize, const K: usize>(
        &self,
        transfer: &Transfer<S, T>,
        light: &Light<'_, S>,
    ) -> Result<Coefficients<S, K>, Error> {
        let mut coefficients = zeros::<S, K>(What::Coefficients, self.components())?;
        self.relight_into(&transfer.0, light, &mut coefficients)?;
        Ok(coefficients)
    }

    /// [`relight`](Self::relight) on slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis, [`Error::Length`] if
    /// a slice is not as long as [`transfer_len`](Self::transfer_len) and
    /// [`components`](Self::components) say.
    pub fn relight_into(
        &self,
        transfer: &[S],
        light: &Light<'_, S>,
        coefficients: &mut [S],
    ) -> Result<(), Error> {
        self.accept_light(light)?;
        Error::check(What::Transfer, self.transfer_len(), transfer.len())?;
        Error::check(What::Coefficients, self.components(), coefficients.len())?;
        self.start(coefficients);
        let (transfer, _) = transfer.as_chunks::<LANES>();
        for pass in self.passes() {
            match pass.count {
                1 => relight_pass::<S, 1>(&pass, transfer, light, coefficients),
                2 => relight_pass::<S, 2>(&pass, transfer, light, coefficients),
                3 => relight_pass::<S, 3>(&pass, transfer, light, coefficients),
                _ => relight_pass::<S, PASS>(&pass, transfer, light, coefficients),
            }
        }
        Ok(())
    }

    /// One scattering serves every azimuth, unless a selection of modes makes
    /// them differ.
    #[inline]
    fn scatter_again(&self, material: &Material<'_, S>, pass: &Pass<'_, S>, scattering: &mut [S]) {
        if !self.parts.selection.is_empty() && pass.azimuth > 0 && pass.first == 0 {
            self.scatter(material, pass.azimuth, scattering);
        }
    }

    /// Checks a light against this basis.
    fn accept_light(&self, light: &Light<'_, S>) -> Result<(), Error> {
        let (basis, found) = (self.degree(), light.degree());
        if found > basis {
            return Err(Error::Beyond {
                what: What::Light,
                basis,
                found,
            });
        }
        Ok(())
    }

    /// The coefficients of the image that is zero: less those of the mean.
    fn start(&self, coefficients: &mut [S]) {
        coefficients.fill(S::ZERO);
        for (coefficient, &mean) in coefficients.iter_mut().zip(self.parts.mean_coefficients) {
            *coefficient = -mean;
        }
    }

    /// The work azimuth by azimuth, and where rows are long, part by part.
    #[inline]
    fn passes(&self) -> impl Iterator<Item = Pass<'_, S>> {
        let degree = self.degree();
        let pairs = crate::index::pair::count(self.order());
        let (mut factors, _) = self.parts.factors.as_chunks::<LANES>();
        let mut start = 0;
        self.parts
            .profiles
            .chunk_by(|a, b| a.azimuth == b.azimuth)
            .flat_map(move |places| {
                let azimuth = places.first().map_or(0, |place| place.azimuth());
                let groups = layout::groups(degree, azimuth);
                let of_block = places.len() * groups;
                let (block, rest) = factors
                    .split_at_checked(of_block * pairs)
                    .unwrap_or((factors, &[]));
                factors = rest;
                let transfer = start;
                start += of_block;
                (0..groups).step_by(PASS).map(move |first| Pass {
                    places,
                    azimuth,
                    groups,
                    first,
                    count: PASS.min(groups - first),
                    factors: block,
                    row: groups * pairs,
                    transfer,
                })
            })
    }

    fn project_pass<const C: usize>(
        &self,
        pass: &Pass<'_, S>,
        light: &Light<'_, S>,
        scattering: &[S],
        coefficients: &mut [S],
    ) {
        let lights = gather::<S, C>(pass, light);
        for (place, factors) in pass.places.iter().zip(pass.factors.chunks_exact(pass.row)) {
            let row = self.fold::<C>(pass, factors, scattering);
            add(place, &row, &lights, coefficients);
        }
    }

    fn transfer_pass<const C: usize>(
        &self,
        pass: &Pass<'_, S>,
        scattering: &[S],
        transfer: &mut [[S; LANES]],
    ) {
        let rows = transfer.get_mut(pass.transfer..).unwrap_or_default();
        for (to, factors) in rows
            .chunks_exact_mut(pass.groups)
            .zip(pass.factors.chunks_exact(pass.row))
        {
            let row = self.fold::<C>(pass, factors, scattering);
            for (to, from) in to.iter_mut().skip(pass.first).zip(row) {
                *to = from;
            }
        }
    }

    /// `C` groups of T_l = Σ_pq factor_l,pq S_l,pq of one profile.
    #[inline]
    fn fold<const C: usize>(
        &self,
        pass: &Pass<'_, S>,
        factors: &[[S; LANES]],
        scattering: &[S],
    ) -> [[S; LANES]; C] {
        let mut row = [[S::ZERO; LANES]; C];
        let start = pass.azimuth + LANES * pass.first;
        let scattering = scattering.chunks_exact(layout::stride(self.degree()));
        for (factors, scattering) in factors.chunks_exact(pass.groups).zip(scattering) {
            let factors = factors
                .get(pass.first..)
                .and_then(|groups| groups.first_chunk::<C>());
            let scattering = scattering.get(start..).map(<[S]>::as_chunks::<LANES>);
            let scattering = scattering.and_then(|(groups, _)| groups.first_chunk::<C>());
            let (Some(factors), Some(scattering)) = (factors, scattering) else {
                continue;
            };
            for ((sums, factors), scattering) in row.iter_mut().zip(factors).zip(scattering) {
                for ((sum, &factor), &scattered) in sums.iter_mut().zip(factors).zip(scattering) {
                    *sum += factor * scattered;
                }
            }
        }
        row
    }
}

/// Part of the work on the profiles of one azimuth: some groups of their rows.
struct Pass<'a, S> {
    places: &'a [ProfilePlace],
    azimuth: usize,
    /// Groups in a row.
    groups: usize,
    /// The first group of this pass.
    first: usize,
    /// How many groups it takes.
    count: usize,
    /// The factors of the azimuth's profiles.
    factors: &'a [[S; LANES]],
    /// Groups of factors of one profile.
    row: usize,
    /// Where the azimuth's rows start in a transfer, in groups.
    transfer: usize,
}

/// L_l^m and (-1)^m L_l^-m over the degrees l of a pass.
type Gathered<S, const C: usize> = [[[S; LANES]; C]; 2];

/// Picks the light of a pass out of its order by degree; zero beyond its degree.
#[inline]
fn gather<S: Scalar, const C: usize>(pass: &Pass<'_, S>, light: &Light<'_, S>) -> Gathered<S, C> {
    let coefficients = light.coefficients();
    let order = pass.azimuth.cast_signed();
    let of = |l: usize, m: isize| {
        coefficients
            .get(light::position(l, m))
            .copied()
            .unwrap_or(S::ZERO)
    };
    let mut gathered = [[[S::ZERO; LANES]; C]; 2];
    let [plus, minus] = &mut gathered;
    let start = pass.azimuth + LANES * pass.first;
    let lanes = plus
        .as_flattened_mut()
        .iter_mut()
        .zip(minus.as_flattened_mut());
    for (l, (plus, minus)) in (start..=light.degree()).zip(lanes) {
        *plus = of(l, order);
        let value = of(l, -order);
        *minus = if order % 2 == 0 { value } else { -value };
    }
    gathered
}

#[inline]
fn relight_pass<S: Scalar, const C: usize>(
    pass: &Pass<'_, S>,
    transfer: &[[S; LANES]],
    light: &Light<'_, S>,
    coefficients: &mut [S],
) {
    let lights = gather::<S, C>(pass, light);
    let rows = transfer
        .get(pass.transfer..)
        .unwrap_or_default()
        .chunks_exact(pass.groups);
    for (place, row) in pass.places.iter().zip(rows) {
        if let Some(row) = row.get(pass.first..).and_then(|row| row.first_chunk::<C>()) {
            add(place, row, &lights, coefficients);
        }
    }
}

/// Adds Σ_l T_l L_l^±m to the components that a profile serves.
#[inline]
fn add<S: Scalar, const C: usize>(
    place: &ProfilePlace,
    row: &[[S; LANES]; C],
    [plus, minus]: &Gathered<S, C>,
    coefficients: &mut [S],
) {
    for (index, light) in [(place.plus, plus), (place.minus, minus)] {
        let place = index.and_then(|index| coefficients.get_mut(usize::from(index)));
        if let Some(coefficient) = place {
            *coefficient += product(row, light);
        }
    }
}

/// Σ a b, lane by lane and then across.
#[inline]
fn product<S: Scalar, const C: usize>(a: &[[S; LANES]; C], b: &[[S; LANES]; C]) -> S {
    let mut lanes = [S::ZERO; LANES];
    for (a, b) in a.iter().zip(b) {
        for ((lane, &a), &b) in lanes.iter_mut().zip(a).zip(b) {
            *lane += a * b;
        }
    }
    let [first, second, third, fourth] = lanes;
    (first + second) + (third + fourth)
}

/// A buffer of `needed` zeros.
pub(crate) fn zeros<S: Scalar, const N: usize>(
    what: What,
    needed: usize,
) -> Result<heapless::Vec<S, N>, Error> {
    let mut buffer = heapless::Vec::new();
    buffer
        .resize(needed, S::ZERO)
        .map_err(|_| Error::Capacity {
            what,
            needed,
            capacity: N,
        })?;
    Ok(buffer)
}

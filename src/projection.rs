//! d = UᵀMc, without ever forming c or UᵀM.
//!
//! c = L (x) b has rank one. The material is scattered into S_l,pq once, and each profile then
//! takes one pass over its factors, d_±m = Σ_l (Σ_pq factor_l,pq S_l,pq) (±1)^m L_l^±m. The inner
//! sum is the same for +m and -m.
//!
//! The public functions are the same steps with constants for all sizes and positions, for tables
//! that are known when the program is compiled. Four profiles then read the scattered material once.

use crate::basis::Basis;
use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::groups;
use crate::index::{layout::LANES, light};
use crate::known_table::{KnownTable, at, components, tail};
use crate::light::Light;
use crate::material::Material;
use crate::relight::Coefficients;
use crate::transfer::{Workspace, scatter_pairs, transpose};

impl Basis<'_> {
    /// Computes d = UᵀMc for a light on a material: the coefficients of the image in the
    /// eigenimages.
    ///
    /// `N` must be at least [`workspace_len`](Self::workspace_len), `K` at least
    /// [`components`](Self::components). If the light has a lower degree than the basis, or the
    /// material a lower order, the missing coefficients count as zero.
    ///
    /// ```
    /// # #[cfg(feature = "baked")] {
    /// use eigenshade::{Light, Material, sphere};
    ///
    /// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
    /// let matte = Material::new(&[2.0])?;
    /// // A table's own functions have its sizes as constants.
    /// let d = sphere::project(&light, &matte)?;
    /// assert_eq!(d.len(), sphere::BASIS.components());
    /// # }
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// Cost: for each profile and each degree from its |m| on, one multiplication for each pair (p,
    /// q) and eight for the light; before that, for each q and degree, the square of the number of
    /// pairs of that q.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis's degree or the material beyond the
    /// basis's order, [`Error::Capacity`] if `N` or `K` is too small.
    pub fn project<const N: usize, const K: usize>(
        &self,
        light: &Light<'_>,
        material: &Material<'_>,
    ) -> Result<Coefficients<K>, Error> {
        buffered::<N, K>(self.workspace_len(), self.components(), |workspace, d| {
            self.project_into(light, material, workspace, d)
        })
    }

    /// [`project`](Self::project) with slices: `workspace` has
    /// [`workspace_len`](Self::workspace_len) numbers, and `coefficients` receives
    /// [`components`](Self::components) numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis's degree or the material beyond the
    /// basis's order, [`Error::Length`] if a slice has another length.
    pub fn project_into(
        &self,
        light: &Light<'_>,
        material: &Material<'_>,
        workspace: &mut [f32],
        coefficients: &mut [f32],
    ) -> Result<(), Error> {
        self.accept_light(light)?;
        self.accept_material(material)?;
        Error::check(Argument::Workspace, self.workspace_len(), workspace.len())?;
        Error::check(Argument::Coefficients, self.components(), coefficients.len())?;
        // Rows of the usual orders have kernels with their length built in.
        let lit = (light, material);
        match self.row() / LANES {
            1 => self.project_rows(lit, workspace, coefficients, row::<1>),
            2 => self.project_rows(lit, workspace, coefficients, row::<2>),
            3 => self.project_rows(lit, workspace, coefficients, row::<3>),
            4 => self.project_rows(lit, workspace, coefficients, row::<4>),
            5 => self.project_rows(lit, workspace, coefficients, row::<5>),
            _ => self.project_rows(lit, workspace, coefficients, long_row),
        }
        Ok(())
    }

    #[inline(always)]
    fn project_rows(
        &self,
        (light, material): (&Light<'_>, &Material<'_>),
        workspace: &mut [f32],
        coefficients: &mut [f32],
        row: impl Fn(Row<'_>) -> [groups::Two; 2],
    ) {
        let width = self.row() / LANES;
        let Workspace { scattering, sums, lights } = self.divide(workspace);
        self.scatter(material, sums, scattering);
        let mut gathered = None;
        for (places, factors) in self.rows() {
            let azimuth = places.first().map_or(0, |place| place.azimuth());
            if gathered != Some(azimuth) {
                gather(light.coefficients(), light.degree(), azimuth, lights);
                gathered = Some(azimuth);
            }
            let scattering = self.scattered_from(azimuth, scattering);
            let sums = row(Row { factors, scattering, lights, width });
            let components = places.iter().map(|place| place.components());
            write_twos(&[sums], components, coefficients);
        }
    }
}

/// L_l^m and (-1)^m L_l^-m for l = m, m + 1, ...; zero above the degree of the light.
#[inline(always)]
fn gather(coefficients: &[f32], degree: usize, azimuth: usize, lights: &mut [[f32; 2]]) {
    let sign = if azimuth % 2 == 1 { -1.0 } else { 1.0 };
    let mut center = light::position(azimuth, 0);
    for (l, place) in (azimuth..).zip(lights) {
        let plus = coefficients.get(center + azimuth).copied().unwrap_or(0.0);
        let minus = coefficients.get(center - azimuth).copied().unwrap_or(0.0);
        // Above the degree of the light, the position of -m may still hold another order.
        *place = if l <= degree { [plus, sign * minus] } else { [0.0; 2] };
        center += 2 * l + 2;
    }
}

/// The inputs for the components of two profiles.
struct Row<'a> {
    factors: &'a [f32],
    scattering: &'a [f32],
    lights: &'a [[f32; 2]],
    /// Groups in a row of factors.
    width: usize,
}

/// The components of two profiles, for +m and for -m, from rows of `V` groups, not yet summed
/// across the lanes. Not inlined: if the compiler sees the sum across the lanes, it splits the
/// vectors throughout.
#[inline(never)]
fn row<const V: usize>(row: Row<'_>) -> [groups::Two; 2] {
    let (factors, _) = row.factors.as_chunks().0.as_chunks::<V>();
    let (scattering, _) = row.scattering.as_chunks::<LANES>().0.as_chunks::<V>();
    let rows = factors.iter().zip(scattering);
    lit(rows.map(|(factors, scattering)| groups::product(factors, scattering)), row.lights)
}

/// [`row`] for rows of any length.
#[inline(never)]
fn long_row(row: Row<'_>) -> [groups::Two; 2] {
    let factors = row.factors.as_chunks().0.chunks_exact(row.width.max(1));
    let scattering = row.scattering.as_chunks::<LANES>().0.chunks_exact(row.width.max(1));
    let rows = factors.zip(scattering);
    lit(rows.map(|(factors, scattering)| groups::product(factors, scattering)), row.lights)
}

/// The sums of the rows, weighted by the light.
#[inline(always)]
fn lit(rows: impl Iterator<Item = groups::Two>, lights: &[[f32; 2]]) -> [groups::Two; 2] {
    let zero = [[0.0; 2 * LANES]; 2];
    rows.zip(lights).fold(zero, |sums, (row, lights)| add_lit(sums, &row, lights))
}

/// Adds a row, times the light of +m and of -m, to the sums of two profiles.
#[inline(always)]
fn add_lit(
    [plus, minus]: [groups::Two; 2],
    row: &groups::Two,
    &[of_plus, of_minus]: &[f32; 2],
) -> [groups::Two; 2] {
    let plus = groups::multiply_add_two(plus, row, &[of_plus; LANES]);
    [plus, groups::multiply_add_two(minus, row, &[of_minus; LANES])]
}

/// Writes the components of profiles, two at a time, from sums that are not yet summed across the
/// lanes.
#[inline(always)]
fn write_twos(
    sums: &[[groups::Two; 2]],
    components: impl IntoIterator<Item = [u16; 2]>,
    coefficients: &mut [f32],
) {
    let sums = sums.iter().flat_map(|[plus, minus]| {
        let [[a, b], [c, d]] = [groups::sums(*plus), groups::sums(*minus)];
        [[a, c], [b, d]]
    });
    for (sums, components) in sums.zip(components) {
        for (sum, component) in sums.into_iter().zip(components) {
            if let Some(coefficient) = coefficients.get_mut(usize::from(component)) {
                *coefficient = sum;
            }
        }
    }
}

/// Provides a workspace and coefficients for `project` to fill, both of constant capacities.
#[inline]
pub(crate) fn buffered<const N: usize, const K: usize>(
    workspace: usize,
    components: usize,
    project: impl FnOnce(&mut [f32], &mut [f32]) -> Result<(), Error>,
) -> Result<Coefficients<K>, Error> {
    let mut workspace = zeros::<f32, N>(Argument::Workspace, workspace)?;
    let mut coefficients = zeros::<f32, K>(Argument::Coefficients, components)?;
    project(&mut workspace, &mut coefficients)?;
    Ok(coefficients)
}

/// The sums S_l,pq of one q, for its `P` pairs p = q, q + 2, ..., in rows of `G` groups. Not inlined,
/// so that the sums stay in registers.
#[inline(never)]
pub fn scatter<const Q: usize, const P: usize, const G: usize, const M: usize, const R: usize>(
    material: &[f32; M],
    polar: &[[[f32; LANES]; G]; R],
    sums: &mut [[[f32; LANES]; G]],
) {
    scatter_pairs(Q, P, material, polar, sums);
}

/// The numbers of a table as `R` rows of `G` groups, if there are enough.
#[inline(always)]
pub fn table_rows<const G: usize, const R: usize>(
    numbers: &[f32],
) -> Option<&[[[f32; LANES]; G]; R]> {
    let (groups, _) = numbers.as_chunks::<LANES>();
    groups.as_chunks::<G>().0.first_chunk()
}

/// Transposes rows over l, one for each pair, to `D` rows over the pairs, one for each l.
#[inline(always)]
pub fn transposed<const V: usize, const D: usize, const G: usize, const R: usize>(
    sums: &[[[f32; LANES]; G]; R],
) -> [[[f32; LANES]; V]; D] {
    let mut scattering = [[[0.0; LANES]; V]; D];
    transpose(sums.as_flattened(), G, scattering.as_flattened_mut(), V);
    scattering
}

/// L_l^m and (-1)^m L_l^-m for the `L` degrees l from m = `M` on.
#[inline(always)]
pub fn lights<const M: usize, const L: usize, const N: usize>(light: &[f32; N]) -> [[f32; 2]; L] {
    let mut lights = [[0.0; 2]; L];
    gather(light, M + L - 1, M, &mut lights);
    lights
}

/// The components of up to `2 C` profiles of azimuth `M`, from number `FIRST` of this azimuth on:
/// `C` times two profiles, for +m and for -m, before the sum across the lanes. The rows have `V`
/// groups, for `L` degrees; the scattered material has `D` rows. Not inlined: a compiler that sees
/// single lanes being read splits the groups.
#[inline(never)]
pub fn rows<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const FIRST: usize,
    const C: usize,
    const V: usize,
    const L: usize,
    const D: usize,
>(
    scattering: &[[[f32; LANES]; V]; D],
    lights: &[[f32; 2]; L],
) -> [[groups::Two; 2]; C] {
    // Two profiles have two rows of factors for each degree.
    let factors = const {
        let row = at(B::BASIS.parts.azimuths, M).rows as usize + FIRST * L;
        tail(B::BASIS.parts.factors, LANES * V * row)
    };
    let mut sums = [[[0.0; 2 * LANES]; 2]; C];
    let (factors, _) = factors.as_chunks().0.as_chunks::<V>().0.as_chunks::<L>();
    let scattering = scattering.get(M..).and_then(|rows| rows.first_chunk::<L>());
    let Some(rows) = scattering.map(|rows| rows.iter().zip(lights)) else { return sums };
    // The sums are named, so that they stay in registers.
    match (factors, sums.as_mut_slice()) {
        ([a, ..], [of_a]) => {
            let mut sum = [[0.0; 2 * LANES]; 2];
            for (a, (scattering, lights)) in a.iter().zip(rows) {
                sum = add_lit(sum, &groups::product(a, scattering), lights);
            }
            *of_a = sum;
        }
        ([a, b, ..], [of_a, of_b]) => {
            let mut sums = [[[0.0; 2 * LANES]; 2]; 2];
            for ((a, b), (scattering, lights)) in a.iter().zip(b).zip(rows) {
                let (a, b) = (groups::product(a, scattering), groups::product(b, scattering));
                sums = [add_lit(sums[0], &a, lights), add_lit(sums[1], &b, lights)];
            }
            [*of_a, *of_b] = sums;
        }
        _ => {}
    }
    sums
}

/// Writes the components that [`rows`] computed.
#[inline(always)]
pub fn write<B, const M: usize, const FIRST: usize, const C: usize, const K: usize>(
    sums: &[[groups::Two; 2]; C],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    // There are at most four profiles.
    let components = const {
        let place = at(B::BASIS.parts.azimuths, M);
        let left = place.profiles as usize - FIRST;
        components::<4>(
            B::BASIS.parts.profiles,
            place.first as usize + FIRST,
            if left < 4 { left } else { 4 },
        )
    };
    write_twos(sums, components, coefficients);
}

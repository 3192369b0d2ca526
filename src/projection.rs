//! d = UᵀMc, without ever forming c or UᵀM.
//!
//! c = L (x) b has rank one. The material is scattered into S_l,pq once, and each profile then
//! takes one pass over its factors, d_±m = Σ_l (Σ_pq factor_l,pq S_l,pq) (±1)^m L_l^±m. The inner
//! sum is the same for +m and -m.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::groups;
use crate::index::{layout, layout::LANES, light, record::ProfilePlace};
use crate::light::Light;
use crate::material::Material;

/// The coefficients d of one image, component by component.
pub type Coefficients<const K: usize> = Buffer<f32, K>;

impl<'a> Basis<'a> {
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

    #[inline]
    pub(crate) fn divide<'w>(&self, workspace: &'w mut [f32]) -> Workspace<'w> {
        let rows = (self.degree() + 1) * self.row();
        let (scattering, rest) = split_mut(workspace, rows);
        let sums = self.sums_len();
        let (sums, lights) = split_mut(rest, sums);
        Workspace { scattering, sums, lights: lights.as_chunks_mut().0 }
    }

    /// The rows of S from l = `azimuth` on.
    #[inline]
    pub(crate) fn scattered_from<'w>(&self, azimuth: usize, scattering: &'w [f32]) -> &'w [f32] {
        part(scattering, azimuth * self.row()..)
    }

    /// The profiles of each azimuth in twos, with their factors.
    #[inline]
    pub(crate) fn rows(&self) -> impl Iterator<Item = (&'a [ProfilePlace], &'a [f32])> + use<'a> {
        let (degree, row) = (self.degree(), self.row());
        let (mut places, mut factors) = (self.parts.profiles, self.parts.factors);
        // Written by hand because the compiler cannot prove that `chunk_by` never panics.
        core::iter::from_fn(move || {
            let azimuth = places.first()?.azimuth();
            let same = places.iter().take(2).take_while(|place| place.azimuth() == azimuth);
            let (two, others) = places.split_at_checked(same.count())?;
            let length = layout::rows(degree, azimuth, two.len()) * row;
            let (rows, rest) = split_row(factors, length);
            (places, factors) = (others, rest);
            Some((two, rows))
        })
    }

    pub(crate) fn accept_light(&self, light: &Light<'_>) -> Result<(), Error> {
        Error::check_beyond(Argument::Light, self.degree(), light.degree())
    }
}

/// L_l^m and (-1)^m L_l^-m for l = m, m + 1, ...; zero above the degree of the light.
#[inline(always)]
pub(crate) fn gather(coefficients: &[f32], degree: usize, azimuth: usize, lights: &mut [[f32; 2]]) {
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

pub(crate) struct Workspace<'w> {
    /// S, with a row for each l.
    pub(crate) scattering: &'w mut [f32],
    /// Room for S along l.
    pub(crate) sums: &'w mut [f32],
    /// The light of one azimuth.
    lights: &'w mut [[f32; 2]],
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
pub(crate) fn add_lit(
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
pub(crate) fn write_twos(
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

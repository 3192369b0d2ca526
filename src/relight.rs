//! A new light on a transferred material: d_i = Σ_l T_i,l L_l^m.
//!
//! A machine that computes with groups of numbers takes a transfer pass by pass. The lanes run
//! along m, as do the light's coefficients of one degree, so nothing is gathered and nothing is
//! summed across lanes. Lanes with |m| > l multiply coefficients of other degrees by zero.
//!
//! Other machines take it run by run, that is, order by order: this skips products with zero, and
//! reads each coefficient of the light once.

use crate::basis::Basis;
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::part;
use crate::error::{Argument, Error};
use crate::float;
use crate::groups;
use crate::index::record::{Pass, Run};
use crate::index::{layout, layout::LANES, light::position};
use crate::known_table::{KnownTable, at, components, head, tail};
use crate::light::Light;
use crate::transfer::Transfer;

/// The coefficients d of one image, component by component.
pub type Coefficients<const K: usize> = Buffer<f32, K>;

/// Whether the target computes with groups of numbers.
pub const GROUPS: bool = cfg!(any(
    target_arch = "x86",
    target_arch = "x86_64",
    target_arch = "aarch64",
    target_arch = "wasm32",
    target_feature = "neon",
    target_feature = "v"
));

/// Evaluates `$body` with `$profiles` as a constant from 1 to 8, the most profiles in a pass.
macro_rules! by_profiles {
    ($count:expr, $profiles:ident => $body:expr) => {
        by_profiles!(@each $count, $profiles => $body, 1 2 3 4 5 6 7 8)
    };
    (@each $count:expr, $profiles:ident => $body:expr, $($number:literal)*) => {
        match $count {
            $($number => {
                const $profiles: usize = $number;
                $body
            })*
            _ => {}
        }
    };
}

impl<'a> Basis<'a> {
    /// Computes d for a new light on a material whose transfer is known, with one multiplication
    /// for each of the [`transfer_len`](Self::transfer_len) numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis's degree, [`Error::Length`] if the
    /// transfer belongs to another basis, [`Error::Capacity`] if `K` is less than
    /// [`components`](Self::components).
    #[inline]
    pub fn relight<const T: usize, const K: usize>(
        &self,
        transfer: &Transfer<T>,
        light: &Light<'_>,
    ) -> Result<Coefficients<K>, Error> {
        let mut coefficients = zeros::<f32, K>(Argument::Coefficients, self.components())?;
        self.relight_into(transfer.as_slice(), light, &mut coefficients)?;
        Ok(coefficients)
    }

    /// [`relight`](Self::relight) with slices.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis's degree, [`Error::Length`] unless
    /// `transfer` has [`transfer_len`](Self::transfer_len) numbers and `coefficients` has
    /// [`components`](Self::components).
    #[inline]
    pub fn relight_into(
        &self,
        transfer: &[f32],
        light: &Light<'_>,
        coefficients: &mut [f32],
    ) -> Result<(), Error> {
        self.accept_light(light)?;
        Error::check(Argument::Transfer, self.transfer_len(), transfer.len())?;
        Error::check(Argument::Coefficients, self.components(), coefficients.len())?;
        if GROUPS {
            self.relight_passes(transfer, light, coefficients);
        } else {
            self.relight_runs(transfer, light, coefficients);
        }
        Ok(())
    }

    pub(crate) fn accept_light(&self, light: &Light<'_>) -> Result<(), Error> {
        Error::check_beyond(Argument::Light, self.degree(), light.degree())
    }

    #[inline]
    fn relight_passes(&self, transfer: &[f32], light: &Light<'_>, coefficients: &mut [f32]) {
        for pass in self.parts.passes {
            by_profiles!(pass.profiles, P => {
                let sums = any_sums::<P>(pass, transfer, light);
                write_pass(self.slots(pass).as_chunks().0, &sums, coefficients);
            });
        }
    }

    #[inline]
    fn relight_runs(&self, transfer: &[f32], light: &Light<'_>, coefficients: &mut [f32]) {
        for run in self.parts.runs {
            by_profiles!(run.profiles, P => {
                let sums = run_sums::<P>(run, light.degree(), transfer, light.coefficients());
                let profiles = tail(self.parts.profiles, run.first.into());
                let components = profiles.iter().map(|profile| profile.components());
                write_run(components, run.order, sums, coefficients);
            });
        }
    }

    /// The components of a pass.
    #[inline(always)]
    const fn slots(&self, pass: &Pass) -> &'a [u16] {
        tail(self.parts.slots, pass.slots as usize)
    }
}

/// Whether a table of this degree takes a light.
///
/// # Errors
///
/// [`Error::Beyond`].
#[inline(always)]
pub fn accept_light(degree: usize, light: &Light<'_>) -> Result<(), Error> {
    Error::check_beyond(Argument::Light, degree, light.degree())
}

/// The numbers of a transfer.
///
/// # Errors
///
/// [`Error::Length`] if there are fewer, as in a transfer of another table.
#[inline(always)]
pub fn transfer_numbers<const N: usize>(transfer: &Transfer<N>) -> Result<&[f32; N], Error> {
    let (argument, found) = (Argument::Transfer, transfer.as_slice().len());
    let length = Error::Length { argument, expected: N, found };
    transfer.as_slice().try_into().map_err(|_| length)
}

/// The coefficients of an image, to be written.
///
/// # Errors
///
/// None: a buffer holds as many as its capacity.
#[inline(always)]
pub fn coefficients<const N: usize>(
    coefficients: &mut Coefficients<N>,
) -> Result<&mut [f32; N], Error> {
    let (argument, needed, capacity) = (Argument::Coefficients, N, N);
    coefficients.filled().ok_or(Error::Capacity { argument, needed, capacity })
}

/// Writes the sums of pass number `I`, which has `P` profiles, to their components.
#[inline(always)]
pub fn write<B, const I: usize, const P: usize, const K: usize>(
    sums: &[[f32; LANES]; P],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    let slots = const {
        *head::<_, P>(B::BASIS.slots(at(B::BASIS.parts.passes, I)).as_chunks::<LANES>().0)
    };
    write_pass(&slots, sums, coefficients);
}

/// The sums of pass number `I`, which has `P` profiles. Not inlined: a compiler that sees single
/// lanes being read splits the groups.
#[inline(never)]
pub fn sums<B, const I: usize, const P: usize, const T: usize, const N: usize>(
    transfer: &[f32; T],
    light: &[f32; N],
) -> [[f32; LANES]; P]
where
    B: KnownTable<Basis<'static>>,
{
    let pass = const { *at(B::BASIS.parts.passes, I) };
    const { assert!(at(B::BASIS.parts.passes, I).profiles as usize == P, "other profiles") };
    sums_of_pass(&pass, const { B::BASIS.parts.degree }, transfer, light)
}

/// [`sums_of_pass`] of any pass of `P` profiles.
#[inline(never)]
fn any_sums<const P: usize>(pass: &Pass, transfer: &[f32], light: &Light<'_>) -> [[f32; LANES]; P] {
    sums_of_pass(pass, light.degree(), transfer, light.coefficients())
}

/// The sums of a pass, for a light of this degree.
#[inline(always)]
fn sums_of_pass<const P: usize>(
    pass: &Pass,
    degree: usize,
    transfer: &[f32],
    light: &[f32],
) -> [[f32; LANES]; P] {
    let mut sums = [[0.0; LANES]; P];
    let (groups, _) = part(transfer, pass.start as usize..).as_chunks::<LANES>();
    let (rows, _) = groups.as_chunks::<P>();
    let first = isize::from(pass.first);
    let lowest = layout::lowest_degree(first);
    for (l, row) in (lowest..).zip(part(rows, ..(degree + 1).saturating_sub(lowest))) {
        let window = window(light, l, first);
        for (sum, row) in sums.iter_mut().zip(row) {
            *sum = groups::multiply_add(*sum, row, &window);
        }
    }
    sums
}

/// L_l^m for the orders from `first` on. Orders beyond l read other coefficients or zero, which
/// does no harm because their rows are zero.
#[inline(always)]
fn window(light: &[f32], l: usize, first: isize) -> [f32; LANES] {
    let start = position(l, first);
    if let Some(window) = light.get(start..).and_then(|rest| rest.first_chunk()) {
        return *window;
    }
    let at = |lane: usize| light.get(start.wrapping_add(lane)).copied().unwrap_or(0.0);
    [at(0), at(1), at(2), at(3)]
}

#[inline(always)]
fn write_pass(slots: &[[u16; LANES]], sums: &[[f32; LANES]], coefficients: &mut [f32]) {
    for (slots, sums) in slots.iter().zip(sums) {
        for (&slot, &sum) in slots.iter().zip(sums) {
            if let Some(coefficient) = coefficients.get_mut(usize::from(slot)) {
                *coefficient = sum;
            }
        }
    }
}

/// Writes the components of run number `I`, which has `P` profiles. Not inlined: a compiler that
/// sees several orders at once runs out of registers.
#[inline(never)]
pub fn run<B, const I: usize, const P: usize, const T: usize, const N: usize, const K: usize>(
    transfer: &[f32; T],
    light: &[f32; N],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    let run = const { *at(B::BASIS.parts.runs, I) };
    const { assert!(at(B::BASIS.parts.runs, I).profiles as usize == P, "other profiles") };
    let sums = run_sums::<P>(&run, const { B::BASIS.parts.degree }, transfer, light);
    let components = const {
        components::<P>(B::BASIS.parts.profiles, at(B::BASIS.parts.runs, I).first as usize, P)
    };
    write_run(components, run.order, sums, coefficients);
}

/// The sums of a run of `P` profiles, for a light of this degree.
#[inline(always)]
fn run_sums<const P: usize>(run: &Run, degree: usize, transfer: &[f32], light: &[f32]) -> [f32; P] {
    let mut sums = [0.0; P];
    let (groups, _) = transfer.as_chunks::<LANES>();
    let (mut at, lane) = (run.start as usize / LANES, run.start as usize % LANES);
    let order = isize::from(run.order);
    let lowest = order.unsigned_abs();
    let mut of_light = position(lowest, order);
    for l in lowest..degree + 1 {
        let groups = groups.get(at..).and_then(<[_]>::first_chunk::<P>);
        let (Some(&light), Some(groups)) = (light.get(of_light), groups) else { break };
        for (sum, group) in sums.iter_mut().zip(groups) {
            let number = group.get(lane).copied().unwrap_or(0.0);
            *sum =
                if l == lowest { number * light } else { float::add_product(*sum, number, light) };
        }
        (at, of_light) = (at + usize::from(run.step) / LANES, of_light + 2 * l + 2);
    }
    sums
}

#[inline(always)]
fn write_run<const P: usize>(
    components: impl IntoIterator<Item = [u16; 2]>,
    order: i16,
    sums: [f32; P],
    coefficients: &mut [f32],
) {
    for (sum, [plus, minus]) in sums.into_iter().zip(components) {
        let component = if order < 0 { minus } else { plus };
        if let Some(coefficient) = coefficients.get_mut(usize::from(component)) {
            *coefficient = sum;
        }
    }
}

#[cfg(all(test, feature = "baked"))]
mod tests {
    use crate::light::Light;
    use crate::material::Material;
    use crate::sphere;

    /// Each machine takes one of the two ways.
    #[test]
    #[inline]
    fn passes_and_runs_agree_bit_for_bit() {
        let light: [f32; sphere::LIGHT] = core::array::from_fn(|k| (7 * k % 19) as f32 - 9.0);
        let material = [0.3f32; 40];
        let transfer = Material::new(&material).and_then(|material| sphere::transfer(&material));
        let transfer = transfer.as_ref().map_or(&[][..], |transfer| transfer.as_slice());
        assert_eq!(transfer.len(), sphere::TRANSFER);
        for degree in 0..=sphere::DEGREE {
            let light = Light::new(&light).map(|light| light.truncated(degree));
            let Ok(light) = light else { unreachable!("the light of the table's degree") };
            let [mut passes, mut runs] = [[f32::NAN; sphere::COMPONENTS]; 2];
            sphere::BASIS.relight_passes(transfer, &light, &mut passes);
            sphere::BASIS.relight_runs(transfer, &light, &mut runs);
            assert_eq!(passes, runs, "degree {degree}");
        }
    }
}

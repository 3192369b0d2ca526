//! A new light on a transferred material: d_i = Σ_l T_i,l L_l^m.
//!
//! A machine that computes with groups of numbers takes a transfer pass by pass. The lanes run
//! along m, as do the light's coefficients of one degree, so nothing is gathered and nothing is
//! summed across lanes. Lanes with |m| > l multiply coefficients of other degrees by zero.
//!
//! Other machines take it run by run, that is, order by order: this skips products with zero, and
//! reads each coefficient of the light once.

use crate::basis::Basis;
use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::float;
use crate::index::{layout::LANES, light::position};
use crate::invariant::part;
use crate::lanes;
use crate::light::Light;
use crate::places::{KnownTable, PassPlace, Run};
use crate::projection::Coefficients;
use crate::transfer::Transfer;

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

impl Basis<'_> {
    /// Computes d for a new light on a material whose transfer is known, with one multiplication
    /// for each of the [`transfer_len`](Self::transfer_len) numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the degree of the light exceeds that of the basis, [`Error::Length`] if
    /// the transfer belongs to another basis, [`Error::Capacity`] if `K` is less than
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
    /// [`Error::Beyond`] if the degree of the light exceeds that of the basis, [`Error::Length`]
    /// unless `transfer` has [`transfer_len`](Self::transfer_len) numbers and `coefficients` has
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
        self.subtract_mean(coefficients);
        Ok(())
    }

    #[inline]
    fn relight_passes(&self, transfer: &[f32], light: &Light<'_>, coefficients: &mut [f32]) {
        let mut next = self.first_pass();
        while let Some(pass) = next {
            let degrees = (light.degree() + 1).saturating_sub(pass.lowest);
            by_profiles!(pass.profiles, P => {
                let sums = any_sums::<P>(&pass, degrees, transfer, light.coefficients());
                write_pass(&pass, &sums, coefficients);
            });
            next = self.pass_after(&pass);
        }
    }

    #[inline]
    fn relight_runs(&self, transfer: &[f32], light: &Light<'_>, coefficients: &mut [f32]) {
        let mut next = self.first_run();
        while let Some(run) = next {
            let degrees = (light.degree() + 1).saturating_sub(run.order.unsigned_abs());
            by_profiles!(run.profiles, P => {
                let sums = run_sums::<P>(&run, degrees, transfer, light.coefficients());
                write_run(self.components_of_run(&run), sums, coefficients);
            });
            next = self.run_after(&run);
        }
    }
}

/// The numbers of a transfer and of a light, if there are exactly `T` and `N`.
#[inline(always)]
pub fn inputs<'a, const T: usize, const N: usize>(
    transfer: &'a Transfer<T>,
    light: &Light<'a>,
) -> Option<(&'a [f32; T], &'a [f32; N])> {
    Some((transfer.as_slice().try_into().ok()?, light.coefficients().try_into().ok()?))
}

/// Writes the sums of pass number `I`, which has `P` profiles, to their components.
#[inline(always)]
pub fn write<B, const I: usize, const P: usize, const K: usize>(
    sums: &[[f32; LANES]; P],
    coefficients: &mut [f32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    write_pass(const { &pass_of::<B, P>(I) }, sums, coefficients);
}

#[expect(clippy::panic, reason = "while the program is compiled")]
#[inline]
const fn pass_of<B: KnownTable<Basis<'static>>, const P: usize>(index: usize) -> PassPlace {
    match B::BASIS.pass_at(index) {
        Some(pass) if pass.profiles == P => pass,
        _ => panic!("the table has no such pass"),
    }
}

#[expect(clippy::panic, reason = "while the program is compiled")]
#[inline]
const fn run_of<B: KnownTable<Basis<'static>>, const P: usize>(index: usize) -> Run {
    match B::BASIS.run_at(index) {
        Some(run) if run.profiles == P => run,
        _ => panic!("the table has no such run"),
    }
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
    let place = const { &pass_of::<B, P>(I) };
    let degrees = const { B::BASIS.parts.degree + 1 - pass_of::<B, P>(I).lowest };
    sums_of_pass(place, degrees, transfer, light)
}

/// [`sums_of_pass`] of any pass of `P` profiles.
#[inline(never)]
fn any_sums<const P: usize>(
    pass: &PassPlace,
    degrees: usize,
    transfer: &[f32],
    light: &[f32],
) -> [[f32; LANES]; P] {
    sums_of_pass(pass, degrees, transfer, light)
}

/// The sums of a pass, over this many degrees.
#[inline(always)]
fn sums_of_pass<const P: usize>(
    pass: &PassPlace,
    degrees: usize,
    transfer: &[f32],
    light: &[f32],
) -> [[f32; LANES]; P] {
    let mut sums = [[0.0; LANES]; P];
    let (groups, _) = part(transfer, pass.start..).as_chunks::<LANES>();
    let (rows, _) = groups.as_chunks::<P>();
    for (l, row) in (pass.lowest..).zip(part(rows, ..degrees)) {
        let window = window(light, l, pass.first);
        for (sum, row) in sums.iter_mut().zip(row) {
            *sum = lanes::multiply_add(*sum, row, &window);
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
fn write_pass(pass: &PassPlace, sums: &[[f32; LANES]], coefficients: &mut [f32]) {
    for (slots, sums) in pass.slots.iter().zip(sums) {
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
    let run = const { &run_of::<B, P>(I) };
    let degrees = const { B::BASIS.parts.degree + 1 - run_of::<B, P>(I).order.unsigned_abs() };
    let components = const { B::BASIS.run_components::<P>(&run_of::<B, P>(I)) };
    let sums = run_sums::<P>(run, degrees, transfer, light);
    write_run(components, sums, coefficients);
}

/// The sums of a run of `P` profiles, over this many degrees.
#[inline(always)]
fn run_sums<const P: usize>(
    run: &Run,
    degrees: usize,
    transfer: &[f32],
    light: &[f32],
) -> [f32; P] {
    let mut sums = [0.0; P];
    let (groups, _) = transfer.as_chunks::<LANES>();
    let (mut at, lane) = (run.start / LANES, run.start % LANES);
    let lowest = run.order.unsigned_abs();
    let mut of_light = position(lowest, run.order);
    for l in lowest..lowest + degrees {
        let groups = groups.get(at..).and_then(<[_]>::first_chunk::<P>);
        let (Some(&light), Some(groups)) = (light.get(of_light), groups) else { break };
        for (sum, group) in sums.iter_mut().zip(groups) {
            let number = group.get(lane).copied().unwrap_or(0.0);
            *sum =
                if l == lowest { number * light } else { float::add_product(*sum, number, light) };
        }
        (at, of_light) = (at + run.step / LANES, of_light + 2 * l + 2);
    }
    sums
}

#[inline(always)]
fn write_run<const P: usize>(
    components: impl IntoIterator<Item = u16>,
    sums: [f32; P],
    coefficients: &mut [f32],
) {
    for (sum, component) in sums.into_iter().zip(components) {
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

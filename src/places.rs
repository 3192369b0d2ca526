//! Where the numbers of one step are: the azimuths of a basis, the passes and runs of a transfer.
//!
//! Each step of the runtime is one function of a place. For a table that is known only at run time,
//! a loop asks for one place after the other. For a [`KnownTable`] the places are constants, and the
//! compiler specializes the same function for each of them; so the functions here are `const`.

use crate::basis::Basis;
use crate::index::layout::{LANES, PASS, factors, lowest_degree};
use crate::index::record::{ProfilePlace, Row};
use crate::invariant::part;
use crate::q15;
use crate::q15::Profile;
use crate::scene::signs;

/// A table that is known when the program is compiled, with a basis of type `B`.
pub trait KnownTable<B: 'static> {
    /// The basis.
    const BASIS: &'static B;
}

/// The place of one pass in a transfer.
#[derive(Clone, Copy)]
pub(crate) struct PassPlace {
    pub(crate) index: usize,
    /// Its first order m.
    pub(crate) first: isize,
    /// Its lowest degree.
    pub(crate) lowest: usize,
    pub(crate) profiles: usize,
    /// Position of its numbers in the transfer.
    pub(crate) start: usize,
    /// Position of its slots among all slots.
    pub(crate) first_slot: usize,
    /// For each profile and lane, the number of its component.
    pub(crate) slots: [[u16; LANES]; PASS],
}

/// The place of a run: profiles of one order whose rows stand side by side in a transfer.
#[derive(Clone, Copy)]
pub(crate) struct Run {
    /// The order m, with its sign.
    pub(crate) order: isize,
    /// Position of the number of the first profile and the lowest degree.
    pub(crate) start: usize,
    /// Distance from one degree to the next. One profile is [`LANES`] from the next.
    pub(crate) step: usize,
    pub(crate) profiles: usize,
    /// The number of its first profile.
    pub(crate) first: usize,
    /// The number of the first profile of this azimuth.
    of_azimuth: usize,
}

/// The place of an azimuth |m|.
#[derive(Clone, Copy)]
pub(crate) struct AzimuthPlace {
    pub(crate) azimuth: usize,
    /// Number of degrees from |m| on.
    pub(crate) degrees: usize,
    /// The number of its first profile.
    pub(crate) first: usize,
    pub(crate) profiles: usize,
    /// Position of the first row of its first profile. A profile has one row for each degree.
    pub(crate) rows: usize,
    /// Position of the terms of its first profile.
    pub(crate) terms: usize,
    /// Position of its polynomials in a scene.
    pub(crate) start: usize,
    /// Number of terms of each polynomial.
    pub(crate) length: usize,
}

/// The walk over azimuths of both kinds of basis: a `const` function cannot call a trait's.
macro_rules! azimuths {
    ([$($of:tt)*] $basis:ty, $profile:ident) => {
        impl $($of)* $basis {
            pub(crate) const fn first_azimuth(&self) -> AzimuthPlace {
                AzimuthPlace {
                    azimuth: 0,
                    degrees: self.parts.degree + 1,
                    first: 0,
                    profiles: self.count_of(0, 0),
                    rows: 0,
                    terms: 0,
                    start: 0,
                    length: self.length(0),
                }
            }

            pub(crate) const fn azimuth_after(&self, before: &AzimuthPlace) -> AzimuthPlace {
                let azimuth = before.azimuth + 1;
                let first = before.first + before.profiles;
                AzimuthPlace {
                    azimuth,
                    degrees: before.degrees.saturating_sub(1),
                    first,
                    profiles: self.count_of(first, azimuth),
                    rows: before.rows + before.profiles * before.degrees,
                    terms: before.terms + before.profiles * before.length,
                    start: before.start + signs(before.azimuth) * before.length,
                    length: self.length(azimuth),
                }
            }

            pub(crate) const fn azimuth_at(&self, azimuth: usize) -> AzimuthPlace {
                let mut place = self.first_azimuth();
                while place.azimuth < azimuth {
                    place = self.azimuth_after(&place);
                }
                place
            }

            /// Number of profiles of this azimuth, the first of which is number `first`.
            const fn count_of(&self, first: usize, azimuth: usize) -> usize {
                let mut count = 0;
                while let Some(profile) = self.profile(first + count)
                    && profile.azimuth() == azimuth
                {
                    count += 1;
                }
                count
            }

            /// Number of terms of an azimuth's polynomials; 0 if it has none.
            pub(crate) const fn length(&self, azimuth: usize) -> usize {
                match self.parts.lengths.split_at_checked(azimuth) {
                    Some((_, [length, ..])) => *length as usize,
                    _ => 0,
                }
            }

            const fn profile(&self, index: usize) -> Option<&'a $profile> {
                match self.parts.profiles.split_at_checked(index) {
                    Some((_, [profile, ..])) => Some(profile),
                    _ => None,
                }
            }
        }
    };
}
azimuths!([<'a>] Basis<'a>, ProfilePlace);
azimuths!([<'a>] q15::Basis<'a>, Profile);

impl<'a> q15::Basis<'a> {
    pub(crate) const fn profiles_at(&self, place: &AzimuthPlace) -> &'a [Profile] {
        let Some((_, rest)) = self.parts.profiles.split_at_checked(place.first) else { return &[] };
        match rest.split_at_checked(place.profiles) {
            Some((profiles, _)) => profiles,
            None => rest,
        }
    }
}

impl Basis<'_> {
    /// The components of +m and of -m of the `P` profiles of an azimuth.
    pub(crate) const fn components_of<const P: usize>(&self, azimuth: usize) -> [[u16; 2]; P] {
        let mut components = [[u16::MAX; 2]; P];
        let (mut to, mut next) = (components.as_mut_slice(), self.first_of(azimuth));
        while let [of_profile, others @ ..] = to
            && let Some(place) = self.profile(next)
        {
            *of_profile = [place.component(1), place.component(-1)];
            (to, next) = (others, next + 1);
        }
        components
    }

    /// Position of the factors of profile `index` of an azimuth; `index` is even.
    pub(crate) const fn factors_at(&self, azimuth: usize, index: usize) -> usize {
        let (mut start, mut before) = (0, 0);
        let mut first = 0;
        while before < azimuth {
            let next = self.first_of(before + 1);
            start += self.factors_of(before, next - first);
            (first, before) = (next, before + 1);
        }
        start + self.factors_of(azimuth, index)
    }

    const fn factors_of(&self, azimuth: usize, profiles: usize) -> usize {
        factors(self.parts.degree, self.factored_order(), azimuth, profiles)
    }

    /// The components of `2 C` profiles of an azimuth, from its profile `index` on: for each two
    /// profiles those of +m and those of -m. Where there is no profile, there is no component.
    pub(crate) const fn twos_of<const C: usize>(
        &self,
        azimuth: usize,
        index: usize,
    ) -> [[[u16; 2]; 2]; C] {
        let mut components = [[[u16::MAX; 2]; 2]; C];
        let (mut to, mut next) = (components.as_mut_slice(), self.first_of(azimuth) + index);
        let end = self.first_of(azimuth + 1);
        while let [[[a, b], [c, d]], others @ ..] = to {
            if next < end
                && let Some(place) = self.profile(next)
            {
                [*a, *c] = [place.component(1), place.component(-1)];
            }
            if next + 1 < end
                && let Some(place) = self.profile(next + 1)
            {
                [*b, *d] = [place.component(1), place.component(-1)];
            }
            (to, next) = (others, next + 2);
        }
        components
    }

    pub(crate) const fn first_pass(&self) -> Option<PassPlace> {
        self.pass(0, 0, 0)
    }

    pub(crate) const fn pass_after(&self, pass: &PassPlace) -> Option<PassPlace> {
        let slots = LANES * pass.profiles;
        let degrees = (self.parts.degree + 1).saturating_sub(pass.lowest);
        self.pass(pass.index + 1, pass.start + degrees * slots, pass.first_slot + slots)
    }

    pub(crate) const fn pass_at(&self, index: usize) -> Option<PassPlace> {
        let (mut pass, mut left) = (self.first_pass(), index);
        while let Some(before) = pass
            && left > 0
        {
            (pass, left) = (self.pass_after(&before), left - 1);
        }
        pass
    }

    const fn pass(&self, index: usize, start: usize, first_slot: usize) -> Option<PassPlace> {
        let Some((_, [pass, ..])) = self.parts.passes.split_at_checked(index) else { return None };
        let (first, profiles) = (pass.first as isize, pass.profiles as usize);
        let mut slots = [[u16::MAX; LANES]; PASS];
        let mut to = slots.as_mut_slice();
        let Some((_, mut rest)) = self.parts.slots.split_at_checked(first_slot) else {
            return None;
        };
        while let [slots, others @ ..] = to
            && let Some((found, more)) = rest.split_first_chunk()
        {
            (*slots, to, rest) = (*found, others, more);
        }
        let lowest = lowest_degree(first);
        Some(PassPlace { index, first, lowest, profiles, start, first_slot, slots })
    }

    pub(crate) const fn first_run(&self) -> Option<Run> {
        self.run(0, 0, 1)
    }

    /// The run that follows another: of the same order, the opposite one, or the next azimuth.
    pub(crate) const fn run_after(&self, run: &Run) -> Option<Run> {
        let next = run.first + run.profiles;
        match self.profile(next) {
            Some(place) if place.azimuth() == run.order.unsigned_abs() => {
                self.run(next, run.of_azimuth, run.order.signum() | 1)
            }
            _ if run.order > 0 => self.run(run.of_azimuth, run.of_azimuth, -1),
            _ => self.run(next, next, 1),
        }
    }

    pub(crate) const fn run_at(&self, index: usize) -> Option<Run> {
        let (mut run, mut left) = (self.first_run(), index);
        while let Some(before) = run
            && left > 0
        {
            (run, left) = (self.run_after(&before), left - 1);
        }
        run
    }

    /// The run that begins with this profile.
    const fn run(&self, first: usize, of_azimuth: usize, sign: isize) -> Option<Run> {
        let Some((_, [place, rest @ ..])) = self.parts.profiles.split_at_checked(first) else {
            return None;
        };
        let Row { start, step } = place.row(sign);
        let (mut rest, mut profiles) = (rest, 1);
        while let [next, others @ ..] = rest
            && next.azimuth == place.azimuth
            && next.row(sign).step == step
            && next.row(sign).start == start + (LANES * profiles) as u32
            && profiles < PASS
        {
            (rest, profiles) = (others, profiles + 1);
        }
        let order = sign * place.azimuth().cast_signed();
        let (start, step) = (start as usize, step as usize);
        Some(Run { order, start, step, profiles, first, of_azimuth })
    }

    pub(crate) fn components_of_run(&self, run: &Run) -> impl Iterator<Item = u16> {
        let (profiles, order) = (part(self.parts.profiles, run.first..), run.order);
        profiles.iter().map(move |place| place.component(order))
    }

    /// The components of a run of `P` profiles.
    pub(crate) const fn run_components<const P: usize>(&self, run: &Run) -> [u16; P] {
        let mut components = [u16::MAX; P];
        let (mut to, mut next) = (components.as_mut_slice(), run.first);
        while let [component, others @ ..] = to
            && let Some(place) = self.profile(next)
        {
            *component = place.component(run.order);
            (to, next) = (others, next + 1);
        }
        components
    }

    /// The number of the first profile of this azimuth.
    const fn first_of(&self, azimuth: usize) -> usize {
        let mut first = 0;
        while let Some(place) = self.profile(first)
            && place.azimuth() < azimuth
        {
            first += 1;
        }
        first
    }
}

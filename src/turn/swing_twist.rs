//! Turns the coefficients of lights, degree by degree, in floats or in integers.
//!
//! A rotation is a twist about the view axis z, followed by a swing about a horizontal axis: see
//! [`SwingTwist`]. With Rz for rotations about z and E for the exchange of y and z,
//!
//! R = Rz(a) Ry(b) Rz(-a) Rz(γ), Ry(b) = E Rz(-b) E,
//!
//! and Ry(b) - 1 = E (Rz(-b) - 1) E is small if the angle is. A light that is turned by small
//! angles many times then neither gains nor loses energy.

use crate::checked_slice::rows;
use crate::checked_slice::{part, part_mut, split, split_mut};
use crate::index::light;
use crate::index::light::MAX_DEGREE;
use core::ops::{Add, Neg};

/// The arithmetic of a number format. Numbers are scaled coefficients, factors are cosines and
/// sines, elements belong to the matrices that exchange y and z.
pub(crate) trait Arithmetic {
    type Coefficient: Copy;
    type Scale: Copy + Default;
    type Number: Copy + Default + Add<Output = Self::Number> + Neg<Output = Self::Number>;
    type Factor: Copy + Neg<Output = Self::Factor>;
    type Element: Copy + 'static;
    type Sum: Copy + Default;
    /// The matrices -E of all degrees.
    const EXCHANGE: &'static [Self::Element];
    /// The scale at which no step overflows for the coefficients of one degree.
    fn scale(coefficients: &[Self::Coefficient]) -> Self::Scale;
    fn scaled(scale: Self::Scale) -> impl Fn(Self::Coefficient) -> Self::Number;
    fn coefficient(number: Self::Number) -> Self::Coefficient;
    /// The complex product of a factor and a pair.
    fn product(factor: [Self::Factor; 2], pair: [Self::Number; 2]) -> [Self::Number; 2];
    /// sum + element number.
    fn add_product(sum: Self::Sum, element: Self::Element, number: Self::Number) -> Self::Sum;
    fn number(sum: Self::Sum) -> Self::Number;
}

/// exp(imα) - 1 for m = 1, 2, ...: real and imaginary part.
pub(crate) type Multiples<F> = [[F; 2]; MAX_DEGREE];

/// The scales of the degrees of a light.
pub(crate) type Scales<S> = [S; MAX_DEGREE + 1];

/// A rotation, prepared for lights up to degree 16.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SwingTwist<F> {
    /// Whether a half turn about y comes before the twist. The half turn keeps the swing to at most
    /// a right angle, so that only a swing by nothing has no axis, and needs none.
    pub flips: bool,
    /// Whether this is the inverse: the swing, then the twist, then the half turn.
    pub is_inverse: bool,
    /// Whether there is a swing.
    pub swings: bool,
    /// Whether the swing's angle is small. Then what it changes is computed and added.
    pub is_small: bool,
    /// γ.
    pub twist: Multiples<F>,
    /// a.
    pub axis: Multiples<F>,
    /// -b.
    pub swing: Multiples<F>,
}

/// Orders from 0 to 16, and one more to make pairs of them.
const ORDERS: usize = MAX_DEGREE + 2;

/// The coefficients of one degree of `C` lights by order, without the phase.
struct Degree<A: Arithmetic, const C: usize> {
    cosines: [[A::Number; C]; ORDERS],
    sines: [[A::Number; C]; ORDERS],
}

impl<F: Copy + Neg<Output = F>> SwingTwist<F> {
    /// Turns lights of the same or of different degrees, at most this one, each into as many
    /// coefficients. Degree l of the result is scaled by `scales[l]`.
    pub(crate) fn turn<A: Arithmetic<Factor = F>, const C: usize>(
        &self,
        degree: usize,
        lights: [&[A::Coefficient]; C],
        mut turned: [&mut [A::Coefficient]; C],
        scales: &mut [Scales<A::Scale>; C],
    ) {
        for (to, from) in turned.iter_mut().zip(&lights) {
            if let (Some(to), Some(&mean)) = (to.first_mut(), from.first()) {
                *to = mean;
            }
        }
        let mut elements = A::EXCHANGE;
        let mut numbers = [(); 3].map(|()| Degree::<A, C>::new());
        for l in 1..=degree {
            let range = light::count(l - 1)..light::count(l);
            let [of_degree, ..] = &mut numbers;
            for (channel, (light, scales)) in lights.iter().zip(scales.iter_mut()).enumerate() {
                // A light of a lower degree has none.
                let from = light.get(range.clone()).unwrap_or_default();
                let scale = A::scale(from);
                of_degree.load(channel, from, A::scaled(scale));
                if let Some(to) = scales.get_mut(l) {
                    *to = scale;
                }
            }
            self.apply(l, &mut elements, &mut numbers);
            let [of_degree, ..] = &mut numbers;
            for (channel, to) in turned.iter_mut().enumerate() {
                of_degree.store(channel, to.get_mut(range.clone()).unwrap_or_default());
            }
        }
    }

    /// Turns the coefficients of degree l, the first of three. `elements` are the matrices'
    /// elements from this degree on, and afterward from the next.
    fn apply<A: Arithmetic<Factor = F>, const C: usize>(
        &self,
        l: usize,
        elements: &mut &[A::Element],
        [light, swung, exchanged]: &mut [Degree<A, C>; 3],
    ) {
        let count = (l / 2 + 1).pow(2) + (l / 2).pow(2) + 2 * l.div_ceil(2).pow(2);
        let (matrix, others) = split(elements, count);
        *elements = others;
        if !self.is_inverse {
            self.flip(l, light);
            light.twist(l, &self.twist, false);
        }
        if self.swings && self.is_small {
            (swung.cosines, swung.sines) = (light.cosines, light.sines);
            self.swing(l, matrix, swung, exchanged);
            light.add(l, swung);
        } else if self.swings {
            self.swing(l, matrix, light, exchanged);
        }
        if self.is_inverse {
            light.twist(l, &self.twist, false);
            self.flip(l, light);
        }
    }

    /// The swing, or if it is small what it changes.
    fn swing<A: Arithmetic<Factor = F>, const C: usize>(
        &self,
        l: usize,
        matrix: &[A::Element],
        light: &mut Degree<A, C>,
        exchanged: &mut Degree<A, C>,
    ) {
        light.twist(l, &self.axis, true);
        light.exchange(l, matrix, exchanged);
        if self.is_small {
            exchanged.change(l, &self.swing);
        } else {
            exchanged.twist(l, &self.swing, false);
        }
        exchanged.exchange(l, matrix, light);
        light.twist(l, &self.axis, false);
    }

    /// The half turn about y, if there is one.
    #[inline(never)]
    fn flip<A: Arithmetic, const C: usize>(&self, l: usize, light: &mut Degree<A, C>) {
        if self.flips {
            let changed = if l.is_multiple_of(2) { &mut light.sines } else { &mut light.cosines };
            part_mut(changed, ..=l).as_flattened_mut().iter_mut().for_each(|x| *x = -*x);
        }
    }
}

impl<A: Arithmetic, const C: usize> Degree<A, C> {
    fn new() -> Self {
        let zeros = [[A::Number::default(); C]; ORDERS];
        Self { cosines: zeros, sines: zeros }
    }

    /// Takes in one channel's coefficients, of orders -l to l.
    #[inline(never)]
    fn load(
        &mut self,
        channel: usize,
        from: &[A::Coefficient],
        number: impl Fn(A::Coefficient) -> A::Number,
    ) {
        let (minus, plus) = split(from, from.len() / 2);
        for (to, &from) in self.sines.iter_mut().skip(1).zip(minus.iter().rev()) {
            to.get_mut(channel).into_iter().for_each(|to| *to = -number(from));
        }
        for (to, &from) in self.cosines.iter_mut().zip(plus) {
            to.get_mut(channel).into_iter().for_each(|to| *to = number(from));
        }
        self.negate_odd(channel, minus.len());
    }

    /// Writes one channel's coefficients. The channel then has no coefficients of a light any more.
    #[inline(never)]
    fn store(&mut self, channel: usize, to: &mut [A::Coefficient]) {
        let half = to.len() / 2;
        self.negate_odd(channel, half);
        let (minus, plus) = split_mut(to, half);
        for (to, from) in minus.iter_mut().rev().zip(self.sines.iter().skip(1)) {
            from.get(channel).into_iter().for_each(|&from| *to = A::coefficient(-from));
        }
        for (to, from) in plus.iter_mut().zip(&self.cosines) {
            from.get(channel).into_iter().for_each(|&from| *to = A::coefficient(from));
        }
    }

    /// The phase of the cosines; the phase of the sines is -1.
    #[inline(never)]
    fn negate_odd(&mut self, channel: usize, l: usize) {
        for odd in part_mut(&mut self.cosines, ..=l).iter_mut().skip(1).step_by(2) {
            odd.get_mut(channel).into_iter().for_each(|x| *x = -*x);
        }
    }

    /// Orders 1 to l.
    #[inline(always)]
    fn pairs(
        &mut self,
        l: usize,
    ) -> impl Iterator<Item = (&mut [A::Number; C], &mut [A::Number; C])> {
        part_mut(&mut self.cosines, 1..=l).iter_mut().zip(part_mut(&mut self.sines, 1..=l))
    }

    /// A rotation about z.
    #[inline(never)]
    fn twist(&mut self, l: usize, multiples: &Multiples<A::Factor>, is_back: bool) {
        for ((cosines, sines), &[c, s]) in self.pairs(l).zip(multiples) {
            let factor = [c, if is_back { -s } else { s }];
            for (c, s) in cosines.iter_mut().zip(sines) {
                let [dc, ds] = A::product(factor, [*c, *s]);
                [*c, *s] = [*c + dc, *s + ds];
            }
        }
    }

    /// The change that a rotation about z makes.
    #[inline(never)]
    fn change(&mut self, l: usize, multiples: &Multiples<A::Factor>) {
        let [zero, ..] = &mut self.cosines;
        *zero = [A::Number::default(); C];
        for ((cosines, sines), &factor) in self.pairs(l).zip(multiples) {
            for (c, s) in cosines.iter_mut().zip(sines) {
                [*c, *s] = A::product(factor, [*c, *s]);
            }
        }
    }

    #[inline(never)]
    fn add(&mut self, l: usize, other: &Self) {
        for (to, from) in [(&mut self.cosines, &other.cosines), (&mut self.sines, &other.sines)] {
            let (to, from) = (part_mut(to, ..=l).as_flattened_mut(), part(from, ..=l));
            to.iter_mut().zip(from.as_flattened()).for_each(|(to, &from)| *to = *to + from);
        }
    }

    #[inline(never)]
    fn exchange(&self, l: usize, mut matrix: &[A::Element], to: &mut Self) {
        let (even, odd) = (l / 2, l.div_ceil(2));
        let (c_even, c_odd) = (&self.cosines[..], part(&self.cosines, 1..));
        let (s_even, s_odd) = (part(&self.sines, 2..), part(&self.sines, 1..));
        let [a, b, c, d] = match l % 2 {
            0 => [c_even, s_even, c_odd, s_odd],
            _ => [s_odd, c_odd, s_even, c_even],
        };
        block::<A, C>(&mut matrix, even + 1, a, &mut to.cosines);
        block::<A, C>(&mut matrix, odd, b, part_mut(&mut to.cosines, 1..));
        block::<A, C>(&mut matrix, even, c, part_mut(&mut to.sines, 2..));
        block::<A, C>(&mut matrix, odd, d, part_mut(&mut to.sines, 1..));
    }
}

/// Multiplies every second order by the leading `size` x `size` elements, and removes these.
#[inline(never)]
fn block<A: Arithmetic, const C: usize>(
    matrix: &mut &[A::Element],
    size: usize,
    from: &[[A::Number; C]],
    to: &mut [[A::Number; C]],
) {
    let (block, others) = split(matrix, size * size);
    *matrix = others;
    let (from, to) = (from.as_chunks::<2>().0, to.as_chunks_mut::<2>().0);
    for ([to, _], row) in to.iter_mut().zip(rows(block, size)) {
        let mut sum = [A::Sum::default(); C];
        for ([from, _], &element) in from.iter().zip(row) {
            for (sum, &number) in sum.iter_mut().zip(from) {
                *sum = A::add_product(*sum, element, number);
            }
        }
        for (to, sum) in to.iter_mut().zip(sum) {
            *to = A::number(sum);
        }
    }
}

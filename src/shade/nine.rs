//! Scenes of nine terms or fewer: what a matte under light of degree 2 needs.

use crate::normal::Normals;
use crate::scalar::Scalar;
use crate::scene::{Descent, argument};

/// Terms of azimuths 0, 1 and 2, those of lower polynomials filled up with zeros.
pub(super) struct Nine<S> {
    pole: [S; 3],
    first: [[S; 2]; 2],
    second: [S; 2],
}

impl<S: Scalar> Nine<S> {
    /// `None` of a scene that has more.
    pub(super) fn new(mut polynomials: Descent<'_, S>) -> Option<Self> {
        let pole = filled(polynomials.pole)?;
        let ([_] | [_, _]) = polynomials.lengths else { return None };
        let second = match polynomials.lengths {
            [_] => Some((&[] as &[S], &[] as &[S])),
            _ => polynomials.next(),
        };
        let ((plus, minus), (first_plus, first_minus)) = (second?, polynomials.next()?);
        let ([plus], [minus]) = (filled(plus)?, filled(minus)?);
        let first = [filled(first_plus)?, filled(first_minus)?];
        Some(Self { pole, first, second: [plus, minus] })
    }

    /// The irradiance of each normal.
    pub(super) fn shade(&self, normals: Normals<'_, S>, irradiance: &mut [S]) {
        let Self { pole: [square, linear, constant], first: [plus, minus], second } = *self;
        let normals = normals.x.iter().zip(normals.y).zip(normals.z);
        for (out, ((&x, &y), &z)) in irradiance.iter_mut().zip(normals) {
            let t = argument(z);
            let [real, imaginary] = second;
            let [plus, minus] = [plus, minus].map(|[linear, of]| of.add_product(linear, t));
            let plus = plus.add_product(real, x).add_product(imaginary, y);
            let minus = minus.add_product(imaginary, x).add_product(-real, y);
            let pole = constant.add_product(linear.add_product(square, t), t);
            *out = pole.add_product(plus, x).add_product(minus, y);
        }
    }
}

/// Terms, highest first, after zeros; `None` if they are more.
fn filled<S: Scalar, const N: usize>(terms: &[S]) -> Option<[S; N]> {
    let mut filled = [S::ZERO; N];
    let zeros = N.checked_sub(terms.len())?;
    for (to, &term) in filled.iter_mut().skip(zeros).zip(terms) {
        *to = term;
    }
    Some(filled)
}

//! The polynomials of a table's profiles, in a form that `f32` represents accurately.
//!
//! At a high azimuth h = u / sin^|m| is orders of magnitude larger near the pole than at the rim.
//! In powers or halves of t the value at the rim is a small difference of large terms, and the
//! rounding error is proportional to the terms. This module measures that error for each azimuth.
//! From the first azimuth on where it is too large, the polynomials become series in other
//! polynomials, which are orthogonal over a sphere's normals and whose terms are nowhere larger
//! than the profile.

use crate::chebyshev::{clenshaw, polynomial};
use crate::table::Table;
use eigenshade_index::layout::{self, Form, Recurrence};

/// The largest error that rounding an azimuth's polynomials to `f32` may cause in a pixel: root
/// mean square over the database's images, relative to the largest such deviation of a pixel from
/// its mean. With all components no azimuth of GGX materials exceeds 2.5e-6 up to degree 12 and
/// order 12; at degree 16 azimuths from |m| = 6 on do.
const LIMIT: f64 = 4e-6;

/// The polynomials of all profiles.
pub(crate) struct Polynomials {
    /// Number of terms for each |m|.
    pub(crate) lengths: Vec<u16>,
    /// Recurrences of the last azimuths: [`layout::recurrences`].
    pub(crate) recurrences: Vec<Recurrence>,
    /// Terms of each profile, highest first.
    pub(crate) profiles: Vec<Vec<f64>>,
    /// Terms of the mean image, or empty.
    pub(crate) mean: Vec<f64>,
}

impl Polynomials {
    /// The polynomials of a table.
    pub(crate) fn new(table: &Table) -> Self {
        let lengths = lengths(table);
        let stride = usize::from(lengths.iter().copied().max().unwrap_or_default());
        let slants = Slants::new(table);
        let peak = slants.peak(table);
        let azimuths = lengths.iter().enumerate().map(|(azimuth, &length)| {
            Azimuth::new(table, &slants, azimuth, usize::from(length), stride)
        });
        let azimuths: Vec<Azimuth> = azimuths.collect();
        let steep = |one: &Azimuth| one.error > LIMIT * peak && one.orthogonal_error < one.error;
        // The table has too few nodes for this many terms. The generator does not make such tables.
        let known = table.gram.nodes.len() > stride;
        let first = azimuths.iter().position(steep).filter(|_| known).unwrap_or(lengths.len());
        let (mut profiles, mut mean, mut recurrences) = (Vec::new(), Vec::new(), Vec::new());
        for (azimuth, one) in azimuths.into_iter().enumerate() {
            if azimuth < first {
                profiles.extend(one.terms);
                mean.extend(one.mean);
            } else {
                profiles.extend(one.orthogonal);
                mean.extend(one.orthogonal_mean);
                recurrences.extend(one.recurrence);
            }
        }
        Self { lengths, recurrences, profiles, mean: mean.into_iter().flatten().collect() }
    }
}

/// The polynomials of one |m| in both forms, and the rounding error of each form.
struct Azimuth {
    terms: Vec<Vec<f64>>,
    mean: Option<Vec<f64>>,
    error: f64,
    recurrence: Vec<Recurrence>,
    orthogonal: Vec<Vec<f64>>,
    orthogonal_mean: Option<Vec<f64>>,
    orthogonal_error: f64,
}

impl Azimuth {
    fn new(table: &Table, slants: &Slants, azimuth: usize, length: usize, stride: usize) -> Self {
        let recurrence = slants.recurrence(azimuth, stride);
        let elements = slants.elements(azimuth, &recurrence[..length]);
        let of_azimuth = table.profiles.iter().enumerate();
        let of_azimuth = of_azimuth.filter(|(_, profile)| profile.azimuth == azimuth);
        let [mut error, mut orthogonal_error] = [0, 1].map(|_| vec![0.0; slants.nodes.len()]);
        let (mut terms, mut orthogonal) = (Vec::new(), Vec::new());
        for (k, profile) in of_azimuth {
            let short = polynomial(&profile.chebyshev, length);
            let series = elements.series(&profile.node_values);
            let variance = variance(table, k);
            for (node, slant) in slants.nodes.iter().enumerate() {
                let size = variance * slant.sine.powi(2 * azimuth as i32);
                let t = slant.t as f32;
                let exact = clenshaw(&profile.chebyshev, t.into());
                error[node] += size * (f64::from(short_in_f32(&short, t)) - exact).powi(2);
                let exact = elements.value(&series, t);
                let found = series_in_f32(&series, t, &recurrence);
                orthogonal_error[node] += size * (f64::from(found) - exact).powi(2);
            }
            terms.push(short);
            orthogonal.push(series);
        }
        let of_mean = table.mean.as_ref().filter(|_| azimuth == 0);
        Self {
            terms,
            mean: of_mean.map(|mean| polynomial(&mean.chebyshev, length)),
            error: if length > layout::EVEN_ODD_TERMS { f64::INFINITY } else { largest(&error) },
            orthogonal_mean: of_mean.map(|mean| elements.series(&slants.values(&mean.chebyshev))),
            recurrence,
            orthogonal,
            orthogonal_error: largest(&orthogonal_error),
        }
    }
}

/// The square root of the largest number.
fn largest(squares: &[f64]) -> f64 {
    squares.iter().copied().fold(0.0, f64::max).sqrt()
}

/// The variance of a profile's components over the database; 1 if the components are only a span.
fn variance(table: &Table, profile: usize) -> f64 {
    if table.general.is_some() {
        return 1.0;
    }
    let components = table.components.iter().filter(|one| one.profile == profile);
    components.filter_map(|one| one.eigenvalue).sum()
}

/// The slants at the nodes of a table.
struct Slants {
    nodes: Vec<Slant>,
}

struct Slant {
    /// 2 cos α - 1.
    t: f64,
    /// sin α.
    sine: f64,
    root_weight: f64,
}

impl Slants {
    fn new(table: &Table) -> Self {
        let nodes = table.gram.nodes.iter().zip(&table.gram.root_weights);
        let nodes = nodes.map(|(&z, &root_weight)| Slant {
            t: 2.0 * z - 1.0,
            sine: ((1.0 - z) * (1.0 + z)).sqrt(),
            root_weight,
        });
        Self { nodes: nodes.collect() }
    }

    /// The largest root mean square deviation of a pixel from its mean, over the database's images.
    fn peak(&self, table: &Table) -> f64 {
        let mut squares = vec![0.0; self.nodes.len()];
        for (k, profile) in table.profiles.iter().enumerate() {
            let variance = variance(table, k);
            let values = profile.node_values.iter().zip(&self.nodes);
            for (square, (value, slant)) in squares.iter_mut().zip(values) {
                *square += variance * (value / slant.root_weight).powi(2);
            }
        }
        largest(&squares)
    }

    /// Values of a Chebyshev series at the nodes, times the root weights.
    fn values(&self, chebyshev: &[f64]) -> Vec<f64> {
        let value = |slant: &Slant| slant.root_weight * clenshaw(chebyshev, slant.t);
        self.nodes.iter().map(value).collect()
    }

    /// √w sin^|m|: with these weights, sums over the nodes are means over a sphere.
    fn weights(&self, azimuth: usize) -> Vec<f64> {
        let weight = |slant: &Slant| slant.root_weight * slant.sine.powi(azimuth as i32);
        self.nodes.iter().map(weight).collect()
    }

    /// The recurrence of an azimuth, by Stieltjes' procedure.
    fn recurrence(&self, azimuth: usize, count: usize) -> Vec<Recurrence> {
        let mut element = self.weights(azimuth);
        let mut before = vec![0.0; element.len()];
        let mut square_before = f64::INFINITY;
        let mut recurrence = Vec::with_capacity(count);
        for _ in 0..count {
            let square: f64 = element.iter().map(|value| value * value).sum();
            let moments = element.iter().zip(&self.nodes);
            let moment: f64 = moments.map(|(value, slant)| 2.0 * slant.t * value * value).sum();
            let (at, below) = (moment / square, square / square_before);
            recurrence.push([at as f32, below as f32]);
            for ((value, before), slant) in element.iter_mut().zip(&mut before).zip(&self.nodes) {
                let next = (2.0 * slant.t - at) * *value - below * *before;
                *before = std::mem::replace(value, next);
            }
            square_before = square;
        }
        recurrence
    }

    /// The polynomials of a recurrence, evaluated at the nodes.
    fn elements<'r>(&self, azimuth: usize, recurrence: &'r [Recurrence]) -> Elements<'r> {
        let mut values = Vec::with_capacity(recurrence.len());
        let mut element = self.weights(azimuth);
        let mut before = vec![0.0; element.len()];
        for coefficients in recurrence {
            let [at, below] = coefficients.map(f64::from);
            values.push(element.clone());
            for ((value, before), slant) in element.iter_mut().zip(&mut before).zip(&self.nodes) {
                let next = (2.0 * slant.t - at) * *value - below * *before;
                *before = std::mem::replace(value, next);
            }
        }
        Elements { recurrence, values }
    }
}

/// The polynomials e_k of a recurrence.
struct Elements<'r> {
    recurrence: &'r [Recurrence],
    /// √w sin^|m| e_k for each k, at each node.
    values: Vec<Vec<f64>>,
}

impl Elements<'_> {
    /// The series, highest term first, of a profile with these weighted values.
    fn series(&self, values: &[f64]) -> Vec<f64> {
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let squares: Vec<f64> = self.values.iter().map(|one| product(one, one)).collect();
        let mut series = vec![0.0; squares.len()];
        let mut rest = values.to_vec();
        // The polynomials are orthogonal only to the f32 precision of their coefficients, so the
        // projection is repeated on the remainder.
        for _ in 0..10 {
            let missed: Vec<f64> = self.values.iter().map(|one| product(one, &rest)).collect();
            for ((term, missed), (square, one)) in
                series.iter_mut().zip(missed).zip(squares.iter().zip(&self.values))
            {
                let more = missed / square;
                *term += more;
                rest.iter_mut().zip(one).for_each(|(rest, value)| *rest -= more * value);
            }
        }
        series.reverse();
        series
    }

    /// The value of a series, highest term first, in f64.
    fn value(&self, series: &[f64], t: f32) -> f64 {
        let t = f64::from(t);
        let (mut sum, mut element, mut before) = (0.0, 1.0, 0.0);
        for (term, coefficients) in series.iter().rev().zip(self.recurrence) {
            let [at, below] = coefficients.map(f64::from);
            sum += term * element;
            (element, before) = ((2.0 * t - at) * element - below * before, element);
        }
        sum
    }
}

/// The value of a series in f32, summed in the same way as in the runtime.
fn series_in_f32(series: &[f64], t: f32, recurrence: &[Recurrence]) -> f32 {
    let (mut sum, mut element, mut before) = (0.0f32, 1.0f32, 0.0f32);
    for (&term, [at, below]) in series.iter().rev().zip(recurrence) {
        sum += term as f32 * element;
        (element, before) = ((2.0 * t - at) * element - below * before, element);
    }
    sum
}

/// The value of a polynomial in the form that its length determines, summed in f32 by Horner's rule
/// in the same way as in the runtime.
fn short_in_f32(terms: &[f64], t: f32) -> f32 {
    match Form::of(terms.len()) {
        Form::Monomial => terms.iter().fold(0.0, |sum, &term| sum * t + term as f32),
        Form::EvenOdd => {
            let (u, alone) = (2.0 * t * t - 1.0, terms.len() % 2);
            let first = terms[..alone].iter().fold(0.0, |_, &term| term as f32);
            terms[alone..]
                .chunks_exact(2)
                .fold(first, |sum, two| sum * u + (two[1] as f32 + two[0] as f32 * t))
        }
    }
}

/// Number of terms for each azimuth: that of its longest profile.
fn lengths(table: &Table) -> Vec<u16> {
    let mut lengths = vec![0; table.gram.degree + 1];
    let profiles = table.profiles.iter().map(|profile| (profile.azimuth, &profile.chebyshev));
    for (azimuth, chebyshev) in profiles.chain(table.mean.iter().map(|mean| (0, &mean.chebyshev))) {
        let length = u16::try_from(chebyshev.len()).expect("a polynomial's length is small");
        lengths[azimuth] = length.max(lengths[azimuth]);
    }
    lengths
}

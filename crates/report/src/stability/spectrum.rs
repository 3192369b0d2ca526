//! M is singular; order and sign of components whose eigenvalues are equal, nearly equal or zero.

use super::{Figure, GramRoot, exactly, least, left_vectors, most, off_orthonormal, tight};
use crate::tolerances;
use eigenshade_generator::basis::moments::Deviation;
use eigenshade_generator::basis::pca::{Block, principal};
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_generator::basis::{self, gram};
use eigenshade_model::database::Named;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_table::{GramFactor, Table, encode, material};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{fixtures, largest, largest_difference};
use faer::Mat;
use nalgebra::{DMatrix, DVector};

/// M^(-1/2) by eigenvalues, (28) and (33), at degree 9 and order 7.
pub(super) fn root() -> Vec<Figure> {
    let gram = gram::of_sphere(9, 7);
    let block = |azimuth| {
        let columns = gram.columns(azimuth).into_iter().map(DVector::from_vec);
        GramRoot::new(&DMatrix::from_columns(&columns.collect::<Vec<_>>()))
    };
    let blocks: Vec<GramRoot> = (0..=9).map(block).collect();
    let share = |of: fn(&GramRoot) -> [usize; 2]| {
        let [part, all] = [0, 1].map(|k| blocks.iter().map(|one| of(one)[k]).sum::<usize>());
        part as f64 / all as f64
    };
    let (negative, not_numbers) = (share(|one| one.negative), share(|one| one.not_numbers));
    let worst = largest(blocks.iter().map(|one| one.off));
    let ours = basis::orthonormality(&fixtures::table(&fixtures::shipped("curet")), 100);
    vec![
        least("share of M's eigenvalues that are negative", negative, tolerances::NAIVE_NEGATIVE),
        // One negative eigenvalue spoils its whole block.
        least("share of M^(-1/2) that is NaN", not_numbers, 0.99),
        least("|UᵀMU - I| with the eigenvalues' sizes", worst, tolerances::NAIVE_ROOT),
        most("|UᵀMU - I| here, 100 components", ours, tolerances::ORTHONORMAL_MODES),
    ]
}

/// The ranks of the paper's modes in exact arithmetic for |m| = 0..9.
const EXACT: [usize; 10] = [25, 25, 24, 23, 22, 21, 20, 19, 17, 14];
/// The ranks that f64 resolves above a share of the largest singular value.
const RESOLVED: [(f64, [usize; 10]); 3] = [
    (1e-7, [13, 13, 12, 12, 11, 10, 10, 9, 8, 7]),
    (1e-10, [15, 14, 14, 13, 13, 12, 11, 11, 10, 9]),
    (1e-13, [17, 16, 16, 15, 14, 14, 13, 12, 12, 11]),
];

/// Singular values of A, relative to the largest of all blocks, by |m|.
fn singular_values(gram: &GramFactor) -> Vec<Vec<f64>> {
    let block = |azimuth| Block::new(gram, azimuth, &|_, _, _, _| true).expect("finite");
    let blocks: Vec<_> = (0..=gram.degree).map(|m| block(m).singular_values).collect();
    let most = largest(blocks.iter().flatten().copied());
    blocks.iter().map(|block| block.iter().map(|value| value / most).collect()).collect()
}

/// The exact rank of the modes of |m| = `m` up to a degree and an order, modulo a prime.
///
/// With f_s = K D (C_o R_p + C_p R_o), the modes with o = p give every D R_o whose C_o is not zero,
/// and then the other products follow. For each l and q that couples at all, the modes span the
/// products D_l^mq R_p^q. Factors that depend only on l, m, q and p do not affect the span.
///
/// Up to such factors, d^l_mn = Σ_k (-1)^(m-n+k) s^(m-n+2k) c^(2l+n-m-2k) / ((l+n-k)! k! (m-n+k)!
/// (l-m-k)!), where s and c are the sine and cosine of α/2, D is the sum of d^l_mn over n = ±q, and
/// R_p^q is ρ^q = (√2 s)^q times a polynomial in ρ² = 2 s². A product of D and R is therefore
/// (s/c)^m c^(m+q) times a polynomial in x = s² with rational coefficients. Products of even q and
/// of odd q are independent, so the rank is that of two families of polynomials, each over a common
/// power of c. It is the rank of their values at as many points as they have coefficients. Modulo a
/// prime the rank can only fall; if two large primes agree, it has not fallen.
fn exact_rank(degree: usize, order: usize, m: usize) -> usize {
    let [degree, order, m] = [degree, order, m].map(usize::cast_signed);
    let [first, second] = [(1 << 61) - 1, (1 << 31) - 1].map(|prime| {
        let field = Field(prime);
        (0..2).map(|parity| field.rank(field.rows(degree, order, m, parity))).sum()
    });
    assert_eq!(first, second, "two primes disagree");
    first
}

/// n! over a product of factorials, which is an integer.
fn quotient<const N: usize>(n: isize, below: [isize; N]) -> i128 {
    let factorial = |n: isize| (1..=n).map(|i| i as i128).product::<i128>();
    factorial(n) / below.into_iter().map(factorial).product::<i128>()
}

/// Numbers modulo a prime.
#[derive(Clone, Copy)]
struct Field(i128);

impl Field {
    fn power(self, base: i128, exponent: i128) -> i128 {
        match exponent {
            0 => 1,
            odd if odd % 2 == 1 => base * self.power(base, odd - 1) % self.0,
            even => self.power(base * base % self.0, even / 2),
        }
    }

    /// Σ_k (-1)^k a b^c d^e for terms (k, a, [(b, c), (d, e)]).
    fn sum(self, terms: impl Iterator<Item = (isize, i128, [(i128, isize); 2])>) -> i128 {
        terms.fold(0, |sum, (k, coefficient, [(b, c), (d, e)])| {
            let sign = if k % 2 == 0 { 1 } else { -1 };
            let powers = self.power(b, c as i128) * self.power(d, e as i128) % self.0;
            (sum + sign * (coefficient % self.0 * powers % self.0)).rem_euclid(self.0)
        })
    }

    /// (2l)! d^l_mn s^q c^q / (s^m c^m) for n = ±q.
    fn wigner(self, l: isize, m: isize, n: isize, x: i128) -> i128 {
        let q = n.abs();
        let term = |k: isize| {
            let coefficient = quotient(2 * l, [l + n - k, k, m - n + k, l - m - k]);
            let (s, c) = ((q - n) / 2 + k, l - m - k + (q + n) / 2);
            (m - n + k, coefficient, [(x, s), (self.0 + 1 - x, c)])
        };
        self.sum((0.max(n - m)..=(l + n).min(l - m)).map(term))
    }

    /// R_p^q / ρ^q, by the explicit sum.
    fn radial(self, p: isize, q: isize, x: i128) -> i128 {
        let half = (p - q) / 2;
        let term = |k: isize| {
            (k, quotient(p - k, [k, half - k, half + q - k]), [(2 * x, half - k), (1, 0)])
        };
        self.sum((0..=half).map(term))
    }

    /// All products of one parity of q at enough points, over (s/c)^m c^(m + parity), a power of c.
    fn rows(self, degree: isize, order: isize, m: isize, parity: isize) -> Vec<Vec<i128>> {
        let mut rows = Vec::new();
        for q in (parity..=order.min(degree)).step_by(2) {
            let terms = |l: isize| (q..=order).step_by(2).map(move |p| (l, p));
            for (l, p) in (m.max(q)..=degree).flat_map(terms) {
                let at = |x: i128| {
                    let sign = if q % 2 == 0 { 1 } else { self.0 - 1 };
                    let minus = if q == 0 { 0 } else { sign * self.wigner(l, m, -q, x) };
                    let turned = (self.wigner(l, m, q, x) + minus) % self.0;
                    let common = self.power(self.0 + 1 - x, ((order - q) / 2) as i128);
                    turned * self.radial(p, q, x) % self.0 * common % self.0
                };
                rows.push((1..=(degree + order + 1) as i128).map(at).collect());
            }
        }
        rows
    }

    /// The rank, by elimination.
    fn rank(self, mut rows: Vec<Vec<i128>>) -> usize {
        let mut rank = 0;
        for column in 0..rows.first().map_or(0, Vec::len) {
            let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else {
                continue;
            };
            rows.swap(rank, pivot);
            let (top, rest) = rows.split_at_mut(rank + 1);
            let inverse = self.power(top[rank][column], self.0 - 2);
            for row in rest.iter_mut().filter(|row| row[column] != 0) {
                let factor = row[column] * inverse % self.0;
                for (value, pivot) in row.iter_mut().zip(&top[rank]) {
                    *value = (*value - factor * pivot).rem_euclid(self.0);
                }
            }
            rank += 1;
        }
        rank
    }
}

/// Ranks of A at several cut-offs, against the exact rank.
pub(super) fn ranks() -> Vec<Figure> {
    let exact: Vec<usize> = (0..=9).map(|azimuth| exact_rank(9, 7, azimuth)).collect();
    // The exact rank assumes this: each l and q couples. 1e-4 is far above rounding.
    let integrals = PolarIntegrals::new(9, 7);
    for (q, l) in (0..=7).flat_map(|q| (q..=9).map(move |l| (q, l))) {
        let couples = (q..=7).step_by(2).any(|o| integrals.row(o, q)[l].abs() > 1e-4);
        assert!(couples, "degree {l} and q = {q} do not couple");
    }
    let values = singular_values(&gram::of_sphere(9, 7));
    let above = |cutoff: f64| -> Vec<usize> {
        values.iter().map(|block| block.iter().filter(|value| **value > cutoff).count()).collect()
    };
    let count = |found: &[usize], of: &[usize], is: fn(&usize, &usize) -> bool| {
        found.iter().zip(of).filter(|(a, b)| is(a, b)).count()
    };
    let over = |cutoff| count(&above(cutoff), &exact, |found, exact| found > exact) as f64;
    let whole = count(&above(1e-15), &exact, |found, exact| found >= exact);
    let total: usize = exact[0] + 2 * exact[1..].iter().sum::<usize>();
    let beyond = values.iter().zip(&exact).flat_map(|(block, &rank)| block.iter().skip(rank));
    let beyond = largest(beyond.copied());
    let resolved = RESOLVED.map(|(cutoff, recorded)| {
        let found = above(cutoff);
        let ranks: Vec<String> = found.iter().map(usize::to_string).collect();
        let what = format!("rank above {cutoff:e}: {}; other |m|", ranks.join(" "));
        exactly(what, count(&found, &recorded, |a, b| a != b), 0)
    });
    let of_exact = [
        exactly("|m| with the exact rank above", count(&exact, &EXACT, |a, b| a == b), 10),
        exactly("exact rank", total, 395),
    ];
    let rounded = [
        exactly("|m| with the whole rank above 1e-15", whole, 0),
        most("|m| with more than the exact rank above 1e-15", over(1e-15), 0.0),
        // At least one block counts rounding.
        least("|m| with more than the exact rank above 1e-17", over(1e-17), 1.0),
        tight("largest singular value beyond the exact rank", beyond, tolerances::BEYOND_RANK),
    ];
    of_exact.into_iter().chain(resolved).chain(rounded).collect()
}

pub(super) fn more_than_rank() -> Vec<Figure> {
    let loaded = fixtures::shipped("curet");
    let table = fixtures::table(&loaded);
    let error = fixtures::reconstruction_error(&loaded, &table);
    let eigenvalues = || table.components.iter().filter_map(|one| one.eigenvalue);
    let weakest = eigenvalues().fold(1.0, f64::min) / eigenvalues().fold(0.0, f64::max);
    vec![
        exactly("components, of an exact rank of 395", table.components.len(), 218),
        // The square of the scene's cut-off.
        least("weakest eigenvalue, of the largest", weakest, 1e-20),
        tight("images of the database, of the peak", error, tolerances::ALL_COMPONENTS_SHIPPED),
    ]
}

/// The components of two tables of one scene, compared.
pub struct Agreement {
    /// The number of components compared: those whose eigenvalues exceed 1e-24 of the largest.
    pub compared: usize,
    /// The components of another order or sign.
    pub different: Vec<usize>,
    /// The least product of a component with its counterpart, both of unit length.
    pub least: f64,
}

/// Compares the order and the sign of two tables' components.
pub fn agreement(a: &Table, b: &Table) -> Agreement {
    /// The least eigenvalue that is compared, relative to the largest.
    const FLOOR: f64 = 1e-24;
    /// The product with another component is near 0, with the component's negative near -1.
    const ALIKE: f64 = 0.5;
    let most = largest(a.components.iter().filter_map(|one| one.eigenvalue));
    let above = |table: &Table| {
        let values = table.components.iter().map(|one| one.eigenvalue);
        values.take_while(|value| value.is_none_or(|value| value > FLOOR * most)).count()
    };
    let compared = above(a).min(above(b));
    let (mut different, mut least) = (Vec::new(), f64::INFINITY);
    for (k, (one, other)) in a.components.iter().zip(&b.components).take(compared).enumerate() {
        let (u, v) = (&a.profiles[one.profile], &b.profiles[other.profile]);
        let product: f64 = u.node_values.iter().zip(&v.node_values).map(|(u, v)| u * v).sum();
        least = least.min(product);
        if one.order != other.order || product < ALIKE {
            different.push(k);
        }
    }
    Agreement { compared, different, least }
}

/// Components of +m and -m have equal eigenvalues; the weakest have 1e-24 of the largest.
pub(super) fn order_and_sign() -> Vec<Figure> {
    let mut loaded = fixtures::shipped("curet");
    loaded.scene.basis.rank_cutoff = 1e-13;
    let table = fixtures::table(&loaded);
    let again = encode(&fixtures::table(&loaded)) == encode(&table);
    // Up to an ulp is more than the effect of any other order of summation or instruction set.
    let mut numbers = Numbers(5);
    let mut shaken = loaded.clone();
    let entries = shaken.lights.entries.iter_mut().chain(&mut shaken.materials.entries);
    for value in entries.flat_map(|entry: &mut Named| &mut entry.rgb).flatten() {
        *value *= 1.0 + f64::EPSILON * numbers.next().round();
    }
    let other = fixtures::table(&shaken);
    let Agreement { compared, different, .. } = agreement(&table, &other);
    let most_of_all = largest(table.components.iter().filter_map(|one| one.eigenvalue));
    let pairs = table.components.iter().zip(&other.components).take(compared);
    let apart = pairs.filter_map(|(a, b)| Some((a.eigenvalue? - b.eigenvalue?) / most_of_all));
    let apart = largest(apart);
    let signs = table.profiles.iter().filter(|one| evaluate(&one.chebyshev, 1.0) <= 0.0).count();
    vec![
        exactly("runs that differ in a byte", usize::from(!again), 0),
        // Some 240 have eigenvalues above 1e-24 of the largest.
        least("components compared", compared as f64, 200.0),
        exactly("components of another order or sign after an ulp", different.len(), 0),
        exactly("profiles not positive at the pole", signs, 0),
        tight("eigenvalues after an ulp, of the largest", apart, tolerances::EIGENVALUE_ULP),
    ]
}

fn dense(matrix: &Mat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// Orthonormal images of known lengths: eigenvalues that are 1e-15 to 1e-3 apart, and zero.
pub(super) fn nearly_equal() -> Vec<Figure> {
    let gram = gram::of_sphere(6, 5);
    let block = Block::new(&gram, 0, &|_, _, _, _| true).expect("finite");
    let deviation = |material| Deviation { degree: 2, material };
    // Images of plain materials under one degree.
    let plain = [(0, 0), (2, 0), (4, 0), (1, 1), (3, 1)].map(|(o, q)| {
        let mut material = DVector::zeros(material::count(5));
        material[material::position(o, q, q)] = 1.0;
        material
    });
    let of_plain = plain.each_ref().map(|one| deviation(one.as_slice().to_vec()));
    let triangle = dense(&block.images(&gram, &of_plain)).qr().r().lu();
    let (mut orthogonality, mut values, mut squared, mut found) = (0.0f64, 0.0f64, 0.0f64, 0);
    for gap in [0.0, 1e-15, 1e-12, 1e-8, 1e-3] {
        let sizes = [1.0, 1.0 - gap, 1e-4, 1e-4 * (1.0 - gap), 1e-9];
        let wanted = DMatrix::from_diagonal(&DVector::from_row_slice(&sizes));
        let mix = triangle.solve(&wanted).expect("independent images");
        let mixed = DMatrix::from_columns(&plain) * mix;
        let mixed = mixed.column_iter().map(|one| deviation(one.iter().copied().collect()));
        // An image of zeros gives an eigenvalue of zero.
        let black = deviation(vec![0.0; material::count(5)]);
        let images = block.images(&gram, &mixed.chain([black]).collect::<Vec<_>>());
        let ours = principal(&images, None, 0).expect("finite");
        let of_five = |vectors: DMatrix<f64>| off_orthonormal(&vectors.columns(0, 5).into_owned());
        orthogonality = largest([orthogonality, of_five(dense(&ours.coordinates))]);
        squared = squared.max(of_five(left_vectors(&dense(&images)).0));
        values = values.max(largest_difference(&sizes, &ours.singular_values[..5]));
        found = found.max(ours.singular_values.iter().filter(|value| **value > 1e-14).count());
    }
    vec![
        // An image of 1e-9 has a square of 1e-18, far below the rounding of the largest, 1e-16.
        // Divided by its root, it is not orthogonal to the others.
        least("|WᵀW - I| from squares", squared, 1e-8),
        most("|WᵀW - I| here", orthogonality, tolerances::ORTHONORMAL_NODES),
        most("singular values, of the largest", values, tolerances::SINGULAR_VALUE),
        exactly("singular values that are not zero", found, 5),
    ]
}

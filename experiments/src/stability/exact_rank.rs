//! The exact rank of M for each |m|, computed modulo a prime.
//!
//! With f_s = K D (C_o R_p + C_p R_o), the modes with o = p give every D R_o whose C_o is not zero,
//! and then the other products follow. For each l and q that couples at all, the modes span the
//! products D_l^mq R_p^q. Factors that depend only on l, m, q and p do not affect the span.
//!
//! Up to such factors, d^l_mn = Σ_k (-1)^(m-n+k) s^(m-n+2k) c^(2l+n-m-2k) / ((l+n-k)! k! (m-n+k)!
//! (l-m-k)!), where s and c are the sine and cosine of α/2, D is the sum of d^l_mn over n = ±q, and
//! R_p^q is ρ^q = (√2 s)^q times a polynomial in ρ² = 2 s². A product of D and R is therefore
//! (s/c)^m c^(m+q) times a polynomial in x = s² with rational coefficients. Products of even q and
//! of odd q are independent, so the rank is that of two families of polynomials, each over a common
//! power of c. It is the rank of their values at as many points as they have coefficients. Modulo a
//! prime the rank can only fall; if two large primes agree, it has not fallen.

/// Rank of the modes of |m| = `m` up to a degree and an order.
pub fn rank(degree: usize, order: usize, m: usize) -> usize {
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

    /// All products of one parity of q at enough points, each divided by (s/c)^m c^(m + parity) and
    /// a common power of c.
    fn rows(self, degree: isize, order: isize, m: isize, parity: isize) -> Vec<Vec<i128>> {
        let mut rows = Vec::new();
        for q in (parity..=order.min(degree)).step_by(2) {
            for (l, p) in
                (m.max(q)..=degree).flat_map(|l| (q..=order).step_by(2).map(move |p| (l, p)))
            {
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

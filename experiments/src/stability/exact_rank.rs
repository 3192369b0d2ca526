//! The exact rank of M for each |m|, computed modulo a prime.
//!
//! With f_s = K D (C_o R_p + C_p R_o), the modes with o = p give every D R_o whose C_o is not zero,
//! and then the other products follow. For each l and q that couples at all, the modes span the
//! products D_l^mq R_p^q. Factors that depend only on l, m, q and p do not affect the span. Up to
//! such factors, d^l_mq = s^|m-q| c^|m+q| times a polynomial in s² with rational coefficients,
//! where s and c are the sine and cosine of α/2, and D is the sum over ±q. A product is therefore
//! sin^m c^q times a rational function of s². Products of even q and of odd q are independent, so
//! the rank is that of two matrices of rationals. Modulo a prime the rank can only fall; if two
//! large primes agree, it has not fallen.

/// Rank of the modes of |m| = `m` up to a degree and an order.
pub fn rank(degree: usize, order: usize, m: usize) -> usize {
    let [first, second] = [(1 << 61) - 1, (1 << 31) - 1].map(|prime| {
        let field = Field(prime);
        (0..2).map(|parity| field.rank(field.rows(degree, order, m, parity))).sum()
    });
    assert_eq!(first, second, "two primes disagree");
    first
}

/// Numbers modulo a prime.
#[derive(Clone, Copy)]
struct Field(u64);

/// Coefficients in x = (1 - z)/2 = s², lowest power first.
type Polynomial = Vec<u64>;

impl Field {
    fn integer(self, value: i64) -> u64 {
        value.rem_euclid(self.0 as i64) as u64
    }

    fn times(self, a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(self.0)) as u64
    }

    fn plus(self, a: u64, b: u64) -> u64 {
        ((u128::from(a) + u128::from(b)) % u128::from(self.0)) as u64
    }

    fn inverse(self, value: u64) -> u64 {
        let (mut power, mut base, mut exponent) = (1, value, self.0 - 2);
        while exponent > 0 {
            if exponent % 2 == 1 {
                power = self.times(power, base);
            }
            base = self.times(base, base);
            exponent /= 2;
        }
        power
    }

    fn binomial(self, n: usize, k: usize) -> u64 {
        if k > n {
            return 0;
        }
        (0..k).fold(1, |value, i| {
            let ratio =
                self.times(self.integer((n - i) as i64), self.inverse(self.integer(i as i64 + 1)));
            self.times(value, ratio)
        })
    }

    fn product(self, a: &[u64], b: &[u64]) -> Polynomial {
        let mut product = vec![0; a.len() + b.len() - 1];
        for (i, a) in a.iter().enumerate() {
            for (j, b) in b.iter().enumerate() {
                product[i + j] = self.plus(product[i + j], self.times(*a, *b));
            }
        }
        product
    }

    fn sum(self, a: &[u64], b: &[u64], sign: i64) -> Polynomial {
        let at = |p: &[u64], k: usize| p.get(k).copied().unwrap_or(0);
        let sign = self.integer(sign);
        (0..a.len().max(b.len())).map(|k| self.plus(at(a, k), self.times(sign, at(b, k)))).collect()
    }

    /// x^power.
    fn monomial(power: usize) -> Polynomial {
        (0..=power).map(|k| u64::from(k == power)).collect()
    }

    /// (1 - x)^power = c^(2 power).
    fn cosines(self, power: usize) -> Polynomial {
        (0..power).fold(vec![1], |value, _| self.product(&value, &[1, self.integer(-1)]))
    }

    /// d^l_mn / (s^|m-n| c^|m+n|) for m >= |n|, without the factor √((l+m)!(l-m)!(l+n)!(l-n)!),
    /// which is the same for ±n. Uses the explicit sum Σ_k (-1)^(m-n+k) s^2k c^2(l-m-k) /
    /// ((l+n-..)! ..).
    fn wigner(self, l: usize, m: usize, n: i64) -> (usize, usize, Polynomial) {
        let (l, m) = (l as i64, m as i64);
        let mut sum = vec![0];
        let low = 0.max(n - m);
        let high = (l + n).min(l - m);
        // Powers of s: m - n + 2k; powers of c: 2l + n - m - 2k.
        let (least_s, least_c) = (m - n + 2 * low, 2 * l + n - m - 2 * high);
        for k in low..=high {
            let denominator = [l + n - k, k, m - n + k, l - m - k]
                .into_iter()
                .flat_map(|top| 1..=top)
                .fold(1, |value, i| self.times(value, self.integer(i)));
            let sign = if (m - n + k) % 2 == 0 { 1 } else { -1 };
            let (s, c) = ((m - n + 2 * k - least_s) / 2, (2 * l + n - m - 2 * k - least_c) / 2);
            let term = self.product(&Self::monomial(s as usize), &self.cosines(c as usize));
            let scale = [self.times(self.integer(sign), self.inverse(denominator))];
            sum = self.sum(&sum, &self.product(&term, &scale), 1);
        }
        (least_s as usize, least_c as usize, sum)
    }

    /// R_p^q / ρ^q in x = ρ²/2, by the explicit sum.
    fn radial(self, p: usize, q: usize) -> Polynomial {
        let half = (p - q) / 2;
        let mut terms = vec![0; half + 1];
        for k in 0..=half {
            // (-1)^k C(p-k, k) C(p-2k, half-k), with ρ^(p-q-2k) = (2x)^(half-k).
            let value = self.times(self.binomial(p - k, k), self.binomial(p - 2 * k, half - k));
            let power = (0..half - k).fold(1, |power, _| self.plus(power, power));
            let sign = self.integer(if k % 2 == 0 { 1 } else { -1 });
            terms[half - k] = self.times(sign, self.times(value, power));
        }
        terms
    }

    /// All products of one parity of q, each divided by s^m c^(m + parity).
    fn rows(self, degree: usize, order: usize, m: usize, parity: usize) -> Vec<Polynomial> {
        let mut rows = Vec::new();
        for q in (parity..=order.min(degree)).step_by(2) {
            for l in m.max(q)..=degree {
                let turn = |n: i64| {
                    let (s, c, polynomial) = self.wigner(l, m, n);
                    // s^s c^c ρ^q divided by s^m c^m; ρ^q = (√2 s)^q.
                    let over = self.product(&polynomial, &Self::monomial((s + q - m) / 2));
                    // c^-q is factored out, so that only whole powers of c² remain.
                    (over, (c + q - m) / 2)
                };
                let (plus, powers) = turn(q as i64);
                let (minus, others) = turn(-(q as i64));
                let raise = |polynomial: &[u64], power: usize| {
                    self.product(polynomial, &self.cosines(power))
                };
                let sign = if q % 2 == 0 { 1 } else { -1 };
                let turned = if q == 0 {
                    raise(&plus, powers)
                } else {
                    self.sum(&raise(&plus, powers), &raise(&minus, others), sign)
                };
                for p in (q..=order).step_by(2) {
                    rows.push((q, self.product(&turned, &self.radial(p, q))));
                }
            }
        }
        // All relative to c^-q of the largest q.
        let most = rows.iter().map(|(q, _)| *q).max().unwrap_or(0);
        rows.into_iter().map(|(q, row)| self.product(&row, &self.cosines((most - q) / 2))).collect()
    }

    /// The rank, by elimination.
    fn rank(self, mut rows: Vec<Polynomial>) -> usize {
        let width = rows.iter().map(Vec::len).max().unwrap_or(0);
        rows.iter_mut().for_each(|row| row.resize(width, 0));
        let mut rank = 0;
        for column in 0..width {
            let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else {
                continue;
            };
            rows.swap(rank, pivot);
            let (top, rest) = rows.split_at_mut(rank + 1);
            let pivot = &top[rank];
            let inverse = self.inverse(pivot[column]);
            for row in rest.iter_mut().filter(|row| row[column] != 0) {
                let factor = self.times(row[column], inverse);
                let factor = (self.0 - factor) % self.0;
                for (value, pivot) in row.iter_mut().zip(pivot) {
                    *value = self.plus(*value, self.times(factor, *pivot));
                }
            }
            rank += 1;
        }
        rank
    }
}

"""N_l^q C_lo^q of (11) for l and o to 64, by exact integration of powers.

python3 crates/generator/tests/vectors/polar_integral_high.py

With z = cos(theta) and s = 1 + z the integrand of

    N_l^q C_lo^q = N_l^q int_0^1 R_o^q(sqrt(1 - z)) P_l^q(z) z dz

is (2 - s)^q s^(q/2) times a polynomial in s with rational coefficients; each power of
s is integrated from 1 to 2 in closed form. Even q: rational numbers. Odd q: the one
irrational is sqrt(2). Neither quadrature nor a recurrence. Needs mpmath.
"""

import random
from fractions import Fraction
from math import comb, factorial
from pathlib import Path

from mpmath import mp, mpf, nstr, pi, sqrt

mp.dps = 200
HIGHEST = 64
ROWS = 600


def product(a, b):
    c = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] += x * y
    return c


def substituted(polynomial, line):
    """The polynomial at a linear polynomial, by Horner's rule."""
    result = [Fraction(0)]
    for coefficient in reversed(polynomial):
        result = product(result, line)
        result[0] += coefficient
    return result


def legendre_derivative(l, q):
    """d^q/dz^q of P_l, powers of z."""
    c = [Fraction(0)] * (l + 1)
    for k in range(l // 2 + 1):
        c[l - 2 * k] = Fraction((-1) ** k * comb(l, k) * comb(2 * l - 2 * k, l), 2**l)
    for _ in range(q):
        c = [k * c[k] for k in range(1, len(c))]
    return c


def radial(o, q):
    """R_o^q(rho) / rho^q, powers of rho^2."""
    c = [Fraction(0)] * ((o - q) // 2 + 1)
    for k in range((o - q) // 2 + 1):
        size = factorial(o - k) // (
            factorial(k) * factorial((o + q) // 2 - k) * factorial((o - q) // 2 - k)
        )
        c[(o - q) // 2 - k] = Fraction((-1) ** k * size)
    return c


def polar_integral(l, o, q):
    z, square = [Fraction(-1), Fraction(1)], [Fraction(2), Fraction(-1)]
    integrand = product(substituted(legendre_derivative(l, q), z), z)
    integrand = product(integrand, substituted(radial(o, q), square))
    for _ in range(q):
        integrand = product(integrand, square)
    half = Fraction(q, 2)
    # Rational and sqrt(2) parts of the integral over s from 1 to 2.
    rational, irrational = Fraction(0), Fraction(0)
    for k, c in enumerate(integrand):
        power = k + half + 1
        rational -= c / power
        if q % 2 == 0:
            rational += c * 2 ** int(power) / power
        else:
            irrational += c * 2 ** int(power - Fraction(1, 2)) / power
    number = lambda x: mpf(x.numerator) / x.denominator
    square = Fraction(2 * l + 1, 4) * Fraction(factorial(l - q), factorial(l + q))
    value = number(rational) + number(irrational) * sqrt(2)
    return (-1) ** q * sqrt(number(square) / pi) * value


def main():
    random.seed(64)
    corners = [(l, o, q) for l in (33, 48, 63, 64) for o in (32, 33, 63, 64) for q in range(o + 1)]
    corners = [(l, o, q) for l, o, q in corners if (o - q) % 2 == 0 and q <= l]
    wanted = set(random.sample(corners, ROWS // 3))
    while len(wanted) < ROWS:
        l, o = random.randint(0, HIGHEST), random.randint(0, HIGHEST)
        q = random.randrange(o % 2, o + 1, 2)
        if q <= l:
            wanted.add((l, o, q))
    lines = ["# " + __doc__.split("\n")[2], "l,o,q,normalised"]
    lines += [f"{l},{o},{q},{nstr(polar_integral(l, o, q), 25)}" for l, o, q in sorted(wanted)]
    Path(__file__).with_suffix(".csv").write_text("\n".join(lines) + "\n")


main()

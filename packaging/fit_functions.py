#!/usr/bin/python3
"""Prints the polynomials of kernel/src/frep/functions.h, and how accurate they are (needs python3-mpmath).

Each interpolates a function at Chebyshev nodes, which is nearly the best that its degree can do. Its first coefficient
is given, so that the function of a tiny argument is exact.
"""

from mpmath import asin, atan, atanh, cos, fabs, linspace, log, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 60


def fit(name, function, low, high, degree, first=1, slope=None):
    """Prints coefficients for the range; `slope` is the derivative at 0, where a node may be."""
    low, high = mpf(low), mpf(high) * (1 + mpf("1e-6"))  # range reduction rounds

    def rest(x):
        return slope if fabs(x) < mpf("1e-30") else (function(x) - first) / x

    nodes = [(low + high) / 2 + (high - low) / 2 * cos(pi * (2 * i + 1) / (2 * degree)) for i in range(degree)]
    powers = matrix(degree, degree)
    for i, x in enumerate(nodes):
        for j in range(degree):
            powers[i, j] = x**j
    solved = lu_solve(powers, matrix([rest(x) for x in nodes]))
    made = [float(first)] + [float(number) for number in solved]
    worst = max(
        fabs(sum(mpf(number) * x**j for j, number in enumerate(made)) / function(x) - 1)
        for x in linspace(low + (high - low) * mpf("1e-9"), high, 2001)
    )
    print(f"{name}: relative error {nstr(worst, 3)}\n  " + ",\n  ".join(repr(number) for number in made))


def of_square(function):
    """f(r) / r as a function of r^2."""
    return lambda s: function(sqrt(s)) / sqrt(s)


fit("sine_series", of_square(sin), 0, (pi / 2) ** 2, 7)
fit("short_sine_series", of_square(sin), 0, (pi / 4) ** 2, 5)
fit("short_cosine_series", lambda s: cos(sqrt(s)), 0, (pi / 4) ** 2, 6)
fit("exponential_series", lambda t: mpf(2) ** t, -mpf(1) / 2 * (1 + mpf("1e-6")), mpf(1) / 2, 9, slope=log(2))
fit("logarithm_series", of_square(lambda f: 2 * atanh(f)), 0, ((sqrt(2) - 1) / (sqrt(2) + 1)) ** 2, 6, first=2)
fit("arctangent_series", of_square(atan), 0, tan(pi / 8) ** 2, 9)
fit("arcsine_series", of_square(asin), 0, mpf(1) / 4, 10)

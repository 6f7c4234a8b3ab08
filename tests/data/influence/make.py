#!/usr/bin/env python3
"""Makes random_points.csv: the nine influence coefficients at random points, by numerical integration.

No closed form is used. The kernels of Boussinesq and Cerruti are homogeneous of degree -1, k(t r) = k(r)/t,
so that div(k r) = k. The integral over a rectangle is therefore the integral of k times r.n around its edge,

    sum over the four sides of d * integral of k along the side, d = distance of the field point from its line.

With s = d sinh(t) along a side, the nearest poles of the integrand are at a distance of pi/2 from the axis.
Gauss-Legendre quadrature with NODES nodes on pieces of length one is accurate to DIGITS digits; for a far cell, about
thirty of them cancel between the four sides. Every tenth point is recomputed with 50 % more digits and nodes, and some
far points by the adaptive quadrature of mpmath over the cell itself. All must agree to 40 digits of the largest
coefficient.
"""

import pathlib
import random

from mpmath import mp, mpf

DIGITS = 80
NODES = 60
POINTS = 120
HEAD = """\
# Influence coefficients of a uniformly loaded rectangle |x| <= a, |y| <= b on a half-space at random points, by
# numerical integration around its edge in 80-digit arithmetic (make.py, mpmath); rounded to 20 digits.
# Body 1 and body 2: E or G marks the modulus given. The second body may be rigid. Displacement u1 - u2, tractions act on body 1.
id,x,y,a,b,modulus1,nu1,modulus2,nu2,xx,xy,xz,yx,yy,yz,zx,zy,zz
"""
RATIOS = [-0.5, 0.0, 0.29, 0.499999, 0.5]


def kernels(x, y):
    """Returns 1/r, x^2/r^3, x y/r^3, x/r^2 and y/r^2."""
    r2 = x * x + y * y
    r = mp.sqrt(r2)
    return mp.matrix([1 / r, x * x / (r2 * r), x * y / (r2 * r), x / r2, y / r2])


def gauss_legendre(n):
    """Returns nodes and weights on [-1, 1], by Newton's method."""
    rule = []
    for i in range(n):
        x = mp.cos(mp.pi * (i + mpf(3) / 4) / (n + mpf(1) / 2))
        for _ in range(10):
            below, p = mpf(1), x
            for k in range(2, n + 1):
                below, p = p, ((2 * k - 1) * x * p - (k - 1) * below) / k
            slope = n * (x * p - below) / (x * x - 1)
            x -= p / slope
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


def around_the_edge(x, y, a, b):
    """Integrates the kernels for the field point (x, y) over the loaded cell."""
    total = mp.matrix(5, 1)
    # Vectors from the load to the field point; each side is given by its line and its ends.
    for sign, offset, ends, is_turned in [
        (1, x + a, (y - b, y + b), False),
        (-1, x - a, (y - b, y + b), False),
        (1, y + b, (x - a, x + a), True),
        (-1, y - b, (x - a, x + a), True),
    ]:
        if offset == 0:
            continue
        d = abs(offset)
        low, high = (mp.asinh(end / d) for end in ends)
        pieces = 1 + int(high - low)
        half = (high - low) / (2 * pieces)
        for piece in range(pieces):
            middle = low + (2 * piece + 1) * half
            for node, weight in around_the_edge.rule:
                e = mp.exp(middle + half * node)
                s, stretch = d * (e - 1 / e) / 2, d * (e + 1 / e) / 2
                at = (s, offset) if is_turned else (offset, s)
                total += kernels(*at) * (sign * offset * half * weight * stretch)
    return total


def over_the_cell(x, y, a, b):
    """Integrates the kernels by quadrature over the area, for a cell that is far away."""
    def at(k):
        inner = lambda s: mp.quad(lambda t: kernels(x + s, y + t)[k], [-b, b], method="gauss-legendre")
        return mp.quad(inner, [-a, a], method="gauss-legendre")
    return mp.matrix([at(k) for k in range(5)])


def one_body(modulus, nu, integrals):
    """Returns the nine coefficients of a body with the shear modulus `modulus`."""
    potential, along_x, diagonal, radial_x, radial_y = integrals
    f = 1 / (2 * mp.pi * modulus)
    xx = f * ((1 - nu) * potential + nu * along_x)
    yy = f * ((1 - nu) * potential + nu * (potential - along_x))
    zz = f * (1 - nu) * potential
    xy = f * nu * diagonal
    zx = f * (1 - 2 * nu) / 2 * radial_x
    zy = f * (1 - 2 * nu) / 2 * radial_y
    return mp.matrix([xx, xy, -zx, xy, yy, -zy, zx, zy, zz])


# The shear on body 2 has the opposite sign.
AS_BODY_2 = [1, 1, -1, 1, 1, -1, -1, -1, 1]


def coefficients(x, y, a, b, bodies, integrate):
    integrals = integrate(mpf(x), mpf(y), mpf(a), mpf(b))
    tensors = [one_body(mpf(g), mpf(nu), integrals) for g, nu in bodies]
    total = tensors[0]
    if len(tensors) == 2:
        total += mp.matrix([s * c for s, c in zip(AS_BODY_2, tensors[1])])
    return total


def assert_equal(first, second):
    largest = max(abs(c) for c in first)
    difference = max(abs(p - q) for p, q in zip(first, second))
    assert difference < largest * mpf(10) ** -40, (difference / largest)


def draw(pick, index):
    """Draws a cell, a field point and one or two bodies."""
    size = 10.0 ** pick.uniform(-7, 2)
    aspect = 10.0 ** pick.uniform(-2, 2) if index % 4 else [0.01, 100.0, 1.0][index // 4 % 3]
    a, b = size, size * aspect
    longer = 2 * max(a, b)
    kind = ["inside", "edge", "beside", "near", "middle", "far"][index % 6]
    angle = pick.uniform(0, 2 * mp.pi)
    if kind == "inside":
        x, y = a * pick.uniform(-1, 1), b * pick.uniform(-1, 1)
    elif kind == "edge":
        # On an edge, at a corner, or very close to it.
        x = a * pick.choice([1.0, -1.0, 1.0 + 1e-9])
        y = b * pick.choice([1.0, -1.0, pick.uniform(-1, 1), 1.0 - 1e-6])
    elif kind == "beside":
        # Near the middle of a side, at a distance in units of the other side.
        x, y = a * pick.uniform(-1, 1), b * (1 + 10.0 ** pick.uniform(-3, 1))
        if pick.random() < 0.5:
            x, y = a * (1 + 10.0 ** pick.uniform(-3, 1)), b * pick.uniform(-1, 1)
    else:
        decades = {"near": (-0.5, 1), "middle": (1, 3), "far": (3, 6)}[kind]
        distance = longer * 10.0 ** pick.uniform(*decades)
        x, y = float(distance * mp.cos(angle)), float(distance * mp.sin(angle))
    bodies = [(10.0 ** pick.uniform(-3, 12), RATIOS[index // 6 % 5])]
    if index % 5 == 4:
        bodies.append((bodies[0][0] * 10.0 ** pick.uniform(-1, 1), pick.choice(RATIOS)))
    return x, y, a, b, bodies


def set_digits(digits, nodes):
    mp.dps = digits
    around_the_edge.rule = gauss_legendre(nodes)


def main():
    set_digits(DIGITS, NODES)
    pick = random.Random(20210629)
    lines = []
    for index in range(POINTS):
        x, y, a, b, bodies = draw(pick, index)
        values = coefficients(x, y, a, b, bodies, around_the_edge)
        if index % 10 == 0:
            set_digits(DIGITS * 3 // 2, NODES * 3 // 2)
            assert_equal(values, coefficients(x, y, a, b, bodies, around_the_edge))
            set_digits(DIGITS, NODES)
        if index % 30 == 5:
            assert_equal(values, coefficients(x, y, a, b, bodies, over_the_cell))
        cells = [f"R{index:03}", *map(repr, (x, y, a, b))]
        for g, nu in bodies:
            cells += [f"G{g!r}", repr(nu)]
        cells += [] if len(bodies) == 2 else ["rigid", "0"]
        cells += [mp.nstr(value, 20) for value in values]
        lines.append(",".join(cells))
    path = pathlib.Path(__file__).with_name("random_points.csv")
    path.write_text(HEAD + "\n".join(lines) + "\n")


main()

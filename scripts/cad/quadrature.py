"""Reference values that have no closed form, from plain quadrature and the definition of B-splines."""

import math


def gauss(count):
    """Points and weights of Gauss's rule on [-1, 1], by Newton's method on the Legendre polynomial."""
    points, weights = [], []
    for i in range(count):
        x = math.cos(math.pi * (i + 0.75) / (count + 0.5))
        for _ in range(50):
            p, q = 1.0, 0.0
            for k in range(count):
                p, q = ((2 * k + 1) * x * p - k * q) / (k + 1), p
            slope = count * (x * p - q) / (x * x - 1)
            step = p / slope
            x -= step
            if abs(step) < 1e-16:
                break
        points.append(x)
        weights.append(2 / ((1 - x * x) * slope * slope))
    return points, weights


RULE = gauss(20)


def integral(function, low, high, pieces=1):
    """Of a smooth function."""
    total = 0.0
    for k in range(pieces):
        a = low + (high - low) * k / pieces
        b = low + (high - low) * (k + 1) / pieces
        for x, w in zip(*RULE):
            total += 0.5 * (b - a) * w * function(0.5 * (a + b) + 0.5 * (b - a) * x)
    return total


def de_boor(points, knots, degree, t, derivative=False):
    """A point of a B-spline curve, or its derivative; knots with their multiplicities."""
    if derivative:
        slopes = [
            [degree * (b - a) / (knots[i + degree + 1] - knots[i + 1]) for a, b in zip(points[i], points[i + 1])]
            for i in range(len(points) - 1)
        ]
        return de_boor(slopes, knots[1:-1], degree - 1, t)
    span = degree
    while span + 1 < len(points) and knots[span + 1] <= t:
        span += 1
    d = [list(points[span - degree + j]) for j in range(degree + 1)]
    for r in range(1, degree + 1):
        for j in range(degree, r - 1, -1):
            i = span - degree + j
            a = (t - knots[i]) / (knots[i + degree - r + 1] - knots[i])
            d[j] = [(1 - a) * p + a * q for p, q in zip(d[j - 1], d[j])]
    return d[degree]


def area_and_length(points, knots, degree):
    """Of a plane curve: half the integral of x dy - y dx (Green's theorem), and its length."""
    area = length = 0.0
    breaks = sorted(set(knots[degree : len(points) + 1]))
    for a, b in zip(breaks, breaks[1:]):

        def speed(t):
            return math.hypot(*de_boor(points, knots, degree, t, True)[:2])

        def green(t):
            p, q = de_boor(points, knots, degree, t), de_boor(points, knots, degree, t, True)
            return 0.5 * (p[0] * q[1] - p[1] * q[0])

        area += integral(green, a, b)
        length += integral(speed, a, b, 8)
    return area, length


def triangle(a, b):
    """Half of x dy - y dx along the line from a to b."""
    return 0.5 * (a[0] * b[1] - a[1] * b[0])


def ellipse_length(a, b):
    """Its circumference, by the arithmetic and geometric mean."""
    a0, g, power = max(a, b), min(a, b), 0.5
    total, start = 0.0, a0
    c = math.sqrt(a0 * a0 - g * g)
    total = power * c * c
    x, y = a0, g
    for _ in range(30):
        x, y, c = 0.5 * (x + y), math.sqrt(x * y), 0.5 * (x - y)
        power *= 2
        total += power * c * c
        if c < 1e-17 * start:
            break
    return 2 * math.pi * (start * start - total) / x


def bilinear_area(a, b, c, d):
    """Of the surface through the corners a b c d in turn."""

    def piece(u, v):
        du = [(1 - v) * (q - p) + v * (r - s) for p, q, r, s in zip(a, b, c, d)]
        dv = [(1 - u) * (s - p) + u * (r - q) for p, q, r, s in zip(a, b, c, d)]
        n = (du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0])
        return math.sqrt(sum(x * x for x in n))

    return integral(lambda u: integral(lambda v: piece(u, v), 0, 1), 0, 1)

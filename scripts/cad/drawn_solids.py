"""Solids over polygons and splines, polyhedra, lofts and sweeps."""

import math

from expected import Body
from quadrature import area_and_length, bilinear_area, de_boor, ellipse_length, integral, triangle
from gmsh_shapes import solid, occ, box, cut, prism, polyhedron, pi


# Polygons and polyhedra


@solid
def l_profile():
    return [prism([(0, 0), (20, 0), (20, 3), (3, 3), (3, 15), (0, 15)], 40)]


@solid
def cross_profile():
    b = prism([(1, 0), (2, 0), (2, 1), (3, 1), (3, 2), (2, 2), (2, 3), (1, 3), (1, 2), (0, 2), (0, 1), (1, 1)], 7)
    return [b]


@solid
def stairs():
    corners = [(0, 0)] + [p for i in range(8) for p in ((8 - i, i), (8 - i, i + 1))] + [(0, 8)]
    return [prism(corners, 5)]


@solid
def hexagon():
    return [prism([(5 * math.cos(pi * i / 3), 5 * math.sin(pi * i / 3)) for i in range(6)], 4)]


@solid
def star():
    return [prism([((10 if i % 2 else 4) * math.cos(pi * i / 12), (10 if i % 2 else 4) * math.sin(pi * i / 12)) for i in range(24)], 3)]


@solid
def tetrahedron():
    return [polyhedron([(0, 0, 0), (5, 0, 0), (0, 6, 0), (0, 0, 7)], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])]


@solid
def octahedron():
    p = [(3, 0, 0), (-3, 0, 0), (0, 4, 0), (0, -4, 0), (0, 0, 5), (0, 0, -5)]
    f = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    return [polyhedron(p, f)]


@solid
def pyramid():
    p = [(0, 0, 0), (6, 0, 0), (6, 6, 0), (0, 6, 0), (3, 3, 8)]
    return [polyhedron(p, [[3, 2, 1, 0], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])]


@solid
def frame():
    cut(box(20, 20, 20), box(16, 16, 30, (2, 2, -5)), box(16, 30, 16, (2, -5, 2)), box(30, 16, 16, (-5, 2, 2)))
    return [Body(8000 - 16**3 - 6 * 16 * 16 * 2, 6 * (400 - 256) + 6 * 4 * 16 * 2, genus=5)]


# Splines


def spline_curve(tags, knots, degree):
    """A curve of gmsh by its knots with their multiplicities."""
    distinct = sorted(set(knots))
    return occ().addBSpline(tags, degree=degree, knots=distinct, multiplicities=[knots.count(k) for k in distinct])


def extruded(curves, height):
    """Over closed plane curves."""
    occ().extrude([(2, occ().addPlaneSurface([occ().addCurveLoop(curves)]))], 0, 0, height)


def spline_prism(points, degree, height):
    """Over a B-spline curve and its chord."""
    tags = [occ().addPoint(x, y, 0) for x, y in points]
    knots = clamped(points, degree)
    extruded([spline_curve(tags, knots, degree), occ().addLine(tags[-1], tags[0])], height)
    base, length = area_and_length(points, knots, degree)
    base = abs(base + triangle(points[-1], points[0]))
    return Body(base * height, 2 * base + (length + math.dist(points[0], points[-1])) * height)


def clamped(points, degree):
    spans = len(points) - degree
    return [0.0] * degree + [i / spans for i in range(spans + 1)] + [1.0] * degree


@solid
def spline_wave():
    points = [(x, 3 * math.sin(0.9 * x)) for x in range(0, 21)] + [(22, -6), (0, -10)]
    return [spline_prism(points, 3, 5)]


@solid
def spline_blob():
    points = [(10 * math.cos(t / 6 * pi) * (1 + 0.3 * (t % 3)), 8 * math.sin(t / 6 * pi)) for t in range(12)]
    tags = [occ().addPoint(x, y, 0) for x, y in points]
    extruded([occ().addBSpline(tags + tags[:1])], 6)  # periodic, of degree 3
    # gmsh doubles the knot where a periodic spline closes.
    base, length = area_and_length(points + points[:2], [-2, -1, 0, *range(12), 11, 12, 13], 3)
    return [Body(base * 6, 2 * base + length * 6)]


@solid
def spline_quadratic():
    points = [(0, 0), (10, -3), (20, 0), (23, 8), (12, 12), (2, 9), (-3, 4)]
    return [spline_prism(points, 2, 3)]


@solid
def spline_quintic():
    points = [(0, 0), (10, -3), (20, 0), (23, 8), (12, 12), (2, 9), (-3, 4), (-2, 2)]
    return [spline_prism(points, 5, 3)]


@solid
def spline_polyline():
    points = [(0, 0), (10, 0), (12, 5), (7, 9), (-1, 6)]
    return [spline_prism(points, 1, 3)]


@solid
def airfoil():
    def half(x):
        return 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x**3 - 0.1015 * x**4)

    xs = [0.5 * (1 + math.cos(pi * i / 15)) for i in range(16)]  # from the trailing edge to the nose
    sides = [[(100 * x, sign * 100 * half(x)) for x in xs] for sign in (1, -1)]
    nose = occ().addPoint(0, 0, 0)
    tags = [[occ().addPoint(x, y, 0) for x, y in side[:-1]] + [nose] for side in sides]
    knots = clamped(xs, 3)
    curves = [spline_curve(side, knots, 3) for side in tags]
    extruded([curves[0], curves[1], occ().addLine(tags[1][0], tags[0][0])], 40)
    (upper, length), (lower, _) = (area_and_length(side, knots, 3) for side in sides)
    base, back = upper - lower + triangle(sides[1][0], sides[0][0]), math.dist(sides[0][0], sides[1][0])
    return [Body(base * 40, 2 * base + (2 * length + back) * 40)]


@solid
def bezier_prism():
    points = [(0, 0), (12, -4), (14, 10), (0, 8)]
    tags = [occ().addPoint(x, y, 0) for x, y in points]
    loop = occ().addCurveLoop([occ().addBezier(tags), occ().addLine(tags[-1], tags[0])])
    occ().extrude([(2, occ().addPlaneSurface([loop]))], 0, 0, 5)
    base, length = area_and_length(points, clamped(points, 3), 3)
    base += triangle(points[-1], points[0])
    return [Body(base * 5, 2 * base + (length + 8) * 5)]


@solid
def ellipse_20_2():
    face = occ().addPlaneSurface([occ().addCurveLoop([occ().addEllipse(0, 0, 0, 20, 2)])])
    occ().extrude([(2, face)], 0, 0, 10)
    return [Body(pi * 400, 2 * pi * 40 + 10 * ellipse_length(20, 2))]


@solid
def ellipse_tube():
    outer, inner = occ().addDisk(0, 0, 0, 20, 12), occ().addDisk(0, 0, 0, 18, 10)
    occ().extrude(occ().cut([(2, outer)], [(2, inner)])[0], 0, 0, 10)
    base = pi * 60
    return [Body(base * 10, 2 * base + 10 * (ellipse_length(20, 12) + ellipse_length(18, 10)), genus=1)]


@solid
def revolved_spline():
    points = [(5, 0), (9, 3), (3, 8), (7, 12), (6, 16)]
    knots = clamped(points, 3)
    tags = [occ().addPoint(x, 0, z) for x, z in points]
    axis = [occ().addPoint(0, 0, 16), occ().addPoint(0, 0, 0)]
    distinct = sorted(set(knots))
    lines = [spline_curve(tags, knots, 3), occ().addLine(tags[-1], axis[0]), occ().addLine(*axis), occ().addLine(axis[1], tags[0])]
    face = occ().addPlaneSurface([occ().addCurveLoop(lines)])
    occ().revolve([(2, face)], 0, 0, 0, 0, 0, 1, pi)
    def at(t, d=False):
        return de_boor(points, knots, 3, t, d)

    total = [0.0, 0.0, 0.0]
    for a, b in zip(distinct, distinct[1:]):
        total[0] += integral(lambda t: 0.5 * pi * at(t)[0] ** 2 * at(t, True)[1], a, b)
        total[1] += integral(lambda t: pi * at(t)[0] * math.hypot(*at(t, True)), a, b, 20)
        total[2] += integral(lambda t: 2 * at(t)[0] * at(t, True)[1], a, b)
    return [Body(total[0], total[1] + total[2] + 0.5 * pi * (25 + 36))]


# Lofts and sweeps


def loft(low, high, height):
    """A ruled solid between two quadrilaterals."""
    wires = []
    for corners, z in ((low, 0), (high, height)):
        tags = [occ().addPoint(x, y, z) for x, y in corners]
        wires.append(occ().addWire([occ().addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]))
    occ().addThruSections(wires, makeSolid=True, makeRuled=True)

    def section(s):
        p = [((1 - s) * a[0] + s * b[0], (1 - s) * a[1] + s * b[1]) for a, b in zip(low, high)]
        return abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(p, p[1:] + p[:1]))) / 2

    sides = 0.0
    for i in range(4):
        j = (i + 1) % 4
        sides += bilinear_area((*low[i], 0), (*low[j], 0), (*high[j], height), (*high[i], height))
    return Body(height * (section(0) + 4 * section(0.5) + section(1)) / 6, section(0) + section(1) + sides)


def square(half, angle=0.0):
    return [(half * math.sqrt(2) * math.cos(pi / 4 + k * pi / 2 + angle), half * math.sqrt(2) * math.sin(pi / 4 + k * pi / 2 + angle)) for k in range(4)]


@solid
def frustum():
    b = loft(square(5), square(3), 8)
    b.stage = "parameterization"
    return [b]


@solid
def twisted_bar():
    return [loft(square(5), square(5, pi / 5), 12)]


@solid
def skew_loft():
    return [loft([(0, 0), (10, 0), (11, 8), (0, 7)], [(2, 1), (9, -1), (8, 8), (1, 6)], 9)]


@solid
def bent_pipe():
    p = [occ().addPoint(*q) for q in ((0, 0, 0), (0, 0, 10), (10, 0, 10), (10, 0, 20))]
    centre = occ().addPoint(10, 0, 10)
    end = occ().addPoint(10, 0, 20)
    line, arc = occ().addLine(p[0], p[1]), occ().addCircleArc(p[1], centre, end)
    occ().addPipe([(2, occ().addDisk(0, 0, 0, 3, 3))], occ().addWire([line, arc]))
    length = 10 + 10 * pi / 2
    return [Body(pi * 9 * length, 6 * pi * length + 2 * pi * 9)]


@solid
def spring():
    turns, radius, pitch, r = 3, 10, 6, 1.5
    points = []
    for i in range(24 * turns + 1):
        t = 2 * pi * i / 24
        points.append(occ().addPoint(radius * math.cos(t), radius * math.sin(t), pitch * t / (2 * pi)))
    disk = occ().addDisk(radius, 0, 0, r, r)
    occ().rotate([(2, disk)], radius, 0, 0, 1, 0, 0, pi / 2 - math.atan2(pitch, 2 * pi * radius) * -1)
    occ().addPipe([(2, disk)], occ().addWire([occ().addSpline(points)]))
    occ().remove([(2, disk)])  # else it is written beside the pipe
    length = turns * math.hypot(2 * pi * radius, pitch)
    return [Body(pi * r * r * length, 2 * pi * r * length + 2 * pi * r * r, tolerance=0.05)]

"""Solids made by gmsh (OpenCASCADE's kernel), in mm, with volume and area in closed form or by quadrature."""

import math

import gmsh

from expected import Body, box_body
from quadrature import area_and_length, bilinear_area, de_boor, ellipse_length, integral, triangle

SOLIDS = {}
pi = math.pi


def solid(make):
    """Registers a function that builds solids in gmsh's current model and returns the bodies to be found."""
    SOLIDS[make.__name__] = make
    return make


def occ():
    return gmsh.model.occ


def edges_of(volume, wanted=lambda box: True):
    """Edges of a solid whose bounding box (low, high) is wanted."""
    occ().synchronize()
    result = []
    for _, tag in gmsh.model.getBoundary(gmsh.model.getBoundary([(3, volume)], oriented=False), combined=False, oriented=False):
        b = gmsh.model.getBoundingBox(1, tag)
        if wanted((b[:3], b[3:])) and tag not in result:
            result.append(tag)
    return result


def upright(box):
    """Whether an edge's bounding box is that of a line along z."""
    return box[1][0] - box[0][0] < 1e-5 and box[1][1] - box[0][1] < 1e-5


def box(x, y, z, low=(0, 0, 0)):
    return occ().addBox(*low, x, y, z)


def cut(a, *tools):
    occ().cut([(3, a)], [(3, t) for t in tools])


def polygon_face(points):
    """A plane face with straight edges."""
    tags = [occ().addPoint(*p) for p in points]
    lines = [occ().addLine(a, b) for a, b in zip(tags, tags[1:] + tags[:1])]
    return occ().addPlaneSurface([occ().addCurveLoop(lines)])


def prism(points, height):
    """Over a polygon in the plane z = 0, with its volume and area."""
    occ().extrude([(2, polygon_face([(x, y, 0) for x, y in points]))], 0, 0, height)
    pairs = list(zip(points, points[1:] + points[:1]))
    base = abs(sum(a[0] * b[1] - a[1] * b[0] for a, b in pairs)) / 2
    around = sum(math.dist(a, b) for a, b in pairs)
    return Body(base * height, 2 * base + around * height)


def polyhedron(points, faces):
    """By its faces, each a list of corners counted outward."""
    tags = [occ().addPoint(*p) for p in points]
    lines, surfaces = {}, []
    volume = area = 0.0
    for face in faces:
        loop = []
        for a, b in zip(face, face[1:] + face[:1]):
            if (a, b) not in lines:
                lines[a, b] = occ().addLine(tags[a], tags[b])
                lines[b, a] = -lines[a, b]
            loop.append(lines[a, b])
        surfaces.append(occ().addPlaneSurface([occ().addCurveLoop(loop)]))
        p = points[face[0]]
        for i, j in zip(face[1:], face[2:]):
            q, r = points[i], points[j]
            c = cross(minus(q, p), minus(r, p))
            area += 0.5 * math.hypot(*c)
            volume += (p[0] * c[0] + p[1] * c[1] + p[2] * c[2]) / 6
    occ().addVolume([occ().addSurfaceLoop(surfaces, sewing=True)])
    return Body(abs(volume), area)


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


# Blocks


@solid
def cube():
    box(10, 10, 10)
    return [box_body(10, 10, 10)]


@solid
def block():
    box(10, 20, 30, (-4, 7, 100))
    return [box_body(10, 20, 30, (-4, 7, 100))]


@solid
def sheet():
    box(1000, 700, 1)
    return [box_body(1000, 700, 1)]


@solid
def needle():
    box(0.5, 0.5, 400)
    return [box_body(0.5, 0.5, 400)]


@solid
def tiny_block():
    box(0.02, 0.03, 0.01)
    return [box_body(0.02, 0.03, 0.01)]


@solid
def bridge():
    box(80000, 6000, 900)
    return [box_body(80000, 6000, 900)]


@solid
def wedge():
    occ().addWedge(0, 0, 0, 10, 6, 8, ltx=4)
    base = 0.5 * (10 + 4) * 6
    return [Body(base * 8, 2 * base + 8 * (10 + 6 + 4 + math.hypot(6, 6)), stage="parameterization")]


@solid
def pointed_wedge():
    occ().addWedge(0, 0, 0, 10, 6, 8, ltx=0)
    base = 0.5 * 10 * 6
    return [Body(base * 8, 2 * base + 8 * (10 + 6 + math.hypot(6, 10)))]


# Round ones


@solid
def cylinder():
    occ().addCylinder(1, 2, 3, 0, 0, 20, 5)
    return [Body(pi * 25 * 20, 2 * pi * 25 + 2 * pi * 5 * 20, box=((-4, -3, 3), (6, 7, 23)), stage="preprocessing")]


@solid
def quarter_cylinder():
    occ().addCylinder(0, 0, 0, 0, 0, 20, 5, angle=pi / 2)
    return [Body(pi * 25 * 20 / 4, pi * 25 / 2 + pi * 5 * 20 / 2 + 2 * 5 * 20)]


@solid
def three_quarter_disc():
    occ().addCylinder(0, 0, 0, 0, 0, 1, 50, angle=1.5 * pi)
    return [Body(0.75 * pi * 2500, 1.5 * pi * 2500 + 1.5 * pi * 50 + 100)]


@solid
def slanted_cylinder():
    occ().addCylinder(0, 0, 0, 3, 4, 12, 2)
    return [Body(pi * 4 * 13, 2 * pi * 4 + 4 * pi * 13)]


@solid
def cone():
    occ().addCone(0, 0, 0, 0, 0, 12, 5, 2)
    slant = math.hypot(3, 12)
    return [Body(pi * 12 * (25 + 10 + 4) / 3, pi * 25 + pi * 4 + pi * 7 * slant)]


@solid
def pointed_cone():
    occ().addCone(0, 0, 0, 0, 0, 12, 5, 0)
    return [Body(pi * 25 * 12 / 3, pi * 25 + pi * 5 * 13)]


@solid
def half_cone():
    occ().addCone(0, 0, 0, 0, 0, 12, 5, 2, angle=pi)
    slant = math.hypot(3, 12)
    return [Body(pi * 12 * 39 / 6, pi * 29 / 2 + pi * 7 * slant / 2 + 12 * 7)]


@solid
def sphere():
    occ().addSphere(3, -4, 5, 7)
    return [Body(4 / 3 * pi * 343, 4 * pi * 49, box=((-4, -11, -2), (10, 3, 12)))]


@solid
def half_sphere():
    occ().addSphere(0, 0, 0, 7, angle1=0)
    return [Body(2 / 3 * pi * 343, 3 * pi * 49)]


@solid
def eighth_sphere():
    occ().addSphere(0, 0, 0, 7, angle1=0, angle3=pi / 2)
    return [Body(pi * 343 / 6, pi * 49 / 2 + 3 * pi * 49 / 4)]


@solid
def sphere_zone():
    occ().addSphere(0, 0, 0, 10, angle1=-math.asin(0.6), angle2=math.asin(0.8))
    return [Body(pi * (100 * 14 - (512 + 216) / 3), 2 * pi * 10 * 14 + pi * 64 + pi * 36)]


@solid
def torus():
    occ().addTorus(0, 0, 0, 10, 3)
    return [Body(2 * pi**2 * 10 * 9, 4 * pi**2 * 30, box=((-13, -13, -3), (13, 13, 3)), genus=1)]


@solid
def torus_sector():
    occ().addTorus(0, 0, 0, 10, 3, angle=2)
    return [Body(2 * 10 * 9 * pi, 2 * 10 * 2 * pi * 3 + 2 * pi * 9)]


@solid
def capsule():
    c, a, b = occ().addCylinder(0, 0, 0, 0, 0, 10, 4), occ().addSphere(0, 0, 0, 4), occ().addSphere(0, 0, 10, 4)
    occ().fuse([(3, c)], [(3, a), (3, b)])
    return [Body(pi * 160 + 4 / 3 * pi * 64, 2 * pi * 40 + 4 * pi * 16)]


@solid
def two_spheres():
    occ().fuse([(3, occ().addSphere(0, 0, 0, 5))], [(3, occ().addSphere(6, 0, 0, 5))])
    cap = pi * 4 / 3 * (15 - 2)  # of height 2
    return [Body(2 * (4 / 3 * pi * 125 - cap), 2 * (4 * pi * 25 - 2 * pi * 5 * 2))]


@solid
def lens():
    occ().intersect([(3, occ().addSphere(0, 0, 0, 5))], [(3, occ().addSphere(6, 0, 0, 5))])
    return [Body(2 * pi * 4 / 3 * 13, 2 * 2 * pi * 5 * 2)]


@solid
def napkin_ring():
    cut(occ().addSphere(0, 0, 0, 5), occ().addCylinder(0, 0, -10, 0, 0, 20, 3))
    return [Body(pi * 8**3 / 6, 2 * pi * 5 * 8 + 2 * pi * 3 * 8, genus=1)]


@solid
def crossing_cylinders_common():
    a, b = occ().addCylinder(0, 0, -20, 0, 0, 40, 5), occ().addCylinder(-20, 0, 0, 40, 0, 0, 5)
    occ().intersect([(3, a)], [(3, b)])
    return [Body(16 / 3 * 125, 16 * 25)]


@solid
def cut_cylinder():
    c = occ().addCylinder(0, 0, 0, 0, 0, 40, 5)
    b = occ().addBox(-50, -50, 0, 100, 100, 100)
    occ().rotate([(3, b)], 0, 0, 0, 0, 1, 0, pi / 4)
    occ().translate([(3, b)], 0, 0, 20)
    cut(c, b)
    return [Body(pi * 25 * 20, pi * 25 * (1 + math.sqrt(2)) + 2 * pi * 5 * 20)]


@solid
def elbow():
    ring = occ().addDisk(10, 0, 0, 3, 3)
    hole = occ().addDisk(10, 0, 0, 2, 2)
    face = occ().cut([(2, ring)], [(2, hole)])[0]
    occ().revolve(face, 0, 0, 0, 0, 1, 0, pi / 2)
    return [Body(pi * 5 * 10 * pi / 2, 2 * pi * 5 * 10 * pi / 2 + 2 * pi * 5, genus=1)]


# Fillets, chamfers, bores


@solid
def one_fillet():
    b = box(20, 15, 10)
    occ().fillet([b], edges_of(b, upright)[:1], [3])
    return [Body(3000 - (4 - pi) * 9 / 4 * 10, 1300 - 2 * (4 - pi) * 9 / 4 - (6 - pi * 3 / 2) * 10, genus=0)]


@solid
def four_fillets():
    b = box(20, 15, 10)
    occ().fillet([b], edges_of(b, upright), [3])
    return [Body(3000 - (4 - pi) * 9 * 10, 1300 - 2 * (4 - pi) * 9 - (24 - 6 * pi) * 10)]


@solid
def all_edges_filleted():
    b = box(20, 15, 10)
    occ().fillet([b], edges_of(b), [2])
    x, y, z, r = 16, 11, 6, 2
    return [
        Body(
            x * y * z + 2 * r * (x * y + y * z + z * x) + pi * r * r * (x + y + z) + 4 / 3 * pi * r**3,
            2 * (x * y + y * z + z * x) + 2 * pi * r * (x + y + z) + 4 * pi * r * r,
            box=((0, 0, 0), (20, 15, 10)),
        )
    ]


@solid
def one_chamfer():
    b = box(20, 15, 10)
    occ().synchronize()
    edge = edges_of(b, upright)[0]
    face = [t for t in gmsh.model.getAdjacencies(1, edge)[0]][0]
    occ().chamfer([b], [edge], [face], [3])
    return [Body(3000 - 4.5 * 10, 1300 - 9 - 60 + 10 * 3 * math.sqrt(2))]


@solid
def bore():
    cut(box(20, 20, 10), occ().addCylinder(10, 10, -1, 0, 0, 12, 4))
    return [Body(4000 - pi * 160, 1600 - 2 * pi * 16 + 2 * pi * 40, genus=1, stage="preprocessing")]


@solid
def blind_bore():
    cut(box(20, 20, 10), occ().addCylinder(10, 10, 4, 0, 0, 12, 4))
    return [Body(4000 - pi * 16 * 6, 1600 + 2 * pi * 4 * 6)]


@solid
def stepped_bore():
    cut(box(20, 20, 10), occ().addCylinder(10, 10, -1, 0, 0, 12, 3), occ().addCylinder(10, 10, 6, 0, 0, 12, 6))
    return [Body(4000 - pi * (9 * 6 + 36 * 4), 1600 - 2 * pi * 9 + 2 * pi * (18 + 24), genus=1)]


@solid
def countersunk():
    cut(box(20, 20, 10), occ().addCylinder(10, 10, -1, 0, 0, 12, 3), occ().addCone(10, 10, 7, 0, 0, 3, 3, 6))
    sink = pi * 3 * (9 + 18 + 36) / 3
    return [
        Body(4000 - pi * 9 * 7 - sink, 1600 - pi * 9 - pi * 36 + 2 * pi * 3 * 7 + pi * 9 * math.hypot(3, 3), genus=1)
    ]


@solid
def crossing_bores():
    cut(box(30, 30, 30, (-15, -15, -15)), occ().addCylinder(0, 0, -20, 0, 0, 40, 5), occ().addCylinder(-20, 0, 0, 40, 0, 0, 5))
    return [
        Body(27000 - 2 * pi * 25 * 30 + 16 / 3 * 125, 5400 - 4 * pi * 25 + 2 * 2 * pi * 5 * 30 - 16 * 25, genus=3)
    ]


@solid
def slanted_bore():
    hole = occ().addCylinder(0, 0, -50, 0, 0, 100, 4)
    occ().rotate([(3, hole)], 0, 0, 0, 0, 1, 0, pi / 6)
    cut(box(60, 30, 20, (-30, -15, -10)), hole)
    tilt = math.cos(pi / 6)
    return [
        Body(
            36000 - pi * 16 * 20 / tilt,
            2 * (1800 + 600 + 1200) - 2 * pi * 16 / tilt + 2 * pi * 4 * 20 / tilt,
            genus=1,
        )
    ]


def plate(columns, rows):
    holes = [occ().addCylinder(10 * i + 5, 10 * j + 5, -1, 0, 0, 4, 3) for i in range(columns) for j in range(rows)]
    cut(box(10 * columns, 10 * rows, 2), *holes)
    n = columns * rows
    return [Body(n * (200 - pi * 18), 2 * n * (100 - 9 * pi) + 40 * (columns + rows) + n * 12 * pi, genus=n)]


@solid
def plate_4():
    return plate(2, 2)


@solid
def plate_25():
    return plate(5, 5)


@solid
def plate_100():
    return plate(10, 10)


@solid
def tube():
    cut(occ().addCylinder(0, 0, 0, 0, 0, 30, 6), occ().addCylinder(0, 0, 0, 0, 0, 30, 5))
    return [Body(pi * 11 * 30, 2 * pi * 11 * 30 + 2 * pi * 11, genus=1)]


@solid
def boss():
    occ().fuse([(3, box(20, 20, 5))], [(3, occ().addCylinder(10, 10, 5, 0, 0, 7, 4))])
    return [Body(2000 + pi * 112, 1200 + 2 * pi * 28)]


@solid
def pockets():
    cut(box(40, 20, 10), box(10, 12, 6, (5, 4, 4)), box(15, 12, 6, (20, 4, 4)))
    return [Body(8000 - 6 * 12 * 25, 2 * (800 + 200 + 400) + 2 * 6 * (22 + 27))]


# Cavities


@solid
def hollow_box():
    cut(box(10, 10, 10), box(4, 5, 6, (2, 2, 2)))
    return [Body(880, 600 + 148, shells=2, stage="preprocessing")]


@solid
def hollow_sphere():
    cut(occ().addSphere(0, 0, 0, 7), occ().addSphere(0, 0, 0, 5))
    return [Body(4 / 3 * pi * (343 - 125), 4 * pi * (49 + 25), shells=2)]


@solid
def box_with_two_bubbles():
    cut(box(30, 10, 10), occ().addSphere(7, 5, 5, 3), occ().addSphere(20, 5, 5, 4))
    return [Body(3000 - 4 / 3 * pi * (27 + 64), 1400 + 4 * pi * 25, shells=3)]


@solid
def ring_shaped_cavity():
    cut(box(30, 30, 10, (-15, -15, -5)), occ().addTorus(0, 0, 0, 10, 3))
    return [Body(9000 - 2 * pi**2 * 90, 3000 + 4 * pi**2 * 30, shells=2, genus=1)]


@solid
def box_in_a_cavity():
    cut(box(20, 20, 20), box(10, 10, 10, (5, 5, 5)))
    box(4, 4, 4, (8, 8, 8))
    return [Body(7000, 3000, shells=2), box_body(4, 4, 4, (8, 8, 8))]


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


# Several bodies


@solid
def nine_blocks():
    bodies = []
    for i in range(3):
        for j in range(3):
            box(2 + i, 3 + j, 4, (10 * i, 10 * j, 0))
            bodies.append(box_body(2 + i, 3 + j, 4, (10 * i, 10 * j, 0)))
    return bodies


@solid
def twenty_balls():
    bodies = []
    for i in range(20):
        r = 1 + 0.1 * i
        occ().addSphere(8 * (i % 5), 8 * (i // 5), 0, r)
        bodies.append(Body(4 / 3 * pi * r**3, 4 * pi * r * r))
    return bodies


@solid
def touching_blocks():
    box(10, 10, 10)
    box(10, 10, 10, (10, 0, 0))
    return [box_body(10, 10, 10), box_body(10, 10, 10, (10, 0, 0))]


@solid
def glued_blocks():
    occ().fragment([(3, box(10, 10, 10))], [(3, box(15, 10, 10, (10, 0, 0)))])
    return [box_body(10, 10, 10), box_body(15, 10, 10, (10, 0, 0))]


@solid
def glued_row():
    occ().fragment([(3, box(10, 10, 10))], [(3, box(15, 10, 10, (10, 0, 0))), (3, box(12, 10, 10, (25, 0, 0)))])
    return [box_body(10, 10, 10), box_body(15, 10, 10, (10, 0, 0)), box_body(12, 10, 10, (25, 0, 0))]


@solid
def pin_in_a_block():
    block_tag = box(20, 20, 10)
    pin = occ().addCylinder(10, 10, 0, 0, 0, 10, 4)
    occ().fragment([(3, block_tag)], [(3, pin)])
    return [
        Body(4000 - pi * 160, 1600 - 2 * pi * 16 + 2 * pi * 40, genus=1),
        Body(pi * 160, 2 * pi * 16 + 2 * pi * 40),
    ]


@solid
def block_on_block():
    occ().fragment([(3, box(20, 20, 5))], [(3, box(8, 8, 7, (6, 6, 5)))])
    return [
        Body(2000, 1200, box=((0, 0, 0), (20, 20, 5))),
        box_body(8, 8, 7, (6, 6, 5)),
    ]


@solid
def blocks_meeting_in_an_edge():
    box(10, 10, 10)
    box(10, 10, 10, (10, 10, 0))
    return [box_body(10, 10, 10), box_body(10, 10, 10, (10, 10, 0))]

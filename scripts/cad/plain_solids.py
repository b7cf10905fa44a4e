"""Blocks and round solids: what a box, a cylinder, a cone, a sphere and a torus are, and pieces of them."""

import math

from expected import Body, box_body
from gmsh_shapes import solid, occ, box, cut, pi


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

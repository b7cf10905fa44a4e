"""Solids with fillets, chamfers, bores and cavities."""

import math

import gmsh

from expected import Body, box_body
from gmsh_shapes import solid, occ, edges_of, upright, box, cut, pi


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

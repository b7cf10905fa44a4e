"""Files of several bodies."""

from expected import Body, box_body
from gmsh_shapes import solid, occ, box, pi


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

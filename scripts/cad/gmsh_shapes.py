"""What solids are built of in gmsh (OpenCASCADE's kernel), in mm, and the register of those that are made."""

import math

import gmsh

from expected import Body

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

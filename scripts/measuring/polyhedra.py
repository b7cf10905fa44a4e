"""Random polyhedra: half-spaces cut from a box, their duals, and solids with notches. Seeded, no other packages.

A solid is made of convex pieces whose faces carry the number of the plane that they lie on. What two pieces share is
cancelled half-edge by half-edge, so that a notched solid has few faces, not many convex ones.
"""

import math
import random
from typing import NamedTuple

SAME = 1e-9        # points closer than this are one; solids are about 2 across
SHORTEST = 0.004    # edges of a solid, as a share of its size


class Polyhedron(NamedTuple):
    vertices: list  # (x, y, z)
    faces: list     # numbers of vertices, anticlockwise seen from outside

    def edges(self):
        return {(min(pair), max(pair)) for face in self.faces for pair in sides(face)}


class NotDone(Exception):
    """A random choice that makes no valid solid; another is to be made."""


def sides(face):
    return list(zip(face, face[1:] + face[:1]))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def along(a, b, share):
    return tuple(x + share * (y - x) for x, y in zip(a, b))


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a)


def random_direction(source):
    while True:
        a = tuple(source.gauss(0, 1) for _ in range(3))
        if dot(a, a) > 1e-6:
            return unit(a)


# ------------------------------------------------------------ convex pieces


def box(half_widths):
    """{plane: polygon}; planes 0 to 5."""
    a, b, c = half_widths
    corners = [(x, y, z) for z in (-c, c) for y in (-b, b) for x in (-a, a)]
    faces = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5))
    return {number: [corners[i] for i in face] for number, face in enumerate(faces)}


def clip(piece, plane, number):
    """What of a convex piece lies where normal . x <= offset, with a new face on the plane; {} if nothing does.

    Raises NotDone where a corner is nearly on the plane, which no random plane needs to be.
    """
    normal, offset = plane
    result, segments = {}, []
    for label, polygon in piece.items():
        heights = [dot(normal, point) - offset for point in polygon]
        if any(abs(height) < 1e-7 for height in heights):
            raise NotDone("a corner on a plane")
        kept, ends = [], []
        for i, point in enumerate(polygon):
            after = (i + 1) % len(polygon)
            if heights[i] < 0:
                kept.append(point)
            if (heights[i] < 0) != (heights[after] < 0):
                # From the same end whichever face asks, so that both get the same point.
                low, high = (i, after) if heights[i] < 0 else (after, i)
                share = heights[low] / (heights[low] - heights[high])
                kept.append(along(polygon[low], polygon[high], share))
                ends.append((kept[-1], heights[i] < 0))
        if len(kept) > 2:
            result[label] = kept
        if ends:
            leaving = next(point for point, out in ends if out)
            entering = next(point for point, out in ends if not out)
            segments.append((entering, leaving))
    if segments:
        result[number] = chained(segments)
    return result


def chained(segments):
    """The polygon that segments (start, end) close up to."""
    polygon, left = [segments[0][0]], list(segments)
    while left:
        at = min(range(len(left)), key=lambda i: distance(left[i][0], polygon[-1]))
        start, end = left.pop(at)
        if distance(start, polygon[-1]) > SAME:
            raise NotDone("a section that does not close")
        polygon.append(end)
    return polygon[:-1]


def distance(a, b):
    return math.dist(a, b)


def turned(plane):
    return tuple(-x for x in plane[0]), -plane[1]


def without(pieces, planes, numbers):
    """Convex pieces less what lies above all of some planes."""
    result = []
    for piece in pieces:
        rest = piece
        for plane, number in zip(planes, numbers):
            kept = clip(rest, plane, number)
            if kept:
                result.append(kept)
            rest = clip(rest, turned(plane), number)
            if not rest:
                break
    return result


# ---------------------------------------------------------------- one solid


def numbered(pieces):
    """Points, and the pieces with their numbers instead."""
    points = []

    def number(point):
        for i, other in enumerate(points):
            if distance(point, other) < SAME:
                return i
        points.append(point)
        return len(points) - 1

    return points, [{label: [number(p) for p in polygon] for label, polygon in piece.items()} for piece in pieces]


def divided(polygon, points):
    """A polygon with all points that lie on its sides as corners."""
    result = []
    for a, b in sides(polygon):
        start, end = points[a], points[b]
        length = distance(start, end)
        inner = []
        for i, point in enumerate(points):
            share = dot(minus(point, start), minus(end, start)) / length ** 2
            if i not in (a, b) and 0 < share < 1 and distance(point, along(start, end, share)) < SAME:
                inner.append((share, i))
        result += [a] + [i for _, i in sorted(inner)]
    return result


def loops_of(half_edges):
    """Closed chains of half-edges; NotDone where they touch themselves."""
    following = dict(half_edges)
    if len(following) != len(half_edges):
        raise NotDone("a face that touches itself")
    result = []
    while following:
        start, at = following.popitem()
        loop = [start]
        while at != start:
            loop.append(at)
            at = following.pop(at)
        result.append(loop)
    return result


def joined(pieces):
    """The solid that convex pieces fill together, without the faces between them."""
    points, pieces = numbered(pieces)
    faces = []
    for label in sorted({label for piece in pieces for label in piece}):
        half_edges = {}
        for piece in pieces:
            for side in sides(divided(piece[label], points)) if label in piece else ():
                if half_edges.get(side[::-1], 0) > 0:
                    half_edges[side[::-1]] -= 1
                else:
                    half_edges[side] = half_edges.get(side, 0) + 1
        faces += loops_of([side for side, count in half_edges.items() if count > 0])
    return checked(simplified(points, faces))


def simplified(points, faces):
    """Without vertices at which two faces meet only, and numbered anew."""
    meeting = {}
    for number, face in enumerate(faces):
        for vertex in face:
            meeting.setdefault(vertex, set()).add(number)
    kept = {vertex: i for i, vertex in enumerate(sorted(v for v, around in meeting.items() if len(around) > 2))}
    faces = [[kept[vertex] for vertex in face if vertex in kept] for face in faces]
    return Polyhedron([points[vertex] for vertex in kept], [face for face in faces if face])


def area_normal(solid, face):
    """The area of a face times its normal."""
    total = (0.0, 0.0, 0.0)
    first = solid.vertices[face[0]]
    for a, b in zip(face[1:], face[2:]):
        part = cross(minus(solid.vertices[a], first), minus(solid.vertices[b], first))
        total = tuple(x + 0.5 * y for x, y in zip(total, part))
    return total


def area(solid, face):
    """Of a face by its number."""
    normal = area_normal(solid, solid.faces[face])
    return dot(normal, normal) ** 0.5


def volume(solid):
    return sum(dot(solid.vertices[face[0]], area_normal(solid, face)) for face in solid.faces) / 3


def size(solid):
    return math.dist(*[[pick(v[i] for v in solid.vertices) for i in range(3)] for pick in (min, max)])


def checked(solid):
    """The solid if it is a ball with disc faces, no short edge and no vertex twice on a face; else NotDone."""
    pairs = [pair for face in solid.faces for pair in sides(face)]
    if any(len(face) < 3 or len(set(face)) != len(face) for face in solid.faces):
        raise NotDone("a face that is no polygon")
    if len(set(pairs)) != len(pairs) or {pair[::-1] for pair in pairs} != set(pairs):
        raise NotDone("not closed")
    edges = solid.edges()
    if len(solid.vertices) - len(edges) + len(solid.faces) != 2:
        raise NotDone("no ball, or a face with a hole")
    shortest = min(distance(solid.vertices[a], solid.vertices[b]) for a, b in edges)
    if shortest < SHORTEST * size(solid):
        raise NotDone("a short edge")
    return solid


def concave_edges(solid):
    """Edges with more than 180 degrees inside."""
    normals = [area_normal(solid, face) for face in solid.faces]
    face_of = {pair: number for number, face in enumerate(solid.faces) for pair in sides(face)}
    result = []
    for (a, b), number in face_of.items():
        direction = minus(solid.vertices[b], solid.vertices[a])
        if a < b and dot(cross(normals[number], normals[face_of[(b, a)]]), direction) < 0:
            result.append((a, b))
    return result


def three_connected(solid):
    """Whether two faces meet in nothing, a vertex or an edge."""
    edges = solid.edges()
    faces = [set(face) for face in solid.faces]
    for i, one in enumerate(faces):
        for other in faces[:i]:
            common = sorted(one & other)
            if len(common) > 2 or (len(common) == 2 and tuple(common) not in edges):
                return False
    return True


# ------------------------------------------------------------ random solids


def random_simple(source, planes):
    """A box cut by planes that touch an ellipsoid: three edges at every vertex. One convex piece."""
    radii = [source.uniform(0.6, 1.4) for _ in range(3)]
    piece = box([1.3 * radius for radius in radii])
    for number in range(6, 6 + planes):
        normal = random_direction(source)
        offset = math.sqrt(sum((radius * x) ** 2 for radius, x in zip(radii, normal)))
        piece = clip(piece, (normal, offset * source.uniform(0.95, 1.15)), number) or piece
    return piece


def dual(solid):
    """The polar dual of a convex solid about the origin: a vertex for every face, a face for every vertex."""
    vertices = []
    for face in solid.faces:
        normal = unit(area_normal(solid, face))
        vertices.append(tuple(x / dot(normal, solid.vertices[face[0]]) for x in normal))
    face_of = {pair: number for number, face in enumerate(solid.faces) for pair in sides(face)}
    faces = []
    for vertex in range(len(solid.vertices)):
        start = next(pair for pair in face_of if pair[0] == vertex)
        ring, pair = [], start
        while not ring or pair != start:
            ring.append(face_of[pair])
            face = solid.faces[ring[-1]]
            pair = (vertex, face[face.index(vertex) - 1])
        faces.append(ring[::-1])
    return Polyhedron(vertices, [face if turns_outwards(vertices, face) else face[::-1] for face in faces])


def turns_outwards(vertices, face):
    solid = Polyhedron(vertices, [face])
    return dot(area_normal(solid, face), vertices[face[0]]) > 0


def piece_of(solid):
    """A convex solid as a piece."""
    return {number: [solid.vertices[vertex] for vertex in face] for number, face in enumerate(solid.faces)}


def random_truncated(source, solid):
    """A convex solid with some corners cut off, as a piece."""
    piece = piece_of(solid)
    number = len(solid.faces)
    for vertex in source.sample(range(len(solid.vertices)), max(1, len(solid.vertices) // 4)):
        normal = unit(solid.vertices[vertex])
        others = max(dot(normal, point) for i, point in enumerate(solid.vertices) if i != vertex)
        height = dot(normal, solid.vertices[vertex])
        if others < height - 0.05:
            piece = clip(piece, (normal, height - source.uniform(0.25, 0.45) * (height - others)), number)
            number += 1
    return piece


def near(source, direction, spread):
    return unit(tuple(x + spread * source.gauss(0, 1) for x in direction))


def random_notch(source, solid):
    """Planes above all of which something is cut away: two along an edge, or three at a corner."""
    normals = [unit(area_normal(solid, face)) for face in solid.faces]
    depth = source.uniform(0.15, 0.45)
    if source.random() < 0.6:
        a, b = source.choice(sorted(solid.edges()))
        middle = along(solid.vertices[a], solid.vertices[b], source.uniform(0.3, 0.7))
        around = [n for n, face in zip(normals, solid.faces) if (a, b) in sides(face) or (b, a) in sides(face)]
    else:
        vertex = source.randrange(len(solid.vertices))
        middle = solid.vertices[vertex]
        around = [n for n, face in zip(normals, solid.faces) if vertex in face]
        around = source.sample(around, min(3, len(around)))
    centre = tuple(sum(v[i] for v in solid.vertices) / len(solid.vertices) for i in range(3))
    place = along(middle, centre, depth)
    tilted = [near(source, normal, 0.15) for normal in around]
    return [(normal, dot(normal, place)) for normal in tilted]


KINDS = ("simple", "triangulated", "truncated", "notched", "notched twice")
LEAST_VERTICES = {"simple": 10, "triangulated": 7, "truncated": 12, "notched": 14, "notched twice": 20}


def random_solid(kind, seed, most_vertices):
    """A solid of a kind with at most so many vertices, all sizes alike; the same for the same arguments."""
    source = random.Random(f"{kind} {seed}")
    wanted = source.randint(min(LEAST_VERTICES[kind], most_vertices), most_vertices)
    best = None
    while best is None or (len(best.vertices) < 0.8 * wanted and source.random() < 0.97):
        try:
            solid = _attempt(kind, source, wanted)
        except NotDone:
            continue
        if len(solid.vertices) <= wanted and (best is None or len(solid.vertices) > len(best.vertices)):
            best = solid
    return best


def _attempt(kind, source, wanted):
    # A simple solid of n faces has 2 n - 4 vertices; a notch adds about six.
    if kind == "simple":
        return joined([random_simple(source, max(1, wanted // 2 - 4))])
    if kind == "triangulated":
        return checked(dual(joined([random_simple(source, max(1, wanted - 6))])))
    if kind == "truncated":
        return joined([random_truncated(source, dual(joined([random_simple(source, max(1, wanted // 2 - 4))])))])
    notches = 1 + (kind == "notched twice")
    whole = random_simple(source, max(1, wanted // 2 - 4 - 3 * notches))
    pieces, solid = [whole], joined([whole])
    for notch in range(notches):
        planes = random_notch(source, solid)
        pieces = without(pieces, planes, [1000 + 10 * notch + i for i in range(len(planes))])
    solid = joined(pieces)
    if not concave_edges(solid):
        raise NotDone("no concave edge")
    return solid


def off_text(solid):
    lines = ["OFF", f"{len(solid.vertices)} {len(solid.faces)} 0"]
    lines += [" ".join(repr(x) for x in vertex) for vertex in solid.vertices]
    lines += [" ".join(map(str, [len(face), *face])) for face in solid.faces]
    return "\n".join(lines) + "\n"

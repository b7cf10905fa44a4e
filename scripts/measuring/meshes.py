"""Triangle meshes: read, written, and disturbed in ways that files of real programs are, from a seed."""

import math
import random
import struct
from typing import NamedTuple


class Mesh(NamedTuple):
    vertices: list   # triples of floats
    triangles: list  # triples of vertex numbers


def welded(triangles):
    """Corners of triangles, equal ones made one vertex."""
    number = {}
    numbered = [tuple(number.setdefault(p, len(number)) for p in corners) for corners in triangles]
    return Mesh(list(number), numbered)


def read(path):
    """An STL file, binary or not, or the triangles of an OBJ or OFF file, larger faces as fans."""
    data = path.read_bytes()
    if path.suffix == ".stl" and len(data) == 84 + 50 * struct.unpack_from("<I", data, 80)[0]:
        return welded([tuple(struct.unpack_from("<3f", data, at + 12 * i) for i in (1, 2, 3))
                       for at in range(84, len(data), 50)])
    lines = [line.split() for line in data.decode().splitlines() if line.strip() and not line.startswith("#")]
    if path.suffix == ".stl":
        points = [tuple(map(float, words[1:4])) for words in lines if words[0] == "vertex"]
        return welded(list(zip(points[::3], points[1::3], points[2::3])))
    if path.suffix == ".obj":
        vertices = [tuple(map(float, words[1:4])) for words in lines if words[0] == "v"]
        faces = [[int(word.split("/")[0]) - 1 for word in words[1:]] for words in lines if words[0] == "f"]
    else:
        numbers = lines[1:] if lines[0] == ["OFF"] else [lines[0][1:]] + lines[1:]
        count = int(numbers[0][0])
        vertices = [tuple(map(float, words[:3])) for words in numbers[1:count + 1]]
        faces = [[int(word) for word in words[1:1 + int(words[0])]] for words in numbers[count + 1:]]
    return Mesh(vertices, [(face[0], face[i], face[i + 1]) for face in faces for i in range(1, len(face) - 1)])


def off_text(mesh):
    lines = ["OFF", f"{len(mesh.vertices)} {len(mesh.triangles)} 0"]
    lines += [" ".join(map(repr, p)) for p in mesh.vertices]
    return "\n".join(lines + [f"3 {a} {b} {c}" for a, b, c in mesh.triangles]) + "\n"


def stl_bytes(mesh):
    body = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for v in triangle for x in mesh.vertices[v]), 0)
                    for triangle in mesh.triangles)
    return b"\0" * 80 + struct.pack("<I", len(mesh.triangles)) + body


def size(mesh):
    return math.dist([min(p[i] for p in mesh.vertices) for i in range(3)],
                     [max(p[i] for p in mesh.vertices) for i in range(3)])


def volume(mesh):
    total = 0.0
    for a, b, c in ([mesh.vertices[v] for v in triangle] for triangle in mesh.triangles):
        total += sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
    return total / 6


def moved(mesh, move):
    return mesh._replace(vertices=[move(p) for p in mesh.vertices])


# ----------------------------------------------------------- disturbances


def noisy(mesh, random_, share):
    """Each coordinate off by up to a share of the size."""
    step = share * size(mesh)
    return moved(mesh, lambda p: tuple(x + random_.uniform(-step, step) for x in p))


def scaled(mesh, factor):
    return moved(mesh, lambda p: tuple(factor * x for x in p))


def rotated(mesh, random_):
    """About a random axis by a random angle."""
    q = [random_.gauss(0, 1) for _ in range(4)]
    length = math.hypot(*q)
    w, x, y, z = (value / length for value in q)
    rows = ((1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
            (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
            (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)))
    return moved(mesh, lambda p: tuple(sum(r * value for r, value in zip(row, p)) for row in rows))


def shuffled(mesh, random_):
    """Triangles and vertices in another order, each triangle from another corner."""
    order = list(range(len(mesh.vertices)))
    random_.shuffle(order)
    number = {old: new for new, old in enumerate(order)}
    triangles = []
    for triangle in mesh.triangles:
        first = random_.randrange(3)
        triangles.append(tuple(number[triangle[(first + i) % 3]] for i in range(3)))
    random_.shuffle(triangles)
    return Mesh([mesh.vertices[old] for old in order], triangles)


def with_duplicates(mesh, random_):
    """Up to twenty triangles twice, some of them turned around."""
    extra = [random_.choice(mesh.triangles) for _ in range(random_.randint(1, 20))]
    return mesh._replace(triangles=mesh.triangles + [random_.choice([t, t[::-1]]) for t in extra])


def without_corners(mesh, random_):
    """Up to five vertices cut off, at a share of the edges around them."""
    vertices, triangles = list(mesh.vertices), list(mesh.triangles)
    taken = set()
    for _ in range(random_.randint(1, 5)):
        v = random_.randrange(len(mesh.vertices))
        around = [t for t in triangles if v in t]
        ring = {t[(t.index(v) + 1) % 3]: t[(t.index(v) + 2) % 3] for t in around}
        if taken & ({v} | set(ring)) or len(ring) != len(around) or set(ring) != set(ring.values()):
            continue
        taken |= {v} | set(ring)
        share = random_.uniform(0.1, 0.6)
        number = {}
        for a in ring:
            number[a] = len(vertices)
            vertices.append(tuple(x + share * (y - x) for x, y in zip(vertices[v], vertices[a])))
        triangles = [t for t in triangles if v not in t]
        for a, b in ring.items():
            triangles += [(number[a], a, b), (number[a], b, number[b])]
        loop = [next(iter(ring))]
        while ring[loop[-1]] != loop[0]:
            loop.append(ring[loop[-1]])
        triangles += [(number[loop[0]], number[loop[i]], number[loop[i + 1]]) for i in range(1, len(loop) - 1)]
    return Mesh(vertices, triangles)


def decimated(mesh, random_, share):
    """A share of the vertices gone, by edges that lose one end to the other; the surface stays closed."""
    around = [set() for _ in mesh.vertices]
    triangles = dict(enumerate(mesh.triangles))
    for number, triangle in triangles.items():
        for v in triangle:
            around[v].add(number)

    def beside(v):
        return {w for t in around[v] for w in triangles[t]} - {v}

    for v in random_.sample(range(len(mesh.vertices)), int(share * len(mesh.vertices))):
        candidates = sorted(beside(v))
        if not candidates:
            continue
        w = random_.choice(candidates)
        if len(beside(v) & beside(w)) != 2 or len(beside(v)) < 4:
            continue
        for t in list(around[v]):
            old = triangles[t]
            if w in old:
                del triangles[t]
                for u in old:
                    around[u].discard(t)
            else:
                triangles[t] = tuple(w if u == v else u for u in old)
                around[v].discard(t)
                around[w].add(t)
    return Mesh(mesh.vertices, list(triangles.values()))


KINDS = ("noise", "decimated", "corners", "duplicates", "shuffled", "float32", "small", "large", "rotated")


def disturbed(mesh, kind, seed):
    """(the mesh, and what factor it was scaled by)"""
    random_ = random.Random(f"{kind} {seed}")
    if kind == "noise":
        return noisy(mesh, random_, 10 ** random_.uniform(-8, -3)), 1
    if kind == "decimated":
        return decimated(mesh, random_, random_.uniform(0.02, 0.7)), 1
    if kind == "corners":
        return without_corners(mesh, random_), 1
    if kind == "duplicates":
        return with_duplicates(mesh, random_), 1
    if kind == "shuffled":
        return shuffled(mesh, random_), 1
    if kind in ("small", "large"):
        factor = (1e-3 if kind == "small" else 1e6) * random_.uniform(0.5, 2)
        return scaled(mesh, factor), factor
    return rotated(mesh, random_), 1  # "float32" is written as such besides

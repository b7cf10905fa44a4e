"""The link of examples/link by gmsh and CalculiX: second-order tetrahedra, direct solver."""

import math
import pathlib
import re
import tomllib
from typing import NamedTuple

from . import seconds

# Points (barycentric) and weights (sum 1) on a triangle, exact for degree 5. Radon 1948.
_A, _B = (6 - math.sqrt(15)) / 21, (6 + math.sqrt(15)) / 21
TRIANGLE_RULE = [((1 / 3, 1 / 3, 1 / 3), 0.225)] + [
    (point, (155 + sign * math.sqrt(15)) / 1200) for x, sign in ((_A, -1), (_B, 1))
    for point in ((x, x, 1 - 2 * x), (x, 1 - 2 * x, x), (1 - 2 * x, x, x))]


class Link(NamedTuple):
    """Lengths in mm, stresses in MPa, forces in N."""

    distance: float
    left_bore_radius: float
    right_bore_radius: float
    left_outer_radius: float
    right_outer_radius: float
    shank_width: float
    fillet_radius: float
    thickness: float
    young: float = 210e3  # steel, as isopatch's table has it
    poisson: float = 0.3
    force: tuple = (10e3, -2e3, 0.0)


def link_of(study):
    """The dimensions that the study file of examples/link gives in mm."""
    model = tomllib.loads(pathlib.Path(study).read_text(encoding="utf-8"))["model"]
    return Link(**{name: float(model[name]) for name in Link._fields if name in model})


def _arc_points(center, radius, angles):
    return [(center + radius * math.cos(angle), radius * math.sin(angle)) for angle in angles]


def _round_end(center, radius, opening, facing):
    """Four points on an eye's outline, anticlockwise from one fillet to the other; `facing`: where the shank is."""
    step = (2 * math.pi - 2 * opening) / 3
    return _arc_points(center, radius, [facing + opening + step * i for i in range(4)])


def geometry(link, size):
    """The text of a .geo file: the outline with exact arcs, extruded."""
    lines, points = [], {}

    def point(x, y):
        key = (round(x, 9), round(y, 9))
        if key not in points:
            points[key] = len(points) + 1
            lines.append(f"Point({points[key]}) = {{{x!r}, {y!r}, 0, {size!r}}};")
        return points[key]

    curves = []

    def curve(text):
        curves.append(len(curves) + 1)
        lines.append(f"{text.split(' ')[0]}({curves[-1]}) = {{{text.split(' ', 1)[1]}}};")

    def arcs(center, ends):
        for start, end in zip(ends, ends[1:]):
            curve(f"Circle {point(*start)}, {point(*center)}, {point(*end)}")

    half, fillet = link.shank_width / 2, link.fillet_radius
    reach = [radius + fillet for radius in (link.left_outer_radius, link.right_outer_radius)]
    opening = [math.asin((half + fillet) / r) for r in reach]
    start = reach[0] * math.cos(opening[0])
    end = link.distance - reach[1] * math.cos(opening[1])
    left = _round_end(0.0, link.left_outer_radius, opening[0], 0.0)
    right = _round_end(link.distance, link.right_outer_radius, opening[1], math.pi)
    arcs((0.0, 0.0), left)
    arcs((start, -half - fillet), [left[-1], (start, -half)])
    curve(f"Line {point(start, -half)}, {point(end, -half)}")
    arcs((end, -half - fillet), [(end, -half), right[0]])
    arcs((link.distance, 0.0), right)
    arcs((end, half + fillet), [right[-1], (end, half)])
    curve(f"Line {point(end, half)}, {point(start, half)}")
    arcs((start, half + fillet), [(start, half), left[0]])
    loops = [list(curves)]
    for center, radius in ((0.0, link.left_bore_radius), (link.distance, link.right_bore_radius)):
        first = len(curves) + 1
        quarters = _arc_points(center, radius, [0.5 * math.pi * i for i in range(4)])
        arcs((center, 0.0), quarters + quarters[:1])
        loops.append(list(range(first, len(curves) + 1)))
    for number, loop in enumerate(loops, 1):
        lines.append(f"Curve Loop({number}) = {{{', '.join(map(str, loop))}}};")
    lines.append("Plane Surface(1) = {1, 2, 3};")
    lines.append(f"made[] = Extrude {{0, 0, {link.thickness!r}}} {{ Surface{{1}}; }};")
    # made[] holds the top, the volume, then the sides in the order of the loops.
    at = 2 + len(loops[0])
    lines.append("Physical Volume(1) = {made[1]};")
    lines.append(f"Physical Surface(2) = {{made[{{{at}:{at + 3}}}]}};")      # left bore
    lines.append(f"Physical Surface(3) = {{made[{{{at + 4}:{at + 7}}}]}};")  # right bore
    return "\n".join(lines) + "\n"


class Mesh(NamedTuple):
    nodes: dict         # number: (x, y, z)
    tetrahedra: list    # ten nodes each, in gmsh's order
    surfaces: dict      # physical number: triangles of six nodes


def read_mesh(path, surface_tag=3):
    """A mesh of format 2.2, its second-order tetrahedra and triangles.

    surface_tag: 3 for the numbers of physical surfaces, 4 for those of the geometry.
    """
    nodes, tetrahedra, surfaces, section, left = {}, [], {}, "", 0
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("$"):
                section, left = line.strip(), -1
            elif section in ("$Nodes", "$Elements") and left < 0:
                left = int(line)
            elif section == "$Nodes":
                number, *place = line.split()
                nodes[int(number)] = tuple(map(float, place))
            elif section == "$Elements":
                entries = list(map(int, line.split()))
                corners = entries[3 + entries[2]:]
                if entries[1] == 11:
                    tetrahedra.append(corners)
                elif entries[1] == 9:
                    surfaces.setdefault(entries[surface_tag], []).append(corners)
    return Mesh(nodes, tetrahedra, surfaces)


def _shares(triangle, nodes):
    """(share of the area, shape functions) of a curved six-node triangle at the points of the rule."""
    places = [nodes[number] for number in triangle]
    for (a, b, c), weight in TRIANGLE_RULE:
        shape = (a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * a * b, 4 * b * c, 4 * c * a)
        along_b = (1 - 4 * a, 4 * b - 1, 0, 4 * (a - b), 4 * c, -4 * c)
        along_c = (1 - 4 * a, 0, 4 * c - 1, -4 * b, 4 * b, 4 * (a - c))
        u, v = ([sum(s * place[i] for s, place in zip(along, places)) for i in range(3)]
                for along in (along_b, along_c))
        yield 0.5 * weight * math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                        u[0] * v[1] - u[1] * v[0]), shape


def area(triangles, nodes):
    """Of curved six-node triangles."""
    return sum(share for triangle in triangles for share, _ in _shares(triangle, nodes))


def spread(force, triangles, nodes):
    """{node: force}: a total force spread evenly over curved six-node triangles, by their shape functions."""
    weights, total = {}, 0.0
    for triangle in triangles:
        for share, shape in _shares(triangle, nodes):
            total += share
            for number, value in zip(triangle, shape):
                weights[number] = weights.get(number, 0.0) + share * value
    return {number: tuple(weight / total * f for f in force) for number, weight in weights.items()}


def write_input(path, link, mesh):
    """The input of ccx: clamped left bore, loaded right bore. Returns the nodal forces and the free unknowns."""
    clamped = sorted({number for triangle in mesh.surfaces[2] for number in triangle})
    loads = spread(link.force, mesh.surfaces[3], mesh.nodes)
    used = sorted({number for element in mesh.tetrahedra for number in element})
    with open(path, "w", encoding="ascii") as file:
        out = lambda *lines: file.write("\n".join(lines) + "\n")
        out("*NODE, NSET=ALL", *(f"{n}, {x:.12g}, {y:.12g}, {z:.12g}" for n, (x, y, z) in
                                 ((n, mesh.nodes[n]) for n in used)))
        # The last two nodes are exchanged between gmsh's order and that of C3D10.
        out("*ELEMENT, TYPE=C3D10, ELSET=PART", *(f"{number}, " + ", ".join(map(str, e[:8] + [e[9], e[8]]))
                                                  for number, e in enumerate(mesh.tetrahedra, 1)))
        out("*NSET, NSET=CLAMPED", *(f"{number}," for number in clamped))
        out("*NSET, NSET=LOADED", *(f"{number}," for number in sorted(loads)))
        out("*MATERIAL, NAME=STEEL", "*ELASTIC", f"{link.young}, {link.poisson}",
            "*SOLID SECTION, ELSET=PART, MATERIAL=STEEL", "*BOUNDARY", "CLAMPED, 1, 3", "*STEP", "*STATIC", "*CLOAD")
        out(*(f"{number}, {i + 1}, {f:.12g}" for number, force in sorted(loads.items()) for i, f in enumerate(force)))
        out("*NODE PRINT, NSET=LOADED", "U", "*NODE FILE", "U", "*EL FILE", "S", "*END STEP")
    return loads, 3 * (len(used) - len(clamped))


def energy(path, loads):
    """Half the work of the loads, J, from the displacements that ccx printed (mm)."""
    work = 0.0
    for line in pathlib.Path(path).read_text(encoding="ascii").splitlines():
        entries = line.split()
        if len(entries) == 4 and re.fullmatch(r"\d+", entries[0]) and int(entries[0]) in loads:
            work += sum(f * float(u) for f, u in zip(loads[int(entries[0])], entries[1:]))
    return 0.5e-3 * work


def solve(link, size, *, threads, folder, timeout=None):
    """One mesh of element size `size` (mm): seconds of gmsh and ccx, free unknowns, energy."""
    folder = pathlib.Path(folder)
    (folder / "link.geo").write_text(geometry(link, size))
    meshing = seconds.of_program(["gmsh", "-3", "-order", "2", "-format", "msh22", "-v", "0", "-o", "link.msh",
                                  "link.geo"], folder, threads=threads, timeout=timeout).clock
    loads, dofs = write_input(folder / "link.inp", link, read_mesh(folder / "link.msh"))
    solving = seconds.of_program(["ccx", "link"], folder, threads=threads, timeout=timeout).clock
    return {"size_mm": size, "dofs": dofs, "mesh_seconds": meshing, "solve_seconds": solving,
            "energy": energy(folder / "link.dat", loads)}


def order(coarse, fine):
    """Order in the element size with which the error of two meshes fell, kept within 1 .. 4."""
    fell = math.log(coarse["error"] / fine["error"]) / math.log(coarse["size_mm"] / fine["size_mm"])
    return min(4.0, max(1.0, fell))

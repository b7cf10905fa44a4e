"""Solids by gmsh and CalculiX: second-order tetrahedra on a body as `isopatch info` describes it, or on its STEP file."""

import math
import pathlib
import subprocess
from typing import NamedTuple

from measuring import cut_solids, finite_elements

MM = 1e3  # metres in mm


class Steel(NamedTuple):
    """Forces in N, stresses in MPa: what `finite_elements.write_input` asks of a part."""

    force: tuple
    young: float = 210e3
    poisson: float = 0.3


def is_polyhedral(solid):
    return all(face["surface"] == "plane" for face in solid["faces"]) and all(
        edge["curve"] == "line" for edge in solid["edges"])


def singular_edges(solid, held):
    """Where stresses are large: around the clamped faces, and at concave edges."""
    return [number for number, edge in enumerate(solid["edges"])
            if edge["convexity"] == "non-convex" or (len(set(edge["faces"]) & set(held)) == 1)]


def geometry(solid, held, size):
    """The text of a .geo file of a polyhedron, mm; elements of `size`, a third of it at singular edges."""
    lines = [f"Point({number + 1}) = {{{', '.join(repr(MM * x) for x in place)}, {size!r}}};"
             for number, place in enumerate(solid["vertices"])]
    lines += [f"Line({number + 1}) = {{{edge['vertices'][0] + 1}, {edge['vertices'][1] + 1}}};"
              for number, edge in enumerate(solid["edges"])]
    for number, face in enumerate(solid["faces"], 1):
        loop = [(-1 if use["reversed"] else 1) * (use["edge"] + 1) for use in face["loops"][0]]
        lines += [f"Curve Loop({number}) = {{{', '.join(map(str, loop))}}};",
                  f"Plane Surface({number}) = {{{number}}};"]
    count = len(solid["faces"])
    lines += [f"Surface Loop(1) = {{1:{count}}};", "Volume(1) = {1};"]
    curves = ", ".join(str(edge + 1) for edge in singular_edges(solid, held))
    lines += ["Field[1] = Distance;", f"Field[1].CurvesList = {{{curves}}};", "Field[1].NumPointsPerCurve = 200;",
              "Field[2] = Threshold;", "Field[2].InField = 1;", f"Field[2].SizeMin = {size / 3!r};",
              f"Field[2].SizeMax = {size!r};", "Field[2].DistMin = 0;", f"Field[2].DistMax = {4 * size!r};",
              "Background Field = 2;", *SIZES_OF_THE_FIELD_ALONE]
    return "\n".join(lines) + "\n"


SIZES_OF_THE_FIELD_ALONE = ["Mesh.MeshSizeExtendFromBoundary = 0;", "Mesh.MeshSizeFromPoints = 0;",
                            "Mesh.MeshSizeFromCurvature = 0;"]


def imported(file, size):
    """The same of a STEP file, with elements of one size."""
    return "\n".join([f'Merge "{file}";', f"Mesh.MeshSizeMax = {size!r};", f"Mesh.MeshSizeMin = {size!r};",
                      "Mesh.MeshSizeFromCurvature = 0;", "Mesh.HighOrderOptimize = 1;"]) + "\n"  # unfolds elements at rounds


def surface_with(mesh, places, wanted, tolerance):
    """Triangles of the surface whose nodes include all these places; of several, as around a seam, of that whose area
    is nearest to `wanted` (mm^2)."""
    found = []
    for triangles in mesh.surfaces.values():
        nodes = [mesh.nodes[number] for number in {number for triangle in triangles for number in triangle}]
        if all(min(math.dist(place, node) for node in nodes) < tolerance for place in places):
            found.append(triangles)
    if not found:
        raise RuntimeError(f"no surface has the corners {places}")
    return min(found, key=lambda triangles: abs(finite_elements.area(triangles, mesh.nodes) - wanted))


def solve(solid, file, held, loaded, traction, size, *, folder, timeout=None):
    """One mesh: {"size_mm", "nodes", "energy"} of a solid clamped on the side of face `held`, with a traction (MPa) on
    that of face `loaded`; energy in J."""
    folder = pathlib.Path(folder)
    sides = {group[0]: group for group in cut_solids.merged_faces(solid)}
    text = geometry(solid, sides[held], size) if is_polyhedral(solid) else imported(file, size)
    (folder / "solid.geo").write_text(text)
    subprocess.run(["gmsh", "-3", "-order", "2", "-format", "msh22", "-v", "2", "-save_all", "-o", "solid.msh",
                    "solid.geo"], cwd=folder, check=True, timeout=timeout)
    mesh = finite_elements.read_mesh(folder / "solid.msh", surface_tag=4)
    tolerance = 1e-5 * size
    areas = {face: solid["faces"][face]["area"] * MM ** 2 for side in (held, loaded) for face in sides[side]}
    chosen = {}
    for number, name, side in ((2, "clamped", held), (3, "loaded", loaded)):
        chosen[number] = [triangle for face in sides[side] for triangle in surface_with(
            mesh, [[MM * x for x in place] for place in cut_solids.corners(solid, face)], areas[face], tolerance)]
        total, meshed = sum(areas[face] for face in sides[side]), finite_elements.area(chosen[number], mesh.nodes)
        if abs(meshed / total - 1) > 1e-2:
            raise RuntimeError(f"the {name} side has {meshed:g} mm^2 in the mesh, not {total:g}")
    mesh = mesh._replace(surfaces=chosen)
    part = Steel(tuple(t * sum(areas[face] for face in sides[loaded]) for t in traction))
    loads, _ = finite_elements.write_input(folder / "solid.inp", part, mesh)
    subprocess.run(["ccx", "solid"], cwd=folder, check=True, timeout=timeout, stdout=subprocess.DEVNULL)
    used = {number for element in mesh.tetrahedra for number in element}
    return {"size_mm": size, "nodes": len(used), "energy": finite_elements.energy(folder / "solid.dat", loads)}


def extrapolated(meshes):
    """The energy of three meshes whose sizes fall by one factor, at size 0; the order is kept within 1 .. 4."""
    coarse, middle, fine = (mesh["energy"] for mesh in meshes)
    factor = meshes[1]["size_mm"] / meshes[2]["size_mm"]
    ratio = (middle - coarse) / (fine - middle) if fine != middle else factor ** 4
    ratio = min(factor ** 4, max(factor, ratio))
    return fine + (fine - middle) / (ratio - 1)

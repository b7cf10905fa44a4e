"""The same part to the same accuracy by isopatch and by gmsh with CalculiX, in one run."""

import subprocess

from . import finite_elements, growth, tables

# Internal energy of examples/link, J. isopatch gives 0.579475 and 0.579476 at degrees 3 and 4 with 12 elements per
# direction and patch, 0.579475 at degree 4 with 8; CalculiX comes nearer from below with every finer mesh.
REFERENCE = 0.579477
# Elements per direction and patch of isopatch's runs, degree 3.
ELEMENTS = (2, 4)
FIRST_SIZE = 6.0  # mm, of the first tetrahedra
MOST_SECONDS = 900.0  # for one mesh; where more would be needed, the nearest is reported


def error_of(energy):
    """Relative error of the energy."""
    return abs(energy - REFERENCE) / REFERENCE


def next_size(meshes, target):
    """Element size that the last two meshes promise to reach the target, between 0.5 and 0.85 of the last one."""
    last = meshes[-1]
    order = 2.0
    if len(meshes) > 1:
        order = finite_elements.order(meshes[-2], last)
    needed = last["size_mm"] * (0.9 * target / last["error"]) ** (1 / order)
    return min(0.85 * last["size_mm"], max(needed, 0.5 * last["size_mm"]))


def refine(link, target, meshes, *, threads, folder):
    """Adds ever finer meshes to `meshes` until one is within the target; a sentence where that does not come about."""
    while not meshes or meshes[-1]["error"] > target:
        size = next_size(meshes, target) if meshes else FIRST_SIZE
        try:
            mesh = finite_elements.solve(link, size, threads=threads, folder=folder, timeout=MOST_SECONDS)
        except subprocess.TimeoutExpired:
            return f"tetrahedra of {size:.2g} mm took more than {MOST_SECONDS:.0f} s"
        except subprocess.CalledProcessError as failed:
            return f"{failed.cmd[0]} failed at tetrahedra of {size:.2g} mm"
        meshes.append({**mesh, "error": error_of(mesh["energy"])})
    return ""


def measure(root, program, study, *, threads, folder):
    """{"reference", "isopatch": [...], "finite_elements": [...], "failure"}."""
    link = finite_elements.link_of(study)
    own = []
    for elements in ELEMENTS:
        entry = growth.measure(root, program, study, elements, threads=threads, folder=folder, timeout=None,
                               memory=None)
        if entry["failure"]:
            raise RuntimeError(f"the link with {elements} elements per direction: {entry['failure']}")
        own.append({**entry, "error": error_of(entry["internal_energy"])})
    meshes, failure = [], ""
    for entry in own:
        failure = failure or refine(link, entry["error"], meshes, threads=threads, folder=folder)
    return {"reference_energy": REFERENCE, "threads": threads, "isopatch": own, "finite_elements": meshes,
            "failure": failure}


def report(found):
    number = tables.figure
    rows = [[f"isopatch, p = {max(e['degree'])}, {e['elements_per_direction']}^3 elements a patch", number(e["dofs"]),
             "-", number(e["wall_seconds"]), number(e["wall_seconds"]), number(e["error"], 2)]
            for e in found["isopatch"]]
    rows += [[f"gmsh + CalculiX, tetrahedra of {e['size_mm']:.2g} mm", number(e["dofs"]), number(e["mesh_seconds"]),
              number(e["solve_seconds"]), number(e["mesh_seconds"] + e["solve_seconds"]), number(e["error"], 2)]
             for e in found["finite_elements"]]
    lines = [f"### The link to the same accuracy, {found['threads']} threads", ""]
    lines += tables.table(["whole run, files written", "DOFs", "mesh s", "solve s", "total s", "error of energy"], rows)
    if found["failure"]:
        lines += ["", f"Finite elements as near as isopatch's finest: {found['failure']}."]
    return lines

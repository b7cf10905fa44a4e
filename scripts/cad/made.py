"""Cases of the solids of `solids.py`: each in several formats, schemas and units."""

import copy
import subprocess
from dataclasses import replace

import gmsh

from expected import Case
from solids import SOLIDS

UNITS = {"MM": "mm", "INCH": "inch", "M": "m", "CM": "cm", "UM": "um", "FT": "foot"}
IGES_UNITS = {"MM": "mm", "IN": "inch", "M": "m", "CM": "cm"}
MILLIMETRES = ("--length-unit", "1 mm")


def without_place(bodies):
    """What stays known of bodies that are turned."""
    bodies = copy.deepcopy(bodies)
    for body in bodies:
        body.box = None
    return bodies


def built(folder):
    """Builds every solid, straight and turned, as .brep; yields number, name and bodies."""
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    for number, (name, make) in enumerate(SOLIDS.items()):
        gmsh.model.add(name)
        bodies = make()
        gmsh.model.occ.synchronize()
        solids = gmsh.model.getEntities(3)
        gmsh.write(str(folder / f"{name}.brep"))
        gmsh.model.occ.rotate(solids, 1, 2, 3, 1, 2, 3, 2.4)
        gmsh.model.occ.translate(solids, 1000, -200, 77)
        gmsh.model.occ.synchronize()
        gmsh.write(str(folder / f"{name}.turned.brep"))
        gmsh.model.remove()
        yield number, name, bodies
    gmsh.finalize()


def variants(number, name, bodies):
    """The files made of a solid: (case, from, schema, unit, arrangement)."""
    units, iges = list(UNITS), list(IGES_UNITS)

    def step(kind, schema, unit, arrangement="solids", source=name, expected=bodies):
        file = f"step/{name}_{kind}.step"
        case = Case(file, expected, unit=UNITS[unit], warns=False)
        if name == "two_spheres":
            case.code, case.says = (0, 2), "other side"
        return case, source, schema, unit, arrangement

    yield step("AP214", "AP214IS", units[number % 6])
    yield step("AP203", "AP203", units[(number + 2) % 6]) if number % 2 else step("AP242", "AP242DIS", units[(number + 4) % 6])
    if number % 3 == 0:
        yield step("turned", "AP214IS", "MM", source=name + ".turned", expected=without_place(bodies))
    if number % 3 == 1:
        yield step("shells", "AP214IS", "MM", "shells") if all(b.shells == 1 for b in bodies) else step("nested", "AP214IS", "MM", "nested")
    for kind in ("solids", "faces"):
        unit = iges[(number + (kind == "faces")) % 4]
        case = Case(f"iges/{name}_{kind}.igs", bodies, unit=IGES_UNITS[unit], warns=False)
        if kind == "faces" and name in ("torus", "torus_sector", "ring_shaped_cavity"):
            # The library reads the section, a circle, as a spline some nanometres off.
            case.bodies = [replace(body, tolerance=1e-6) for body in bodies]
        if kind == "faces" and name == "pin_in_a_block":
            case.code, case.says = (0, 2), "not a manifold"
        yield case, name, kind, unit, "solids"
    yield Case(f"brep/{name}.brep", bodies, options=MILLIMETRES), name, "-", "MM", "nested" if number % 2 else "solids"
    if number % 4 == 0:
        yield Case(f"brep/{name}_loose.brep", bodies, options=MILLIMETRES), name, "-", "MM", "loose"


def make_files(folder, converter, wanted):
    """Makes the wanted files; returns their cases."""
    sources = folder / "sources"
    for part in ("sources", "step", "iges", "brep"):
        (folder / part).mkdir(parents=True, exist_ok=True)
    cases, lines = [], []
    for number, name, bodies in built(sources):
        for case, source, schema, unit, arrangement in variants(number, name, bodies):
            if wanted(case.name):
                cases.append(case)
                lines.append(f"{sources / source}.brep {folder / case.name} {schema} {unit} {arrangement}")
    done = subprocess.run([converter], input="\n".join(lines) + "\n", text=True, capture_output=True)
    if done.returncode:
        print(done.stderr, end="")
    return cases

"""Parts held in one bore and loaded in another, from their files by gmsh and CalculiX: second-order tetrahedra."""

import math
import pathlib
from typing import NamedTuple

from . import finite_elements, seconds, solid_elements


class Bore(NamedTuple):
    """A cylinder along z; mm."""

    x: float
    y: float
    radius: float


class BoredPart(NamedTuple):
    """What `finite_elements.write_input` asks of a part, N and MPa, and where the part is held and loaded."""

    name: str
    file: str     # of verification/parts
    study: str    # of isopatch, the same support, load and material
    held: Bore
    loaded: Bore
    force: tuple
    young: float
    poisson: float
    energy: float      # J, the limit of ever finer meshes
    first_size: float  # mm, of the first tetrahedra


def _from_lame(first, second):
    return second * (3 * first + 2 * second) / (first + second), first / (2 * (first + second))


# Energy of the link: that of `peers`. It is the same part, drawn in place of generated.
LINK = BoredPart("link", "link.step", "examples/parts/study.toml", Bore(0.0, 0.0, 10.0), Bore(100.0, 0.0, 7.0),
                 (10e3, -2e3, 0.0), 210e3, 0.3, 0.579477, 9.0)
_BORE, _HEIGHT = 11.975, 29.937
_AREA = 2 * math.pi * _BORE * _HEIGHT
# Energy of the demonstrator: accuracy.energy = 0.005 gives 70.5707 J with an estimated error of 0.47 % in the energy
# norm, which is 0.0015 J and up to a third too small.
DEMONSTRATOR = BoredPart("demonstrator", "demonstrator.step", "examples/parts/demonstrator.toml",
                         Bore(-10.0, -21.9495, _BORE), Bore(181.5963, -147.6845, _BORE),
                         (20 * _AREA, -14 * _AREA, 0.0), *_from_lame(54e3, 27.8e3), 70.5725, 12.0)
FROM_TRIANGLES = DEMONSTRATOR._replace(name="demonstrator from triangles", file="demonstrator.stl",
                                       study="examples/demonstrator/study.toml")
PARTS = (LINK, DEMONSTRATOR, FROM_TRIANGLES)

# Of the corners of triangles on a bore, mm: those of a file of triangles lie on chords of 0.19 mm.
OFF_THE_BORE = 0.3


def from_triangles(file, size):
    """The text of a .geo file that meshes a closed surface of triangles anew, edges at 40 degrees, size in mm.

    Middle nodes stay on straight edges: to curve them on such surfaces takes gmsh 40 times as long as all the rest, for
    as much as meshes finer by a third give.
    """
    angle = math.radians(40)
    return "\n".join([f'Merge "{file}";', f"ClassifySurfaces{{{angle!r}, 1, 1, {angle!r}}};", "CreateGeometry;",
                      "Surface Loop(1) = Surface{:};", "Volume(1) = {1};", f"Mesh.MeshSizeMax = {size!r};",
                      f"Mesh.MeshSizeMin = {size!r};", "Mesh.MeshSizeFromCurvature = 0;",
                      "Mesh.SecondOrderLinear = 1;"]) + "\n"


def on(bore, mesh):
    """Triangles of the surfaces whose corners all lie on a bore; a bore may be several surfaces."""
    def off(number):
        x, y, _ = mesh.nodes[number]
        return abs(math.hypot(x - bore.x, y - bore.y) - bore.radius)

    found = [triangle for triangles in mesh.surfaces.values()
             if all(off(number) < OFF_THE_BORE for triangle in triangles for number in triangle[:3])
             for triangle in triangles]
    if not found:
        raise RuntimeError(f"no surface of the mesh lies on the bore of radius {bore.radius:g} mm "
                           f"at ({bore.x:g}, {bore.y:g}) mm")
    return found


def solve(part, file, size, *, threads, folder, timeout=None, memory=None):
    """One mesh of element size `size` (mm): Seconds of gmsh and ccx, free unknowns, energy (J).

    What turns gmsh's mesh into ccx's input is not counted.
    """
    folder = pathlib.Path(folder)
    text = from_triangles if file.suffix == ".stl" else solid_elements.imported
    (folder / "part.geo").write_text(text(file, size))
    bounds = {"threads": threads, "timeout": timeout, "memory": memory}
    meshing = seconds.of_program(["gmsh", "-3", "-order", "2", "-format", "msh22", "-v", "0", "-save_all", "-o",
                                  "part.msh", "part.geo"], folder, **bounds)
    mesh = finite_elements.read_mesh(folder / "part.msh", surface_tag=4)
    mesh = mesh._replace(surfaces={2: on(part.held, mesh), 3: on(part.loaded, mesh)})
    loads, dofs = finite_elements.write_input(folder / "part.inp", part, mesh)
    solving = seconds.of_program(["ccx", "part"], folder, **bounds)
    return {"size_mm": size, "dofs": dofs, "mesh": meshing, "solve": solving,
            "energy": finite_elements.energy(folder / "part.dat", loads)}

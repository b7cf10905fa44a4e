"""Solids made by gmsh (OpenCASCADE's kernel), in mm, with volume and area in closed form or by quadrature."""

# Their order, by which the files of each are chosen.
import plain_solids  # noqa: F401
import machined_solids  # noqa: F401
import drawn_solids  # noqa: F401
import several_bodies  # noqa: F401
from gmsh_shapes import SOLIDS  # noqa: F401

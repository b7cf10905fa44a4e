"""What a file should turn out to be."""

from dataclasses import dataclass, field


@dataclass
class Body:
    """A body of a file, in the unit of length of its case."""

    volume: float
    area: float
    box: tuple | None = None  # (low, high), where it is known
    genus: int | None = 0
    shells: int = 1
    stage: str | None = None
    name: str | None = None
    colours: set | None = None  # of its faces, as "#rrggbb"; None: not looked at
    faces: set | None = None  # names of its faces
    tolerance: float = 1e-7  # relative, of volume and area


@dataclass
class Case:
    """A file, and what `isopatch info --json` should say of it."""

    name: str  # with its ending; the file's name
    bodies: list = field(default_factory=list)
    metres: float = 1e-3  # of the unit of length of `bodies`
    unit: str | None = None  # as the program should call it
    code: int | tuple = 0  # exit codes that are right
    says: str = ""  # what an error or a warning must contain
    warns: bool | None = None  # whether there must be a warning; None: either
    options: tuple = ()
    make: object = None  # makes the bytes of the file; None where a converter does


def moved_box(low, high, by):
    """A box moved by a vector."""
    return tuple(tuple(c + d for c, d in zip(corner, by)) for corner in (low, high))


def box_body(x, y, z, low=(0, 0, 0), **more):
    """A rectangular block."""
    high = tuple(c + d for c, d in zip(low, (x, y, z)))
    more.setdefault("stage", "parameterization")
    return Body(x * y * z, 2 * (x * y + y * z + z * x), box=(tuple(low), high), **more)

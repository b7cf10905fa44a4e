"""CPU time of building from nothing, without a compiler cache: what a user waits for before the first result."""

import contextlib
import os
import pathlib
import resource
import subprocess
import tempfile
import time

from . import tables

# What scripts/run builds, and what scripts/test adds to it.
TARGETS = {"isopatch": ("isopatch",), "everything": ()}


def _seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def _run(command, **more):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **more)


@contextlib.contextmanager
def checkout(root, commit):
    """A folder with the files of a commit."""
    with tempfile.TemporaryDirectory(prefix="isopatch-tree-") as name:
        archive = subprocess.run(["git", "-C", root, "archive", commit], check=True, stdout=subprocess.PIPE).stdout
        _run(["tar", "-x", "-C", name], input=archive)
        yield pathlib.Path(name)


def build(tree, jobs):
    """[{"target", "cpu_seconds", "wall_seconds"}], each with all that came before; configuring counts for the first."""
    environment = {**os.environ, "CCACHE_DISABLE": "1"}
    result, cpu, wall = [], _seconds(), time.monotonic()
    with tempfile.TemporaryDirectory(prefix="isopatch-build-") as folder:
        _run(["cmake", "--preset", "release", "-B", folder], cwd=tree, env=environment)
        for target, names in TARGETS.items():
            _run(["ninja", "-C", folder, "-j", str(jobs), *names], env=environment)
            result.append({"target": target, "cpu_seconds": _seconds() - cpu, "wall_seconds": time.monotonic() - wall})
    return result


def measure(root, against, jobs):
    """Entries of a record, the ratios to a commit with them where one is given."""
    entries = build(root, jobs)
    if against:
        with checkout(root, against) as tree:
            for entry, other in zip(entries, build(tree, jobs)):
                entry.update(against=against, against_cpu_seconds=other["cpu_seconds"],
                             ratio=entry["cpu_seconds"] / other["cpu_seconds"])
    return entries


def report(entries):
    against = any("ratio" in entry for entry in entries)
    head = ["built", "CPU s", "wall s"] + ([f"CPU s of {entries[0]['against']}", "ratio"] if against else [])
    rows = [[entry["target"], f"{entry['cpu_seconds']:.0f}", f"{entry['wall_seconds']:.0f}"]
            + ([f"{entry['against_cpu_seconds']:.0f}", f"{entry['ratio']:.2f}"] if against else []) for entry in entries]
    return ["Building from nothing, without a compiler cache:", *tables.table(head, rows)]

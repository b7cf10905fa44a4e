"""From a file of CAD to figures by isopatch and by gmsh with CalculiX, in one run, at the same error of the energy."""

import itertools
import json
import math
import pathlib
import subprocess
import tempfile

from . import bored_parts, runs, seconds, solid_elements, tables

TARGETS = (5e-3, 1e-3)  # relative errors of the energy at which both are compared
STAGES = ("read", "cut", "parameterize")
ELEMENTS = (1, 2, 3, 4, 6, 8)    # of isopatch's runs: least number along each direction of each patch, degree 3
FINER = 1.5                      # sizes of tetrahedra fall by it
LONGEST = 60.0                   # seconds of the processor; the next mesh would take about six times as many
MOST_REPETITIONS, ENOUGH = 3, 10.0  # no more repetitions of what took the processor so many seconds


def error_of(part, energy):
    """Relative error of the energy."""
    return abs(energy / part.energy - 1)


def total(entry):
    return seconds.of_all(entry["seconds"].values())


def repeated(call):
    """The repetition with the least total, of up to three until enough seconds are spent."""
    done = []
    while len(done) < MOST_REPETITIONS and (not done or sum(total(one).processor for one in done) < ENOUGH):
        done.append(call())
    return min(done, key=lambda one: total(one).processor)


# ----------------------------------------------------------------- isopatch


def _run(root, program, study, folder, options, *, threads, timeout):
    line = [str(program), "run", str(study), "--quiet", "--threads", str(threads), "--output", str(folder),
            *map(str, options)]
    done, took = seconds.measured(lambda: subprocess.run(
        line, env=runs.environment(root, threads), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE, text=True, timeout=timeout))
    if done.returncode:
        raise RuntimeError(runs.cause(done.stderr) or f"exit code {done.returncode}")
    return took


def _solution(part, run, folder, elements, *options):
    """One run: the seconds of solving and, by their share of the clock, of writing files, and the figures."""
    took = run(part.study, folder, [*options, "--set", "discretization.refine=0", "--set",
                                    f"discretization.elements_per_direction={elements}"])
    summary = json.loads((folder / "summary.json").read_text())
    energy = summary["results"]["internal_energy"]
    writing = summary["timings"]["output"] / summary["timings"]["total"]
    return {"elements_per_direction": elements, "patches": summary["model"]["patches"],
            "dofs": summary["discretization"]["dofs_free"], "energy": energy, "error": error_of(part, energy),
            "estimated_error": summary["results"]["discretization_error"]["energy_norm"] ** 2,
            "clock_of_stages": [stage["seconds"] for stage in summary["stages"]],
            "seconds": {"solve": took.share(1 - writing), "write": took.share(writing)}}


def before_solving(whole, solution):
    """Seconds of reading, cutting and parameterizing: what a whole run took longer than one from the patches it kept,
    in the proportions of the stages by the clock."""
    more = total(whole).minus(total(solution))
    together = sum(whole["clock_of_stages"])
    return {name: more.share(took / together) for name, took in zip(STAGES, whole["clock_of_stages"])}


def by_isopatch(part, run, folder):
    """Yields an entry for each number of elements, until one is within the last target. The seconds of an entry are
    from the file on: solids, hexahedra and patches are made once, and count in each."""
    whole = repeated(lambda: _solution(part, run, folder, ELEMENTS[0], "--from", "solid"))
    before = None
    for elements in ELEMENTS:
        entry = repeated(lambda: _solution(part, run, folder, elements, "--from", "solution"))
        before = before or before_solving(whole, entry)
        entry["seconds"] = {**before, **entry["seconds"]}
        yield entry
        if entry["error"] <= min(TARGETS):
            return


# ------------------------------------------------------- gmsh and CalculiX


def _mesh(part, file, size, folder, bounds):
    found = bored_parts.solve(part, file, size, folder=folder, **bounds)
    return {"size_mm": size, "dofs": found["dofs"], "energy": found["energy"],
            "error": error_of(part, found["energy"]), "seconds": {"mesh": found["mesh"], "solve": found["solve"]}}


def by_finite_elements(part, file, folder, bounds):
    """Yields an entry for each size until one is within the last target.

    Raises RuntimeError after a mesh that took very long without being so near.
    """
    for level in itertools.count():
        size = part.first_size / FINER ** level
        found = repeated(lambda: _mesh(part, file, size, folder, bounds))
        yield found
        if found["error"] <= min(TARGETS):
            return
        if total(found).processor > LONGEST:
            raise RuntimeError(f"error {found['error']:.2g} after {total(found).processor:.0f} s, no finer mesh was made")


# ----------------------------------------------------------------- together


def _until_it_fails(entries, failures, name):
    """The entries up to the first failure, which becomes a sentence."""
    try:
        yield from entries
    except subprocess.TimeoutExpired as late:
        failures[name] = f"{pathlib.PurePath(late.cmd[0]).name} took more than {late.timeout:.0f} s"
    except subprocess.CalledProcessError as failed:
        failures[name] = f"{failed.cmd[0]} failed with {failed.returncode}"
    except RuntimeError as failed:
        failures[name] = str(failed)


def in_turns(sides):
    """({side: its entries}, {side: why it ended early}) of iterators over entries, one of each after the other."""
    found, failures = {name: [] for name in sides}, {}
    for turn in itertools.zip_longest(*(_until_it_fails(side, failures, name) for name, side in sides.items())):
        for name, entry in zip(sides, turn):
            if entry:
                found[name].append(entry)
    return found, failures


def measure(root, program, part, *, with_finite_elements, threads, folder, timeout, memory):
    """{"part", "threads", "reference_energy", "isopatch": [...], "finite_elements": [...], "failures": {...}}."""
    file = program.resolve().parents[1] / "verification" / "parts" / "files" / part.file

    def run(study, output, options):
        return _run(root, program, pathlib.Path(root) / study, output,
                    [*options, "--set", f"model.file={file}"], threads=threads, timeout=timeout)

    with tempfile.TemporaryDirectory(dir=folder) as ours, tempfile.TemporaryDirectory(dir=folder) as theirs:
        bounds = {"threads": threads, "timeout": timeout, "memory": memory}
        tetrahedra = by_finite_elements(part, file, theirs, bounds) if with_finite_elements else iter(())
        found, failures = in_turns({"isopatch": by_isopatch(part, run, pathlib.Path(ours)),
                                    "finite_elements": tetrahedra})
    return {"part": part.name, "threads": threads, "reference_energy": part.energy, **found, "failures": failures}


def at(target, entries):
    """(Seconds at an error, whether they are only known to be enough), between the neighbouring entries as powers of
    the error; None where no entry is so near."""
    near = next((i for i, entry in enumerate(entries) if entry["error"] <= target), None)
    if near is None:
        return None
    if near == 0:
        return total(entries[0]), True
    before, after = entries[near - 1], entries[near]
    share = math.log(before["error"] / target) / math.log(before["error"] / after["error"])
    return seconds.Seconds(*(math.exp((1 - share) * math.log(a) + share * math.log(b))
                             for a, b in zip(total(before), total(after)))), False


def limits(found):
    """{side: energy at infinite fineness}: isopatch's with its estimated error added, the tetrahedra's from the last
    three meshes."""
    result = {}
    if found["isopatch"]:
        last = found["isopatch"][-1]
        result["isopatch"] = last["energy"] * (1 + last["estimated_error"])
    if len(found["finite_elements"]) > 2:
        result["finite_elements"] = solid_elements.extrapolated(found["finite_elements"][-3:])
    return result


def recorded(found):
    """With plain values, for the record."""
    def plain(entry):
        return {**entry, "seconds": {name: took._asdict() for name, took in entry["seconds"].items()}}

    return {**found, "isopatch": [plain(e) for e in found["isopatch"]],
            "finite_elements": [plain(e) for e in found["finite_elements"]], "limits": limits(found)}


# ------------------------------------------------------------------- report

COLUMNS = (*STAGES, "mesh", "solve", "write")
NAMES = {"isopatch": "isopatch", "finite_elements": "gmsh + CalculiX"}


def _row(name, entry):
    number = tables.figure
    took = [number(entry["seconds"][column].processor, 2) if column in entry["seconds"] else "-" for column in COLUMNS]
    return [name, number(entry["dofs"]), *took, number(total(entry).processor, 3), number(total(entry).clock, 3),
            number(entry["error"], 2)]


def with_another_load(entries):
    """Entries without what a part takes once: patches, or a mesh."""
    once = (*STAGES, "mesh")
    return [{**entry, "seconds": {name: took for name, took in entry["seconds"].items() if name not in once}}
            for entry in entries]


def _compared(words, sides, target):
    """A sentence on both sides at an error."""
    def said(known):
        return f"{'at most ' if known[1] else ''}{tables.figure(known[0].processor)} s" if known else "not reached"

    known = {side: at(target, entries) for side, entries in sides.items()}
    text = f"{words}, error {target:g}: " + "; ".join(f"{NAMES[side]} {said(value)}" for side, value in known.items())
    if all(known.values()):
        clock, processor = (theirs / ours for ours, theirs in
                            zip(known["isopatch"][0], known["finite_elements"][0]))
        text += f"; ratio {tables.figure(processor, 2)} (clock {tables.figure(clock, 2)})"
    return text + "."


def report(found):
    rows = [_row(f"isopatch, {e['patches']} patches, {e['elements_per_direction']}^3 elements or more", e)
            for e in found["isopatch"]]
    rows += [_row(f"gmsh + CalculiX, {e['size_mm']:.2g} mm", e) for e in found["finite_elements"]]
    lines = [f"### The {found['part']} from its file to figures, {found['threads']} threads, seconds of the processor", ""]
    lines += tables.table(["", "DOFs", *COLUMNS, "total", "clock", "error of energy"], rows) + [""]
    if found["finite_elements"]:
        sides = {side: found[side] for side in NAMES}
        again = {side: with_another_load(entries) for side, entries in sides.items()}
        lines += [_compared(words, compared, target) for words, compared in
                  (("From the file", sides), ("Another load", again)) for target in TARGETS]
    lines += [f"{NAMES[side]} ended: {why}." for side, why in found["failures"].items()]
    lines += [f"Energy {found['reference_energy']:.6g} J; " +
              ", ".join(f"{NAMES[side]} towards {limit:.6g} J" for side, limit in limits(found).items()) + "."]
    return lines

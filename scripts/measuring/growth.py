"""How the time of each phase of a run grows with the number of unknowns."""

import math

from . import runs, tables

BOUND = 1.2     # largest exponent of a phase other than a direct factorization
SHORTEST = 0.1  # seconds at the larger size, below which an exponent says nothing
# Elements along each direction of each of the link's eleven patches, for about 10^4, 10^5 and 10^6 free unknowns at
# degree 3.
ELEMENTS = {10_000: 4, 100_000: 12, 1_000_000: 29}


def overrides(elements, degree=3):
    return {"discretization.refine": 0, "discretization.degree": degree,
            "discretization.elements_per_direction": elements}


def measure(root, program, study, elements, *, threads, folder, timeout, memory, most=3, enough=20.0):
    """Up to `most` runs, no more once `enough` seconds have gone; one entry of a record."""
    done, spent = [], 0.0
    while len(done) < most and (not done or spent < enough):
        run = runs.run_study(root, [program], study, overrides(elements), threads=threads, folder=folder,
                             timeout=timeout, memory=memory)
        if run.failure:
            return {"elements_per_direction": elements, "threads": threads, "failure": run.failure}
        done.append(run)
        spent += run.wall_seconds
    times, wall = runs.fastest(done)
    summary = done[-1].summary
    return {
        "elements_per_direction": elements, "threads": threads, "failure": "", "dofs": done[-1].dofs,
        "elements": summary["discretization"]["elements"],
        "degree": summary["discretization"]["degree"], "phases": times, "wall_seconds": wall,
        "method": summary["solver"]["method"], "direct": runs.is_direct(done[-1]),
        "iterations": summary["solver"]["iterations"], "peak_bytes": summary["memory"]["peak_bytes"],
        "internal_energy": summary["results"]["internal_energy"],
    }


def exponent(smaller, larger, phase, size="dofs"):
    """log time over log size between two entries; None where the phase is absent or too short."""
    before, after = smaller["phases"].get(phase), larger["phases"].get(phase)
    if not before or not after or after < SHORTEST:
        return None
    return math.log(after / before) / math.log(larger[size] / smaller[size])


def exponents(entries):
    """For each pair of neighbouring sizes {phase: {"exponent", "by_elements", "within"}}.

    Patches of few elements have more unknowns an element, so what works through elements grows faster with the unknowns
    than with the elements. A phase is within the bound if it is so by either; the solver's, which know no elements, by
    the unknowns. `within` is None for a direct factorization, which has no bound. The solver's phases have no exponent
    between two sizes that different methods solved.
    """
    done = [entry for entry in entries if not entry["failure"]]
    found = []
    for smaller, larger in zip(done, done[1:]):
        pair = {"from_dofs": smaller["dofs"], "to_dofs": larger["dofs"], "phases": {}}
        for phase in larger["phases"]:
            if phase.startswith("solve") and smaller["method"] != larger["method"]:
                continue
            value, by_elements = (exponent(smaller, larger, phase, size) for size in ("dofs", "elements"))
            if value is not None:
                judged = value if phase.startswith("solve") else min(value, by_elements)
                free = larger["direct"] and phase == "solve: factorization"
                pair["phases"][phase] = {"exponent": value, "by_elements": by_elements,
                                         "within": None if free else judged <= BOUND}
        found.append(pair)
    return found


def report(entries):
    number = tables.figure
    done = [entry for entry in entries if not entry["failure"]]
    lines = ["### A whole run on the link by phase, degree 3", ""]
    for entry in entries:
        if entry["failure"]:
            lines += [f"{entry['elements_per_direction']} elements per direction and patch: not measured: "
                      f"{entry['failure']}", ""]
    if not done:
        return lines
    pairs = exponents(entries)
    phases = list(dict.fromkeys(phase for entry in done for phase in entry["phases"]))
    rows = []
    for phase in phases:
        row = [phase] + [number(entry["phases"].get(phase)) for entry in done]
        for pair in pairs:
            found = pair["phases"].get(phase)
            mark = {None: ", no bound", True: "", False: f", ABOVE {BOUND}"}
            row.append(f"{found['exponent']:.2f}, {found['by_elements']:.2f}{mark[found['within']]}"
                       if found else "-")
        rows.append(row)
    dashes = ["-"] * len(pairs)
    rows.append(["whole run"] + [number(entry["wall_seconds"]) for entry in done] + dashes)
    rows.append(["elements"] + [number(entry["elements"]) for entry in done] + dashes)
    rows.append(["most memory, bytes per DOF"] + [number(round(e["peak_bytes"] / e["dofs"])) for e in done] + dashes)
    rows.append(["method, iterations"] + [f"{e['method']}, {e['iterations']}" for e in done] + dashes)
    head = ["seconds"] + [f"{entry['dofs']:,} DOFs" for entry in done]
    lines += tables.table(head + [f"exponent by DOFs, by elements {p['from_dofs']:,} to {p['to_dofs']:,}" for p in pairs], rows)
    return lines

"""Strong and weak scaling of whole runs over processes and threads."""

import argparse

from . import growth, runs, tables

LAST_LINES = 20  # of what a failed run said, in the report; the record has all

def parse_layouts(text):
    """"1x1,2x1,1x2": ranks x threads of each. For argparse."""
    layouts = []
    for entry in text.split(","):
        ranks, _, threads = entry.partition("x")
        if not (ranks.isdigit() and threads.isdigit() and int(ranks) > 0 and int(threads) > 0):
            raise argparse.ArgumentTypeError(f"'{entry}' is no layout: RANKSxTHREADS, for example 4x2")
        layouts.append((int(ranks), int(threads)))
    return layouts


def default_layouts(cores):
    """Powers of two up to the cores: threads of one rank, then ranks of one thread."""
    powers = [2 ** k for k in range(cores.bit_length()) if 2 ** k <= cores]
    return [(1, n) for n in powers] + [(n, 1) for n in powers[1:]]


def elements_for(base, workers, degree):
    """Elements per direction that give `workers` times the unknowns of `base` at highest continuity."""
    return max(base, round((base + degree) * workers ** (1 / 3)) - degree)


def measure(root, program, study, overrides, layout, *, launcher, folder, timeout, repetitions):
    """One entry: the least times of some runs, or why there are none."""
    ranks, threads = layout
    command = [word.format(ranks=ranks, threads=threads) for word in launcher] + [program]
    entry = {"ranks": ranks, "threads": threads, "failure": ""}
    done = []
    for _ in range(repetitions):
        run = runs.run_study(root, command, study, overrides, threads=threads, folder=folder, timeout=timeout)
        if run.failure:
            return {**entry, "failure": run.failure, "said": run.said}
        done.append(run)
    times, wall = runs.fastest(done)
    summary = done[-1].summary
    return {**entry, "dofs": done[-1].dofs, "phases": times, "wall_seconds": wall,
            "method": summary["solver"]["method"], "iterations": summary["solver"]["iterations"],
            "peak_bytes": summary["memory"]["peak_bytes"]}


def measure_all(root, program, study, base, degree, layouts, say, **how):
    """{"strong": entries, "weak": entries}; `base`: elements per direction and patch on one worker."""
    found = {"strong": [], "weak": []}
    for ranks, threads in layouts:
        for kind, elements in (("strong", base), ("weak", elements_for(base, ranks * threads, degree))):
            if kind == "weak" and ranks * threads == 1:
                found["weak"] = list(found["strong"])
                continue
            say(f"{kind} scaling, {ranks} x {threads}, {elements} elements per direction and patch")
            found[kind].append(measure(root, program, study, growth.overrides(elements, degree), (ranks, threads),
                                       **how))
    return found


def ratios(entries):
    """Speed-up and efficiency of each entry and phase against the first entry.

    Speed-up is that in unknowns per second, so the weak series need not have exactly its share of unknowns; efficiency
    is speed-up by the number of workers, ranks times threads.
    """
    first = entries[0]
    result = []
    for entry in entries:
        more = entry["ranks"] * entry["threads"] / (first["ranks"] * first["threads"])
        times = {"whole run": (first["wall_seconds"], entry["wall_seconds"])}
        times.update({p: (t, entry["phases"][p]) for p, t in first["phases"].items() if p in entry["phases"]})
        gain = entry["dofs"] / first["dofs"]
        result.append({phase: {"speed_up": gain * before / after, "efficiency": gain * before / after / more}
                       for phase, (before, after) in times.items() if before > 0 and after > 0})
    return result


def report(kind, entries):
    """Lines in Markdown: a row for each phase, seconds and (speed-up, efficiency) for each layout."""
    number = tables.figure
    lines = [f"### {kind.capitalize()} scaling", ""]
    failed = [entry for entry in entries if entry["failure"]]
    for entry in failed:
        lines += [f"{entry['ranks']} ranks x {entry['threads']} threads: {entry['failure']}", ""]
        said = entry["said"].strip().splitlines()
        if said[1:]:
            lines += [*("    " + line for line in said[-LAST_LINES:]), ""]
    done = [entry for entry in entries if not entry["failure"]]
    if not done:
        return lines
    gains = ratios(done)
    phases = list(dict.fromkeys(phase for entry in done for phase in entry["phases"]))
    rows = []
    for phase in phases + ["whole run"]:
        row = [phase]
        for entry, gain in zip(done, gains):
            seconds = entry["wall_seconds"] if phase == "whole run" else entry["phases"].get(phase)
            text = number(seconds)
            if entry is not done[0] and phase in gain:
                text += f" ({gain[phase]['speed_up']:.2f}, {100 * gain[phase]['efficiency']:.0f} %)"
            row.append(text)
        rows.append(row)
    rows.append(["DOFs"] + [number(entry["dofs"]) for entry in done])
    rows.append(["method, iterations"] + [f"{entry['method']}, {entry['iterations']}" for entry in done])
    rows.append(["most memory of a rank, MB"] + [number(round(entry["peak_bytes"] / 1e6)) for entry in done])
    head = ["seconds (speed-up, efficiency)"]
    lines += tables.table(head + [f"{e['ranks']} x {e['threads']}" for e in done], rows)
    return lines

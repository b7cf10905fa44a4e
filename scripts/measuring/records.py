"""Records of measurements, and the comparison of two of them."""

import json
import pathlib

from . import kernels, machine, tables

SCHEMA = 1
SHORTEST = 0.1  # seconds; phases of runs below it are not compared


def path_of(root, record):
    """Where a record of this tree is kept."""
    name = f"{record['version']}-{machine.slug(record['machine'])}.json"
    return pathlib.Path(root) / "verification" / "performance" / "records" / name


def write(record, path):
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def read(path):
    """@throws ValueError: no record, or one of another schema."""
    try:
        record = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    except json.JSONDecodeError as error:
        raise ValueError(f"{path}: no JSON: {error}") from error
    if not isinstance(record, dict) or record.get("schema_version") != SCHEMA:
        raise ValueError(f"{path}: not a record of scripts/bench with schema_version {SCHEMA}")
    return record


def timed(record):
    """{what: (seconds, threads, limit)}: everything with a time; limit: "dgemm" or "memory", what bounds it."""
    found = {}
    for entry in record.get("kernels", []):
        patch = f"p = {entry['p']}, {entry['spans']}^3{', rational' if entry['rational'] else ''}"
        name = f"{entry['kernel']}, {patch}, {entry['threads']} threads"
        found[name] = (entry["seconds"], entry["threads"], "memory" if entry["kernel"] == "product" else "dgemm")
    for run in record.get("runs", []):
        if run["failure"]:
            continue
        for phase, seconds in [*run["phases"].items(), ("whole run", run["wall_seconds"])]:
            if seconds >= SHORTEST:
                limit = "memory" if phase == "solve: solve" else "dgemm"
                found[f"link, {run['dofs']:,} DOFs, {phase}"] = (seconds, run["threads"], limit)
    return found


def limit_of(record, threads, limit):
    """The machine's rate with so many threads, or with the most threads measured below that; None if not measured."""
    measured = {entry["threads"]: entry for entry in record.get("limits", [])}
    fitting = [count for count in measured if count <= threads]
    if not fitting:
        return None
    entry = measured[max(fitting)]
    return entry["dgemm_gflops"] if limit == "dgemm" else kernels.bandwidth(entry)


def compare(before, after):
    """What both records have: {"what", "before", "after", "ratio", "limit", "corrected"}; a ratio above 1 is slower.

    The corrected ratio is that of the times in units of the machine's own time for the same operations or bytes: what
    would be left if both machines were equally fast. None if a limit is absent.
    """
    rows, first, second = [], timed(before), timed(after)
    for what, (seconds, threads, limit) in first.items():
        if what not in second:
            continue
        later = second[what][0]
        rates = limit_of(before, threads, limit), limit_of(after, second[what][1], limit)
        ratio = later / seconds
        rows.append({"what": what, "before": seconds, "after": later, "ratio": ratio, "limit": limit,
                     "corrected": ratio * rates[1] / rates[0] if all(rates) else None})
    return rows


def report(before, after, rows, bound):
    """`bound`: ratios above it are marked; None marks none."""
    def title(record):
        made_with = record["machine"]
        return (f"version {record['version']}, commit {record['commit'] or '-'}, {record['date'][:10]}, "
                f"{made_with['cpu']}, {made_with['cores']} cores")

    number = tables.figure
    lines = ["before: " + title(before), "after:  " + title(after), ""]
    for name, limit in (("dgemm, Gflop/s", "dgemm"), ("memory, GB/s", "memory")):
        rates = [limit_of(record, 1, limit) for record in (before, after)]
        lines.append(f"{name}, one thread: {number(rates[0])} before, {number(rates[1])} after")
    lines.append("")
    lines += tables.table(["seconds", "before", "after", "ratio", "limit", "corrected ratio"], [
        [row["what"], number(row["before"]), number(row["after"]), number(row["ratio"]), row["limit"],
         number(row["corrected"]) + (" SLOWER" if bound and slower(row, bound) else "")] for row in rows])
    return lines


def slower(row, bound):
    value = row["corrected"] if row["corrected"] is not None else row["ratio"]
    return value > bound

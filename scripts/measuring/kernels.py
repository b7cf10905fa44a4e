"""Figures from what verification/performance/measure_kernels has measured."""

import json
import subprocess

from . import runs, tables

# Floating point operations of dense products per degree of freedom that element-wise formation needs inside a patch of
# splines of highest continuity: 9 (p + 1)^9 per element, one element for every three degrees of freedom.
FORMATION_KFLOP = {2: 60.0, 3: 790.0, 4: 5900.0}
FORMATION_GOAL = {2: 3.0, 3: 1.0, 4: 0.5}  # largest ratio of formation time to those operations at the rate of dgemm
SPEED_UP_GOAL = 1.8                        # of two threads
# Of one product without a matrix by sum factorization with (p + 1)^3 points per element.
APPLY_KFLOP = {2: 2.9, 3: 7.6, 4: 16.0}

# On a link of which no interface matches: the elements' stiffness, and what ties the patches.
INTERFACES = ("link", "interfaces", "jumps")
INTERFACE_GOAL = 0.15                      # of the time of the elements' stiffness

_UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def measure(root, program, output, repetitions, seconds=0.1):
    """Runs the program, every repetition in another random order; its JSON goes to `output`."""
    subprocess.run([str(program), f"--benchmark_out={output}", "--benchmark_out_format=json",
                    f"--benchmark_repetitions={repetitions}", "--benchmark_enable_random_interleaving=true",
                    f"--benchmark_min_time={seconds}"],
                   env=runs.environment(root, threads=1), check=True, stdin=subprocess.DEVNULL,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(output, encoding="utf-8") as file:
        return json.load(file)


def fastest(measured):
    """One entry per benchmark: its counters, `kernel`, and `seconds`, the least of the repetitions.

    One thread counts by its processor time, which is the time on the clock of a machine that nobody else uses; more
    threads count by the clock.
    """
    entries = {}
    for run in measured["benchmarks"]:
        if run.get("run_type") == "aggregate":
            continue
        if run.get("error_occurred"):
            raise RuntimeError(f"{run['name']}: {run.get('error_message', 'failed')}")
        threads = round(run["omp_threads"])
        unit = _UNITS[run["time_unit"]]
        seconds = unit * (run["cpu_time"] if threads == 1 else run["real_time"])
        entry = entries.setdefault(run["run_name"], {"kernel": run["run_name"].split("/")[0], "threads": threads,
                                                 "seconds": seconds})
        entry["seconds"] = min(entry["seconds"], seconds)
        for counter in ("flops", "bytes", "dofs", "elements", "p", "spans", "rational"):
            if counter in run:
                entry[counter] = round(run[counter])
    return list(entries.values())


def limits(entries):
    """{threads: {"dgemm_gflops", "triad_gbs", "read_gbs"}}: what the machine did in the same run."""
    found = {}
    for entry in entries:
        rate = entry.get("flops" if entry["kernel"] == "dgemm" else "bytes", 0) / entry["seconds"] / 1e9
        name = {"dgemm": "dgemm_gflops", "triad": "triad_gbs", "read": "read_gbs"}.get(entry["kernel"])
        if name:
            found.setdefault(entry["threads"], {"threads": entry["threads"]})[name] = rate
    return dict(sorted(found.items()))


def bandwidth(limit):
    """GB/s that the memory gives at best."""
    return max(limit["triad_gbs"], limit["read_gbs"])


def figures(entries):
    """The kernels' entries with what follows from them: us_per_dof, gflops or gbs, ratios to the limits, speed_up."""
    machine = limits(entries)
    kernels = [dict(entry) for entry in entries if "dofs" in entry and entry["kernel"] not in INTERFACES]
    key = lambda entry, *names: tuple(entry.get(name) for name in names)
    one = {key(e, "kernel", "p", "spans", "rational"): e["seconds"] for e in kernels if e["threads"] == 1}
    products = {}
    for entry in kernels:
        if entry["kernel"] == "product":
            products[key(entry, "p", "rational", "threads")] = entry["seconds"] / entry["dofs"]
    for entry in kernels:
        limit, dofs, seconds = machine[entry["threads"]], entry["dofs"], entry["seconds"]
        entry["us_per_dof"] = 1e6 * seconds / dofs
        if entry["threads"] > 1:
            entry["speed_up"] = one[key(entry, "kernel", "p", "spans", "rational")] / seconds
        if entry["kernel"] == "formation":
            _formation(entry, machine)
        else:
            entry["gbs"] = entry["bytes"] / seconds / 1e9
            entry["to_memory"] = seconds / (entry["bytes"] / 1e9 / bandwidth(limit))
        if entry["kernel"] == "apply":
            flops = 1e3 * APPLY_KFLOP[entry["p"]] * dofs
            entry["gflops"] = flops / seconds / 1e9
            entry["to_dgemm"] = limit["dgemm_gflops"] / entry["gflops"]
            product = products.get(key(entry, "p", "rational", "threads"))
            entry["to_product"] = seconds / dofs / product if product else None
    return kernels


def interfaces(entries):
    """What ties patches that do not match, beside the elements of the same link: shares of their time, by threads."""
    measured = [dict(entry) for entry in entries if entry["kernel"] in INTERFACES]
    key = lambda entry: (entry["p"], entry["spans"], entry["threads"])
    elements = {key(entry): entry["seconds"] for entry in measured if entry["kernel"] == "link"}
    for entry in measured:
        entry["share"] = entry["seconds"] / elements[key(entry)]
    return measured


def _formation(entry, machine):
    """R, and the same with the operations counted by the patch's elements instead of its degrees of freedom."""
    p, rate = entry["p"], machine[1]["dgemm_gflops"] * 1e9
    entry["gbs"] = entry["bytes"] / entry["seconds"] / 1e9
    if entry["threads"] == 1:
        entry["r"] = entry["seconds"] * rate / (1e3 * FORMATION_KFLOP[p] * entry["dofs"])
        entry["r_by_elements"] = entry["seconds"] * rate / (9.0 * (p + 1) ** 9 * entry["elements"])
        entry["reached"] = entry["r"] <= FORMATION_GOAL[p]
    elif entry["threads"] == 2:
        entry["reached"] = entry["speed_up"] >= SPEED_UP_GOAL


def report(entries):
    """Lines for people."""
    number = tables.figure
    lines = ["### Limits of this machine, in the same run", ""]
    lines += tables.table(["threads", "dgemm Gflop/s", "triad GB/s", "read GB/s"],
                          [[str(l["threads"]), number(l["dgemm_gflops"]), number(l["triad_gbs"]), number(l["read_gbs"])]
                           for l in limits(entries).values()])
    kernels = figures(entries)

    def patch(e):
        return f"p = {e['p']}, {e['spans']}^3 spans{', rational' if e['rational'] else ''}"

    def part(title, kernel, head, row):
        chosen = [entry for entry in kernels if entry["kernel"] == kernel]
        if chosen:
            lines.extend(["", "### " + title, ""])
            lines.extend(tables.table(["patch", "DOFs", "threads", "ms", "us/DOF", *head, "speed-up"], [
                [patch(e), number(e["dofs"]), str(e["threads"]), number(1e3 * e["seconds"]), number(e["us_per_dof"]),
                 *row(e), number(e.get("speed_up"))] for e in sorted(
                     chosen, key=lambda e: (e["rational"], e["p"], e["spans"], e["threads"]))]))

    def goal(e):
        aim = f"R <= {FORMATION_GOAL[e['p']]:g}" if e["threads"] == 1 else f"speed-up >= {SPEED_UP_GOAL:g}"
        return f"{aim}: {'reached' if e['reached'] else 'MISSED'}" if "reached" in e else "-"

    part("Formation of the elasticity matrix, pattern and values", "formation", ["R", "R by elements", "goal"],
         lambda e: [number(e.get("r")), number(e.get("r_by_elements")), goal(e)])
    part("Product with the assembled matrix", "product", ["GB/s", "time / memory limit"],
         lambda e: [number(e["gbs"]), number(e["to_memory"])])
    part("Product without a matrix", "apply",
         ["Gflop/s", "time / dgemm limit", "time / memory limit", "time / assembled product"],
         lambda e: [number(e["gflops"]), number(e["to_dgemm"]), number(e["to_memory"]), number(e["to_product"])])
    return lines + _interface_report(entries)


def _interface_report(entries):
    number = tables.figure
    of_ways = {"interfaces": "Nitsche", "jumps": "mortar"}
    rows = [[f"p = {e['p']}, {e['spans']}^3 spans or more", number(e["dofs"]), str(e["threads"]), of_ways[e["kernel"]],
             number(1e3 * e["seconds"]), number(e["share"]),
             "reached" if e["share"] <= INTERFACE_GOAL else "MISSED"]
            for e in interfaces(entries) if e["kernel"] in of_ways]
    if not rows:
        return []
    return ["", "### Interfaces that do not match, all of the link's", "",
            *tables.table(["patch", "DOFs", "threads", "way", "ms", "time / elements' stiffness",
                           f"goal {INTERFACE_GOAL:g}"], rows)]

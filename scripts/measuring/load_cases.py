"""What ten load cases take beside one, in one process: they share matrix, factors or multigrid."""

import pathlib
import re

from . import runs, tables

CASES = 10
METHODS = ("cholmod", "cg")
WITHOUT_FILES = {"output.fields": "false", "output.report": "false"}


def study_text(text, cases):
    """A study with as many load cases in place of its loads, each of one patch's own body force: none depends on others."""
    loads = "".join(f"""[[load]]
case = "case_{i}"
patches = [{i}]
body_force = ["{3 * (-1) ** i} MN/m^3", "{i - 4.5} MN/m^3", "2 MN/m^3"]

""" for i in range(cases))
    without = re.sub(r"^\[\[load\]\]\n(?:(?!\[).*\n)*", "", text, flags=re.MULTILINE)
    return without + "\n" + loads


def measure(root, program, study, *, threads, folder, timeout, refine=3, most=3):
    """One entry for each method, with and without files: the least seconds of one case and of ten."""
    text = pathlib.Path(study).read_text(encoding="utf-8")
    entries = []
    for method in METHODS:
        for files in (False, True):
            entry = {"method": method, "files": files, "failure": ""}
            overrides = {"discretization.refine": refine, "solver.method": method, **({} if files else WITHOUT_FILES)}
            for cases in (1, CASES):
                path = pathlib.Path(folder) / f"cases_{cases}.toml"
                path.write_text(study_text(text, cases), encoding="utf-8")
                done = [runs.run_study(root, [program], path, overrides, threads=threads, folder=folder,
                                       timeout=timeout) for _ in range(most)]
                failed = [run.failure for run in done if run.failure]
                if failed:
                    entry["failure"] = failed[0]
                    break
                phases, wall = runs.fastest(done)
                entry[str(cases)] = {"wall_seconds": wall, "phases": phases, "dofs": done[-1].dofs}
            entries.append(entry)
    return entries


def ratio(entry):
    return None if entry["failure"] else entry[str(CASES)]["wall_seconds"] / entry["1"]["wall_seconds"]


def report(entries):
    rows = [[entry["method"] + (", all files" if entry["files"] else ", results.h5 alone"),
             *([entry["failure"], "", ""] if entry["failure"] else
               [tables.figure(entry["1"]["wall_seconds"]), tables.figure(entry[str(CASES)]["wall_seconds"]),
                tables.figure(ratio(entry))])] for entry in entries]
    return [f"{CASES} load cases of the link beside one, least of several runs:", "",
            *tables.table(["", "one, s", f"{CASES}, s", "ratio"], rows)]

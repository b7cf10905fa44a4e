"""Checks that a run has left whole and sane results: check_results.py DIRECTORY."""

import json
import math
import pathlib
import sys
import xml.etree.ElementTree

HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"


def problems(folder):
    """What is wrong with the results in a folder, one sentence each."""
    found = []

    def expect(condition, sentence):
        if not condition:
            found.append(sentence)

    summary = json.loads((folder / "summary.json").read_text())
    results, solver = summary["results"], summary["solver"]
    energy, work = results["internal_energy"], results["external_work"]
    expect(energy > 0 and math.isfinite(energy), f"internal energy {energy} J is not positive")
    expect(abs(energy - work) <= 1e-8 * abs(energy), f"internal energy {energy} J and external work {work} J differ")
    expect(0 <= solver["relative_residual"] <= 1e-8, f"relative residual {solver['relative_residual']}")
    expect(results["max_displacement"] > 0, f"largest displacement {results['max_displacement']} m")
    expect(results["max_von_mises"] > 0, f"largest von Mises stress {results['max_von_mises']} Pa")
    expect(summary["model"]["volume"] > 0, f"volume {summary['model']['volume']} m^3")
    expect(summary["discretization"]["dofs_free"] > 0, "no free degree of freedom")

    stored = folder / "results.h5"
    expect(stored.is_file() and stored.read_bytes()[:8] == HDF5_SIGNATURE, "results.h5 is no HDF5 file")
    parts = set(folder.rglob("*.vtu"))
    collections = [folder / name for name in ("results.vtm", "results_boundaries.vtm", "results_exact.vtm")]
    named = set()
    for collection in collections:
        expect(collection.is_file(), f"{collection.name} is missing")
        if collection.is_file():
            entries = xml.etree.ElementTree.parse(collection).iter("DataSet")
            named |= {folder / entry.attrib["file"] for entry in entries}
    expect(named == parts, f"fields named and there differ: {sorted(path.name for path in named ^ parts)}")
    report = folder / "report.html"
    expect(report.is_file() and report.read_text().rstrip().endswith("</html>"), "report.html is missing or cut off")
    known = {folder / "summary.json", stored, report, *collections, *parts}
    others = [path.name for path in folder.rglob("*") if path.is_file() and path not in known]
    expect(not others, f"unknown files, unfinished perhaps: {others}")
    return found


def main():
    folder = pathlib.Path(sys.argv[1])
    found = problems(folder)
    for sentence in found:
        print(f"{folder}: {sentence}", file=sys.stderr)
    if not found:
        print(f"{folder}: the results are whole and sane")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

"""scripts/scaling: its tables, with a program that only says how long it took."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import scaling  # noqa: E402

# Takes 8 s for a study of 27 unknowns, divided by ranks and threads; knows no more than two ranks.
PROGRAM = """#!/usr/bin/env python3
import json, os, pathlib, sys
if sys.argv[1] == "--version":
    sys.exit(print("isopatch 1.2.3"))
ranks, threads = int(os.environ.get("RANKS", 1)), int(os.environ["OMP_NUM_THREADS"])
if ranks > 2:
    sys.exit("isopatch: error: too many ranks")
settings = dict(word.split("=") for word in sys.argv if "=" in word)
dofs = int(settings["discretization.elements_per_direction"]) ** 3
seconds = 8 * dofs / 27 / ranks / threads
pathlib.Path(sys.argv[sys.argv.index("--output") + 1], "summary.json").write_text(json.dumps({
    "discretization": {"dofs_free": dofs}, "timings": {"assembly": seconds, "total": seconds},
    "solver": {"method": "cg", "iterations": 9}, "memory": {"peak_bytes": 10 ** 8}}))
"""


class Scaling(unittest.TestCase):
    def run_script(self, layouts):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "isopatch"
            program.write_text(PROGRAM)
            program.chmod(0o755)
            output = pathlib.Path(folder) / "results"
            done = subprocess.run(
                [sys.executable, SCRIPTS / "scaling", "--program", program, "--launcher", "env RANKS={ranks}",
                 "--layouts", layouts, "--elements", "3", "--repetitions", "1", "--output", output],
                capture_output=True, text=True)
            found = json.loads((output / "scaling.json").read_text()) if output.is_dir() else None
            self.assertEqual(sorted(path.name for path in output.iterdir()) if found else [],
                             ["scaling.json", "scaling.md"] if found else [])
            return done, found

    def test_perfect_scaling_is_seen_as_such(self):
        done, found = self.run_script("1x1,2x1,1x2")
        self.assertEqual(done.returncode, 0, done.stderr)
        for kind in ("strong", "weak"):
            self.assertEqual([(e["ranks"], e["threads"]) for e in found[kind]], [(1, 1), (2, 1), (1, 2)])
            for entry, gain in zip(found[kind], scaling.ratios(found[kind])):
                workers = entry["ranks"] * entry["threads"]
                self.assertAlmostEqual(gain["assembly"]["speed_up"], workers)
                self.assertAlmostEqual(gain["assembly"]["efficiency"], 1.0)
        self.assertEqual([entry["phases"]["assembly"] for entry in found["strong"]], [8.0, 4.0, 4.0])
        self.assertGreater(found["weak"][1]["dofs"], found["strong"][1]["dofs"])
        self.assertIn("4 (2.00, 100 %)", done.stdout)

    def test_what_fails_is_named_and_the_rest_measured(self):
        done, found = self.run_script("1x1,4x1,1x2")
        self.assertEqual(done.returncode, 1)
        self.assertIn("4 ranks x 1 threads: isopatch: error: too many ranks", done.stdout)
        self.assertIn("4 (2.00, 100 %)", done.stdout)
        self.assertEqual([bool(entry["failure"]) for entry in found["strong"]], [False, True, False])

    def test_a_wrong_layout_is_refused(self):
        done, _ = self.run_script("2y2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("'2y2' is no layout: RANKSxTHREADS", done.stderr)

    def test_layouts_are_powers_of_two(self):
        self.assertEqual(scaling.default_layouts(6), [(1, 1), (1, 2), (1, 4), (2, 1), (4, 1)])
        self.assertEqual(scaling.default_layouts(1), [(1, 1)])

    def test_weak_scaling_keeps_the_unknowns_of_each_worker(self):
        for workers in (1, 2, 8, 64):
            share = ((scaling.elements_for(12, workers, 3) + 3) / 15) ** 3 / workers
            self.assertAlmostEqual(share, 1.0, delta=0.1)  # whole numbers of elements allow no better


if __name__ == "__main__":
    unittest.main()

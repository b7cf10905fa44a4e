"""scripts/scaling: its tables, with a program that only says how long it took."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import runs, scaling  # noqa: E402

# Takes 8 s for a study of 27 unknowns, divided by ranks and threads; knows no more than two ranks.
PROGRAM = """#!/usr/bin/env python3
import json, os, pathlib, sys
if sys.argv[1] == "--version":
    sys.exit(print("isopatch 1.2.3"))
ranks, threads = int(os.environ.get("RANKS", 1)), int(os.environ["OMP_NUM_THREADS"])
if ranks > 8:
    import subprocess, time
    subprocess.Popen(["sleep", "600"])  # a rank of its own
    pathlib.Path(os.environ["ALIVE"]).write_text(str(os.getpid()))
    print("no end in sight", file=sys.stderr, flush=True)
    time.sleep(600)
if ranks > 2:
    print("isopatch: error: too many ranks", file=sys.stderr)
    print("-" * 50, "Primary job  terminated normally, but 1 process returned", "a non-zero exit code.", sep="\\n", file=sys.stderr)
    sys.exit("srun: error: host: task 3: Exited with exit code 1")
settings = dict(word.split("=") for word in sys.argv if "=" in word)
dofs = int(settings["discretization.elements_per_direction"]) ** 3
seconds = 8 * dofs / 27 / ranks / threads
pathlib.Path(sys.argv[sys.argv.index("--output") + 1], "summary.json").write_text(json.dumps({
    "discretization": {"dofs_free": dofs}, "timings": {"assembly": seconds, "total": seconds},
    "solver": {"method": "cg", "iterations": 9}, "memory": {"peak_bytes": 10 ** 8}}))
"""


class Scaling(unittest.TestCase):
    def run_script(self, layouts, timeout=3600):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "isopatch"
            program.write_text(PROGRAM)
            program.chmod(0o755)
            output = pathlib.Path(folder) / "results"
            done = subprocess.run(
                [sys.executable, SCRIPTS / "scaling", "--program", program, "--launcher", "env RANKS={ranks}",
                 "--layouts", layouts, "--elements", "3", "--repetitions", "1", "--timeout", str(timeout),
                 "--output", output],
                capture_output=True, text=True, env=dict(os.environ, ALIVE=str(pathlib.Path(folder) / "alive")))
            self.alive = (pathlib.Path(folder) / "alive").read_text() if (pathlib.Path(folder) / "alive").exists() else ""
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
        self.assertIn("task 3: Exited with exit code 1", found["strong"][1]["said"], "all of it")

    def test_the_cause_is_not_what_launchers_say_of_it(self):
        self.assertEqual(runs.cause("a warning\nisopatch: error: no\nsrun: error: vm: task 0: Exited with exit code 1"),
                         "isopatch: error: no")
        self.assertEqual(runs.cause("-----\nThe application appears to have been direct launched\n-----\n"
                                    "srun: error: vm: task 0: Exited with exit code 1"),
                         "The application appears to have been direct launched")
        self.assertEqual(runs.cause("srun: error: Unable to create step"), "srun: error: Unable to create step")

    def test_what_takes_too_long_is_ended_with_its_ranks(self):
        done, found = self.run_script("1x1,9x1,1x2", timeout=2)
        self.assertEqual(done.returncode, 1)
        self.assertIn("not done after 2 s", found["strong"][1]["failure"])
        self.assertIn("no end in sight", found["strong"][1]["said"])
        for _ in range(50):  # the system takes its time on a busy machine
            left = subprocess.run(["ps", "-o", "pid=", "-s", self.alive], capture_output=True, text=True).stdout
            if not left.split():
                break
            time.sleep(0.2)
        self.assertEqual(left.split(), [], "processes of its session")
        self.assertEqual(found["strong"][2]["failure"], "")

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

#!/usr/bin/python3
"""The program as several processes: the figures, files, messages and exit codes of one.

  processes_test.py [-k NAME]     with ISOPATCH_PROGRAM, ISOPATCH_MPIEXEC and ISOPATCH_SOURCE_DIR in the environment
"""

import json
import math
import os
import pathlib
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["ISOPATCH_PROGRAM"]
SOURCE = pathlib.Path(os.environ["ISOPATCH_SOURCE_DIR"])
DATA = pathlib.Path(os.environ.get("ISOPATCH_DATA", SOURCE.parent / "shared" / "data"))
SAME = 1e-10  # relative; a vector's differences count beside its length

STRETCHED = """
[model]
generate = "box"
patches = [3, 1, 1]
[discretization]
degree = 2
refine = 1
elements_per_direction = [1, 1, 3]
[[material]]
young = 2e11
poisson = 0
[[support]]
faces = ["x_min"]
roller = true
[[support]]
faces = ["y_min"]
roller = true
[[support]]
faces = ["z_min"]
roller = true
[[load]]
faces = ["x_max"]
traction = [1e6, 0, 0]
"""

ONE_PATCH = """
[model]
generate = "box"
size = [1, 1, 3]
[discretization]
degree = 2
refine = 2
[[material]]
young = 1000
poisson = 0.3
[[support]]
name = "foot"
faces = ["z_min"]
displacement = [0, 0, 0]
[[support]]
name = "head"
faces = ["z_max"]
displacement = [0.01, 0, -0.02]
[[load]]
faces = ["x_max"]
traction = [1, 2, 3]
[[probe]]
name = "middle"
point = [0.5, 0.5, 1.5]
"""


def mpiexec(count):
    return [os.environ["ISOPATCH_MPIEXEC"], "--oversubscribe", "-n", str(count)] if count > 1 else []


def distance(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)))


class Processes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="isopatch-processes-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.environment = dict(os.environ, ISOPATCH_DATA=str(DATA))

    def start(self, count, *arguments, timeout=300):
        return subprocess.run([*mpiexec(count), PROGRAM, *map(str, arguments)], cwd=self.folder, text=True,
                              env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=timeout)

    def study(self, text=ONE_PATCH):
        path = self.folder / "study.toml"
        path.write_text(text)
        return path

    def summary(self, count, study, settings):
        output = self.folder / f"results_{count}"
        run = self.start(count, "run", study, "--quiet", "--output", output, "--set", "output.fields=false",
                         *(word for setting in settings for word in ("--set", setting)))
        self.assertEqual(run.returncode, 0, run.stderr)
        found = json.loads((output / "summary.json").read_text())
        self.assertEqual(found["parallel"]["processes"], count)
        return found

    def expect_vectors(self, pairs, what, least=0):
        scale = max(least, *(math.hypot(*a) for a, _ in pairs))
        for a, b in pairs:
            self.assertLessEqual(distance(a, b), SAME * scale, what)

    # Where reactions balance within a support, what is left of them counts beside stress times surface.
    def expect_same_figures(self, study, *settings, counts=(2, 3), balanced=False):
        one = self.summary(1, study, settings)
        for count in counts:
            with self.subTest(processes=count):
                several = self.summary(count, study, settings)
                self.assertEqual(one["discretization"], several["discretization"])
                a, b = one["results"], several["results"]
                for name in ("internal_energy", "external_work", "max_displacement", "max_von_mises"):
                    self.assertLessEqual(abs(a[name] - b[name]), SAME * abs(a[name]), name)
                force = a["max_von_mises"] * one["model"]["boundary_area"] if balanced else 0
                for name in ("force", "moment"):
                    self.expect_vectors([(x[name], y[name]) for x, y in zip(a["reactions"], b["reactions"])], name,
                                        least=force)
                for name in ("displacement", "stress"):
                    pairs = [(x[name], y[name]) for x, y in zip(one["probes"], several["probes"])]
                    if pairs:
                        self.expect_vectors(pairs, name)

    def test_one_patch_cut_into_parts(self):
        self.expect_same_figures(self.study())

    def test_fewer_elements_than_processes(self):
        self.expect_same_figures(self.study(), "discretization.refine=0")

    def test_link_by_elimination(self):
        self.expect_same_figures(SOURCE / "examples/link/study.toml", "discretization.refine=0")

    def test_link_by_multipliers(self):
        self.expect_same_figures(SOURCE / "examples/link/study.toml", "discretization.refine=0",
                                 "coupling.method='lagrange'")

    # Iterations stop far below the difference that is allowed.
    def test_link_by_minimal_residuals(self):
        self.expect_same_figures(SOURCE / "examples/link/study.toml", "coupling.method='lagrange'",
                                 "solver.method='minres'", "solver.tolerance=3e-11")

    def test_one_patch_by_minimal_residuals(self):
        self.expect_same_figures(self.study(ONE_PATCH.replace("refine = 2", "refine = 3")), "discretization.degree=3",
                                 "coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=3e-11")

    def test_thick_cylinder_by_elimination(self):
        self.expect_same_figures(SOURCE / "examples/thick_cylinder/study.toml", "discretization.degree=3",
                                 "discretization.refine=1")

    def test_thick_cylinder_by_multipliers(self):
        self.expect_same_figures(SOURCE / "examples/thick_cylinder/study.toml", "discretization.degree=3",
                                 "discretization.refine=1", "coupling.method='lagrange'")

    def test_patch_test_with_prescribed_displacements(self):
        self.expect_same_figures(SOURCE / "examples/patch_test/study.toml", "discretization.degree=2",
                                 "discretization.refine=1", "coupling.method='lagrange'", balanced=True)

    def test_equal_maxima_are_found_in_one_place(self):
        # Stretched evenly: the stress is the same everywhere, and the largest displacement all over one face.
        for text in (STRETCHED, STRETCHED.replace("patches = [3, 1, 1]", "patches = [1, 1, 3]")):
            study = self.study(text)
            for settings in ((), ("coupling.method=lagrange",)):
                one = self.summary(1, study, settings)["results"]
                self.assertLess(abs(one["max_von_mises"] - 1e6), 1, "an even stress")
                for count in (2, 3):
                    several = self.summary(count, study, settings)["results"]
                    for name in ("max_displacement_at", "max_von_mises_at"):
                        self.assertEqual(one[name], several[name], f"{name} with {count} processes {settings}")

    def test_terrific(self):
        if not (DATA / "terrific" / "terrific.xml").exists():
            self.skipTest(f"{DATA / 'terrific' / 'terrific.xml'} is not there")
        self.expect_same_figures(SOURCE / "examples/terrific/study.toml", "discretization.degree=2", counts=(2,))

    def test_compare(self):
        run = self.start(2, "compare", SOURCE / "examples/link/study.toml", "--output", self.folder, "--set",
                         "discretization.refine=0")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.count("the two couplings agree"), 1)
        self.assertTrue(json.loads((self.folder / "compare.json").read_text())["agree"])

    def test_one_process_speaks_and_writes(self):
        run = self.start(3, "run", self.study())
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.count("internal energy"), 1)
        self.assertIn("in 3 processes", run.stdout)
        self.assertEqual(run.stderr.count("isopatch: assembly"), 1)
        self.assertEqual({path.name for path in (self.folder / "results").iterdir()},
                         {"summary.json", "results.h5", "results.vtm", "results_boundaries.vtm", "results_exact.vtm",
                          "report.html", "fields"})

    def expect_failure(self, code, message, *arguments, counts=(2, 3)):
        for count in counts:
            with self.subTest(processes=count):
                run = self.start(count, *arguments)
                self.assertEqual(run.returncode, code, run.stderr)
                self.assertEqual(run.stderr.count("isopatch: error"), 1, run.stderr)
                self.assertIn(message, run.stderr)

    def test_wrong_input_is_said_once(self):
        self.expect_failure(2, "unknown key", "run", self.study(ONE_PATCH.replace("poisson", "poison")))
        self.expect_failure(2, "unknown command", "rnu", "study.toml", counts=(2,))
        self.expect_failure(3, "absent.toml", "run", "absent.toml", counts=(2,))

    def test_a_method_of_one_process_is_refused_once(self):
        self.expect_failure(2, "works on one process", "run", self.study(), "--set", "solver.method='cholmod'")

    def test_modes_of_several_processes_are_refused_once(self):
        self.expect_failure(2, "on one process", "modes", self.study())

    def test_a_loose_part_is_said_once(self):
        loose = self.study(ONE_PATCH.replace("displacement = [0, 0, 0]", "roller = true")
                           .replace("displacement = [0.01, 0, -0.02]", "roller = true"))
        self.expect_failure(1, "rigid motions", "run", loose)

    def test_a_failure_of_the_first_process_alone_ends_all(self):
        (self.folder / "taken").write_text("a file where the folder should be")
        started = time.monotonic()
        self.expect_failure(3, "there is a file of that name", "run", self.study(), "--output", self.folder / "taken")
        self.assertLess(time.monotonic() - started, 30)

    def test_a_failure_of_another_process_alone_ends_all(self):
        study = self.study()
        line = [*mpiexec(2)[:-1], "1", PROGRAM, "run", study, ":",
                "-n", "1", PROGRAM, "run", study, "--set", "titel=''"]
        run = subprocess.run(line, cwd=self.folder, text=True, env=self.environment, stdin=subprocess.DEVNULL,
                             capture_output=True, timeout=300)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertEqual(run.stderr.count("isopatch: error"), 1, run.stderr)
        self.assertIn("unknown key 'titel'", run.stderr)

    def test_an_interrupt_ends_all(self):
        study = self.study(ONE_PATCH.replace("refine = 2", "refine = 4"))
        # Factors take long enough to be interrupted.
        process = subprocess.Popen([*mpiexec(2), PROGRAM, "run", study, "--set", "solver.method='mumps'"],
                                   cwd=self.folder, text=True,
                                   env=self.environment, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        for line in process.stderr:
            if "assembly" in line or "factorization" in line:
                break
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=20)
        self.assertNotEqual(process.returncode, 0)
        self.assertFalse((self.folder / "results/summary.json").exists())
        left = subprocess.run(["pgrep", "-f", str(study)], text=True, capture_output=True).stdout
        self.assertEqual(left, "")

    def test_other_commands_answer_once(self):
        run = self.start(2, "info", self.study())
        self.assertEqual((run.returncode, run.stdout.count("1 patch")), (0, 1), run.stdout)
        run = self.start(2, "--version")
        self.assertEqual((run.returncode, run.stdout.count("isopatch")), (0, 1), run.stdout)

    # MUMPS starts MPI for one process, too.
    def solve_in(self, command, *more):
        line = f"'{PROGRAM}' run '{self.study()}' --quiet --set solver.method=mumps --output '{self.folder}'/"
        run = subprocess.run([*more, "sh", "-c", command.replace("RUN ", line)], cwd=self.folder, text=True,
                             env=self.environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=300)
        self.assertEqual(run.returncode, 0, run.stderr)
        for name in ("one", "two"):
            self.assertEqual(json.loads((self.folder / name / "summary.json").read_text())["solver"]["method"], "mumps")

    def test_one_process_of_a_launcher_runs_as_often_as_one_likes(self):
        self.solve_in("RUN one && RUN two", os.environ["ISOPATCH_MPIEXEC"], "-n", "1")

    def test_one_process_of_a_launcher_runs_twice_at_once(self):
        self.solve_in("RUN one & first=$!; RUN two && wait $first", os.environ["ISOPATCH_MPIEXEC"], "-n", "1")

    def test_one_process_runs_in_a_shell_of_slurm(self):
        self.environment.update(SLURM_NTASKS="1", SLURM_PROCID="0", SLURM_JOB_ID="1", SLURM_JOBID="1", SLURM_STEPID="0",
                                SLURM_STEP_ID="0", SLURM_NODELIST="here", SLURM_STEP_NUM_TASKS="1", SLURM_LOCALID="0")
        self.solve_in("RUN one && RUN two")
        # As the second program of a step with PMIx finds it.
        self.environment.update(PMIX_NAMESPACE="slurm.pmix.1.0", PMIX_RANK="0", PMIX_SERVER_URI4="gone;tcp4://127.0.0.1:9")
        self.solve_in("RUN one && RUN two")

    def test_threads_of_all_processes_are_counted(self):
        run = self.start(2, "run", self.study(), "--quiet", "--threads", str(os.cpu_count()))
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stderr.count("isopatch: warning: 2 processes with"), 1, run.stderr)
        self.assertIn("use --threads", run.stderr)

    def test_a_batch_script_of_slurm_is_no_launcher(self):
        self.environment.update(SLURM_NTASKS="4", SLURM_PROCID="0", SLURM_JOB_ID="1")
        self.summary(1, self.study(), [])


if __name__ == "__main__":
    unittest.main()

"""scripts/bench: what it makes of measurements, without measuring anything."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import finite_elements, growth, kernels, load_cases, machine, peers, records, runs, tables  # noqa: E402


def benchmark(name, cpu_ms, real_ms, **counters):
    return {"run_name": name, "name": name, "run_type": "iteration", "cpu_time": cpu_ms, "real_time": real_ms,
            "time_unit": "ms", "threads": 1, **counters}


def limits_of_two():
    """One core with 10 Gflop/s and 8 GB/s, two with 20 Gflop/s and 10 GB/s."""
    return [benchmark("dgemm/threads:1", 200, 250, omp_threads=1, flops=2e9),
            benchmark("dgemm/threads:2", 150, 200, omp_threads=2, flops=4e9),
            benchmark("triad/threads:1", 100, 100, omp_threads=1, bytes=0.7e9),
            benchmark("triad/threads:2", 100, 100, omp_threads=2, bytes=1e9),
            benchmark("read/threads:1", 100, 100, omp_threads=1, bytes=0.8e9),
            benchmark("read/threads:2", 100, 100, omp_threads=2, bytes=0.9e9)]


def of_patch(kernel, threads, cpu_ms, real_ms, p=3, nbytes=0.08e9):
    return benchmark(f"{kernel}/p:{p}/threads:{threads}", cpu_ms, real_ms, omp_threads=threads, p=p, spans=16,
                     rational=0, dofs=20000, elements=4096, bytes=nbytes)


def figures(*benchmarks):
    entries = kernels.fastest({"benchmarks": limits_of_two() + list(benchmarks)})
    return {(e["kernel"], e["threads"]): e for e in kernels.figures(entries)}


class LoadCases(unittest.TestCase):
    def test_cases_stand_in_place_of_the_loads(self):
        text = load_cases.study_text((SCRIPTS.parent / "examples" / "link" / "study.toml").read_text(encoding="utf-8"), 10)
        self.assertEqual(text.count("[[load]]"), 10)
        names = set(re.findall(r'case = "(.*)"', text))
        self.assertEqual(len(names), 10)
        for name in names:
            self.assertRegex(name, r"^[A-Za-z0-9_-]+$")  # folders are named so
        self.assertNotIn("10 kN", text)
        self.assertIn("[[probe]]", text)

    def test_the_ratio_is_that_of_the_whole_runs(self):
        def of(seconds):
            return {"wall_seconds": seconds, "phases": {}, "dofs": 1000}
        entries = [{"method": "cg", "files": True, "failure": "", "1": of(2.0), "10": of(5.0)},
                   {"method": "cholmod", "files": False, "failure": "not done after 1 s"}]
        self.assertEqual(load_cases.ratio(entries[0]), 2.5)
        said = "\n".join(load_cases.report(entries))
        self.assertRegex(said, r"cg, all files +\| +2 +\| +5 +\| +2.5 ")
        self.assertIn("not done after 1 s", said)


class Kernels(unittest.TestCase):
    def test_the_least_of_the_repetitions_counts(self):
        found = figures(of_patch("formation", 1, 900, 950), of_patch("formation", 1, 790, 2000))
        self.assertAlmostEqual(found["formation", 1]["seconds"], 0.79)
        self.assertAlmostEqual(found["formation", 1]["us_per_dof"], 39.5)

    def test_formation_is_held_against_dgemm(self):
        # 790 kflop/DOF x 20,000 DOFs at 10 Gflop/s take 1.58 s; 4096 elements of 9 * 4^9 flops 0.966 s.
        reached = figures(of_patch("formation", 1, 790, 800))["formation", 1]
        self.assertAlmostEqual(reached["r"], 0.5)
        self.assertAlmostEqual(reached["r_by_elements"], 0.79 / (4096 * 9 * 4 ** 9 / 1e10))
        self.assertTrue(reached["reached"])
        self.assertFalse(figures(of_patch("formation", 1, 1600, 1600))["formation", 1]["reached"])

    def test_two_threads_count_by_the_clock(self):
        found = figures(of_patch("formation", 1, 800, 900), of_patch("formation", 2, 300, 440))["formation", 2]
        self.assertAlmostEqual(found["speed_up"], 800 / 440)
        self.assertTrue(found["reached"])
        self.assertFalse(figures(of_patch("formation", 1, 800, 900),
                                 of_patch("formation", 2, 300, 450))["formation", 2]["reached"])

    def test_products_are_held_against_the_memory_of_as_many_threads(self):
        found = figures(of_patch("product", 1, 20, 20), of_patch("product", 2, 16, 16))
        self.assertAlmostEqual(found["product", 1]["to_memory"], 2.0)  # 0.08 GB at 8 GB/s take 10 ms
        self.assertAlmostEqual(found["product", 2]["to_memory"], 2.0)  # at 10 GB/s 8 ms

    def test_a_product_without_a_matrix_is_held_against_the_one_with_it(self):
        found = figures(of_patch("product", 1, 20, 20), of_patch("apply", 1, 30.4, 31, nbytes=2.4e6))["apply", 1]
        self.assertAlmostEqual(found["to_product"], 1.52)
        self.assertAlmostEqual(found["gflops"], 5.0)  # 7.6 kflop/DOF
        self.assertAlmostEqual(found["to_dgemm"], 2.0)

    def test_a_failed_benchmark_is_an_error(self):
        with self.assertRaisesRegex(RuntimeError, "out of memory"):
            figures({**of_patch("product", 1, 1, 1), "error_occurred": True, "error_message": "out of memory"})

    def test_the_report_marks_goals(self):
        entries = kernels.fastest({"benchmarks": limits_of_two() + [
            of_patch("formation", 1, 1600, 1600), of_patch("formation", 2, 440, 440)]})
        text = "\n".join(kernels.report(entries))
        self.assertIn("R <= 1: MISSED", text)
        self.assertIn("speed-up >= 1.8: reached", text)


def run_of(dofs, elements, direct=True, **phases):
    return {"failure": "", "elements_per_direction": 4, "threads": 1, "dofs": dofs, "elements": elements, "degree": [3],
            "phases": {name.replace("_", " "): seconds for name, seconds in phases.items()}, "wall_seconds": 9.0,
            "method": "cholmod" if direct else "cg", "direct": direct, "iterations": 1, "peak_bytes": 10 ** 9}


class Growth(unittest.TestCase):
    def test_exponents_follow_from_two_sizes(self):
        found = growth.exponents([run_of(10_000, 10_000, assembly=1.0, results=0.001),
                                  run_of(100_000, 100_000, assembly=10 ** 1.5, results=0.09)])[0]["phases"]
        self.assertAlmostEqual(found["assembly"]["exponent"], 1.5)
        self.assertFalse(found["assembly"]["within"])
        self.assertNotIn("results", found)  # too short to say

    def test_what_grows_with_the_elements_is_within_the_bound(self):
        found = growth.exponents([
            {**run_of(n, elements), "phases": {"assembly": seconds, "solve: analysis": seconds}}
            for n, elements, seconds in ((10_000, 1_000, 1.0), (100_000, 30_000, 30.0))])
        self.assertGreater(found[0]["phases"]["assembly"]["exponent"], growth.BOUND)
        self.assertAlmostEqual(found[0]["phases"]["assembly"]["by_elements"], 1.0)
        self.assertTrue(found[0]["phases"]["assembly"]["within"])
        self.assertFalse(found[0]["phases"]["solve: analysis"]["within"])  # knows no elements

    def test_only_a_direct_factorization_has_no_bound(self):
        sizes = [(10_000, 0.5), (100_000, 50.0)]
        for direct, within in ((True, None), (False, False)):
            entries = [{**run_of(n, n, direct), "phases": {"solve: factorization": t}} for n, t in sizes]
            found = growth.exponents(entries)[0]["phases"]["solve: factorization"]
            self.assertIs(found["within"], within)

    def test_two_methods_have_no_exponent_in_common(self):
        entries = [{**run_of(n, n, direct), "phases": {"solve: solve": t, "assembly": t}}
                   for n, direct, t in ((10_000, True, 0.1), (100_000, False, 9.0))]
        self.assertEqual(list(growth.exponents(entries)[0]["phases"]), ["assembly"])

    def test_a_size_that_failed_is_named_and_left_out(self):
        entries = [run_of(10_000, 1_000, assembly=1.0), {"elements_per_direction": 29, "failure": "out of memory"}]
        self.assertEqual(growth.exponents(entries), [])
        self.assertIn("29 elements per direction and patch: not measured: out of memory",
                      growth.report(entries))

    def test_the_parts_of_solving_take_its_place(self):
        summary = {"timings": {"assembly": 1.0, "solve": 5.0, "total": 6.0},
                   "solver": {"analysis_seconds": 1.0, "factorization_seconds": 2.5, "solve_seconds": 0.5}}
        self.assertEqual(runs.phases(runs.Run(summary, 7.0, "")), {
            "assembly": 1.0, "solve: analysis": 1.0, "solve: factorization": 2.5, "solve: solve": 0.5,
            "solve: rest": 1.0, "start and files": 1.0})


def record(speed, slowdown=1.0):
    """A record of a machine `speed` times as fast as another, of code `slowdown` times as slow."""
    factor = slowdown / speed
    return {
        "schema_version": records.SCHEMA, "version": "1.2.3", "commit": "abc", "date": "2026-01-02T03:04:05",
        "machine": {"cpu": "Some(R) Core(TM) CPU 9 @ 3.00GHz", "cores": 2},
        "limits": [{"threads": 1, "dgemm_gflops": 10 * speed, "triad_gbs": 8 * speed, "read_gbs": 7 * speed}],
        "kernels": [{"kernel": kernel, "p": 3, "spans": 16, "rational": 0, "threads": 1, "seconds": factor}
                    for kernel in ("formation", "product")],
        "runs": [{**run_of(10_000, 1_000, assembly=factor, results=0.01), "wall_seconds": 9 * factor},
                 {"failure": "only with --full"}],
    }


class Records(unittest.TestCase):
    def compare(self, before, after, *options):
        with tempfile.TemporaryDirectory() as folder:
            names = [str(pathlib.Path(folder) / name) for name in ("before.json", "after.json")]
            for name, content in zip(names, (before, after)):
                pathlib.Path(name).write_text(content if isinstance(content, str) else json.dumps(content))
            return subprocess.run([sys.executable, SCRIPTS / "bench", "compare", *names, *options],
                                  capture_output=True, text=True)

    def test_a_machine_twice_as_fast_makes_no_difference(self):
        rows = records.compare(record(1.0), record(2.0))
        corrected = {row["what"]: row["corrected"] for row in rows}
        for what in ("formation, p = 3, 16^3, 1 threads", "product, p = 3, 16^3, 1 threads",
                     "link, 10,000 DOFs, assembly"):
            self.assertAlmostEqual(corrected[what], 1.0)
        self.assertNotIn("link, 10,000 DOFs, results", corrected)  # too short to say

    def test_slower_code_fails_whatever_the_machine(self):
        done = self.compare(record(1.0), record(2.0, slowdown=1.5), "--fail-above", "1.2")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("SLOWER", done.stdout)
        done = self.compare(record(1.0), record(2.0, slowdown=1.1), "--fail-above", "1.2")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(self.compare(record(1.0), record(2.0, slowdown=1.5)).returncode, 0)

    def test_what_is_no_record_is_named(self):
        for content, why in (("{", "no JSON"), ("[]", "not a record"), ({"schema_version": 99}, "not a record")):
            done = self.compare(record(1.0), content)
            self.assertEqual(done.returncode, 2)
            self.assertIn("after.json", done.stderr)
            self.assertIn(why, done.stderr)

    def test_records_are_named_by_version_and_machine(self):
        self.assertEqual(records.path_of("tree", record(1.0)).as_posix(),
                         "tree/verification/performance/records/1.2.3-some-core-9-3-00ghz-2-cores.json")


class FiniteElements(unittest.TestCase):
    LINK = finite_elements.link_of(SCRIPTS.parent / "examples" / "link" / "study.toml")

    def test_a_flat_triangle_carries_its_load_at_the_middles_of_its_sides(self):
        nodes = dict(enumerate([(0, 0, 0), (2, 0, 0), (0, 4, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0)]))
        loads = finite_elements.spread((6.0, -3.0, 0.0), [[0, 1, 2, 3, 4, 5]], nodes)
        for corner in (0, 1, 2):
            self.assertAlmostEqual(loads[corner][0], 0.0)
        for middle in (3, 4, 5):
            self.assertAlmostEqual(loads[middle][0], 2.0)
            self.assertAlmostEqual(loads[middle][1], -1.0)

    def test_a_curved_triangle_carries_the_whole_load(self):
        nodes = dict(enumerate([(0, 0, 0), (2, 0, 0), (0, 4, 0), (1, -0.3, 0.2), (1.1, 2.2, 0.4), (0, 2, 0.5)]))
        loads = finite_elements.spread((1.0, 0.0, 0.0), [[0, 1, 2, 3, 4, 5]], nodes)
        self.assertAlmostEqual(sum(force[0] for force in loads.values()), 1.0)

    def test_areas_are_those_of_the_curved_triangles(self):
        flat = dict(enumerate([(0, 0, 0), (2, 0, 0), (0, 4, 0), (1, 0, 0), (1, 2, 0), (0, 2, 0)]))
        self.assertAlmostEqual(finite_elements.area([[0, 1, 2, 3, 4, 5]], flat), 4.0)
        turn = math.pi / 4  # a sector, its arc a parabola: too small by 0.08 %, by a chord 10 %
        x, y = math.cos(turn), math.sin(turn)
        middle = (math.cos(turn / 2), math.sin(turn / 2), 0)
        sector = dict(enumerate([(0, 0, 0), (1, 0, 0), (x, y, 0), (0.5, 0, 0), middle, (x / 2, y / 2, 0)]))
        self.assertAlmostEqual(finite_elements.area([[0, 1, 2, 3, 4, 5]], sector) / (turn / 2), 1.0, delta=1e-3)

    def test_the_outline_is_closed_round_and_smooth(self):
        text = finite_elements.geometry(self.LINK, 5.0)
        points = {int(n): (float(x), float(y)) for n, x, y in re.findall(r"Point\((\d+)\) = \{(\S+), (\S+), 0,", text)}
        curves = [tuple(map(int, ends.split(", "))) for ends in re.findall(r"(?:Circle|Line)\(\d+\) = \{(.*)\}", text)]
        for start, center, end in (curve for curve in curves if len(curve) == 3):
            self.assertAlmostEqual(math.dist(points[start], points[center]), math.dist(points[end], points[center]))
        loops = [[curves[int(n) - 1] for n in loop.split(", ")] for loop in re.findall(r"Loop\(\d\) = \{(.*)\}", text)]
        self.assertEqual([len(loop) for loop in loops], [12, 4, 4])
        for loop in loops:
            for curve, following in zip(loop, loop[1:] + loop[:1]):
                self.assertEqual(curve[-1], following[0])
                # Tangents are perpendicular to the radius of an arc, so where two arcs meet their centres and the
                # point lie on one line.
                if len(curve) == len(following) == 3:
                    (x, y), a, b = points[curve[-1]], points[curve[1]], points[following[1]]
                    self.assertAlmostEqual((a[0] - x) * (b[1] - y) - (a[1] - y) * (b[0] - x), 0.0)

    def test_the_energy_is_half_the_work_of_the_loads(self):
        with tempfile.TemporaryDirectory() as folder:
            printed = pathlib.Path(folder) / "link.dat"
            printed.write_text("\n displacements (vx,vy,vz) for set LOADED and time  0.1000000E+01\n\n"
                               "         7  2.000000E-01 -1.000000E-01  0.000000E+00\n"
                               "        12  1.000000E-01  0.000000E+00  3.000000E-01\n")
            energy = finite_elements.energy(printed, {7: (1000.0, -500.0, 0.0), 12: (0.0, 0.0, 100.0)})
        self.assertAlmostEqual(energy, 0.5e-3 * (200 + 50 + 30))

    def test_meshes_are_refined_as_the_error_asks(self):
        meshes = [{"size_mm": 6.0, "error": 4e-3}, {"size_mm": 4.0, "error": 4e-3 * (2 / 3) ** 2}]
        self.assertAlmostEqual(finite_elements.order(*meshes), 2.0)
        size = peers.next_size(meshes, meshes[-1]["error"] / 2)
        self.assertAlmostEqual(size, 4.0 * math.sqrt(0.45))
        self.assertAlmostEqual(peers.next_size(meshes, 0.99 * meshes[-1]["error"]), 3.4)  # at least by 0.85
        self.assertAlmostEqual(peers.next_size(meshes, 1e-9), 2.0)                        # at most by 0.5


class Tables(unittest.TestCase):
    def test_figures(self):
        self.assertEqual([tables.figure(value) for value in (None, 12345, 12345.6, 0.012345, 1.5e-7)],
                         ["-", "12,345", "12,346", "0.0123", "1.50e-07"])

    def test_columns_are_aligned(self):
        self.assertEqual(tables.table(["a", "long"], [["bcd", "1"]]),
                         ["| a   | long |", "|-----|-----:|", "| bcd |    1 |"])

    def test_a_machine_has_a_name(self):
        self.assertEqual(machine.slug({"cpu": "Intel(R) Xeon(R) Processor @ 2.50GHz", "cores": 2}),
                         "intel-xeon-2-50ghz-2-cores")


if __name__ == "__main__":
    unittest.main()

"""scripts/bench --only pipeline: what it makes of runs and meshes, without either."""

import math
import pathlib
import subprocess
import sys
import tempfile
import tomllib
import unittest
import unittest.mock

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import bored_parts, finite_elements, pipeline, seconds  # noqa: E402
from measuring.seconds import Seconds  # noqa: E402


def entry(error, processor, clock=None, **others):
    return {"error": error, "dofs": 1000, "seconds": {"solve": Seconds(clock or 2 * processor, processor)}, **others}


def of_power(power, *errors):
    return [entry(error, error ** -power) for error in errors]


class SecondsOfPrograms(unittest.TestCase):
    def test_the_processor_of_a_program_is_counted(self):
        took = seconds.of_program(["sh", "-c", "i=0; while [ $i -lt 40000 ]; do i=$((i+1)); done"], ".", threads=1)
        self.assertGreater(took.processor, 0.005)
        idle = seconds.of_program(["sleep", "0.1"], ".", threads=1)
        self.assertGreater(idle.clock, 0.1)
        self.assertLess(idle.processor, 0.1)

    def test_a_program_that_fails_or_takes_too_long_is_an_error(self):
        with self.assertRaises(subprocess.CalledProcessError):
            seconds.of_program(["false"], ".", threads=1)
        with self.assertRaises(subprocess.TimeoutExpired):
            seconds.of_program(["sleep", "5"], ".", threads=1, timeout=0.05)

    def test_a_program_is_told_its_threads(self):
        seconds.of_program(["sh", "-c", "test $OMP_NUM_THREADS = 3"], ".", threads=3)


class AtAnError(unittest.TestCase):
    def test_between_two_runs_seconds_are_a_power_of_the_error(self):
        took, at_most = pipeline.at(1e-3, of_power(1.5, 4e-3, 5e-4))
        self.assertAlmostEqual(took.processor, 1e-3 ** -1.5)
        self.assertAlmostEqual(took.clock, 2 * 1e-3 ** -1.5)
        self.assertFalse(at_most)

    def test_a_first_run_that_is_nearer_is_at_most_what_it_takes(self):
        self.assertEqual(pipeline.at(5e-3, of_power(1.0, 4e-3, 5e-4)), (Seconds(500.0, 250.0), True))

    def test_what_no_run_reached_is_none(self):
        self.assertIsNone(pipeline.at(1e-4, of_power(1.0, 4e-3, 5e-4)))
        self.assertIsNone(pipeline.at(1e-4, []))


class Stages(unittest.TestCase):
    def test_what_a_whole_run_takes_longer_is_that_of_its_stages(self):
        whole = {"clock_of_stages": [1.0, 6.0, 3.0], "seconds": {"solve": Seconds(18.0, 20.0), "write": Seconds(4.0, 3.0)}}
        solution = {"seconds": {"solve": Seconds(1.0, 2.0), "write": Seconds(1.0, 1.0)}}
        before = pipeline.before_solving(whole, solution)
        self.assertEqual(before, {"read": Seconds(2.0, 2.0), "cut": Seconds(12.0, 12.0),
                                  "parameterize": Seconds(6.0, 6.0)})

    def test_repetitions_end_with_the_seconds_and_the_least_counts(self):
        cheap = iter([entry(0.1, 3.0), entry(0.1, 2.0), entry(0.1, 4.0), entry(0.1, 0.1)])
        self.assertEqual(pipeline.total(pipeline.repeated(lambda: next(cheap))).processor, 2.0)
        dear = iter([entry(0.1, 50.0), entry(0.1, 1.0)])
        self.assertEqual(pipeline.total(pipeline.repeated(lambda: next(dear))).processor, 50.0)


class Turns(unittest.TestCase):
    def test_both_sides_are_measured_in_turns(self):
        order = []

        def side(name, count):
            for number in range(count):
                order.append(name)
                yield entry(0.1, number + 1.0)

        found, failures = pipeline.in_turns({"ours": side("ours", 1), "theirs": side("theirs", 3)})
        self.assertEqual(order, ["ours", "theirs", "theirs", "theirs"])
        self.assertEqual([len(entries) for entries in found.values()], [1, 3])
        self.assertEqual(failures, {})

    def test_what_was_measured_before_a_failure_is_kept(self):
        def failing(error):
            yield entry(0.1, 1.0)
            raise error

        found, failures = pipeline.in_turns({
            "late": failing(subprocess.TimeoutExpired(["/usr/bin/ccx", "part"], 900)),
            "failed": failing(subprocess.CalledProcessError(201, ["gmsh"])),
            "refused": failing(RuntimeError("face 3 has 2 outlines"))})
        self.assertEqual([len(entries) for entries in found.values()], [1, 1, 1])
        self.assertEqual(failures, {"late": "ccx took more than 900 s", "failed": "gmsh failed with 201",
                                    "refused": "face 3 has 2 outlines"})


class Meshes(unittest.TestCase):
    def meshes(self, *entries):
        part, made = bored_parts.LINK, []
        with unittest.mock.patch.object(pipeline, "_mesh", side_effect=[*entries]) as mesh:
            try:
                for found in pipeline.by_finite_elements(part, pathlib.Path("link.step"), ".", {}):
                    made.append(found)
            finally:
                self.sizes = [call.args[2] for call in mesh.call_args_list]
        return made

    def test_sizes_fall_until_the_last_target_is_met(self):
        self.assertEqual(len(self.meshes(entry(1e-2, 20.0), entry(2e-3, 20.0), entry(9e-4, 20.0), entry(1e-4, 20.0))), 3)
        self.assertEqual(self.sizes, [9.0, 6.0, 4.0])

    def test_no_mesh_follows_one_that_took_long(self):
        with self.assertRaisesRegex(RuntimeError, "error 0.002 after 70 s"):
            self.meshes(entry(1e-2, 20.0), entry(2e-3, 70.0), entry(9e-4, 300.0))
        self.assertEqual(self.sizes, [9.0, 6.0])


class Report(unittest.TestCase):
    def found(self, ours, theirs, failures=None):
        return {"part": "link", "threads": 2, "reference_energy": 1.0, "failures": failures or {},
                "isopatch": [{**e, "elements_per_direction": 2, "patches": 10, "energy": 1 - e["error"],
                              "estimated_error": 0.9 * e["error"]} for e in ours],
                "finite_elements": [{**e, "size_mm": 8 / 2 ** i, "energy": 1 - e["error"]}
                                    for i, e in enumerate(theirs)]}

    def test_the_ratio_is_theirs_over_ours(self):
        text = "\n".join(pipeline.report(self.found([entry(8e-3, 2.0), entry(5e-4, 2.0)],
                                                    [entry(8e-3, 10.0), entry(5e-4, 10.0)])))
        self.assertIn("From the file, error 0.005: isopatch 2 s; gmsh + CalculiX 10 s; ratio 5 (clock 5).", text)

    def test_what_was_not_reached_is_said(self):
        text = "\n".join(pipeline.report(self.found([entry(4e-3, 2.0)], [entry(8e-3, 1.0)],
                                                    {"finite_elements": "ccx took more than 900 s"})))
        self.assertIn("From the file, error 0.005: isopatch at most 2 s; gmsh + CalculiX not reached.", text)
        self.assertIn("gmsh + CalculiX ended: ccx took more than 900 s.", text)

    def test_another_load_needs_neither_patches_nor_a_mesh(self):
        def side(*once):
            return [{**e, "seconds": {**e["seconds"], **{name: Seconds(90.0, 90.0) for name in once}}}
                    for e in (entry(8e-3, 2.0), entry(5e-4, 2.0))]

        text = "\n".join(pipeline.report(self.found(side("read", "cut", "parameterize"), side("mesh"))))
        self.assertIn("Another load, error 0.001: isopatch 2 s; gmsh + CalculiX 2 s; ratio 1 (clock 1).", text)
        self.assertIn("From the file, error 0.001: isopatch 272 s; gmsh + CalculiX 92 s; ratio 0.34 (clock 0.34).", text)

    def test_without_the_others_ours_is_reported(self):
        text = "\n".join(pipeline.report(self.found([entry(4e-3, 2.0)], [])))
        self.assertIn("isopatch, 10 patches, 2^3 elements or more", text)
        self.assertNotIn("ratio", text)

    def test_each_side_has_its_limit(self):
        # Errors that fall with the square of the size.
        theirs = [entry(e, 1.0) for e in (0.16, 0.04, 0.01)]
        limits = pipeline.limits(self.found([entry(0.1, 1.0)], theirs))
        self.assertAlmostEqual(limits["finite_elements"], 1.0)
        self.assertAlmostEqual(limits["isopatch"], 0.9 * 1.09)


class BoredParts(unittest.TestCase):
    def ring(self, radius, first, count=8):
        """Triangles around a cylinder about (5, 0), and their nodes; the middles of sides off the cylinder."""
        nodes, triangles = {}, []
        for i in range(count):
            angle = 2 * math.pi * i / count
            for j, z in enumerate((0.0, 1.0)):
                nodes[first + 2 * i + j] = (5 + radius * math.cos(angle), radius * math.sin(angle), z)
        for i in range(count):
            a, b, c = (first + (2 * i + j) % (2 * count) for j in range(3))
            nodes[first + 100 + i] = (5.0, 0.0, 0.5)
            triangles.append([a, b, c] + 3 * [first + 100 + i])
        return nodes, triangles

    def test_a_bore_may_be_several_surfaces_of_chords(self):
        nodes, triangles = self.ring(9.85, 1)
        wider, others = self.ring(10.5, 1000)
        mesh = finite_elements.Mesh({**nodes, **wider}, [], {4: triangles[:3], 7: triangles[3:], 9: others})
        self.assertEqual(bored_parts.on(bored_parts.Bore(5.0, 0.0, 10.0), mesh), triangles)

    def test_a_mesh_without_the_bore_is_an_error(self):
        nodes, triangles = self.ring(10.5, 1)
        with self.assertRaisesRegex(RuntimeError, r"bore of radius 10 mm at \(5, 0\) mm"):
            bored_parts.on(bored_parts.Bore(5.0, 0.0, 10.0), finite_elements.Mesh(nodes, [], {4: triangles}))

    def study(self, name):
        return tomllib.loads((SCRIPTS.parent / name).read_text(encoding="utf-8"))

    def value(self, text, unit):
        number, found = str(text).split() if text else ("0", unit)
        self.assertEqual(found, unit)
        return float(number)

    def test_the_link_is_that_of_its_study(self):
        study, link = self.study(bored_parts.LINK.study), finite_elements.link_of(
            SCRIPTS.parent / "examples" / "link" / "study.toml")
        self.assertEqual(tuple(1e3 * self.value(f, "kN") for f in study["load"][0]["force"]), bored_parts.LINK.force)
        self.assertEqual((link.force, link.young, link.poisson),
                         (bored_parts.LINK.force, bored_parts.LINK.young, bored_parts.LINK.poisson))
        self.assertEqual((bored_parts.LINK.held.radius, bored_parts.LINK.loaded.radius, bored_parts.LINK.loaded.x),
                         (link.left_bore_radius, link.right_bore_radius, link.distance))

    def test_the_demonstrator_is_that_of_its_studies(self):
        part = bored_parts.DEMONSTRATOR
        shear = part.young / (2 * (1 + part.poisson))
        first = 2 * shear * part.poisson / (1 - 2 * part.poisson)
        area = 2 * math.pi * part.loaded.radius * (2.5 + 27.437)  # from the bottom to the top of the part
        for name in (part.study, bored_parts.FROM_TRIANGLES.study):
            study = self.study(name)
            lame = study["material"][0]["lame"]
            self.assertAlmostEqual(1e3 * self.value(lame["lambda"], "GPa"), first)
            self.assertAlmostEqual(1e3 * self.value(lame["mu"], "GPa"), shear)
            for force, traction in zip(part.force, study["load"][0]["traction"]):
                self.assertAlmostEqual(force, self.value(traction, "MPa") * area)
        for bore, where in ((part.held, study["support"][0]), (part.loaded, study["load"][0])):
            cylinder = where["where"]["cylinder"]
            self.assertEqual([self.value(x, "mm") for x in cylinder["point"][:2]], [bore.x, bore.y])
            self.assertEqual(self.value(cylinder["radius"], "mm"), bore.radius)


if __name__ == "__main__":
    unittest.main()

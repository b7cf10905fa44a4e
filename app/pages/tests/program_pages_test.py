#!/usr/bin/python3
"""Pages that the program itself writes, in a real browser; ISOPATCH_PROGRAM in the environment names it."""

import json
import math
import os
import pathlib
import subprocess
import unittest

import browser
import fixture
from page_case import Pages, four_digits


@unittest.skipUnless(os.environ.get("ISOPATCH_PROGRAM"), "ISOPATCH_PROGRAM is not set")
class Program(Pages):
    """The pages of the program itself: the link's, by the run and by the comparison."""

    def page(self, command, name):
        source = pathlib.Path(os.environ.get("ISOPATCH_SOURCE_DIR", pathlib.Path(__file__).parents[3]))
        output = self.folder / command
        run = subprocess.run([os.environ["ISOPATCH_PROGRAM"], command, source / "examples/link/study.toml", "--output", output],
                             text=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        if not (output / name).exists():
            self.skipTest(f"this program writes no {name}")
        self.browser.open(output / name)
        self.expect_sound()
        self.expect_drawn()
        return output

    def test_report(self):
        output = self.page("run", "report.html")
        summary = json.loads((output / "summary.json").read_text())
        probe = summary["probes"][0]
        self.browser.run("[...document.querySelectorAll('button.place')].find((b) => b.textContent === arguments[0]).click()",
                         probe["name"])
        rows = self.browser.values()["rows"]
        self.assertEqual(rows["von Mises stress"], four_digits(probe["von_mises"], "Pa"))
        # Beside the marker the samples show nearly the same.
        x, y = self.browser.run("""const {project, places, change} = isopatch.viewer; change({markers: false, scale: 0});
            return project(places.find((place) => place.name === arguments[0]).point);""", probe["name"])
        self.browser.click(x, y)
        hit = self.browser.run("""const hit = isopatch.viewer.pickAt(...arguments[0]);
            return hit && [hit.place, hit.fields.displacement]""", [x, y])
        if hit and math.dist(hit[0], probe["point"]) < 1e-3:
            self.assertLess(math.dist(hit[1], probe["displacement"]), 0.05 * math.hypot(*probe["displacement"]))

    def test_faces_that_do_not_match(self):
        """A box with two on its top: how they hold together, and that the energies add up to the work."""
        def box(x0, x1, z0, z1):
            corners = [f"{x} {y} {z}" for z in (z0, z1) for y in (0, 1) for x in (x0, x1)]
            return "\n".join(["700 1 0 0", "3 0", *["2 2", "0 0 1 1"] * 3, *corners, ""])
        study = self.folder / "boxes.toml"
        (self.folder / "boxes.g2").write_text(box(0, 2, 0, 1) + box(0, 0.7, 1, 2) + box(0.7, 1.5, 1, 2))
        study.write_text('''model.file = "boxes.g2"
material = [{ name = "steel" }]
support = [{ faces = ["0:front"], displacement = [0, 0, 0] }]
load = [{ faces = ["1:back", "2:back"], pressure = "1 MPa" }]''')
        output = self.folder / "boxes"
        for way, said in (("nitsche", "coupled by elimination and Nitsche's method"),
                          ("mortar", "coupled by elimination and mortar multipliers")):
            run = subprocess.run([os.environ["ISOPATCH_PROGRAM"], "run", study, "--set", f"coupling.non_matching={way}", "-o", output],
                                 text=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=60)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.browser.open(output / "report.html")
            self.expect_sound()
            text = self.browser.run("return document.body.innerText")
            results = json.loads((output / "summary.json").read_text())["results"]
            for expected in (said, "3, 1 interface, 2 that do not match", "0:back and 1:front, 0:back and 2:front"):
                self.assertIn(expected, text)
            # Rounding, beside what is between the faces.
            self.assertAlmostEqual(results["internal_energy"] + results["interface_energy"], results["external_work"],
                                   delta=1e-9 * results["external_work"])
            self.assertEqual("energy of Nitsche's method between faces" in text, way == "nitsche")
            if way == "nitsche":
                self.assertGreater(abs(results["interface_energy"]), 1e-6 * results["external_work"])
                sign = "-" if results["interface_energy"] < 0 else ""
                between = sign + four_digits(abs(results["interface_energy"]), "J")
                self.assertIn(between, text)
                self.assertIn(f"with {between} of Nitsche's method between faces: the work is", run.stdout)
        rows = self.browser.run("return [...document.querySelectorAll('#mortar tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))")
        ties = results["mortar"]
        self.assertEqual([row[:4] for row in rows], [[tie["face"], ", ".join(tie["covered_by"]), tie["reason"], str(tie["multipliers"])] for tie in ties])
        self.assertEqual(len(rows), 2)
        for row, tie in zip(rows, ties):
            self.assertIn(f'{tie["force"][2] / 1e3:.4g}) kN', row[4])

    def test_segment(self):
        """A prism over an L, cut in two."""
        outline = [(0, 0), (20, 0), (20, 10), (10, 10), (10, 20), (0, 20)]
        corners = [f"{x} {y} {z}" for z in (0, 10) for x, y in outline]
        sides = [f"4 {i} {(i + 1) % 6} {6 + (i + 1) % 6} {6 + i}" for i in range(6)]
        solid, output = self.folder / "l.off", self.folder / "blocks"
        solid.write_text("\n".join(["OFF", "12 8 0", *corners, "6 5 4 3 2 1 0", "6 6 7 8 9 10 11", *sides]))
        command = [os.environ["ISOPATCH_PROGRAM"], "segment", solid, "-o", output, "--length-unit", "mm"]
        run = subprocess.run(command, text=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=60)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.browser.open(output / "report.html")
        self.expect_sound()
        self.assertGreater(self.browser.pixels()["drawn"], 0.1)  # of few colours: plane faces
        table = "return [...document.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))"
        self.assertEqual(self.browser.run(table)[0][:8], ["l", "3 cm^3", "0", "swept", "0", "", "2", "below 1e-12"])
        self.assertIn("l: swept along z", self.browser.run("return document.getElementById('remarks').textContent"))
        command += ["--method", "cuts"]
        self.assertEqual(subprocess.run(command, capture_output=True, stdin=subprocess.DEVNULL, timeout=60).returncode, 0)
        self.browser.open(output / "report.html")
        self.expect_sound()
        rows = self.browser.run(table)
        self.assertEqual(rows[0][:8], ["l", "3 cm^3", "1", "2", "0", "", "2", "below 1e-12"])
        self.assertEqual([row[:2] for row in rows[1:]], [["l", "block_0.step"], ["l#1", "block_1.step"]])
        # Without time there is one part, red, with its concave edge.
        run = subprocess.run([*command, "--time-limit", "1e-9"], text=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=60)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn(str(output / "failure.html"), run.stderr)
        self.assertFalse((output / "report.html").exists())
        self.browser.open(output / "failure.html")
        self.expect_sound()
        self.assertIn("Raise time_limit", self.browser.run("return document.querySelector('.warnings').textContent"))
        self.assertIn("given up", self.browser.run("return document.querySelector('tbody').textContent"))

    def test_compare(self):
        self.page("compare", "compare.html")
        self.assertIn("agree", self.browser.run("return document.getElementById('verdict').textContent"))

    def test_verify(self):
        """The claims of a stand-in for the suites: those of the made-up page."""
        claims = [{**claim, "suite": "".join(word.title() for word in claim["suite"].split("_"))}
                  for claim in fixture.verification()["summary"]["claims"]]
        record, script, output = (self.folder / name for name in ("claims.json", "suites", "verified"))
        record.write_text(json.dumps(claims))
        script.write_text(f"""#!/bin/sh
            if [ "$1" = --gtest_list_tests ]; then printf 'ClosedForms.\\n  Bar\\n'; else cp '{record}' "$ISOPATCH_CLAIMS"; fi""")
        script.chmod(0o700)
        run = subprocess.run([os.environ["ISOPATCH_PROGRAM"], "verify", "--output", output], text=True, capture_output=True,
                             stdin=subprocess.DEVNULL, timeout=60, env={**os.environ, "ISOPATCH_VERIFICATION": str(script)})
        self.assertEqual(run.returncode, 1, run.stderr)
        self.browser.open(output / "verify.html")
        self.expect_sound()
        self.assertIn("3 claims hold, 1 fail, 1 were not run", self.browser.run("return document.getElementById('verdict').textContent"))
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('.claims')].map((x) => [x.id, x.querySelectorAll('svg').length])"),
                         [["closed_forms", 0], ["manufactured", 1], ["solvers", 0], ["seed_studies", 0]])
        self.assertIn("p = 2: slope 3, expected 3", self.browser.run("return document.querySelector('#manufactured svg').textContent"))


if __name__ == "__main__":
    browser.skip_if_absent()
    unittest.main()

#!/usr/bin/python3
"""The pages in a real browser: what they draw, what a click shows, what the controls do.

  pages_test.py [CLASS]      ISOPATCH_PROGRAM in the environment adds the pages of the program itself
"""

import json
import math
import os
import pathlib
import random
import re
import subprocess
import tempfile
import unittest

import browser
import fixture

ROUND_OFF = 2e-6  # of a field's range: the page holds numbers of 32 bits


class Pages(unittest.TestCase):
    """One browser for all tests of a class."""
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="isopatch-pages-")
        cls.folder = pathlib.Path(cls.temporary.name)
        cls.browser = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.temporary.cleanup()

    def open(self, name):
        path = self.folder / f"{name}.html"
        if not path.exists():
            fixture.write_page(name, self.folder)
        self.browser.open(path)
        return path

    def expect_drawn(self):
        found = self.browser.pixels()
        self.assertGreater(found["colours"], 50, found)
        self.assertGreater(found["drawn"], 0.04, found)

    def expect_sound(self):
        """No message of the browser, nothing loaded from elsewhere, no control without a name."""
        self.assertEqual(self.browser.messages(), [])
        self.assertEqual(self.browser.run("return performance.getEntriesByType('resource').map((x) => x.name)"), [])
        unnamed = self.browser.run("""
            return [...document.querySelectorAll("input, select, button")].filter((control) => !(
              control.getAttribute("aria-label") || (control.labels && control.labels.length) ||
              (control.tagName === "BUTTON" && control.textContent.trim()))).map((control) => control.outerHTML);""")
        self.assertEqual(unnamed, [])


def contrast(*colours):
    """Of two colours "rgb(1, 2, 3)", from 1 to 21: WCAG 2.1, relative luminance."""
    def luminance(colour):
        parts = [int(x) / 255 for x in re.findall(r"\d+", colour)[:3]]
        red, green, blue = [x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4 for x in parts]
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue
    low, high = sorted(map(luminance, colours))
    return (high + 0.05) / (low + 0.05)


def four_digits(value, unit):
    """What the program prints: four digits with the prefix that leaves at least 1 before the point."""
    factor, symbol = next(((f, s) for f, s in [(1e9, "G"), (1e6, "M"), (1e3, "k"), (1, ""), (1e-3, "m"), (1e-6, "u")]
                           if abs(value) >= f and not (unit == "m" and f >= 1)), (1e-9, "n"))
    return f"{value / factor:.4g} {symbol}{unit}"


class Report(Pages):
    def setUp(self):
        self.open("report")

    def test_draws_the_part_without_complaint(self):
        self.expect_sound()
        self.expect_drawn()

    def test_slider_deforms_the_part(self):
        self.browser.run("arguments[0]; isopatch.viewer.change({markers: false})", 0)
        pictures = []
        for value in ("0", "20", "0"):
            self.browser.run("""const slider = document.getElementById("deformation"); slider.value = arguments[0];
                             slider.dispatchEvent(new Event("input"));""", value)
            self.browser.settle()
            pictures.append(self.browser.picture())
            self.assertIn(f"\u00d7 {value}", self.browser.run("return document.querySelector('.caption').textContent"))
        self.assertNotEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])

    def test_deformed_part_is_where_its_points_are(self):
        self.browser.change(markers=False, supports=False, loads=False)
        for scale in (0, 20):
            self.browser.change(scale=scale)
            drawn, expected = self.browser.run("""
                const {canvas, project, scene, state} = isopatch.viewer; const gl = canvas.getContext("webgl2");
                const [width, height] = [canvas.width, canvas.height]; const bytes = new Uint8Array(4 * width * height);
                gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
                const all = new Uint32Array(bytes.buffer);
                const boxes = [0, 1].map(() => [1e9, 1e9, -1e9, -1e9]);
                const extend = (box, x, y) => { box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], y);
                                                box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], y); };
                for (let i = 0; i < all.length; ++i)
                  if (all[i] !== all[0]) extend(boxes[0], i % width + 0.5, height - Math.floor(i / width) - 0.5);
                for (let v = 0; v < scene.count; ++v)
                  extend(boxes[1], ...project([0, 1, 2].map((c) => (
                    scene.points[3 * v + c] + state.scale * scene.displacement[3 * v + c]))));
                return boxes;""")
            for pixel, point in zip(drawn, expected):
                self.assertAlmostEqual(pixel, point, delta=2)

    def expect_tip(self):
        tip = fixture.ring_report()["summary"]["probes"][0]
        found = self.browser.values()
        self.assertEqual(found["title"], "tip")
        self.assertIn("exact", found["how"])
        self.assertEqual(found["rows"]["von Mises stress"], four_digits(tip["von_mises"], "Pa"))
        self.assertEqual(found["rows"]["its length"], four_digits(math.hypot(*tip["displacement"]), "m"))
        self.assertEqual(found["rows"]["displacement"], "(12.35, -246.9, 59.99) um")
        self.assertEqual(found["rows"]["place"], "(0, 60, 5) mm")

    def test_click_on_a_marker_shows_the_figures_of_the_summary(self):
        x, y = self.browser.run("""
            const {project, places, state} = isopatch.viewer; const tip = places[0];
            return project(tip.point.map((x, c) => x + state.scale * tip.displacement[c]));""")
        self.browser.click(x + 3, y - 2)
        self.expect_tip()

    def test_button_of_a_marker_shows_the_same(self):
        self.browser.run("[...document.querySelectorAll('button.place')].find((b) => b.textContent === 'tip').click()")
        self.expect_tip()

    def test_click_on_the_part_shows_the_field_there(self):
        """The field is linear in the place, so interpolation between points is exact wherever a click falls."""
        self.browser.change(markers=False)
        for scale, axis in ((0, -1), (10, -1), (5, 0), (5, 2)):
            self.browser.change(scale=scale, axis=axis, at=0.37)
            hits = self.browser.run("""
                const {canvas, pickAt} = isopatch.viewer; const hits = [];
                for (let i = 1; i < 40; ++i) for (let j = 1; j < 40; ++j) {
                  const hit = pickAt(canvas.clientWidth * i / 40, canvas.clientHeight * j / 40);
                  if (hit) hits.push([hit.place, hit.fields.displacement, hit.fields.von_mises[0]]);
                }
                return hits;""")
            self.assertGreater(len(hits), 20)
            for place, displacement, stress in hits:
                expected, expected_stress = fixture.ring_fields(place)
                for x, y in zip(displacement, expected):
                    self.assertAlmostEqual(x, y, delta=ROUND_OFF * 3e-4)
                self.assertAlmostEqual(stress, expected_stress, delta=ROUND_OFF * 2.2e8)
                if axis >= 0:
                    low, high = fixture.ring().data()["box"].values()
                    self.assertLessEqual(place[axis], low[axis] + 0.37 * (high[axis] - low[axis]) + 1e-8)

    def test_click_says_that_it_interpolates(self):
        place = fixture.ring_place(0.3, 0.5, 1)
        moved = [x + 10 * u for x, u in zip(place, fixture.ring_fields(place)[0])]
        self.browser.change(markers=False, scale=10)
        x, y = self.browser.run("return isopatch.viewer.project(arguments[0])", moved)
        for hit, expected in zip(self.browser.run("return isopatch.viewer.pickAt(...arguments[0]).place", [x, y]), place):
            self.assertAlmostEqual(hit, expected, delta=1e-5)
        self.browser.click(x, y)
        found = self.browser.values()
        self.assertIn("interpolated", found["how"])
        self.assertEqual(found["rows"]["patch"], "0, face 0:back")
        parameters = [float(p) for p in found["rows"]["parameters"].strip("()").split(",")]
        for p, expected in zip(parameters, (0.3, 0.5, 1)):
            self.assertAlmostEqual(p, expected, delta=0.01)
        _, stress = fixture.ring_fields(fixture.ring_place(0.3, 0.5, 1))
        self.assertAlmostEqual(float(found["rows"]["von Mises stress"].split()[0]), stress / 1e6, delta=1)

    def test_click_beside_the_part_says_so(self):
        self.browser.click(5, 300)
        self.assertIn("missed", self.browser.values()["how"])

    def test_section_of_the_ring_has_its_area(self):
        """Of the polygon through the sampled points: 24 parts of a quarter turn."""
        areas = self.browser.run("""
            const {scene} = isopatch.viewer; const cells = isopatch.makeCells(scene);
            return [0, 0.1, 0.25, 0.5, 0.99].map((part) => {
              const section = isopatch.cutCells(scene, cells, 2, part * scene.box.max[2]);
              const p = isopatch.onSection(scene.points, section, 3); let area = 0;
              for (let i = 2; i < p.length; i += 3)
                if (Math.abs(p[i] - part * scene.box.max[2]) > 1e-8) return "a point off the plane";
              for (let t = 0; t < section.count / 3; ++t) {
                const [ax, ay, , bx, by, , cx, cy] = p.slice(9 * t);
                area += Math.abs((bx - ax) * (cy - ay) - (cx - ax) * (by - ay)) / 2;
              }
              return area;
            });""")
        step = math.pi / 2 / 24
        for area in areas:
            self.assertAlmostEqual(area, 24 * math.sin(step) / 2 * (0.06**2 - 0.04**2), delta=1e-5 * 1e-3)

    def test_section_is_cut_and_filled(self):
        self.browser.change(markers=False, supports=False, loads=False, scale=0)
        self.browser.run("document.getElementById('view-top').click()")
        self.browser.settle()
        whole = self.browser.pixels()["drawn"]
        self.browser.change(axis=0, at=0.5)
        self.assertLess(self.browser.pixels()["drawn"], 0.8 * whole)
        # Seen from the side that is cut away there is a section, and not the hollow inside of the surface.
        self.browser.run("document.getElementById('view-right').click()")
        self.browser.settle()
        hit = self.browser.run("""const {project, pickAt, scene} = isopatch.viewer;
            return pickAt(...project([0.03, 0.046, 0.005])).place;""")
        self.assertAlmostEqual(hit[0], 0.03, delta=1e-6)

    def test_outlines_of_the_section_close(self):
        """Across z the section of each patch is a closed line: every end of a line meets another one."""
        ends = self.browser.run("""
            const {scene} = isopatch.viewer;
            const lines = isopatch.cutFaces(scene, isopatch.patchRanges(scene), 2, 0.004);
            const p = isopatch.onSection(scene.points, lines, 3); const ends = [];
            for (let i = 0; i < lines.count; ++i) ends.push([...p.slice(3 * i, 3 * i + 3)].map((x) => Math.round(x * 1e6)).join());
            return ends;""")
        counts = {end: ends.count(end) for end in set(ends)}
        self.assertGreater(len(counts), 40)
        self.assertEqual({count % 2 for count in counts.values()}, {0})

    def test_markers_that_are_cut_off_or_covered(self):
        classes = """return [...document.querySelectorAll('.marker-label')].map((label) => [
            label.textContent, label.hidden, label.classList.contains('marker-behind')]);"""
        def state():
            self.browser.driver.execute_async_script("setTimeout(arguments[0], 300)")
            return {name: (hidden, behind) for name, hidden, behind in self.browser.run(classes)}
        self.browser.change(scale=0)
        self.assertEqual(state()["largest displacement"], (False, False))
        self.browser.run("document.getElementById('view-bottom').click()")
        self.assertEqual(state()["warning 1"], (False, True))
        self.browser.change(axis=1, at=0.2)
        self.assertEqual(state()["largest displacement"], (True, False))

    def test_fit_shows_all_of_the_part_beside_the_colour_bar(self):
        for name in ("isometric", "front", "top"):
            self.browser.run("document.getElementById(arguments[0]).click()", f"view-{name}")
            low, high, width, height, bar = self.browser.run("""
                const {scene, project, canvas} = isopatch.viewer; const [low, high] = [[1e9, 1e9], [-1e9, -1e9]];
                isopatch.viewer.change({scale: 0}); isopatch.viewer.fit();
                for (let v = 0; v < scene.count; ++v) project(isopatch.pointOf(scene, v)).forEach((x, c) => {
                  low[c] = Math.min(low[c], x); high[c] = Math.max(high[c], x); });
                return [low, high, canvas.clientWidth, canvas.clientHeight, document.querySelector(".colour-bar").offsetWidth];""")
            self.assertGreaterEqual(low[0], bar, name)
            self.assertLessEqual(high[0], width, name)
            self.assertGreaterEqual(low[1], 0, name)
            self.assertLessEqual(high[1], height, name)
            # It is as large as that allows.
            self.assertGreater(max((high[0] - low[0]) / (width - bar), (high[1] - low[1]) / height), 0.85, name)

    def test_range_and_colours(self):
        self.browser.change(markers=False)
        pictures = [self.browser.picture()]
        for script in ("document.getElementById('range-percentile').click()",
                       "const i = document.getElementById('range-high'); i.value = '150'; i.dispatchEvent(new Event('change'))",
                       "const s = document.getElementById('bands'); s.value = '8'; s.dispatchEvent(new Event('change'))",
                       "const s = document.getElementById('quantity'); s.value = 'patch'; s.dispatchEvent(new Event('change'))",
                       "const s = document.getElementById('quantity'); s.value = 'displacement_z'; s.dispatchEvent(new Event('change'))"):
            self.browser.run(script)
            self.browser.settle()
            pictures.append(self.browser.picture())
            if "150" in script:
                self.assertIn("up to 220", self.browser.run("return document.querySelector('.bar-hint').textContent"))
        self.assertEqual(len(set(pictures)), len(pictures))

    def test_keys_turn_move_and_zoom(self):
        places = []
        for key, shift in (("1", 0), ("2", 0), ("3", 0), ("4", 0), ("5", 0), ("6", 0), ("7", 0), ("ArrowLeft", 0),
                           ("ArrowUp", 0), ("+", 0), ("-", 0), ("ArrowRight", 8), ("0", 0)):
            self.browser.press(key, shift)
            orbit = self.browser.run("const s = isopatch.viewer.orbit.state; return [s.azimuth, s.elevation, s.distance, s.target.x]")
            places.append(tuple(round(x, 6) for x in orbit))
        for before, after, key in zip(places, places[1:], "234567<^+->0"):
            self.assertNotEqual(before, after, key)

    def test_fingers_turn_and_zoom(self):
        def orbit():
            return self.browser.run("const s = isopatch.viewer.orbit.state; return [s.azimuth, s.distance]")
        def touch(kind, *points):
            self.browser.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {
                "type": kind, "touchPoints": [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})
        self.browser.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})
        self.addCleanup(self.browser.driver.execute_cdp_cmd, "Emulation.setTouchEmulationEnabled", {"enabled": False})
        start = orbit()
        touch("touchStart", (400, 300))
        touch("touchMove", (460, 300))
        touch("touchEnd")
        turned = orbit()
        self.assertNotAlmostEqual(turned[0], start[0], places=2)
        self.assertEqual(turned[1], start[1])
        touch("touchStart", (400, 300), (500, 300))
        touch("touchMove", (350, 300), (550, 300))
        touch("touchEnd")
        pinched = orbit()
        self.assertAlmostEqual(pinched[1], turned[1] / 2, delta=0.05 * turned[1])
        self.assertEqual(pinched[0], turned[0])

    def test_nothing_is_drawn_while_nothing_changes(self):
        count = "return isopatch.viewer.pictures"
        before = self.browser.run(count)
        for _ in range(5):
            self.browser.settle()
        self.assertEqual(self.browser.run(count), before)
        self.browser.change(scale=3)
        self.assertEqual(self.browser.run(count), before + 1)

    def test_dark_and_light(self):
        self.browser.settle()
        first = self.browser.pixels()["first"]
        self.browser.run("document.getElementById('theme').click()")
        self.browser.settle()
        second = self.browser.pixels()["first"]
        self.assertGreater(abs(sum(first) - sum(second)), 200)

    def test_paper_is_white_also_of_a_dark_page(self):
        self.browser.run("document.documentElement.dataset.theme = 'dark'; isopatch.viewer.setBackground()")
        self.browser.settle()
        screen = self.browser.pixels()["first"]
        self.browser.run("window.dispatchEvent(new Event('beforeprint'))")
        self.assertEqual(self.browser.pixels()["first"], [255, 255, 255])
        self.browser.run("window.dispatchEvent(new Event('afterprint'))")
        self.browser.settle()
        self.assertEqual(self.browser.pixels()["first"], screen)

    def test_warnings_lead_to_their_place(self):
        self.browser.run("document.querySelector('.warnings button').click()")
        found = self.browser.values()
        self.assertEqual((found["title"], found["how"]),
                         ("warning 1", "patch 1: the sign of its Jacobian could not be certified"))
        self.assertEqual(self.browser.run("return document.querySelectorAll('.warnings li').length"), 2)

    def test_tables_show_the_summary(self):
        text = self.browser.run("return document.body.innerText")
        for expected in ("quarter ring <of two patches>", "275.4 um at (0, 60, 10) mm", "12.35 mJ",
                         "(0, 200, -50) N", "cg with 3 multigrid levels, matrix-free", "0.80 s", 'faces = ["0:west"]'):
            self.assertIn(expected, text)

    def test_numbers_are_printed_as_by_printf(self):
        generator = random.Random(7)
        values = [0.0, 1.0, 0.5, -1234.5, 1235.5, 999.95, 9999.5, 0.00012345, 99999.0, 1e22, 5e-324, 0.1, 123456.5]
        values += [generator.uniform(-1, 1) * 10.0 ** generator.randint(-12, 12) for _ in range(2000)]
        found = self.browser.run("return arguments[0].map((x) => [isopatch.general(x, 4), isopatch.general(x, 6)])", values)
        self.assertEqual(found, [[f"{x:.4g}", f"{x:.6g}"] for x in values])


class OtherPages(Pages):
    def test_compare_draws_the_tractions_on_the_interface(self):
        self.open("compare")
        self.expect_sound()
        self.expect_drawn()
        self.browser.change(markers=False, scale=0)
        self.browser.run("document.getElementById('view-left').click()")
        hit = self.browser.run("""const {project, pickAt} = isopatch.viewer;
            const hit = pickAt(...project(arguments[0])); return hit && hit.fields.traction""",
                               fixture.ring_place(0.5, 0.5, 0.5))
        # Half the width lies between the points j = 4 of 0 to 8 in the other direction.
        for found, expected in zip(hit, (3e7 * 5 / 9, -2e7, 5e6 * 2)):
            self.assertAlmostEqual(found, expected, delta=3e5)
        self.assertIn("agree", self.browser.run("return document.getElementById('verdict').textContent"))
        self.assertIn("3,225", self.browser.run("return document.body.innerText"))

    def test_model_without_a_solution(self):
        self.open("model")
        self.expect_sound()
        self.expect_drawn()
        self.assertIsNone(self.browser.run("return document.getElementById('deformation')"))
        self.assertIn("Scaled Jacobian", self.browser.run("return document.querySelector('.bar-title').textContent"))

    def verdicts(self, section):
        """Row by row of a suite: what is claimed and the verdict."""
        return self.browser.run("""
            return [...document.querySelectorAll(`#${arguments[0]} tbody tr:not(.case)`)].map((row) => (
              [row.querySelector("th").innerText, row.querySelector(".verdict").textContent]));""", section)

    def test_patches_of_solids_have_certificate_quality_and_deviation(self):
        self.open("model")
        text = self.browser.run("return [...document.querySelectorAll('h2')].find((h) => h.textContent === 'From solids to patches').parentElement.innerText")
        for part in ("The largest deviation is 8.6 um, at a:face 3; 10 um is allowed", "Not every patch could be certified",
                     "0.25", "75 %"):
            self.assertIn(part, text)
        rows = self.browser.run("return [...document.querySelectorAll('details tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))")
        self.assertEqual(rows[0], ["a:face 3", "0:west", "8.6 um", ""])
        self.assertEqual(rows[1], ["a:face 1 = b:face 5", "0:east = 1:west", "1 um", "20 nm"])

    def test_verification_shows_every_verdict(self):
        self.open("verification")
        self.expect_sound()
        text = self.browser.run("return document.getElementById('verdict').textContent")
        self.assertIn("3 claims hold, 1 fail, 1 were not run (level quick, 12.30 s)", text)
        self.assertIn("bad", self.browser.run("return document.getElementById('verdict').className"))
        self.assertEqual(self.verdicts("closed_forms"), [["u at the end (m)", "holds"], ["u at the joint (m)", "FAILS"]])
        self.assertEqual(self.verdicts("seed_studies"), [
            ["largest displacement (m)\nthe paper prints <another> load", "reported"], ["no figures", "not run"]])
        self.assertIn("set ISOPATCH_DATA", self.browser.run("return document.getElementById('seed_studies').innerText"))
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('#failures li')].map((x) => x.textContent)"),
                         ["closed forms, bar: u at the joint"])
        # One link a suite, and plots stand in their own.
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('.suites a')].map((x) => x.hash)"),
                         ["#closed_forms", "#manufactured", "#solvers", "#seed_studies"])
        self.assertEqual(self.browser.run("return [...document.querySelectorAll('.claims')].map((x) => x.querySelectorAll('svg').length)"),
                         [0, 1, 0, 0])
        self.assertIn("at most, from 1", self.browser.run("return document.getElementById('solvers').innerText"))
        self.assertIn("meshes that are affordable", self.browser.run("return document.getElementById('manufactured').innerText"))

    def test_faults_stand_out_in_red(self):
        self.open("faults")
        self.expect_sound()
        self.assertIn("its outline <crosses> itself", self.browser.run("return document.getElementById('message').textContent"))
        reddish = """
            isopatch.viewer.draw();
            const canvas = isopatch.viewer.canvas;
            const gl = canvas.getContext("webgl2") || canvas.getContext("webgl");
            const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
            gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            let count = 0;
            for (let i = 0; i < bytes.length; i += 4) if (bytes[i] > 1.3 * bytes[i + 1] && bytes[i] > 1.3 * bytes[i + 2]) count += 1;
            return 4 * count / bytes.length;"""
        self.assertGreater(self.browser.run(reddish), 0.02)
        self.browser.run("isopatch.viewer.look('top')")
        self.assertGreater(self.browser.run(reddish), 0.05)
        labels = self.browser.run("return [...document.querySelectorAll('.marker-label')].map((x) => x.textContent)")
        self.assertEqual(labels, ["part: face 1 (outline <crosses> itself)", "part: edge 3", "part: edge 4", "crossing"])
        rows = self.browser.run("return [...document.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))")
        self.assertIn(["part: face 2", "drawn by its edges only", ""], rows)
        self.assertIn(["crossing", "(50, 50, 100) mm", "show"], rows)
        self.assertIn(["part", "part.off", "3", "12", "8", "closed"], rows)
        # "show" leads to the place.
        self.browser.run("[...document.querySelectorAll('button')].find((b) => b.getAttribute('aria-label') === 'show crossing').click()")
        self.browser.settle()
        self.assertFalse(self.browser.run("return document.querySelector('.marker-picked').hidden"))

    def slide(self, control, value):
        self.browser.run("""const slider = document.getElementById(arguments[0]); slider.value = arguments[1];
                         slider.dispatchEvent(new Event("input"));""", control, str(value))
        self.browser.settle()

    def counted(self, condition):
        """The part of the picture's pixels, red r, green g, blue b, for which a condition holds."""
        return self.browser.run("""
            isopatch.viewer.draw();
            const canvas = isopatch.viewer.canvas;
            const gl = canvas.getContext("webgl2") || canvas.getContext("webgl");
            const bytes = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
            gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
            const holds = new Function("r", "g", "b", "return " + arguments[0]);
            let count = 0;
            for (let i = 0; i < bytes.length; i += 4) if (holds(bytes[i], bytes[i + 1], bytes[i + 2])) count += 1;
            return 4 * count / bytes.length;""", condition)

    PINK = "r > 150 && g < 60 && b > 60 && b < 170"
    RED = "r > 60 && r > 3 * g && r > 3 * b"

    def test_blocks_move_apart_from_the_centre(self):
        self.open("blocks")
        self.expect_sound()
        self.expect_drawn()
        pictures = []
        for value in (0, 1, 0):
            self.slide("apart", value)
            pictures.append(self.browser.picture())
            for i, centre in enumerate([(0.05, 0.05), (0.15, 0.05), (0.05, 0.15)]):
                moved = self.browser.run("return isopatch.viewer.offsetOf(arguments[0])", i)
                for found, x, middle in zip(moved, centre, (0.1, 0.1)):
                    self.assertAlmostEqual(found, value * (x - middle), delta=1e-6)
        self.assertNotEqual(pictures[0], pictures[1])
        self.assertEqual(pictures[0], pictures[2])

    def test_blocks_switch_to_the_parts_with_their_t_joints(self):
        self.open("blocks")
        self.assertLess(self.counted(self.PINK), 1e-4)  # before removal, so on the parts alone
        self.browser.run("document.getElementById('stage-0').click()")
        self.assertGreater(self.counted(self.PINK), 1e-3)
        self.browser.run("document.getElementById('show-lines').click()")
        self.assertLess(self.counted(self.PINK), 1e-4)

    def test_blocks_are_listed_and_chosen_by_a_click(self):
        self.open("blocks")
        rows = self.browser.run("return [...document.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))")
        self.assertIn(["part", "3000 cm^3", "1", "2", "1", "1 further cut", "3", "1e-09", "0.25 s"], rows)
        self.assertIn(["part#1", "block_1.step", "1000 cm^3", "33.3 %", "face <0>", "show"], rows)
        x, y = self.browser.run("return isopatch.viewer.project([0.15, 0.05, 0.1].map((x, c) => x + isopatch.viewer.offsetOf(1)[c]))")
        self.browser.click(x, y)
        self.assertIn("block_1.step", self.browser.run("return document.getElementById('picked').innerText"))
        self.browser.click(x, y)
        self.assertIn("Click a piece", self.browser.run("return document.getElementById('picked').innerText"))
        self.browser.run("document.querySelector('[aria-label=\"show part#2\"]').click()")
        self.assertIn("block_2.step", self.browser.run("return document.getElementById('picked').innerText"))

    def test_stages_stand_beside_the_result(self):
        self.open("staged")
        self.expect_sound()
        self.expect_drawn()
        identifiers = self.browser.run("return [...document.querySelectorAll('[id]')].map((found) => found.id)")
        self.assertEqual(len(identifiers), len(set(identifiers)))
        rows = self.browser.run("return [...document.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => cell.textContent))")
        self.assertIn(["solid", "as before, from 2026-11-30 10:28 UTC", "3.30 s", "stages/solids.h5"], rows)
        self.assertIn(["hexahedra", "made in this run", "5.40 s", "stages/blocks.h5"], rows)
        offset = "return isopatch.stageViewer.offsetOf(1)"
        self.assertGreater(abs(self.browser.run(offset)[0]), 0.01)  # hexahedra are drawn apart at first
        self.browser.run("document.getElementById('stages-stage-0').click()")
        self.assertEqual(self.browser.run(offset), [0, 0, 0])  # triangles are not
        self.browser.run("isopatch.stageViewer.change({chosen: 0})")
        self.assertIn("12 triangles", self.browser.run("return document.getElementById('stages-picked').innerText"))
        self.assertNotIn("volume", self.browser.run("return document.getElementById('stages-picked').innerText"))

    def test_triangles_without_a_solid_say_why(self):
        self.open("unmade")
        self.expect_sound()
        self.assertIn("3 of <46> faces", self.browser.run("return document.querySelector('.warnings').textContent"))
        self.assertGreater(self.counted(self.RED), 0.05)

    def test_what_could_not_be_cut_is_red(self):
        self.open("failure")
        self.expect_sound()
        self.assertIn("could not be <cut>", self.browser.run("return document.querySelector('.warnings').textContent"))
        self.assertIn("given up", self.browser.run("return document.querySelector('tbody').textContent"))
        self.assertEqual(self.browser.run("return document.getElementById('t-joints').textContent"), "face 4 of block 'part' meets <part#1>")
        self.assertGreater(self.counted(self.RED), 0.05)
        self.open("blocks")
        self.assertLess(self.counted(self.RED), 1e-3)

    def test_verdicts_are_readable_in_both_themes(self):
        self.open("verification")
        for theme in ("light", "dark"):
            self.browser.run("document.documentElement.dataset.theme = arguments[0]", theme)
            for verdict in ("good", "bad", "open"):
                colours = self.browser.run("""
                    const style = (at) => getComputedStyle(document.querySelector(at));
                    return [style(arguments[0]).color, style(".card").backgroundColor]""", f".claims .verdict.{verdict}")
                self.assertGreater(contrast(*colours), 4.5, (theme, verdict, colours))

    def test_pages_fit_a_phone(self):
        self.addCleanup(self.browser.resize, 1280, 800)
        self.browser.resize(390, 844, is_phone=True)
        for name in ("report", "compare", "model", "verification", "faults", "blocks", "failure", "staged", "unmade"):
            self.open(name)
            width = self.browser.run("return document.documentElement.scrollWidth")
            self.assertLessEqual(width, 390, name)
            if name not in ("verification", "faults"):
                self.expect_drawn()

    def test_without_webgl_the_rest_is_there(self):
        script = self.browser.driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {
            "source": "HTMLCanvasElement.prototype.getContext = () => null;"})
        self.addCleanup(self.browser.driver.execute_cdp_cmd, "Page.removeScriptToEvaluateOnNewDocument", script)
        self.open("report")
        text = self.browser.run("return document.body.innerText")
        self.assertIn("WebGL", text)
        self.assertIn("12.35 mJ", text)
        self.assertEqual(self.browser.messages(), [])

    def test_values_that_are_absent_are_grey(self):
        self.open("compare")
        self.browser.change(markers=False, surface="solid", interfaces=False, patchEdges=False)
        self.browser.change(scale=0)
        pixel = """
            const {canvas, project} = isopatch.viewer; const gl = canvas.getContext("webgl2"); const p = new Uint8Array(4);
            const [x, y] = project(arguments[0]);
            gl.readPixels(x, canvas.height - 1 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, p); return [...p.slice(0, 3)];"""
        grey = self.browser.run(pixel, fixture.ring_place(0.3, 0.5, 1))
        self.assertEqual(len(set(grey)), 1, grey)
        self.browser.run("const s = document.getElementById('quantity'); s.value = 'von_mises'; s.dispatchEvent(new Event('change'))")
        self.browser.settle()
        self.assertEqual(len(set(self.browser.run(pixel, fixture.ring_place(0.3, 0.5, 1)))), 3)

    def test_three_hundred_patches(self):
        """A page of a quarter of a million points stays within its size and answers."""
        path = self.open("grid")
        self.assertLess(path.stat().st_size, 15e6)
        self.expect_sound()
        self.expect_drawn()
        milliseconds = self.browser.run("""
            const {scene} = isopatch.viewer; const cells = isopatch.makeCells(scene); const start = performance.now();
            isopatch.cutCells(scene, cells, 0, 0.45); return performance.now() - start;""")
        self.assertLess(milliseconds, 500)
        hit = self.browser.run("const {canvas, pickAt} = isopatch.viewer; return pickAt(canvas.clientWidth / 2, canvas.clientHeight / 2).place")
        self.assertEqual(len(hit), 3)


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

#!/usr/bin/python3
"""The report in a real browser: what it draws, what a click shows, what the controls do."""

import math
import random
import unittest

import browser
import fixture
from page_case import Pages, four_digits

ROUND_OFF = 2e-6  # of a field's range: the page holds numbers of 32 bits


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
                  if (hit) hits.push([hit.place, hit.fields.displacement, hit.fields.von_mises[0], hit.fields.stress]);
                }
                return hits;""")
            self.assertGreater(len(hits), 20)
            for place, displacement, stress, components in hits:
                expected, expected_stress = fixture.ring_fields(place)
                for x, y in zip(displacement, expected):
                    self.assertAlmostEqual(x, y, delta=ROUND_OFF * 3e-4)
                self.assertAlmostEqual(stress, expected_stress, delta=ROUND_OFF * 2.2e8)
                for x, y in zip(components, fixture.stress_components(expected_stress)):
                    self.assertAlmostEqual(x, y, delta=0.51 * 6.6e8 / 32767)
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

    def test_colours_by_every_component_of_the_stress(self):
        found = self.browser.run("""
            const {scene, statisticsOf} = isopatch.viewer;
            return scene.quantities.filter((q) => q.field === "stress").map((q) => [q.label, statisticsOf(q).max]);""")
        largest = dict(xx=2.2e8, yy=1.1e8, zz=-2.5e7, xy=2.75e7, yz=-2e8, zx=6.6e8)
        self.assertEqual([label for label, _ in found], ["Stress " + name for name in largest])
        for (_, value), expected in zip(found, largest.values()):
            self.assertAlmostEqual(value, expected, delta=0.51 * 6.6e8 / 32767)

    def test_axes_point_where_those_of_the_part_do(self):
        for view in ("isometric", "front", "top", "left"):
            self.browser.run("document.getElementById('view-' + arguments[0]).click()", view)
            self.browser.settle()
            drawn, seen = self.browser.run("""
                const {project, orbit, scene} = isopatch.viewer; const centre = orbit.state.target.toArray();
                const axes = ["x", "y", "z"].map((name) => document.querySelector(".axis-" + name + " line"));
                const start = project(centre);
                return [axes.map((line) => [line.x2.baseVal.value, line.y2.baseVal.value]), [0, 1, 2].map((c) => {
                  const end = project(centre.map((x, i) => x + (i === c ? 1e-3 * scene.size : 0)));
                  return end.map((x, i) => x - start[i]);
                })];""")
            largest = [max(math.hypot(*axis) for axis in axes) for axes in (drawn, seen)]
            for axis, expected in zip(drawn, seen):
                for x, y in zip(axis, expected):  # the part is seen in perspective
                    self.assertAlmostEqual(x / largest[0], y / largest[1], delta=0.05)

    def test_labels_have_the_values(self):
        tip, top, stress = fixture.ring_report()["summary"]["probes"][0], *fixture.ring_markers()[1:]
        for quantity, of_tip in (("von_mises", four_digits(tip["von_mises"], "Pa")),
                                 ("displacement_x", four_digits(math.hypot(*tip["displacement"]), "m"))):
            self.browser.run("const s = document.getElementById('quantity'); s.value = arguments[0]; "
                             "s.dispatchEvent(new Event('change'))", quantity)
            self.browser.settle()
            labels = self.browser.run("return [...document.querySelectorAll('.marker-label')].map((x) => x.textContent)")
            self.assertEqual(labels[:3], [
                "tip " + of_tip, "largest displacement " + four_digits(math.hypot(*top["displacement"]), "m"),
                "largest von Mises stress " + four_digits(stress["von_mises"], "Pa")])

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
            label.textContent.replace(/ [0-9.]+ [a-zA-Z]+$/, ""), label.hidden, label.classList.contains('marker-behind')]);"""
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

    def test_levels_are_seen_whole(self):
        for width, height, is_phone in ((1280, 800, False), (390, 844, True)):
            self.browser.resize(width, height, is_phone)
            seen, wanted, last = self.browser.run("""
                const table = document.querySelector("#levels .table");
                const cells = table.querySelectorAll("thead th");
                return [table.clientWidth, table.scrollWidth, cells[2].textContent];""")
            self.assertLessEqual(wanted, seen, width)
            self.assertEqual(last, "error")
        self.browser.resize(1280, 800)

    def test_numbers_are_printed_as_by_printf(self):
        generator = random.Random(7)
        values = [0.0, 1.0, 0.5, -1234.5, 1235.5, 999.95, 9999.5, 0.00012345, 99999.0, 1e22, 5e-324, 0.1, 123456.5]
        values += [generator.uniform(-1, 1) * 10.0 ** generator.randint(-12, 12) for _ in range(2000)]
        found = self.browser.run("return arguments[0].map((x) => [isopatch.general(x, 4), isopatch.general(x, 6)])", values)
        self.assertEqual(found, [[f"{x:.4g}", f"{x:.6g}"] for x in values])


if __name__ == "__main__":
    browser.skip_if_absent()
    unittest.main()

#!/usr/bin/python3
"""Pages of comparisons, models, verifications and blocks in a real browser."""

import unittest

import browser
import fixture
from page_case import Pages, contrast


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

    def test_factorizations_have_no_iterations(self):
        self.open("compare")
        self.assertRegex(self.browser.run("return document.body.innerText"), r"iterations\s+none\s+none")

    def test_plots_of_a_comparison_fill_the_page(self):
        self.open("compare")
        widths = self.browser.run("return [...document.querySelectorAll('.plot svg')].map((x) => x.getBoundingClientRect().width)")
        self.assertGreater(len(widths), 0)
        self.assertGreaterEqual(sum(widths), 900, widths)

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


if __name__ == "__main__":
    browser.skip_if_absent()
    unittest.main()

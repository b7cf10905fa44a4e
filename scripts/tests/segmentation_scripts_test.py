"""Shows what the segmentation's scripts make: valid random solids, the right verdicts, tables."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import cut_solids, finite_elements, polyhedra, solid_elements, tables  # noqa: E402


def script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def cube():
    return polyhedra.joined([polyhedra.box((1, 1, 1))])


class Polyhedra(unittest.TestCase):
    def test_random_solids_are_closed_balls_of_their_kind(self):
        for kind in polyhedra.KINDS:
            for seed in range(4):
                solid = polyhedra.random_solid(kind, seed, 24)
                with self.subTest(kind=kind, seed=seed):
                    polyhedra.checked(solid)  # closed, a ball
                    self.assertLessEqual(len(solid.vertices), 24)
                    self.assertGreater(polyhedra.volume(solid), 0)
                    self.assertEqual(bool(polyhedra.concave_edges(solid)), kind.startswith("notched"))
                    degrees = {sum(vertex in face for face in solid.faces) for vertex in range(len(solid.vertices))}
                    if kind == "simple":
                        self.assertEqual(degrees, {3})
                    if kind == "triangulated":
                        self.assertEqual({len(face) for face in solid.faces}, {3})

    def test_the_same_seed_makes_the_same_solid(self):
        self.assertEqual(polyhedra.random_solid("notched", 5, 30), polyhedra.random_solid("notched", 5, 30))
        self.assertNotEqual(polyhedra.random_solid("notched", 5, 30), polyhedra.random_solid("notched", 6, 30))

    def test_a_notch_takes_away_its_volume_and_makes_few_faces(self):
        notch = [((1.0, 0.0, 0.0), 0.5), ((0.0, 1.0, 0.0), 0.5)]
        solid = polyhedra.joined(polyhedra.without([polyhedra.box((1, 1, 1))], notch, [10, 11]))
        self.assertAlmostEqual(polyhedra.volume(solid), 8 - 0.5 * 0.5 * 2)
        self.assertEqual((len(solid.vertices), len(solid.faces)), (12, 8))
        self.assertEqual(len(polyhedra.concave_edges(solid)), 1)
        self.assertTrue(polyhedra.three_connected(solid))

    def test_the_dual_of_a_cube_is_an_octahedron(self):
        solid = polyhedra.checked(polyhedra.dual(cube()))
        self.assertEqual((len(solid.vertices), len(solid.faces)), (6, 8))
        self.assertAlmostEqual(polyhedra.volume(solid), 4 / 3)

    def test_a_hole_through_a_face_is_no_valid_solid(self):
        pocket = [((1.0, 0.0, 0.0), -0.5), ((-1.0, 0.0, 0.0), -0.5), ((0.0, 1.0, 0.0), -0.5), ((0.0, -1.0, 0.0), -0.5),
                  ((0.0, 0.0, 1.0), 0.5)]
        with self.assertRaises(polyhedra.NotDone):
            polyhedra.joined(polyhedra.without([polyhedra.box((1, 1, 1))], pocket, range(10, 15)))

    def test_a_corner_off_is_read_back_as_written(self):
        lines = polyhedra.off_text(cube()).split("\n")
        self.assertEqual(lines[:2], ["OFF", "8 6 0"])
        self.assertEqual(len(lines), 2 + 8 + 6 + 1)


def described(solid):
    """A polyhedron as `isopatch info --json` has it."""
    edges = sorted(solid.edges())
    number = {edge: i for i, edge in enumerate(edges)}
    faces = []
    for face in solid.faces:
        loop = [{"edge": number[(min(a, b), max(a, b))], "reversed": a > b} for a, b in polyhedra.sides(face)]
        area = sum(x * x for x in polyhedra.area_normal(solid, face)) ** 0.5
        faces.append({"name": "", "colour": None, "surface": "plane", "area": area, "loops": [loop]})
    concave = polyhedra.concave_edges(solid)
    meeting = [[i for i, face in enumerate(solid.faces) if set(edge) <= set(face)] for edge in edges]
    return {"vertices": [list(vertex) for vertex in solid.vertices], "faces": faces,
            "edges": [{"vertices": list(edge), "faces": around, "curve": "line",
                       "convexity": "non-convex" if edge in concave else "convex"} for edge, around in zip(edges, meeting)],
            "checks": {"contractible": True, "simple": True, "three_connected": True, "faces_with_inner_loops": [],
                       "periodic_faces": [], "closed_edges": []}}


class Solids(unittest.TestCase):
    def test_the_triangles_of_a_plane_side_are_one(self):
        whole = cube()
        halved = polyhedra.Polyhedron(whole.vertices, whole.faces[:5] + [whole.faces[5][:3], whole.faces[5][2:] + whole.faces[5][:1]])
        self.assertEqual(cut_solids.merged_faces(described(halved)), [[0], [1], [2], [3], [4], [5, 6]])

    def test_holds_the_largest_side_and_loads_one_that_does_not_touch_it(self):
        flat = polyhedra.joined([polyhedra.box((3, 2, 1))])
        held, loaded = cut_solids.held_and_loaded(described(flat))
        self.assertEqual({held, loaded}, {0, 1})  # bottom and top

    def test_tells_classes(self):
        self.assertEqual(cut_solids.kind_of(described(cube())), "i")
        notched = described(polyhedra.random_solid("notched", 1, 20))
        self.assertEqual(cut_solids.kind_of(notched), "ii")
        notched["checks"]["three_connected"] = False
        self.assertEqual(cut_solids.kind_of(notched), "iii")
        notched["faces"][0]["surface"] = "bspline"
        self.assertEqual(cut_solids.kind_of(notched), "iv")

    def test_shortens_errors_to_their_reason(self):
        self.assertEqual(cut_solids.in_few_words("isopatch: error: solid 'a b': its edge graph is not 3-connected: face 2 and face 3 "
                                                 "meet twice; cut it"), "its edge graph is not 3-connected: face 2 and face 3 meet twice")
        self.assertEqual(cut_solids.in_few_words("isopatch: error: /d/x.off: face 2 is not plane; split it"), "face 2 is not plane")
        self.assertEqual(cut_solids.in_few_words("one two three", most=9), "one two ...")

    def test_a_command_that_goes_on_is_ended(self):
        done = cut_solids.call(SCRIPTS.parent, [sys.executable, "-c", "while True: pass"], seconds=0)
        self.assertIsNone(done.code)
        done = cut_solids.call(SCRIPTS.parent, [sys.executable, "-c", "import sys; print(1); sys.exit('why')"], seconds=5)
        self.assertEqual((done.code, done.output, done.said), (1, "1\n", "why\n"))


class References(unittest.TestCase):
    def test_extrapolates_a_known_order(self):
        meshes = [{"size_mm": size, "energy": 7 - 0.1 * size ** 2} for size in (2.25, 1.5, 1.0)]
        self.assertAlmostEqual(solid_elements.extrapolated(meshes), 7)

    def test_does_not_believe_an_order_below_one(self):
        meshes = [{"size_mm": size, "energy": energy} for size, energy in ((2.25, 1.0), (1.5, 2.0), (1.0, 3.0))]
        self.assertAlmostEqual(solid_elements.extrapolated(meshes), 3 + 1 / 0.5)

    def test_meshes_are_graded_to_clamped_and_concave_edges(self):
        solid = described(polyhedra.random_solid("notched", 1, 20))
        edges = solid_elements.singular_edges(solid, [0])
        self.assertEqual({i for i, edge in enumerate(solid["edges"]) if edge["convexity"] == "non-convex" or 0 in edge["faces"]},
                         set(edges))

    def test_a_surface_is_found_by_its_corners_and_of_several_by_its_area(self):
        # A disc's edge is closed: its one vertex is the corner of the wall around it too.
        nodes = dict(enumerate([(0, 0, 0), (2, 0, 0), (0, 2, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                (0, 0, 9), (0, 0, 4.5), (1, 0, 4.5)]))
        base, wall = [[0, 1, 2, 3, 4, 5]], [[0, 1, 6, 3, 8, 7]]
        mesh = finite_elements.Mesh(nodes, [], {1: base, 2: wall})
        self.assertEqual(solid_elements.surface_with(mesh, [(0, 0, 0)], 2.1, 1e-6), base)
        self.assertEqual(solid_elements.surface_with(mesh, [(0, 0, 0)], 8.5, 1e-6), wall)
        self.assertEqual(solid_elements.surface_with(mesh, [(0, 0, 0), (0, 2, 0)], 8.5, 1e-6), base)
        with self.assertRaisesRegex(RuntimeError, "no surface has the corners"):
            solid_elements.surface_with(mesh, [(5, 0, 0)], 2.0, 1e-6)


class Verdicts(unittest.TestCase):
    robustness = script("segmentation_robustness")

    def verdict(self, code, error, summary=None):
        said = f"isopatch: error: {error}\n" if error else ""
        return self.robustness.verdict(summary, cut_solids.Outcome(code, "", said, 1.0), 2.0, (3.0, 4.0))[0]

    def test_a_refusal_names_an_entity(self):
        self.assertEqual(self.verdict(2, "solid 'a': face 3 and face 5 meet twice"), "refused")
        self.assertEqual(self.verdict(2, "no way was found at (1, 2.5, -3e-2) m"), "refused")
        self.assertEqual(self.verdict(2, "no way was found, 3 cuts were tried"), "refused without a place")

    def test_tells_faults_apart(self):
        self.assertEqual(self.verdict(1, "this is a bug: face 3"), "internal error")
        self.assertEqual(self.verdict(-11, ""), "crash")
        self.assertEqual(self.verdict(2, "face a#1:face 5 is only a part of face a#2:face 2"), "blocks do not fit")
        self.assertEqual(self.verdict(None, ""), "too slow")
        self.assertEqual(self.verdict(2, "patch 3 is folded, block 3"), "not certified")

    def test_a_solution_needs_certificates_and_the_volume(self):
        def summary(certified=True, volume=2.0, held=3.0):
            return {"parameterization": {"certified": certified}, "supports": [{"area": held}], "loads": [{"area": 4.0}],
                    "model": {"volume": volume, "patches": 3, "min_scaled_jacobian": 0.5}}
        self.assertEqual(self.verdict(0, "", summary()), "certified")
        self.assertEqual(self.verdict(0, "", summary(certified=False)), "not certified")
        self.assertEqual(self.verdict(0, "", summary(volume=2.0 + 1e-7)), "wrong volume")
        self.assertEqual(self.verdict(0, "", summary(held=3.0 + 1e-5)), "wrong area")

    def test_shares_are_by_kind_and_by_size(self):
        rows = [("simple", 1, 10, 7, "certified", "", 4, 1.0), ("simple", 2, 30, 17, "refused", "", None, 3.0)]
        text = self.robustness.table(rows)
        self.assertIn("| simple            |      2 |      50 % |    50 % |", text)
        self.assertIn("21 to 40 vertices", text)
        self.assertNotIn("Faults", text)
        rows.append(("simple", 3, 30, 17, "crash", "signal 11", None, 3.0))
        self.assertTrue(self.robustness.table(rows).endswith("\n\nFaults: simple:3 crash."))


class Tables(unittest.TestCase):
    def test_replaces_what_is_between_the_marks_alone(self):
        text = "a\n<!-- x -->\nold\n<!-- end of x -->\nb\n"
        self.assertEqual(tables.insert(text, "x", "new"), "a\n<!-- x -->\nnew\n<!-- end of x -->\nb\n")

    def test_what_is_refused_has_a_table_of_its_own(self):
        table = script("segmentation_table")
        text = table.table([["a.off", "i", *"123456789"], ["b.step", "iii", "face 0 has a hole"]])
        self.assertIn("refused, or not solved, because", text)
        self.assertIn("face 0 has a hole", text)

    def test_parts_say_where_they_are_held_and_what_they_measure(self):
        table = script("segmentation_table")
        part = {"held": "base", "loaded": "bore", "volume_in_mm3": 5e8, "hexahedra_at_most": None}
        solid = {"volume": 0.25}
        self.assertEqual(table.held_and_loaded(solid, part), ("base", "bore"))
        self.assertEqual(table.known_volume(solid, part), 0.5)
        self.assertEqual(table.known_volume(solid, {**part, "volume_in_mm3": None}), 0.25)
        self.assertEqual(table.at_most(part), "-")
        self.assertTrue(table.table([["nut", "iii", "face 0 has a hole"]], table.PARTS_HEADER).startswith("| part"))


if __name__ == "__main__":
    unittest.main()

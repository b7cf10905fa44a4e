"""Shows what scripts/reconstruction_robustness disturbs meshes by: they stay closed, and verdicts are right."""

import collections
import importlib.machinery
import importlib.util
import json
import pathlib
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SCRIPTS))
sys.dont_write_bytecode = True

from measuring import cut_solids, meshes  # noqa: E402


def script(name):
    loader = importlib.machinery.SourceFileLoader(name, str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def ball():
    """An octahedron, each triangle divided into four, twice."""
    mesh = meshes.Mesh([(1.0, 0, 0), (0, 1.0, 0), (-1.0, 0, 0), (0, -1.0, 0), (0, 0, 1.0), (0, 0, -1.0)],
                       [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (1, 0, 5), (2, 1, 5), (3, 2, 5), (0, 3, 5)])
    for _ in range(2):
        vertices, triangles, number = list(mesh.vertices), [], {}
        for t in mesh.triangles:
            middles = []
            for a, b in zip(t, t[1:] + t[:1]):
                key = (min(a, b), max(a, b))
                if key not in number:
                    number[key] = len(vertices)
                    vertices.append(tuple((x + y) / 2 for x, y in zip(mesh.vertices[a], mesh.vertices[b])))
                middles.append(number[key])
            triangles += [tuple(middles)] + [(t[i], middles[i], middles[i - 1]) for i in range(3)]
        mesh = meshes.Mesh(vertices, triangles)
    return mesh


def is_closed(mesh):
    sides = collections.Counter((t[i], t[(i + 1) % 3]) for t in mesh.triangles for i in range(3))
    return all(count == 1 and sides[b, a] == 1 for (a, b), count in sides.items())


class Disturbed(unittest.TestCase):
    def test_meshes_stay_closed_but_for_triangles_twice(self):
        for kind in meshes.KINDS:
            for seed in range(5):
                mesh, _ = meshes.disturbed(ball(), kind, seed)
                self.assertEqual(is_closed(mesh), kind != "duplicates", (kind, seed))

    def test_order_and_position_keep_the_volume_and_scale_its_cube(self):
        volume = meshes.volume(ball())
        for kind in ("shuffled", "rotated", "small", "large"):
            mesh, factor = meshes.disturbed(ball(), kind, 3)
            self.assertAlmostEqual(meshes.volume(mesh) / (volume * factor ** 3), 1, 9)

    def test_files_come_back(self):
        with tempfile.TemporaryDirectory() as folder:
            off = pathlib.Path(folder) / "a.off"
            off.write_text(meshes.off_text(ball()))
            self.assertEqual(meshes.read(off), ball())
            stl = pathlib.Path(folder) / "a.stl"
            stl.write_bytes(meshes.stl_bytes(ball()))
            self.assertEqual(len(meshes.read(stl).vertices), len(ball().vertices))

    def test_verdicts(self):
        verdict = script("reconstruction_robustness").verdict
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)

            def of(code, said):
                return verdict(cut_solids.Outcome(code, "", said, 1), folder, ball())[0]

            self.assertEqual(of(None, ""), "too slow")
            self.assertEqual(of(-11, ""), "crash")
            self.assertEqual(of(1, "isopatch: error: a face around (1.5, 2, 3) m is none"), "refused")
            self.assertEqual(of(1, "isopatch: error: it did not work"), "refused without a place")
            self.assertEqual(of(1, "isopatch: error: a bug at (1, 2, 3)"), "internal error")
            for factor, expected in ((1.01, "solid"), (1.2, "wrong volume")):
                (folder / "reconstruction.json").write_text(json.dumps({"volume": factor * meshes.volume(ball())}))
                self.assertEqual(of(0, ""), expected)


if __name__ == "__main__":
    unittest.main()

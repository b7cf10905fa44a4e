"""Shows that scripts/check_layers finds each kind of breach, and accepts what is allowed."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK_LAYERS = pathlib.Path(__file__).resolve().parents[1] / "check_layers"


def run(files, with_headers=True):
    """Exit code and standard output for a tree made of {path: text}; headers get their #pragma once, sources a header."""
    headers = {path[:-4] + ".hpp" for path in files if path.endswith(".cpp")} if with_headers else set()
    files = {**dict.fromkeys(sorted(headers - set(files)), ""), **files}
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        for path, text in files.items():
            target = root / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text("#pragma once\n" + text if path.endswith(".hpp") else text)
        done = subprocess.run([sys.executable, CHECK_LAYERS, "--root", root], capture_output=True, text=True)
        return done.returncode, done.stdout


class CheckLayers(unittest.TestCase):
    def accepts(self, files):
        code, output = run(files)
        self.assertEqual((code, output), (0, output), output)

    def rejects(self, files, where, what):
        code, output = run(files)
        self.assertEqual(code, 1, output)
        self.assertEqual(len(output.splitlines()), 1, output)
        self.assertTrue(output.startswith(where + ": "), output)
        self.assertIn(what, output)

    def test_accepts_the_floors_in_order(self):
        self.accepts({
            "geometry/base/error.hpp": "#include <string>\n#include <Eigen/Core>\n",
            "geometry/patch.hpp": '#include "geometry/base/error.hpp"\n',
            "geometry/io/read.cpp": '#include <pugixml.hpp>\n#include <zip.h>\n#include "geometry/patch.hpp"\n',
            "solvers/solve.cpp": '#include <petscksp.h>\n#include <suitesparse/cholmod.h>\n'
                                 '#include "geometry/base/error.hpp"\n',
            "iga/assemble.hpp": '#include "geometry/patch.hpp"\n',
            "app/run.cpp": '#include <toml++/toml.h>\n#include <CLI/CLI.hpp>\n#include "iga/assemble.hpp"\n',
        })

    def test_rejects_a_room_that_the_drawing_or_the_table_of_the_house_lacks(self):
        house = pathlib.Path(__file__).resolve().parents[2] / "CONTRIBUTING.md"
        text = house.read_text(encoding="utf-8")
        files = {"geometry/a.hpp": ""}
        self.accepts({**files, "CONTRIBUTING.md": text})
        self.rejects({**files, "CONTRIBUTING.md": text.replace("distribution assembly", "assembly")}, "CONTRIBUTING.md:1",
                     "the drawing of the house lacks iga/distribution")
        self.rejects({**files, "CONTRIBUTING.md": text.replace("| app/plots |", "| app/plot |")}, "CONTRIBUTING.md:1",
                     "the table of the house lacks app/plots")

    def test_rejects_a_folder_above(self):
        self.rejects({"iga/a.hpp": "", "solvers/b.cpp": '\n#include "iga/a.hpp"\n'}, "solvers/b.cpp:2",
                     "solvers may not include iga")

    def test_rejects_geometry_in_the_solvers(self):
        self.rejects({"geometry/a.hpp": "", "solvers/b.cpp": '#include "geometry/a.hpp"\n'}, "solvers/b.cpp:1",
                     "solvers may not include geometry")

    def test_rejects_files_in_the_models(self):
        self.rejects({"geometry/io/a.hpp": "", "geometry/models/b.cpp": '#include "geometry/io/a.hpp"\n'},
                     "geometry/models/b.cpp:1", "geometry/models may not include geometry/io")

    def test_rejects_solids_in_the_combinatorics(self):
        room = "segmentation/decomposition/combinatorics"
        self.accepts({"geometry/topology/a.hpp": "", room + "/b.cpp": '#include "geometry/topology/a.hpp"\n'})
        for other in ("geometry/brep", "geometry/hex", "geometry", "segmentation/decomposition/cutting"):
            for path in (room + "/b.cpp", room + "/tests/b_test.cpp"):
                self.rejects({other + "/a.hpp": "", path: f'#include "{other}/a.hpp"\n'}, path + ":1",
                             f"{room} may not include {other}")

    def test_rejects_solids_in_the_profiles(self):
        self.rejects({"geometry/brep/a.hpp": "", "segmentation/profiles/b.cpp": '#include "geometry/brep/a.hpp"\n'},
                     "segmentation/profiles/b.cpp:1", "segmentation/profiles may not include geometry/brep")

    def test_rejects_decompositions_in_the_parameterization(self):
        self.rejects({"segmentation/decomposition/a.hpp": "",
                      "segmentation/parameterization/b.cpp": '#include "segmentation/decomposition/a.hpp"\n'},
                     "segmentation/parameterization/b.cpp:1",
                     "segmentation/parameterization may not include segmentation/decomposition")

    def test_rejects_the_program_below_it(self):
        self.rejects({"app/a.hpp": "", "iga/deep/b.hpp": '#include "app/a.hpp"\n'}, "iga/deep/b.hpp:2",
                     "iga may not include app")

    def test_rejects_a_library_in_a_public_header(self):
        self.rejects({"solvers/a.hpp": "#include <petscksp.h>\n"}, "solvers/a.hpp:2", "in a public header")

    def test_accepts_a_library_in_an_internal_header(self):
        self.accepts({"solvers/internal/a.hpp": "#include <petscksp.h>\n",
                      "solvers/b.cpp": '#include "solvers/internal/a.hpp"\n'})

    def test_rejects_an_internal_header_in_a_public_one(self):
        self.rejects({"solvers/internal/a.hpp": "", "solvers/b.hpp": '#include "solvers/internal/a.hpp"\n'},
                     "solvers/b.hpp:2", "is internal")

    def test_rejects_an_internal_header_of_another_room(self):
        self.rejects({"solvers/internal/a.hpp": "", "iga/b.cpp": '#include "solvers/internal/a.hpp"\n'},
                     "iga/b.cpp:1", "is internal to solvers")

    def test_accepts_the_rooms_of_a_library_in_order(self):
        self.accepts({
            "iga/internal/loop.hpp": "#include <omp.h>\n",
            "iga/spaces/a.hpp": "",
            "iga/spaces/internal/table.hpp": "",
            "iga/solution/b.hpp": '#include "iga/spaces/a.hpp"\n',
            "iga/solution/b.cpp": '#include "iga/internal/loop.hpp"\n#include "iga/solution/b.hpp"\n'
                                  '#include "iga/spaces/internal/table.hpp"\n',
            "iga/tests/b_test.cpp": '#include "iga/solution/b.hpp"\n',
            "app/pages/c.hpp": '#include "iga/solution/b.hpp"\n',
        })

    def test_rejects_a_room_above_in_the_same_library(self):
        self.rejects({"iga/solution/a.hpp": "", "iga/spaces/b.hpp": '#include "iga/solution/a.hpp"\n'},
                     "iga/spaces/b.hpp:2", "iga/spaces may not include iga/solution")

    def test_rejects_an_internal_header_of_another_library(self):
        self.rejects({"iga/spaces/internal/a.hpp": "",
                      "app/run/b.hpp": "", "app/run/b.cpp": '#include "iga/spaces/internal/a.hpp"\n'},
                     "app/run/b.cpp:1", "is internal to iga")

    def test_rejects_a_library_of_another_room(self):
        self.rejects({"iga/a.cpp": "#include <vtkPoints.h>\n"}, "iga/a.cpp:1", "iga may not include VTK")

    def test_rejects_an_unknown_library(self):
        self.rejects({"iga/a.cpp": "#include <boost/any.hpp>\n"}, "iga/a.cpp:1", "belongs to no known library")

    def test_rejects_decompositions_that_are_compiled_elsewhere(self):
        self.rejects({"iga/a.cpp": "#include <Eigen/Eigenvalues>\n"}, "iga/a.cpp:1", "dense_matrices.hpp")
        self.rejects({"iga/a.cpp": "#include <Eigen/Dense>\n"}, "iga/a.cpp:1", "dense_matrices.hpp")
        self.accepts({"geometry/base/dense_matrices.cpp": "#include <Eigen/Eigenvalues>\n",
                      "iga/a.cpp": "#include <Eigen/Geometry>\n"})

    def test_rejects_an_include_relative_to_the_file(self):
        self.rejects({"iga/a.hpp": "", "iga/b.cpp": '#include "a.hpp"\n'}, "iga/b.cpp:1",
                     'must be spelled from the root: "iga/a.hpp"')

    def test_rejects_a_file_that_does_not_exist(self):
        self.rejects({"iga/b.cpp": '#include "iga/a.hpp"\n'}, "iga/b.cpp:1", "is no file of the tree")

    def test_rejects_a_circle_of_files(self):
        self.rejects({"iga/a.hpp": '#include "iga/b.hpp"\n', "iga/b.hpp": '#include "iga/c.hpp"\n',
                      "iga/c.hpp": '#include "iga/a.hpp"\n'}, "iga/a.hpp:1",
                     "iga/a.hpp -> iga/b.hpp -> iga/c.hpp -> iga/a.hpp")

    def test_rejects_a_circle_through_sources(self):
        self.rejects({"iga/a.hpp": "", "iga/a.cpp": '#include "iga/a.hpp"\n#include "iga/b.hpp"\n', "iga/b.hpp": "",
                      "iga/b.cpp": '#include "iga/a.hpp"\n'},
                     "iga/a:1", "headers and their sources include each other in a circle: iga/a -> iga/b -> iga/a")

    def test_takes_headers_in_internal_with_their_sources(self):
        self.rejects({"iga/internal/a.hpp": '#include "iga/internal/b.hpp"\n', "iga/internal/b.hpp": "",
                      "iga/b.cpp": '#include "iga/internal/b.hpp"\n#include "iga/internal/a.hpp"\n'},
                     "iga/a:1", "headers and their sources include each other in a circle: iga/a -> iga/b -> iga/a")

    def test_rejects_a_circle_of_folders(self):
        self.rejects({"iga/x/a.hpp": '#include "iga/y/a.hpp"\n', "iga/y/a.hpp": "", "iga/y/b.hpp":
                      '#include "iga/x/b.hpp"\n', "iga/x/b.hpp": ""}, "iga/x:1", "iga/x -> iga/y -> iga/x")

    def test_rejects_a_header_without_pragma_once(self):
        self.rejects({"iga/a.hpp": "", "iga/b.cpp": ""} | {"iga/c.h": "#pragma once\n"}, "iga/c.h:1",
                     "headers end in .hpp")
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "iga").mkdir()
            (pathlib.Path(folder) / "iga/a.hpp").write_text("// #pragma once\n")
            done = subprocess.run([sys.executable, CHECK_LAYERS, "--root", folder], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (1, "iga/a.hpp:1: #pragma once is missing\n"))

    def test_rejects_a_source_without_a_header_of_its_name(self):
        code, output = run({"iga/spaces/a.cpp": "", "iga/spaces/internal/b.hpp": "", "iga/spaces/b.cpp": "",
                            "iga/tests/c.cpp": "", "app/program/main.cpp": ""}, with_headers=False)
        self.assertEqual((code, output), (1, "iga/spaces/a.cpp:1: has no header of its name\n"))

    def test_rejects_a_header_that_the_table_of_its_folder_lacks(self):
        table = "# iga\n\n| header | what |\n|---|---|\n| `a`, `b.hpp` | both |\n"
        self.accepts({"iga/README.md": table, "iga/a.hpp": "", "iga/b.hpp": "", "iga/internal/c.hpp": "",
                      "iga/tests/d.hpp": ""})
        self.rejects({"iga/README.md": table, "iga/a.hpp": "", "iga/c.hpp": ""}, "iga/README.md:3",
                     "the table of headers lacks c")
        self.accepts({"iga/README.md": "Words alone.\n", "iga/c.hpp": ""})

    def test_rejects_a_folder_that_is_no_room(self):
        self.rejects({"tools/a.hpp": ""}, "tools/a.hpp:1", "lies in no room")

    def test_rejects_judges_that_forget_nan(self):
        for text in ("x = y.maxCoeff();", "x = y.minCoeff(&i);", "worst = std::max(worst, x);",
                     "  a.b =\n  std::max(\n  a.b, x);", "worst = std::max(f(x), worst);", "std::max({a, b})",
                     "low = std::min(low, x);", "w[1] = std::fmax(w[1], x);", "*std::max_element(a.begin(), a.end())",
                     "std::ranges::max(values)", "std::ranges::min_element(values)", "y.lpNorm<Eigen::Infinity>()",
                     "std::minmax({a, b})"):
            self.rejects({"verification/suites/a.cpp": text + "\n"}, "verification/suites/a.cpp:1", "forgets NaN")
            self.rejects({"iga/tests/a.cpp": text + "\n"}, "iga/tests/a.cpp:1", "forgets NaN")
            self.rejects({"app/compare/compare_levels.cpp": text + "\n"}, "app/compare/compare_levels.cpp:1",
                         "forgets NaN")
            self.accepts({"iga/a.cpp": text + "\n"})
        self.accepts({"iga/tests/a.cpp": "x = std::max(y, 0); z = a.maxCoeff<Eigen::PropagateNaN>();\n"
                                           "low = std::min(a, b); pair = std::minmax(a, b);\n"})

    def test_rejects_tests_that_any_error_satisfies(self):
        for text in ("EXPECT_THROW(f(), Error);", "ASSERT_THROW(f({1, 2}),\n             geometry::SolidError);",
                     "EXPECT_NO_THROW(f());", "EXPECT_ANY_THROW(f());"):
            self.rejects({"iga/tests/a.cpp": text + "\n"}, "iga/tests/a.cpp:1", "does not say which error")
        self.accepts({"iga/tests/a.cpp": 'EXPECT_ERROR(f(), ErrorCode::io, "x"); EXPECT_THROW(f(), std::range_error);\n'
                                         "f(); // an Error\n"})

    def test_rejects_an_empty_tree(self):
        self.assertEqual(run({"README.md": ""})[0], 1)

    def test_accepts_models_and_readers_in_tests(self):
        self.accepts({"geometry/models/a.hpp": "", "geometry/io/a.hpp": "",
                      "iga/tests/a.cpp": '#include <gtest/gtest.h>\n#include "geometry/models/a.hpp"\n'
                                         '#include "geometry/io/a.hpp"\n'})

    def test_rejects_tests_in_a_library(self):
        self.rejects({"iga/tests/a.hpp": "", "iga/b.cpp": '#include "iga/tests/a.hpp"\n'}, "iga/b.cpp:1",
                     "belongs to the tests of iga")


if __name__ == "__main__":
    unittest.main()

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/processor_stopwatch.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/mesh/mend.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"
#include "segmentation/reconstruction/tests/triangulated.hpp"

namespace isopatch::segmentation {
namespace {

/// Rows for scripts/reconstruction_table, to the standard output; with ONLY=model in the environment what was
/// missed, to the error output.
TEST(Reconstruction, DISABLED_TableOfTheReadme) {
  const char* data = std::getenv("ISOPATCH_DATA");
  const char* only = std::getenv("ONLY");
  ASSERT_NE(data, nullptr);
  ReconstructionOptions options;
  if (const char* given = std::getenv("TOLERANCE")) options.tolerance = std::stod(given);
  for (const char* name :
       {"block", "wedge_ok", "cylinder", "block_through_hole", "block_fillet1", "block_torus_fillet3",
        "three_concave_edge", "123091_2ebff124_3", "7-connected", "conjoined_twins", "cuboid_screw_thread",
        "cuboid_torus_with_step", "screw", "mambo_s34", "component8", "pipe_helix", "linkrods"}) {
    const bool other = only != nullptr && std::filesystem::path(only).extension() == ".step";
    if (only != nullptr && std::string(only) != name && !other) continue;
    const std::filesystem::path file =
        other ? std::filesystem::path(only)
              : std::filesystem::path(data) / "models" / (std::string(name) + ".step");
    const geometry::Brep brep = geometry::read_brep(file).brep;
    std::string cells, details;
    int faces = 0, solids = 0;
    for (const auto& [chord, turn] : {std::pair(1e-2, 28.0), std::pair(1e-3, 12.0), std::pair(1e-4, 5.0)}) {
      const test::Triangulated truth = test::triangulated(brep, chord, turn);
      const geometry::TriangleMesh mesh = geometry::mended(truth.mesh, 0).mesh;
      const ProcessorStopwatch watch;
      const Regions regions = find_regions(mesh, options);
      faces = truth.faces;
      cells += fmt::format(" | {}", test::faces_found(truth, mesh, regions));
      details +=
          fmt::format("{}: {} t, {} regions, {:.2f} s{}\n", name, mesh.triangles.cols(),
                      regions.regions.size(), watch.seconds(), test::missed(brep, truth, mesh, regions));
      try {
        const Reconstruction made = reconstruct(truth.mesh, options);
        const double off = made.report.volume / brep.volume() - 1;
        solids += std::abs(off) < 1e-5;
        details += fmt::format("  volume off {:.1e}, parallel {} coaxial {} equal {}\n", off,
                               made.report.regularity.parallel, made.report.regularity.coaxial,
                               made.report.regularity.equal);
      } catch (const Error& error) {
        details += fmt::format("  {}\n", error.what());
      }
    }
    std::cout << fmt::format("row | {} | {}{} | {}", name, faces, cells, solids) << std::endl;
    if (only != nullptr) std::cerr << details;
    if (other) break;
  }
}

}  // namespace
}  // namespace isopatch::segmentation

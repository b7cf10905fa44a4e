#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "segmentation/parameterization/parameterize.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/gismo_solids.hpp"

namespace isopatch::segmentation {
namespace {

std::string folder() {
  const char* data = std::getenv("ISOPATCH_DATA");
  return (data ? std::string(data) : std::string(ISOPATCH_SOURCE_DIR "/../shared/data")) + "/chair_stand/solids";
}

TEST(ChairStand, Explore) {
  if (!std::filesystem::exists(folder())) GTEST_SKIP() << folder();
  const test::ChairStand chair = test::chair_stand(folder());
  for (const auto& block : chair.blocks) {
    fmt::print("{}\n", block.name);
    for (const auto& face : block.faces) {
      const FaceMap blend(face);
      std::fflush(stdout); fmt::print("  {} sine {:.3f}\n", face.name, smallest_sine(blend));
    }
  }
  const HexComplex complex = hex_complex(chair.blocks, chair.pairs, {.same_point = 0.04});
  fmt::print("size {} v {} e {} f {} sheets {}\n", complex.size, complex.vertices.size(), complex.edges.size(), complex.faces.size(), complex.sheets.size());
  for (const auto& face : complex.faces) if (face.uses.size() > 1) fmt::print("gap {:.2e} {} {}\n", face.gap, complex.label(face.uses[0].side), complex.label(face.uses[1].side));
  for (std::size_t e = 0; e < complex.edges.size(); ++e) if (!complex.edges[e].surfaces_meet) fmt::print("edge {} does not meet\n", e);
  ParameterizationOptions options; options.optimize = std::getenv("OPT") != nullptr;
  const Parameterization result = parameterize(complex, options);
  for (const auto& p : result.report.patches) fmt::print("{} sign {} lower {:.3g} SJ {:.3f} {:.3f} cps {} before {} moved {}\n", p.name, int(p.certificate.sign), p.certificate.lower, p.quality.min_scaled_jacobian, p.quality.mean_scaled_jacobian, p.control_points, p.certified_before, p.moved);
  for (const auto& f : result.report.faces) fmt::print("{} dev {:.2e} gap {:.2e} {}\n", f.name, f.deviation, f.gap, name(f.kind));
  for (const auto& c : result.report.complaints()) fmt::print("{}\n", c);
  fmt::print("rounds {} evals {} s {:.2f}\n", result.report.rounds, result.report.evaluations, result.report.seconds);
}

TEST(ChairStand, ExploreBrep) {
  if (!std::filesystem::exists(folder())) GTEST_SKIP() << folder();
  BlockFiles files;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) if (entry.path().extension() == ".xml") files.files.push_back(entry.path());
  std::sort(files.files.begin(), files.files.end());
  if (!std::getenv("FREE")) files.pairs = folder() + "/segmented_objStandFiveParts_pairs.txt";
  const HexComplex complex = read_blocks(files);
  fmt::print("size {} v {} e {} f {} sheets {}\n", complex.size, complex.vertices.size(), complex.edges.size(), complex.faces.size(), complex.sheets.size());
  for (const auto& face : complex.faces) if (face.uses.size() > 1) fmt::print("gap {:.2e} {} {}\n", face.gap, complex.label(face.uses[0].side), complex.label(face.uses[1].side));
  for (std::size_t e = 0; e < complex.edges.size(); ++e) if (!complex.edges[e].surfaces_meet) fmt::print("edge {} does not meet\n", e);
  const Parameterization result = parameterize(complex);
  for (const auto& p : result.report.patches) fmt::print("{} sign {} lower {:.3g} SJ {:.3f} {:.3f} cps {} before {} moved {}\n", p.name, int(p.certificate.sign), p.certificate.lower, p.quality.min_scaled_jacobian, p.quality.mean_scaled_jacobian, p.control_points, p.certified_before, p.moved);
  fmt::print("worst dev {:.2e}\n", result.report.worst_face().deviation);
  for (const auto& c : result.report.complaints()) fmt::print("{}\n", c);
  fmt::print("rounds {} evals {} s {:.2f}\n", result.report.rounds, result.report.evaluations, result.report.seconds);
}

}  // namespace
}  // namespace isopatch::segmentation

#include "app/problem/cut_solids.hpp"

#include <fmt/format.h>

#include <utility>

#include "segmentation/decomposition/blocks.hpp"

namespace isopatch::app {
namespace {

std::string number_of(int number, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

}  // namespace

CutSolids cut_solids(const BlocksInput& input, const Progress& progress) {
  segmentation::ReadSolids read = segmentation::read_solids(input.files, progress);
  CutSolids result;
  result.warnings = std::move(read.warnings);
  for (geometry::BrepFile& body : read.solids) {
    CutBody cut{body.name, 1, {}};
    if (segmentation::is_hexahedron(body.brep)) {
      result.blocks.push_back(body);
    } else {
      const segmentation::Decomposition decomposition =
          segmentation::decompose(body.brep, body.name, *input.decomposition, progress);
      cut.report = decomposition.report;
      std::vector<geometry::BrepFile> parts = segmentation::blocks(body, decomposition);
      cut.blocks = static_cast<int>(parts.size());
      for (geometry::BrepFile& part : parts) result.blocks.push_back(std::move(part));
    }
    result.bodies.insert(result.bodies.end(), static_cast<std::size_t>(cut.blocks), body.name);
    result.cuts.push_back(std::move(cut));
  }
  return result;
}

std::string cutting_text(const CutSolids& solids) {
  std::string text;
  for (const CutBody& body : solids.cuts) {
    const segmentation::DecompositionReport& report = body.report;
    if (report.cells == 0) {
      text += fmt::format("  {}: a topological hexahedron as it is\n", body.name);
      continue;
    }
    text += fmt::format("  {}: {} into {}, {} where sides meet in parts", body.name,
                        number_of(report.cuts, "cut", "cuts"), number_of(report.cells, "part", "parts"),
                        number_of(report.t_joints, "place", "places"));
    if (report.by_tetrahedra)
      text += "; all parts divided into tetrahedra, since cuts did not end in sides that meet";
    else if (report.further_cuts > 0)
      text += fmt::format(", closed by {}", number_of(report.further_cuts, "further cut", "further cuts"));
    text += fmt::format("; {} ({:.1f} s)\n", number_of(report.hexahedra, "hexahedron", "hexahedra"),
                        report.seconds);
  }
  return text;
}

}  // namespace isopatch::app

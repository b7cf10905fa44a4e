#include "app/problem/reconstructed_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/study/file_kind.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/read_triangles.hpp"

namespace isopatch::app {
namespace {

bool holds_triangles(const std::filesystem::path& file) {
  return kind_of(file) == FileKind::triangles;
}

}  // namespace

geometry::TriangleMesh in_metres(geometry::MeasuredTriangles read, std::optional<double> length_unit) {
  const double metres = length_unit.value_or(read.metres.value_or(1));
  read.mesh.vertices *= metres;
  read.mesh.grain *= metres;
  return std::move(read.mesh);
}

geometry::TriangleMesh triangles_in_metres(const std::filesystem::path& file,
                                           std::optional<double> length_unit) {
  return in_metres(geometry::read_triangles(file), length_unit);
}

segmentation::Reconstruction reconstructed(const std::filesystem::path& file,
                                           std::optional<double> length_unit,
                                           const segmentation::ReconstructionOptions& options,
                                           const Progress& progress) {
  progress("reading the triangles", 0);
  geometry::MeasuredTriangles read = geometry::read_triangles(file);
  const bool is_unit_known = length_unit || read.metres;
  const geometry::TriangleMesh mesh = in_metres(std::move(read), length_unit);
  try {
    segmentation::Reconstruction made = segmentation::reconstruct(mesh, options, progress);
    if (!is_unit_known)
      made.report.remarks.push_back(fmt::format(
          "the file states no unit of length, so one unit is taken as 1 m and the part is {:.3g} m "
          "across; length_unit = \"mm\" (--length-unit mm) says otherwise",
          made.brep.size()));
    return made;
  } catch (const Error& error) {
    throw ReconstructionError(error.code(), fmt::format("{}: {}", file.string(), error.what()));
  }
}

FoundSolids solids_of_files(const BlocksInput& input, const Progress& progress) {
  const auto& files = input.files.files;
  if (std::none_of(files.begin(), files.end(), holds_triangles))
    return {segmentation::read_solids(input.files, progress)};
  FoundSolids found;
  segmentation::ReadSolids& result = found.read;
  segmentation::BlockNames names;
  for (const std::filesystem::path& file : files) {
    segmentation::BlockFiles one = input.files;
    one.files = {file};
    segmentation::ReadSolids read;
    if (holds_triangles(file)) {
      segmentation::Reconstruction made =
          reconstructed(file, input.files.length_unit, input.reconstruction, progress);
      read.solids.push_back({std::move(made.brep), file.stem().string(), 0});
      found.triangles.push_back(
          {"", std::move(made.mesh), std::move(made.regions.of_triangle), made.report.largest_deviation});
      for (const std::string& remark : made.report.remarks)
        read.warnings.push_back(fmt::format("{}: {}", file.string(), remark));
    } else {
      read = segmentation::read_solids(one, progress);
    }
    result.warnings.insert(result.warnings.end(), read.warnings.begin(), read.warnings.end());
    for (geometry::BrepFile& solid : read.solids) {
      solid.name = names.add(solid.name);
      if (holds_triangles(file)) found.triangles.back().solid = solid.name;
      result.solids.push_back(std::move(solid));
    }
  }
  return found;
}

}  // namespace isopatch::app

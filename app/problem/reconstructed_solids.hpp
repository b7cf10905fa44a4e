#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/study/blocks_input.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/progress.hpp"
#include "geometry/io/measured_triangles.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {

/// Triangles with lengths in metres.
/// @param length_unit  m of one unit of their file; without it what the file says (3MF), or 1
geometry::TriangleMesh in_metres(geometry::MeasuredTriangles read, std::optional<double> length_unit);

/// The triangles of a file, as `in_metres` gives them.
/// @throws Error as `geometry::read_triangles` does
geometry::TriangleMesh triangles_in_metres(const std::filesystem::path& file,
                                           std::optional<double> length_unit);

/// Why no solid could be made of triangles.
class ReconstructionError : public Error {
 public:
  using Error::Error;
};

/// The solid that a file of triangles was made of; lengths are metres.
/// @param length_unit  m of one unit of the file; without it what the file says (3MF), or 1, of which a
/// remark
///                     tells
/// @throws Error as `geometry::read_triangles` does; ReconstructionError as `segmentation::reconstruct`, with
/// the file's name
segmentation::Reconstruction reconstructed(const std::filesystem::path& file,
                                           std::optional<double> length_unit,
                                           const segmentation::ReconstructionOptions& options,
                                           const Progress& progress = {});

/// The triangles that a solid was made of.
struct SolidTriangles {
  std::string solid;            ///< its name
  geometry::TriangleMesh mesh;  ///< mended, m
  std::vector<int> faces;       ///< by triangle, the solid's face that it lies on
  double deviation = 0;         ///< m, largest distance of a vertex from the solid's surface
};

/// Solids of files, and the triangles of those that were made of such.
struct FoundSolids {
  segmentation::ReadSolids read;
  std::vector<SolidTriangles> triangles = {};
};

/// The solids of files, of which some may hold triangles: those are reconstructed, and warnings say how well.
/// @throws Error as `segmentation::read_solids` and `reconstructed` do
FoundSolids solids_of_files(const BlocksInput& input, const Progress& progress = {});

}  // namespace isopatch::app

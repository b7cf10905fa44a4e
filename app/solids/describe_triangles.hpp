#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/results/load_input.hpp"
#include "geometry/base/progress.hpp"
#include "segmentation/decomposition/prospect.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {

/// What a file of triangles is and what would become of it. Lengths in m.
struct TriangleReport {
  std::int64_t triangles = 0;  ///< of the file
  std::int64_t vertices = 0;   ///< places that differ
  Eigen::AlignedBox3d box;
  std::string unit;                   ///< of the file: "mm", "m, since the file states none"
  double area = 0;                    ///< m^2
  std::optional<double> volume = {};  ///< m^3; nothing where the triangles bound no solid
  /// The solid that would be made of them, or why there is none.
  std::optional<segmentation::Reconstruction> made = {};
  std::optional<Error> failure = {};
  /// What cutting that solid would mean; nothing for a topological hexahedron.
  std::optional<segmentation::Prospect> prospect = {};
};

/// Reads the triangles and makes a solid of them, with the options of a study without [reconstruction].
/// @throws Error as `geometry::read_triangles` does; invalid_argument for a length unit that is none
/// @cost  that of `reconstruct`
TriangleReport triangle_report(const InputFile& input, const Progress& progress = {});

/// What `isopatch info` prints of it.
std::string triangles_text(const TriangleReport& report);
/// The same as JSON, SI units.
std::string triangles_json_text(const TriangleReport& report);

}  // namespace isopatch::app

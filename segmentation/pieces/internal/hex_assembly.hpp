#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/brep/cell_complex.hpp"

namespace isopatch::segmentation {

/// Hexahedra by their corners, as a complex: edges are straight but where others are given, sides plane where
/// their edges are, Coons patches elsewhere.
class HexAssembly {
 public:
  /// @param tolerance  m, of what is plane
  explicit HexAssembly(double tolerance) : tolerance_(tolerance) {}

  int add_vertex(const Eigen::Vector3d& place);
  const Eigen::Vector3d& vertex(int number) const { return places_[static_cast<std::size_t>(number)]; }
  /// Before any hexahedron that has it.
  void set_edge(int from, int to, geometry::NurbsCurve curve);
  /// @param corners  four around one side, and those opposite to them: the first, its two neighbours among
  /// the four and its opposite are right-handed
  void add(const std::array<int, 8>& corners);
  /// @param origin  of a side that one hexahedron has, by a point in its middle
  geometry::CellComplex make(
      const std::function<std::optional<FaceId>(const Eigen::Vector3d& place)>& origin) const;

 private:
  double tolerance_;
  std::vector<Eigen::Vector3d> places_;
  std::map<std::pair<int, int>, geometry::NurbsCurve> curves_;
  std::vector<std::array<int, 8>> cells_;
};

}  // namespace isopatch::segmentation

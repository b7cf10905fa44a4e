#include "app/pictures/clip.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace isopatch::app {
namespace {

/// A point of the surface or of the inside with all that it carries.
struct Vertex {
  Eigen::Vector3d point;
  Eigen::Vector3d undeformed;
  Eigen::Vector3d normal;
  double value;
  double height;  ///< above the cut; kept if not positive
};

Vertex between(const Vertex& a, const Vertex& b) {
  const double share = a.height / (a.height - b.height);
  const auto mix = [share](const auto& x, const auto& y) { return (x + share * (y - x)).eval(); };
  return {mix(a.point, b.point), mix(a.undeformed, b.undeformed), mix(a.normal, b.normal).normalized(),
          a.value + share * (b.value - a.value), 0};
}

bool kept(const Vertex& vertex) {
  return vertex.height <= 0;
}

Vertex vertex_of(const Surface& surface, int i, const Cut& cut) {
  return {surface.points.col(i), surface.undeformed.col(i), surface.normals.col(i), surface.values[i],
          surface.undeformed(cut.axis, i) - cut.position};
}

/// Each two ends are a line.
Lines lines_between(const std::vector<Vertex>& ends) {
  Lines result;
  result.points.resize(3, static_cast<Eigen::Index>(ends.size()));
  result.undeformed.resize(3, static_cast<Eigen::Index>(ends.size()));
  for (std::size_t i = 0; i < ends.size(); ++i) {
    result.points.col(static_cast<Eigen::Index>(i)) = ends[i].point;
    result.undeformed.col(static_cast<Eigen::Index>(i)) = ends[i].undeformed;
    if (i % 2 == 1) result.segments.push_back({static_cast<int>(i) - 1, static_cast<int>(i)});
  }
  return result;
}

/// A surface as it grows.
class SurfaceBuilder {
 public:
  /// A convex polygon.
  void add(const std::vector<Vertex>& corners) {
    const auto first = static_cast<int>(vertices_.size());
    vertices_.insert(vertices_.end(), corners.begin(), corners.end());
    for (int i = 2; i < static_cast<int>(corners.size()); ++i)
      triangles_.push_back({first, first + i - 1, first + i});
  }
  Surface surface() const {
    const auto count = static_cast<Eigen::Index>(vertices_.size());
    Surface result{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count),
                   Eigen::VectorXd(count), triangles_};
    for (Eigen::Index i = 0; i < count; ++i) {
      const Vertex& vertex = vertices_[static_cast<std::size_t>(i)];
      result.points.col(i) = vertex.point;
      result.undeformed.col(i) = vertex.undeformed;
      result.normals.col(i) = vertex.normal;
      result.values[i] = vertex.value;
    }
    return result;
  }

 private:
  std::vector<Vertex> vertices_;
  std::vector<std::array<int, 3>> triangles_;
};

/// The kept part of a convex polygon.
std::vector<Vertex> kept_part(const std::vector<Vertex>& corners) {
  std::vector<Vertex> result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vertex& here = corners[i];
    const Vertex& next = corners[(i + 1) % corners.size()];
    if (kept(here)) result.push_back(here);
    if (kept(here) != kept(next)) result.push_back(between(here, next));
  }
  return result;
}

/// Where the plane cuts a tetrahedron: three or four points around their polygon.
std::vector<Vertex> cut_polygon(const std::array<Vertex, 4>& corners) {
  std::vector<const Vertex*> below;
  std::vector<const Vertex*> above;
  for (const Vertex& corner : corners) (kept(corner) ? below : above).push_back(&corner);
  std::vector<Vertex> polygon;
  for (std::size_t i = 0; i < below.size(); ++i)
    for (std::size_t j = 0; j < above.size(); ++j) {
      const bool backwards = below.size() == 2 && i == 1;  // around, not across
      polygon.push_back(between(*below[i], *above[backwards ? above.size() - 1 - j : j]));
    }
  return polygon;
}

/// The six tetrahedra of a cell around its long diagonal; corner c lies at (c & 1, c >> 1 & 1, c >> 2).
constexpr std::array<std::array<int, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// @param round_off  less than this above or below the cut is on it
std::array<Vertex, 8> cell(const PatchShape& patch, int i, int j, int k, const Cut& cut, double round_off) {
  std::array<Vertex, 8> corners;
  for (int c = 0; c < 8; ++c) {
    const int at = patch.index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
    const double above = patch.undeformed(cut.axis, at) - cut.position;
    const double height = std::abs(above) < round_off ? 0 : above;
    corners[static_cast<std::size_t>(c)] = {patch.points.col(at), patch.undeformed.col(at),
                                            Eigen::Vector3d::Unit(cut.axis), patch.values[at], height};
  }
  return corners;
}

/// Twice the area of a polygon in the undeformed part, positive if counter-clockwise from the far end of an
/// axis.
double area_along(const std::vector<Vertex>& polygon, int axis) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 2; i < polygon.size(); ++i)
    sum += (polygon[i - 1].undeformed - polygon[0].undeformed)
               .cross(polygon[i].undeformed - polygon[0].undeformed);
  return sum[axis];
}

void add_sections(SurfaceBuilder& builder, const std::array<Vertex, 8>& corners, int axis) {
  for (const auto& four : tetrahedra) {
    const auto corner = [&](std::size_t i) { return corners[static_cast<std::size_t>(four[i])]; };
    std::vector<Vertex> polygon = cut_polygon({corner(0), corner(1), corner(2), corner(3)});
    const double area = area_along(polygon, axis);
    if (area == 0) continue;
    if (area < 0) std::reverse(polygon.begin(), polygon.end());
    builder.add(polygon);
  }
}

bool is_cut(const std::array<Vertex, 8>& corners) {
  int below = 0;
  for (const Vertex& corner : corners) below += kept(corner) ? 1 : 0;
  return below > 0 && below < 8;
}

}  // namespace

Surface clipped(const Surface& surface, const Cut& cut) {
  SurfaceBuilder builder;
  for (const auto& triangle : surface.triangles) {
    const std::vector<Vertex> polygon =
        kept_part({vertex_of(surface, triangle[0], cut), vertex_of(surface, triangle[1], cut),
                   vertex_of(surface, triangle[2], cut)});
    if (polygon.size() >= 3) builder.add(polygon);
  }
  return builder.surface();
}

Lines clipped(const Lines& lines, const Cut& cut) {
  std::vector<Vertex> ends;
  const auto vertex = [&](int i) {
    return Vertex{lines.points.col(i), lines.undeformed.col(i), Eigen::Vector3d::UnitX(), 0,
                  lines.undeformed(cut.axis, i) - cut.position};
  };
  for (const auto& segment : lines.segments) {
    const Vertex first = vertex(segment[0]);
    const Vertex second = vertex(segment[1]);
    if (!kept(first) && !kept(second)) continue;
    ends.push_back(kept(first) ? first : between(first, second));
    ends.push_back(kept(second) ? second : between(first, second));
  }
  return lines_between(ends);
}

Lines cut_outline(const Surface& surface, const Cut& cut) {
  std::vector<Vertex> ends;
  for (const auto& triangle : surface.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex here = vertex_of(surface, triangle[i], cut);
      const Vertex next = vertex_of(surface, triangle[(i + 1) % 3], cut);
      if (kept(here) != kept(next)) ends.push_back(between(here, next));  // two sides of a triangle or none
    }
  return lines_between(ends);
}

Surface section(const std::vector<PatchShape>& shape, const Cut& cut) {
  SurfaceBuilder builder;
  for (const PatchShape& patch : shape) {
    const auto along = patch.undeformed.row(cut.axis);
    const double round_off = 1e-9 * (along.maxCoeff() - along.minCoeff());
    for (int k = 0; k + 1 < patch.sizes[2]; ++k)
      for (int j = 0; j + 1 < patch.sizes[1]; ++j)
        for (int i = 0; i + 1 < patch.sizes[0]; ++i) {
          const auto corners = cell(patch, i, j, k, cut, round_off);
          if (is_cut(corners)) add_sections(builder, corners, cut.axis);
        }
  }
  return builder.surface();
}

}  // namespace isopatch::app

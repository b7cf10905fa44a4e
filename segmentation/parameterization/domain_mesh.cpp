#include "segmentation/parameterization/internal/domain_mesh.hpp"

#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {
namespace {

using Place = std::array<double, 3>;

/// The numbers of points by where they are.
std::map<Place, int> numbers_of(const Eigen::Matrix3Xd& points) {
  std::map<Place, int> result;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result[{points(0, i), points(1, i), points(2, i)}] = static_cast<int>(i);
  return result;
}

/// All around: the sides, and whether they are walked from their ends.
constexpr std::array<std::pair<int, bool>, 4> way_around = {{{0, false}, {3, false}, {1, true}, {2, true}}};

/// The points of the outline with their numbers among the library's, in order.
struct Outline {
  std::vector<OutlinePoint> points;
  std::vector<int> numbers;
};

std::optional<Outline> outline_of(const geometry::FaceTriangles& triangles,
                                  const std::array<SidePoints, 4>& side_points) {
  const std::map<Place, int> known = numbers_of(triangles.points);
  Outline result;
  for (const auto& [side, from_end] : way_around) {
    const SidePoints& given = side_points[static_cast<std::size_t>(side)];
    const Eigen::Index count = given.points.cols();
    for (Eigen::Index k = 0; k + 1 < count; ++k) {
      const Eigen::Index i = from_end ? count - 1 - k : k;
      const auto found = known.find({given.points(0, i), given.points(1, i), given.points(2, i)});
      if (found == known.end()) return std::nullopt;
      result.points.push_back({side, given.t[i]});
      result.numbers.push_back(found->second);
    }
  }
  return result;
}

double doubled_area_of(const DomainMesh& mesh, const std::array<int, 3>& t) {
  const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(t[k])]; };
  return doubled_area(at(0), at(1), at(2));
}

/// Turns triangles as the outline is; whether all are so, and fill its polygon.
bool turned_like_outline(DomainMesh& mesh) {
  const std::size_t n = mesh.outline.size();
  double polygon = 0, sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    polygon += doubled_area(mesh.points[0], mesh.points[i], mesh.points[(i + 1) % n]);
  for (const auto& t : mesh.triangles) sum += doubled_area_of(mesh, t);
  if (sum * polygon < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  for (const auto& t : mesh.triangles)
    if (!(doubled_area_of(mesh, t) * polygon > 0)) return false;
  return std::abs(std::abs(sum) - std::abs(polygon)) < 1e-6 * std::abs(polygon);
}

/// Whether the edges of one triangle are those of the outline, in its order.
bool is_bounded_by_outline(const DomainMesh& mesh) {
  std::set<std::pair<int, int>> open;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) open.insert({t[k], t[(k + 1) % 3]});
  const int n = static_cast<int>(mesh.outline.size());
  int found = 0, single = 0;
  for (int i = 0; i < n; ++i) found += open.contains({i, (i + 1) % n});
  for (const auto& [a, b] : open) single += !open.contains({b, a});
  return found == n && single == n;
}

}  // namespace

std::optional<DomainMesh> domain_mesh(const geometry::FaceTriangles& triangles,
                                      const std::array<SidePoints, 4>& side_points,
                                      const std::array<DomainCurve, 4>& sides) {
  const std::optional<Outline> outline = outline_of(triangles, side_points);
  if (!outline) return std::nullopt;
  DomainMesh mesh{{}, outline->points, {}};
  std::vector<int> number(static_cast<std::size_t>(triangles.points.cols()), -1);
  for (std::size_t i = 0; i < outline->numbers.size(); ++i) {
    const OutlinePoint& point = outline->points[i];
    number[static_cast<std::size_t>(outline->numbers[i])] = static_cast<int>(i);
    mesh.points.push_back(sides[static_cast<std::size_t>(point.side)](point.t));
  }
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] >= 0) continue;
    number[i] = static_cast<int>(mesh.points.size());
    mesh.points.push_back(triangles.uv.col(static_cast<Eigen::Index>(i)));
  }
  for (const auto& t : triangles.triangles.colwise())
    mesh.triangles.push_back({number[static_cast<std::size_t>(t[0])], number[static_cast<std::size_t>(t[1])],
                              number[static_cast<std::size_t>(t[2])]});
  if (!turned_like_outline(mesh) || !is_bounded_by_outline(mesh)) return std::nullopt;
  return mesh;
}

}  // namespace isopatch::segmentation

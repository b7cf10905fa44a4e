#include "segmentation/reconstruction/internal/without_rounds.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace isopatch::segmentation {
namespace {

using geometry::TriangleSide;

// Normals of one wall are within so many degrees of its slope; the strips of a round are not.
constexpr double slope_step = 5 * 3.14159265358979 / 180;
// Triangles of the wall reach over at least this share of its height.
constexpr double tall = 0.6;
// Of the region's area that is wall, at least: else it is all round.
constexpr double least_wall = 0.15;
constexpr double parallel_within = 1e-6;

/// Triangles between two rows of vertices, around.
struct WallStrip {
  std::vector<int> triangles;
  std::array<std::vector<int>, 2>
      rows;  ///< in turn, as the region's border runs; beside the first plane first
};

/// Triangles that a plane gets where a round was.
struct Ring {
  int plane = 0;
  std::vector<std::array<int, 3>> triangles;
  bool is_sound = true;  ///< none is turned over
};

class RoundRemover {
 public:
  RoundRemover(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
               const Regions& regions)
      : mesh_(mesh), neighbours_(neighbours), regions_(regions), result_{mesh, regions, 0, 0, {}} {}

  WithoutRounds run() {
    const double before = geometry::volume(mesh_);
    for (std::size_t r = 0; r < regions_.regions.size(); ++r)
      if (!regions_.regions[r].carrier) remove(static_cast<int>(r));
    if (result_.removed == 0) return std::move(result_);
    rebuild();
    result_.volume_change = geometry::volume(result_.mesh) - before;
    return std::move(result_);
  }

 private:
  Eigen::Vector3d point(int v) const { return mesh_.vertices.col(v); }
  const Region& region(int r) const { return regions_.regions[static_cast<std::size_t>(r)]; }
  TriangleSide across(int t, int side) const {
    return neighbours_.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(side)];
  }
  int region_of(int t) const { return regions_.of_triangle[static_cast<std::size_t>(t)]; }

  /// The borders of some triangles as loops of vertices that each is once on; nothing if there are others.
  std::optional<std::vector<std::vector<int>>> loops(const std::vector<int>& triangles) const {
    const std::set<int> inside(triangles.begin(), triangles.end());
    std::map<int, int> next;
    for (const int t : triangles)
      for (int i = 0; i < 3; ++i)
        if (!inside.contains(across(t, i).triangle) &&
            !next.emplace(mesh_.triangles(i, t), mesh_.triangles((i + 1) % 3, t)).second)
          return std::nullopt;
    std::vector<std::vector<int>> result;
    while (!next.empty()) {
      std::vector<int> loop;
      for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
        loop.push_back(at->second);
        next.erase(at);
      }
      result.push_back(std::move(loop));
    }
    return result;
  }

  /// The plane that all of a loop of a region lies beside, -1 for none.
  int plane_beside(int r, const std::vector<int>& loop) const {
    const std::set<int> on(loop.begin(), loop.end());
    int result = -1;
    for (const int t : region(r).triangles)
      for (int i = 0; i < 3; ++i) {
        const int other = region_of(across(t, i).triangle);
        if (other == r || !on.contains(mesh_.triangles(i, t))) continue;
        if (result >= 0 && other != result) return -1;
        result = other;
      }
    const auto& carrier = region(result).carrier;
    return carrier && carrier->kind == geometry::SurfaceKind::plane ? result : -1;
  }

  void remove(int r) {
    auto borders = loops(region(r).triangles);
    if (!borders || borders->size() != 2) return;
    const std::array<int, 2> planes{plane_beside(r, (*borders)[0]), plane_beside(r, (*borders)[1])};
    if (planes[0] < 0 || planes[1] < 0 || planes[0] == planes[1]) return;
    const Eigen::Vector3d up = region(planes[0]).carrier->axis;
    if (up.cross(region(planes[1]).carrier->axis).norm() > parallel_within) return;
    const auto strip = wall_strip(r, up, planes);
    if (!strip) return;
    const auto extended = extended_rows(*strip, planes);
    std::vector<Ring> rings;
    for (std::size_t side = 0; side < 2 && extended; ++side)
      if (!is_same(strip->rows[side], (*borders)[side]))
        rings.push_back(ring((*borders)[side], strip->rows[side], *extended, planes[side]));
    if (!extended || !std::all_of(rings.begin(), rings.end(), [](const Ring& one) { return one.is_sound; })) {
      keep(r);
      return;
    }
    result_.removed += static_cast<int>(rings.size());
    rings_.insert(rings_.end(), rings.begin(), rings.end());
    for (const auto& [v, place] : *extended) result_.mesh.vertices.col(v) = place;
    result_.regions.regions[static_cast<std::size_t>(r)].triangles = strip->triangles;
  }

  void keep(int r) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int t : region(r).triangles)
      middle += point(mesh_.triangles(0, t)) / double(region(r).triangles.size());
    result_.kept.push_back(fmt::format(
        "the rounds of the wall around ({:.6g}, {:.6g}, {:.6g}) m stay: without them it does not reach "
        "its planes",
        middle.x(), middle.y(), middle.z()));
  }

  static bool is_same(const std::vector<int>& a, const std::vector<int>& b) {
    return std::set<int>(a.begin(), a.end()) == std::set<int>(b.begin(), b.end());
  }

  /// The slope that most of a region's area has, rad from `up`.
  double slope(int r, const Eigen::Vector3d& up) const {
    std::vector<std::pair<double, double>> all;
    for (const int t : region(r).triangles) {
      const Eigen::Vector3d n = geometry::area_vector(mesh_, t);
      all.emplace_back(std::atan2(n.cross(up).norm(), n.dot(up)), n.norm());
    }
    std::sort(all.begin(), all.end());
    double best = 0, most = 0, sum = 0;
    for (std::size_t first = 0, last = 0; last < all.size(); ++last) {
      sum += all[last].second;
      for (; all[last].first - all[first].first > slope_step / 2; ++first) sum -= all[first].second;
      if (sum <= most) continue;
      most = sum;
      best = (all[first].first + all[last].first) / 2;
    }
    return best;
  }

  double height(int t, const Eigen::Vector3d& up) const {
    double low = 1e300, high = -1e300;
    for (int i = 0; i < 3; ++i) {
      const double at = up.dot(point(mesh_.triangles(i, t)));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    return high - low;
  }

  std::optional<WallStrip> wall_strip(int r, const Eigen::Vector3d& up,
                                      const std::array<int, 2>& planes) const {
    const double steep = slope(r, up);
    WallStrip strip;
    double highest = 0, area = 0;
    const auto is_steep = [&](int t) {
      const Eigen::Vector3d n = geometry::area_vector(mesh_, t);
      return std::abs(std::atan2(n.cross(up).norm(), n.dot(up)) - steep) < slope_step;
    };
    for (const int t : region(r).triangles)
      if (is_steep(t)) highest = std::max(highest, height(t, up));
    for (const int t : region(r).triangles)
      if (is_steep(t) && height(t, up) > tall * highest) {
        strip.triangles.push_back(t);
        area += geometry::area_vector(mesh_, t).norm() / 2;
      }
    if (area < least_wall * region(r).area) return std::nullopt;
    const auto rows = loops(strip.triangles);
    if (!rows || rows->size() != 2) return std::nullopt;
    for (const auto& row : *rows) {
      double middle = 0;
      for (const int v : row) middle += up.dot(point(v)) / double(row.size());
      const std::size_t side = std::abs(middle - up.dot(region(planes[0]).carrier->origin)) <
                                       std::abs(middle - up.dot(region(planes[1]).carrier->origin))
                                   ? 0
                                   : 1;
      strip.rows[side] = row;
    }
    if (strip.rows[0].empty() || strip.rows[1].empty()) return std::nullopt;
    return strip;
  }

  /// Where the vertices of the rows come to lie in their planes.
  std::optional<std::map<int, Eigen::Vector3d>> extended_rows(const WallStrip& strip,
                                                              const std::array<int, 2>& planes) const {
    std::map<int, Eigen::Vector3d> normal;
    for (const int t : strip.triangles) {
      const Eigen::Vector3d n = geometry::area_vector(mesh_, t).normalized();
      for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d a = point(mesh_.triangles((i + 1) % 3, t)) - point(mesh_.triangles(i, t)),
                              b = point(mesh_.triangles((i + 2) % 3, t)) - point(mesh_.triangles(i, t));
        const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
        normal.emplace(mesh_.triangles(i, t), Eigen::Vector3d::Zero()).first->second += angle * n;
      }
    }
    std::map<int, Eigen::Vector3d> result;
    for (std::size_t side = 0; side < 2; ++side) {
      const geometry::Carrier& plane = *region(planes[side]).carrier;
      for (const int v : strip.rows[side]) {
        const Eigen::Vector3d n = normal.at(v).normalized();
        const Eigen::Vector3d steepest = plane.axis - n * n.dot(plane.axis);
        const double rise = steepest.dot(plane.axis);
        if (!(rise > 0.1)) return std::nullopt;
        result[v] = point(v) + steepest * (plane.axis.dot(plane.origin - point(v)) / rise);
      }
    }
    return result;
  }

  /// Triangles between a plane's border and a row that runs beside it, nearest to nearest.
  Ring ring(const std::vector<int>& border, const std::vector<int>& row,
            const std::map<int, Eigen::Vector3d>& extended, int plane) const {
    const auto outer = [&](std::size_t i) { return point(border[i % border.size()]); };
    const auto inner = [&](std::size_t j) { return extended.at(row[j % row.size()]); };
    std::size_t first = 0;
    for (std::size_t j = 1; j < row.size(); ++j)
      if ((inner(j) - outer(0)).norm() < (inner(first) - outer(0)).norm()) first = j;
    const Eigen::Vector3d up = (region(plane).reversed ? -1.0 : 1.0) * region(plane).carrier->axis;
    Ring result{plane, {}, true};
    for (std::size_t i = 0, j = first; i < border.size() || j < first + row.size();) {
      const auto turned_over = [&](const Eigen::Vector3d& third) {
        return !((third - outer(i)).cross(inner(j) - outer(i)).dot(up) > 0);
      };
      const bool first_over = turned_over(outer(i + 1)), second_over = turned_over(inner(j + 1));
      const bool is_shorter = (outer(i + 1) - inner(j)).norm() < (outer(i) - inner(j + 1)).norm();
      const bool along_border = i < border.size() && (j == first + row.size() ||
                                                      (first_over == second_over ? is_shorter : second_over));
      if (along_border ? first_over : second_over) result.is_sound = false;
      result.triangles.push_back({border[i % border.size()],
                                  along_border ? border[(i + 1) % border.size()] : row[(j + 1) % row.size()],
                                  row[j % row.size()]});
      ++(along_border ? i : j);
    }
    return result;
  }

  /// What is left of the triangles, with the rings, and the vertices that these have.
  void rebuild() {
    Regions& regions = result_.regions;
    std::vector<std::array<int, 3>> triangles;
    std::vector<std::vector<std::array<int, 3>>> rings(regions.regions.size());
    for (const Ring& one : rings_) {
      auto& of_plane = rings[static_cast<std::size_t>(one.plane)];
      of_plane.insert(of_plane.end(), one.triangles.begin(), one.triangles.end());
    }
    regions.of_triangle.clear();
    for (std::size_t r = 0; r < regions.regions.size(); ++r) {
      std::vector<int> numbers;
      const auto add = [&](const std::array<int, 3>& triangle) {
        numbers.push_back(static_cast<int>(triangles.size()));
        triangles.push_back(triangle);
        regions.of_triangle.push_back(static_cast<int>(r));
      };
      for (const int t : regions.regions[r].triangles)
        add({mesh_.triangles(0, t), mesh_.triangles(1, t), mesh_.triangles(2, t)});
      for (const auto& triangle : rings[r]) add(triangle);
      regions.regions[r].triangles = std::move(numbers);
    }
    std::vector<int> number(static_cast<std::size_t>(mesh_.vertices.cols()), -1);
    Eigen::Matrix3Xd vertices = result_.mesh.vertices;
    Eigen::Index count = 0;
    result_.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const int v = triangles[t][static_cast<std::size_t>(i)];
        int& known = number[static_cast<std::size_t>(v)];
        if (known < 0) {
          known = static_cast<int>(count);
          vertices.col(count++) = result_.mesh.vertices.col(v);
        }
        result_.mesh.triangles(i, static_cast<Eigen::Index>(t)) = known;
      }
    result_.mesh.vertices = vertices.leftCols(count);
    for (Region& one : regions.regions) {
      one.area = 0;
      for (const int t : one.triangles) one.area += geometry::area_vector(result_.mesh, t).norm() / 2;
    }
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Regions& regions_;
  WithoutRounds result_;
  std::vector<Ring> rings_;
};

}  // namespace

WithoutRounds without_rounds(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                             const Regions& regions) {
  return RoundRemover(mesh, neighbours, regions).run();
}

}  // namespace isopatch::segmentation

#include "segmentation/reconstruction/internal/split_bands.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace isopatch::segmentation {
namespace {

using geometry::TriangleSide;
using MeshEdge = std::pair<int, int>;  // vertices, the lower first

// A loop turns in a place where it does by so much along this share of it.
constexpr double window_share = 0.03;
constexpr double least_turn = 0.5;  // rad
constexpr double least_apart = 0.04;
constexpr std::size_t most_divisions = 4;
constexpr double spacing_change = 4;
// Of its length: a seam's vertices are no farther from the line between its ends.
constexpr double seam_bend = 0.01;
constexpr double parallel = 1e-6;

MeshEdge mesh_edge(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The borders and edges of a region.
class Band {
 public:
  Band(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours, const Regions& regions,
       int region)
      : mesh_(mesh), neighbours_(neighbours), regions_(regions) {
    for (const int t : regions.regions[static_cast<std::size_t>(region)].triangles)
      for (int i = 0; i < 3; ++i) {
        const TriangleSide other = across({t, i});
        const int a = mesh.triangles(i, t), b = mesh.triangles((i + 1) % 3, t);
        const int there = regions.of_triangle[static_cast<std::size_t>(other.triangle)];
        if (there == region) {
          beside_[a].push_back(b);
        } else {
          next_.emplace(a, b);
          beyond_[a] = there;
        }
      }
    std::set<int> done;
    for (const auto& [first, second] : next_) {
      if (done.contains(first)) continue;
      std::vector<int> loop;
      for (int v = first; done.insert(v).second; v = next_.find(v)->second) loop.push_back(v);
      loops_.push_back(std::move(loop));
    }
  }

  /// The longer one first; two loops that no vertex is twice on.
  bool is_band() const { return loops_.size() == 2 && next_.size() == loops_[0].size() + loops_[1].size(); }

  /// One loop that no vertex is twice on.
  bool is_disc() const { return loops_.size() == 1 && next_.size() == loops_[0].size(); }

  /// Ways from border to border where the spacing of vertices changes at both ends to the same side, as where
  /// faces of a CAD program met that continue each other: single edges, or several with vertices of the seam
  /// between them.
  std::vector<std::vector<MeshEdge>> changes() const {
    const std::map<int, double> change = changes_of_spacing(1), wider = changes_of_spacing(2);
    const auto is_change = [&](int v, const std::map<int, double>& ratios, bool grows) {
      const double ratio = ratios.at(v);
      return grows ? ratio > spacing_change : ratio < 1 / spacing_change;
    };
    std::vector<std::vector<MeshEdge>> result;
    std::set<int> used;
    for (const auto& [v, ratio] : change) {
      const bool grows = ratio > 1;
      if (!is_change(v, change, grows)) continue;
      for (const auto& [w, other] : change) {
        // The two borders run against each other.
        if (used.contains(v) || used.contains(w) || !is_change(w, change, !grows)) continue;
        const bool is_edge = is_beside(v, w);
        if (!is_edge &&
            !(is_change(v, wider, grows) && is_change(w, wider, !grows) && is_between_planes(v, w)))
          continue;
        const std::vector<int> way = is_edge ? std::vector<int>{v, w} : straight_way(v, w);
        if (way.empty()) continue;
        result.push_back(edges_along(way));
        used.insert(way.begin(), way.end());
      }
    }
    return result;
  }

  /// Edges that divide it, from loop to loop.
  /// @param ends  vertices where others were divided, near which divisions begin and end there; those of this
  /// one are added
  std::vector<std::vector<MeshEdge>> divisions(std::set<int>& ends) {
    if (length(loops_[1]) > length(loops_[0])) std::swap(loops_[0], loops_[1]);
    std::vector<std::vector<MeshEdge>> result;
    std::set<int> used;
    for (const std::size_t place : places()) {
      const std::vector<int> way = shortest_way(near_end(place, ends, used), used, ends);
      if (way.empty()) continue;
      ends.insert({way.front(), way.back()});
      result.push_back(edges_along(way));
      used.insert(way.begin(), way.end());
    }
    return result;
  }

 private:
  TriangleSide across(const TriangleSide& s) const {
    return neighbours_.across[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>(s.side)];
  }
  Eigen::Vector3d point(int v) const { return mesh_.vertices.col(v); }
  double length(const std::vector<int>& loop) const {
    double result = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      result += (point(loop[(i + 1) % loop.size()]) - point(loop[i])).norm();
    return result;
  }

  static std::vector<MeshEdge> edges_along(const std::vector<int>& way) {
    std::vector<MeshEdge> result;
    for (std::size_t i = 0; i + 1 < way.size(); ++i) result.push_back(mesh_edge(way[i], way[i + 1]));
    return result;
  }

  bool is_beside(int v, int w) const {
    const auto found = beside_.find(v);
    return found != beside_.end() &&
           std::find(found->second.begin(), found->second.end(), w) != found->second.end();
  }

  /// Whether two vertices of the border are on planes that are parallel and apart.
  bool is_between_planes(int v, int w) const {
    const int low = beyond_.at(v), high = beyond_.at(w);
    const auto& first = regions_.regions[static_cast<std::size_t>(low)].carrier;
    const auto& second = regions_.regions[static_cast<std::size_t>(high)].carrier;
    return low != high && first && second && first->kind == geometry::SurfaceKind::plane &&
           second->kind == geometry::SurfaceKind::plane && first->axis.cross(second->axis).norm() < parallel;
  }

  /// By vertex of the first loop: the length of the `count` edges after it over that of those before it.
  std::map<int, double> changes_of_spacing(std::size_t count) const {
    const std::vector<int>& loop = loops_[0];
    const std::size_t n = loop.size();
    std::map<int, double> result;
    for (std::size_t i = 0; i < n; ++i) {
      double after = 0, before = 0;
      for (std::size_t k = 0; k < count; ++k) {
        after += (point(loop[(i + k + 1) % n]) - point(loop[(i + k) % n])).norm();
        before += (point(loop[(i + n - k) % n]) - point(loop[(i + 2 * n - k - 1) % n])).norm();
      }
      result[loop[i]] = after / before;
    }
    return result;
  }

  /// Vertices between two of the border across the inside, each the one beside the last that is nearest to
  /// the line to the goal and ahead; empty if one is far from the line between the two.
  std::vector<int> straight_way(int from, int to) const {
    const Eigen::Vector3d line = point(to) - point(from);
    std::vector<int> way{from};
    while (way.back() != to) {
      const auto beside = beside_.find(way.back());
      if (beside == beside_.end()) return {};
      int best = -1;
      double least = seam_bend * line.norm();
      for (const int v : beside->second) {
        const double ahead = line.dot(point(v) - point(way.back()));
        const double off = line.cross(point(v) - point(from)).norm() / line.norm();
        if (!(ahead > 0) || !(off < least) || (v != to && next_.contains(v))) continue;
        least = off;
        best = v;
      }
      if (best < 0) return {};
      way.push_back(best);
    }
    return way;
  }

  /// Where the first loop turns most, and at least two places.
  std::vector<std::size_t> places() const {
    const std::vector<int>& loop = loops_[0];
    const std::size_t n = loop.size();
    std::vector<double> at{0}, turn(n), gathered(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3d before = point(loop[i]) - point(loop[(i + n - 1) % n]),
                            after = point(loop[(i + 1) % n]) - point(loop[i]);
      turn[i] = std::atan2(before.cross(after).norm(), before.dot(after));
      at.push_back(at.back() + after.norm());
    }
    const double whole = at[n];
    const auto apart = [&](std::size_t a, std::size_t b) {
      const double way = std::abs(at[a] - at[b]);
      return std::min(way, whole - way);
    };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        if (apart(i, j) < window_share / 2 * whole) gathered[i] += turn[j];
    std::vector<std::size_t> order(n), result;
    for (std::size_t i = 0; i < n; ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return gathered[a] > gathered[b]; });
    for (const std::size_t i : order) {
      const bool turns = gathered[i] > least_turn && result.size() < most_divisions;
      if (!turns && result.size() >= 2) break;
      // Where it does not turn, the places are half of it apart.
      const double least = turns ? least_apart * whole : 0.4 * whole;
      if (std::all_of(result.begin(), result.end(), [&](std::size_t r) { return apart(i, r) >= least; }))
        result.push_back(i);
    }
    return result;
  }

  /// A vertex of the first loop, or the nearest end along it that is not far.
  int near_end(std::size_t place, const std::set<int>& ends, const std::set<int>& used) const {
    const std::vector<int>& loop = loops_[0];
    const double far = least_apart * length(loop);
    double way = 0;
    for (std::size_t step = 0; step < loop.size() / 2; ++step) {
      for (const std::size_t i : {(place + step) % loop.size(), (place + loop.size() - step) % loop.size()})
        if (ends.contains(loop[i]) && !used.contains(loop[i])) return loop[i];
      way +=
          (point(loop[(place + step + 1) % loop.size()]) - point(loop[(place + step) % loop.size()])).norm();
      if (way > far) break;
    }
    return loop[place];
  }

  /// From a vertex of the first loop to the second one, along no border and through no used vertex; to
  /// another vertex than an end only if that is so much shorter.
  std::vector<int> shortest_way(int from, const std::set<int>& used, const std::set<int>& ends) const {
    const std::set<int> start(loops_[0].begin(), loops_[0].end()), goal(loops_[1].begin(), loops_[1].end());
    const double detour = 2 * least_apart * length(loops_[1]);
    std::map<int, double> known{{from, 0}};
    std::map<int, int> before;
    std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> open;
    open.emplace(0, from);
    while (!open.empty()) {
      const auto [far, v] = open.top();
      open.pop();
      if (far > known[v]) continue;
      if (goal.contains(v)) {
        std::vector<int> way{v};
        while (way.back() != from) way.push_back(before[way.back()]);
        return way;
      }
      const auto beside = beside_.find(v);
      if (beside == beside_.end()) continue;
      for (const int w : beside->second) {
        if (start.contains(w) || used.contains(w)) continue;
        const double longer =
            far + (point(w) - point(v)).norm() + (goal.contains(w) && !ends.contains(w) ? detour : 0.0);
        const auto [at, added] = known.emplace(w, std::numeric_limits<double>::infinity());
        if (longer >= at->second) continue;
        at->second = longer;
        before[w] = v;
        open.emplace(longer, w);
      }
    }
    return {};
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Regions& regions_;
  std::multimap<int, int> next_;            // along the border
  std::map<int, int> beyond_;               // the region across it, by the vertex before
  std::map<int, std::vector<int>> beside_;  // across an inner edge
  std::vector<std::vector<int>> loops_;
};

/// The pieces of a region between edges, each as its triangles.
std::vector<std::vector<int>> pieces_between(const geometry::TriangleMesh& mesh,
                                             const geometry::MeshNeighbours& neighbours, const Region& region,
                                             const std::set<MeshEdge>& walls) {
  std::set<int> left(region.triangles.begin(), region.triangles.end());
  std::vector<std::vector<int>> result;
  for (const int first : region.triangles) {
    if (left.erase(first) == 0) continue;
    std::vector<int> piece{first};
    for (std::size_t next = 0; next < piece.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const int t = piece[next];
        if (walls.contains(mesh_edge(mesh.triangles(i, t), mesh.triangles((i + 1) % 3, t)))) continue;
        const int other =
            neighbours.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)].triangle;
        if (left.erase(other) > 0) piece.push_back(other);
      }
    result.push_back(std::move(piece));
  }
  return result;
}

}  // namespace

Regions split_bands(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    Regions regions) {
  const std::size_t count = regions.regions.size();
  std::set<int> ends;
  for (std::size_t r = 0; r < count; ++r) {
    if (regions.regions[r].carrier) continue;
    Band band(mesh, neighbours, regions, static_cast<int>(r));
    const auto divisions = band.is_band()   ? band.divisions(ends)
                           : band.is_disc() ? band.changes()
                                            : std::vector<std::vector<MeshEdge>>{};
    if (divisions.size() < (band.is_band() ? 2u : 1u)) continue;
    std::set<MeshEdge> walls;
    for (const auto& division : divisions) walls.insert(division.begin(), division.end());
    auto pieces = pieces_between(mesh, neighbours, regions.regions[r], walls);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Region piece;
      for (const int t : pieces[i]) piece.area += geometry::area_vector(mesh, t).norm() / 2;
      piece.triangles = std::move(pieces[i]);
      const std::size_t number = i == 0 ? r : regions.regions.size();
      for (const int t : piece.triangles)
        regions.of_triangle[static_cast<std::size_t>(t)] = static_cast<int>(number);
      if (i == 0)
        regions.regions[r] = std::move(piece);
      else
        regions.regions.push_back(std::move(piece));
    }
  }
  return regions;
}

}  // namespace isopatch::segmentation

#include "segmentation/reconstruction/internal/bent_borders.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace isopatch::segmentation {
namespace {

using geometry::TriangleSide;

// Smooth borders that turn by more in a vertex of the mesh have a corner there.
constexpr double corner_of_border = 0.8;  // rad, 46 degrees
// Strips of more than this share of their region's area are no chance.
constexpr double largest_share = 0.2;
// Triangles of one strip turn by less.
constexpr double flat_strip = 1.7e-3;  // rad, a tenth of a degree
constexpr int most_bent_rounds = 4;
// More triangles are no strip, and more corners no chance.
constexpr std::size_t longest_strip = 64, most_bends = 100;

struct Move {
  std::vector<int> triangles;
  int from = 0, to = 0;
};

class BentBorders {
 public:
  BentBorders(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
              const Regions& regions, Angle smooth)
      : mesh_(mesh), neighbours_(neighbours), regions_(regions), least_cosine_(std::cos(smooth.radians())) {}

  std::vector<Move> moves() const {
    std::vector<Move> result;
    for (std::size_t r = 0; r < regions_.regions.size(); ++r)
      if (!regions_.regions[r].carrier) add_moves(static_cast<int>(r), result);
    return result;
  }

  /// Corners between a region and one other.
  /// @param triangles  all of the region
  std::size_t corners_with(int other, const std::vector<int>& triangles, int region) const {
    const std::vector<Corner> all = corners(triangles, region);
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [&](const Corner& corner) { return corner.other == other; }));
  }

 private:
  int from(const TriangleSide& s) const { return mesh_.triangles(s.side, s.triangle); }
  int to(const TriangleSide& s) const { return mesh_.triangles((s.side + 1) % 3, s.triangle); }
  Eigen::Vector3d way(const TriangleSide& s) const {
    return mesh_.vertices.col(to(s)) - mesh_.vertices.col(from(s));
  }
  TriangleSide across(const TriangleSide& s) const {
    return neighbours_.across[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>(s.side)];
  }
  int region_across(const TriangleSide& s) const {
    return regions_.of_triangle[static_cast<std::size_t>(across(s).triangle)];
  }
  bool is_smooth(const TriangleSide& s) const {
    const Eigen::Vector3d a = geometry::area_vector(mesh_, s.triangle),
                          b = geometry::area_vector(mesh_, across(s).triangle);
    return a.dot(b) > least_cosine_ * a.norm() * b.norm();
  }

  /// Sides of a region's border, one after the other along one other region, with a corner between them.
  struct Corner {
    TriangleSide side, next;
    int other = 0;
  };

  /// Of smooth borders alone.
  /// @param triangles  all of the region
  std::vector<Corner> corners(const std::vector<int>& triangles, int region) const {
    std::multimap<int, TriangleSide> begins;
    for (const int t : triangles)
      for (int i = 0; i < 3; ++i)
        if (region_across({t, i}) != region) begins.emplace(from({t, i}), TriangleSide{t, i});
    std::vector<Corner> result;
    for (const auto& entry : begins) {
      const TriangleSide& side = entry.second;
      if (begins.count(to(side)) != 1) continue;
      const TriangleSide next = begins.find(to(side))->second;
      const int other = region_across(side);
      if (region_across(next) != other || !is_smooth(side) || !is_smooth(next)) continue;
      if (std::atan2(way(side).cross(way(next)).norm(), way(side).dot(way(next))) < corner_of_border)
        continue;
      result.push_back({side, next, other});
    }
    return result;
  }

  void add_moves(int freeform, std::vector<Move>& result) const {
    for (const Corner& corner :
         corners(regions_.regions[static_cast<std::size_t>(freeform)].triangles, freeform))
      if (regions_.regions[static_cast<std::size_t>(corner.other)].carrier)
        for (const TriangleSide& one : {corner.side, corner.next})
          add_strip(across(one).triangle, corner.other, freeform, result);
  }

  double turn(int a, int b) const {
    const Eigen::Vector3d first = geometry::area_vector(mesh_, a), second = geometry::area_vector(mesh_, b);
    return std::atan2(first.cross(second).norm(), first.dot(second));
  }

  /// The triangles of a region that are flat around one of them.
  void add_strip(int triangle, int from, int to, std::vector<Move>& result) const {
    std::vector<int> strip{triangle};
    double area = geometry::area_vector(mesh_, triangle).norm() / 2;
    for (std::size_t next = 0; next < strip.size(); ++next)
      for (int i = 0; i < 3; ++i) {
        const int other = across({strip[next], i}).triangle;
        if (regions_.of_triangle[static_cast<std::size_t>(other)] != from ||
            std::find(strip.begin(), strip.end(), other) != strip.end() ||
            !(turn(triangle, other) < flat_strip))
          continue;
        strip.push_back(other);
        area += geometry::area_vector(mesh_, other).norm() / 2;
        if (strip.size() > longest_strip ||
            area > largest_share * regions_.regions[static_cast<std::size_t>(from)].area)
          return;
      }
    result.push_back({std::move(strip), from, to});
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Regions& regions_;
  double least_cosine_;
};

/// Whether triangles hang together.
bool is_connected(const std::vector<int>& triangles, const geometry::MeshNeighbours& neighbours) {
  std::set<int> left(triangles.begin(), triangles.end());
  std::vector<int> open{triangles.front()};
  left.erase(open.front());
  while (!open.empty()) {
    const int t = open.back();
    open.pop_back();
    for (const TriangleSide& side : neighbours.across[static_cast<std::size_t>(t)])
      if (left.erase(side.triangle) > 0) open.push_back(side.triangle);
  }
  return left.empty();
}

/// Makes a move that leaves the surface most of its area, in one piece, and fewer corners: a corner that only
/// moves on is where the surface ends.
/// @param least  area of the surface that stays, m^2
bool make(const Move& move, const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
          const BentBorders& borders, double least, Regions& regions) {
  Region &carrier = regions.regions[static_cast<std::size_t>(move.from)],
         &freeform = regions.regions[static_cast<std::size_t>(move.to)];
  std::vector<int> kept, given;
  double area = 0;
  for (const int t : carrier.triangles) {
    const bool goes = std::find(move.triangles.begin(), move.triangles.end(), t) != move.triangles.end();
    (goes ? given : kept).push_back(t);
    if (goes) area += geometry::area_vector(mesh, t).norm() / 2;
  }
  if (given.empty() || carrier.area - area < least || !is_connected(kept, neighbours)) return false;
  const std::size_t corners = borders.corners_with(move.to, carrier.triangles, move.from);
  for (const int t : given) regions.of_triangle[static_cast<std::size_t>(t)] = move.to;
  if (borders.corners_with(move.to, kept, move.from) >= corners) {
    for (const int t : given) regions.of_triangle[static_cast<std::size_t>(t)] = move.from;
    return false;
  }
  freeform.triangles.insert(freeform.triangles.end(), given.begin(), given.end());
  freeform.area += area;
  carrier.area -= area;
  carrier.triangles = std::move(kept);
  return true;
}

}  // namespace

Regions without_bent_borders(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                             Regions regions, Angle smooth) {
  std::vector<double> least;
  for (const Region& region : regions.regions) least.push_back((1 - largest_share) * region.area);
  const BentBorders borders(mesh, neighbours, regions, smooth);
  for (int round = 0; round < most_bent_rounds; ++round) {
    bool changed = false;
    const std::vector<Move> moves = borders.moves();
    if (moves.size() > most_bends) break;
    for (const Move& move : moves)
      changed = make(move, mesh, neighbours, borders, least[static_cast<std::size_t>(move.from)], regions) ||
                changed;
    if (!changed) break;
  }
  return regions;
}

}  // namespace isopatch::segmentation

#include "segmentation/parameterization/internal/find_t_joints.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/hex/cube.hpp"
#include "segmentation/parameterization/internal/face_contact.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::BlockCorner;
using geometry::BlockEdge;
using geometry::BlockSide;
using geometry::HexTopology;
using FramePoint = std::array<double, 2>;

/// Parameters this close are one: faces that touch agree to about as much of their size.
constexpr double same_share = 1e-3;

bool same(double a, double b) {
  return std::abs(a - b) < same_share;
}

double snapped(double share) {
  return same(share, 0) ? 0 : same(share, 1) ? 1 : share;
}

bool is_end(double share) {
  return share == 0 || share == 1;
}

/// The rectangle that an outline runs around, if it is one.
std::optional<geometry::SideRectangle> rectangle_of(const std::vector<FramePoint>& outline) {
  geometry::SideRectangle box{outline.front(), outline.front()};
  for (const FramePoint& point : outline)
    for (std::size_t d = 0; d < 2; ++d) {
      box.low[d] = std::min(box.low[d], point[d]);
      box.high[d] = std::max(box.high[d], point[d]);
    }
  const auto on_border = [&](const FramePoint& point) {
    return same(point[0], box.low[0]) || same(point[0], box.high[0]) || same(point[1], box.low[1]) ||
           same(point[1], box.high[1]);
  };
  if (!std::all_of(outline.begin(), outline.end(), on_border)) return std::nullopt;
  return box;
}

/// The corner of the whole side at a point of its frame, if there is one.
std::optional<int> corner_at(BlockSide whole, const FramePoint& point) {
  if (!is_end(point[0]) || !is_end(point[1])) return std::nullopt;
  return geometry::side_corner(whole.side, static_cast<int>(point[0]), static_cast<int>(point[1]));
}

int part_corner(const SideInSide& part, std::size_t i) {
  return geometry::side_corner(part.part.side, static_cast<int>(i % 2), static_cast<int>(i / 2));
}

void join_corners(geometry::HexContacts& contacts, const SideInSide& part) {
  std::map<int, int> whole_corner;  // by the part's
  for (std::size_t i = 0; i < 4; ++i)
    if (const auto corner = corner_at(part.whole, part.outline.corners[i])) {
      whole_corner[part_corner(part, i)] = *corner;
      contacts.corners.push_back({{part.part.block, part_corner(part, i)}, {part.whole.block, *corner}});
    }
  for (const int edge : geometry::side_edges(part.part.side)) {
    const auto ends = geometry::edge_corners(edge);
    if (!whole_corner.contains(ends[0]) || !whole_corner.contains(ends[1])) continue;
    const std::array there{whole_corner[ends[0]], whole_corner[ends[1]]};
    for (const int other : geometry::side_edges(part.whole.side)) {
      const auto other_ends = geometry::edge_corners(other);
      const bool along = other_ends == there, against = other_ends == std::array{there[1], there[0]};
      if (along || against)
        contacts.edges.push_back({{part.part.block, edge}, {part.whole.block, other}, against});
    }
  }
}

/// Vertices within edges of the complex, with the edges' shares.
using Splits = std::map<geometry::HexEdgeId, std::map<geometry::HexVertexId, double>>;

void find_splits(Splits& splits, const HexTopology& topology, const SideInSide& part) {
  const auto edges = geometry::side_edges(part.whole.side);
  for (std::size_t i = 0; i < 4; ++i) {
    const FramePoint& at = part.outline.corners[i];
    for (std::size_t d = 0; d < 2; ++d) {
      // Edges 0 and 1 run along s, at the ends of t; 2 and 3 along t.
      if (is_end(at[d]) || !is_end(at[1 - d])) continue;
      const BlockEdge edge{part.whole.block, edges[2 * d + (at[1 - d] == 1 ? 1 : 0)]};
      splits[topology.at(edge)][topology.at(BlockCorner{part.part.block, part_corner(part, i)})] =
          is_reversed(topology, edge) ? 1 - at[d] : at[d];
    }
  }
}

std::vector<geometry::SplitEdge> split_edges(const Splits& splits) {
  std::vector<geometry::SplitEdge> result;
  for (const auto& [edge, vertices] : splits) {
    geometry::SplitEdge split{edge, {}};
    for (const auto& [vertex, share] : vertices) split.at.push_back({vertex, share});
    std::sort(split.at.begin(), split.at.end(),
              [](const auto& a, const auto& b) { return a.share < b.share; });
    result.push_back(std::move(split));
  }
  return result;
}

}  // namespace

std::optional<OutlineInSide> lies_in(const FaceMap& part, const FaceMap& whole, double reach) {
  OutlineInSide result;
  const auto foot_of = [&](double s, double t) -> std::optional<FramePoint> {
    const FaceFoot found = foot(whole, part.point(s, t), reach);
    if (!(found.distance <= reach)) return std::nullopt;
    result.distance = std::max(result.distance, found.distance);
    return FramePoint{snapped(found.at[0]), snapped(found.at[1])};
  };
  for (const double s : {0.5, 0.3, 0.7})
    for (const double t : {0.5, 0.2, 0.8})
      if (!foot_of(s, t)) return std::nullopt;
  constexpr int pieces = 4;
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < pieces; ++i) {
      const double x = double(i) / pieces;
      const std::array<FramePoint, 4> around{{{x, 0}, {1, x}, {1 - x, 1}, {0, 1 - x}}};
      const FramePoint& at = around[static_cast<std::size_t>(side)];
      const auto found = foot_of(at[0], at[1]);
      if (!found) return std::nullopt;
      result.points.push_back(*found);
      if (i == 0) result.corners[static_cast<std::size_t>(at[0] + 2 * at[1])] = *found;
    }
  double doubled = 0;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    const FramePoint &a = result.points[i], &b = result.points[(i + 1) % result.points.size()];
    doubled += a[0] * b[1] - a[1] * b[0];
  }
  if (doubled < 0) std::reverse(result.points.begin(), result.points.end());
  return result;
}

HexTopology with_t_joints(int blocks, geometry::HexContacts contacts, const std::vector<SideInSide>& parts) {
  for (const SideInSide& part : parts) join_corners(contacts, part);
  HexTopology topology = geometry::assembled_topology(blocks, contacts);
  std::map<BlockSide, std::vector<geometry::SidePart>> by_whole;
  Splits splits;
  for (const SideInSide& part : parts) {
    by_whole[part.whole].push_back({part.part, {}, part.outline.points, rectangle_of(part.outline.points)});
    find_splits(splits, topology, part);
  }
  for (auto& [whole, in_it] : by_whole) topology.t_joints.push_back({whole, std::move(in_it)});
  topology.split_edges = split_edges(splits);
  return topology;
}

}  // namespace isopatch::segmentation

#include "segmentation/decomposition/cutting/cell_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellFaceUse;
using geometry::EdgeUse;

/// An edge as the boundary of one of a cell's faces walks it, seen from outside.
struct Boundary {
  CellFaceUse face;
  EdgeUse use;
};

/// The edges between two sides, each from both.
std::map<EdgeId, std::vector<Boundary>> edges_between_sides(const CellComplex& complex,
                                                            const std::vector<CellFaceUse>& faces) {
  std::map<EdgeId, std::vector<Boundary>> result;
  for (const CellFaceUse& face : faces)
    for (const EdgeUse& use : complex.face(face.face).loop)
      result[use.edge].push_back({face, {use.edge, use.reversed != face.reversed}});
  std::erase_if(result, [](const auto& entry) {
    return entry.second.size() == 2 && entry.second[0].face.side == entry.second[1].face.side;
  });
  return result;
}

/// The outline of a side, starting from its lowest vertex.
std::vector<EdgeUse> outline_of(const CellComplex& complex, std::vector<EdgeUse> uses) {
  const std::size_t count = uses.size();
  std::map<VertexId, EdgeUse> from;
  for (const EdgeUse& use : uses) from[complex.from(use)] = use;
  std::vector<EdgeUse> loop;
  if (from.empty()) return loop;
  VertexId at = from.begin()->first;
  do {
    const auto next = from.find(at);
    if (next == from.end()) break;
    loop.push_back(next->second);
    at = complex.to(next->second);
  } while (at != from.begin()->first && loop.size() <= count);
  if (loop.size() != count || from.size() != count)
    throw Error(ErrorCode::unsupported, "a side of a cell has more than one outline");
  return loop;
}

EdgeKind kind_of(const std::array<Angle, 2>& range, Angle flat) {
  if (range[1].degrees() > 180 + flat.degrees()) return EdgeKind::non_convex;
  return range[0].degrees() < 180 - flat.degrees() ? EdgeKind::convex : EdgeKind::flat;
}

/// The smallest and largest angle along an edge.
std::array<Angle, 2> angles_along(const CellShapes& shapes, const std::vector<Boundary>& between) {
  const bool straight = shapes.is_straight(between[0].use.edge) &&
                        shapes.is_plane(shapes.complex().face(between[0].face.face).surface) &&
                        shapes.is_plane(shapes.complex().face(between[1].face.face).surface);
  std::array<Angle, 2> range = {Angle::degrees(360), Angle::degrees(0)};
  for (const double t :
       straight ? std::vector<double>{0.5} : std::vector<double>{0.02, 0.25, 0.5, 0.75, 0.98}) {
    const Angle angle = inner_angle(shapes, between[0].face, between[1].face, between[0].use, t);
    if (angle.degrees() < range[0].degrees()) range[0] = angle;
    if (angle.degrees() > range[1].degrees()) range[1] = angle;
  }
  return range;
}

}  // namespace

bool is_polyhedral(const CellShapes& shapes, geometry::CellId cell) {
  for (const CellFaceUse& use : shapes.complex().cell(cell).faces) {
    if (!shapes.is_plane(shapes.complex().face(use.face).surface)) return false;
    for (const EdgeUse& edge : shapes.complex().face(use.face).loop)
      if (!shapes.is_straight(edge.edge)) return false;
  }
  return true;
}

CellSides cell_sides(const CellShapes& shapes, geometry::CellId cell, const SideOptions& options) {
  const CellComplex& complex = shapes.complex();
  const std::vector<CellFaceUse>& faces = complex.cell(cell).faces;
  const auto between = edges_between_sides(complex, faces);
  std::map<VertexId, int> degree;
  std::map<int, std::vector<EdgeUse>> boundary;  // by side
  for (const auto& [edge, sides] : between) {
    if (sides.size() != 2)
      throw Error(ErrorCode::unsupported,
                  fmt::format("edge {} of a cell has {} faces", edge.value, sides.size()));
    ++degree[complex.edge(edge).start];
    ++degree[complex.edge(edge).end];
    for (const Boundary& side : sides) boundary[side.face.side].push_back(side.use);
  }
  CellSides result;
  std::map<VertexId, VertexId> number;
  for (const auto& [vertex, count] : degree)
    if (count > 2) {
      number[vertex] = VertexId(static_cast<int>(result.vertices.size()));
      result.vertices.push_back(vertex);
    }
  result.graph.vertex_count = static_cast<int>(result.vertices.size());
  std::map<std::pair<VertexId, VertexId>, EdgeId> known;
  for (auto& [side, uses] : boundary) {
    std::vector<EdgeUse> loop = outline_of(complex, std::move(uses));
    const auto corner = std::find_if(loop.begin(), loop.end(),
                                     [&](const EdgeUse& use) { return number.contains(complex.from(use)); });
    std::rotate(loop.begin(), corner, loop.end());
    CellGraph::Corners corners;
    std::vector<std::vector<EdgeUse>> chains;
    for (const EdgeUse& use : loop) {
      if (const auto found = number.find(complex.from(use)); found != number.end()) {
        corners.push_back(found->second);
        chains.emplace_back();
      }
      if (chains.empty()) throw Error(ErrorCode::unsupported, "a side of a cell has no corners");
      chains.back().push_back(use);
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexId from = corners[k], to = corners[(k + 1) % corners.size()];
      const auto [found, fresh] =
          known.try_emplace(std::minmax(from, to), EdgeId(static_cast<int>(result.graph.edges.size())));
      if (!fresh) continue;
      std::array<Angle, 2> range = {Angle::degrees(360), Angle::degrees(0)};
      for (const EdgeUse& use : chains[k]) {
        const auto here = angles_along(shapes, between.at(use.edge));
        if (here[0].degrees() < range[0].degrees()) range[0] = here[0];
        if (here[1].degrees() > range[1].degrees()) range[1] = here[1];
      }
      result.graph.edges.push_back({from, to, kind_of(range, options.flat),
                                    range[1].degrees() > 180 + options.flat.degrees() ? range[1] : range[0]});
      result.edges.push_back(chains[k]);
    }
    result.graph.faces.push_back(std::move(corners));
    std::vector<CellFaceUse>& members = result.faces.emplace_back();
    for (const CellFaceUse& face : faces)
      if (face.side == side) members.push_back(face);
  }
  return result;
}

}  // namespace isopatch::segmentation

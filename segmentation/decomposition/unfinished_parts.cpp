#include "segmentation/decomposition/unfinished_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <utility>

#include "geometry/brep/cell_solids.hpp"

namespace isopatch::segmentation {
namespace {

/// Edges of a cell that cuts have to go through.
std::vector<Eigen::Matrix3Xd> concave_edges(const CellStore::Entry& entry, const geometry::Brep& solid,
                                            const CellGraph& graph) {
  const CellShapes shapes(solid, entry.complex);
  std::vector<Eigen::Matrix3Xd> lines;
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    if (graph.edges[e].kind != EdgeKind::non_convex) continue;
    for (const geometry::EdgeUse& use : entry.sides.edges[e]) lines.push_back(polyline(shapes, use.edge));
  }
  return lines;
}

/// ". They meet in parts of 3 sides, the first at (0.1, 0, 0.2) m"; "" if they do not.
std::string where_they_meet(const CellShapes& shapes, const std::vector<PartedSide>& t_joints) {
  if (t_joints.empty() || t_joints.front().inside.empty()) return "";
  const Eigen::Vector3d place = shapes.point(t_joints.front().inside.front(), 0.5);
  return fmt::format(". They meet in parts of {} side{}, the first at ({:.4g}, {:.4g}, {:.4g}) m",
                     t_joints.size(), t_joints.size() == 1 ? "" : "s", place.x(), place.y(), place.z());
}

CuttingError error_about(ErrorCode code, const std::string& message, const std::string& called,
                         std::vector<UnfinishedPart> parts) {
  geometry::SolidFault fault;
  for (const UnfinishedPart& part : parts)
    for (const Eigen::Matrix3Xd& line : part.lines) fault.edges.push_back({called, line});
  return {code, message, std::move(fault), std::move(parts)};
}

}  // namespace

Eigen::Matrix3Xd polyline(const CellShapes& shapes, EdgeId edge) {
  constexpr int pieces = 16;
  Eigen::Matrix3Xd points(3, pieces + 1);
  for (int i = 0; i <= pieces; ++i) points.col(i) = shapes.point(edge, double(i) / pieces);
  return points;
}

std::string faces_of_unfinished(const CutTree& tree, const CellStore& store) {
  const CutTree::Node& node = tree.nodes[static_cast<std::size_t>(tree.unfinished.front())];
  const CellStore::Entry& entry = store.entry(node.cell.handle);
  std::set<int> faces;
  for (const geometry::CellFaceUse& use : entry.complex.cell(entry.cell).faces)
    if (const auto origin = entry.complex.face(use.face).origin) faces.insert(origin->value);
  constexpr std::size_t most = 6;
  std::vector<int> shown(faces.begin(), faces.end());
  const bool all = shown.size() <= most;
  if (!all) shown.resize(most);
  if (shown.empty()) return "no face";
  return fmt::format("face{} {}{}", faces.size() == 1 ? "" : "s", fmt::join(shown, ", "), all ? "" : ", ...");
}

CuttingError unfinished_search(const std::string& message, const CutTree& tree, const CellStore& store) {
  std::vector<UnfinishedPart> parts;
  for (const CutTree::Node& node : tree.nodes) {
    if (node.loop) continue;
    const CellStore::Entry& entry = store.entry(node.cell.handle);
    UnfinishedPart part{cell_solids(store.source(), entry.complex, {entry.cell}).front(),
                        node.base.has_value()};
    if (!part.finished) part.lines = concave_edges(entry, store.source(), node.cell.graph);
    parts.push_back(std::move(part));
  }
  return error_about(ErrorCode::unsupported, message, "an edge to be cut through", std::move(parts));
}

CuttingError unfinished_meeting(const Error& error, const geometry::Brep& solid,
                                const geometry::CellComplex& cells, const std::vector<PartedSide>& t_joints) {
  std::vector<UnfinishedPart> parts;
  for (geometry::Brep& cell : cell_solids(solid, cells)) parts.push_back({std::move(cell), true});
  const CellShapes shapes(solid, cells);
  for (const PartedSide& side : t_joints)
    for (const EdgeId edge : side.inside)
      parts[static_cast<std::size_t>(side.cell.value)].lines.push_back(polyline(shapes, edge));
  return error_about(error.code(), error.what() + where_they_meet(shapes, t_joints), "parts of a side meet",
                     std::move(parts));
}

}  // namespace isopatch::segmentation

#include "segmentation/parameterization/internal/refused_faces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::BrepEdge;
using geometry::BrepFace;

/// "solid 'shaft', face 2 (cylinder)".
std::string described_with_kind(const geometry::BrepFile& solid, FaceId id) {
  return fmt::format("{} ({})", described(solid, id), name(solid.brep.face(id).kind));
}

/// What the whole solid has; a cube has 8, 12 and 6.
std::string counted(const Brep& brep) {
  return fmt::format(
      "The solid has {} vertices, {} edges and {} faces; a hexahedron has 8, 12 and 6. isopatch segment cuts "
      "solids into such, and so does a study with [model] file in place of blocks",
      brep.vertices().cols(), brep.edges().size(), brep.faces().size());
}

std::string millimetres(const Eigen::Vector3d& point) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * point[0], 1e3 * point[1], 1e3 * point[2]);
}

geometry::SolidFault fault_at(const geometry::BrepFile& solid, FaceId face, const std::string& remark,
                              const std::vector<geometry::EdgeUse>& edges) {
  const Brep& brep = solid.brep;
  geometry::SolidFault fault{.faces = {{face.value, solid.name, remark}}};
  for (const geometry::EdgeUse& use : edges) fault.edges.push_back(drawn(brep, use.edge));
  return fault;
}

bool is_round(geometry::SurfaceKind kind) {
  using geometry::SurfaceKind;
  return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::sphere ||
         kind == SurfaceKind::torus;
}

std::string advice_on_cutting(geometry::SurfaceKind kind) {
  if (is_round(kind)) return "cut the solid along its axis, into pieces with four edges on each face";
  return "cut the solid across it, into pieces with four edges on each face";
}

/// A face that goes all around: its loop walks an edge in both directions.
void refuse_seam(const geometry::BrepFile& solid, FaceId id) {
  const Brep& brep = solid.brep;
  for (const auto& loop : brep.face(id).loops)
    for (const geometry::EdgeUse& use : loop) {
      if (std::find(loop.begin(), loop.end(), geometry::EdgeUse{use.edge, !use.reversed}) == loop.end())
        continue;
      const BrepEdge& seam = brep.edge(use.edge);
      throw geometry::SolidError(
          ErrorCode::unsupported,
          fmt::format("{} is closed on itself: it goes all around and meets itself along the edge from {} to "
                      "{}; {}. {}",
                      described_with_kind(solid, id), millimetres(brep.vertex(seam.start)),
                      millimetres(brep.vertex(seam.end)), advice_on_cutting(brep.face(id).kind),
                      counted(brep)),
          fault_at(solid, id, "closed on itself", {use}));
    }
}

void refuse_inner_loops(const geometry::BrepFile& solid, FaceId id) {
  const Brep& brep = solid.brep;
  const auto& loops = brep.face(id).loops;
  if (loops.size() == 1) return;
  if (loops.empty())
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("{} has no edges, it is closed on itself; {}. {}", described_with_kind(solid, id),
                    advice_on_cutting(brep.face(id).kind), counted(brep)),
        fault_at(solid, id, "no edges", {}));
  std::vector<geometry::EdgeUse> inner;
  for (std::size_t i = 1; i < loops.size(); ++i) inner.insert(inner.end(), loops[i].begin(), loops[i].end());
  const std::size_t holes = loops.size() - 1;
  throw geometry::SolidError(
      ErrorCode::unsupported,
      fmt::format(
          "{} has {} hole{} ({} outlines); each face of a hexahedron has one outline with four edges. "
          "Cut the solid through the hole{} first. {}",
          described_with_kind(solid, id), holes, holes == 1 ? "" : "s", loops.size(), holes == 1 ? "" : "s",
          counted(brep)),
      fault_at(solid, id, fmt::format("{} outlines", loops.size()), inner));
}

void refuse_closed_edges(const geometry::BrepFile& solid, FaceId id) {
  const Brep& brep = solid.brep;
  for (const geometry::EdgeUse& use : brep.face(id).loops.front()) {
    const BrepEdge& edge = brep.edge(use.edge);
    if (edge.start != edge.end) continue;
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format(
            "{} is bounded by an edge that is closed on itself ({}, through {}); each face of a "
            "hexahedron has four edges from corner to corner. Cut the solid through the middle of that "
            "face, twice. {}",
            described_with_kind(solid, id), name(edge.kind), millimetres(brep.vertex(edge.start)),
            counted(brep)),
        fault_at(solid, id, "a closed edge", {use}));
  }
}

/// What to do about a face with too few corners or too many.
const char* advice_for_corners(std::size_t count) {
  if (count > 4) return "Cut the solid through the face, or remove a vertex that only divides an edge";
  if (count == 3)
    return "Cut the solid from the face's middle to its three edges: that makes three faces with four edges";
  return "Cut the solid so that each piece has four edges there; a round face through its middle, twice";
}

geometry::SolidFault corners_fault(const geometry::BrepFile& solid, FaceId id, const std::string& remark,
                                   const std::vector<int>& corners) {
  geometry::SolidFault fault{.faces = {{id.value, solid.name, remark}}};
  for (const int v : std::set<int>(corners.begin(), corners.end()))
    fault.points.push_back({fmt::format("vertex {}", v), solid.brep.vertex(VertexId(v))});
  return fault;
}

void refuse_corners(const geometry::BrepFile& solid, FaceId id) {
  std::vector<int> corners;
  for (const geometry::EdgeUse& use : solid.brep.face(id).loops.front()) {
    const BrepEdge& edge = solid.brep.edge(use.edge);
    corners.push_back((use.reversed ? edge.end : edge.start).value);
  }
  const std::size_t count = corners.size();
  if (count != 4)
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("{} has {} corner{} (vert{} {}); each face of a hexahedron has four. {}",
                    described(solid, id), count, count == 1 ? "" : "s", count == 1 ? "ex" : "ices",
                    fmt::join(corners, ", "), advice_for_corners(count)),
        corners_fault(solid, id, fmt::format("{} corners", count), corners));
  if (std::set<int>(corners.begin(), corners.end()).size() != 4)
    throw geometry::SolidError(
        ErrorCode::unsupported,
        fmt::format("{} comes back to a vertex on its way around: {}. Each face of a hexahedron has four "
                    "different corners; cut the solid through that vertex",
                    described(solid, id), fmt::join(corners, ", ")),
        corners_fault(solid, id, "visits a vertex twice", corners));
}

}  // namespace

std::string face_name(const Brep& brep, FaceId id) {
  const BrepFace& face = brep.face(id);
  return face.name.empty() ? fmt::format("face {}", id.value) : face.name;
}

std::string face_in_words(const std::string& name) {
  const std::string prefix = "face ";
  const bool numbered = name.starts_with(prefix) && name.size() > prefix.size() &&
                        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
  return numbered ? name : "face '" + name + "'";
}

std::string described(const geometry::BrepFile& solid, FaceId face) {
  return fmt::format("solid '{}', {}", solid.name, face_in_words(face_name(solid.brep, face)));
}

void refuse_faces(const geometry::BrepFile& solid) {
  for (const auto refuse : {refuse_seam, refuse_inner_loops, refuse_closed_edges, refuse_corners})
    for (std::size_t f = 0; f < solid.brep.faces().size(); ++f) refuse(solid, FaceId(static_cast<int>(f)));
}

}  // namespace isopatch::segmentation

#include "geometry/brep/cell_solids.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::geometry {
namespace {

/// Why a face is no disc bounded by several edges; "" if it is one.
std::string no_disc(const Brep& source, FaceId id) {
  const BrepFace& face = source.face(id);
  if (face.loops.size() != 1) return fmt::format("has {} outlines; one is needed", face.loops.size());
  for (const EdgeUse& use : face.loops.front()) {
    const BrepEdge& edge = source.edge(use.edge);
    if (edge.start == edge.end) return fmt::format("is bounded by the closed edge {}", use.edge.value);
    if (edge.faces.size() == 2 && edge.faces[0] == edge.faces[1])
      return fmt::format("is closed on itself along edge {}", use.edge.value);
  }
  return "";
}

/// "a cone at (0.01, 0, 0.02) m".
std::string what_and_where(const Brep& source, FaceId id) {
  const BrepFace& face = source.face(id);
  const DomainBox domain = source.domain(id);
  const bool has_edges = !face.loops.empty() && !face.loops.front().empty();
  const Eigen::Vector3d place = has_edges ? source.point(face.loops.front().front().edge, 0.5)
                                          : source.point(id, (domain.low + domain.high) / 2);
  const double round_off = 1e-9 * source.size();
  const Eigen::Vector3d at = place.unaryExpr([&](double x) { return std::abs(x) < round_off ? 0.0 : x; });
  return fmt::format("a {} at ({:.4g}, {:.4g}, {:.4g}) m", name(face.kind), at.x(), at.y(), at.z());
}

void require_discs(const Brep& source) {
  std::vector<FaceId> others;
  for (std::size_t f = 0; f < source.faces().size(); ++f)
    if (const FaceId id(static_cast<int>(f)); !no_disc(source, id).empty()) others.push_back(id);
  if (others.empty()) return;
  SolidFault fault;
  for (const FaceId id : others) fault.faces.push_back({id.value});
  const std::string more =
      others.size() == 1 ? "" : fmt::format(", and {} more of its faces are alike", others.size() - 1);
  throw SolidError(
      ErrorCode::unsupported,
      fmt::format("{} {}; cut the solid through it in the CAD program, so that each face has one outline of "
                  "several edges ({} is {}{})",
                  describe(source, others.front()), no_disc(source, others.front()),
                  describe(source, others.front()), what_and_where(source, others.front()), more),
      std::move(fault));
}

}  // namespace

CellComplex one_cell(const Brep& source) {
  require_discs(source);
  CellComplex complex;
  for (Eigen::Index v = 0; v < source.vertices().cols(); ++v)
    complex.vertices.emplace_back(source.vertices().col(v));
  for (std::size_t e = 0; e < source.edges().size(); ++e) {
    const EdgeId id(static_cast<int>(e));
    complex.curves.push_back({id});
    complex.edges.push_back({CurveId(id.value), 0, 1, source.edge(id).start, source.edge(id).end});
  }
  Cell& cell = complex.cells.emplace_back();
  for (std::size_t f = 0; f < source.faces().size(); ++f) {
    const FaceId id(static_cast<int>(f));
    complex.surfaces.emplace_back(id);
    complex.faces.push_back({SurfaceId(id.value), source.face(id).loops.front(), id});
    cell.faces.push_back({id, false, id.value});
  }
  return complex;
}

std::vector<Brep> cell_solids(const Brep& source, const CellComplex& complex,
                              const std::vector<CellId>& cells) {
  std::vector<Brep> result;
  for (KernelSolid& solid : brep_module().cells(source.kernel(), complex, cells)) {
    result.emplace_back(std::move(solid.kernel));
    require_solid(result.back());
  }
  return result;
}

std::vector<Brep> cell_solids(const Brep& source, const CellComplex& complex) {
  std::vector<CellId> all;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) all.emplace_back(static_cast<int>(c));
  return cell_solids(source, complex, all);
}

}  // namespace isopatch::geometry

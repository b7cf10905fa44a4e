#include "geometry/brep/cell_complex.hpp"

#include <utility>

#include "geometry/splines/arc.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

/// @return  the number of the value, which is the last one now
template <class T>
int appended(std::vector<T>& values, T value) {
  values.push_back(std::move(value));
  return static_cast<int>(values.size()) - 1;
}

}  // namespace

VertexId CellComplex::add_vertex(const Eigen::Vector3d& place) {
  return VertexId(appended(vertices, place));
}

CurveId CellComplex::add_curve(CellCurve curve) {
  return CurveId(appended(curves, std::move(curve)));
}

SurfaceId CellComplex::add_surface(CellSurface surface) {
  return SurfaceId(appended(surfaces, std::move(surface)));
}

FaceId CellComplex::add_face(CellFace face) {
  return FaceId(appended(faces, std::move(face)));
}

EdgeId CellComplex::add_edge(CellCurve curve, VertexId from, VertexId to) {
  return EdgeId(appended(edges, {add_curve(std::move(curve)), 0, 1, from, to}));
}

EdgeId CellComplex::add_straight_edge(VertexId from, VertexId to) {
  return add_edge({segment(vertex(from), vertex(to))}, from, to);
}

void CellComplex::add_trace(EdgeUse use, SurfaceId surface, NurbsCurve domain) {
  if (use.reversed) domain = reversed(domain, 0);
  curves[static_cast<std::size_t>(edge(use.edge).curve.value)].traces.push_back({surface, std::move(domain)});
}

}  // namespace isopatch::geometry

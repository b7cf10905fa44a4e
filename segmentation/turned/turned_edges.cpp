#include "segmentation/turned/internal/turned_edges.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <variant>

#include "geometry/base/angle.hpp"
#include "geometry/splines/arc.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CurveId;
using geometry::NurbsCurve;

}  // namespace

TurnedEdges::TurnedEdges(const TurnedFrame& frame, const TurnedDrawing& drawing, int sectors)
    : frame_(frame), drawing_(drawing), sectors_(sectors) {
  for (std::size_t s = 0; s < drawing.columns.size(); ++s) {
    for (const int edge : drawing.columns[s])
      for (const int end : {drawing.quads.edges[static_cast<std::size_t>(edge)].start,
                            drawing.quads.edges[static_cast<std::size_t>(edge)].end})
        core_.emplace(end, nullptr);
    const CoreStrip& strip = drawing.half.strips[s];
    for (const CoreEnd* end : {&strip.low, &strip.high}) core_[end->vertex] = end;
  }
  for (const QuadEdge& edge : drawing.quads.edges)
    if (edge.profile_edge >= 0 &&
        drawing.half.outside.curves[static_cast<std::size_t>(edge.profile_edge)].of_prism)
      of_prism_.insert({edge.start, edge.end});
}

const CoreEnd* TurnedEdges::core_end(int vertex) const {
  const auto found = core_.find(vertex);
  return found == core_.end() ? nullptr : found->second;
}

const NurbsCurve& TurnedEdges::shape(EdgeId edge) const {
  return std::get<NurbsCurve>(complex.curve(complex.edge(edge).curve).shape);
}

VertexId TurnedEdges::vertex(int number, int meridian) {
  const auto [found, fresh] =
      vertices_.try_emplace({number, meridian}, static_cast<int>(complex.vertices.size()));
  if (fresh) complex.vertices.push_back(frame_.point(flat(number), angle(meridian)));
  return found->second;
}

VertexId TurnedEdges::axis_vertex(int number) {
  const auto [found, fresh] = axis_vertices_.try_emplace(number, static_cast<int>(complex.vertices.size()));
  const CoreEnd* end = core_end(number);
  if (fresh) complex.vertices.push_back(frame_.point({0, end ? end->height : flat(number)[1]}, 0));
  return found->second;
}

EdgeId TurnedEdges::add(NurbsCurve shape, VertexId from, VertexId to) {
  return complex.add_edge({std::move(shape)}, from, to);
}

EdgeId TurnedEdges::meridian(int edge, int meridian) {
  const auto known = meridians_.find({edge, meridian});
  if (known != meridians_.end()) return known->second;
  const QuadEdge& drawn = drawing_.quads.edges[static_cast<std::size_t>(edge)];
  const VertexId from = vertex(drawn.start, meridian), to = vertex(drawn.end, meridian);
  const NurbsCurve& curve = drawing_.curves[static_cast<std::size_t>(edge)];
  return meridians_[{edge, meridian}] = add(frame_.turned(curve, angle(meridian)), from, to);
}

EdgeId TurnedEdges::around(int number, int sector) {
  const auto known = around_.find({number, sector});
  if (known != around_.end()) return known->second;
  const VertexId from = vertex(number, sector), to = vertex(number, next(sector));
  const Eigen::Vector3d a = complex.vertex(from), b = complex.vertex(to);
  NurbsCurve shape = geometry::segment(a, b);
  if (const CoreEnd* end = core_end(number); end && end->sphere)
    shape = end->sphere->arc(a, b);
  else if (!has_chords(number))
    shape = geometry::arc_about(frame_.origin, frame_.along, a, Angle::radians(frame_.sweep / sectors_));
  return around_[{number, sector}] = add(std::move(shape), from, to);
}

EdgeId TurnedEdges::radial(int number, int meridian) {
  const auto known = radial_.find({number, meridian});
  if (known != radial_.end()) return known->second;
  const VertexId from = axis_vertex(number), to = vertex(number, meridian);
  const Eigen::Vector3d a = complex.vertex(from), b = complex.vertex(to);
  const CoreEnd* end = core_end(number);
  NurbsCurve shape = end && end->sphere ? end->sphere->arc(a, b) : geometry::segment(a, b);
  return radial_[{number, meridian}] = add(std::move(shape), from, to);
}

EdgeId TurnedEdges::rung(int number, int from, int to) {
  const auto known = rungs_.find({number, from});
  if (known != rungs_.end()) return known->second;
  const VertexId a = vertex(number, from), b = vertex(number, to);
  return rungs_[{number, from}] = add(geometry::segment(complex.vertex(a), complex.vertex(b)), a, b);
}

EdgeId TurnedEdges::axis(int edge) {
  const auto known = axis_.find(edge);
  if (known != axis_.end()) return known->second;
  const QuadEdge& drawn = drawing_.quads.edges[static_cast<std::size_t>(edge)];
  const VertexId from = axis_vertex(drawn.start), to = axis_vertex(drawn.end);
  return axis_[edge] = add(geometry::segment(complex.vertex(from), complex.vertex(to)), from, to);
}

}  // namespace isopatch::segmentation

#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/brep/cell_complex.hpp"
#include "segmentation/turned/internal/turned_drawing.hpp"

namespace isopatch::segmentation {

/// Vertices and edges of a divided half profile turned in sectors, each made once. Meridians count from 0;
/// the last one of a whole turn is the first.
class TurnedEdges {
 public:
  /// Both must outlive it.
  TurnedEdges(const TurnedFrame& frame, const TurnedDrawing& drawing, int sectors);

  /// An edge of the drawing at a meridian.
  EdgeId meridian(int edge, int meridian);
  /// The edge from a vertex at one meridian to that at the next: an arc, a chord beside the column and on
  /// prisms, a great circle where the column ends on a sphere.
  EdgeId around(int vertex, int sector);
  /// The edge from the axis to a vertex beside the column.
  EdgeId radial(int vertex, int meridian);
  /// The piece of the axis beside an edge of the column's side, upwards.
  EdgeId axis(int edge);
  /// The edge across the column of a whole turn, between its corners at two meridians.
  EdgeId rung(int vertex, int from, int to);

  /// Whether a vertex is beside the column.
  bool is_core(int vertex) const { return core_.contains(vertex); }
  /// Whether what is around the axis at a vertex is not turned.
  bool has_chords(int vertex) const { return is_core(vertex) || of_prism_.contains(vertex); }
  /// Where the column ends at a vertex; nothing elsewhere.
  const CoreEnd* core_end(int vertex) const;
  int next(int meridian) const { return frame_.is_whole() ? (meridian + 1) % sectors_ : meridian + 1; }
  double angle(int meridian) const { return frame_.sweep * meridian / sectors_; }
  const geometry::NurbsCurve& shape(EdgeId edge) const;

  geometry::CellComplex complex;  ///< what was made so far

 private:
  VertexId vertex(int number, int meridian);
  VertexId axis_vertex(int number);
  EdgeId add(geometry::NurbsCurve shape, VertexId from, VertexId to);
  const Eigen::Vector2d& flat(int vertex) const { return drawing_.places[static_cast<std::size_t>(vertex)]; }

  using Turned = std::pair<int, int>;  // something of the drawing, and its meridian or sector
  const TurnedFrame& frame_;
  const TurnedDrawing& drawing_;
  int sectors_;
  std::map<int, const CoreEnd*> core_;
  std::set<int> of_prism_;
  std::map<Turned, VertexId> vertices_;
  std::map<int, VertexId> axis_vertices_;
  std::map<Turned, EdgeId> meridians_, around_, radial_, rungs_;
  std::map<int, EdgeId> axis_;
};

}  // namespace isopatch::segmentation

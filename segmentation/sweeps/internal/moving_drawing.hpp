#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/sweeps/internal/swept_drawing.hpp"

namespace isopatch::segmentation {

/// A divided drawing at any height: vertices and edges on inclined walls move along them, other outlines
/// stay, and what lies inside follows the mean of its neighbours.
class MovingDrawing {
 public:
  /// All must outlive it.
  /// @param offsets  by edge of the drawing: how far to the left of its piece of the profile it runs, m
  /// @throws Error unsupported  a curve that cannot be cut so, or has no exact offset
  MovingDrawing(const geometry::Brep& solid, const SweepFrame& frame, const SweptDrawing& drawing,
                const Quadrangulation& quads, const std::map<int, double>& offsets = {});

  Eigen::Vector3d place(int vertex, double height) const;
  /// Where a vertex inside has to be drawn so that it is, at a height, where the drawing has it.
  Eigen::Vector2d drawn_place(int vertex, double height) const;
  /// Exact, over [0, 1] from start to end, in space.
  geometry::NurbsCurve curve(int edge, double height) const;
  /// A point of an edge of the profile, by its share of the edge's parameter.
  Eigen::Vector2d outline_place(int edge, double share, double height) const;
  /// Heights where walls beside an edge of the drawing begin, end or change their slope.
  std::vector<double> kinks(int edge) const;
  /// Heights where the way of a vertex changes its slope.
  std::vector<double> kinks_at(int vertex) const;

 private:
  /// A piece of a track, in the t of its first edge.
  struct Piece {
    const EdgeTrack* track;
    double low, high;
  };
  struct Between {
    const EdgeTrack::At *below, *above;
    double share;
  };

  void find_vertex_tracks();
  void find_rings();
  void find_inner_vertices();
  void find_discs();
  /// Where a track has a vertex; nothing for one that no track has.
  std::optional<Eigen::Vector2d> tracked_place(int vertex, double height) const;
  const std::vector<Eigen::Vector2d>& shifts(double height) const;
  /// Of several, the one that has a height.
  static const Piece* at_height(const std::vector<Piece>& pieces, double height);
  std::optional<Piece> piece_on(const EdgeTrack& track, int edge) const;
  double parameter_on(const EdgeTrack& track, const Eigen::Vector3d& point) const;
  Eigen::Vector3d sheet_point(const QuadEdge& edge, double share) const;
  static Between between(const EdgeTrack& track, double height);
  Eigen::Vector2d track_place(const EdgeTrack& track, double t, double height) const;
  geometry::NurbsCurve member_curve(const EdgeTrack::At& at, const Piece& piece, double height) const;
  Eigen::Vector3d apex(const QuadEdge& drawn, double height) const;
  const QuadEdge& edge(int number) const { return quads_.edges[static_cast<std::size_t>(number)]; }

  const geometry::Brep& solid_;
  const SweepFrame& frame_;
  const SweptDrawing& drawing_;
  const Quadrangulation& quads_;
  std::vector<Eigen::Vector2d> places_;                           // where nothing moves
  std::vector<geometry::NurbsCurve> curves_;                      // of edges, at height 0
  std::set<int> beside_;                                          // edges that run beside the profile
  std::vector<std::vector<Piece>> pieces_;                        // of edges
  std::map<int, std::vector<const VertexTrack*>> vertex_tracks_;  // by vertex
  std::map<int, const RingTrack*> edge_rings_, vertex_rings_;
  std::map<int, const RingTrack*> discs_;  // vertices inside of a ring
  /// Other vertices inside the drawing with their neighbours.
  std::map<int, std::vector<int>> inner_;
  mutable std::map<double, std::vector<Eigen::Vector2d>> shifts_;  // of all vertices, by height
  std::map<int, std::vector<Piece>> on_track_;  // vertices inside edges that move, as pieces of no length
};

}  // namespace isopatch::segmentation

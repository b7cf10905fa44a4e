#pragma once

#include <compare>
#include <string>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"

namespace isopatch::segmentation {

/// Where a loop passes: a vertex, or an auxiliary vertex inside an edge (one an edge at most).
struct LoopPlace {
  VertexId vertex;  ///< -1 where the place is inside an edge
  EdgeId edge;      ///< -1 where the place is a vertex

  static LoopPlace at(VertexId vertex) { return {vertex, EdgeId()}; }
  static LoopPlace inside(EdgeId edge) { return {VertexId(), edge}; }
  bool auxiliary() const { return edge.value >= 0; }
  auto operator<=>(const LoopPlace&) const = default;
};

/// What the cutting surface continues, where it leaves the boundary along a non-convex edge: in that piece
/// the face and the new face are one side, and the edge is gone.
enum class Extension { none, left, right };

/// How a loop goes from one place to the next: along an edge, or by an auxiliary edge inside a face.
struct LoopStep {
  EdgeId edge;  ///< -1 where the step is auxiliary
  FaceId face;  ///< -1 where the step is an edge
  Extension extension = Extension::none;

  static LoopStep along(EdgeId edge, Extension extension = Extension::none) {
    return {edge, FaceId(), extension};
  }
  static LoopStep across(FaceId face) { return {EdgeId(), face, Extension::none}; }
  bool auxiliary() const { return face.value >= 0; }
  auto operator<=>(const LoopStep&) const = default;
};

/// A closed path on the boundary of a cell along which it is cut in two. Pure data.
///
/// Step k goes from place k to place k + 1. Walking along, seen from outside, one piece is to the left and
/// one to the right; a left extension continues the face to the left.
struct CuttingLoop {
  std::vector<LoopPlace> places;
  std::vector<LoopStep> steps;

  int length() const { return static_cast<int>(places.size()); }
  bool extends() const;
  int auxiliary_vertices() const;
  int auxiliary_edges() const;
  auto operator<=>(const CuttingLoop&) const = default;
};

/// The same loop from its lowest place on, towards the lower of that place's two neighbours: equal for loops
/// that cut the same, whatever their start and direction (of which extensions are left or right).
CuttingLoop normal_form(const CuttingLoop& loop);

/// The faces that a place lies on.
std::vector<FaceId> faces_at(const CellIncidence& incidence, const LoopPlace& place);

/// For messages: "vertex 3", "a vertex on edge 5".
std::string words(const LoopPlace& place);

/// @throws Error invalid_argument  a place that the cell does not have
void check_places(const CellGraph& graph, const std::vector<LoopPlace>& places);

/// Of a loop's places, the loop: along edges where there are any, else across the one face that both lie in.
/// @throws Error invalid_argument  two places that follow each other and share no face, or more than one
CuttingLoop loop_through(const CellGraph& graph, const CellIncidence& incidence,
                         const std::vector<LoopPlace>& places);

}  // namespace isopatch::segmentation

#pragma once

#include <array>
#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation {

/// Which vertices, edges and faces of a cell meet. Made from a graph that bounds a ball; does not keep it.
class CellIncidence {
 public:
  /// @throws Error not_manifold  unless each edge is a side of two faces, in opposite senses, the faces at
  /// each
  ///                             vertex make one fan, and the whole is one sphere
  /// @cost O(sum of degrees of the ends, over the edges)
  explicit CellIncidence(const CellGraph& graph);

  /// Around a vertex, counter-clockwise seen from outside; edge k is the first side of face k from there.
  const std::vector<EdgeId>& edges_at(VertexId vertex) const { return edges_at_[index(vertex.value)]; }
  const std::vector<FaceId>& faces_at(VertexId vertex) const { return faces_at_[index(vertex.value)]; }
  /// Sides of a face: side k joins its corners k and k + 1.
  const std::vector<EdgeId>& sides(FaceId face) const { return sides_[index(face.value)]; }
  /// The faces to the left and right of an edge, walked from its start, seen from outside.
  FaceId left(EdgeId edge) const { return sides_of_[index(edge.value)][0]; }
  FaceId right(EdgeId edge) const { return sides_of_[index(edge.value)][1]; }

  std::optional<EdgeId> edge_between(VertexId a, VertexId b) const;
  std::vector<FaceId> common_faces(VertexId a, VertexId b) const;

 private:
  static std::size_t index(int value) { return static_cast<std::size_t>(value); }
  std::vector<std::vector<EdgeId>> edges_at_, sides_;
  std::vector<std::vector<FaceId>> faces_at_;
  std::vector<std::vector<VertexId>> neighbours_;
  std::vector<std::array<FaceId, 2>> sides_of_;
};

/// Whether no two vertices can be removed so that the rest falls apart, for a graph that bounds a ball.
///
/// Such a graph is 3-connected iff it has four vertices or more, all of degree three or more, and any two of
/// its faces share nothing, a vertex, or an edge with its ends.
/// @cost O(sum over the faces of the degrees of their corners)
/// @source Juettler, Kapl, Nguyen, Pan, Pauley, CAD 57 (2014), Lemma 2, in the form for all pairs of faces
bool is_three_connected(const CellGraph& graph);

}  // namespace isopatch::segmentation

#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/io/mfem_topology.hpp"

namespace isopatch::geometry {

/// Numbers of the coefficients of each patch, first direction fastest, in the numbering over the whole mesh.
///
/// MFEM numbers vertices, then the insides of edges (from the lower to the higher vertex), of faces (in the
/// frame of the first patch) and of patches. Faces and edges that others divide have the numbers of these.
class MfemNumbering {
 public:
  /// @param sizes  number of coefficients of every patch along its directions
  /// @param edges  number of coefficients of every edge
  /// @throws Error bad_format or unsupported  faces that divide another one without having its coefficients
  MfemNumbering(const MfemTopology& topology, std::vector<std::array<int, 3>> sizes,
                const std::vector<int>& edges);

  /// Coefficients of the whole mesh.
  std::int64_t size() const { return size_; }
  std::vector<std::int64_t> patch(std::size_t index) const;

 private:
  using Numbers = std::vector<std::int64_t>;
  /// Vertices of a face at (0, 0), (1, 0), (0, 1) and (1, 1).
  using FaceCorners = std::array<int, 4>;

  void find_divided_edges();
  /// Inside an edge, from one end to the other.
  Numbers edge(int from, int to) const;
  /// Inside a face, first direction fastest.
  Numbers face(const FaceCorners& corners) const;
  Numbers divided_face(const MfemDividedFace& divided, const FaceCorners& corners) const;
  struct Frames {
    std::array<Numbers, 6> faces;   // by side
    std::array<Numbers, 12> edges;  // by direction and the ends of the two others
  };
  std::int64_t number(const Frames& frames, std::size_t patch, const std::array<int, 3>& at) const;

  const MfemTopology& topology_;
  std::vector<std::array<int, 3>> sizes_;
  struct OfEdge {
    std::int64_t first;
    int inside;
  };
  std::map<std::pair<int, int>, OfEdge> edges_;              // by the lower and the higher vertex
  std::map<std::pair<int, int>, std::vector<int>> divided_;  // vertices, from the lower to the higher
  struct OfFace {
    std::array<int, 4> vertices;  // the frame, counter-clockwise
    std::int64_t first;
    std::array<int, 2> inside;
  };
  std::map<std::array<int, 4>, OfFace> faces_;                          // by the vertices, ascending
  std::map<std::array<int, 4>, const MfemDividedFace*> divided_faces_;  // likewise
  std::vector<std::int64_t> first_of_patch_;
  std::int64_t size_ = 0;
};

}  // namespace isopatch::geometry

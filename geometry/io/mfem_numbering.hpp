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
/// frame of the first patch) and of patches.
class MfemNumbering {
 public:
  /// @param sizes  number of coefficients of every patch along its directions
  /// @param edges  number of coefficients of every edge
  MfemNumbering(const MfemTopology& topology, std::vector<std::array<int, 3>> sizes,
                const std::vector<int>& edges);

  /// Coefficients of the whole mesh.
  std::int64_t size() const { return size_; }
  std::vector<std::int64_t> patch(std::size_t index) const;

 private:
  struct Strided {  // number of the coefficient at (a, b), counted inside a face: first + a along + b across
    std::int64_t first = 0;
    std::int64_t along = 0;
    std::int64_t across = 0;
  };
  Strided face(std::size_t patch, Side side) const;
  Strided edge(std::size_t patch, int direction, int corner) const;
  struct Frames {
    std::array<Strided, 6> faces;   // by side
    std::array<Strided, 12> edges;  // by direction and the ends of the two others
  };
  std::int64_t number(const Frames& frames, std::size_t patch, const std::array<int, 3>& at) const;

  const MfemTopology& topology_;
  std::vector<std::array<int, 3>> sizes_;
  std::map<std::pair<int, int>, std::int64_t> first_of_edge_;
  std::map<PatchFace, std::size_t> face_of_;
  std::vector<std::int64_t> first_of_face_;
  std::vector<std::int64_t> first_of_patch_;
  std::int64_t size_ = 0;
};

}  // namespace isopatch::geometry

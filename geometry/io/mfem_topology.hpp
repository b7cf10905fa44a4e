#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A face of an MFEM mesh: its vertices in the order of the first patch that has it, which is the frame in
/// which its coefficients are numbered.
struct MfemFace {
  std::array<int, 4> vertices;
  std::vector<PatchFace> patches;  ///< one or two
};

struct MfemEdge {
  int knot_vector = 0;
  int from = 0;  ///< the knot vector runs from this vertex
  int to = 0;
};

struct MfemBoundaryElement {
  int attribute = 0;
  std::array<int, 4> vertices;
  int line = 0;
};

/// How the patches of an MFEM mesh hang together, as the file's first sections say.
struct MfemTopology {
  std::vector<std::array<int, 8>> patches;  ///< vertices: the low layer counter-clockwise, then the high one
  std::vector<MfemBoundaryElement> boundary;
  std::vector<MfemEdge> edges;
  int vertex_count = 0;
  std::vector<MfemFace> faces;  ///< numbered as the patches first meet them
};

/// Vertex of a patch at the low (0) or high (1) end of each direction.
int mfem_corner(const std::array<int, 8>& patch, const std::array<int, 3>& ends);

/// The faces of the patches, numbered as MFEM does: by patch, within it front, south, east, north, west,
/// back.
/// @throws Error bad_format   a face of three patches, or two patches that see its vertices in different
/// cycles
/// @throws Error unsupported  a patch that meets itself
std::vector<MfemFace> mfem_faces(const std::vector<std::array<int, 8>>& patches);

/// Boundaries "attribute N" by increasing N.
/// @throws Error bad_format or unsupported for an element that is no outer face of a patch, with its line
std::vector<Boundary> mfem_boundaries(const MfemTopology& topology);

/// The knot vectors of every patch: those of its edges, turned around where the edge runs against the patch.
/// @throws Error bad_format  an edge that is missing, listed twice or superfluous; parallel edges that
/// disagree
std::vector<NurbsVolume::KnotVectors> mfem_spaces(const MfemTopology& topology,
                                                  const std::vector<KnotVector>& knots);

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

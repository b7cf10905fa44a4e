#pragma once

#include <array>
#include <string>
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

/// A face of a patch that meets faces of several others: vertices where these end divide it into a grid.
struct MfemDividedFace {
  std::array<int, 4> corners;  ///< counter-clockwise: (0, 0), (1, 0), (1, 1), (0, 1)
  /// Per direction: elements of the patch before each line of the grid, 0 and all of them included.
  std::array<std::vector<int>, 2> lines;
  std::vector<int> vertices;  ///< of the grid, first direction fastest
  int at(std::size_t i, std::size_t j) const { return vertices[i + lines[0].size() * j]; }
};

/// Connectivity of the patches of an MFEM mesh, from the file's first sections.
struct MfemTopology {
  std::vector<std::array<int, 8>> patches;  ///< vertices: the low layer counter-clockwise, then the high one
  std::vector<MfemBoundaryElement> boundary;
  std::vector<MfemEdge> edges;
  int vertex_count = 0;
  std::vector<MfemFace> faces;  ///< numbered as the patches first meet them
  std::vector<MfemDividedFace> divided;
};

/// A vertex of some patches within a face of another one, or within an edge of it.
struct MfemHangingVertex {
  int vertex = 0;
  std::array<int, 2> element{};  ///< before which elements of the face it lies, per direction
  std::array<int, 4>
      face{};  ///< its corners, counter-clockwise; its first direction is from the first to the second
};

/// Faces that hanging vertices divide into grids.
/// @param knots  by the numbers that the topology's edges give
/// @throws Error bad_format   vertices that do not exist, or two in one place; faces without listed edges
/// @throws Error unsupported  vertices that are not all of a grid
std::vector<MfemDividedFace> mfem_divided_faces(const std::vector<MfemHangingVertex>& hanging,
                                                const MfemTopology& topology,
                                                const std::vector<KnotVector>& knots);

/// Vertex of a patch at the low (0) or high (1) end of each direction.
int mfem_corner(const std::array<int, 8>& patch, const std::array<int, 3>& ends);

/// Vertices of a patch's edge along a direction, at the low and the high end.
/// @param corner  0 .. 3: the ends of the two other directions, the lower one counting 1 and the higher 2
std::pair<int, int> mfem_edge_ends(const std::array<int, 8>& patch, int direction, int corner);

/// The faces of the patches, numbered as MFEM does: by patch, within it front, south, east, north, west,
/// back.
/// @throws Error bad_format   a face of three patches, or two patches that see its vertices in different
/// cycles
/// @throws Error unsupported  a patch that meets itself
std::vector<MfemFace> mfem_faces(const std::vector<std::array<int, 8>>& patches);

/// The faces of two patches, as their vertices lie on each other.
std::vector<StatedInterface> mfem_interfaces(const MfemTopology& topology);

/// Boundaries "attribute N" by increasing N.
/// @param source  the file's name, for messages
/// @throws Error bad_format or unsupported for an element that is no outer face of a patch, with its line
std::vector<Boundary> mfem_boundaries(const MfemTopology& topology, const std::string& source);

/// The knot vectors of every patch: those of its edges, turned around where the edge runs against the patch.
/// @throws Error bad_format  an edge that is missing, listed twice or superfluous; parallel edges that
/// disagree
std::vector<NurbsVolume::KnotVectors> mfem_spaces(const MfemTopology& topology,
                                                  const std::vector<KnotVector>& knots);

}  // namespace isopatch::geometry

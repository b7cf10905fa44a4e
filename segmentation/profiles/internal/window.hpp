#pragma once

#include <map>
#include <random>
#include <vector>

#include "segmentation/profiles/internal/cell_mesh.hpp"
#include "segmentation/profiles/internal/divide_polygon.hpp"

namespace isopatch::segmentation::planar {

/// Which cells meet.
class Neighbours {
 public:
  explicit Neighbours(const CellMesh& mesh);

  /// The cell on the other side of one, -1 if there is none.
  int across(const Side& side) const;
  int nodes() const { return static_cast<int>(around_.size()); }
  const std::vector<int>& around(int node) const { return around_[static_cast<std::size_t>(node)]; }

 private:
  std::map<SideKey, int> cells_;
  std::vector<std::vector<int>> around_;
};

using Random = std::minstd_rand;

/// Cells of one region that hang together, grown around one of them in a random order.
/// @param room at most so much, a triangle counting 1 and a quadrilateral 2
std::vector<int> window_around(const CellMesh& mesh, const Neighbours& neighbours, int cell, int room,
                               Random& random);

/// The outline of cells that hang together as a polygon: nodes inside are left out with a probability, those
/// that are kept and holes hang on it by sides that are run there and back. Cuts that nothing else uses are
/// optional.
/// @param shared of each curve: whether there are wanted regions on both its sides
std::vector<Place> outline_of(const CellMesh& mesh, const Neighbours& neighbours,
                              const std::vector<int>& cells, const std::vector<bool>& shared,
                              double leave_out, Random& random);

/// The loops around cells that hang together, the outer one first, without what lies inside; nothing if the
/// outline touches itself.
std::vector<std::vector<Place>> loops_of(const std::vector<Curve>& curves, const CellMesh& mesh,
                                         const Neighbours& neighbours, const std::vector<int>& cells,
                                         const std::vector<bool>& shared);

/// One polygon of loops: each is joined to those before it by one of the shortest chords that cross nothing,
/// at random.
/// @return nothing where none is found
std::vector<Place> joined_at_random(const std::vector<Curve>& curves, const std::vector<Node>& nodes,
                                    std::vector<std::vector<Place>> loops, Random& random);

}  // namespace isopatch::segmentation::planar

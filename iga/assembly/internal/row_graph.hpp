#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "iga/assembly/internal/direction_overlap.hpp"
#include "iga/coupling/row_numbering.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Rows begin .. end.
struct RowInterval {
  int begin;
  int end;
};

/// Which rows of a matrix share an element.
class RowGraph {
 public:
  /// @throws Error invalid_argument  parts out of range, a node of a part without a row, a row out of range
  RowGraph(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
           const RowNumbering& numbering);

  int rows() const { return static_cast<int>(node_start_.size()) - 1; }
  /// Fills `found` with the rows from `lowest` on that share an element with `row`, and `row` itself:
  /// disjoint intervals, increasing.
  void neighbours(int row, int lowest, std::vector<RowInterval>& found) const;
  /// How many rows share an element with `row`, itself included.
  /// @param scratch  storage to use again
  std::int64_t neighbour_count(int row, std::vector<RowInterval>& scratch) const;

 private:
  struct Part {
    std::array<std::vector<Overlap>, 3> overlaps;
    std::array<int, 3> sizes;
    int first_node;
    bool simple;  // no other part of this patch, and no two nodes of the patch in one row
  };
  struct Node {
    int part;
    int local;
  };
  std::span<const Node> nodes_of(int row) const;
  std::array<const Overlap*, 3> overlaps_of(const Node& node) const;
  void check(const RowNumbering& numbering) const;
  void mark_simple(const std::vector<PatchLayers>& parts);

  std::vector<Part> parts_;
  const std::vector<int>* row_of_node_;
  std::vector<std::int64_t> node_start_;
  std::vector<Node> nodes_;
};

}  // namespace isopatch::iga

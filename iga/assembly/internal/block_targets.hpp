#pragma once

#include <cstdint>
#include <vector>

#include "iga/assembly/internal/stiffness_tables.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// The rows of a patch's nodes.
struct PatchRows {
  const int* row_of_node = nullptr;  ///< of this patch's first node on
  std::vector<char> shared;          ///< whether another node of the patch has the same row
};
PatchRows patch_rows(const StiffnessTables& tables, const int* row_of_node);

/// What one task works on: functions a with one index in direction 3, some in direction 1, over some element
/// layers of direction 2, paired with all functions b whose index in direction 3 is not smaller.
struct StiffnessTask {
  int third = 0;
  int first_begin = 0;
  int first_end = 0;
  int layer_begin = 0;
  int layer_end = 0;
};

/// Blocks of a task that cannot go straight to their places.
class CollectedBlocks {
 public:
  void clear() { pairs_.clear(); }
  /// Number of a new block, of a pair of nodes with these rows.
  /// @param both  if the rows are equal, whether the transposed block counts too
  int append(int row_a, int row_b, bool both) {
    pairs_.push_back({row_a, row_b, both});
    return static_cast<int>(pairs_.size()) - 1;
  }
  /// Sets all blocks to zero.
  void zero() { values_.assign(9 * pairs_.size(), 0.0); }
  double* values() { return values_.data(); }
  /// Adds the blocks to those rows whose number divided by 64 is `share` modulo `shares`.
  void flush(int share, int shares, solvers::SymmetricBlockMatrix& matrix) const;

 private:
  struct Pair {
    int row_a;
    int row_b;
    bool both;
  };
  std::vector<Pair> pairs_;
  std::vector<double> values_;
};

/// Where the blocks of a task's pairs (a, b) go.
///
/// A block goes straight to its place if a's row is the smaller one and no other node of the patch has it:
/// then no other task writes there. All other blocks are collected and added later, task by task, so that
/// sums do not depend on who is first.
class BlockTargets {
 public:
  static constexpr std::int32_t nowhere = -1;  ///< the pair comes again as (b, a) in the same task

  /// Fills the table of a task; `collected` gets the blocks that have to wait, zero.
  void prepare(const StiffnessTask& task, const StiffnessTables& tables, const PatchRows& rows,
               const solvers::SymmetricBlockMatrix& matrix, CollectedBlocks& collected);

  /// The targets of a line of pairs, b running along direction 1 from the first that overlaps a.
  struct LineTargets {
    bool in_a_row;  ///< all go to consecutive blocks of a's row, from the first target on
    /// Of each pair. At least 0: position in a's row; nowhere; below: the collected block -2 - target.
    const std::int32_t* targets;
  };
  /// @param b_second, b_third  b's indices in directions 2 and 3
  LineTargets line(int a_first, int a_second, int b_second, int b_third) const {
    const std::int32_t* const at = targets_.data() + line_start(a_first, a_second, b_second, b_third);
    return {at[0] != 0, at + 1};
  }

 private:
  std::size_t line_start(int a_first, int a_second, int b_second, int b_third) const {
    const int second = b_second - tables_->overlap(1, a_second).low;
    const int row = (a_first - task_.first_begin) * seconds_ + a_second - second_begin_;
    const int line = (row * thirds_ + b_third - task_.third) * width_second_ + second;
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(width_first_ + 1);
  }

  // Pairs of a node with a node b and those behind it.
  struct Line {
    int a;
    int b;
    int count;
    bool comes_twice;  // the pairs come as (b, a) too
  };
  std::int32_t fill(const Line& line, std::int32_t guess, const PatchRows& rows,
                    const solvers::SymmetricBlockMatrix& matrix, CollectedBlocks& collected,
                    std::int32_t* to) const;

  StiffnessTask task_;
  const StiffnessTables* tables_ = nullptr;
  int second_begin_ = 0;  // first function of direction 2
  int seconds_ = 0;       // functions of direction 2
  int width_second_ = 0, width_first_ = 0, thirds_ = 0;
  std::vector<std::int32_t> targets_;
};

}  // namespace isopatch::iga

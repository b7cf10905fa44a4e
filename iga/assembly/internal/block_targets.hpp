#pragma once

#include <cstddef>
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

/// What one thread works on at a time: functions a with one index in w and some in u, over some element
/// layers of v, paired with all functions b whose index in w is not smaller.
struct StiffnessTask {
  int a_w = 0;
  int u_begin = 0;
  int u_end = 0;
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
  void zero() { values_.assign(solvers::block_entries * pairs_.size(), 0.0); }
  double* block(std::ptrdiff_t number) { return values_.data() + solvers::block_entries * number; }
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

/// Where the block of a pair (a, b) goes.
struct Target {
  enum class Where : std::uint32_t {
    a_row,      ///< to the block `at` of a's row
    run,        ///< the same; and the following pairs of the line to the blocks behind it
    collected,  ///< to the collected block `at`
    nowhere,    ///< its transpose is computed in this task as well, as (b, a)
  };
  Target() = default;
  Target(Where to, std::uint32_t position) : where(to), at(position) {}

  Where where : 2;
  std::uint32_t at : 30;
};
static_assert(sizeof(Target) == 4, "targets are read as often as blocks are written");

/// Where the blocks of a task's pairs (a, b) go.
///
/// A block goes straight to its place if a's row is the smaller one and no other node of the patch has it:
/// then no other task writes there. All other blocks are collected and added later, task by task, so that
/// sums do not depend on who is first.
class BlockTargets {
 public:
  /// Fills the table of a task; `collected` gets the blocks that have to wait, zero.
  void prepare(const StiffnessTask& task, const StiffnessTables& tables, const PatchRows& rows,
               const solvers::SymmetricBlockMatrix& matrix, CollectedBlocks& collected);

  /// The targets of a line of pairs, b running along u from the first that overlaps a. Only the first one can
  /// be a `run`.
  const Target* line(int a_u, int a_v, int b_v, int b_w) const {
    return targets_.data() + line_start(a_u, a_v, b_v, b_w);
  }

 private:
  std::size_t line_start(int a_u, int a_v, int b_v, int b_w) const {
    const int row = (a_u - task_.u_begin) * count_v_ + a_v - v_begin_;
    const int line = (row * count_w_ + b_w - task_.a_w) * width_v_ + b_v - tables_->overlap(1, a_v).low;
    return static_cast<std::size_t>(line) * static_cast<std::size_t>(width_u_);
  }

  // Pairs of a node with a node b and those behind it.
  struct Line {
    int a;
    int b;
    int count;
    bool comes_twice;  // the pairs come as (b, a) too
  };
  std::uint32_t fill(const Line& line, std::uint32_t guess, const PatchRows& rows,
                     const solvers::SymmetricBlockMatrix& matrix, CollectedBlocks& collected,
                     Target* to) const;

  StiffnessTask task_;
  const StiffnessTables* tables_ = nullptr;
  int v_begin_ = 0;                // first function a and b of v
  int count_v_ = 0, count_w_ = 0;  // functions a of v, b of w
  int width_u_ = 0, width_v_ = 0;  // most functions b that overlap a function a
  std::vector<Target> targets_;    // [a of u][a of v][b of w][b of v][b of u]
};

}  // namespace isopatch::iga

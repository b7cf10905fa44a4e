#pragma once

#include <cstddef>
#include <vector>

#include "iga/assembly/internal/block_targets.hpp"
#include "iga/assembly/internal/stiffness_tables.hpp"
#include "iga/internal/small_products.hpp"
#include "iga/material/material.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

/// The numbers of QuadratureGeometry for some element layers of v.
struct PointData {
  const double* values = nullptr;  ///< [point of v][block of u][point of w][component]
  int layer_begin = 0;
  int blocks = 0;
  int points_w = 0;  ///< from the part's first layer on
  int components = 9;

  /// The values at the points along w of one block along u, for the point `v`: [point of w][component].
  const double* block(int v, int block, int w) const;
};

/// Input that all tasks of a patch share.
struct PatchIntegrand {
  const StiffnessTables& tables;
  const PatchRows& rows;
  const Material& material;
  const double* weights;  ///< of rational functions, of the whole patch, or null
};

/// Integrates the blocks of one task after the other; one such object for each thread. How, and what the
/// indices mean: iga/assembly/README.md, "How the matrix is made".
///
/// For each element layer of v it walks along u. The contraction of w runs ahead for the points of u,
/// register by register, and leaves its sums in a ring that holds the support of one function; u is
/// contracted for one function a and all b; then v within the layer.
///
/// @cost  flops per function a at degree p, inside a patch: 81 (p+1)^4 (p+2) for w, 162 (p+1)^5 for u,
///        72 (p+1)^4 (2p+1) for v
class StiffnessIntegrator {
 public:
  /// Adds the blocks of a task to the matrix, or to `collected`, as `targets` says.
  void run(const StiffnessTask& task, const PatchIntegrand& patch, const PointData& points,
           const BlockTargets& targets, CollectedBlocks& collected, solvers::SymmetricBlockMatrix& matrix);

 private:
  struct Range {
    int begin;
    int end;
  };
  void choose_sizes();
  void choose_offsets();
  void contract_w(int block, int layer);
  void contract_w_at(const double* from);
  void scale_points(const double* from, int function, const Range& range, double* to) const;
  void contract_u(int a);
  void contract_v(int a, int layer);
  void add(int a, int layer, const BlockTargets& targets, CollectedBlocks& collected,
           solvers::SymmetricBlockMatrix& matrix) const;
  Range common_points(int b) const;

  const StiffnessTables* tables_ = nullptr;
  const PatchIntegrand* patch_ = nullptr;
  const PointData* points_ = nullptr;
  StiffnessTask task_;
  Range group_ = {0, 0};  // functions b of w that are worked on together
  int per_point_ = 0;     // numbers of one kind at a point of v: nine for each b of the group
  int line_ = 0;          // of all points of the layer, in whole registers
  int ring_blocks_ = 0;   // of points of u
  int pair_step_ = 0;     // from pair to pair in blocks_, in whole registers

  std::vector<double> operand_a_;  // X: [point of w][s][i][lane]
  std::vector<double> operand_b_;  // Y
  std::vector<double> sums_;       // S: [kind][b of w][i][j][lane]
  std::vector<double> ring_;       // S: [point of u][kind][point of v][b of w][i][j]
  std::vector<double> line_sums_;  // R: [b of u][kind][point of v][b of w][i][j]
  std::vector<double> blocks_;     // K: [a of v][b of v][b of u][b of w][i][j]
  SmallProducts products_u_;
  SmallProducts products_v_;
  std::vector<int> offsets_u_;  // in the ring, of each term of each element
  std::vector<int> offsets_v_;  // in the sums of a line
};

}  // namespace isopatch::iga

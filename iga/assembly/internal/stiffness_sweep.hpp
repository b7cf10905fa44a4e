#pragma once

#include <vector>

#include "iga/assembly/internal/block_targets.hpp"
#include "iga/assembly/internal/stiffness_tables.hpp"
#include "iga/internal/small_products.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// The numbers of QuadratureGeometry for some element layers of direction 2.
struct PointData {
  const double* values =
      nullptr;  ///< [point of direction 2][block of direction 1][point of direction 3][component]
  int layer_begin = 0;
  int blocks = 0;
  int thirds = 0;  ///< points of direction 3, from the part's first layer on
  int components = 9;

  /// Points of one block along direction 3.
  const double* block(int second, int block, int third) const;
};

/// Computes the blocks of one task after the other; one for each thread.
///
/// For each element layer of direction 2 it walks along direction 1. The contraction of direction 3 runs
/// ahead for the points of direction 1, register by register, and leaves its sums in a ring that holds the
/// support of one function; direction 1 is contracted for one function a and all b; then direction 2 within
/// the layer.
///
/// @cost  flops per function a at degree p, inside a patch: 81 (p+1)^4 (p+2) for direction 3, 162 (p+1)^5 for
///        direction 1, 72 (p+1)^4 (2p+1) for direction 2
class StiffnessSweep {
 public:
  /// @param weights  w of rational functions, of the whole patch, or null
  void run(const StiffnessTask& task, const StiffnessTables& tables, const PointData& points,
           const Material& material, const double* weights, const PatchRows& rows,
           const BlockTargets& targets, CollectedBlocks& collected, solvers::SymmetricBlockMatrix& matrix);

 private:
  struct Range {
    int begin;
    int end;
  };
  void choose_sizes();
  void choose_offsets();
  void contract_third(int block, int layer);
  void contract_third_at(const double* from);
  void scale_points(const double* from, int function, const Range& range, double* to) const;
  void contract_first(int a);
  void contract_second(int a, int layer);
  void add(int a, int layer, const PatchRows& rows, const BlockTargets& targets, CollectedBlocks& collected,
           solvers::SymmetricBlockMatrix& matrix);
  Range third_points(int b) const;

  const StiffnessTables* tables_ = nullptr;
  const PointData* points_ = nullptr;
  const double* weights_ = nullptr;
  Material material_;
  StiffnessTask task_;
  Range group_ = {0, 0};  // functions b of direction 3
  int per_point_ = 0;     // numbers of one kind at a point of direction 2: nine for each b of the group
  int line_ = 0;          // of all points of the layer, in whole registers
  int ring_blocks_ = 0;
  int pair_step_ = 0;

  std::vector<double> first_operand_;  // [point of direction 3][s][i][lane]
  std::vector<double> second_operand_;
  std::vector<double> sums_;       // [kind][b][i][j][lane]
  std::vector<double> ring_;       // [point of direction 1][kind][point of direction 2][b][i][j]
  std::vector<double> line_sums_;  // [b of direction 1][kind][point of direction 2][b][i][j]
  std::vector<double> blocks_;     // [pair of direction 2][b of direction 1][b of direction 3][i][j]
  SmallProducts first_products_;
  SmallProducts second_products_;
  std::vector<int> first_offsets_;   // in the ring, of each element's terms
  std::vector<int> second_offsets_;  // in the sums of a line
};

}  // namespace isopatch::iga

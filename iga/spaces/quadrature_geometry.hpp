#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "iga/spaces/element_tables.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// What an elasticity integral needs of a patch's geometry at the Gauss points of a space's elements.
///
/// For a point with quadrature weight w it is G = sqrt(w det J) J^-1, nine numbers g[3 alpha + i] (i the
/// coordinate, alpha the parameter): the product of the gradients of two functions, integrated, is the sum
/// over the points of (sum_alpha dN_a/dxi_alpha g[3 alpha + i]) (sum_beta dN_b/dxi_beta g[3 beta + j]). For
/// rational functions N_a = w_a B_a / W it is G / W, followed by three more numbers h[i] = - sum_alpha g[3
/// alpha + i] (dW/dxi_alpha) / W that multiply B_a itself.
///
/// The geometry is evaluated in its own knots, which may be finer or coarser than the functions'.
class QuadratureGeometry {
 public:
  /// @param space   must outlive this
  /// @param points  Gauss points per element and direction; 0: as many as the space says
  QuadratureGeometry(const PatchSpace& space, int points);

  /// The functions of direction d at its points.
  const DirectionTable& table(int d) const { return tables_[static_cast<std::size_t>(d)]; }
  /// Gauss points of an element along direction d.
  int points_per_element(int d) const;
  /// Gauss points of the whole patch along direction d.
  int points(int d) const;
  /// Numbers at a point: 9, or 12 for rational functions.
  int components() const { return space_->is_rational() ? 12 : 9; }

  /// Points of direction 1 come in blocks of this many; the last block is filled up with zeros.
  static const int block_size;
  int blocks() const { return (points(0) + block_size - 1) / block_size; }

  /// Evaluates the points that have index j in direction 2 and begin .. end - 1 in direction 3.
  ///
  /// @param out   numbers of the point (i, j, k) at ((i / block_size) * stride + (k - begin)) *
  /// components() *
  ///              block_size, those of one kind for the points of a block side by side
  /// @param stride  at least end - begin
  /// @param patch   for messages
  /// @throws Error fold_over  det J <= 0, naming patch, parameter (the input's names) and place
  /// @cost   about 24 (degree + 1) + 100 flops per point, 32 (degree + 1) + 120 for rational geometry
  void evaluate(int j, int begin, int end, double* out, int stride, int patch) const;

 private:
  // The functions of a knot vector that live at each Gauss point of a direction.
  struct AtPoints {
    int functions = 0;
    std::vector<int> first;
    std::vector<double> values;  // [point * functions + function]
    std::vector<double> derivatives;
  };
  // A scalar or vector spline between two steps: [plane of direction 3][V V, D V, V D][component][point].
  struct Lines {
    int first_plane = 0;
    int fields = 0;
    std::vector<double> values;
  };
  AtPoints tabulate(const geometry::KnotVector& knots, int d) const;
  AtPoints tabulate_own(int d) const;
  Lines lines(const Eigen::Matrix4Xd& coefficients, const std::array<AtPoints, 3>& at,
              const std::array<int, 2>& sizes, int components, int j, int begin, int end) const;
  [[noreturn]] void refuse_fold(int j, int begin, int end, int patch) const;

  const PatchSpace* space_;
  std::array<DirectionTable, 3> tables_;
  std::array<std::vector<double>, 3> nodes_;
  std::array<std::vector<double>, 3> weights_;
  std::array<AtPoints, 3> geometry_at_;
  std::array<AtPoints, 3> functions_at_;  // of rational functions
  Eigen::Matrix4Xd homogeneous_;
  Eigen::Matrix4Xd function_weights_;  // in the first row
};

}  // namespace isopatch::iga

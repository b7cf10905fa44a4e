#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Values or derivatives of a line's functions at points: (points, functions).
using LineTable = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// The functions of a side of a patch that are not 0 there, and those beside them, by their two directions.
class SideFunctions {
 public:
  /// @param space       must outlive this
  /// @param first_node  of the patch, among those of all patches
  SideFunctions(const PatchSpace& space, geometry::Side side, int first_node);

  const PatchSpace& space() const { return *space_; }
  geometry::Side side() const { return side_; }
  /// Along a direction of the side, 0 or 1.
  const geometry::KnotVector& knots(int along) const;
  /// The node of a function: (i, j) of the side itself, layer 0, or of those behind it, layer 1.
  int node(int i, int j, int layer) const {
    return first_ + stride_[0] * i + stride_[1] * j + behind_ * layer;
  }
  /// The weight of such a function; 1 for polynomials.
  double weight(int i, int j, int layer) const;
  /// The derivative, by the parameter across the side, of the across factor of layer 0 and of layer 1 there.
  const std::array<double, 2>& slope() const { return slope_; }

 private:
  const PatchSpace* space_;
  geometry::Side side_;
  int first_node_;
  int first_;  // node at (0, 0) of layer 0
  std::array<int, 2> stride_;
  int behind_;
  std::array<double, 2> slope_;
};

/// A sheet of a patch, at one parameter across a side, at all pairs of parameters along it, the first
/// fastest.
struct Sheet {
  std::array<Eigen::Matrix3Xd, 2> along;  ///< derivatives by the parameters of the side, m
  Eigen::Matrix3Xd across;                ///< derivative by the parameter across it, m
};
Sheet sheet(const geometry::NurbsVolume& patch, geometry::Side side, double across,
            const std::array<std::vector<double>, 2>& along);

/// W = sum of the weighted B-splines of all functions on a side and its derivatives along both directions and
/// across: (4, points). Without derivatives, (1, points); nothing to do with polynomials, whose W is 1.
Eigen::MatrixXd weight_sums(const SideFunctions& functions, const std::array<std::vector<double>, 2>& along,
                            bool derivatives);

/// (degree + 1)^2 / thickness of the elements behind a side, 1/m, (elements of direction 0, of direction 1):
/// for strains that are polynomials along the lines across an element, the most that their square on the side
/// is of their square in the element. The thickness is the least found at 27 points of it.
Eigen::MatrixXd trace_constants(const SideFunctions& functions);

/// Gauss points of a cell that is a rectangle on both sides, along the directions of the first: as many as
/// the maps of both patches need.
std::array<int, 2> points_of_rectangle(const SideFunctions& own, const SideFunctions& other);

}  // namespace isopatch::iga

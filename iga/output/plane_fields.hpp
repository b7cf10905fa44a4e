#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/patch_face.hpp"
#include "geometry/splines/grid.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// Points at which a map is folded or has no volume, so that its stress there means nothing.
struct BorrowedStress {
  std::int64_t count = 0;
  std::int64_t of = 0;                              ///< points looked at
  int patch = -1;                                   ///< of the worst one
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< of the worst one, m
  double scaled_jacobian = 1;                       ///< there

  void add(const BorrowedStress& other);
};

/// All fields at the points of one plane of a grid, the first direction fastest.
struct FieldPlane {
  Eigen::Matrix3Xd points;             ///< m
  Eigen::Matrix3Xd displacement;       ///< m
  Eigen::MatrixXd strain;              ///< (6, points): xx, yy, zz, xy, yz, zx
  Eigen::MatrixXd stress;              ///< the same, Pa
  Eigen::RowVectorXd von_mises;        ///< of this stress, Pa
  Eigen::Matrix3Xd principal;          ///< its principal stresses, the largest first, Pa
  Eigen::RowVectorXd tresca;           ///< the first of these minus the last, Pa
  Eigen::RowVectorXd scaled_jacobian;  ///< det J over the product of its columns' lengths, -1 .. 1
  Eigen::RowVectorXd weights;          ///< the denominator of rational functions
  std::vector<char> is_borrowed;       ///< whether the point's stress means nothing, and is that of another
  BorrowedStress borrowed;             ///< these points
};

/// The fields of one patch on a grid of parameters, evaluated from the coefficients, a plane of direction 3
/// at a time.
///
/// Where derivatives jump inside a patch (at knots of multiplicity degree), strain and stress are the mean of
/// the sides. Where the map is folded or nearly so, they are those of the nearest good point on the way to
/// the patch's middle, and the point counts as left out; where an edge is one point, they are those a
/// thousandth of that way inside.
class PlaneFields {
 public:
  /// @param field       must outlive this
  /// @param parameters  increasing, per direction
  PlaneFields(const ElasticField& field, int patch, const geometry::GridParameters<3>& parameters);
  ~PlaneFields();
  PlaneFields(PlaneFields&&) noexcept;

  std::array<int, 3> sizes() const;
  /// Plane k of direction 3, valid until the next call; its points may be changed.
  /// @cost  O(degree) per point and function across, and 0.1 us; in parallel, the same for any number of
  /// threads
  FieldPlane& plane(int k);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Whether the Jacobian at a point is regular enough for a stress there to be meaningful.
/// @param typical  scaled Jacobian at the patch's middle
bool is_usable(double scaled_jacobian, double typical);

}  // namespace isopatch::iga

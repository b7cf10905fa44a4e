#pragma once

#include <Eigen/Core>
#include <array>

#include "iga/material/material.hpp"
#include "iga/problem/unresolved_energy.hpp"
#include "iga/spaces/gauss_points.hpp"

namespace isopatch::iga {

/// Stresses at the Gauss points of an element, xx, yy, zz, xy, yz, zx; first direction fastest.
using PointStresses = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// The part of the stresses in an element that needs polynomials of the functions' full degree. Displacements
/// that the functions represent well leave almost nothing there.
class HighestModes {
 public:
  /// @param degrees  of the displacements along the three directions
  HighestModes(const GaussPoints& points, const std::array<int, 3>& degrees);

  /// @param measures  quadrature weights times det J of the points, m^3
  /// @param buffer    storage that is used again
  /// @cost  18 points per direction operations a point
  UnresolvedEnergy energies(const PointStresses& stresses, const Eigen::VectorXd& measures,
                            const Material& material, PointStresses& buffer) const;

 private:
  GaussPoints points_;
  std::array<Eigen::MatrixXd, 3> remainder_;  // (points, points): what lower polynomials leave
};

}  // namespace isopatch::iga

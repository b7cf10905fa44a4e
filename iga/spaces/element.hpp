#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {

/// Everything an integral over one element needs. n functions, q points; first direction fastest in both.
struct ElementValues {
  std::vector<int> functions;                ///< local indices of the n functions
  std::array<Eigen::MatrixXd, 3> gradients;  ///< d/dx, d/dy, d/dz of each function at each point: (n, q), 1/m
  Eigen::MatrixXd values;                    ///< (n, q)
  Eigen::VectorXd measures;                  ///< quadrature weight times det J, m^3
  Eigen::VectorXd jacobians;                 ///< det J, m^3 per parameter^3
  Eigen::Matrix3Xd places;                   ///< (3, q), m
};

/// Evaluates the elements of one patch, each knot span between breaks being one.
class ElementEvaluator {
 public:
  /// @param points  quadrature points per element and direction; 0: degree + 1 in each
  ElementEvaluator(const geometry::NurbsVolume& patch, int points);
  /// With the given rule in each direction, for example at points of evaluation.
  ElementEvaluator(const geometry::NurbsVolume& patch, const std::array<geometry::QuadratureRule, 3>& rules);

  std::int64_t element_count() const { return tables_.element_count(); }
  /// Fills `values`, whose storage is used again from element to element.
  void evaluate(std::int64_t element, ElementValues& values) const;
  /// Parameter of a quadrature point.
  geometry::Parameter<3> parameter(std::int64_t element, Eigen::Index point) const {
    return tables_.parameter(element, point);
  }

 private:
  const geometry::NurbsVolume* patch_;
  ElementTables tables_;
};

}  // namespace isopatch::iga

#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/quadrature.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::iga {

/// Basis functions of one direction, evaluated at the quadrature points of every element.
struct DirectionTable {
  /// One element: functions first .. first + degree at its points.
  struct Element {
    int first = 0;
    Eigen::MatrixXd values;       ///< (points, degree + 1)
    Eigen::MatrixXd derivatives;  ///< (points, degree + 1)
    Eigen::VectorXd nodes;        ///< parameters of the points
    Eigen::VectorXd weights;      ///< quadrature weights, scaled to the element
  };
  std::vector<Element> elements;
};
/// @param rule  on [0, 1]
DirectionTable direction_table(const geometry::KnotVector& knots, const geometry::QuadratureRule& rule);

/// The tables of a patch's three directions, whose elements are the knot spans between breaks; direction 1
/// fastest in the numbers of elements and of points.
class ElementTables {
 public:
  /// @param rules  points and weights on [0, 1], of each direction
  ElementTables(const geometry::NurbsVolume& patch, const std::array<geometry::QuadratureRule, 3>& rules);
  /// Gauss points; 0: degree + 1 of them in each direction.
  ElementTables(const geometry::NurbsVolume& patch, int points);

  std::int64_t element_count() const;
  std::array<const DirectionTable::Element*, 3> of(std::int64_t element) const {
    std::array<const DirectionTable::Element*, 3> result;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto count = static_cast<std::int64_t>(directions_[d].elements.size());
      result[d] = &directions_[d].elements[static_cast<std::size_t>(element % count)];
      element /= count;
    }
    return result;
  }
  /// Parameter of a quadrature point.
  geometry::Parameter<3> parameter(std::int64_t element, Eigen::Index point) const;

 private:
  std::array<DirectionTable, 3> directions_;
};

}  // namespace isopatch::iga

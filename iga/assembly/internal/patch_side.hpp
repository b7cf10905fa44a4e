#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/common_refinement.hpp"
#include "geometry/patch_face.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// An element of a side, per direction along it.
using ElementOfFace = std::array<int, 2>;

/// A side of a patch with the functions that live on its elements, for integrals between patches.
class PatchSide {
 public:
  /// @param space       must outlive this
  /// @param first_node  of the patch, among those of all patches
  PatchSide(const PatchSpace& space, geometry::Side side, int first_node);

  /// The side in the elements of its functions; lives as long as this does.
  geometry::DividedSurface divided() const;
  /// The highest degree of the patch.
  int degree() const;
  /// Knots along a direction of the side, 0 or 1.
  const geometry::KnotVector& knots(int along) const;

  /// Elements along a direction of the side, 0 or 1.
  int elements(int along) const { return knots(along).element_count(); }
  /// The corner of lowest parameters of the volume's element behind an element of the side, and its extent.
  std::array<geometry::Parameter<3>, 2> box_behind(const ElementOfFace& of_face) const;

  /// The volume's element behind an element of the side, per direction.
  std::array<int, 3> element(const ElementOfFace& of_face) const;

  /// The functions that are not 0, or have no gradient 0, on an element of the side, at one point.
  struct Functions {
    std::vector<int> nodes;        ///< of all patches
    std::vector<bool> is_on_side;  ///< whether the function is not 0 on the side
    std::vector<double> values;
    std::vector<Eigen::Vector3d> gradients;  ///< in space, 1/m
    Eigen::Vector3d normal;                  ///< outward
  };
  Functions functions(const ElementOfFace& of_face, const geometry::Parameter<2>& on_side) const;
  /// The same at a point of the volume's element behind; the normal is that of the sheet through the point.
  Functions functions_behind(const ElementOfFace& of_face, const geometry::Parameter<3>& at) const;

 private:
  // @param layers  of functions from the side inwards
  Functions functions_of_layers(const ElementOfFace& of_face, const geometry::Parameter<3>& at,
                                int layers) const;
  void add_functions(const std::array<Eigen::MatrixXd, 3>& bases, const std::array<int, 3>& first, int layers,
                     Functions& result) const;

  const PatchSpace& space_;
  geometry::Side side_;
  int first_node_;
  geometry::NurbsSurface surface_;
  std::array<int, 2> along_;
  std::array<std::vector<double>, 3> breaks_;
};

/// Gauss points per direction of a cell that two sides share: what is integrated has twice the degree, and
/// areas are no polynomials.
int points_of_cell(const PatchSide& first, const PatchSide& second);

}  // namespace isopatch::iga

#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// The functions of one patch, over the exact geometry below them: N_a = w_a B_a / W with W = sum w_b B_b, or
/// just B-splines. First direction fastest.
///
/// The functions may be coarser than the geometry (levels of a multigrid) or be the geometry's own
/// (isoparametric, the solution space).
struct PatchSpace {
  const geometry::NurbsVolume* geometry = nullptr;  ///< must outlive the space
  std::array<geometry::KnotVector, 3> knots;        ///< of the functions
  Eigen::VectorXd weights;                          ///< w, one per function; empty: polynomial
  bool reversed = false;  ///< whether the input has the first direction the other way round; for messages
  GaussPoints points = {0, 0, 0};  ///< per element of the functions; 0: degree + 1

  std::array<int, 3> sizes() const { return {knots[0].size(), knots[1].size(), knots[2].size()}; }
  int size() const { return knots[0].size() * knots[1].size() * knots[2].size(); }
  bool is_rational() const { return weights.size() > 0; }
  /// Gauss points along a direction if `asked` for so many everywhere, or with 0 for what suits the space.
  int points_along(int direction, int asked) const {
    const auto d = static_cast<std::size_t>(direction);
    return asked > 0 ? asked : points[d] > 0 ? points[d] : knots[d].degree() + 1;
  }
};

/// The elements of one patch whose third knot span is one of first_layer .. last_layer - 1: a whole patch, or
/// the share of it that one process integrates, perhaps none.
struct PatchLayers {
  int patch = 0;
  int first_layer = 0;
  int last_layer = 0;
  bool couples = true;  ///< also what ties the patch where its sides do not match others
};

/// The solution space's own functions, one space per patch, pointing into `discretization`.
std::vector<PatchSpace> isoparametric_spaces(const Discretization& discretization);

/// The first node of every patch, and the number of nodes at the end.
std::vector<int> first_nodes(const std::vector<PatchSpace>& spaces);

/// Every patch as a whole.
std::vector<PatchLayers> whole_patches(const std::vector<PatchSpace>& spaces);

}  // namespace isopatch::iga

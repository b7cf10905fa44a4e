#pragma once

#include <map>
#include <optional>
#include <vector>

#include "app/pictures/surface.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/output/part_samples.hpp"

namespace isopatch::app {

/// What the colours of a picture show.
enum class PictureField { none, patch, jacobian, displacement, von_mises, conditions };

struct ShapeOptions {
  PictureField field = PictureField::patch;
  std::optional<int> component;  ///< of the displacement, 0 .. 2; its length otherwise
  double deformation = 0;        ///< how many times the displacement is added to the points
};

/// A patch on its grid, first direction fastest, as it is drawn.
struct PatchShape {
  std::array<int, 3> sizes{};
  std::array<std::vector<int>, 3> element_ends;
  Eigen::Matrix3Xd undeformed;
  Eigen::Matrix3Xd points;
  Eigen::VectorXd values;  ///< SI units; the patch's number for `patch`, zeros for `none` and `conditions`

  int index(int i, int j, int k) const { return i + sizes[0] * (j + sizes[1] * k); }
};

/// @throws Error invalid_argument for a field of a solution where there is none
std::vector<PatchShape> part_shape(const iga::PartSamples& samples, const ShapeOptions& options);

/// A round factor (1, 2 or 5 times a power of ten) that makes the largest displacement 4 to 10 % of the
/// model's size; 1 where nothing moves or there is no solution.
double visible_deformation(const iga::PartSamples& samples, double model_size);

/// The faces that no other patch shares, with normals.
/// @param values  one for all points of some of these faces, in place of the patches' own
Surface outer_surface(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape,
                      const std::map<geometry::PatchFace, double>& values = {});

/// Edges of the outer faces.
Lines patch_edges(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape);

/// Ends of the elements on the outer faces, without the faces' own edges.
Lines element_edges(const geometry::MultiPatch& model, const std::vector<PatchShape>& shape);

}  // namespace isopatch::app

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/pictures/layout.hpp"
#include "app/pictures/surface.hpp"

namespace isopatch::app {

/// Where one looks from, in parallel projection. The three vectors are orthonormal, right x up = toward_eye.
struct View {
  Eigen::Vector3d toward_eye = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
};

/// The names that `named_view` knows.
std::vector<std::string> view_names();

/// From a named side: "front" looks along y, "right" against x, "top" against z; "iso" from the right, the
/// front and above.
/// @return  nothing for an unknown name
std::optional<View> named_view(const std::string& name);

/// @param toward_eye  from the part to the eye, any length
/// @param up          what is to point upwards; nothing: z, or y when looking along z
/// @throws Error invalid_argument  no direction, or an `up` along it
View view_from(const Eigen::Vector3d& toward_eye, const std::optional<Eigen::Vector3d>& up);

struct Camera {
  View view;
  Eigen::Vector3d focus = Eigen::Vector3d::Zero();  ///< in the middle of the picture
  double height = 1;                                ///< of the picture, model units
};

/// Where a point appears: pixels from the lower left of the picture.
Eigen::Vector2d pixel(const Camera& camera, const Eigen::Vector3d& point, const PictureSize& size);

/// The camera that fills a box of the picture with a surface and centres it there.
/// @param zoom  above 1: larger than the box
Camera fitted(const View& view, const Eigen::Matrix3Xd& points, const Layout& layout, double zoom);

}  // namespace isopatch::app

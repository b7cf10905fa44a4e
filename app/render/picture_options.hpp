#pragma once

#include <optional>
#include <string>

#include "app/pictures/camera.hpp"
#include "app/pictures/clip.hpp"
#include "app/pictures/part_shape.hpp"
#include "app/pictures/value_scale.hpp"

namespace isopatch::app {

/// The options of `isopatch render` in words, as they are typed. Empty: the default for the input.
struct PictureWords {
  std::string field;                 ///< --field: von_mises, displacement, patch, jacobian, conditions, none
  std::string component;             ///< --component: x, y or z of the displacement
  std::string range;                 ///< --range "0,300 MPa"
  double percentile = 99.9;          ///< --percentile: of the surface's area that the range holds
  std::string deformation = "auto";  ///< --deformation: auto or a factor
  std::string view = "iso";          ///< --view: a name or X,Y,Z toward the eye
  std::string up;                    ///< --up: x, y, z or X,Y,Z
  double zoom = 1;                   ///< --zoom
  std::string size = "1600x1200";    ///< --size, pixels
  std::string edges = "patches";     ///< --edges: patches, elements, none
  std::string clip;                  ///< --clip "x=20 mm"
  std::optional<std::string> caption;  ///< --caption; "" for none
  bool transparent = false;
  bool no_bar = false;
};

enum class PictureEdges { none, patches, elements };

/// The same, understood.
struct PictureOptions {
  PictureField field = PictureField::patch;
  std::optional<int> component;
  std::optional<ValueRange> range;  ///< SI units
  double percentile = 99.9;
  std::optional<double> deformation;  ///< a visible one if not given
  View view;
  double zoom = 1;
  PictureSize size;
  PictureEdges edges = PictureEdges::patches;
  std::optional<Cut> cut;  ///< m
  std::optional<std::string> caption;
  bool transparent = false;
  bool bar = true;
};

/// @param has_results  whether the input has a solution; its von Mises stress is shown by default, else the
/// patches
/// @throws Error invalid_argument  naming the option, what was given and what is expected
PictureOptions parse_picture_options(const PictureWords& words, bool has_results);

}  // namespace isopatch::app

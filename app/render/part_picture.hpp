#pragma once

#include <string>

#include "app/pictures/picture.hpp"
#include "app/render/picture_options.hpp"
#include "app/results/load_input.hpp"

namespace isopatch::app {

/// A picture, and the same in words.
struct PartPicture {
  Picture picture;
  std::string description;  ///< "von Mises stress 0 to 350 MPa (largest 338.7 MPa), deformation x20"
};

/// Composes the picture of a model or of results; draws nothing yet.
/// @throws Error invalid_argument  a cut that leaves nothing
PartPicture part_picture(const LoadedInput& input, const PictureOptions& options);

}  // namespace isopatch::app

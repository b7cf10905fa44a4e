#pragma once

#include <Eigen/Core>
#include <string>

#include "app/internal/json_values.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/part_samples.hpp"

namespace isopatch::app {

/// Numbers for a page: little-endian single precision in base64, columns one after the other.
std::string number_block(const Eigen::MatrixXd& values);

/// A unit that suits values of a size: "um" with 1e6 for displacements.
struct DisplayUnit {
  std::string name;
  double factor = 1;  ///< display = SI * factor
};
/// @param si_unit  "m" or "Pa"
DisplayUnit display_unit(double largest, const std::string& si_unit);

/// The part with displacement, von Mises stress and scaled Jacobian for the viewer of the pages; supports,
/// loads, markers and warnings are empty.
Json part_scene(const geometry::MultiPatch& model, const iga::PartSamples& samples,
                const iga::SamplingOptions& options);

}  // namespace isopatch::app

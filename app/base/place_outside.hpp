#pragma once

#include <string>

#include "geometry/multi_patch.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::app {

/// "the point ... lies 2 mm outside the part; the nearest patch is 3", and for points far away that numbers
/// without a unit are metres.
/// @param location  of the nearest point of the model
std::string outside_text(const geometry::MultiPatch& model, const Eigen::Vector3d& point,
                         const iga::Location& location);

}  // namespace isopatch::app

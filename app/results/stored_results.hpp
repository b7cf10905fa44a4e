#pragma once

#include <optional>
#include <string>

#include "iga/output/result_file.hpp"

namespace isopatch::app {

/// Where stored results are asked for values: a point (m), or a patch with a parameter in the input's naming.
struct StoredProbe {
  std::optional<Eigen::Vector3d> point;
  std::optional<int> patch;
  geometry::Parameter<3> parameter = geometry::Parameter<3>::Zero();
};

struct StoredValues {
  int patch = 0;
  geometry::Parameter<3> parameter;  ///< in the input's naming
  iga::FieldValues values;
};

/// @throws Error invalid_argument  no such patch, a parameter outside its knots, a point more than 1e-4 of
/// the model's
///                                 size away from the part
StoredValues probe(const iga::StoredResult& result, const StoredProbe& where);

/// "0.1,0,20 mm": three lengths; a unit at the end of one counts for that one only.
Eigen::Vector3d parse_point(const std::string& text);
/// ".5,.5,1": three numbers.
Eigen::Vector3d parse_parameter(const std::string& text);

}  // namespace isopatch::app

#pragma once

#include <optional>
#include <string>

namespace isopatch::app {

/// The largest values that a run found and wrote into its summary. Whatever shows the results says these,
/// though it samples the fields at other points.
struct LargestValues {
  std::optional<double> displacement;  ///< m
  std::optional<double> von_mises;     ///< Pa; nothing in summaries that looked at Gauss points only
};
/// @param summary  of a run, JSON; nothing is found in any other text
LargestValues largest_values(const std::string& summary);

}  // namespace isopatch::app

#pragma once

#include <optional>
#include <vector>

namespace isopatch::app {

/// Whether a change is as small as solvers' errors.
bool is_settled(double value, double before);

/// The limit of a sequence by its last three values (Aitken), or nothing where their changes do not shrink:
/// those as small as solvers' errors or that grow have no limit that could be told.
std::optional<double> extrapolated(const std::vector<double>& values);

/// Whether the last three values grow without slowing down, as a stress does where it has no limit.
bool grows(const std::vector<double>& values);

}  // namespace isopatch::app

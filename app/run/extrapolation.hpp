#pragma once

#include <optional>
#include <vector>

namespace isopatch::app {

/// Whether a change is as small as solvers' errors.
bool is_settled(double value, double before);

/// The limit of a sequence, and by how much it may be wrong.
struct Extrapolation {
  double limit = 0;
  double doubt =
      0;  ///< what the last value has changed in the limit; of three values all that was added to the last
};

/// The limit of the energies of a refinement by the last three (Aitken), or nothing where their changes do
/// not shrink: those as small as solvers' errors or that grow have no limit that could be told. Changes that
/// shrink by less than half are followed as if they shrank by half, as they do at a crack: the limit is then
/// rather too near.
std::optional<Extrapolation> extrapolated(const std::vector<double>& values);

/// Whether the last three values grow without slowing down, as a stress does where it has no limit.
bool grows(const std::vector<double>& values);

}  // namespace isopatch::app

#pragma once

#include <string>
#include <vector>

#include "app/run/compare_couplings.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// compare.json; SUMMARY.md documents its keys.
/// @param levels  at least one, the finest last
std::string comparison_json(const Study& study, const std::vector<CouplingComparison>& levels);

/// The table of one comparison for the terminal.
std::string comparison_text(const Study& study, const CouplingComparison& comparison);

/// The table of several levels: one line for each coupling of each.
std::string levels_text(const std::vector<CouplingComparison>& levels);

/// "relative difference ... in displacement, ... (allowed ...)", for a comparison that disagrees.
std::string disagreement_text(const CouplingComparison& comparison);

/// The limit of the internal energies of the last three levels (Aitken), or nothing where these do not
/// converge.
std::optional<double> extrapolated_energy(const std::vector<CouplingComparison>& levels);

}  // namespace isopatch::app

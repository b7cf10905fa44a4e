#pragma once

#include <optional>
#include <string>

#include "iga/estimate/error_estimate.hpp"

namespace isopatch::iga {

/// Why the stress at a place has no limit because of what is held or loaded apart from edges of patches: "the
/// rim of a part that is held" within a quarter of an element, "a point that is held" or "a point that is
/// loaded" within an element.
std::optional<std::string> why_held_singular(const ElasticityProblem& problem, const PatchPlace& place);

}  // namespace isopatch::iga

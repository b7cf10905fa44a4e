#pragma once

#include <string>

#include "app/problem/build_problem.hpp"

namespace isopatch::app {

/// What `isopatch info` prints of a model, in engineering units.
/// @param all  every patch and face; otherwise long lists are cut after 24 lines
std::string model_text(const geometry::MultiPatch& model, const ModelReport& report, bool all = false);

/// The same as JSON, SI units, complete.
/// @param problem  the study's that the model is of, for its supports and loads; may be null
std::string model_json_text(const geometry::MultiPatch& model, const ModelReport& report,
                            const BuiltProblem* problem = nullptr);

}  // namespace isopatch::app

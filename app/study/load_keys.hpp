#pragma once

#include <cstddef>

#include "app/study/applied_load.hpp"
#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"

namespace isopatch::app {

/// The keys of [[load]]; they fill a load whose kind is chosen already.
const Keys<AppliedLoad>& load_keys();

/// @param index  of the load in the study, from 0
/// @throws Error invalid_argument  for wrong keys, without a kind or with two, without faces
AppliedLoad read_load(const ConfigSection& input, std::size_t index);

}  // namespace isopatch::app

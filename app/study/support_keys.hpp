#pragma once

#include <cstddef>

#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"
#include "app/study/support_input.hpp"

namespace isopatch::app {

/// The keys of [[support]]; they fill a support whose condition is chosen already.
const Keys<SupportInput>& support_keys();

/// @param index  of the support in the study, from 0
/// @throws Error invalid_argument  for wrong keys, without a condition or with two, without faces
SupportInput read_support(const ConfigSection& input, std::size_t index);

}  // namespace isopatch::app

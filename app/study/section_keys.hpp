#pragma once

#include "app/study/config_section.hpp"
#include "app/study/keys.hpp"
#include "app/study/section_input.hpp"

namespace isopatch::app {

const Keys<SectionInput>& section_keys();

/// @param index  of the table, from 0
SectionInput read_cut(const ConfigSection& input, std::size_t index);

}  // namespace isopatch::app

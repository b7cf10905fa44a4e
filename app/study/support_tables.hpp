#pragma once

#include "app/study/keys.hpp"
#include "app/study/support_input.hpp"

namespace isopatch::app {

/// The keys of supports that are tables: cylindrical, elastic.
const Keys<Cylindrical>& cylindrical_keys();
const Keys<Elastic>& elastic_keys();

}  // namespace isopatch::app

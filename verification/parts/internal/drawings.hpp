#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// A line of the table of parts.
struct Drawing {
  std::string name;  ///< of the file too
  std::string set;   ///< basic, shop, later, turned, held_out, models or assemblies
  std::string what;
  Part (*draw)();
  std::optional<int> hexahedra = {};  ///< that its decomposition takes at most
};

/// All parts, in order.
const std::vector<Drawing>& drawings();

}  // namespace isopatch::parts

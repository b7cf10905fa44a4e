#pragma once

namespace isopatch::app {

/// What `isopatch modes` looks for: [modes].
struct ModesInput {
  int number = 10;       ///< lowest modes besides rigid motions
  bool is_free = false;  ///< whether the supports are left away
  bool count = true;     ///< whether a second factorization counts the modes
  bool operator==(const ModesInput&) const = default;
};

}  // namespace isopatch::app

#pragma once

namespace isopatch::iga {

/// What ties the two sides of an interface that does not match.
enum class InterfaceTerms {
  nitsche,  ///< tractions and penalty
  springs,  ///< a small share of the penalty alone: for preconditioners beside multipliers
};

}  // namespace isopatch::iga

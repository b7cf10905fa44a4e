#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "verification/claims/tolerance.hpp"

namespace isopatch::verification {

/// Where a reference value comes from.
enum class ReferenceKind {
  closed_form,
  manufactured,
  independent_fe,
  published,
  seed_figure,
  other_method,
  exact
};

/// A study that shows a claim: a file of the tree and the keys that are set differently, so that a user can
/// run it alone.
struct ClaimStudy {
  std::string file = {};                    ///< from the root of the tree; empty: no study file can say it
  std::vector<std::string> overrides = {};  ///< "discretization.degree=3"
};

/// How a value is held against its reference.
enum class Comparison {
  relative,  ///< differs by no more than `allowed` of the reference; a reference of 0 makes it absolute
  absolute,  ///< differs by no more than `allowed`, in the value's unit
  at_most,   ///< the reference is a limit, and `least` is the other one
  at_least,  ///< the reference is a limit, and there is no other one
};

/// A number that must be what a reference says. A difference that is allowed is at most a tenth of the
/// reference (of 1 where that is 0), with a reason if it is above a hundredth; limits allow none.
struct Claim {
  std::string what = {};  ///< "u_r at the inner wall, nu = 0.3, p = 3"
  std::string unit = {};  ///< "m"; empty for numbers without one
  ReferenceKind kind = ReferenceKind::closed_form;
  std::string source = {};  ///< "Lame", "NAFEMS LE10"
  double reference = 0;
  double value = 0;
  Tolerance allowed = 0;  ///< the largest difference
  ClaimStudy study = {};
  Comparison comparison = Comparison::relative;
  /// With `at_most`, which needs it: the least that means that something happened, as 1 of iterations.
  std::optional<double> least = {};
};

/// As it is made: `relative` becomes `absolute` where the reference is 0.
Comparison comparison_of(const Claim& claim);
/// The difference that counts against `allowed`; of limits how far the value is outside, relative to the
/// reference unless that is 0.
double difference(const Claim& claim);
/// NaN is never within.
bool is_within(const Claim& claim);

/// Errors on finer and finer meshes, whose order is claimed from both sides.
struct Convergence {
  std::string what;  ///< "displacement in L2, p = 2, elimination"
  ReferenceKind kind = ReferenceKind::closed_form;
  std::string source;
  std::vector<double> sizes = {};   ///< of the elements, falling
  std::vector<double> errors = {};  ///< relative
  double order = 0;
  /// Difference of the order between any two levels.
  Tolerance allowed = {0.15, "the next power of the size of elements on meshes that are affordable"};
  ClaimStudy study = {};
};

/// A figure that is worth a look and claims nothing: one beside another that it cannot meet, or one alone.
struct Figure {
  std::string what;
  std::string unit;
  ReferenceKind kind = ReferenceKind::published;
  std::string source;
  double reference = std::numeric_limits<double>::quiet_NaN();  ///< NaN: there is none
  double value = 0;
  std::string why;  ///< nothing is claimed: "the paper prints another load"
  ClaimStudy study = {};
};

/// The orders measured between neighbouring levels, one fewer than there are levels.
std::vector<double> orders(const Convergence& convergence);
/// The order measured between two levels that is farthest from the expected one.
double farthest_order(const Convergence& convergence);

/// What keeps it from meaning anything, in words; empty if nothing does.
std::string objection(const Claim& claim);
std::string objection(const Convergence& convergence);

}  // namespace isopatch::verification

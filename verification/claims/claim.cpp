#include "verification/claims/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isopatch::verification {

// What a claim of an order must have to mean anything; empty if it has.
std::string objection(const Convergence& c) {
  if (c.sizes.size() < 4 || c.sizes.size() != c.errors.size()) return "needs four levels, with an error each";
  if (!(c.allowed <= 0.2)) return "allows too much";
  for (std::size_t i = 0; i < c.errors.size(); ++i) {
    if (!(c.errors[i] > 1e-11)) return fmt::format("level {} is near round-off: {}", i, c.errors[i]);
    if (i > 0 && !(c.sizes[i] < c.sizes[i - 1])) return "needs finer and finer levels";
  }
  return "";
}

// What a claim must have to mean anything.
std::string objection(const Claim& claim) {
  constexpr double most = 0.1;
  if (!(claim.allowed >= 0 && claim.allowed <= most))
    return fmt::format("allows {}; at most {} means anything, or set `least`", claim.allowed, most);
  if (claim.least && !(*claim.least <= claim.reference && claim.allowed == 0))
    return "a value between limits needs the least below the most, and nothing more is allowed";
  return "";
}

double difference(const Claim& claim) {
  const bool between = claim.least && claim.value >= *claim.least && claim.value <= claim.reference;
  const double nearest = claim.least && claim.value < *claim.least ? *claim.least : claim.reference;
  const double absolute = between ? 0 : std::abs(claim.value - nearest);
  return claim.reference == 0 ? absolute : absolute / std::abs(claim.reference);
}

bool is_within(const Claim& claim) {
  return objection(claim).empty() && difference(claim) <= claim.allowed;
}

std::vector<double> orders(const Convergence& c) {
  std::vector<double> result;
  for (std::size_t i = 1; i < std::min(c.sizes.size(), c.errors.size()); ++i)
    result.push_back(std::log(c.errors[i - 1] / c.errors[i]) / std::log(c.sizes[i - 1] / c.sizes[i]));
  return result;
}

double farthest_order(const Convergence& convergence) {
  double farthest = convergence.order;
  for (const double order : orders(convergence))
    if (!(std::abs(order - convergence.order) <= std::abs(farthest - convergence.order))) farthest = order;
  return farthest;
}

}  // namespace isopatch::verification

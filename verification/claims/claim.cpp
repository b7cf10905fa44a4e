#include "verification/claims/claim.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace isopatch::verification {

// What a claim of an order must have to mean anything; empty if it has.
std::string objection(const Convergence& c) {
  if (c.sizes.size() < 4 || c.sizes.size() != c.errors.size()) return "needs four levels, with an error each";
  if (!(c.allowed.most <= 0.2)) return "allows too much";
  for (std::size_t i = 0; i < c.errors.size(); ++i) {
    if (!(c.errors[i] > 1e-11)) return fmt::format("level {} is near round-off: {}", i, c.errors[i]);
    if (i > 0 && !(c.sizes[i] < c.sizes[i - 1])) return "needs finer and finer levels";
  }
  return "";
}

namespace {

bool is_limit(Comparison comparison) {
  return comparison == Comparison::at_most || comparison == Comparison::at_least;
}

std::string objection_to_limits(const Claim& claim) {
  if (claim.allowed.most != 0)
    return fmt::format("allows {} past a limit; limits are limits", claim.allowed.most);
  if (claim.comparison == Comparison::at_least)
    return claim.least ? "says `least` beside a reference that is the least" : "";
  if (!claim.least) return "says at most without `least`, below which nothing would have happened";
  return *claim.least <= claim.reference ? "" : "has its least above its most";
}

}  // namespace

// What a claim must have to mean anything.
std::string objection(const Claim& claim) {
  constexpr double most = 0.1, most_without_reason = 0.01;
  if (is_limit(claim.comparison)) return objection_to_limits(claim);
  if (claim.least) return "says `least`, which belongs to `at_most`";
  const bool of_reference = claim.comparison == Comparison::absolute && claim.reference != 0;
  const double share = of_reference ? claim.allowed.most / std::abs(claim.reference) : claim.allowed.most;
  if (!(share >= 0 && share <= most))
    return fmt::format("allows {}; at most {} of the reference means anything, or say at most or at least",
                       claim.allowed.most, most);
  if (share > most_without_reason && claim.allowed.reason.empty())
    return fmt::format("allows {}; above {} of the reference needs a reason", claim.allowed.most,
                       most_without_reason);
  return "";
}

Comparison comparison_of(const Claim& claim) {
  return claim.comparison == Comparison::relative && claim.reference == 0 ? Comparison::absolute
                                                                          : claim.comparison;
}

double difference(const Claim& claim) {
  const double off = std::abs(claim.value - claim.reference);
  const double relative = claim.reference == 0 ? off : off / std::abs(claim.reference);
  switch (claim.comparison) {
    case Comparison::relative:
      return relative;
    case Comparison::absolute:
      return off;
    case Comparison::at_least:
      return claim.value >= claim.reference ? 0 : relative;
    case Comparison::at_most:
      break;
  }
  const double least = claim.least.value_or(claim.reference);
  if (claim.value >= least && claim.value <= claim.reference) return 0;
  if (!(claim.value < least)) return relative;
  const double below = least - claim.value;
  return claim.reference == 0 ? below : below / std::abs(claim.reference);
}

bool is_within(const Claim& claim) {
  return objection(claim).empty() && difference(claim) <= claim.allowed.most;
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

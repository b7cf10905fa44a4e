#include "verification/claims/expect.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/claims/claim_record.hpp"

namespace isopatch::verification {

namespace {

// "2", "at least 2" or "1 to 20".
std::string expected(const Claim& claim) {
  if (claim.comparison == Comparison::at_least) return fmt::format("at least {:.10g}", claim.reference);
  if (claim.least) return fmt::format("{:.10g} to {:.10g}", *claim.least, claim.reference);
  return fmt::format("{:.10g}", claim.reference);
}

}  // namespace

void expect(const Claim& claim) {
  record(claim, is_within(claim));
  const std::string why = objection(claim);
  EXPECT_TRUE(is_within(claim)) << fmt::format(
      "{}: {:.10g} {} where {} says {}: differs by {:.3g}, allowed are {:.3g}. {}", claim.what, claim.value,
      claim.unit, claim.source, expected(claim), difference(claim), claim.allowed.most, why);
}

void expect(const Convergence& convergence) {
  const std::string why = objection(convergence);
  const double order = farthest_order(convergence);
  const bool holds = why.empty() && std::abs(order - convergence.order) <= convergence.allowed.most;
  record(convergence, holds);
  EXPECT_TRUE(holds) << convergence.what << " "
                     << (why.empty()
                             ? fmt::format("has order {:.3g} where {:.3g} is expected, allowed are {:.3g}",
                                           order, convergence.order, convergence.allowed.most)
                             : why);
}

void report(const Figure& figure) {
  record(figure);
}

}  // namespace isopatch::verification

#include "verification/claims/expect.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "verification/claims/claim_record.hpp"

namespace isopatch::verification {

void expect(const Claim& claim) {
  record(claim, is_within(claim));
  const std::string why = objection(claim);
  EXPECT_TRUE(is_within(claim)) << fmt::format(
      "{}: {:.10g} {} where {} says {}{:.10g}: differs by {:.3g}, allowed are {:.3g}. {}", claim.what,
      claim.value, claim.unit, claim.source, claim.least ? fmt::format("{:.10g} to ", *claim.least) : "",
      claim.reference, difference(claim), claim.allowed, why);
}

void expect(const Convergence& convergence) {
  const std::string why = objection(convergence);
  const double order = farthest_order(convergence);
  const bool holds = why.empty() && std::abs(order - convergence.order) <= convergence.allowed;
  record(convergence, holds);
  EXPECT_TRUE(holds) << convergence.what << " "
                     << (why.empty()
                             ? fmt::format("has order {:.3g} where {:.3g} is expected, allowed are {:.3g}",
                                           order, convergence.order, convergence.allowed)
                             : why);
}

void report(const Figure& figure) {
  record(figure);
}

}  // namespace isopatch::verification

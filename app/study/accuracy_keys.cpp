#include "app/study/accuracy_keys.hpp"

namespace isopatch::app {

const Keys<AccuracyInput>& accuracy_keys() {
  using A = AccuracyInput;
  static const Range share{.least = 0, .most = 1, .least_allowed = false, .most_allowed = false};
  static const Keys<A> keys = {
      quantity_key<A>("energy", &A::energy, dimensions::none, share,
                      "Largest estimated error of the solution in the energy norm: \"1 %\"."),
      quantity_key<A>("stress", &A::stress, dimensions::none, share,
                      "Largest estimated error of the von Mises stress at `probe`, as a share of it."),
      text_key<A>("probe", &A::probe,
                  "Name of the probe whose stress is meant; without it the place of the largest stress."),
      integer_key<A>("refinements", &A::refinements, 0, 30,
                     "How often elements may be refined; what was reached by then is said."),
  };
  return keys;
}

}  // namespace isopatch::app

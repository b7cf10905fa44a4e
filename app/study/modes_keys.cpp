#include "app/study/modes_keys.hpp"

namespace isopatch::app {

const Keys<ModesInput>& modes_keys() {
  using M = ModesInput;
  static const Keys<M> keys = {
      integer_key<M>("number", &M::number, 1, 200,
                     "How many of the lowest natural modes, besides the motions of the part as a whole."),
      flag_key<M>("free", &M::is_free,
                  "Whether the supports are left away: the part as it hangs in the air."),
      flag_key<M>(
          "count", &M::count,
          "Whether a second factorization counts the modes below the highest, so that none is missing."),
  };
  return keys;
}

}  // namespace isopatch::app

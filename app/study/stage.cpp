#include "app/study/stage.hpp"

namespace isopatch::app {

const Choices<Stage>& stage_choices() {
  static const Choices<Stage> choices = {{"solid", Stage::solid},
                                         {"hexahedra", Stage::hexahedra},
                                         {"patches", Stage::patches},
                                         {"solution", Stage::solution}};
  return choices;
}

}  // namespace isopatch::app

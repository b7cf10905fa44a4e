#include "app/study/support_input.hpp"

#include "app/base/overloaded.hpp"

namespace isopatch::app {

std::string_view kind_name(const SupportInput& support) {
  return std::visit(Overloaded{[](const HeldDisplacement&) -> std::string_view { return "displacement"; },
                               [](const Symmetry&) -> std::string_view { return "symmetry"; },
                               [](const Roller&) -> std::string_view { return "roller"; },
                               [](const Cylindrical&) -> std::string_view { return "cylindrical"; },
                               [](const Elastic&) -> std::string_view { return "elastic"; },
                               [](const FreeBody&) -> std::string_view { return "free_body"; }},
                    support.condition);
}

}  // namespace isopatch::app

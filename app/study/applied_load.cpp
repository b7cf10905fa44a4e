#include "app/study/applied_load.hpp"

#include "app/base/overloaded.hpp"

namespace isopatch::app {
namespace {

template <class Load>
auto* selection_in(Load& load) {
  using Selection = decltype(&std::get<Traction>(load.load).selection);
  return std::visit(
      [](auto& found) -> Selection {
        if constexpr (requires { found.selection; })
          return &found.selection;
        else
          return nullptr;
      },
      load.load);
}

template <class Load>
auto* patches_in(Load& load) {
  using Selection = decltype(&std::get<Gravity>(load.load).patches);
  return std::visit(
      [](auto& found) -> Selection {
        if constexpr (requires { found.patches; })
          return &found.patches;
        else
          return nullptr;
      },
      load.load);
}

}  // namespace

std::string_view kind_name(const AppliedLoad& load) {
  return std::visit(Overloaded{[](const Traction&) -> std::string_view { return "traction"; },
                               [](const Pressure&) -> std::string_view { return "pressure"; },
                               [](const Force&) -> std::string_view { return "force"; },
                               [](const Bearing&) -> std::string_view { return "bearing"; },
                               [](const Remote&) -> std::string_view { return "remote"; },
                               [](const Hydrostatic&) -> std::string_view { return "hydrostatic"; },
                               [](const BodyForce&) -> std::string_view { return "body_force"; },
                               [](const Gravity&) -> std::string_view { return "gravity"; },
                               [](const Acceleration&) -> std::string_view { return "acceleration"; },
                               [](const Rotating&) -> std::string_view { return "rotation"; },
                               [](const Temperature&) -> std::string_view { return "temperature"; }},
                    load.load);
}

FaceSelection* faces_of(AppliedLoad& load) {
  return selection_in(load);
}
const FaceSelection* faces_of(const AppliedLoad& load) {
  return selection_in(load);
}

PatchSelection* patches_of(AppliedLoad& load) {
  return patches_in(load);
}
const PatchSelection* patches_of(const AppliedLoad& load) {
  return patches_in(load);
}

}  // namespace isopatch::app

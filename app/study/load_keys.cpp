#include "app/study/load_keys.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

#include "app/study/case_keys.hpp"
#include "app/study/selection_keys.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

FaceSelection& loaded_faces(AppliedLoad& load, const ConfigValue& value) {
  if (FaceSelection* selection = faces_of(load)) return *selection;
  throw error_at(value.place, "[[load]]: body_force and gravity act in patches, not on faces");
}

PatchSelection& loaded_patches(AppliedLoad& load, const ConfigValue& value) {
  if (PatchSelection* selection = patches_of(load)) return *selection;
  throw error_at(value.place, "[[load]]: only body_force and gravity take patches; use faces");
}

/// The vector of one kind of load.
template <class Load>
Key<AppliedLoad> load_vector_key(const std::string& name, const Dimension& dimension, std::string meaning) {
  return custom_key<AppliedLoad>(name, "3 of " + type_name(dimension), std::move(meaning),
                                 [=](AppliedLoad& target, const ConfigValue& value) {
                                   std::get<Load>(target.load).value = read_vector(value, name, dimension);
                                 });
}

/// Loads of the kinds that some keys ask for, with nothing in them yet.
std::vector<AppliedLoad> empty_loads(const ConfigSection& input) {
  std::vector<AppliedLoad> result = {{.load = Traction{}},
                                     {.load = Pressure{}},
                                     {.load = Force{}},
                                     {.load = BodyForce{.patches = {.place = input.place}}},
                                     {.load = Gravity{.patches = {.place = input.place}}}};
  std::erase_if(result, [&](const AppliedLoad& load) { return !input.table.find(kind_name(load)); });
  return result;
}

/// A load of any kind that the other keys may belong to, so that what is wrong with them is found.
AppliedLoad any_load(const ConfigSection& input) {
  if (input.table.find("patches")) return {.load = BodyForce{}};
  return {.load = Traction{}};
}

}  // namespace

const Keys<AppliedLoad>& load_keys() {
  using L = AppliedLoad;
  static const Keys<L> keys = {
      text_key<L>("name", &L::key, "For messages and reports.").with_default("\"load 1\", ..."),
      faces_key<L>(loaded_faces),
      where_key<L>(loaded_faces),
      load_vector_key<Traction>("traction", dim::pressure, "Force per area of the faces."),
      custom_key<L>("pressure", type_name(dim::pressure), "Pushes against the faces where positive.",
                    [](L& target, const ConfigValue& value) {
                      std::get<Pressure>(target.load).value = read_quantity(value, "pressure", dim::pressure);
                    }),
      load_vector_key<Force>("force", dim::force,
                             "Total force, spread evenly over the area of all faces of this load."),
      patches_key<L>("The patches that body_force or gravity acts in.", loaded_patches),
      load_vector_key<BodyForce>("body_force", dim::force_per_volume, "Force per volume."),
      load_vector_key<Gravity>("gravity", dim::acceleration,
                               "Acceleration of gravity; the materials need a density."),
      case_key<L>(
          "Load case that it belongs to, or several. Loads of one case act together; cases are solved "
          "with one set-up, and each has results of its own."),
  };
  return keys;
}

AppliedLoad read_load(const ConfigSection& input, std::size_t index) {
  constexpr const char* one_kind =
      "[[load]] needs exactly one of traction, pressure, force, body_force, gravity";
  const std::vector<AppliedLoad> kinds = empty_loads(input);
  if (kinds.size() > 1) throw error_at(input.place, one_kind);
  AppliedLoad result = read_table<AppliedLoad>(input.table, input.place, "[[load]]", load_keys(),
                                               kinds.empty() ? any_load(input) : kinds.front());
  if (kinds.empty()) throw error_at(input.place, one_kind);
  result.place = input.place;
  if (FaceSelection* selection = faces_of(result)) {
    selection->place = input.place;
    if (selection->faces.empty() && !selection->where)
      throw error_at(input.place, "[[load]] needs faces or where: which faces are loaded?");
  }
  result.name = fmt::format("load {}{}", index + 1, result.key.empty() ? "" : " (" + result.key + ")");
  if (result.key.empty()) result.key = result.name;
  return result;
}

}  // namespace isopatch::app

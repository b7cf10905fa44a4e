#include "app/study/support_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/study/case_keys.hpp"
#include "app/study/selection_keys.hpp"
#include "app/study/support_tables.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

std::array<std::optional<double>, 3> read_displacement(const ConfigValue& value) {
  const auto& items = read_array(value, "displacement");
  if (items.size() != 3)
    throw error_at(value.place, fmt::format("displacement: expected 3 components, got {}", items.size()));
  std::array<std::optional<double>, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* text = std::get_if<std::string>(&items[i].value);
    if (text && *text == "free") continue;
    result[i] = read_quantity(items[i], "displacement", dim::length);
  }
  return result;
}

Eigen::Matrix3d read_gradient(const ConfigValue& value) {
  const auto& rows = read_array(value, "displacement_gradient");
  if (rows.size() != 3) throw error_at(value.place, "displacement_gradient: expected 3 rows of 3 numbers");
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i)
    result.row(i) =
        read_vector(rows[static_cast<std::size_t>(i)], "displacement_gradient", dim::none).transpose();
  return result;
}

FaceSelection& held_faces(SupportInput& support, const ConfigValue&) {
  return support.selection;
}

/// The condition that a key belongs to.
template <class Condition>
Condition& condition_of(SupportInput& support, const ConfigValue& value, const std::string& complaint) {
  if (auto* condition = std::get_if<Condition>(&support.condition)) return *condition;
  throw error_at(value.place, complaint);
}

HeldDisplacement& displacement_of(SupportInput& support, const ConfigValue& value) {
  return condition_of<HeldDisplacement>(
      support, value,
      fmt::format("[[support]] has both a displacement and {}; write two supports", kind_name(support)));
}

/// A displacement at places instead of faces.
HeldDisplacement& held_at(SupportInput& support, const ConfigValue& value, const char* key,
                          const char* place) {
  return condition_of<HeldDisplacement>(
      support, value,
      fmt::format(
          "[[support]] has {}: all but displacement needs whole faces, because {} has no normal; give "
          "displacement components",
          key, place));
}

template <class Places>
Key<SupportInput> places_key(const char* key, Places HeldDisplacement::*places, const char* place,
                             std::string meaning) {
  return custom_key<SupportInput>(key, "array of points, each 3 of length (m)", std::move(meaning),
                                  [=](SupportInput& target, const ConfigValue& value) {
                                    held_at(target, value, key, place).*places = read_places(value, key);
                                  });
}

template <class Condition>
Key<SupportInput> support_table_key(const std::string& name, const Keys<Condition>& keys,
                                    std::string meaning) {
  return custom_key<SupportInput>(
      name, "table, see below", std::move(meaning),
      [name, &keys](SupportInput& target, const ConfigValue& value) {
        condition_of<Condition>(
            target, value,
            fmt::format("[[support]] has both {} and {}; write two supports", kind_name(target), name)) =
            read_table<Condition>(read_subtable(value, name), value.place, name, keys);
      });
}

bool is_set(const ConfigTable& table, const char* key) {
  const ConfigEntry* entry = table.find(key);
  return entry && read_flag(entry->value, key);
}

/// The kind of support that the keys ask for, with nothing in it yet.
SupportInput empty_support(const ConfigTable& table) {
  if (is_set(table, "symmetry")) return {.condition = Symmetry{}};
  if (is_set(table, "roller")) return {.condition = Roller{}};
  if (is_set(table, "free_body")) return {.condition = FreeBody{}};
  if (table.find("cylindrical")) return {.condition = Cylindrical{}};
  if (table.find("elastic")) return {.condition = Elastic{}};
  return {.condition = HeldDisplacement{}};
}

void require_condition(const SupportInput& support, const ConfigSection& input) {
  if (!std::holds_alternative<HeldDisplacement>(support.condition)) return;
  if (input.table.find("displacement") || input.table.find("displacement_gradient")) return;
  throw error_at(input.place,
                 "[[support]] needs displacement, displacement_gradient, symmetry = true, roller = true, "
                 "cylindrical, elastic or free_body = true");
}

// What a support holds: faces, points, or the body.
void require_place(const SupportInput& support, const ConfigSection& input) {
  const FaceSelection& selection = support.selection;
  const bool has_faces = !selection.faces.empty() || selection.where || selection.part;
  const auto* held = std::get_if<HeldDisplacement>(&support.condition);
  const bool has_points = held && !(held->points.empty() && held->line.empty());
  const bool is_free = std::holds_alternative<FreeBody>(support.condition);
  if (is_free && has_faces)
    throw error_at(input.place,
                   "[[support]] free_body holds bodies by points that it chooses itself; leave out faces and "
                   "where");
  if (has_points && (has_faces || held->edges || (!held->points.empty() && !held->line.empty())))
    throw error_at(input.place,
                   "[[support]] has points or a line beside faces, where, part or edges; write two supports");
  if (!has_faces && !has_points && !is_free)
    throw error_at(input.place, "[[support]] needs faces, where, part, points or a line: what is held?");
  if (held && held->edges && selection.part)
    throw error_at(input.place, "[[support]] edges hold whole edges; leave out part, or write a line");
  if (held && held->line.size() == 1)
    throw error_at(input.place, "[[support]] a line needs two points or more");
  const auto* springs = std::get_if<Elastic>(&support.condition);
  if (springs && *springs == Elastic{})
    throw error_at(input.place,
                   "[[support]] elastic needs a stiffness above 0: normal, tangential, "
                   "total_normal or total_tangential");
  const auto* about = std::get_if<Cylindrical>(&support.condition);
  if (about && about->point.has_value() != about->axis.has_value())
    throw error_at(input.place, "[[support]] cylindrical needs both point and axis, or neither");
  if (about && !about->radial && !about->tangential && !about->axial)
    throw error_at(input.place,
                   "[[support]] cylindrical holds nothing: all of radial, tangential and axial "
                   "are free");
}

}  // namespace

const Keys<SupportInput>& support_keys() {
  using S = SupportInput;
  static const Keys<S> keys = {
      text_key<S>("name", &S::key, "For messages and for the reactions in summary.json.")
          .with_default("\"support 1\", ..."),
      faces_key<S>(held_faces),
      where_key<S>(held_faces),
      part_key<S>(held_faces),
      custom_key<S>(
          "edges", "table, see below",
          "Holds, instead of the faces, those of their patches' edges that lie there: lines. Displacements "
          "and energy then grow without limit as elements become small; stresses elsewhere do not.",
          [](S& target, const ConfigValue& value) {
            held_at(target, value, "edges", "an edge").edges =
                read_table<FaceConditions>(read_subtable(value, "edges"), value.place, "edges", edges_keys());
          }),
      places_key(
          "points", &HeldDisplacement::points, "a point",
          "Holds, instead of faces, these places of the part: corners of patches exactly, others by "
          "springs ten thousand times as stiff as the part, which hold at 0 alone. Where a point takes a "
          "force, displacements and stresses grow without limit as elements become small."),
      places_key(
          "line", &HeldDisplacement::line, "a line",
          "Holds, instead of faces, what lies on straight lines from each of these points to the next, "
          "which must lie in the part, by springs as `points` does; at 0 alone."),
      custom_key<S>("displacement", "3 of length (m) or \"free\"",
                    "Prescribed displacement; \"free\" leaves a component free.",
                    [](S& target, const ConfigValue& value) {
                      displacement_of(target, value).displacement.value = read_displacement(value);
                    }),
      custom_key<S>("displacement_gradient", "3 x 3 numbers",
                    "Adds a linear part: u = displacement + displacement_gradient * x, with x in m.",
                    [](S& target, const ConfigValue& value) {
                      displacement_of(target, value).displacement.gradient = read_gradient(value);
                    }),
      custom_key<S>("symmetry", "true or false",
                    "A plane of symmetry of any orientation: no displacement along its normal.",
                    [](S&, const ConfigValue& value) { read_flag(value, "symmetry"); })
          .with_default("false"),
      custom_key<S>(
          "roller", "true or false",
          "Whether plane faces slide without friction: no displacement along their normal (or the one that "
          "normal_displacement gives), any in their plane. With 0 it is the same as symmetry.",
          [](S&, const ConfigValue& value) { read_flag(value, "roller"); })
          .with_default("false"),
      custom_key<S>("normal_displacement", type_name(dim::length),
                    "With roller: moves the faces along their outward normal.",
                    [](S& target, const ConfigValue& value) {
                      condition_of<Roller>(target, value, "normal_displacement needs roller = true")
                          .normal_displacement = read_quantity(value, "normal_displacement", dim::length);
                    })
          .with_default("0"),
      support_table_key<Cylindrical>("cylindrical", cylindrical_keys(),
                                     "Faces about an axis are held along some of the directions of cylinder "
                                     "coordinates: a pin in a bore, a bearing on a shaft."),
      support_table_key<Elastic>("elastic", elastic_keys(),
                                 "Springs between the faces and what does not move: a bed, a rubber mount."),
      custom_key<S>("free_body", "true or false",
                    "Whether each body is held by as many single conditions, at corners of patches, as other "
                    "supports leave motions, six without any: loads that balance feel nothing of them, and "
                    "what does not balance is reported as the reaction.",
                    [](S&, const ConfigValue& value) { read_flag(value, "free_body"); })
          .with_default("false"),
      case_key<S>("Load cases in which what it prescribes acts; in others it holds at 0. Without, in all."),
  };
  return keys;
}

SupportInput read_support(const ConfigSection& input, std::size_t index) {
  SupportInput result = read_table<SupportInput>(input.table, input.place, "[[support]]", support_keys(),
                                                 empty_support(input.table));
  require_condition(result, input);
  result.selection.place = input.place;
  require_place(result, input);
  result.name = fmt::format("support {}{}", index + 1, result.key.empty() ? "" : " (" + result.key + ")");
  if (result.key.empty()) result.key = result.name;
  return result;
}

}  // namespace isopatch::app

#include "app/study/section_keys.hpp"

#include <fmt/format.h>

namespace isopatch::app {

namespace dim = dimensions;

const Keys<SectionInput>& section_keys() {
  using S = SectionInput;
  static const Keys<S> keys = {
      text_key<S>("name", &S::name, "For reports and summary.json.").with_default("\"section 1\", ..."),
      custom_key<S>("point", "3 of " + type_name(dim::length),
                    "A point of the plane, about which the moment is taken.",
                    [](S& target, const ConfigValue& value) {
                      target.plane.point = read_vector(value, "point", dim::length);
                    })
          .required(),
      custom_key<S>(
          "normal", "3 numbers, or \"x\", \"-x\", \"y\", ...",
          "Across the plane. The forces are those of the side to which it points on the other one.",
          [](S& target, const ConfigValue& value) { target.plane.normal = read_direction(value, "normal"); })
          .required(),
      custom_key<S>("radius", type_name(dim::length) + ", above 0",
                    "Cuts only so far from the point: one arm of several.",
                    [](S& target, const ConfigValue& value) {
                      target.plane.radius = read_quantity(value, "radius", dim::length, positive);
                    })
          .with_default("no limit"),
  };
  return keys;
}

SectionInput read_cut(const ConfigSection& input, std::size_t index) {
  auto result = read_table<SectionInput>(input.table, input.place, "[[section]]", section_keys());
  if (result.name.empty()) result.name = fmt::format("section {}", index + 1);
  result.place = input.place;
  return result;
}

}  // namespace isopatch::app

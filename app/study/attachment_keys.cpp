#include "app/study/attachment_keys.hpp"

#include <variant>

#include "app/study/selection_keys.hpp"

namespace isopatch::app {
namespace {

Eigen::Vector3d read_scale(const ConfigValue& value) {
  if (std::holds_alternative<std::vector<ConfigValue>>(value.value))
    return read_vector(value, "scale", dimensions::none);
  return Eigen::Vector3d::Constant(read_quantity(value, "scale", dimensions::none));
}

}  // namespace

Keys<AttachmentKeys> attachment_keys(ModelUnits units) {
  using A = AttachmentKeys;
  return {
      custom_key<A>("faces", "array of strings",
                    "One patch is added to each: \"patch:side\" or names of boundaries, also of patches "
                    "attached before; written as the faces of supports and loads.",
                    [](A& target, const ConfigValue& value) { target.faces = read_face_names(value); })
          .required(),
      custom_key<A>(
          "scale", "number, or 3 numbers",
          "The far end of each new patch is its face scaled about `about` by this factor, or by one "
          "along each axis, ...",
          [](A& target, const ConfigValue& value) { target.scale = read_scale(value); })
          .with_default("1"),
      point_key<A>(units, "about", &A::about, "The point that scaling leaves where it is."),
      point_key<A>(units, "move", &A::move, "... and moved by this."),
      text_key<A>("name", &A::name, "Of a boundary that gets the far ends."),
  };
}

AttachmentInput read_attachment(const ConfigSection& input, ModelUnits units) {
  const auto keys =
      read_table<AttachmentKeys>(input.table, input.place, "[[model.attach]]", attachment_keys(units));
  if (keys.move.isZero(0) && (keys.scale.array() == 1).all())
    throw error_at(input.place, "[[model.attach]] needs move or scale: where does the new patch end?");
  AttachmentInput result{keys.name, keys.faces, Eigen::Affine3d::Identity(), input.place};
  result.map.translate(keys.about + keys.move).scale(keys.scale).translate(-keys.about);
  return result;
}

}  // namespace isopatch::app

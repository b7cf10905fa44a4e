#include "app/study/reconstruction_keys.hpp"

#include <fmt/format.h>

#include "app/study/segmentation_keys.hpp"

namespace isopatch::app {
namespace {

using R = ReconstructionKeys;
using segmentation::ReconstructionOptions;

Key<R> share_key(const std::string& name, const Range& range, double ReconstructionOptions::*member,
                 std::string meaning) {
  Key<R> key = custom_key<R>(name, "number", std::move(meaning), [=](R& target, const ConfigValue& value) {
    target.options.*member = read_quantity(value, name, dimensions::none, range);
  });
  key.text.range = range.text();
  key.text.fallback = format_default(ReconstructionOptions{}.*member);
  return key;
}

Key<R> turn_key(const std::string& name, double most, Angle ReconstructionOptions::*member,
                std::string meaning) {
  const Range range{.least = Angle::degrees(0.01).radians(), .most = Angle::degrees(most).radians()};
  Key<R> key = custom_key<R>(
      name, type_name(dimensions::angle), std::move(meaning), [=](R& target, const ConfigValue& value) {
        target.options.*member = Angle::radians(read_quantity(value, name, dimensions::angle, range));
      });
  key.text.range = fmt::format("from 0.01 to {:g} degrees", most);
  key.text.fallback = fmt::format("\"{:g} deg\"", (ReconstructionOptions{}.*member).degrees());
  return key;
}

}  // namespace

const Choices<segmentation::RegionMethod>& region_method_choices() {
  static const Choices<segmentation::RegionMethod> choices = {
      {"carriers", segmentation::RegionMethod::carriers}, {"angles", segmentation::RegionMethod::angles}};
  return choices;
}

const Keys<ReconstructionKeys>& reconstruction_keys() {
  using O = ReconstructionOptions;
  static const Keys<R> keys = {
      custom_key<R>(
          "method", quoted_list(names(region_method_choices())),
          "How triangles are put together to faces: by the planes, cylinders, cones, spheres and tori that "
          "their vertices lie "
          "on; or by the angles between them alone, as published, which goes wrong at tangent rounds.",
          [](R& target, const ConfigValue& value) {
            target.options.method = read_choice(value, "method", region_method_choices());
          })
          .with_default("\"carriers\""),
      share_key("tolerance", {0, 0.01, false, true}, &O::tolerance,
                "Largest distance between a vertex and the surface that it lies on, as a share of the "
                "model's size; by how much the file "
                "has rounded its coordinates is found out and allowed for."),
      custom_key<R>("blends", quoted_list(names(blend_choices())),
                    "What becomes of rounds along freeform walls between parallel planes, as those of milled "
                    "pockets: they "
                    "stay, or the walls are extended to the planes. A warning says how many, and what that "
                    "does to the volume. "
                    "`blends` of [segmentation] removes those that are cylinders and tori.",
                    [](R& target, const ConfigValue& value) {
                      target.options.remove_blends =
                          read_choice(value, "blends", blend_choices()) == segmentation::Blends::remove;
                    })
          .with_default("\"keep\""),
      share_key("time_limit", {0, 1e7, false, true}, &O::time_limit,
                "Seconds of computing that a file of triangles may take to become a solid (the processor's, "
                "so that a "
                "busy machine makes what an idle one does), after which it is refused."),
      turn_key("smooth", 89, &O::smooth,
               "Largest angle between neighbouring plane pieces of one curved surface."),
      turn_key("cutoff", 179, &O::cutoff, "By angles: edges of at least this angle part faces."),
      turn_key("inner_cutoff", 179, &O::inner_cutoff,
               "By angles: the same inside of large faces, in a second pass."),
      share_key("large", {0, 1e6}, &O::large,
                "By angles: faces above this share of the mean area are looked at again with `inner_cutoff`; "
                "0: none."),
      share_key("small", {0, 1e6}, &O::small,
                "By angles: faces below this share of the mean area are given to the neighbour with the "
                "smallest angle between; 0: none."),
  };
  return keys;
}

}  // namespace isopatch::app

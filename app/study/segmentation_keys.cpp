#include "app/study/segmentation_keys.hpp"

#include <fmt/format.h>

#include <variant>

namespace isopatch::app {
namespace {

using S = SegmentationKeys;
using segmentation::DecompositionOptions;

template <class Member>
Key<S> number_key(const std::string& name, const Dimension& dimension, const Range& range, Member member,
                  std::string meaning) {
  Key<S> key =
      custom_key<S>(name, type_name(dimension), std::move(meaning), [=](S& target, const ConfigValue& value) {
        member(target.options) = read_quantity(value, name, dimension, range);
      });
  key.text.range = range.text();
  DecompositionOptions defaults;
  key.text.fallback = format_default(member(defaults));
  return key;
}

template <class Member>
Key<S> angle_key(const std::string& name, double least, double most, Member member, std::string meaning) {
  const Range range{.least = Angle::degrees(least).radians(), .most = Angle::degrees(most).radians()};
  Key<S> key = custom_key<S>(
      name, type_name(dimensions::angle), std::move(meaning), [=](S& target, const ConfigValue& value) {
        member(target.options) = Angle::radians(read_quantity(value, name, dimensions::angle, range));
      });
  key.text.range = fmt::format("from {:g} to {:g} degrees", least, most);
  DecompositionOptions defaults;
  key.text.fallback = fmt::format("\"{:g} deg\"", member(defaults).degrees());
  return key;
}

template <class Member>
Key<S> count_key(const std::string& name, int most, Member member, std::string meaning) {
  Key<S> key = custom_key<S>(name, "integer", std::move(meaning), [=](S& target, const ConfigValue& value) {
    member(target.options) = read_integer(value, name, 1, most);
  });
  key.text.range = fmt::format("from 1 to {}", most);
  DecompositionOptions defaults;
  key.text.fallback = fmt::format("{}", member(defaults));
  return key;
}

segmentation::GivenPlane read_given_plane(const ConfigValue& value, const std::string& heading) {
  auto result = read_table<segmentation::GivenPlane>(read_subtable(value, heading), value.place, heading,
                                                     given_plane_keys());
  try {
    segmentation::validate(result);
  } catch (const Error& error) {
    throw error_at(value.place, fmt::format("{}: {}", heading, error.what()));
  }
  return result;
}

}  // namespace

const Choices<segmentation::TJoints>& t_joint_choices() {
  static const Choices<segmentation::TJoints> choices = {{"remove", segmentation::TJoints::remove},
                                                         {"keep", segmentation::TJoints::keep}};
  return choices;
}

const Choices<segmentation::Method>& method_choices() {
  static const Choices<segmentation::Method> choices = {{"automatic", segmentation::Method::automatic},
                                                        {"cuts", segmentation::Method::cuts}};
  return choices;
}

const Choices<segmentation::Blends>& blend_choices() {
  static const Choices<segmentation::Blends> choices = {{"keep", segmentation::Blends::keep},
                                                        {"remove", segmentation::Blends::remove}};
  return choices;
}

const Keys<segmentation::GivenPlane>& given_plane_keys() {
  using P = segmentation::GivenPlane;
  static const Keys<P> keys = {
      custom_key<P>(
          "normal", "3 numbers, or \"x\", \"-x\", \"y\", ...",
          "Across the plane. One of `normal`, `face` and `through` is needed.",
          [](P& target, const ConfigValue& value) { target.normal = read_direction(value, "normal"); }),
      vector_key<P>("point", &P::point, dimensions::length,
                    "With `normal`, a point of the plane; without it, the middle of the body's box."),
      text_key<P>("face", &P::face,
                  "A plane face that is extended through the body, by its name or as \"face 3\"."),
      custom_key<P>("through", "array of 3 or more points, each 3 of length (m)",
                    "Points of the plane, such as the corners of a loop around the body.",
                    [](P& target, const ConfigValue& value) {
                      for (const ConfigValue& point : read_array(value, "through"))
                        target.through.push_back(read_vector(point, "through", dimensions::length));
                    }),
  };
  return keys;
}

const Keys<SegmentationKeys>& segmentation_keys() {
  static const Keys<S> keys = {
      custom_key<S>(
          "t_joints", quoted_list(names(t_joint_choices())),
          "What becomes of sides that meet others in parts: further cuts until all meet side to "
          "side, or nothing: layers of a stack, pieces between planes and parts that are no hexahedra "
          "are divided each by itself, into fewer hexahedra. Patches of kept ones meet without matching: "
          "`coupling.non_matching` "
          "says how they are coupled, and without it such a study is refused; `isopatch segment` "
          "writes and shows them.",
          [](S& target, const ConfigValue& value) {
            target.options.t_joints = read_choice(value, "t_joints", t_joint_choices());
          })
          .with_default("\"remove\""),
      custom_key<S>(
          "method", quoted_list(names(method_choices())),
          "How blocks are looked for. Bodies with floors across one direction and walls along it or "
          "inclined to it are swept, whatever their bores and pockets, bodies whose faces are all "
          "turned about one axis are turned, with bosses and bores across it, and others are cut by planes "
          "into such, unless cuts along loops take fewer blocks; "
          "or cuts along loops alone, as published. Where T-joints are kept, bodies are only cut.",
          [](S& target, const ConfigValue& value) {
            target.options.method = read_choice(value, "method", method_choices());
          })
          .with_default("\"automatic\""),
      custom_key<S>(
          "blends", quoted_list(names(blend_choices())),
          "What becomes of rounds that keep a body from being swept: they stay (concave ones between floors "
          "and walls get blocks of their own, others may keep it from being cut), or they are taken off "
          "and the faces around them extended until they meet. A warning says how many, how large, and "
          "what that does to the volume.",
          [](S& target, const ConfigValue& value) {
            target.options.blends = read_choice(value, "blends", blend_choices());
          })
          .with_default("\"keep\""),
      number_key(
          "largest_blend", dimensions::none, {0, 1, false, true},
          [](DecompositionOptions& o) -> double& { return o.largest_blend; },
          "Largest radius of rounds that may be removed, as a share of the body's size."),
      number_key(
          "time_limit", dimensions::none, {0, 1e7, false, true},
          [](DecompositionOptions& o) -> double& { return o.time_limit; },
          "Seconds of computing that a body may take to be cut (the processor's, so that a busy machine cuts "
          "it as an idle one), after which the best way found is taken, or the body "
          "given up; once "
          "a way is known, a sixth of it is left for better ones."),
      custom_key<S>(
          "cut", "array of tables, see below",
          "Planes that cut the body first, wherever its pieces join; pieces that are no stacks then are cut "
          "further as without them.",
          [](S& target, const ConfigValue& value) {
            for (const ConfigValue& cut : read_array(value, "cut"))
              target.options.cuts.push_back(read_given_plane(cut, "[[segmentation.cut]]"));
          }),
      custom_key<S>(
          "symmetry", "\"x\", \"y\", \"z\", or a table as those of `cut`",
          "The body is symmetric about the plane across this axis through the middle of its box, or about "
          "the plane given: one half is divided, and mirrored.",
          [](S& target, const ConfigValue& value) {
            if (std::holds_alternative<ConfigTable>(value.value)) {
              target.options.symmetry = read_given_plane(value, "symmetry");
            } else {
              target.options.symmetry.emplace();
              target.options.symmetry->normal = read_direction(value, "symmetry");
            }
          }),
      count_key(
          "max_cells", 1000000, [](DecompositionOptions& o) -> int& { return o.max_cells; },
          "Most hexahedra that a body may become while its parts are made to meet side to side."),
      count_key(
          "beam", 10000, [](DecompositionOptions& o) -> int& { return o.search.beam; },
          "Ways of cutting that are followed at the same time; more find fewer blocks and take longer."),
      count_key(
          "branches", 1000, [](DecompositionOptions& o) -> int& { return o.search.branches; },
          "Cuts of a part that are followed in each of them."),
      angle_key(
          "smallest_angle", 0.1, 44, [](DecompositionOptions& o) -> Angle& { return o.cut.smallest_angle; },
          "Least angle between a cut and a side of a part."),
      angle_key(
          "largest_angle", 91, 180, [](DecompositionOptions& o) -> Angle& { return o.cut.largest_angle; },
          "Edges with a larger angle inside a part are cut through, as concave ones are."),
      number_key(
          "shortest_edge", dimensions::none, {0, 0.1, false, false},
          [](DecompositionOptions& o) -> double& { return o.cut.shortest_edge; },
          "Least length of an edge that a cut makes, as a share of the body's size."),
  };
  return keys;
}

}  // namespace isopatch::app

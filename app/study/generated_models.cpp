#include "app/study/generated_models.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <tuple>

#include "app/base/overloaded.hpp"
#include "app/study/model_units.hpp"

namespace isopatch::app {
namespace {

template <class O>
Key<O> angle_key(const std::string& name, Angle O::*member, std::string meaning) {
  return custom_key<O>(name, type_name(dimensions::angle), std::move(meaning),
                       [=](O& target, const ConfigValue& value) {
                         target.*member = Angle::radians(read_quantity(value, name, dimensions::angle));
                       })
      .with_default(fmt::format("\"{:g} deg\"", (O{}.*member).degrees()));
}

template <class O>
Key<O> patch_count_key(const std::string& directions) {
  static constexpr std::size_t count = std::tuple_size_v<decltype(O::patches)>;
  return custom_key<O>("patches", fmt::format("{} integers, from 1 to 1000", count),
                       "Patches along " + directions + ".",
                       [](O& target, const ConfigValue& value) {
                         const auto& items = read_array(value, "patches");
                         if (items.size() != count)
                           throw error_at(value.place, fmt::format("patches: expected {} numbers, got {}",
                                                                   count, items.size()));
                         for (std::size_t i = 0; i < count; ++i)
                           target.patches[i] = read_integer(items[i], "patches", 1, 1000);
                       })
      .with_default(fmt::format("{}", O{}.patches));
}

Keys<geometry::BoxOptions> box_model_keys(ModelUnits units) {
  using O = geometry::BoxOptions;
  return {
      point_key<O>(units, "size", &O::size, "Lengths of the edges, positive."),
      point_key<O>(units, "origin", &O::origin, "The corner with the lowest coordinates."),
      patch_count_key<O>("x, y and z"),
      quantity_key<O>("distortion", &O::distortion, dimensions::none, {0, 0.4},
                      "Share of a patch's size by whose half its corners are moved at random."),
      quantity_key<O>("curvature", &O::curvature, dimensions::none, {0, 0.4},
                      "Patches become quadratic with curved edges: share of a patch's size by whose quarter "
                      "inner control "
                      "points are moved at random."),
      flag_key<O>("distort_faces", &O::distort_faces,
                  "Whether points of the box's own faces move too, within them."),
      custom_key<O>("seed", "integer, from 0", "Seed of the random moves.",
                    [](O& target, const ConfigValue& value) {
                      target.seed = static_cast<unsigned>(read_integer(value, "seed", 0, 1000000000));
                    })
          .with_default("1"),
      custom_key<O>(
          "orientation_seed", "integer, from 0",
          "If given, every patch gets a random orientation out of all 48, left-handed ones among them.",
          [](O& target, const ConfigValue& value) {
            target.orientation_seed =
                static_cast<unsigned>(read_integer(value, "orientation_seed", 0, 1000000000));
          }),
  };
}

Keys<geometry::CylinderOptions> cylinder_model_keys(ModelUnits units) {
  using O = geometry::CylinderOptions;
  return {
      length_key<O>(units, "inner_radius", &O::inner_radius, "Radius of the bore, positive."),
      length_key<O>(units, "outer_radius", &O::outer_radius, "Above inner_radius."),
      length_key<O>(units, "height", &O::height, "z runs from 0 to height."),
      angle_key<O>("angle", &O::angle, "Above 0, at most 360 degrees, which gives a closed ring."),
      integer_key<O>("radial_patches", &O::radial_patches, 1, 1000, "Patches through the wall."),
      integer_key<O>("axial_patches", &O::axial_patches, 1, 1000, "Patches along the axis."),
      integer_key<O>(
          "patches_around", &O::patches_around, 0, 1000,
          "Patches along the circumference, 120 degrees each at most; 0 gives 90 degrees or less each."),
  };
}

Keys<geometry::LinkOptions> link_model_keys(ModelUnits units) {
  using O = geometry::LinkOptions;
  return {
      length_key<O>(units, "distance", &O::distance, "Between the axes of the bores."),
      length_key<O>(units, "left_bore_radius", &O::left_bore_radius,
                    "Positive. The left bore's axis is the z axis."),
      length_key<O>(units, "right_bore_radius", &O::right_bore_radius,
                    "Positive. Its axis goes through (distance, 0)."),
      length_key<O>(units, "left_outer_radius", &O::left_outer_radius, "Above left_bore_radius."),
      length_key<O>(units, "right_outer_radius", &O::right_outer_radius, "Above right_bore_radius."),
      length_key<O>(units, "shank_width", &O::shank_width, "Along y; below twice the smaller outer radius."),
      length_key<O>(units, "fillet_radius", &O::fillet_radius,
                    "Of the four arcs that lead from the eyes to the shank."),
      length_key<O>(units, "thickness", &O::thickness, "z runs from 0 to thickness."),
      integer_key<O>("shank_patches", &O::shank_patches, 1, 1000,
                     "Patches along the straight part of the shank."),
  };
}

Keys<geometry::SphereOptions> sphere_model_keys(ModelUnits units) {
  using O = geometry::SphereOptions;
  return {
      length_key<O>(units, "inner_radius", &O::inner_radius, "Radius of the cavity, positive."),
      length_key<O>(units, "outer_radius", &O::outer_radius, "Above inner_radius."),
      integer_key<O>("radial_patches", &O::radial_patches, 1, 1000, "Patches through the wall."),
  };
}

Keys<geometry::PlateOptions> plate_model_keys(ModelUnits units) {
  using O = geometry::PlateOptions;
  return {
      length_key<O>(units, "width", &O::width, "Half of the whole plate's, along x; above hole_radius."),
      length_key<O>(units, "height", &O::height, "Half of the whole plate's, along y; above hole_radius."),
      length_key<O>(units, "hole_radius", &O::hole_radius, "Positive."),
      length_key<O>(units, "thickness", &O::thickness, "z runs from 0 to thickness."),
  };
}

Keys<geometry::BracketOptions> bracket_model_keys(ModelUnits units) {
  using O = geometry::BracketOptions;
  return {
      length_key<O>(units, "leg", &O::leg, "Outer length of both legs."),
      length_key<O>(units, "width", &O::width, "Of both legs; below leg."),
      length_key<O>(units, "thickness", &O::thickness, "z runs from 0 to thickness."),
  };
}

Keys<geometry::CookOptions> cook_model_keys(ModelUnits units) {
  using O = geometry::CookOptions;
  return {
      length_key<O>(units, "width", &O::width, "Along x, positive."),
      length_key<O>(units, "left_height", &O::left_height, "Of the clamped edge, positive."),
      length_key<O>(units, "right_height", &O::right_height, "Of the loaded edge, positive."),
      length_key<O>(units, "rise", &O::rise, "y of the lower right corner."),
      length_key<O>(units, "thickness", &O::thickness, "z runs from 0 to thickness."),
      patch_count_key<O>("x and y"),
  };
}

Keys<geometry::ElbowOptions> elbow_model_keys(ModelUnits units) {
  using O = geometry::ElbowOptions;
  return {
      length_key<O>(units, "inner_radius", &O::inner_radius, "Of the pipe, positive."),
      length_key<O>(units, "outer_radius", &O::outer_radius, "Above inner_radius."),
      length_key<O>(units, "bend_radius", &O::bend_radius,
                    "Of the pipe's axis in the bend; above outer_radius."),
      angle_key<O>("bend_angle", &O::bend_angle, "Above 0, at most 180 degrees."),
      length_key<O>(units, "inlet_length", &O::inlet_length, "Straight pipe before the bend, 0 or more."),
      length_key<O>(units, "outlet_length", &O::outlet_length, "Straight pipe behind the bend, 0 or more."),
  };
}

Keys<geometry::EllipticPlateOptions> elliptic_plate_model_keys(ModelUnits units) {
  using O = geometry::EllipticPlateOptions;
  return {
      length_key<O>(units, "inner_x", &O::inner_x, "Semi-axis of the inner ellipse along x, positive."),
      length_key<O>(units, "inner_y", &O::inner_y, "Semi-axis of the inner ellipse along y, positive."),
      length_key<O>(units, "outer_x", &O::outer_x, "Above inner_x."),
      length_key<O>(units, "outer_y", &O::outer_y, "Above inner_y."),
      length_key<O>(units, "thickness", &O::thickness, "z runs from 0 to thickness."),
      integer_key<O>("layers", &O::layers, 1, 1000, "Patches through the thickness."),
  };
}

Keys<geometry::TwistedBeamOptions> twisted_beam_model_keys(ModelUnits units) {
  using O = geometry::TwistedBeamOptions;
  return {
      length_key<O>(units, "length", &O::length, "Along x, positive."),
      length_key<O>(units, "width", &O::width, "Of the section, along y at the root; positive."),
      length_key<O>(units, "depth", &O::depth, "Of the section, along z at the root; positive."),
      angle_key<O>("twist", &O::twist, "From the root to the tip; above 0, at most 720 degrees."),
  };
}

template <class O>
GeneratedModel model(const std::string& name, const std::string& meaning, Keys<O> (*keys)(ModelUnits)) {
  return {name, meaning, texts(keys({})),
          [=](const ConfigTable& entries, const Place& place, double length_unit) -> GeneratedDimensions {
            return read_table<O>(entries, place, fmt::format("[model] with generate = \"{}\"", name),
                                 keys({length_unit}));
          }};
}

}  // namespace

const std::vector<GeneratedModel>& generated_models() {
  static const std::vector<GeneratedModel> models = {
      model("box",
            "A box of patches, inside as distorted as wanted. Boundaries: x_min, x_max, y_min, y_max, z_min, "
            "z_max.",
            box_model_keys),
      model("cylinder",
            "A sector of a thick-walled cylinder about the z axis. Boundaries: inner, outer, start, end, "
            "bottom, top.",
            cylinder_model_keys),
      model("link",
            "A link like a connecting rod: two eyes with bores along z, joined by a shank. Boundaries: "
            "bore_left, "
            "bore_right, end_left, end_right, sides, bottom, top.",
            link_model_keys),
      model("sphere",
            "An octant of a hollow sphere about the origin, three patches a layer. Boundaries: inner, outer, "
            "x0, y0, z0.",
            sphere_model_keys),
      model("plate",
            "A quarter of a plate with a round hole about the z axis. Boundaries: hole, x_min, y_min, x_max, "
            "y_max, bottom, top.",
            plate_model_keys),
      model("bracket",
            "An L-bracket of three bricks. Boundaries: x_min, y_min, x_max, y_max, inner, bottom, top.",
            bracket_model_keys),
      model("cook",
            "Cook's membrane, a tapered and swept cantilever. Boundaries: x_min, x_max, y_min, y_max, "
            "bottom, top.",
            cook_model_keys),
      model(
          "elbow",
          "A pipe elbow: a straight pipe, a bend, a straight pipe. Boundaries: inlet, outlet, inner, outer.",
          elbow_model_keys),
      model("elliptic_plate",
            "A quarter of a plate between two ellipses about the z axis, as in NAFEMS LE1 and LE10. "
            "Boundaries: "
            "inner, outer, x_min, y_min, bottom, top.",
            elliptic_plate_model_keys),
      model("twisted_beam",
            "A straight beam along x whose rectangular section turns evenly, as MacNeal and Harder's. "
            "Boundaries: root, tip, sides.",
            twisted_beam_model_keys),
  };
  return models;
}

Choices<std::reference_wrapper<const GeneratedModel>> generated_model_choices() {
  Choices<std::reference_wrapper<const GeneratedModel>> result;
  for (const GeneratedModel& model : generated_models()) result.push_back({model.name, model});
  return result;
}

geometry::PatchSet generated_patches(const GeneratedDimensions& dimensions) {
  return std::visit(
      Overloaded{[](const geometry::BoxOptions& o) { return geometry::box_model(o); },
                 [](const geometry::CylinderOptions& o) { return geometry::cylinder_model(o); },
                 [](const geometry::LinkOptions& o) { return geometry::link_model(o); },
                 [](const geometry::SphereOptions& o) { return geometry::sphere_model(o); },
                 [](const geometry::PlateOptions& o) { return geometry::plate_model(o); },
                 [](const geometry::BracketOptions& o) { return geometry::bracket_model(o); },
                 [](const geometry::CookOptions& o) { return geometry::cook_model(o); },
                 [](const geometry::ElbowOptions& o) { return geometry::elbow_model(o); },
                 [](const geometry::EllipticPlateOptions& o) { return geometry::elliptic_plate_model(o); },
                 [](const geometry::TwistedBeamOptions& o) { return geometry::twisted_beam_model(o); }},
      dimensions);
}

}  // namespace isopatch::app

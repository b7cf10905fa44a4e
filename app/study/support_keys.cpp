#include <fmt/format.h>

#include "app/study/selection_keys.hpp"

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

}  // namespace

const Keys<SupportKeys>& support_keys() {
  using S = SupportKeys;
  static const Keys<S> keys = {
      text_key<S>("name", &S::name, "For messages and for the reactions in summary.json.")
          .with_default("\"support 1\", ..."),
      faces_key<S>(),
      where_key<S>(),
      table_key<S, FaceConditions>(
          "edges", &S::edges, edges_keys,
          "Holds, instead of the faces, those of their patches' edges that lie there: lines. Displacements "
          "and energy then grow without limit as elements become small; stresses elsewhere do not."),
      custom_key<S>(
          "displacement", "3 of length (m) or \"free\"",
          "Prescribed displacement; \"free\" leaves a component free.",
          [](S& target, const ConfigValue& value) { target.displacement = read_displacement(value); }),
      custom_key<S>(
          "displacement_gradient", "3 x 3 numbers",
          "Adds a linear part: u = displacement + displacement_gradient * x, with x in m.",
          [](S& target, const ConfigValue& value) { target.displacement_gradient = read_gradient(value); }),
      flag_key<S>("symmetry", &S::symmetry,
                  "A plane of symmetry of any orientation: no displacement along its normal."),
      flag_key<S>("roller", &S::roller,
                  "A frictionless guide on a plane face: the same condition by its other name."),
      quantity_key<S>("normal_displacement", &S::normal_displacement, dim::length, any_number,
                      "With roller: moves the faces along their outward normal.")
          .with_default("0"),
  };
  return keys;
}

const Keys<LoadKeys>& load_keys() {
  using L = LoadKeys;
  static const Keys<L> keys = {
      text_key<L>("name", &L::name, "For messages and reports.").with_default("\"load 1\", ..."),
      faces_key<L>(),
      where_key<L>(),
      vector_key<L>("traction", &L::traction, dim::pressure, "Force per area of the faces."),
      quantity_key<L>("pressure", &L::pressure, dim::pressure, any_number,
                      "Pushes against the faces where positive."),
      vector_key<L>("force", &L::force, dim::force,
                    "Total force, spread evenly over the area of all faces of this load."),
      patches_key<L>("The patches that body_force or gravity acts in."),
      vector_key<L>("body_force", &L::body_force, dim::force_per_volume, "Force per volume."),
      vector_key<L>("gravity", &L::gravity, dim::acceleration,
                    "Acceleration of gravity; the materials need a density."),
  };
  return keys;
}

}  // namespace isopatch::app

#include "app/study/support_tables.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

const Choices<bool> held_or_free = {{"fixed", true}, {"free", false}};

}  // namespace

const Keys<Cylindrical>& cylindrical_keys() {
  using C = Cylindrical;
  static const Keys<C> keys = {
      choice_key<C>("radial", &C::radial, held_or_free, "Displacement away from the axis."),
      choice_key<C>("tangential", &C::tangential, held_or_free, "Displacement around the axis."),
      choice_key<C>("axial", &C::axial, held_or_free, "Displacement along the axis."),
      vector_key<C>("point", &C::point, dim::length, "A point of the axis.")
          .with_default("the axis of the faces, which then must be cylinders about one axis"),
      custom_key<C>("axis", "3 numbers, or \"x\", \"-x\", \"y\", ...", "Direction of the axis; with `point`.",
                    [](C& target, const ConfigValue& value) { target.axis = read_direction(value, "axis"); })
          .with_default("as `point`"),
  };
  return keys;
}

const Keys<Elastic>& elastic_keys() {
  using E = Elastic;
  static const Keys<E> keys = {
      quantity_key<E>("normal", &E::normal, dim::force_per_volume, not_negative,
                      "Pressure per displacement across the faces: \"5 MPa/mm\". It pushes and pulls."),
      quantity_key<E>("tangential", &E::tangential, dim::force_per_volume, not_negative,
                      "Shear per displacement along the faces."),
      quantity_key<E>("total_normal", &E::total_normal, dim::stiffness, not_negative,
                      "Force per displacement across, of all the faces together, spread over their area."),
      quantity_key<E>("total_tangential", &E::total_tangential, dim::stiffness, not_negative,
                      "The same along the faces."),
  };
  return keys;
}

}  // namespace isopatch::app

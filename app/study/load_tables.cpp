#include "app/study/load_tables.hpp"

namespace isopatch::app {

namespace dim = dimensions;

const Keys<iga::RemoteForce>& remote_keys() {
  using R = iga::RemoteForce;
  static const Keys<R> keys = {
      vector_key<R>("force", &R::force, dim::force, "The force.").with_default("[0, 0, 0]"),
      vector_key<R>("moment", &R::moment, dim::energy, "A moment beside that of the force.")
          .with_default("[0, 0, 0]"),
      vector_key<R>("point", &R::point, dim::length, "Where the force acts, on the part or off it.")
          .with_default("the centroid of the faces"),
  };
  return keys;
}

const Keys<iga::Liquid>& hydrostatic_keys() {
  using L = iga::Liquid;
  static const Keys<L> keys = {
      quantity_key<L>("density", &L::density, dim::density, positive, "Of the liquid: water has 1000.")
          .required(),
      vector_key<L>("surface", &L::surface, dim::length,
                    "A point of the free surface; faces above it are dry.")
          .required(),
      vector_key<L>("gravity", &L::gravity, dim::acceleration, "Acceleration, which points into the depth.")
          .with_default("[0, 0, -9.80665]"),
  };
  return keys;
}

const Keys<iga::Rotation>& rotation_keys() {
  using R = iga::Rotation;
  static const Keys<R> keys = {
      quantity_key<R>("speed", &R::speed, dim::angular_velocity, any_number,
                      "Angular velocity: \"3000 rpm\", \"314 rad/s\".")
          .required(),
      vector_key<R>("point", &R::point, dim::length, "A point of the axis.").with_default("[0, 0, 0]"),
      direction_key<R>("axis", &R::axis, "Direction of the axis.").with_default("\"z\""),
  };
  return keys;
}

const Keys<iga::TemperatureChange>& temperature_keys() {
  using T = iga::TemperatureChange;
  static const Keys<T> keys = {
      quantity_key<T>("change", &T::change, dim::temperature, any_number,
                      "How much warmer than without stress, at `point`: \"50 K\"."),
      vector_key<T>("gradient", &T::gradient, dim::temperature_gradient,
                    "By how much that grows along x, y and z.")
          .with_default("[0, 0, 0]"),
      vector_key<T>("point", &T::point, dim::length, "Where the change is as given; with a gradient.")
          .with_default("[0, 0, 0]"),
  };
  return keys;
}

}  // namespace isopatch::app

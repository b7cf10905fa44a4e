#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>

#include "app/study/keys.hpp"

namespace isopatch::app {

/// Reads lengths of [model]: plain numbers are model units, others are divided by the unit.
struct ModelUnits {
  double length_unit = 1;

  double length(const ConfigValue& value, const std::string& what) const;
  Eigen::Vector3d point(const ConfigValue& value, const std::string& what) const;
};

inline constexpr const char* length_type = "length (model units, or with a unit)";

/// "[1, 0, 0]": a default as one would write it.
std::string format_default(const Eigen::Vector3d& value);

/// A length or a point that fills a member; its default is the one of a fresh O.
template <class O>
Key<O> length_key(ModelUnits units, const std::string& name, double O::*member, std::string meaning) {
  return custom_key<O>(
             name, length_type, std::move(meaning),
             [=](O& target, const ConfigValue& value) { target.*member = units.length(value, name); })
      .with_default(format_default(O{}.*member));
}
template <class O>
Key<O> point_key(ModelUnits units, const std::string& name, Eigen::Vector3d O::*member, std::string meaning) {
  return custom_key<O>(
             name, std::string("3 of ") + length_type, std::move(meaning),
             [=](O& target, const ConfigValue& value) { target.*member = units.point(value, name); })
      .with_default(format_default(Eigen::Vector3d(O{}.*member)));
}

}  // namespace isopatch::app

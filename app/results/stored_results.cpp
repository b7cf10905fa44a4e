#include "app/results/stored_results.hpp"

#include <fmt/format.h>

#include "app/base/place_outside.hpp"
#include "app/base/place_tolerance.hpp"
#include "app/base/units.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

Eigen::Vector3d parse_triple(const std::string& text, const Dimension& dimension, const char* example) {
  Eigen::Vector3d result;
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = text.find(',', begin);
    if ((comma == std::string::npos) != (i == 2))
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("expected three values such as {}, got '{}'", example, text));
    const Quantity quantity = parse_quantity(text.substr(begin, comma - begin));
    if (quantity.dimension != dimension && quantity.dimension != dimensions::none)
      throw Error(ErrorCode::invalid_argument, fmt::format("expected {}, got {} in '{}'", describe(dimension),
                                                           describe(quantity.dimension), text));
    result[i] = quantity.value;
    begin = comma + 1;
  }
  return result;
}

}  // namespace

Eigen::Vector3d parse_point(const std::string& text) {
  return parse_triple(text, dimensions::length, "0.1,0,20mm");
}

Eigen::Vector3d parse_parameter(const std::string& text) {
  return parse_triple(text, dimensions::none, "0.5,0.5,1");
}

StoredValues probe(const iga::StoredResult& result, const StoredProbe& where) {
  const geometry::MultiPatch model = iga::model_of(result);
  const int count = model.patch_count();
  if (where.point) {
    const iga::Location location = iga::locate(result.field, *where.point);
    if (location.distance > place_tolerance * model.size())
      throw Error(ErrorCode::invalid_argument, outside_text(model, *where.point, location));
    return {location.patch, model.to_input(PatchId(location.patch), location.parameter),
            iga::evaluate(result.field, location.patch, location.parameter)};
  }
  const int index = where.patch.value_or(-1);
  if (index < 0 || index >= count)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("patch {} does not exist: there are patches 0 to {}", index, count - 1));
  const auto& patch = model.patch(PatchId(index));
  const auto parameter = model.from_input(PatchId(index), where.parameter);
  if (((parameter - patch.low()).array() < 0).any() || ((patch.high() - parameter).array() < 0).any())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the parameter lies outside the knots of patch {}", index));
  return {index, where.parameter, iga::evaluate(result.field, index, parameter)};
}

}  // namespace isopatch::app

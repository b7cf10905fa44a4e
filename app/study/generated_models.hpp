#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/base/choices.hpp"
#include "app/study/generated_input.hpp"
#include "app/study/keys.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// A generated model, seen from the study file: its name and its keys.
struct GeneratedModel {
  std::string name;
  std::string meaning;
  std::vector<KeyText> keys;
  /// @param entries      of [model] that belong to the model
  /// @param length_unit  m per model unit, for lengths with a unit
  std::function<GeneratedDimensions(const ConfigTable& entries, const Place& place, double length_unit)> read;
};
const std::vector<GeneratedModel>& generated_models();
Choices<std::reference_wrapper<const GeneratedModel>> generated_model_choices();

/// The model with these dimensions, model units.
/// @throws Error invalid_argument  for dimensions that make no such model
geometry::PatchSet generated_patches(const GeneratedDimensions& dimensions);

}  // namespace isopatch::app

#include "app/study/material_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

#include "app/study/selection_keys.hpp"
#include "app/study/standard_materials.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

double read_poisson(const ConfigValue& value) {
  const double poisson = read_quantity(value, "poisson", dim::none);
  if (poisson > -1 && poisson < 0.5) return poisson;
  const char* advice =
      poisson == 0.5 ? ". An incompressible material has no displacement formulation; 0.499 comes close" : "";
  throw error_at(value.place,
                 fmt::format("poisson is {}; it must be above -1 and below 0.5{}", poisson, advice));
}

std::string material_names() {
  std::string result;
  for (const StandardMaterial& material : standard_materials())
    result += fmt::format(
        "{}{} (E {:g} GPa, nu {:g}, {:g} kg/m^3, {:g}e-6 1/K{}: {})", result.empty() ? "" : ", ",
        material.name, material.young / 1e9, material.poisson, material.density, material.expansion * 1e6,
        material.yield > 0 ? fmt::format(", yield {:g} MPa", material.yield / 1e6) : "", material.source);
  return result;
}

iga::Material read_standard_material(const MaterialKeys& keys, const Place& place) {
  if (!keys.name)
    throw error_at(
        place,
        "[[material]] needs elastic constants: lame, young and poisson, or the name of a known material");
  std::vector<std::string> known;
  for (const StandardMaterial& material : standard_materials()) {
    known.push_back(material.name);
    if (material.name != *keys.name) continue;
    iga::Material result = iga::isotropic(material.young, material.poisson,
                                          keys.density.value_or(material.density), material.name);
    result.yield = keys.yield.value_or(material.yield);
    result.expansion = material.expansion;
    return result;
  }
  throw error_at(place,
                 fmt::format("no material named \"{}\"{}; known: {}. Others need lame, or young and poisson",
                             *keys.name, did_you_mean(*keys.name, known), fmt::join(known, ", ")));
}

iga::Material read_constants(const MaterialKeys& keys, const Place& place) {
  const bool engineering = keys.young || keys.poisson;
  if (keys.lame && engineering)
    throw error_at(place, "[[material]] has both lame and young or poisson; keep one");
  if (engineering && !(keys.young && keys.poisson))
    throw error_at(place, fmt::format("[[material]] has {} but lacks {}", keys.young ? "young" : "poisson",
                                      keys.young ? "poisson" : "young"));
  if (!keys.lame && !engineering) return read_standard_material(keys, place);
  const double density = keys.density.value_or(0);
  const std::string name = keys.name.value_or("");
  try {
    iga::Material material = engineering
                                 ? iga::isotropic(*keys.young, *keys.poisson, density, name)
                                 : iga::Material{keys.lame->lambda, keys.lame->mu, density, name, 0, 0};
    material.yield = keys.yield.value_or(0);
    iga::validate(material);
    return material;
  } catch (const Error& error) {
    throw error_at(place, error.what());
  }
}

}  // namespace

const Keys<LameKeys>& lame_keys() {
  static const Keys<LameKeys> keys = {
      quantity_key<LameKeys>("lambda", &LameKeys::lambda, dim::pressure, any_number, "First Lame parameter.")
          .required(),
      quantity_key<LameKeys>("mu", &LameKeys::mu, dim::pressure, positive, "Shear modulus.").required(),
  };
  return keys;
}

const Keys<MaterialKeys>& material_keys() {
  static const Keys<MaterialKeys> keys = {
      patches_key<MaterialKeys>("The patches made of it.",
                                [](MaterialKeys& target, const ConfigValue&) -> PatchSelection& {
                                  return target.patches.emplace();
                                }),
      optional_text_key<MaterialKeys>("name", &MaterialKeys::name,
                                      "Without elastic constants, a material of the table: " +
                                          material_names() + "; with them, a name for reports."),
      quantity_key<MaterialKeys>("young", &MaterialKeys::young, dim::pressure, positive,
                                 "Young's modulus; with `poisson`."),
      custom_key<MaterialKeys>(
          "poisson", "number, above -1 and below 0.5", "Poisson's ratio; with `young`.",
          [](MaterialKeys& target, const ConfigValue& value) { target.poisson = read_poisson(value); }),
      table_key<MaterialKeys, LameKeys>("lame", &MaterialKeys::lame, lame_keys,
                                        "Lame parameters, in place of young and poisson."),
      quantity_key<MaterialKeys>("density", &MaterialKeys::density, dim::density, positive,
                                 "Mass per volume; needed by gravity, acceleration and rotation unless the "
                                 "table has it."),
      quantity_key<MaterialKeys>("expansion", &MaterialKeys::expansion, dim::expansion, any_number,
                                 "Linear thermal expansion, \"12e-6 1/K\" for steel; needed by "
                                 "temperature unless the table has it."),
      quantity_key<MaterialKeys>(
          "yield", &MaterialKeys::yield, dim::pressure, positive,
          "Yield stress, for the safety factor against it; grades of the table have one."),
  };
  return keys;
}

MaterialInput read_material(const ConfigSection& input) {
  const auto keys = read_table<MaterialKeys>(input.table, input.place, "[[material]]", material_keys());
  iga::Material material = read_constants(keys, input.place);
  if (keys.expansion) material.expansion = *keys.expansion;
  return {keys.patches.value_or(PatchSelection{{}, {}, input.place}), std::move(material), input.place};
}

}  // namespace isopatch::app

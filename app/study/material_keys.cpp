#include <fmt/format.h>

#include "app/study/selection_keys.hpp"
#include "app/study/standard_materials.hpp"

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
    result += fmt::format("{}{} (E {:g} GPa, nu {:g}, {:g} kg/m^3)", result.empty() ? "" : ", ",
                          material.name, material.young / 1e9, material.poisson, material.density);
  return result;
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
      patches_key<MaterialKeys>("The patches made of it."),
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
                                 "Mass per volume; needed by gravity unless the table has it."),
  };
  return keys;
}

}  // namespace isopatch::app

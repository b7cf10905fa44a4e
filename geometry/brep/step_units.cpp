#include "geometry/brep/step_units.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace isopatch::geometry {
namespace {

using Kind = Part21Value::Kind;

constexpr std::array<std::pair<std::string_view, double>, 16> prefixes = {{{"EXA", 1e18},
                                                                           {"PETA", 1e15},
                                                                           {"TERA", 1e12},
                                                                           {"GIGA", 1e9},
                                                                           {"MEGA", 1e6},
                                                                           {"KILO", 1e3},
                                                                           {"HECTO", 1e2},
                                                                           {"DECA", 1e1},
                                                                           {"DECI", 1e-1},
                                                                           {"CENTI", 1e-2},
                                                                           {"MILLI", 1e-3},
                                                                           {"MICRO", 1e-6},
                                                                           {"NANO", 1e-9},
                                                                           {"PICO", 1e-12},
                                                                           {"FEMTO", 1e-15},
                                                                           {"ATTO", 1e-18}}};

/// Names that say a length.
constexpr std::array<std::pair<std::string_view, double>, 16> names = {{{"INCH", 0.0254},
                                                                        {"INCHES", 0.0254},
                                                                        {"IN", 0.0254},
                                                                        {"FOOT", 0.3048},
                                                                        {"FEET", 0.3048},
                                                                        {"FT", 0.3048},
                                                                        {"YARD", 0.9144},
                                                                        {"MILE", 1609.344},
                                                                        {"MILLIMETRE", 1e-3},
                                                                        {"MILLIMETER", 1e-3},
                                                                        {"MM", 1e-3},
                                                                        {"CENTIMETRE", 1e-2},
                                                                        {"CENTIMETER", 1e-2},
                                                                        {"METRE", 1},
                                                                        {"METER", 1},
                                                                        {"MICRON", 1e-6}}};

template <std::size_t n>
std::optional<double> listed(const std::array<std::pair<std::string_view, double>, n>& table,
                             std::string_view name) {
  for (const auto& [known, value] : table)
    if (known == name) return value;
  return std::nullopt;
}

std::string capitals(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string unit_name(double metres) {
  for (const auto& [name, value] : {std::pair("mm", 1e-3),
                                    {"cm", 1e-2},
                                    {"m", 1.0},
                                    {"um", 1e-6},
                                    {"inch", 0.0254},
                                    {"foot", 0.3048},
                                    {"km", 1e3},
                                    {"dm", 0.1},
                                    {"nm", 1e-9}})
    if (std::abs(metres - value) < 1e-9 * value) return name;
  return fmt::format("{:.9g} m", metres);
}

/// A unit followed down to the metre.
struct Length {
  double metres = 0;         ///< 0 where it cannot be followed
  std::string problem = {};  ///< then
  int conversions = 0;       ///< from unit to unit on the way
  std::int64_t measure = 0;  ///< the instance that says how much of the next unit it is
};

class Follower {
 public:
  explicit Follower(const Part21File& file) : file_(file) {}

  /// A unit of a context. One that is so many metres but does not call itself a length is not taken for one
  /// by the CAD library, so that its lengths would be something else than we say.
  std::optional<Length> length_of(std::int64_t id) {
    const auto result = follow(id);
    if (!result || record_of(file_.records(*file_.find(id)), "LENGTH_UNIT") != nullptr) return result;
    Length silent;
    silent.problem = file_.place(*file_.find(id)) + " is so many metres but no LENGTH_UNIT";
    return silent;
  }

  /// Nothing if the instance is no unit of length.
  std::optional<Length> follow(std::int64_t id, int depth = 0) {
    const Part21Instance* instance = file_.find(id);
    if (instance == nullptr) return std::nullopt;
    const auto records = file_.records(*instance);
    const bool says_length = record_of(records, "LENGTH_UNIT") != nullptr;
    if (const Part21Record* si = record_of(records, "SI_UNIT")) return si_unit(*si);
    if (const Part21Record* other = record_of(records, "CONVERSION_BASED_UNIT"))
      return converted(*instance, *other, says_length, depth);
    if (!says_length) return std::nullopt;
    return Length{.problem = file_.place(*instance) + " does not say how long it is"};
  }

  std::vector<std::string> contradictions;

 private:
  static std::optional<Length> si_unit(const Part21Record& si) {
    const auto n = si.values.size();
    if (n < 2 || si.values[n - 1].text != "METRE") return std::nullopt;
    const Part21Value& prefix = si.values[n - 2];
    if (prefix.kind != Kind::enumeration) return Length{.metres = 1};
    const auto factor = listed(prefixes, prefix.text);
    return factor ? Length{.metres = *factor}
                  : Length{.problem = fmt::format("'{}' is no prefix of a unit", prefix.text)};
  }

  std::optional<Length> converted(const Part21Instance& instance, const Part21Record& unit, bool says_length,
                                  int depth) {
    Length result;
    const auto fail = [&](const std::string& why) -> std::optional<Length> {
      if (!says_length) return std::nullopt;
      result.metres = 0;
      result.problem = fmt::format("{}: {}", file_.place(instance), why);
      return result;
    };
    if (depth > 10) return fail("units refer to each other in a circle");
    const Part21Value* measure = nullptr;
    for (const Part21Value& value : unit.values)
      if (value.kind == Kind::reference) measure = &value;
    const Part21Instance* said = measure ? file_.find(measure->reference) : nullptr;
    if (said == nullptr) return fail("how long the unit is, is not in the file");
    double factor = 0;
    std::optional<Length> base;
    for (const Part21Record& record : file_.records(*said))
      for (const Part21Value& value : record.values) {
        if (value.kind == Kind::number) factor = value.number;
        if (value.kind == Kind::typed && !value.items.empty()) factor = value.items.front().number;
        if (value.kind == Kind::reference) base = follow(value.reference, depth + 1);
      }
    if (!base) return says_length ? fail("it is made of something that is no unit of length") : std::nullopt;
    if (base->metres == 0) return fail(base->problem);
    if (!(factor > 0)) return fail(fmt::format("its length is {}; it must be positive", factor));
    result = {.metres = factor * base->metres, .conversions = base->conversions + 1, .measure = said->id};
    compare_with_name(instance, unit, result.metres);
    return result;
  }

  void compare_with_name(const Part21Instance& instance, const Part21Record& unit, double metres) {
    for (const Part21Value& value : unit.values) {
      if (value.kind != Kind::text) continue;
      const auto meant = listed(names, capitals(value.text));
      if (meant && std::abs(metres / *meant - 1) > 1e-3)
        contradictions.push_back(fmt::format(
            "{}: the unit is called '{}' but is said to be {:.6g} mm long, and {:.6g} mm is taken",
            file_.place(instance), value.text, 1e3 * metres, 1e3 * metres));
    }
  }

  const Part21File& file_;
};

/// The shapes' contexts: instance of the shape, number of its context.
std::vector<std::pair<const Part21Instance*, std::int64_t>> contexts(const Part21File& file) {
  std::vector<std::pair<const Part21Instance*, std::int64_t>> result;
  for (const Part21Instance& instance : file.instances()) {
    const bool simple = instance.type.ends_with("SHAPE_REPRESENTATION");
    if (!simple &&
        (!instance.type.empty() || instance.body.find("SHAPE_REPRESENTATION") == std::string_view::npos))
      continue;
    for (const Part21Record& record : file.records(instance)) {
      if (!simple && record.type != "REPRESENTATION") continue;
      if (record.values.size() < 3) continue;
      result.emplace_back(&instance, record.values[2].reference);
    }
  }
  return result;
}

}  // namespace

StepUnits step_units(const Part21File& file) {
  StepUnits result;
  Follower follower(file);
  std::map<std::int64_t, std::optional<Length>> known;
  const auto of_context = [&](std::int64_t id) {
    std::optional<Length> found;
    const Part21Instance* context = file.find(id);
    if (context == nullptr) return found;
    const auto records = file.records(*context);
    const Part21Record* units = record_of(records, "GLOBAL_UNIT_ASSIGNED_CONTEXT");
    if (units == nullptr || units->values.empty()) return found;
    if (record_of(records, "GEOMETRIC_REPRESENTATION_CONTEXT") == nullptr)  // the kernel passes it over then
      return std::optional(
          Length{.problem = file.place(*context) + " has units, but is no GEOMETRIC_REPRESENTATION_CONTEXT"});
    for (const Part21Value& unit : units->values.front().items)
      if (!found) found = follower.length_of(unit.reference);
    return found;
  };
  std::vector<std::string> without, unit_names;
  std::set<std::int64_t> measures;
  for (const auto& [shape, context] : contexts(file)) {
    if (!known.contains(context)) known[context] = of_context(context);
    const auto& length = known[context];
    if (!length || length->metres == 0) {
      without.push_back(length ? length->problem
                               : fmt::format("{} has no unit of length", file.place(*shape)));
      continue;
    }
    result.stated = true;
    const std::string name = unit_name(length->metres);
    if (std::find(unit_names.begin(), unit_names.end(), name) == unit_names.end()) unit_names.push_back(name);
    if (length->conversions < 2 || !measures.insert(length->measure).second) continue;
    if (result.added.empty())
      result.added =
          fmt::format("#{}=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.));\n", file.largest_id() + 1);
    result.replaced[length->measure] = fmt::format("LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({:#.17g}),#{})",
                                                   length->metres, file.largest_id() + 1);
  }
  result.name = fmt::format("{}", fmt::join(unit_names, " and "));
  result.warnings = std::move(follower.contradictions);
  std::sort(without.begin(), without.end());
  without.erase(std::unique(without.begin(), without.end()), without.end());
  if (!without.empty())
    result.warnings.push_back(
        fmt::format("{}{}; {}", without.front(),
                    without.size() > 1 ? fmt::format(" (and {} more)", without.size() - 1) : "",
                    result.stated ? "mm is taken there" : "mm is taken; give length_unit if it is another"));
  return result;
}

}  // namespace isopatch::geometry

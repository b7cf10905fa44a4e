#include "app/commands/probe_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/base/engineering_units.hpp"
#include "app/base/internal/json_values.hpp"
#include "app/base/place_text.hpp"
#include "app/commands/input_options.hpp"
#include "app/results/place_values.hpp"
#include "app/results/stored_results.hpp"
#include "geometry/base/error.hpp"
#include "iga/post/stress_measures.hpp"

namespace isopatch::app {
namespace {

constexpr const char* probe_examples = R"(Examples:
  isopatch probe results/results.h5 --point 0.1,0,0.02
  isopatch probe results/results.h5 --point '100 mm,0,20 mm' --json
  isopatch probe results/results.h5 --patch 3 --parameter .5,.5,1
  isopatch probe results/results.h5 --line 0,0,0 '100 mm,0,0' --count 201 > along_x.csv
  isopatch probe results/results.h5 --places points.csv > values.csv     a point X,Y,Z a line
CSV is in SI units, with one row for each material that meets at a place.)";

std::string values_text(const StoredValues& found) {
  const iga::FieldValues& v = found.values;
  const auto tidy = [](const Eigen::Vector3d& x) { return without_round_off(x, x.cwiseAbs().maxCoeff()); };
  const auto stress = [&](int i, int j) {
    return without_round_off(v.stress(i, j), v.stress.cwiseAbs().maxCoeff());
  };
  const iga::PrincipalStresses principal = iga::principal_stresses(v.stress);
  const auto value = [&](int i) {
    return without_round_off(principal.values[i], principal.values.cwiseAbs().maxCoeff());
  };
  return fmt::format(
      "point         {} m, patch {}, parameter {}\n"
      "displacement  {} m\n"
      "stress        xx {:.6g}, yy {:.6g}, zz {:.6g}, xy {:.6g}, yz {:.6g}, zx {:.6g} Pa\n"
      "von Mises     {:.6g} Pa, Tresca {:.6g} Pa\n"
      "principal     {:.6g} Pa along {}\n"
      "              {:.6g} Pa along {}\n"
      "              {:.6g} Pa along {}\n",
      place_text(tidy(v.place), 9), found.patch, place_text(found.parameter, 6),
      place_text(tidy(v.displacement), 9), stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1),
      stress(1, 2), stress(2, 0), v.von_mises, iga::tresca(v.stress), value(0),
      place_text(tidy(principal.directions.col(0)), 4), value(1),
      place_text(tidy(principal.directions.col(1)), 4), value(2),
      place_text(tidy(principal.directions.col(2)), 4));
}

// "case          braking, of gravity, braking, design"; nothing of results without cases.
std::string case_text(const iga::StoredResult& result) {
  if (result.case_name.empty()) return "";
  return fmt::format("case          {}, of {}\n", result.case_name, fmt::join(result.case_names, ", "));
}

std::string values_json(const StoredValues& found, double yield, const std::string& case_name) {
  const iga::PrincipalStresses principal = iga::principal_stresses(found.values.stress);
  return file_text(
      {{"case", case_name.empty() ? Json() : Json(case_name)},
       {"patch", found.patch},
       {"parameter", to_json(Eigen::Vector3d(found.parameter))},
       {"point", to_json(found.values.place)},
       {"displacement", to_json(found.values.displacement)},
       {"strain", symmetric_to_json(found.values.strain)},
       {"stress", symmetric_to_json(found.values.stress)},
       {"von_mises", found.values.von_mises},
       {"tresca", iga::tresca(found.values.stress)},
       {"principal", to_json(principal.values)},
       {"principal_directions",
        {to_json(Eigen::Vector3d(principal.directions.col(0))),
         to_json(Eigen::Vector3d(principal.directions.col(1))),
         to_json(Eigen::Vector3d(principal.directions.col(2)))}},
       {"safety_factor", yield > 0 ? Json(iga::safety_factor(found.values.von_mises, yield)) : Json()},
       {"jacobian", found.values.jacobian}});
}

}  // namespace

ExitCode probe_command(const ProbeCommand& command, const Console& console) {
  const bool many = !command.line.empty() || command.places.has_value();
  if (many) {
    if (!command.point.empty() || command.patch || command.json || (!command.line.empty() && command.places))
      throw Error(ErrorCode::invalid_argument,
                  "--line and --places print CSV and go with none of the other options but --count");
    console.out << places_csv(iga::read_result(command.results, command.case_name),
                              command.places ? read_places(*command.places)
                                             : line_places(parse_point(command.line.at(0)),
                                                           parse_point(command.line.at(1)), command.count));
    return ExitCode::ok;
  }
  if (command.point.empty() == !command.patch.has_value() ||
      command.patch.has_value() == command.parameter.empty())
    throw Error(ErrorCode::invalid_argument,
                "give either --point X,Y,Z, or --patch N with --parameter A,B,C, or --line, or --places");
  StoredProbe where;
  if (!command.point.empty()) where.point = parse_point(command.point);
  where.patch = command.patch;
  if (!command.parameter.empty()) where.parameter = parse_parameter(command.parameter);
  const iga::StoredResult result = iga::read_result(command.results, command.case_name);
  const StoredValues found = probe(result, where);
  const double yield = result.field.materials[static_cast<std::size_t>(found.patch)].yield;
  console.out << (command.json ? values_json(found, yield, result.case_name)
                               : case_text(result) + values_text(found));
  if (!command.json && yield > 0)
    console.out << fmt::format("safety factor {:.4g} against yield\n",
                               iga::safety_factor(found.values.von_mises, yield));
  return ExitCode::ok;
}

void add_probe_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<ProbeCommand>();
  CLI::App& probe =
      add_command(app, line, "probe", "Values at a place of stored results", probe_examples,
                  [command](const Console& console) { return probe_command(*command, console); });
  probe.add_option("results", command->results, "A results.h5")->required();
  add_case(probe, command->case_name);
  probe.add_option("--point", command->point, "A place X,Y,Z in m, or with units")->type_name("X,Y,Z");
  probe.add_option("--patch", command->patch, "A patch, from 0")->type_name("N");
  probe.add_option("--parameter", command->parameter, "A parameter of that patch")->type_name("A,B,C");
  probe.add_option("--line", command->line, "Two places: values between them, ends included, as CSV")
      ->expected(2)
      ->type_name("X,Y,Z X,Y,Z");
  probe.add_option("--count", command->count, "Places on the line (default: 101)")
      ->check(CLI::Range(2, 1000000))
      ->type_name("N");
  probe.add_option("--places", command->places, "A file with a place X,Y,Z a line: values there as CSV")
      ->type_name("FILE");
  probe.add_flag("--json", command->json, "JSON instead of text");
}

}  // namespace isopatch::app

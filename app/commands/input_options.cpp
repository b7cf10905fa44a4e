#include "app/commands/input_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

namespace isopatch::app {

CLI::Validator above_zero() {
  const auto problem = [](const std::string& text) {
    double value = 0;
    const bool fine = CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value);
    return fine ? std::string() : fmt::format("'{}' is no number above 0", text);
  };
  return {problem, "POSITIVE"};
}

void add_reading(CLI::App& command, CadReading& reading) {
  command.add_flag("--allow-partial", reading.allow_partial,
                   "Bodies and faces of CAD files that cannot be read are a warning and left out");
  command
      .add_option("--cad-time-limit", reading.time_limit,
                  "Seconds that a CAD file may take to be read; default: 60, and 10 for each MB")
      ->check(above_zero())
      ->type_name("S");
  command
      .add_option("--cad-memory-limit", reading.memory_limit,
                  "Bytes that a CAD file may take to be read; default: three quarters of the memory")
      ->check(above_zero())
      ->type_name("BYTES");
}

void add_case(CLI::App& command, std::string& name) {
  command.add_option("--case", name, "A load case or combination of the results (default: the first)")
      ->type_name("NAME");
}

void add_input(CLI::App& command, InputFile& input) {
  command
      .add_option("input", input.path,
                  "Patches (.xml, .g2, .mesh), a solid (.step, .iges, .brep, .xml, .off), a study (.toml) or "
                  "results (.h5)")
      ->required();
  command.add_option("--set", input.overrides, "Replaces a key of the study")
      ->take_all()
      ->expected(1)
      ->type_name("KEY=VALUE");
  command.add_option("--length-unit", input.length_unit,
                     "What one unit of the file measures [m]; STEP and IGES files say it themselves");
  add_reading(command, input.reading);
}

}  // namespace isopatch::app

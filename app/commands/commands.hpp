#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/base/exit_code.hpp"
#include "app/commands/console.hpp"
#include "app/problem/parameterized_model.hpp"
#include "app/render/picture_options.hpp"
#include "app/results/load_input.hpp"
#include "app/run/compare_levels.hpp"
#include "solvers/processes.hpp"

namespace isopatch::app {

/// Options that `run` and `compare` share.
struct StudyCommand {
  std::filesystem::path study;
  std::vector<std::string> overrides;           ///< --set key=value
  std::optional<std::filesystem::path> output;  ///< --output; relative to the current folder
  solvers::Processes processes = {};  ///< that solve it together; all call the command, the first one writes
};

/// Solves a study, writes its files, prints the summary.
ExitCode run_command(const StudyCommand& command, const Console& console);

/// Solves each level with both couplings, writes compare.json after each, prints the tables; `failed` if they
/// disagree at any level or memory ends the work.
ExitCode compare_command(const StudyCommand& command, const LevelOptions& levels, const Console& console);

struct InfoCommand {
  InputFile input;
  bool json = false;
  bool all = false;
};
/// Describes a model: patches, interfaces, faces, quality.
ExitCode info_command(const InfoCommand& command, const Console& console);

struct ProbeCommand {
  std::filesystem::path results;
  std::string point;  ///< "0.1,0,20 mm"
  std::optional<int> patch;
  std::string parameter;  ///< ".5,.5,1"
  bool json = false;
};
/// Values at a point or a parameter of stored results.
ExitCode probe_command(const ProbeCommand& command, const Console& console);

struct FieldsCommand {
  std::filesystem::path results;
  std::filesystem::path output;
  int pieces = 0;  ///< as FieldOptions
};
/// Writes the fields of stored results for ParaView.
ExitCode fields_command(const FieldsCommand& command, const Console& console);

struct ReportCommand {
  std::filesystem::path results;
  std::optional<std::filesystem::path> output;  ///< default: report.html beside the results
};
/// Writes the page about stored results.
ExitCode report_command(const ReportCommand& command, const Console& console);

struct RenderCommand {
  InputFile input;
  std::filesystem::path output;  ///< .png
  std::optional<int> solid;      ///< of a file with several; all of them if not given
  PictureWords words;
};
/// Draws a model or results as a picture.
ExitCode render_command(const RenderCommand& command, const Console& console);

struct ParameterizeCommand {
  std::vector<std::filesystem::path> blocks;
  std::string pairs;        ///< a file, or "" to find them from the geometry
  std::string length_unit;  ///< as of InputFile
  CadReading reading;
  std::string method = "shared";
  BlocksInput input;             ///< the options; files are filled in
  std::filesystem::path output;  ///< .xml
  std::filesystem::path report;  ///< .html, or "" for none
};
/// Makes patches of topological hexahedra and writes them as G+Smo XML; `failed` if one is not certified or
/// deviates too far, after writing. The report shows the patches or, where the input is bad, what is wrong
/// with it.
ExitCode parameterize_command(const ParameterizeCommand& command, const Console& console);

struct ConvertCommand {
  std::filesystem::path input;
  std::filesystem::path output;
};
/// Writes patches as G+Smo XML.
ExitCode convert_command(const ConvertCommand& command, const Console& console);

struct VerifyCommand {
  std::vector<std::string> suites;  ///< empty: all
  bool full = false;
  bool list = false;
  std::filesystem::path output = "results/verification";
};
/// Runs the verification suites, writes verify.json and verify.html, prints the table; `failed` if a claim
/// fails.
ExitCode verify_command(const VerifyCommand& command, const Console& console);

/// Prints the documentation of the study file.
ExitCode keys_command(const std::string& topic, const Console& console);

}  // namespace isopatch::app

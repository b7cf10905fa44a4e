#include "app/commands/verify_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "app/results/output_directory.hpp"
#include "app/verify/verification_report.hpp"
#include "geometry/base/stopwatch.hpp"

namespace isopatch::app {
namespace {

constexpr const char* verify_examples = R"(Examples:
  isopatch verify                                    all quick suites
  isopatch verify closed_forms published             some
  isopatch verify --level full                       everything; takes long
Prints one table and writes verify.json and verify.html. Exit code 1 if a claim fails; the study or test
that shows it alone is named.)";

}  // namespace

ExitCode verify_command(const VerifyCommand& command, const Console& console) {
  const auto level = *find_choice(verification_levels(), command.level);
  const std::filesystem::path program = verification_program();
  if (command.list) {
    console.out << fmt::format("{}\n", fmt::join(verification_suites(program, level), "\n"));
    return ExitCode::ok;
  }
  check_writable(command.output);
  ProgressDisplay display(console);
  Stopwatch watch;
  const std::vector<VerifiedClaim> claims =
      run_verification(program, command.suites, level, display.progress());
  const double seconds = watch.lap();
  display.clear();
  const std::string json = verification_json(claims, level, seconds);
  write_in(command.output, "verify.json", json);
  write_in(command.output, "verify.html", to_html(verification_page(json, claims)));
  if (!console.quiet)
    console.out << verification_text(claims)
                << fmt::format("took {0:.0f} s; written to {1}/verify.json and {1}/verify.html\n", seconds,
                               command.output.string());
  const VerificationCounts counts = count_claims(claims);
  if (counts.fail == 0 && counts.hold > 0) return ExitCode::ok;
  console.fail(counts.fail > 0 ? fmt::format("{} of the claims fail", counts.fail) : "no claim was checked");
  return ExitCode::failed;
}

void add_verify_command(CLI::App& app, CommandLine& line) {
  const auto command = std::make_shared<VerifyCommand>();
  CLI::App& verify = add_command(
      app, line, "verify", "Checks what isopatch claims against reference results", verify_examples,
      [command](const Console& console) { return verify_command(*command, console); });
  verify.add_option("suites", command->suites, "Names of suites (default: all of the level)");
  verify.add_option("--level", command->level, "quick takes minutes, full as long as it needs")
      ->check(CLI::IsMember(names(verification_levels())))
      ->capture_default_str();
  verify.add_flag("--list", command->list, "Only the names of the suites");
  verify.add_option("-o,--output", command->output, "Directory of verify.json and verify.html")
      ->type_name("DIR")
      ->capture_default_str();
}

}  // namespace isopatch::app

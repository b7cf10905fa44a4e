#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/base/exit_code.hpp"
#include "app/commands/commands.hpp"
#include "app/results/output_directory.hpp"
#include "app/verify/verification_report.hpp"
#include "geometry/base/stopwatch.hpp"

namespace isopatch::app {

ExitCode verify_command(const VerifyCommand& command, const Console& console) {
  const auto level = command.full ? VerificationLevel::full : VerificationLevel::quick;
  const std::filesystem::path program = verification_program();
  if (command.list) {
    console.out << fmt::format("{}\n", fmt::join(verification_suites(program, level), "\n"));
    return ExitCode::ok;
  }
  check_writable(command.output);
  ProgressDisplay display(console);
  Stopwatch watch;
  const std::string claims = run_verification(program, command.suites, level, display.progress());
  const double seconds = watch.lap();
  display.clear();
  const std::string json = verification_json(claims, level, seconds);
  write_in(command.output, "verify.json", json);
  write_in(command.output, "verify.html", to_html(verification_page(json)));
  if (!console.quiet)
    console.out << verification_text(claims)
                << fmt::format("took {0:.0f} s; written to {1}/verify.json and {1}/verify.html\n", seconds,
                               command.output.string());
  const VerificationCounts counts = count_claims(claims);
  if (counts.fail == 0 && counts.hold > 0) return ExitCode::ok;
  console.fail(counts.fail > 0 ? fmt::format("{} of the claims fail", counts.fail) : "no claim was checked");
  return ExitCode::failed;
}

}  // namespace isopatch::app

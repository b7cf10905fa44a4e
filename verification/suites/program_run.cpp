#include "verification/suites/program_run.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/temporary_folder.hpp"
#include "iga/output/result_file.hpp"

namespace isopatch::verification {
namespace {

namespace fs = std::filesystem;

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

// A suite that has used MPI itself leaves variables that would make a launcher believe it is one of several
// processes: programs are started with the environment that this one was started with.
const std::string at_the_start = [] {
  std::string result = "env -i";
  for (char** variable = environ; *variable != nullptr; ++variable) result += " " + quoted(*variable);
  return result;
}();

// Open MPI refuses root, who only runs this program and its own studies here.
std::string launcher(int processes) {
  return fmt::format("{}{} --oversubscribe --bind-to none -n {} ",
                     ::geteuid() == 0 ? "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 " : "",
                     quoted(ISOPATCH_MPIEXEC), processes);
}

std::string command_line(const ClaimStudy& study, const Launch& launch, const fs::path& output) {
  std::string line = fmt::format("{} OMP_NUM_THREADS={} ", at_the_start, launch.threads);
  if (launch.processes > 1) line += launcher(launch.processes);
  line += fmt::format("{} run {} --quiet --output {}", quoted(ISOPATCH_PROGRAM),
                      quoted((fs::path(ISOPATCH_SOURCE_DIR) / study.file).string()), quoted(output.string()));
  for (const char* setting : {"output.fields=false", "output.report=false"})
    line += fmt::format(" --set {}", setting);
  for (const std::string& setting : study.overrides) line += " --set " + quoted(setting);
  return line;
}

// @param what  for the message: the command has the whole environment
void run(const std::string& command, const std::string& what) {
  std::FILE* pipe = ::popen((command + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot start " + what);
  std::string said;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) said += static_cast<char>(c);
  if (::pclose(pipe) != 0) throw std::runtime_error(what + " fails and says: " + said);
}

// Without the rules between which Open MPI sets its messages.
std::string in_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::string result;
  for (const char c : text)
    if (result.empty() || (c != ' ' && c != '-') || c != result.back()) result += c;
  return result;
}

}  // namespace

std::string words(const Launch& launch) {
  const auto many = [](int n, const char* one, const char* several) {
    return fmt::format("{} {}", n, n == 1 ? one : several);
  };
  return many(launch.processes, "process", "processes") + " of " + many(launch.threads, "thread", "threads");
}

std::string launcher_fault() {
  try {
    run(fmt::format("{} {} true", at_the_start, launcher(2)), "no processes can be started: mpiexec");
    return "";
  } catch (const std::runtime_error& error) {
    return in_one_line(error.what());
  }
}

ProgramRun run_program(const ClaimStudy& study, const Launch& launch) {
  const TemporaryFolder folder;
  run(command_line(study, launch, folder.path()), fmt::format("{} in {}", study.file, words(launch)));
  const auto summary = nlohmann::json::parse(read_file(folder.path() / "summary.json"));
  // Some are not estimated.
  const auto& error = summary["results"]["discretization_error"];
  const double error_energy =
      error.is_object() && error.contains("energy") ? error["energy"].get<double>() : std::nan("");
  return {iga::read_result(folder.path() / "results.h5").field,
          summary["results"]["internal_energy"].get<double>(),
          summary["results"]["max_displacement"].get<double>(),
          summary["parallel"]["processes"].get<int>(),
          summary["parallel"]["threads"].get<int>(),
          error_energy};
}

}  // namespace isopatch::verification

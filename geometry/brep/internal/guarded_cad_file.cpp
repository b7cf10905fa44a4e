#include "geometry/brep/internal/guarded_cad_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <iostream>
#include <new>
#include <nlohmann/json.hpp>

#include "geometry/base/error.hpp"
#include "geometry/base/guarded_process.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/internal/installed_part.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/brep/tessellation.hpp"

// Parent and child speak in one line of JSON, behind which the bodies follow as bytes.
namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int out_of_memory_code = 12;

Json to_json(const Eigen::Vector3d& p) {
  return {p.x(), p.y(), p.z()};
}

Json fault_json(const SolidFault& fault) {
  Json faces = Json::array(), edges = Json::array(), points = Json::array();
  for (const auto& face : fault.faces) faces.push_back({face.number, face.solid, face.remark});
  for (const auto& edge : fault.edges) {
    Json line = Json::array();
    for (const auto& point : edge.points.colwise()) line.push_back(to_json(point));
    edges.push_back({edge.name, line});
  }
  for (const auto& point : fault.points) points.push_back({point.name, to_json(point.point)});
  return {{"faces", faces}, {"edges", edges}, {"points", points}};
}

Eigen::Vector3d point_of(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

SolidFault fault_of(const Json& json) {
  SolidFault fault;
  for (const Json& face : json.at("faces"))
    fault.faces.push_back(
        {face.at(0).get<int>(), face.at(1).get<std::string>(), face.at(2).get<std::string>()});
  for (const Json& edge : json.at("edges")) {
    SolidFault::Edge line{edge.at(0).get<std::string>(),
                          Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(edge.at(1).size()))};
    for (std::size_t i = 0; i < edge.at(1).size(); ++i)
      line.points.col(static_cast<Eigen::Index>(i)) = point_of(edge.at(1)[i]);
    fault.edges.push_back(std::move(line));
  }
  for (const Json& point : json.at("points"))
    fault.points.push_back({point.at(0).get<std::string>(), point_of(point.at(1))});
  return fault;
}

Json options_json(const ReadBrepOptions& options) {
  Json length_unit;
  if (options.length_unit) length_unit = *options.length_unit;
  return {{"length_unit", length_unit},
          {"same_point", options.sew.same_point},
          {"same_curve", options.sew.same_curve},
          {"accept_open", options.sew.accept_open},
          {"allow_partial", options.allow_partial}};
}

ReadBrepOptions options_of(const Json& json) {
  ReadBrepOptions options;
  if (!json.at("length_unit").is_null()) options.length_unit = json.at("length_unit").get<double>();
  options.sew.same_point = json.at("same_point");
  options.sew.same_curve = json.at("same_curve");
  options.sew.accept_open = json.at("accept_open");
  options.allow_partial = json.at("allow_partial");
  return options;
}

void write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ::ssize_t n = ::write(descriptor, bytes.data(), bytes.size());
    if (n < 0 && errno != EINTR) ::_exit(1);
    if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

/// Does to the bodies whatever the parent may do to them with the library, so that it happens here first.
void try_out(const std::vector<KernelSolid>& bodies, const Progress& progress) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    progress("checking the bodies", 0.5 + 0.5 * double(i) / double(bodies.size()));
    try {
      const Brep brep(bodies[i].kernel);
      const BrepReport report = check(brep);
      if (!report.contradictions.empty() || !report.boundary.bounds_a_solid())  // else checking has done so
        tessellate(brep, {.turn = Angle::degrees(60)});
      for (std::size_t f = 0; f < brep.faces().size(); ++f) {
        const FaceId face(static_cast<int>(f));
        const DomainBox box = brep.domain(face);
        brep.contains(face, 0.5 * (box.low + box.high));
      }
    } catch (const Error&) {  // the parent will meet it again and say it
    }
  }
}

/// @throws std::bad_alloc  the memory that the library itself needs is not there
void load_module() {
  try {
    brep_module();
  } catch (const Error& error) {
    const std::string_view why = error.what();
    for (const char* words : {"failed to map", "annot allocate", "annot create shared object"})
      if (why.find(words) != why.npos) throw std::bad_alloc();
    throw;
  }
}

std::string answer_of(const fs::path& path, BrepFormat format, const ReadBrepOptions& options) {
  try {
    load_module();
    const CadFile file = read_cad_file(path, format, options);
    try_out(file.bodies, options.progress);
    const Json said = {{"missing", file.missing}, {"warnings", file.warnings}, {"unit", file.unit}};
    return said.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" +
           brep_module().to_bytes(file.bodies);
  } catch (const Error& error) {
    Json said = {{"error", static_cast<int>(error.code())}, {"message", error.what()}};
    if (const auto* placed = dynamic_cast<const SolidError*>(&error))
      said["fault"] = fault_json(placed->fault());
    return said.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  }
}

CadFile file_of(const std::string& answer) {
  const std::size_t line = answer.find('\n');
  const Json said = Json::parse(answer.substr(0, line));
  if (said.contains("error")) {
    const auto code = static_cast<ErrorCode>(said.at("error").get<int>());
    const std::string message = said.at("message");
    if (said.contains("fault")) throw SolidError(code, message, fault_of(said.at("fault")));
    throw Error(code, message);
  }
  return {brep_module().from_bytes(answer.substr(line + 1)), said.at("missing"), said.at("warnings"),
          said.at("unit")};
}

/// Sixty seconds, and ten for each megabyte: some fifty times what a sound file takes.
double default_seconds(const fs::path& path) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  return 60 + 1e-5 * (none ? 0 : double(size));
}

/// Three quarters of the machine's memory, at least 2 GB of addresses.
std::uint64_t default_bytes() {
  const double memory = double(::sysconf(_SC_PHYS_PAGES)) * double(::sysconf(_SC_PAGE_SIZE));
  return static_cast<std::uint64_t>(std::max(0.75 * memory, 2e9));
}

// Of address space: with less the program that reads ends before it can say why.
constexpr std::uint64_t least_bytes = 50'000'000;

GuardLimits limits_of(const fs::path& path, const ReadBrepOptions& options) {
  GuardLimits limits = options.limits;
  if (limits.bytes > 0 && limits.bytes < least_bytes)
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("the memory limit for CAD files is {} bytes; it must be {} or more, without which the "
                    "CAD library cannot even begin",
                    limits.bytes, least_bytes));
  if (!(limits.seconds > 0)) limits.seconds = default_seconds(path);
  if (limits.bytes == 0) limits.bytes = default_bytes();
#if defined(__SANITIZE_ADDRESS__)
  limits.bytes = 0;  // it takes terabytes of addresses
#endif
  return limits;
}

[[noreturn]] void fail(const fs::path& path, const GuardedOutcome& outcome, const GuardLimits& limits) {
  const bool memory = outcome.end == GuardedOutcome::End::exited && outcome.code == out_of_memory_code;
  const bool time = outcome.end == GuardedOutcome::End::timed_out;
  throw Error(
      ErrorCode::bad_format,
      fmt::format(
          "{}: the CAD library could not read the file: it {}. Most likely the file is damaged: open it in a "
          "CAD "
          "program and save it again{}",
          path.string(),
          memory ? fmt::format("needed more than {:.3g} GB of memory", 1e-9 * double(limits.bytes))
                 : outcome.text(limits),
          time ? "; a very large one may need a higher --cad-time-limit (in a study, [model] cad_time_limit)"
          : memory ? "; a very large one may need a higher --cad-memory-limit (in a study, [model] "
                     "cad_memory_limit)"
                   : ""));
}

/// "0.25 checking the bodies".
void pass_on(std::string_view line, const Progress& progress) {
  double share = 0;
  const auto [stop, problem] = std::from_chars(line.data(), line.data() + line.size(), share);
  if (problem != std::errc{} || stop == line.data() + line.size()) return;
  progress(std::string_view(stop + 1, static_cast<std::size_t>(line.data() + line.size() - stop - 1)), share);
}

}  // namespace

CadFile read_cad_file_guarded(const fs::path& path, BrepFormat format, const ReadBrepOptions& options) {
  const GuardLimits limits = limits_of(path, options);
  GuardedCommand command;
  command.program = installed_part("isopatch_cad_reader");
  command.arguments = {fs::absolute(path).string(), std::to_string(static_cast<int>(format)),
                       options_json(options).dump()};
  command.limits = limits;
  command.on_line = [&](std::string_view line) { pass_on(line, options.progress); };
  const GuardedOutcome outcome = run_guarded(command);
  if (!outcome.succeeded() || outcome.result.empty()) fail(path, outcome, limits);
  return file_of(outcome.result);
}

int cad_reader_main(int count, const char* const* arguments) {
  if (count != 4) return 2;
  // What the library prints must not be taken for phases.
  const int phases = ::dup(STDOUT_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  try {
    ReadBrepOptions options = options_of(Json::parse(arguments[3]));
    options.progress.report = [&](std::string_view phase, double share) {
      write_all(phases, fmt::format("{} {}\n", share, phase));
    };
    write_all(3, answer_of(arguments[1], static_cast<BrepFormat>(std::stoi(arguments[2])), options));
    std::fflush(nullptr);
    ::_exit(0);  // the library's own end is none of our concern
  } catch (const std::bad_alloc&) {
    return out_of_memory_code;
  }
}

}  // namespace isopatch::geometry

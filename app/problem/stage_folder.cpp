#include "app/problem/stage_folder.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <system_error>

#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/content_hash.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::app {
namespace {

constexpr const char* index_name = "stages.json";

/// JSON has no whole numbers of 64 bits.
std::string hexadecimal(std::uint64_t number) {
  return fmt::format("{:016x}", number);
}

std::string now() {
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::chrono::system_clock::now()));
}

/// What is written down of the stages; nothing for a file that is missing or broken.
Json read_index(const std::filesystem::path& folder) {
  try {
    Json index = Json::parse(read_file(folder / index_name));
    return index.is_object() ? index : Json::object();
  } catch (const std::exception&) {
    return Json::object();
  }
}

void write_index(const std::filesystem::path& folder, const Json& index) {
  write_file(folder / index_name, file_text(index));
}

std::string text_in(const Json& entry, const char* name) {
  const auto found = entry.find(name);
  return found != entry.end() && found->is_string() ? found->get<std::string>() : "";
}

/// The entry of a stage if its file is still what it was.
std::optional<StageReport> sound(const Json& index, Stage stage, const std::filesystem::path& file) {
  const auto entry = index.find(name_of(stage_choices(), stage));
  if (entry == index.end() || !entry->is_object()) return std::nullopt;
  StageReport report{.stage = stage, .kept = true, .file = file, .made = text_in(*entry, "made")};
  const auto seconds = entry->find("seconds");
  if (seconds != entry->end() && seconds->is_number()) report.seconds = seconds->get<double>();
  try {
    report.content = content_hash(read_file(file));
  } catch (const Error&) {
    return std::nullopt;
  }
  if (hexadecimal(report.content) != text_in(*entry, "content")) return std::nullopt;
  return report;
}

std::uint64_t stamp_of(const std::filesystem::path& file, std::uint64_t before) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(file, ignored);
  const auto time = std::filesystem::last_write_time(file, ignored).time_since_epoch().count();
  return content_hash(fmt::format("{} {}", size, time), before);
}

}  // namespace

const char* stage_file(Stage stage) {
  switch (stage) {
    case Stage::solid:
      return "solids.h5";
    case Stage::hexahedra:
      return "blocks.h5";
    case Stage::patches:
      return "patches.h5";
    case Stage::solution:
      break;
  }
  return "results.h5";
}

std::uint64_t build_stamp() {
  const std::uint64_t program = stamp_of("/proc/self/exe", content_hash(version()));
  return stamp_of(geometry::brep_module_file(), program);
}

std::filesystem::path StageFolder::path(Stage stage) const {
  return options_.folder / stage_file(stage);
}

std::optional<StageReport> StageFolder::last(Stage stage) const {
  return is_used() ? sound(read_index(options_.folder), stage, path(stage)) : std::nullopt;
}

std::optional<StageReport> StageFolder::kept(Stage stage, std::uint64_t key) const {
  if (!is_used() || (options_.from && *options_.from <= stage)) return std::nullopt;
  const Json index = read_index(options_.folder);
  const auto entry = index.find(name_of(stage_choices(), stage));
  if (entry == index.end() || !entry->is_object() || text_in(*entry, "key") != hexadecimal(key))
    return std::nullopt;
  return sound(index, stage, path(stage));
}

StageReport StageFolder::keep(Stage stage, std::uint64_t key, std::string_view bytes, double seconds) const {
  StageReport report{.stage = stage, .seconds = seconds, .content = content_hash(bytes)};
  if (!options_.writes) return report;
  try {
    std::filesystem::create_directories(options_.folder);
    write_file(path(stage), bytes);
    Json index = read_index(options_.folder);
    index["program"] = fmt::format("isopatch {}", version());
    report.made = now();
    index[name_of(stage_choices(), stage)] = {{"file", stage_file(stage)},
                                              {"made", report.made},
                                              {"seconds", seconds},
                                              {"key", hexadecimal(key)},
                                              {"content", hexadecimal(report.content)}};
    write_index(options_.folder, index);
    report.file = path(stage);
  } catch (const std::exception& error) {
    report.problem = error.what();
  }
  return report;
}

std::string stages_text(const std::vector<StageReport>& stages) {
  std::string before, anew, made;
  for (const StageReport& report : stages) {
    const std::string name = name_of(stage_choices(), report.stage);
    if (report.kept) {
      before += (before.empty() ? "" : ", ") + name;
      made = std::max(made, report.made);
    } else {
      anew += fmt::format("{}{} in {:.1f} s", anew.empty() ? "" : ", ", name, report.seconds);
    }
  }
  std::string text = before.empty() ? "" : fmt::format("{} as before ({})", before, made);
  if (!anew.empty()) text += (text.empty() ? "" : "; ") + anew;
  if (!stages.empty() && !stages.front().file.empty())
    text += fmt::format("; kept in {}", stages.front().file.parent_path().string());
  return text;
}

}  // namespace isopatch::app

#include "app/verification_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "app/internal/json_values.hpp"
#include "app/provenance.hpp"
#include "app/summary.hpp"
#include "app/verification_plots.hpp"

namespace isopatch::app {
namespace {

std::string number(const Json& claim, const char* key, const char* format) {
  return claim.contains(key) && claim[key].is_number()
             ? fmt::format(fmt::runtime(format), claim[key].get<double>())
             : "-";
}

std::string verdict(const Json& claim) {
  return claim.value("verdict", "");
}

// What is allowed: a difference, or the side of a limit.
std::string allowed(const Json& claim) {
  const std::string comparison = claim.value("comparison", "");
  const bool is_limit = claim.contains("allowed") && claim["allowed"].is_number() &&
                        (comparison == "at most" || comparison == "at least");
  return is_limit ? comparison : number(claim, "allowed", "{:.2g}");
}

std::string row(const Json& claim) {
  if (!claim.contains("reference"))
    return fmt::format("    {:<8} {}\n", verdict(claim), claim.value("what", ""));
  const std::string unit = claim.value("unit", "");
  const std::string what = claim.value("what", "") + (unit.empty() ? "" : fmt::format(" ({})", unit));
  std::string notes;
  for (const char* key : {"kind", "source", "why", "reason"})
    if (const std::string note = claim.value(key, ""); !note.empty())
      notes += (notes.empty() ? "" : ", ") + note;
  return fmt::format("    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}  {}\n", verdict(claim), what,
                     number(claim, "reference", "{:.7g}"), number(claim, "value", "{:.7g}"),
                     number(claim, "difference", "{:.2g}"), allowed(claim), notes);
}

// As a shell takes it.
std::string quoted(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.,=/-";
  if (text.find_first_not_of(plain) == std::string::npos) return text;
  const char mark = text.find('"') == std::string::npos ? '"' : '\'';
  return mark + text + mark;
}

// How a user sees a failing claim for himself.
std::string command(const Json& claim) {
  const Json& study = claim.contains("study") ? claim["study"] : Json();
  if (!study.is_object())
    return fmt::format("isopatch-verification --gtest_filter='*{}'", claim.value("test", ""));
  std::string text = "isopatch run " + study.value("file", "");
  for (const Json& setting : study["set"]) text += " --set " + quoted(setting.get<std::string>());
  return text;
}

VerificationCounts counts_of(const Json& claims) {
  VerificationCounts counts;
  for (const Json& claim : claims) {
    const std::string found = verdict(claim);
    ++(found == "holds"      ? counts.hold
       : found == "not run"  ? counts.not_run
       : found == "reported" ? counts.reported
                             : counts.fail);
  }
  return counts;
}

Json counts_json(const VerificationCounts& counts) {
  return {{"hold", counts.hold},
          {"fail", counts.fail},
          {"not_run", counts.not_run},
          {"reported", counts.reported}};
}

/// The claims of each suite, in the order in which suites first appear.
std::vector<std::pair<std::string, Json>> by_suite(const Json& claims) {
  std::vector<std::pair<std::string, Json>> suites;
  for (const Json& claim : claims) {
    const std::string name = claim.value("suite", "");
    auto suite = std::find_if(suites.begin(), suites.end(), [&](const auto& s) { return s.first == name; });
    if (suite == suites.end()) suite = suites.insert(suites.end(), {name, Json::array()});
    suite->second.push_back(claim);
  }
  return suites;
}

}  // namespace

VerificationCounts count_claims(const std::string& claims) {
  return counts_of(Json::parse(claims));
}

std::string verification_json(const std::string& claims, VerificationLevel level, double seconds) {
  const Json all = Json::parse(claims);
  Json suites = Json::array();
  for (const auto& [suite, claims_of_suite] : by_suite(all)) {
    Json entry = {{"name", suite}};
    entry.update(counts_json(counts_of(claims_of_suite)));
    suites.push_back(entry);
  }
  Json text = {{"schema_version", 1},
               {"program", {{"name", "isopatch"}, {"version", version()}}},
               {"level", level == VerificationLevel::full ? "full" : "quick"},
               {"seconds", seconds}};
  text.update(counts_json(counts_of(all)));
  text.update({{"suites", suites}, {"claims", all}});
  return file_text(text);
}

std::string verification_text(const std::string& claims) {
  const Json all = Json::parse(claims);
  std::string text;
  for (const auto& [suite, claims_of_suite] : by_suite(all)) {
    text += fmt::format("\n{}\n    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}\n", suite, "", "claim", "reference",
                        "value", "differs", "allowed");
    std::string part;
    for (const Json& claim : claims_of_suite) {
      if (claim.value("case", "") != part) {
        part = claim.value("case", "");
        text += fmt::format("  {}\n", part);
      }
      text += row(claim);
    }
  }
  const VerificationCounts counts = counts_of(all);
  text += fmt::format("\n{} claims hold, {} fail, {} not run\n", counts.hold, counts.fail, counts.not_run);
  for (const Json& claim : all)
    if (verdict(claim) == "FAILS")
      text += fmt::format("fails: {}\n  alone: {}\n", claim.value("what", ""), command(claim));
  return text;
}

Page verification_page(const std::string& json) {
  Page page;
  page.kind = "verification";
  page.program = fmt::format("isopatch {}", version());
  page.title = "Verification";
  page.summary_json = json;
  page.plots = verification_plots(Json::parse(json)["claims"].dump());
  return page;
}

}  // namespace isopatch::app

#include "app/verify/verification_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "app/base/internal/json_values.hpp"
#include "app/base/provenance.hpp"
#include "app/verify/internal/claim_json.hpp"
#include "app/verify/verification_plots.hpp"

namespace isopatch::app {
namespace {

using Claims = std::vector<VerifiedClaim>;

std::string number_text(const std::optional<double>& number, int digits) {
  return number ? fmt::format("{:.{}g}", *number, digits) : "-";
}

std::string verdict_text(const VerifiedClaim& claim) {
  return name_of(verdicts(), claim.verdict);
}

// What is allowed: a difference, or the side of a limit.
std::string allowed_text(const ClaimFigures& figures) {
  const bool is_limit = figures.comparison == "at most" || figures.comparison == "at least";
  return is_limit && figures.allowed ? figures.comparison : number_text(figures.allowed, 2);
}

std::string row(const VerifiedClaim& claim) {
  if (!claim.figures) return fmt::format("    {:<8} {}\n", verdict_text(claim), claim.what);
  const std::string what = claim.what + (claim.unit.empty() ? "" : fmt::format(" ({})", claim.unit));
  std::string notes;
  const ClaimFigures& figures = *claim.figures;
  for (const std::string& note : {claim.kind, claim.source, claim.why.value_or(""), figures.reason})
    if (!note.empty()) notes += (notes.empty() ? "" : ", ") + note;
  return fmt::format("    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}  {}\n", verdict_text(claim), what,
                     number_text(figures.reference, 7), number_text(figures.value, 7),
                     number_text(figures.difference, 2), allowed_text(figures), notes);
}

// As a shell takes it.
std::string quoted(const std::string& text) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.,=/-";
  if (text.find_first_not_of(plain) == std::string::npos) return text;
  const char mark = text.find('"') == std::string::npos ? '"' : '\'';
  return mark + text + mark;
}

// How a user sees a failing claim for himself.
std::string command(const VerifiedClaim& claim) {
  if (!claim.study) return fmt::format("isopatch-verification --gtest_filter='*{}'", claim.test);
  std::string text = "isopatch run " + claim.study->file;
  for (const std::string& setting : claim.study->overrides) text += " --set " + quoted(setting);
  return text;
}

Json counts_json(const VerificationCounts& counts) {
  return {{"hold", counts.hold},
          {"fail", counts.fail},
          {"not_run", counts.not_run},
          {"reported", counts.reported}};
}

/// The claims of each suite, in the order in which suites first appear.
std::vector<std::pair<std::string, Claims>> by_suite(const Claims& claims) {
  std::vector<std::pair<std::string, Claims>> suites;
  for (const VerifiedClaim& claim : claims) {
    auto suite =
        std::find_if(suites.begin(), suites.end(), [&](const auto& s) { return s.first == claim.suite; });
    if (suite == suites.end()) suite = suites.insert(suites.end(), {claim.suite, {}});
    suite->second.push_back(claim);
  }
  return suites;
}

}  // namespace

VerificationCounts count_claims(const Claims& claims) {
  const auto count = [&](Verdict verdict) {
    return static_cast<int>(std::count_if(claims.begin(), claims.end(),
                                          [&](const auto& claim) { return claim.verdict == verdict; }));
  };
  return {count(Verdict::holds), count(Verdict::fails), count(Verdict::not_run), count(Verdict::reported)};
}

std::string verification_json(const Claims& claims, VerificationLevel level, double seconds) {
  Json suites = Json::array(), all = Json::array();
  for (const auto& [suite, claims_of_suite] : by_suite(claims)) {
    Json entry = {{"name", suite}};
    entry.update(counts_json(count_claims(claims_of_suite)));
    suites.push_back(entry);
  }
  for (const VerifiedClaim& claim : claims) all.push_back(claim_json(claim));
  Json text = {{"schema_version", 1},
               {"program", {{"name", "isopatch"}, {"version", version()}}},
               {"level", name_of(verification_levels(), level)},
               {"seconds", seconds}};
  text.update(counts_json(count_claims(claims)));
  text.update({{"suites", suites}, {"claims", all}});
  return file_text(text);
}

std::string verification_text(const Claims& claims) {
  std::string text;
  for (const auto& [suite, claims_of_suite] : by_suite(claims)) {
    text += fmt::format("\n{}\n    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}\n", suite, "", "claim", "reference",
                        "value", "differs", "allowed");
    std::string part;
    for (const VerifiedClaim& claim : claims_of_suite) {
      if (claim.part != part) {
        part = claim.part;
        text += fmt::format("  {}\n", part);
      }
      text += row(claim);
    }
  }
  const VerificationCounts counts = count_claims(claims);
  text += fmt::format("\n{} claims hold, {} fail, {} not run\n", counts.hold, counts.fail, counts.not_run);
  for (const VerifiedClaim& claim : claims)
    if (claim.verdict == Verdict::fails)
      text += fmt::format("fails: {}\n  alone: {}\n", claim.what, command(claim));
  return text;
}

Page verification_page(const std::string& json, const Claims& claims) {
  Page page;
  page.kind = "verification";
  page.program = fmt::format("isopatch {}", version());
  page.title = "Verification";
  page.summary_json = json;
  page.plots = verification_plots(claims);
  return page;
}

}  // namespace isopatch::app

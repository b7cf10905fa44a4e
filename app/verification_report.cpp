#include "app/verification_report.hpp"

#include <fmt/format.h>

#include "app/internal/json_values.hpp"
#include "app/summary.hpp"

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

std::string row(const Json& claim) {
  if (!claim.contains("reference"))
    return fmt::format("    {:<8} {}\n", verdict(claim), claim.value("what", ""));
  const std::string unit = claim.value("unit", "");
  const std::string what = claim.value("what", "") + (unit.empty() ? "" : fmt::format(" ({})", unit));
  return fmt::format("    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}  {}, {}\n", verdict(claim), what,
                     number(claim, "reference", "{:.7g}"), number(claim, "value", "{:.7g}"),
                     number(claim, "difference", "{:.2g}"), number(claim, "allowed", "{:.2g}"),
                     claim.value("kind", ""), claim.value("source", ""));
}

// How a user sees a failing claim for himself.
std::string command(const Json& claim) {
  const Json& study = claim.contains("study") ? claim["study"] : Json();
  if (!study.is_object())
    return fmt::format("isopatch-verification --gtest_filter='*{}'", claim.value("test", ""));
  std::string text = "isopatch run " + study.value("file", "");
  for (const Json& setting : study["set"]) text += " --set " + setting.get<std::string>();
  return text;
}

}  // namespace

VerificationCounts count_claims(const std::string& claims) {
  VerificationCounts counts;
  for (const Json& claim : Json::parse(claims)) {
    const std::string found = verdict(claim);
    ++(found == "holds" ? counts.hold : found == "not run" ? counts.not_run : counts.fail);
  }
  return counts;
}

std::string verification_json(const std::string& claims, VerificationLevel level) {
  const VerificationCounts counts = count_claims(claims);
  return file_text({{"schema_version", 1},
                    {"program", {{"name", "isopatch"}, {"version", version()}}},
                    {"level", level == VerificationLevel::full ? "full" : "quick"},
                    {"hold", counts.hold},
                    {"fail", counts.fail},
                    {"not_run", counts.not_run},
                    {"claims", Json::parse(claims)}});
}

std::string verification_text(const std::string& claims) {
  const Json all = Json::parse(claims);
  std::string text;
  std::string suite;
  std::string part;
  for (const Json& claim : all) {
    if (claim.value("suite", "") != suite) {
      part.clear();
      suite = claim.value("suite", "");
      text += fmt::format("\n{}\n    {:<8} {:<48} {:>14} {:>14} {:>9} {:>9}\n", suite, "", "claim",
                          "reference", "value", "differs", "allowed");
    }
    if (claim.value("case", "") != part) {
      part = claim.value("case", "");
      text += fmt::format("  {}\n", part);
    }
    text += row(claim);
  }
  const VerificationCounts counts = count_claims(claims);
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
  return page;
}

}  // namespace isopatch::app

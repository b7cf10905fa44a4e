#include "app/verify/verified_claim.hpp"

#include <limits>

#include "app/base/internal/json_values.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

std::string text_in(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

std::optional<double> number_in(const Json& json, const char* key) {
  return json.contains(key) && json[key].is_number() ? std::optional(json[key].get<double>()) : std::nullopt;
}

std::vector<double> numbers_in(const Json& json, const char* key) {
  std::vector<double> result;
  if (!json.contains(key) || !json[key].is_array()) return result;
  for (const Json& x : json[key])
    result.push_back(x.is_number() ? x.get<double>() : std::numeric_limits<double>::quiet_NaN());
  return result;
}

ClaimFigures figures_of(const Json& json) {
  return {number_in(json, "reference"), number_in(json, "value"), number_in(json, "difference"),
          text_in(json, "comparison"),  number_in(json, "least"), number_in(json, "allowed"),
          text_in(json, "reason")};
}

ClaimedStudy study_in(const Json& json) {
  ClaimedStudy study{text_in(json, "file"), {}};
  if (json.contains("set") && json["set"].is_array())
    for (const Json& setting : json["set"])
      if (setting.is_string()) study.overrides.push_back(setting.get<std::string>());
  return study;
}

VerifiedClaim claim_of(const Json& json) {
  VerifiedClaim claim{text_in(json, "suite"), text_in(json, "case"), text_in(json, "test"),
                      text_in(json, "what")};
  claim.unit = text_in(json, "unit");
  claim.kind = text_in(json, "kind");
  claim.source = text_in(json, "source");
  if (json.contains("reference")) claim.figures = figures_of(json);
  if (json.contains("why")) claim.why = text_in(json, "why");
  if (json.contains("study") && json["study"].is_object()) claim.study = study_in(json["study"]);
  if (json.contains("convergence") && json["convergence"].is_object()) {
    const Json& levels = json["convergence"];
    claim.convergence = {numbers_in(levels, "sizes"), numbers_in(levels, "errors"),
                         numbers_in(levels, "orders")};
  }
  if (const Verdict* verdict = find_choice(verdicts(), text_in(json, "verdict"))) claim.verdict = *verdict;
  return claim;
}

}  // namespace

const Choices<Verdict>& verdicts() {
  static const Choices<Verdict> words = {{"holds", Verdict::holds},
                                         {"FAILS", Verdict::fails},
                                         {"not run", Verdict::not_run},
                                         {"reported", Verdict::reported}};
  return words;
}

std::vector<VerifiedClaim> read_claims(const std::string& record) {
  const Json json = Json::parse(record, nullptr, false);
  if (!json.is_array()) throw Error(ErrorCode::bad_format, "the record of the suites is no array of claims");
  std::vector<VerifiedClaim> claims;
  for (const Json& claim : json)
    if (claim.is_object()) claims.push_back(claim_of(claim));
  return claims;
}

}  // namespace isopatch::app

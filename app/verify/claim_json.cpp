#include "app/verify/internal/claim_json.hpp"

#include <cmath>

namespace isopatch::app {
namespace {

Json number_json(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

Json numbers_json(const std::vector<double>& numbers) {
  Json result = Json::array();
  for (const double number : numbers) result.push_back(std::isfinite(number) ? Json(number) : Json());
  return result;
}

Json study_json(const std::optional<ClaimedStudy>& study) {
  return study ? Json{{"file", study->file}, {"set", study->overrides}} : Json();
}

void add_figures(Json& json, const VerifiedClaim& claim) {
  const ClaimFigures& figures = *claim.figures;
  json.update({{"unit", claim.unit},
               {"kind", claim.kind},
               {"source", claim.source},
               {"reference", number_json(figures.reference)},
               {"value", number_json(figures.value)},
               {"difference", number_json(figures.difference)},
               {"comparison", figures.comparison},
               {"least", number_json(figures.least)},
               {"allowed", number_json(figures.allowed)},
               {"reason", figures.reason}});
  if (claim.why) json["why"] = *claim.why;
  json["study"] = study_json(claim.study);
  if (claim.convergence)
    json["convergence"] = {{"sizes", numbers_json(claim.convergence->sizes)},
                           {"errors", numbers_json(claim.convergence->errors)},
                           {"orders", numbers_json(claim.convergence->orders)}};
}

}  // namespace

Json claim_json(const VerifiedClaim& claim) {
  Json json = {{"suite", claim.suite}, {"test", claim.test}, {"what", claim.what}};
  if (claim.figures) add_figures(json, claim);
  json["verdict"] = name_of(verdicts(), claim.verdict);
  json["case"] = claim.part;
  return json;
}

}  // namespace isopatch::app

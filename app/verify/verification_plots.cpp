#include "app/verify/verification_plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "app/plots/line_plot.hpp"

namespace isopatch::app {
namespace {

constexpr std::size_t most_lines = 8;  // as many as there are colours

/// Orders of convergence that one plot shows: of one test, of the same measure.
struct Group {
  std::string suite;
  std::string part;
  std::string measure;  ///< "displacement in L2"
  std::vector<std::vector<std::string>> names;
  std::vector<VerifiedClaim> claims;
};

/// "displacement in L2, a box, p = 2" in pieces.
std::vector<std::string> pieces(std::string text) {
  constexpr std::string_view prefix = "order of ";
  if (text.starts_with(prefix)) text = text.substr(prefix.size());
  std::vector<std::string> result;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(", ", start), text.size());
    result.push_back(text.substr(start, end - start));
    start = end + 2;
  }
  return result;
}

std::vector<Group> groups(const std::vector<VerifiedClaim>& claims) {
  std::vector<Group> result;
  for (const VerifiedClaim& claim : claims) {
    if (!claim.convergence) continue;
    std::vector<std::string> name = pieces(claim.what);
    const auto fits = [&](const Group& group) {
      return group.suite == claim.suite && group.part == claim.part && group.measure == name.front() &&
             group.claims.size() < most_lines;
    };
    auto group = std::find_if(result.begin(), result.end(), fits);
    if (group == result.end()) {
      result.push_back({claim.suite, claim.part, name.front(), {}, {}});
      group = result.end() - 1;
    }
    group->names.emplace_back(name.begin() + 1, name.end());
    group->claims.push_back(claim);
  }
  return result;
}

/// Words that all names have go into the title and leave the lines' names.
std::vector<std::string> take_common(std::vector<std::vector<std::string>>& names) {
  std::vector<std::string> common;
  if (names.size() < 2) return common;
  for (const std::string& word : std::vector<std::string>(names.front())) {
    const auto has_word = [&](const std::vector<std::string>& name) {
      return std::find(name.begin(), name.end(), word) != name.end();
    };
    if (!std::all_of(names.begin(), names.end(), has_word)) continue;
    common.push_back(word);
    for (auto& name : names) std::erase(name, word);
  }
  return common;
}

LinePlot plot_of(Group group) {
  const std::vector<std::string> common = take_common(group.names);
  LinePlot plot{.title = fmt::format("{}: {}", group.part, group.measure),
                .description = fmt::format(
                    "Relative error over the size of the elements, of {}; slopes are orders of convergence",
                    group.part),
                .x = {.label = "element size", .unit = "", .scale = Scale::logarithmic},
                .y = {.label = "relative error, " + group.measure, .unit = "", .scale = Scale::logarithmic},
                .series = {}};
  if (!common.empty()) plot.title += fmt::format(", {}", fmt::join(common, ", "));
  for (std::size_t i = 0; i < group.claims.size(); ++i) {
    const VerifiedClaim& claim = group.claims[i];
    PlotSeries series{.name = fmt::format("{}", fmt::join(group.names[i], ", ")),
                      .x = claim.convergence->sizes,
                      .y = claim.convergence->errors};
    const std::size_t count = std::min(series.x.size(), series.y.size());
    series.x.resize(count);
    series.y.resize(count);
    if (claim.figures && claim.figures->reference) series.expected_slope = *claim.figures->reference;
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::vector<PagePlot> verification_plots(const std::vector<VerifiedClaim>& claims) {
  std::vector<PagePlot> plots;
  for (const Group& group : groups(claims)) plots.push_back({"", to_svg(plot_of(group)), group.suite});
  return plots;
}

}  // namespace isopatch::app

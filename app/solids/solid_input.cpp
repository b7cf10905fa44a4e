#include "app/solids/solid_input.hpp"

#include <optional>
#include <string>
#include <utility>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "segmentation/decomposition/prospect.hpp"

namespace isopatch::app {

LoadedSolids load_solids(const InputFile& input, const Progress& progress) {
  geometry::ReadBrepOptions options;
  if (!input.length_unit.empty()) options.length_unit = length_unit(input);
  options.sew.accept_open = true;
  options.progress = progress;
  set_reading(input.reading, options);
  geometry::BrepSet set = geometry::read_breps(input.path, options);
  LoadedSolids result{{}, std::move(set.missing), std::move(set.warnings), std::move(set.unit)};
  for (std::size_t i = 0; i < set.bodies.size(); ++i) {
    progress("describing the bodies", double(i) / double(set.bodies.size()));
    geometry::BrepReport report = geometry::check(set.bodies[i].brep);
    std::optional<segmentation::Prospect> prospect;
    std::string recognised;
    if (report.stage != geometry::BrepStage::repair) {
      const geometry::RecognisedBrep found = geometry::recognise_carriers(set.bodies[i].brep);
      recognised = found.text();
      if (report.stage != geometry::BrepStage::parameterization)
        prospect = segmentation::prospect(found.brep);
    }
    result.bodies.push_back(
        {std::move(set.bodies[i]), std::move(report), std::move(prospect), std::move(recognised)});
  }
  return result;
}

}  // namespace isopatch::app

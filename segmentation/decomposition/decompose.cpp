#include "segmentation/decomposition/decompose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/conforming.hpp"
#include "segmentation/decomposition/cut_tree.hpp"
#include "segmentation/decomposition/geometric_oracle.hpp"
#include "segmentation/decomposition/keep_t_joints.hpp"
#include "segmentation/decomposition/star_cells.hpp"
#include "segmentation/decomposition/starting_cell.hpp"
#include "segmentation/decomposition/templates.hpp"
#include "segmentation/decomposition/unfinished_parts.hpp"

namespace isopatch::segmentation {
namespace {

/// ": 12 would leave the cell, ..."; "" if there are none.
std::string reasons(const CellStore& store) {
  std::string text;
  for (const auto& [reason, count] : store.refusals())
    text += fmt::format("{} {} times: {}", text.empty() ? ":" : ",", count, reason);
  return text;
}

bool is_polyhedral(const geometry::Brep& solid, const geometry::CellComplex& complex) {
  for (std::size_t c = 0; c < complex.cells.size(); ++c)
    if (!is_polyhedral(CellShapes(solid, complex), geometry::CellId(static_cast<int>(c)))) return false;
  return true;
}

/// By further cuts, if there are not too many of them, else by tetrahedra, which need plane sides.
geometry::CellComplex side_to_side(const geometry::Brep& solid, geometry::CellComplex complex,
                                   const DecompositionOptions& options, DecompositionReport& report,
                                   const Progress& progress) {
  DecompositionOptions limited = options;
  limited.max_cells = std::min(options.max_cells, 20 + 6 * static_cast<int>(complex.cells.size()));
  try {
    return conforming(solid, complex, limited, report, progress);
  } catch (const Error&) {
    if (!is_polyhedral(solid, complex)) throw;
    report.further_cuts = 0;
    report.by_tetrahedra = true;
    return star_cells(solid, std::move(complex));
  }
}

/// @throws CuttingError unsupported  of what the search left, or ran out of time for
void require_complete(const CutTree& tree, const CellStore& store, double time_limit) {
  if (tree.complete()) return;
  if (store.time_is_up())
    throw unfinished_search(
        fmt::format("no way of cutting it into hexahedra was found in {:.3g} s; raise time_limit, or cut the "
                    "solid in the CAD program where its parts join",
                    time_limit),
        tree, store);
  throw unfinished_search(
      fmt::format("{} of its parts could not be cut into hexahedra, prisms and tetrahedra, the first at {} "
                  "of the solid; {} cuts were tried, {} of them refused{}. Cut the solid in the CAD program "
                  "where its parts join",
                  tree.unfinished.size(), faces_of_unfinished(tree, store), tree.evaluations, tree.refusals,
                  reasons(store)),
      tree, store);
}

/// Tells how far a search is, the details behind a tab, and ends it when the time is up.
std::function<bool(const SearchRound&)> watched(const CellStore& store, const std::string& name,
                                                double time_limit, const Progress& progress) {
  return [&store, name, time_limit, &progress](const SearchRound& round) {
    progress(fmt::format("cutting '{}'\t{} cut{}, {} part{} unfinished, {:.0f} of {:g} s", name, round.cuts,
                         round.cuts == 1 ? "" : "s", round.open, round.open == 1 ? "" : "s", store.seconds(),
                         time_limit),
             store.seconds() / time_limit);
    return !store.time_is_up();
  };
}

Decomposition cut_to_hexahedra(const geometry::Brep& solid, const std::string& name,
                               const DecompositionOptions& options, const Progress& progress) {
  const Stopwatch watch;
  CellStore store(solid, options.cut, options.time_limit);
  StartingCell start = starting_cell(store);
  Decomposition result;
  result.complex = std::move(start.complex);
  SearchOracle oracle = geometric_oracle(store);
  oracle.goes_on = watched(store, name, options.time_limit, progress);
  const CutTree tree = search_cuts(start.cell, oracle, options.search);
  result.report.evaluations = tree.evaluations;
  require_complete(tree, store, options.time_limit);
  result.report.cuts = apply_cuts(solid, result.complex, geometry::CellId(0), tree, store, options.cut);
  result.report.cells = static_cast<int>(result.complex.cells.size());
  result.parts = result.complex;
  result.t_joints = parted_sides(CellShapes(solid, result.parts), options.cut.sides);
  const double tolerance = options.cut.tolerance * solid.size();
  try {
    if (options.t_joints == TJoints::keep) {
      result.report.t_joints_kept = true;
      result.complex = keep_t_joints(solid, std::move(result.complex), tolerance, options.cut.sides);
    } else {
      result.complex = side_to_side(solid, std::move(result.complex), options, result.report, progress);
      result.complex = hexahedral(solid, std::move(result.complex), tolerance);
    }
  } catch (const Error& error) {
    throw unfinished_meeting(error, solid, result.parts, result.t_joints);
  }
  result.report.t_joints = static_cast<int>(result.t_joints.size());
  result.report.hexahedra = static_cast<int>(result.complex.cells.size());
  result.report.seconds = watch.seconds();
  return result;
}

}  // namespace

Decomposition decompose(const geometry::Brep& solid, const std::string& name,
                        const DecompositionOptions& options, const Progress& progress) {
  validate(options);
  progress(fmt::format("cutting '{}'", name), 0);
  const auto named = [&](const Error& error) { return fmt::format("solid '{}': {}", name, error.what()); };
  try {
    return cut_to_hexahedra(solid, name, options, progress);
  } catch (const CuttingError& error) {
    throw CuttingError(error.code(), named(error), of_solid(error.fault(), name), error.parts());
  } catch (const geometry::SolidError& error) {
    throw geometry::SolidError(error.code(), named(error), of_solid(error.fault(), name));
  } catch (const Error& error) {
    throw Error(error.code(), named(error));
  }
}

}  // namespace isopatch::segmentation

#include "segmentation/decomposition/decompose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "segmentation/decomposition/conforming.hpp"
#include "segmentation/decomposition/cut_tree.hpp"
#include "segmentation/decomposition/geometric_oracle.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/decomposition/star_cells.hpp"
#include "segmentation/decomposition/templates.hpp"

namespace isopatch::segmentation {
namespace {

/// ": 12 would leave the cell, ..."; "" if there are none.
std::string reasons(const CellStore& store) {
  std::string text;
  for (const auto& [reason, count] : store.refusals())
    text += fmt::format("{} {} times: {}", text.empty() ? ":" : ",", count, reason);
  return text;
}

/// By further cuts, if there are not too many of them, else by tetrahedra.
geometry::CellComplex side_to_side(const geometry::Brep& solid, geometry::CellComplex complex,
                                   const DecompositionOptions& options, DecompositionReport& report,
                                   const Progress& progress) {
  DecompositionOptions limited = options;
  limited.max_cells = std::min(options.max_cells, 20 + 6 * static_cast<int>(complex.cells.size()));
  try {
    return conforming(solid, complex, limited, report, progress);
  } catch (const Error&) {
    report.further_cuts = 0;
    report.by_tetrahedra = true;
    return star_cells(solid, std::move(complex));
  }
}

}  // namespace

Decomposition decompose(const geometry::Brep& solid, const std::string& name,
                        const DecompositionOptions& options, const Progress& progress) {
  validate(options);
  const Stopwatch watch;
  progress(fmt::format("cutting '{}'", name), 0);
  Decomposition result;
  result.complex = prepared(solid);
  CellStore store(solid, options.cut, options.time_limit);
  const geometry::CellId all(0);
  const SearchCell whole = store.add(result.complex, all);
  const CutTree tree = search_cuts(whole, geometric_oracle(store), options.search);
  result.report.evaluations = tree.evaluations;
  if (!tree.complete())
    throw Error(
        ErrorCode::unsupported,
        fmt::format(
            "solid '{}': {} of its parts could not be cut into hexahedra, prisms and tetrahedra; {} cuts "
            "were tried, {} of them refused{}",
            name, tree.unfinished.size(), tree.evaluations, tree.refusals, reasons(store)));
  result.report.cuts = apply_cuts(solid, result.complex, all, tree, store, options.cut);
  result.report.cells = static_cast<int>(result.complex.cells.size());
  result.complex = side_to_side(solid, std::move(result.complex), options, result.report, progress);
  result.complex = hexahedral(solid, std::move(result.complex), options.cut.tolerance * solid.size());
  result.report.hexahedra = static_cast<int>(result.complex.cells.size());
  result.report.seconds = watch.seconds();
  return result;
}

}  // namespace isopatch::segmentation

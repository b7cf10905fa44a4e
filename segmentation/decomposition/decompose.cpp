#include "segmentation/decomposition/decompose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/graph_connectivity.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
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

/// @throws SolidError not_three_connected  naming two faces that meet in more than a vertex or an edge, and
/// where
void require_three_connected(const geometry::Brep& solid, const CellGraph& sides) {
  if (is_three_connected(sides)) return;
  const geometry::EdgeGraph graph = edge_graph(solid);
  const auto report = connectivity(graph, topology(graph, boundary(graph)));
  std::string where;
  geometry::SolidFault fault;
  if (const auto& conflict = report.conflict) {
    where = fmt::format(": {} and {} meet in {} and in {} without the edge between them",
                        describe(solid, conflict->first), describe(solid, conflict->second),
                        describe(solid, conflict->u), describe(solid, conflict->v));
    fault.faces = {{conflict->first.value}, {conflict->second.value}};
    fault.points = {{"one place", solid.vertex(conflict->u)}, {"the other", solid.vertex(conflict->v)}};
  }
  throw geometry::SolidError(
      ErrorCode::not_three_connected,
      fmt::format("its edge graph is not 3-connected{}; cut the solid there in the CAD program", where),
      std::move(fault));
}

bool is_polyhedral(const geometry::Brep& solid, const geometry::CellComplex& complex) {
  for (std::size_t c = 0; c < complex.cells.size(); ++c)
    if (!is_polyhedral(CellShapes(solid, complex), geometry::CellId(static_cast<int>(c)))) return false;
  return true;
}

/// Searches weigh differently what cannot be weighed before neighbours are known: T-joints, and solids that are no
/// hexahedra. The first is the one asked for.
std::vector<SearchOptions> searches(const SearchOptions& asked) {
  std::vector<SearchOptions> result;
  for (const double divided : {1.0, 2.0, 0.0})
    for (const double t_joint : {1.0, 0.25, 4.0}) {
      result.push_back(asked);
      result.back().cost.divided *= divided;
      result.back().cost.t_joint *= t_joint;
    }
  return result;
}

/// Takes one solid apart: finds ways to cut it into base solids, and keeps the one of which the fewest hexahedra come
/// once its parts meet side to side.
class Decomposer {
 public:
  Decomposer(const geometry::Brep& solid, const DecompositionOptions& options, const Progress& progress)
      : solid_(solid),
        options_(options),
        progress_(progress),
        store_(solid, options.cut, options.time_limit),
        prepared_(prepared(solid)),
        whole_(store_.add(prepared_, geometry::CellId(0))) {
    require_three_connected(solid, whole_.graph);
  }

  Decomposition make() {
    for (const SearchOptions& search : searches(options_.search)) {
      best_ && watch_.seconds() > options_.time_limit / 6) break;
      look(search);
    }
    if (!best_ && complete_.empty()) give_up();
    if (!best_) by_tetrahedra();
    best_->report.evaluations = evaluations_;
    best_->report.seconds = watch_.seconds();
    return std::move(*best_);
  }

 private:
  [[noreturn]] void give_up() const {
    throw Error(ErrorCode::unsupported,
                fmt::format("{} of its parts could not be cut into hexahedra, prisms and tetrahedra; {} cuts "
                            "were tried, {} of them "
                            "refused{}. Cut the solid in the CAD program where its parts join",
                            unfinished_->unfinished.size(), unfinished_->evaluations, unfinished_->refusals,
                            reasons(store_)));
  }

  Decomposition cut(const CutTree& tree) const {
    Decomposition result;
    result.complex = prepared_;
    result.report.cuts = apply_cuts(solid_, result.complex, geometry::CellId(0), tree, store_, options_.cut);
    result.report.cells = static_cast<int>(result.complex.cells.size());
    return result;
  }

  /// One search; of its ways the one that takes the fewest hexahedra.
  void look(const SearchOptions& search) {
    std::vector<Decomposition> ways;
    std::vector<geometry::CellComplex> starts;
    for (const CutTree& tree : search_several(whole_, geometric_oracle(store_), search)) {
      evaluations_ += tree.evaluations;
      if (!tree.complete()) {
        if (!unfinished_) unfinished_ = tree;
        continue;
      }
      try {
        ways.push_back(cut(tree));
        starts.push_back(ways.back().complex);
      } catch (const Error& error) {
        failure_ = error.what();
      }
    }
    if (ways.empty()) return;
    ConformingOptions conform;
    conform.cut = options_.cut;
    conform.cut.smallest_angle = Angle::degrees(1);
    conform.cut.shortest_edge /= 10;
    conform.max_hexahedra = std::min(options_.max_cells, best_ ? best_->report.hexahedra - 1 : options_.max_cells);
    ConformingAttempt attempt = conforming(solid_, starts, conform, progress_);
    if (attempt.best.empty())
      failure_ = attempt.refusal;
    else
      finish(std::move(attempt.best.front()), ways);
    if (complete_.empty()) complete_.push_back(std::move(ways.front()));
  }

  void finish(ConformingCells cells, const std::vector<Decomposition>& ways) {
    Decomposition way = ways[cells.start];
    way.report.t_joints = t_joint_count(solid_, way.complex, options_.cut.sides);
    way.report.further_cuts = cells.further_cuts;
    way.complex = std::move(cells.complex);
    finish(std::move(way));
  }

  void finish(Decomposition way) {
    way.complex = hexahedral(solid_, std::move(way.complex), options_.cut.tolerance * solid_.size());
    way.report.hexahedra = static_cast<int>(way.complex.cells.size());
    best_ = std::move(way);
  }

  /// Around a point in every cell, which needs plane sides.
  void by_tetrahedra() {
    Decomposition& way = complete_.front();
    if (!is_polyhedral(solid_, way.complex)) throw Error(ErrorCode::unsupported, failure_);
    way.report.further_cuts = 0;
    way.report.t_joints = t_joint_count(solid_, way.complex, options_.cut.sides);
    way.report.by_tetrahedra = true;
    way.complex = star_cells(solid_, std::move(way.complex));
    finish(std::move(way));
  }

  const geometry::Brep& solid_;
  const DecompositionOptions& options_;
  const Progress& progress_;
  Stopwatch watch_;
  CellStore store_;
  geometry::CellComplex prepared_;
  SearchCell whole_;
  int evaluations_ = 0;
  std::optional<CutTree> unfinished_;
  std::vector<Decomposition> complete_;  // the first way that was cut, but is not yet side to side
  std::optional<Decomposition> best_;
  std::string failure_;  // why the last way did not end
};

}  // namespace

Decomposition decompose(const geometry::Brep& solid, const std::string& name,
                        const DecompositionOptions& options, const Progress& progress) {
  validate(options);
  progress(fmt::format("cutting '{}'", name), 0);
  const auto named = [&](const Error& error) { return fmt::format("solid '{}': {}", name, error.what()); };
  try {
    return Decomposer(solid, options, progress).make();
  } catch (const geometry::SolidError& error) {
    throw geometry::SolidError(error.code(), named(error), of_solid(error.fault(), name));
  } catch (const Error& error) {
    throw Error(error.code(), named(error));
  }
}

}  // namespace isopatch::segmentation

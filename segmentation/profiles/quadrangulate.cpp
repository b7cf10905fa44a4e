#include "segmentation/profiles/quadrangulate.hpp"

#include <map>

#include "segmentation/profiles/division_error.hpp"
#include "segmentation/profiles/internal/best_mesh.hpp"
#include "segmentation/profiles/internal/candidates.hpp"
#include "segmentation/profiles/internal/search.hpp"
#include "segmentation/profiles/internal/shared_cuts.hpp"
#include "segmentation/profiles/internal/standard_position.hpp"
#include "segmentation/profiles/internal/start.hpp"

namespace isopatch::segmentation {

namespace {

/// A side as an edge run in its curve's direction. Its parameters are those of the nodes, so that pieces join
/// exactly.
QuadEdge edge_of(const planar::CellMesh& mesh, const std::vector<planar::Curve>& curves, int from, int to,
                 int curve) {
  QuadEdge result{from, to, curve};
  if (curve < 0) return result;
  if (mesh.nodes[from].is_cut()) result.low = mesh.nodes[from].at;
  if (mesh.nodes[to].is_cut()) result.high = mesh.nodes[to].at;
  if (curves[curve].closed() && result.high <= result.low) result.high += 1;
  return result;
}

/// The mesh as quadrilaterals with shared edges; nodes that none uses are left out.
Quadrangulation result_of(const std::vector<planar::Curve>& curves, const planar::CellMesh& mesh) {
  Quadrangulation result;
  std::vector<int> numbers(mesh.nodes.size(), -1);
  const auto enter = [&](int node) {
    if (numbers[node] < 0) {
      numbers[node] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(mesh.nodes[node].point);
    }
    return numbers[node];
  };
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (mesh.nodes[n].given) enter(static_cast<int>(n));
  std::map<planar::SideKey, int> edges;
  for (const planar::Cell& cell : mesh.cells) {
    Quad quad;
    quad.region = cell.region;
    for (int k = 0; k < 4; ++k) {
      const planar::Side& side = cell.sides[k];
      const bool reversed = side.curve >= 0 ? side.reversed : side.from > side.to;
      const planar::SideKey key = reversed ? planar::key_across(side) : planar::key_of(side);
      const auto [entry, is_new] = edges.try_emplace(key, static_cast<int>(result.edges.size()));
      if (is_new) {
        QuadEdge edge =
            edge_of(mesh, curves, reversed ? side.to : side.from, reversed ? side.from : side.to, side.curve);
        edge.start = enter(edge.start);
        edge.end = enter(edge.end);
        result.edges.push_back(edge);
      }
      quad.sides[static_cast<std::size_t>(k)] = {EdgeId(entry->second), reversed};
    }
    result.quads.push_back(quad);
  }
  return result;
}

/// To where the profile is.
planar::CellMesh moved_back(planar::CellMesh mesh, const planar::StandardPosition& standard,
                            const Profile& profile, const std::vector<planar::Curve>& curves) {
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    planar::Node& node = mesh.nodes[n];
    if (node.given)
      node.point = profile.vertices[n];
    else
      node.point =
          node.is_cut() ? curves[node.curve].at(node.at) : standard.centre + standard.axes * node.point;
  }
  return mesh;
}

}  // namespace

/// Refers to itself, so it stays where it is.
struct DraftedQuadrangulation::Parts {
  Parts(const Profile& given, const QuadrangulationOptions& with)
      : profile(given),
        options(with),
        standard(planar::standard_position(profile)),
        curves(planar::curves_of(standard.profile)),
        input{planar::ShapeRules(options), curves, planar::shared_edges(profile),
              planar::candidates_of(standard.profile, curves), options.thorough},
        draft(planar::drafted_mesh(input, standard.profile, options)) {}

  Profile profile;
  QuadrangulationOptions options;
  planar::StandardPosition standard;
  std::vector<planar::Curve> curves;
  planar::SearchInput input;
  planar::DraftedMesh draft;
};

DraftedQuadrangulation::DraftedQuadrangulation(const Profile& profile,
                                               const QuadrangulationOptions& options) {
  validate(profile);
  validate(options);
  parts_ = std::make_unique<Parts>(profile, options);
}
DraftedQuadrangulation::DraftedQuadrangulation(DraftedQuadrangulation&&) noexcept = default;
DraftedQuadrangulation& DraftedQuadrangulation::operator=(DraftedQuadrangulation&&) noexcept = default;
DraftedQuadrangulation::~DraftedQuadrangulation() = default;

double DraftedQuadrangulation::cost() const {
  if (!parts_->draft.is_valid) return planar::refused;
  return parts_->draft.cost;
}

Quadrangulation DraftedQuadrangulation::finished() const {
  planar::CellMesh best;
  try {
    best = planar::finished_mesh(parts_->input, parts_->draft, parts_->options);
  } catch (const DivisionError& error) {
    throw DivisionError(error.region(), parts_->standard.centre + parts_->standard.axes * error.place());
  }
  const std::vector<planar::Curve> curves_there = planar::curves_of(parts_->profile);
  return result_of(curves_there, moved_back(best, parts_->standard, parts_->profile, curves_there));
}

Quadrangulation quadrangulate(const Profile& profile, const QuadrangulationOptions& options) {
  return DraftedQuadrangulation(profile, options).finished();
}

}  // namespace isopatch::segmentation

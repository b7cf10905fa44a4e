#include "segmentation/parameterization/parameterize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/scaled_jacobian.hpp"
#include "segmentation/parameterization/internal/complex_fit.hpp"
#include "segmentation/parameterization/internal/edge_pace.hpp"
#include "segmentation/parameterization/internal/hex_complex.hpp"
#include "segmentation/parameterization/internal/improve_blocks.hpp"
#include "segmentation/parameterization/internal/model_complex.hpp"
#include "segmentation/parameterization/internal/paper_method.hpp"
#include "segmentation/parameterization/internal/patch_set.hpp"
#include "segmentation/parameterization/internal/start_knots.hpp"

namespace isopatch::segmentation {
namespace {

void refuse_t_joints(const HexModel& model) {
  if (model.topology.t_joints.empty()) return;
  geometry::SolidFault fault;
  std::size_t contacts = 0;
  const auto add = [&](BlockSide side, const std::string& remark) {
    fault.faces.push_back({model.face(side).face.value, model.name(side.block), remark});
  };
  for (const geometry::TJoint& joint : model.topology.t_joints) {
    add(joint.whole, "");
    for (const geometry::SidePart& part : joint.parts)
      add(part.side, "part of " + label_of(model, joint.whole));
    contacts += joint.parts.size();
  }
  const geometry::TJoint& first = model.topology.t_joints.front();
  throw geometry::SolidError(
      ErrorCode::unsupported,
      fmt::format("face {} is only a part of face {} ({} such contacts): patches meet in whole faces; divide "
                  "the larger block so that its faces match",
                  label_of(model, first.parts.front().side), label_of(model, first.whole), contacts),
      std::move(fault));
}

bool is_good_enough(const PatchValidity& validity, double wanted_quality) {
  return validity.certificate.accepted() && validity.quality.min_scaled_jacobian >= wanted_quality;
}

/// Nothing where weights come out too small.
std::optional<BlockPatches> first_patches(const HexComplex& complex, const ComplexFit& fit) {
  BlockPatches blocks;
  for (int b = 0; b < static_cast<int>(complex.blocks.size()); ++b) {
    const RationalNet net = block_net(complex, fit, BlockId(b));
    if (!has_fair_weights(net)) return std::nullopt;
    blocks.patches.emplace_back(block_knots(complex, fit, BlockId(b)), net.points, net.weights);
    blocks.validities.push_back(validity(blocks.patches.back()));
  }
  return blocks;
}

std::vector<BlockId> poor_blocks(const BlockPatches& blocks, double wanted_quality) {
  std::vector<BlockId> result;
  for (std::size_t b = 0; b < blocks.validities.size(); ++b)
    if (!is_good_enough(blocks.validities[b], wanted_quality) && !blocks.validities[b].folded_edge)
      result.emplace_back(static_cast<int>(b));
  return result;
}

void improve(HexComplex& complex, ComplexFit& fit, BlockPatches& blocks,
             const ParameterizationOptions& options, const Progress& progress) {
  std::vector<BlockId> bad = poor_blocks(blocks, options.wanted_quality);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    progress("optimizing patches", double(i) / double(bad.size()));
    const auto b = static_cast<std::size_t>(bad[i].value);
    ImprovedPatch improved =
        improve_interior(blocks.patches[b], options.wanted_quality, options.optimization);
    blocks.evaluations += improved.evaluations;
    blocks.patches[b] = std::move(improved.patch);
    blocks.validities[b] = improved.validity;
  }
  constexpr int most_slides = 3;
  for (int slide = 0; slide < most_slides; ++slide) {
    // Faces only slide where the insides alone are far from good.
    bad = poor_blocks(blocks, options.wanted_quality / 2);
    if (bad.empty()) return;
    progress("sliding faces", double(slide) / most_slides);
    if (!slide_faces(complex, fit, blocks, bad, options.wanted_quality, options.optimization)) return;
  }
}

std::array<int, 10> histogram(const geometry::NurbsVolume& patch) {
  std::array<int, 10> counts{};
  std::array<std::vector<double>, 3> nodes;
  for (int d = 0; d < 3; ++d) {
    const geometry::QuadratureRule rule = geometry::gauss_legendre(patch.degree(d) + 1);
    const std::vector<double> breaks = patch.knots(d).breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (const double x : rule.nodes)
        nodes[static_cast<std::size_t>(d)].push_back(breaks[e] + x * (breaks[e + 1] - breaks[e]));
  }
  for (const double w : nodes[2])
    for (const double v : nodes[1])
      for (const double u : nodes[0]) {
        const double scaled = geometry::scaled_jacobian(patch.jacobian({u, v, w}));
        ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(10 * scaled)), 0, 9))];
      }
  return counts;
}

PatchReport report_of(const std::string& name, const geometry::NurbsVolume& patch,
                      const PatchValidity& validity) {
  PatchReport report;
  report.name = name;
  report.certificate = validity.certificate;
  report.quality = validity.quality;
  report.folded_edge = validity.folded_edge;
  report.histogram = histogram(patch);
  report.volume = geometry::volume(patch);
  report.control_points = patch.size();
  return report;
}

std::string names_of(const HexModel& model, const HexFace& face) {
  std::string name = label_of(model, face.uses[0].side);
  if (face.uses.size() > 1) name += " = " + label_of(model, face.uses[1].side);
  return name;
}

std::string edge_label(const HexComplex& complex, std::size_t edge) {
  const auto place = [&](geometry::HexVertexId id) {
    const Eigen::Vector3d p = complex.vertex(id);
    return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0], p[1], p[2]);
  };
  const HexEdge& found = complex.topology.edges[edge];
  return fmt::format("{}, edge from {} to {}", complex.block(found.uses[0].edge.block).name,
                     place(found.vertices[0]), place(found.vertices[1]));
}

/// A complex that has been fitted.
struct FittedComplex {
  HexComplex complex;
  ComplexFit fit;
};

FittedComplex fitted_complex(HexComplex complex, const FitOptions& options) {
  ComplexFit found = fit(complex, options);
  return {std::move(complex), std::move(found)};
}

/// A complex that has been fitted, with the patches of its blocks.
struct FittedBlocks {
  FittedComplex fitted;
  BlockPatches blocks;
};

/// Nothing where weights come out too small, which without arcs they never do.
std::optional<FittedBlocks> fitted_blocks(FittedComplex fitted) {
  if (!fitted.fit.has_fair_weights) return std::nullopt;
  std::optional<BlockPatches> blocks = first_patches(fitted.complex, fitted.fit);
  if (!blocks) return std::nullopt;
  return FittedBlocks{std::move(fitted), std::move(*blocks)};
}

std::size_t poor_count(const BlockPatches& blocks, double wanted_quality) {
  return static_cast<std::size_t>(std::count_if(
      blocks.validities.begin(), blocks.validities.end(),
      [&](const PatchValidity& validity) { return !is_good_enough(validity, wanted_quality); }));
}

/// The input's splines may come to so many spans along a sheet ...
constexpr int few_spans = 4;
/// ... or so many for each that the tolerance needs: they are exact, which is worth something.
constexpr double worth_of_splines = 1.5;

/// Spans may be so short beside the shortest that the tolerance needs: shorter ones make needles.
constexpr double shortest_beside_needed = 0.25;

bool is_short(const KnotVector& knots) {
  return knots.element_count() <= few_spans;
}

double shortest_span(const KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  double result = knots.length();
  for (std::size_t i = 1; i < breaks.size(); ++i) result = std::min(result, breaks[i] - breaks[i - 1]);
  return result;
}

bool is_worth_it(const KnotVector& own, const KnotVector& needed) {
  return own.element_count() <= worth_of_splines * needed.element_count() &&
         shortest_span(own) >= shortest_beside_needed * shortest_span(needed);
}

/// Those of the `kept` sheets whose knots are worth it.
std::vector<bool> worthy(std::vector<bool> kept, const std::vector<KnotVector>& own,
                         const std::vector<KnotVector>& needed) {
  for (std::size_t k = 0; k < kept.size(); ++k)
    kept[k] = kept[k] && (is_short(own[k]) || is_worth_it(own[k], needed[k]));
  return kept;
}

/// Fitted, without the input's splines along sheets where they bring more spans than they are worth: many
/// edges with knots of their own meet there, or they are finer than the tolerance, or what else runs through
/// the sheet has their spans halved where it would have needed others.
FittedComplex lean_fit(const HexComplex& complex, const FitOptions& options) {
  const std::vector<KnotVector> own = start_knots(complex, options.degree, options.start_spans);
  if (!has_paces(complex) || std::all_of(own.begin(), own.end(), is_short))
    return fitted_complex(complex, options);
  const std::vector<KnotVector> needed = fit(without_paces(complex), options).sheets;
  std::vector<bool> kept = worthy(std::vector<bool>(own.size(), true), own, needed);
  for (;;) {
    FittedComplex result = fitted_complex(with_splines_of(complex, kept), options);
    const std::vector<bool> fewer = worthy(kept, result.fit.sheets, needed);
    if (fewer == kept) return result;
    kept = fewer;
  }
}

/// Keeps the input's paces, and with them its splines and arcs, unless arc length leaves fewer poor blocks.
FittedBlocks first_fit(const HexComplex& complex, const ParameterizationOptions& options) {
  std::optional<FittedBlocks> result = fitted_blocks(lean_fit(complex, options.fit));
  const auto by_arc_length = [&] {
    return fitted_blocks(fitted_complex(without_paces(complex), options.fit)).value();
  };
  if (!result) return by_arc_length();
  const std::size_t poor = poor_count(result->blocks, options.wanted_quality);
  if (poor == 0 || !has_paces(result->fitted.complex)) return std::move(*result);
  FittedBlocks other = by_arc_length();
  return poor_count(other.blocks, options.wanted_quality) < poor ? std::move(other) : std::move(*result);
}

Parameterization shared_method(const HexModel& model, const HexComplex& given,
                               const ParameterizationOptions& options, const Progress& progress) {
  progress("fitting edges and faces", 0);
  auto [found, blocks] = first_fit(given, options);
  auto& [complex, fitted] = found;
  const BlockPatches first = blocks;
  if (options.optimize) improve(complex, fitted, blocks, options, progress);
  Parameterization result;
  ParameterizationReport& report = result.report;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b) {
    report.patches.push_back(report_of(complex.blocks[b].name, blocks.patches[b], blocks.validities[b]));
    report.patches.back().certified_before = first.validities[b].certificate.accepted();
    report.patches.back().moved = blocks.patches[b] != first.patches[b];
  }
  for (std::size_t f = 0; f < model.topology.faces.size(); ++f) {
    const HexFace& face = model.topology.faces[f];
    report.faces.push_back({names_of(model, face), complex.map(face).kind(), fitted.face_deviation[f],
                            face.gap, face.uses, fitted.face_deviations[f], fitted.off_edges[f]});
  }
  const auto widest = std::max_element(fitted.edge_gap.begin(), fitted.edge_gap.end());
  report.largest_gap = *widest;
  report.gap_at = edge_label(complex, static_cast<std::size_t>(widest - fitted.edge_gap.begin()));
  report.rounds = fitted.rounds;
  report.max_spans = *std::max_element(fitted.most_spans.begin(), fitted.most_spans.end());
  report.evaluations = blocks.evaluations;
  result.patches = patch_set(model, std::move(blocks.patches));
  return result;
}

Parameterization paper_method(const HexModel& model, const HexComplex& complex) {
  PaperPatches found = paper_patches(complex);
  Parameterization result;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b) {
    const geometry::NurbsVolume& patch = found.patches[b];
    result.report.patches.push_back(report_of(complex.blocks[b].name, patch, validity(patch)));
    result.report.patches.back().certified_before = result.report.patches.back().certificate.accepted();
  }
  for (std::size_t f = 0; f < model.topology.faces.size(); ++f) {
    const HexFace& face = model.topology.faces[f];
    const DeviationGrid& deviations = found.face_deviations[f];
    result.report.faces.push_back({names_of(model, face), FaceMapKind::coons, deviations.values.maxCoeff(),
                                   face.gap, face.uses, deviations});
  }
  result.patches = patch_set(model, std::move(found.patches));
  return result;
}

}  // namespace

const char* name(ParameterizationMethod method) {
  return method == ParameterizationMethod::paper ? "paper" : "shared";
}

void validate(const ParameterizationOptions& options) {
  validate(options.fit);
  if (!(options.wanted_quality >= 0 && options.wanted_quality < 1))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("wanted_quality is {}; its range is [0, 1)", options.wanted_quality));
}

Parameterization parameterize(const HexModel& model, const ParameterizationOptions& options,
                              const Progress& progress) {
  validate(options);
  validate(model);
  if (!options.keep_t_joints) refuse_t_joints(model);
  const Stopwatch watch;
  const HexComplex complex = model_complex(model);
  Parameterization result = options.method == ParameterizationMethod::paper
                                ? paper_method(model, complex)
                                : shared_method(model, complex, options, progress);
  result.report.size = complex.size;
  result.report.tolerance = options.fit.tolerance * complex.size;
  result.report.names = options.names;
  result.report.seconds = watch.seconds();
  return result;
}

}  // namespace isopatch::segmentation

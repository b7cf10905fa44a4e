#include "segmentation/parameterization/parameterize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "geometry/brep/solid_error.hpp"
#include "geometry/quadrature.hpp"
#include "segmentation/parameterization/edge_pace.hpp"
#include "segmentation/parameterization/improve_blocks.hpp"
#include "segmentation/parameterization/paper_method.hpp"

namespace isopatch::segmentation {
namespace {

using Clock = std::chrono::steady_clock;

void refuse_partial_contacts(const HexComplex& complex) {
  if (complex.partial_contacts.empty()) return;
  const PartialContact& found = complex.partial_contacts.front();
  geometry::SolidFault fault;
  for (const PartialContact& contact : complex.partial_contacts)
    for (const BlockSide side : {contact.part, contact.whole}) {
      const Hexahedron& block = complex.blocks[static_cast<std::size_t>(side.block)];
      fault.faces.push_back({block.face(side.side).number, block.name,
                             side == contact.part ? "part of " + complex.label(contact.whole) : ""});
    }
  throw geometry::SolidError(
      ErrorCode::unsupported,
      fmt::format("face {} is only a part of face {} ({} such contacts): patches meet in whole faces; divide "
                  "the larger block so that its faces match",
                  complex.label(found.part), complex.label(found.whole), complex.partial_contacts.size()),
      std::move(fault));
}

bool healthy(const Health& health, double wanted_quality) {
  return health.certificate.accepted() && health.quality.min_scaled_jacobian >= wanted_quality;
}

BlockNets first_nets(const HexComplex& complex, const ComplexFit& fit) {
  BlockNets blocks;
  for (int b = 0; b < static_cast<int>(complex.blocks.size()); ++b) {
    blocks.nets.push_back(block_net(complex, fit, b));
    blocks.healths.push_back(health(block_knots(complex, fit, b), blocks.nets.back()));
  }
  return blocks;
}

std::vector<int> unhealthy(const BlockNets& blocks, double wanted_quality) {
  std::vector<int> result;
  for (std::size_t b = 0; b < blocks.healths.size(); ++b)
    if (!healthy(blocks.healths[b], wanted_quality) && !blocks.healths[b].hopeless)
      result.push_back(static_cast<int>(b));
  return result;
}

void improve(HexComplex& complex, ComplexFit& fit, BlockNets& blocks, const ParameterizationOptions& options,
             const Progress& progress) {
  std::vector<int> bad = unhealthy(blocks, options.wanted_quality);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    progress("optimizing patches", double(i) / double(bad.size()));
    const auto b = static_cast<std::size_t>(bad[i]);
    ImprovedNet improved = improve_interior(block_knots(complex, fit, bad[i]), blocks.nets[b],
                                            options.wanted_quality, options.optimization);
    blocks.evaluations += improved.evaluations;
    blocks.nets[b] = std::move(improved.net);
    blocks.healths[b] = improved.health;
  }
  constexpr int most_slides = 3;
  for (int slide = 0; slide < most_slides; ++slide) {
    // Faces only slide where the insides alone are far from good.
    bad = unhealthy(blocks, options.wanted_quality / 2);
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
        const Eigen::Matrix3d j = patch.jacobian({u, v, w});
        const double lengths = j.colwise().norm().prod();
        const double scaled = lengths > 0 ? j.determinant() / lengths : 0;
        ++counts[static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(10 * scaled)), 0, 9))];
      }
  return counts;
}

PatchReport report_of(const std::string& name, const geometry::NurbsVolume& patch, const Health& health) {
  PatchReport report;
  report.name = name;
  report.certificate = health.certificate;
  report.quality = health.quality;
  report.hopeless = health.hopeless;
  report.histogram = histogram(patch);
  report.volume = geometry::volume(patch);
  report.control_points = patch.size();
  return report;
}

std::string names_of(const HexComplex& complex, const ComplexFace& face) {
  std::string name = complex.label(face.uses[0].side);
  if (face.uses.size() > 1) name += " = " + complex.label(face.uses[1].side);
  return name;
}

/// "#ff0000".
bool is_colour_text(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

/// Outer faces under the names of the solids' faces, with the block's in front where there are several, or
/// "face:" in front of names that are those of colours; then under their colours.
std::vector<geometry::Boundary> boundaries(const HexComplex& complex) {
  std::vector<geometry::Boundary> result;
  const auto add = [&](const std::string& name, const geometry::PatchFace& face) {
    auto found = std::find_if(result.begin(), result.end(),
                              [&](const auto& boundary) { return boundary.name == name; });
    if (found == result.end()) found = result.insert(result.end(), {name, {}});
    found->faces.push_back(face);
  };
  const auto each_outer = [&](const auto& visit) {
    for (const ComplexFace& face : complex.faces) {
      if (face.uses.size() > 1) continue;
      const BlockSide side = face.uses[0].side;
      visit(side, complex.blocks[static_cast<std::size_t>(side.block)].face(side.side));
    }
  };
  each_outer([&](const BlockSide& side, const QuadFace& face) {
    const std::string name = complex.blocks.size() > 1 ? complex.label(side) : face.name;
    add(is_colour_text(name) ? "face:" + name : name, {PatchId(side.block), side.side});
  });
  each_outer([&](const BlockSide& side, const QuadFace& face) {
    if (!face.colour.empty()) add(face.colour, {PatchId(side.block), side.side});
  });
  return result;
}

geometry::PatchSet patch_set(const HexComplex& complex, std::vector<geometry::NurbsVolume> patches) {
  geometry::PatchSet set;
  set.patches = std::move(patches);
  set.boundaries = boundaries(complex);
  for (const Hexahedron& block : complex.blocks) set.names.push_back(block.name);
  for (const ComplexFace& face : complex.faces)
    if (face.uses.size() > 1)
      set.listed_interfaces.emplace_back(
          geometry::PatchFace{PatchId(face.uses[0].side.block), face.uses[0].side.side},
          geometry::PatchFace{PatchId(face.uses[1].side.block), face.uses[1].side.side});
  return set;
}

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", p[0], p[1], p[2]);
}

std::string complaint(const PatchReport& patch) {
  const std::string what = fmt::format(
      "patch '{}' is {}: det J is {:.3g} at parameter {}, point {}", patch.name,
      patch.certificate.sign == geometry::JacobianSign::negative ? "folded" : "not certified",
      patch.certificate.smallest, place(patch.certificate.parameter), place(patch.certificate.place));
  if (!patch.hopeless) return what + "; optimization found no better map: divide the block";
  return fmt::format(
      "{}; its faces meet at 180 degrees or more on the edge at {}, where no regular patch has an edge: "
      "divide the block there",
      what, place(patch.hopeless->place));
}

/// The least number with two digits that is not below x.
double rounded_up(double x) {
  const double step = std::pow(10, std::floor(std::log10(x)) - 1);
  return std::ceil(x / step) * step;
}

std::string complaint(const FaceReport& face, const ParameterizationReport& report) {
  if (face.off_edges > report.tolerance)
    return fmt::format(
        "face {}: its surface lies {:.3g} off its own edges, more than {:.3g}, so nobody can say where the "
        "solid ends; mend the solid where it was drawn",
        face.name, face.off_edges, report.tolerance);
  const std::string what = fmt::format("face {} deviates by {:.3g} from its surface, more than {:.3g}",
                                       face.name, face.deviation, report.tolerance);
  if (face.gap > report.tolerance)
    return fmt::format("{}; its two blocks are {:.3g} apart there", what, face.gap);
  const double enough = rounded_up(face.deviation / report.size);
  if (report.max_spans == 0)
    return fmt::format("{}; method \"shared\" keeps the tolerance, or raise {} to {:.2g}", what,
                       report.names.tolerance, enough);
  return fmt::format("{}; raise {} above {}, or {} to {:.2g}", what, report.names.max_spans, report.max_spans,
                     report.names.tolerance, enough);
}

std::string edge_label(const HexComplex& complex, std::size_t edge) {
  const ComplexEdge& found = complex.edges[edge];
  return fmt::format("{}, edge from {} to {}",
                     complex.blocks[static_cast<std::size_t>(found.uses[0].block)].name,
                     place(complex.vertices[static_cast<std::size_t>(found.vertices[0])]),
                     place(complex.vertices[static_cast<std::size_t>(found.vertices[1])]));
}

/// A complex that has been fitted, with the nets of its blocks.
struct FittedComplex {
  HexComplex complex;
  ComplexFit fit;
  BlockNets blocks;
};

FittedComplex fitted_complex(HexComplex complex, const FitOptions& options) {
  FittedComplex result{std::move(complex), {}, {}};
  result.fit = fit(result.complex, options);
  result.blocks = first_nets(result.complex, result.fit);
  return result;
}

std::size_t poor_blocks(const BlockNets& blocks, double wanted_quality) {
  return static_cast<std::size_t>(
      std::count_if(blocks.healths.begin(), blocks.healths.end(),
                    [&](const Health& health) { return !healthy(health, wanted_quality); }));
}

/// Keeps the input's paces, and with them its splines, unless arc length leaves fewer poor blocks.
FittedComplex first_fit(const HexComplex& complex, const ParameterizationOptions& options) {
  FittedComplex result = fitted_complex(complex, options.fit);
  const std::size_t poor = poor_blocks(result.blocks, options.wanted_quality);
  if (poor == 0 || !has_paces(complex)) return result;
  FittedComplex other = fitted_complex(without_paces(complex), options.fit);
  return poor_blocks(other.blocks, options.wanted_quality) < poor ? other : result;
}

Parameterization shared_method(const HexComplex& given, const ParameterizationOptions& options,
                               const Progress& progress) {
  progress("fitting edges and faces", 0);
  auto [complex, fitted, blocks] = first_fit(given, options);
  const BlockNets first = blocks;
  if (options.optimize) improve(complex, fitted, blocks, options, progress);
  Parameterization result;
  ParameterizationReport& report = result.report;
  std::vector<geometry::NurbsVolume> patches;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b) {
    patches.emplace_back(block_knots(complex, fitted, static_cast<int>(b)), blocks.nets[b]);
    report.patches.push_back(report_of(complex.blocks[b].name, patches.back(), blocks.healths[b]));
    report.patches.back().certified_before = first.healths[b].certificate.accepted();
    report.patches.back().moved = blocks.nets[b] != first.nets[b];
  }
  for (std::size_t f = 0; f < complex.faces.size(); ++f) {
    const ComplexFace& face = complex.faces[f];
    report.faces.push_back({names_of(complex, face), complex.map(face.uses[0].side).kind(),
                            fitted.face_deviation[f], face.gap, face.uses, fitted.face_deviations[f],
                            fitted.off_edges[f]});
  }
  const auto widest = std::max_element(fitted.edge_gap.begin(), fitted.edge_gap.end());
  report.largest_gap = *widest;
  report.gap_at = edge_label(complex, static_cast<std::size_t>(widest - fitted.edge_gap.begin()));
  report.rounds = fitted.rounds;
  report.max_spans = *std::max_element(fitted.most_spans.begin(), fitted.most_spans.end());
  report.evaluations = blocks.evaluations;
  result.patches = patch_set(complex, std::move(patches));
  return result;
}

Parameterization paper_method(const HexComplex& complex) {
  PaperPatches found = paper_patches(complex);
  Parameterization result;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b) {
    const geometry::NurbsVolume& patch = found.patches[b];
    result.report.patches.push_back(
        report_of(complex.blocks[b].name, patch, health(patch.knots(), patch.control_points())));
    result.report.patches.back().certified_before = result.report.patches.back().certificate.accepted();
  }
  for (std::size_t f = 0; f < complex.faces.size(); ++f) {
    const ComplexFace& face = complex.faces[f];
    const DeviationGrid& deviations = found.face_deviations[f];
    result.report.faces.push_back({names_of(complex, face), FaceMapKind::coons, deviations.values.maxCoeff(),
                                   face.gap, face.uses, deviations});
  }
  result.patches = patch_set(complex, std::move(found.patches));
  return result;
}

}  // namespace

void validate(const ParameterizationOptions& options) {
  validate(options.fit);
  if (!(options.wanted_quality >= 0 && options.wanted_quality < 1))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("wanted_quality is {}; its range is [0, 1)", options.wanted_quality));
}

bool ParameterizationReport::certified() const {
  return std::all_of(patches.begin(), patches.end(),
                     [](const PatchReport& patch) { return patch.certificate.accepted(); });
}

const FaceReport& ParameterizationReport::worst_face() const {
  return *std::max_element(faces.begin(), faces.end(), [](const FaceReport& a, const FaceReport& b) {
    return a.deviation < b.deviation;
  });
}

bool ParameterizationReport::usable() const {
  return certified() && worst_face().deviation <= tolerance;
}

std::vector<std::string> ParameterizationReport::complaints() const {
  std::vector<std::string> result = warnings;
  for (const PatchReport& patch : patches)
    if (!patch.certificate.accepted()) result.push_back(complaint(patch));
  for (const FaceReport& face : faces)
    if (face.deviation > tolerance) result.push_back(complaint(face, *this));
  return result;
}

Parameterization parameterize(const HexComplex& complex, const ParameterizationOptions& options,
                              const Progress& progress) {
  validate(options);
  refuse_partial_contacts(complex);
  const auto start = Clock::now();
  Parameterization result = options.method == ParameterizationMethod::paper
                                ? paper_method(complex)
                                : shared_method(complex, options, progress);
  result.report.size = complex.size;
  result.report.tolerance = options.fit.tolerance * complex.size;
  result.report.names = options.names;
  result.report.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace isopatch::segmentation

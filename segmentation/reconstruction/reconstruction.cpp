#include "segmentation/reconstruction/reconstruction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/processor_stopwatch.hpp"
#include "geometry/brep/contradictions.hpp"
#include "geometry/brep/solid_on_carriers.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "segmentation/reconstruction/internal/angle_regions.hpp"
#include "segmentation/reconstruction/internal/bent_borders.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/carrier_regions.hpp"
#include "segmentation/reconstruction/internal/chance_planes.hpp"
#include "segmentation/reconstruction/internal/dented_planes.hpp"
#include "segmentation/reconstruction/internal/facets.hpp"
#include "segmentation/reconstruction/internal/nearest_on_spline.hpp"
#include "segmentation/reconstruction/internal/regularise.hpp"
#include "segmentation/reconstruction/internal/solid_of_regions.hpp"
#include "segmentation/reconstruction/internal/split_bands.hpp"
#include "segmentation/reconstruction/internal/without_rounds.hpp"

namespace isopatch::segmentation {
namespace {

// Steps of the file's coordinates by which rounded vertices are off their surface at most: half a step in
// each direction, of the point and of those that the surface was fitted to.
constexpr double steps_of_rounding = 4;
// Vertices of a plane face of a CAD file are nearer to it than those of curved faces.
constexpr double plane_share = 0.2;
// What is a flaw of a plane, and no strip of a curved face, may be farther from it.
constexpr double dent_share = 3;
// Edges of freeform faces are as near to the vertices, as a share of the size.
constexpr double freeform_share = 1e-5;
// What lies between triangles and surfaces is known to this share of it from their distances at the middles
// of the triangles' sides: freeform surfaces bend otherwise between them, by a fifth on 450 triangles of a
// mushroom.
constexpr double share_of_carriers = 0.05, share_of_freeform = 0.25;
// What is farther off its surface than this share of the size lies on another one.
constexpr double loosest = 1e-3;
// Of the tolerance, beside freeform faces.
constexpr double freeform_looseness = 3;

class OutOfTime : public Error {
 public:
  using Error::Error;
};

double tolerance_of(const geometry::TriangleMesh& mesh, const ReconstructionOptions& options,
                    double share = 1) {
  return std::max(share * options.tolerance * geometry::diagonal(mesh), steps_of_rounding * mesh.grain);
}

Regions by_area(Regions regions) {
  std::vector<std::size_t> order(regions.regions.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return regions.regions[a].area > regions.regions[b].area;
  });
  Regions result;
  result.of_triangle.resize(regions.of_triangle.size());
  for (const std::size_t r : order) {
    for (const int t : regions.regions[r].triangles)
      result.of_triangle[static_cast<std::size_t>(t)] = static_cast<int>(result.regions.size());
    result.regions.push_back(std::move(regions.regions[r]));
  }
  return result;
}

Regions regions_of(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                   const ReconstructionOptions& options, const Progress& progress) {
  if (options.method == RegionMethod::angles)
    return by_area(angle_regions(mesh, neighbours, tolerance_of(mesh, options), options));
  progress("joining triangles to planes", 0);
  const Facets facets = without_dents(
      mesh, neighbours, plane_facets(mesh, neighbours, tolerance_of(mesh, options, plane_share)),
      dent_share * tolerance_of(mesh, options));
  const double tolerance = tolerance_of(mesh, options);
  Regions regions =
      without_chance_planes(mesh, neighbours, carrier_regions(mesh, facets, tolerance, options, progress),
                            options.smooth, tolerance);
  return by_area(without_bent_borders(mesh, neighbours, std::move(regions), options.smooth));
}

/// Signed distances from a region's surface.
std::function<double(const Eigen::Vector3d&)> distances(const Region& region) {
  if (!region.spline)
    return [&](const Eigen::Vector3d& p) { return carrier_distance(*region.carrier, p).value; };
  return [nearest = NearestOnSpline(*region.spline)](const Eigen::Vector3d& p) {
    return nearest.distance(p).value;
  };
}

void measure_deviation(const geometry::TriangleMesh& mesh, Regions& regions, ReconstructionReport& report) {
  double squares = 0, count = 0, between = 0;
  for (Region& region : regions.regions) {
    const auto distance = distances(region);
    region.deviation = 0;
    for (const int t : region.triangles) {
      double sum = 0;
      std::array<Eigen::Vector3d, 3> p;
      for (int i = 0; i < 3; ++i) p[static_cast<std::size_t>(i)] = mesh.vertices.col(mesh.triangles(i, t));
      for (std::size_t i = 0; i < 3; ++i) {
        const double off = distance(p[i]);
        region.deviation = std::fmax(region.deviation, std::abs(off));
        report.largest_deviation = std::fmax(report.largest_deviation, std::abs(off));
        squares += off * off;
        ++count;
        sum += distance((p[i] + p[(i + 1) % 3]) / 2) / 3;
      }
      const double area = geometry::area_vector(mesh, t).norm() / 2;
      between += (region.reversed ? sum : -sum) * area;
    }
  }
  report.mean_deviation = std::sqrt(squares / count);
  report.mesh_volume = geometry::volume(mesh);
  report.expected_volume = report.mesh_volume + between;
}

/// The solid has the volume that the triangles and their distances from the surfaces say.
void require_volume(const ReconstructionReport& report, bool freeform, double area) {
  const double allowed = (freeform ? share_of_freeform : share_of_carriers) *
                             std::abs(report.expected_volume - report.mesh_volume) +
                         1e-5 * report.mesh_volume + report.mean_deviation * area;
  if (std::abs(report.volume - report.expected_volume) <= allowed) return;
  throw Error(
      ErrorCode::unsupported,
      fmt::format(
          "the surfaces bound another solid than the triangles: {:.6g} m^3 where {:.6g} m^3 were expected",
          report.volume, report.expected_volume));
}

/// The solid of regions without freeform rounds, as the report says.
/// @param report  what is known of it so far
Reconstruction bounded_by(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                          Regions regions, ReconstructionReport report, const Progress& progress) {
  regions = by_area(split_bands(mesh, neighbours, std::move(regions)));
  progress("bounding the faces", 0);
  const geometry::CarrierSolid solid =
      solid_of_regions(mesh, neighbours, regions,
                       std::max(report.tolerance, freeform_share * geometry::diagonal(mesh)), progress);
  measure_deviation(mesh, regions, report);
  const geometry::Brep brep = geometry::make_brep(solid, 3 * report.tolerance);
  progress("checking the solid", 0);
  geometry::require_sound(brep);
  report.volume = brep.volume();
  const bool freeform = std::any_of(regions.regions.begin(), regions.regions.end(),
                                    [](const Region& region) { return region.spline.has_value(); });
  require_volume(report, freeform, geometry::area(mesh));
  return {brep, mesh, std::move(regions), std::move(report)};
}

std::string text_of(const WithoutRounds& sharp, double volume) {
  return fmt::format("{} round{} along freeform walls removed, volume {:+.2g} %", sharp.removed,
                     sharp.removed == 1 ? "" : "s", 100 * sharp.volume_change / volume);
}

/// The solid of regions.
Reconstruction bounded(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                       Regions regions, const ReconstructionOptions& options, const Progress& progress) {
  ReconstructionReport report;
  report.tolerance = tolerance_of(mesh, options);
  report.regularity = regularise(mesh, regions, report.tolerance);
  if (!options.remove_blends) return bounded_by(mesh, neighbours, std::move(regions), report, progress);
  WithoutRounds sharp = without_rounds(mesh, neighbours, regions);
  report.remarks = sharp.kept;
  if (sharp.removed > 0) report.remarks.push_back(text_of(sharp, geometry::volume(mesh)));
  return bounded_by(sharp.mesh, geometry::neighbours(sharp.mesh), std::move(sharp.regions), report, progress);
}

bool is_freeform(const Regions& regions) {
  return std::any_of(regions.regions.begin(), regions.regions.end(),
                     [](const Region& region) { return !region.carrier; });
}

/// A progress that ends what reports to it when its time is up.
Progress limited(const Progress& progress, const ProcessorStopwatch& watch, double time_limit) {
  return {[&progress, &watch, time_limit](std::string_view phase, double share) {
    if (watch.seconds() > time_limit)
      throw OutOfTime(
          ErrorCode::unsupported,
          fmt::format("no solid was made of the triangles in {:.3g} s, which ended while {}; raise "
                      "time_limit, or give it fewer triangles",
                      time_limit, phase));
    progress(phase, share);
  }};
}

std::string looseness(const Reconstruction& made, const ReconstructionOptions& options) {
  return fmt::format(
      "vertices are up to {:.2g} m off the surfaces that they belong to, {:.1g} of the size; "
      "surfaces were taken for what they are "
      "within {:.1g} of it",
      made.report.largest_deviation, made.report.largest_deviation / geometry::diagonal(made.mesh),
      options.tolerance);
}

/// Some programs put vertices on edges that are only near their surfaces: the solid of the fewest faces that
/// looser tolerances give, if they leave no freeform face and no more faces than the strict one.
std::optional<Reconstruction> loosely(const geometry::TriangleMesh& mesh,
                                      const geometry::MeshNeighbours& neighbours, const Regions& strict,
                                      const ReconstructionOptions& options, const Progress& progress) {
  std::optional<Reconstruction> best;
  for (const double factor : {10.0, 100.0, 500.0}) {
    ReconstructionOptions looser = options;
    looser.tolerance = factor * options.tolerance;
    if (looser.tolerance > loosest) break;
    Regions regions = regions_of(mesh, neighbours, looser, progress);
    const std::size_t most = best ? best->regions.regions.size() - 1 : strict.regions.size();
    if (is_freeform(regions) || regions.regions.size() > most) continue;
    try {
      best = bounded(mesh, neighbours, std::move(regions), looser, progress);
    } catch (const OutOfTime&) {
      throw;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      continue;
    }
    best->report.remarks.insert(best->report.remarks.begin(), looseness(*best, looser));
  }
  return best;
}

/// With freeform faces: carriers beside them may need a little more, but much more finds some amid them. The
/// fewer faces.
Reconstruction with_freeform(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                             Regions strict, const ReconstructionOptions& options, const Progress& progress) {
  ReconstructionOptions looser = options;
  looser.tolerance = std::min(loosest, freeform_looseness * options.tolerance);
  Regions fewer = regions_of(mesh, neighbours, looser, progress);
  if (fewer.regions.size() >= strict.regions.size())
    return bounded(mesh, neighbours, std::move(strict), options, progress);
  Reconstruction result = bounded(mesh, neighbours, std::move(fewer), looser, progress);
  result.report.remarks.insert(result.report.remarks.begin(), looseness(result, looser));
  return result;
}

}  // namespace

Regions find_regions(const geometry::TriangleMesh& mesh, const ReconstructionOptions& options,
                     const Progress& progress) {
  validate(options);
  return regions_of(mesh, geometry::neighbours(mesh), options, progress);
}

std::string kinds_text(const Regions& regions) {
  std::vector<std::pair<std::string, int>> counts;
  for (const Region& region : regions.regions) {
    const std::string kind = region.carrier ? geometry::name(region.carrier->kind) : "freeform surface";
    auto known = std::find_if(counts.begin(), counts.end(), [&](const auto& c) { return c.first == kind; });
    if (known == counts.end()) known = counts.insert(counts.end(), {kind, 0});
    ++known->second;
  }
  std::vector<std::string> texts;
  for (const auto& [kind, count] : counts)
    texts.push_back(fmt::format("{} {}", count, count == 1 ? kind : kind == "torus" ? "tori" : kind + "s"));
  return fmt::format("{}", fmt::join(texts, ", "));
}

Reconstruction reconstruct(const geometry::TriangleMesh& given, const ReconstructionOptions& options,
                           const Progress& reported) {
  validate(options);
  const ProcessorStopwatch watch;
  const Progress progress = limited(reported, watch, options.time_limit);
  progress("looking at the triangles", 0);
  geometry::MendedMesh mended = geometry::mended(given, given.grain);
  const geometry::MeshNeighbours neighbours = geometry::neighbours(mended.mesh);
  const Regions regions = regions_of(mended.mesh, neighbours, options, progress);
  std::optional<Reconstruction> result;
  if (is_freeform(regions) && options.method == RegionMethod::carriers) {
    result = loosely(mended.mesh, neighbours, regions, options, progress);
    if (!result) result = with_freeform(mended.mesh, neighbours, regions, options, progress);
  }
  if (!result) result = bounded(mended.mesh, neighbours, regions, options, progress);
  result->report.remarks.insert(result->report.remarks.begin(), mended.remarks.begin(), mended.remarks.end());
  result->report.seconds = watch.seconds();
  return *result;
}

}  // namespace isopatch::segmentation

#include "segmentation/reconstruction/internal/carrier_regions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/fit_carrier.hpp"
#include "segmentation/reconstruction/internal/seed_patches.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::SurfaceKind;

constexpr std::array<SurfaceKind, 4> curved_kinds{SurfaceKind::cylinder, SurfaceKind::cone,
                                                  SurfaceKind::sphere, SurfaceKind::torus};
// More points make no fit better that is exact but for round-off.
constexpr std::size_t most_points = 400;
// A fit to a few facets is less certain farther away: so much looser are facets taken before the next fit.
constexpr double loose = 20;
// A leaf of a freeform surface that some carrier happens to follow has fewer facets than this, or than this
// share of the surface around.
constexpr std::size_t least_in_freeform = 8;
constexpr double leaf_share = 0.02;
// So are some more facets of less than this share of its area: small pieces of anything curved are on a
// carrier within a tolerance that is a share of the whole size.
constexpr std::size_t few_in_freeform = 20;
constexpr double leaf_area = 0.03;
// Neighbouring surfaces that are held against one torus or sphere.
constexpr int most_joins = 3000;
// Slivers that hang together amid one carrier; more are a face of their own.
constexpr std::size_t most_slivers = 8;
// A set of small facets that no carrier explains is a freeform surface from this number on, and plane faces
// below.
constexpr std::size_t least_freeform = 12;

struct Grown {
  Carrier carrier;
  std::vector<int> facets;
  std::size_t points = 0;
};

class CarrierGrower {
 public:
  CarrierGrower(const geometry::TriangleMesh& mesh, const Facets& facets, double tolerance,
                const ReconstructionOptions& options)
      : mesh_(mesh),
        facets_(facets.facets),
        tolerance_(tolerance),
        options_(options),
        seeds_(facets_, options.smooth),
        owner_(facets_.size(), -1),
        mark_(facets_.size(), 0),
        vertex_mark_(static_cast<std::size_t>(mesh.vertices.cols()), 0) {
    for (std::size_t f = 0; f < facets_.size(); ++f)
      plane_.push_back(seeds_.is_large(static_cast<int>(f)) || facets_[f].triangles.size() > 2);
  }

  void search(const Progress& progress) {
    int failures = 0;
    const std::vector<int> order = seeds_.in_order();
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i % 256 == 0) progress("looking for surfaces", double(i) / double(order.size()));
      if (owner(order[i]) >= 0) continue;
      if (auto grown = from_seed(order[i]))
        take(std::move(*grown));
      else if (++failures >= options_.most_failures)
        break;
    }
  }

  /// Rings of a torus or sphere lie on cones: neighbours become one surface where that explains more of them.
  void join_rings(const Progress& progress) {
    int tries = 0;
    for (std::size_t r = 0; r < found_.size() && tries < most_joins; ++r) {
      if (r % 16 == 0) progress("joining surfaces", double(r) / double(found_.size()));
      for (const std::size_t other : smooth_regions(r)) {
        if (++tries > most_joins || found_[r].facets.empty()) break;
        if (auto joined = join(r, other)) {
          take(std::move(*joined));
          break;
        }
      }
    }
  }

  /// Slivers may lean anywhere: small facets amid one curved carrier that have their vertices on it are its.
  void take_slivers() {
    std::vector<bool> done(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (owner_[f] >= 0 || done[f]) continue;
      const Pocket pocket = pocket_around(static_cast<int>(f), done);
      if (pocket.owner < 0 || pocket.facets.size() > most_slivers) continue;
      Grown& grown = found_[static_cast<std::size_t>(pocket.owner)];
      if (!std::all_of(pocket.facets.begin(), pocket.facets.end(),
                       [&](int one) { return is_sliver_on(grown.carrier, one); }))
        continue;
      for (const int one : pocket.facets) owner(one) = pocket.owner;
      grown.facets.insert(grown.facets.end(), pocket.facets.begin(), pocket.facets.end());
    }
  }

  /// Carriers with few facets amid what none explains are chance.
  void drop_leaves() {
    for (bool changed = true; changed;) {
      changed = false;
      const std::vector<FreeSize> around = free_sizes();
      for (std::size_t r = 0; r < found_.size(); ++r) {
        std::size_t free = 0, smooth = 0, largest = 0;
        double area = 0, area_around = 0;
        for (const int f : found_[r].facets) {
          area += facet(f).area;
          for (const FacetLink& link : facet(f).links) {
            if (owner(link.other) == static_cast<int>(r) || !is_smooth(link)) continue;
            ++smooth;
            const FreeSize& size = around[static_cast<std::size_t>(link.other)];
            free += size.facets > 0;
            largest = std::max(largest, size.facets);
            area_around = std::max(area_around, size.area);
          }
        }
        const bool is_small = found_[r].facets.size() < few_in_freeform && area < leaf_area * area_around;
        const std::size_t least =
            std::max(least_in_freeform, static_cast<std::size_t>(leaf_share * static_cast<double>(largest)));
        if (2 * free <= smooth || largest < least_in_freeform) continue;
        if (found_[r].facets.size() >= least && !is_small) continue;
        release(r);
        changed = true;
      }
    }
  }

  /// Numbers of regions by facet: carriers, then planes and freeform surfaces.
  Regions regions(std::size_t triangles) {
    Regions result;
    result.of_triangle.assign(triangles, -1);
    for (const Grown& grown : found_)
      if (!grown.facets.empty()) add(result, grown.facets, grown.carrier);
    std::vector<bool> done(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (owner_[f] >= 0 || done[f]) continue;
      if (plane_[f]) {
        add(result, {static_cast<int>(f)}, plane_of(static_cast<int>(f)));
        continue;
      }
      const std::vector<int> together = left_around(static_cast<int>(f), done);
      if (together.size() >= least_freeform)
        add(result, together, std::nullopt);
      else
        for (const int one : together) add(result, {one}, plane_of(one));
    }
    return result;
  }

 private:
  const Facet& facet(int f) const { return facets_[static_cast<std::size_t>(f)]; }
  int& owner(int f) { return owner_[static_cast<std::size_t>(f)]; }
  bool is_smooth(const FacetLink& link) const { return link.angle < options_.smooth.radians(); }

  SurfaceSample sample(const std::vector<int>& facets) {
    SurfaceSample result;
    const std::vector<int> vertices = vertices_of(facets);
    result.points.resize(3, static_cast<Eigen::Index>(vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result.points.col(static_cast<Eigen::Index>(i)) = mesh_.vertices.col(vertices[i]);
    result.normals.resize(3, static_cast<Eigen::Index>(facets.size()));
    result.middles.resize(3, static_cast<Eigen::Index>(facets.size()));
    for (std::size_t i = 0; i < facets.size(); ++i) {
      result.normals.col(static_cast<Eigen::Index>(i)) = facet(facets[i]).normal;
      result.middles.col(static_cast<Eigen::Index>(i)) = facet(facets[i]).middle;
    }
    return result;
  }

  std::vector<int> vertices_of(const std::vector<int>& facets) {
    ++vertex_stamp_;
    std::vector<int> result;
    for (const int f : facets)
      for (const int v : facet(f).vertices) {
        int& mark = vertex_mark_[static_cast<std::size_t>(v)];
        if (mark == vertex_stamp_) continue;
        mark = vertex_stamp_;
        result.push_back(v);
      }
    return result;
  }

  std::optional<Grown> from_seed(int seed) {
    for (const std::vector<int>& patch : seeds_.patches(seed)) {
      const SurfaceSample points = sample(patch);
      if (points.points.cols() > static_cast<Eigen::Index>(4 * most_points)) continue;
      std::optional<Grown> best;
      for (const SurfaceKind kind : curved_kinds) {
        if (patch.size() == 3 && (kind == SurfaceKind::sphere || kind == SurfaceKind::torus)) continue;
        if (points.points.cols() <= freedoms(kind)) continue;
        const auto fit = fit_carrier(kind, points, tolerance_);
        if (!fit || !(fit->largest <= tolerance_)) continue;
        auto grown = grow(fit->carrier, patch);
        if (grown && kind == SurfaceKind::torus && !has_rings(*grown, grown->carrier)) grown.reset();
        if (grown && (!best || grown->points > best->points + 4)) best = std::move(grown);
        if (best && kind == SurfaceKind::cylinder) break;  // the others include it
      }
      if (best) return best;
    }
    return std::nullopt;
  }

  /// Whether a facet lies on a carrier: its vertices, where the carrier's normal is near the facet's as well
  /// (strips of a cylinder end on a sphere), and so is that in the middle.
  bool lies_on(const Carrier& carrier, int f, double tolerance, double side) const {
    const Facet& it = facet(f);
    const double at_corners = std::cos(options_.smooth.radians()),
                 inside = std::cos(options_.smooth.radians() / 2);
    for (const int v : it.vertices) {
      const CarrierDistance there = carrier_distance(carrier, mesh_.vertices.col(v));
      if (!(std::abs(there.value) <= tolerance) || !(side * there.gradient.dot(it.normal) > at_corners))
        return false;
    }
    return side * carrier_distance(carrier, it.middle).gradient.dot(it.normal) > inside;
  }

  std::optional<Grown> grow(Carrier carrier, const std::vector<int>& patch) {
    const Facet& first = facet(patch.front());
    const double side = carrier_distance(carrier, first.middle).gradient.dot(first.normal) > 0 ? 1 : -1;
    std::vector<int> region;
    std::size_t fitted = patch.size();
    for (int round = 0; round < 60; ++round) {
      // From the patch anew with a better carrier, until the region neither grows nor the carrier changes.
      region = spread(carrier, patch, side, round == 0 ? loose * tolerance_ : 3 * tolerance_, 2 * fitted + 8);
      if (region.empty()) return std::nullopt;
      const bool all = region.size() < 2 * fitted + 8;
      const auto better = refit_carrier(carrier, some_points(region));
      if (!better) return std::nullopt;
      carrier = better->carrier;
      fitted = region.size();
      if (all && round > 0) break;
    }
    region = spread(carrier, patch, side, tolerance_, facets_.size());
    Grown result{carrier, region, vertices_of(region).size()};
    return is_enough(result) ? std::optional(std::move(result)) : std::nullopt;
  }

  Eigen::Matrix3Xd some_points(const std::vector<int>& region) {
    const std::vector<int> vertices = vertices_of(region);
    const std::size_t step = 1 + vertices.size() / most_points;
    Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>((vertices.size() + step - 1) / step));
    for (std::size_t i = 0; i < vertices.size(); i += step)
      points.col(static_cast<Eigen::Index>(i / step)) = mesh_.vertices.col(vertices[i]);
    return points;
  }

  /// Facets on the carrier that are reached from the patch.
  std::vector<int> spread(const Carrier& carrier, const std::vector<int>& patch, double side,
                          double tolerance, std::size_t most) {
    ++stamp_;
    std::vector<int> region;
    const auto offer = [&](int f) {
      int& mark = mark_[static_cast<std::size_t>(f)];
      if (mark == stamp_) return;
      mark = stamp_;
      if (lies_on(carrier, f, tolerance, side)) region.push_back(f);
    };
    for (const int f : patch) offer(f);
    for (std::size_t next = 0; next < region.size() && region.size() < most; ++next)
      for (const FacetLink& link : facet(region[next]).links)
        if (is_smooth(link)) offer(link.other);
    // What larger regions own stays with them.
    std::vector<int> kept;
    for (const int f : region) {
      const int owned = owner(f);
      if (owned < 0 || found_[static_cast<std::size_t>(owned)].facets.size() < region.size())
        kept.push_back(f);
    }
    return kept;
  }

  static bool is_enough(const Grown& grown) {
    const bool ruled = grown.carrier.kind == SurfaceKind::cylinder || grown.carrier.kind == SurfaceKind::cone;
    const std::size_t least_points = static_cast<std::size_t>(freedoms(grown.carrier.kind)) +
                                     (grown.carrier.kind == SurfaceKind::torus ? 5 : 3);
    return grown.facets.size() >= (ruled ? 3 : 4) && grown.points >= least_points;
  }

  void take(Grown grown) {
    const int number = static_cast<int>(found_.size());
    std::vector<std::size_t> robbed;
    for (const int f : grown.facets) {
      if (owner(f) >= 0) robbed.push_back(static_cast<std::size_t>(owner(f)));
      owner(f) = number;
    }
    found_.push_back(std::move(grown));
    std::sort(robbed.begin(), robbed.end());
    robbed.erase(std::unique(robbed.begin(), robbed.end()), robbed.end());
    for (const std::size_t r : robbed) {
      auto& facets = found_[r].facets;
      std::erase_if(facets, [&](int f) { return owner(f) != static_cast<int>(r); });
      found_[r].points = vertices_of(facets).size();
      if (!is_enough(found_[r])) release(r);
    }
  }

  std::vector<std::size_t> smooth_regions(std::size_t r) {
    std::vector<std::size_t> result;
    for (const int f : found_[r].facets)
      for (const FacetLink& link : facet(f).links)
        if (is_smooth(link) && owner(link.other) >= 0 && owner(link.other) != static_cast<int>(r))
          result.push_back(static_cast<std::size_t>(owner(link.other)));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::optional<Grown> join(std::size_t a, std::size_t b) {
    std::vector<int> both = found_[a].facets;
    both.insert(both.end(), found_[b].facets.begin(), found_[b].facets.end());
    const std::size_t step = 1 + both.size() / most_points;
    std::vector<int> some;
    for (std::size_t i = 0; i < both.size(); i += step) some.push_back(both[i]);
    const SurfaceSample points = sample(some);
    for (const SurfaceKind kind : {SurfaceKind::sphere, SurfaceKind::torus}) {
      const auto fit = kind == SurfaceKind::torus ? fit_torus(found_[a].carrier, points.points)
                                                  : fit_carrier(kind, points, tolerance_);
      if (!fit || !(fit->largest <= tolerance_)) continue;
      auto grown = grow(fit->carrier, both);
      if (grown && grown->facets.size() >= both.size() && has_rings(*grown, found_[a].carrier)) return grown;
    }
    return std::nullopt;
  }

  /// Whether vertices are at enough heights along an axis: a torus passes through any three circles about it,
  /// a sphere through any two.
  bool has_rings(const Grown& grown, const Carrier& about) {
    std::vector<double> heights;
    const std::size_t enough = grown.carrier.kind == SurfaceKind::torus ? 4 : 3;
    for (const int v : vertices_of(grown.facets)) {
      const double height = about.axis.dot(mesh_.vertices.col(v) - about.origin);
      const double near = 20 * tolerance_;
      if (std::none_of(heights.begin(), heights.end(), [&](double h) { return std::abs(h - height) < near; }))
        heights.push_back(height);
      if (heights.size() >= enough) return true;
    }
    return false;
  }

  void release(std::size_t r) {
    for (const int f : found_[r].facets) owner(f) = -1;
    found_[r].facets.clear();
  }

  /// Facets without a carrier that hang together, and the only carrier around; -1: none or several.
  struct Pocket {
    std::vector<int> facets;
    int owner = -1;
  };

  Pocket pocket_around(int start, std::vector<bool>& done) const {
    Pocket result{{start}};
    bool several = false;
    done[static_cast<std::size_t>(start)] = true;
    for (std::size_t next = 0; next < result.facets.size(); ++next)
      for (const FacetLink& link : facet(result.facets[next]).links) {
        const auto other = static_cast<std::size_t>(link.other);
        if (owner_[other] >= 0) {
          several = several || (result.owner >= 0 && result.owner != owner_[other]);
          result.owner = owner_[other];
        } else if (!done[other]) {
          done[other] = true;
          result.facets.push_back(link.other);
        }
      }
    if (several) result.owner = -1;
    return result;
  }

  /// Whether a facet of one or two triangles has its vertices on a carrier.
  bool is_sliver_on(const Carrier& carrier, int f) const {
    const Facet& it = facet(f);
    if (plane_[static_cast<std::size_t>(f)]) return false;
    const CarrierDistances distances(carrier);
    for (const int v : it.vertices)
      if (!(std::abs(distances.at(mesh_.vertices.col(v)).value) <= tolerance_)) return false;
    return true;
  }

  /// Facets without a carrier that hang together smoothly.
  std::vector<int> left_around(int start, std::vector<bool>& done) const {
    std::vector<int> result{start};
    done[static_cast<std::size_t>(start)] = true;
    for (std::size_t next = 0; next < result.size(); ++next)
      for (const FacetLink& link : facet(result[next]).links) {
        const auto other = static_cast<std::size_t>(link.other);
        if (owner_[other] >= 0 || done[other] || !is_smooth(link) || plane_[other]) continue;
        done[other] = true;
        result.push_back(link.other);
      }
    return result;
  }

  /// Small facets without a carrier that hang together.
  struct FreeSize {
    std::size_t facets = 0;
    double area = 0;
  };

  /// By facet: what it hangs together with; nothing for all others.
  std::vector<FreeSize> free_sizes() const {
    std::vector<FreeSize> result(facets_.size());
    std::vector<bool> done(facets_.size(), false);
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (owner_[f] >= 0 || done[f] || plane_[f]) continue;
      const std::vector<int> together = left_around(static_cast<int>(f), done);
      FreeSize size{together.size()};
      for (const int one : together) size.area += facet(one).area;
      for (const int one : together) result[static_cast<std::size_t>(one)] = size;
    }
    return result;
  }

  Carrier plane_of(int f) const { return {SurfaceKind::plane, facet(f).middle, facet(f).normal, 0, 0, {}}; }

  void add(Regions& result, const std::vector<int>& facets, const std::optional<Carrier>& carrier) {
    Region region;
    region.carrier = carrier;
    double along = 0;
    for (const int f : facets) {
      for (const int t : facet(f).triangles) {
        region.triangles.push_back(t);
        result.of_triangle[static_cast<std::size_t>(t)] = static_cast<int>(result.regions.size());
      }
      region.area += facet(f).area;
      if (!carrier) continue;
      along += carrier_distance(*carrier, facet(f).middle).gradient.dot(facet(f).normal) * facet(f).area;
      for (const int v : facet(f).vertices)
        region.deviation =
            std::fmax(region.deviation, std::abs(carrier_distance(*carrier, mesh_.vertices.col(v)).value));
    }
    region.reversed = along < 0;
    result.regions.push_back(std::move(region));
  }

  const geometry::TriangleMesh& mesh_;
  const std::vector<Facet>& facets_;
  double tolerance_;
  const ReconstructionOptions& options_;
  SeedPatches seeds_;
  std::vector<int> owner_;  ///< by facet: the carrier
  std::vector<Grown> found_;
  std::vector<bool> plane_;  ///< by facet: a plane, unless it lies on a curved surface: large, or of more
                             ///< triangles than others have
  std::vector<int> mark_, vertex_mark_;
  int stamp_ = 0, vertex_stamp_ = 0;
};

}  // namespace

Regions carrier_regions(const geometry::TriangleMesh& mesh, const Facets& facets, double tolerance,
                        const ReconstructionOptions& options, const Progress& progress) {
  CarrierGrower grower(mesh, facets, tolerance, options);
  grower.search(progress);
  grower.join_rings(progress);
  grower.take_slivers();
  grower.drop_leaves();
  return grower.regions(static_cast<std::size_t>(mesh.triangles.cols()));
}

}  // namespace isopatch::segmentation

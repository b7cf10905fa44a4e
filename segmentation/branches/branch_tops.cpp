#include "segmentation/branches/internal/branch_tops.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/cut_by_plane.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

class TopFinder {
 public:
  explicit TopFinder(const Brep& solid) : solid_(solid) {}

  /// Where the first edge is outside of the side that a branch begins on.
  std::optional<double> top_height(const Branch& branch) const {
    std::optional<double> result;
    for_points(branch, [&](double height) {
      if (height > branch.surface + 1e-6 * solid_.size() && (!result || height < *result)) result = height;
    });
    return result;
  }

  bool goes_on(const Branch& branch, double top) const {
    bool result = false;
    for_points(branch, [&](double height) { result = result || height > top + 1e-6 * solid_.size(); });
    return result;
  }

  /// Straight edges by their ends.
  template <class Take>
  void for_points(const Branch& branch, const Take& take) const {
    for (const FaceId face : branch.faces)
      for (const auto& loop : solid_.face(face).loops)
        for (const geometry::EdgeUse& use : loop)
          for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
            if (t == 0 || t == 1 || solid_.edge(use.edge).kind != geometry::CurveKind::line)
              take(branch.view.height(solid_.point(use.edge, t)));
  }

  /// Half way to the bottom of a hole, so that what is above is there all over the branch.
  double height_to_cut(const Branch& branch, double event) const {
    for (const FaceId face : branch.faces) {
      const auto carrier = solid_.carrier(face);
      if (carrier && carrier->kind == geometry::SurfaceKind::plane &&
          std::abs(branch.view.height(carrier->origin) - event) < 1e-6 * solid_.size() &&
          solid_.outward_normal(face, solid_.domain(face).low).dot(branch.view.along) > 1 - 1e-7)
        return (branch.surface + event) / 2;
    }
    return event;
  }

  /// What stands on a branch's top, as a stack.
  ComplexOfPiece top_of(const Branch& branch, double height) const {
    for (geometry::CutPart& part :
         geometry::cut_by_plane(solid_, branch.view.point({0, 0}, height), branch.view.along)) {
      const bool is_mine =
          std::any_of(part.origin.begin(), part.origin.end(),
                      [&](const auto& face) {
                        return face && std::binary_search(branch.faces.begin(), branch.faces.end(), *face);
                      }) &&
          branch.view.height(part.brep.vertex(VertexId(0))) > height - 1e-6 * solid_.size();
      if (!is_mine) continue;
      for (const SweepFrame& frame : sweep_frames(part.brep))
        if (frame.along.cross(branch.view.along).norm() < 1e-7)
          return {Stack(part.brep, frame, spokes(branch, height)).complex(), part.origin};
    }
    throw Error(ErrorCode::unsupported,
                fmt::format("what stands on {} is no stack", describe(solid_, branch.faces.front())));
  }

  /// Eight across a pipe, two at each side: an odd number of pieces of its outline faces each side of its
  /// place, whatever the flange on it needs.
  std::vector<Line> spokes(const Branch& branch, double height) const {
    if (branch.outlines.size() != 2) return {};
    const PlanCurve &one = branch.outlines[0].curves.front(), &other = branch.outlines[1].curves.front();
    if (!one.is_circle() || !other.is_circle() || (one.centre - other.centre).norm() > 1e-6 * solid_.size())
      return {};
    std::vector<Line> result;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d out =
          Eigen::Rotation2Dd((2 * i + 1) * std::numbers::pi / 8) * Eigen::Vector2d::UnitX();
      const auto at = [&](const PlanCurve& circle) {
        return branch.view.point(circle.centre + (circle.from - circle.centre).norm() * out, height);
      };
      result.push_back({at(one), at(other)});
    }
    return result;
  }

  /// How it is divided where it stands on the branch.
  static std::vector<PlanQuad> floor_of(const Branch& branch, double height, const ComplexOfPiece& top) {
    std::vector<PlanQuad> result;
    for (const geometry::CellFace& face : top.complex.faces) {
      if (!face.origin || top.origin[static_cast<std::size_t>(face.origin->value)]) continue;
      PlanQuad& quad = result.emplace_back();
      double twice_area = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        quad[i] = seen(branch.view, height, top.complex, face.loop[i]);
        const Eigen::Vector3d a = quad[i].point(quad[i].low()), b = quad[i].point(quad[i].high());
        twice_area += a.x() * b.y() - a.y() * b.x();
      }
      if (twice_area > 0) continue;
      std::reverse(quad.begin(), quad.end());
      for (geometry::NurbsCurve& side : quad) side = geometry::reversed(side, 0);
    }
    return result;
  }

  static geometry::NurbsCurve seen(const PlanView& view, double height, const CellComplex& complex,
                                   geometry::EdgeUse use) {
    const auto& curve = std::get<geometry::NurbsCurve>(complex.curve(complex.edge(use.edge).curve).shape);
    Eigen::Matrix3Xd points = curve.control_points();
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i) << view.flat(points.col(i)), view.height(points.col(i)) - height;
    const geometry::NurbsCurve made(curve.knots(), points, curve.weights());
    return use.reversed ? geometry::reversed(made, 0) : made;
  }

 private:
  const Brep& solid_;
};

}  // namespace

void BranchTops::find(const Branch& branch, BranchPlace& place) {
  const TopFinder finder(solid_);
  const auto event = finder.top_height(branch);
  if (!event) return;
  place.top = finder.goes_on(branch, *event) ? finder.height_to_cut(branch, *event) : event;
  if (!finder.goes_on(branch, *place.top)) return;
  tops_.push_back(finder.top_of(branch, *place.top));
  place.on_top = TopFinder::floor_of(branch, *place.top, tops_.back());
}

CellComplex BranchTops::with(CellComplex body) {
  if (tops_.empty()) return body;
  std::vector<std::optional<FaceId>> origin;
  for (int f = 0; f < static_cast<int>(solid_.faces().size()); ++f) origin.emplace_back(FaceId(f));
  origin.emplace_back();
  tops_.insert(tops_.begin(), {std::move(body), std::move(origin)});
  return joined_complex(tops_, 1e-6 * solid_.size());
}

}  // namespace isopatch::segmentation

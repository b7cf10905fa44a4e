#include "segmentation/branches/branched_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/cut_by_plane.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/without_faces.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/branches/internal/branch_room.hpp"
#include "segmentation/branches/internal/inserted_branch.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/pieces/joined_complex.hpp"
#include "segmentation/sweeps/require_all_of.hpp"
#include "segmentation/sweeps/stack.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

class BodyDivider {
 public:
  BodyDivider(const Brep& solid, const MainBody& body)
      : solid_(solid), body_(body), cut_face_(static_cast<int>(solid.faces().size())) {}

  BranchedCells make() {
    CellComplex complex = turned_body();
    std::vector<ComplexOfPiece> tops;
    for (std::size_t b = 0; b < body_.branches.size(); ++b) {
      const Branch& branch = body_.branches[b];
      BranchPlace place = layout_.places[b];
      if (const auto event = top_height(branch)) {
        place.top = goes_on(branch, *event) ? height_to_cut(branch, *event) : event;
        if (goes_on(branch, *place.top)) {
          tops.push_back(top_of(branch, *place.top));
          place.on_top = floor_of(branch, *place.top, tops.back());
        }
      }
      complex = inserted_branch(solid_, complex, branch, place, cut_face_);
    }
    BranchedCells result{joined(std::move(complex), std::move(tops)), body_.axis,
                         static_cast<int>(body_.branches.size())};
    require_all_of(solid_, result.complex);
    return result;
  }

 private:
  /// The body alone, divided so that every branch has a side.
  CellComplex turned_body() {
    std::vector<FaceId> removed;
    for (const Branch& branch : body_.branches)
      removed.insert(removed.end(), branch.faces.begin(), branch.faces.end());
    const Brep blank = geometry::without_faces(solid_, removed);
    layout_ = layout_of(solid_, body_);
    auto turned = turned_cells(blank, layout_.request);
    if (!turned) throw Error(ErrorCode::unsupported, "without its branches it is not turned");
    name_faces(blank, turned->complex);
    return std::move(turned->complex);
  }

  /// By the solid's faces instead of the body's.
  void name_faces(const Brep& blank, CellComplex& complex) const {
    if (blank.faces().size() != body_.faces.size())
      throw Error(ErrorCode::unsupported, "its faces go on in others where its branches are taken off");
    for (geometry::CellFace& face : complex.faces)
      if (face.origin) face.origin = body_.faces[static_cast<std::size_t>(face.origin->value)];
  }

  /// Where the first edge is outside of the body's cylinder.
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

  CellComplex joined(CellComplex body, std::vector<ComplexOfPiece> tops) const {
    if (tops.empty()) return body;
    std::vector<std::optional<FaceId>> origin;
    for (int f = 0; f < static_cast<int>(solid_.faces().size()); ++f) origin.emplace_back(FaceId(f));
    origin.emplace_back();
    tops.insert(tops.begin(), {std::move(body), std::move(origin)});
    return joined_complex(tops, 1e-6 * solid_.size());
  }

  const Brep& solid_;
  const MainBody& body_;
  FaceId cut_face_;
  BranchLayout layout_;
};

}  // namespace

std::optional<BranchedCells> branched_cells(const Brep& solid) {
  std::optional<Error> refusal;
  for (const MainBody& body : main_bodies(solid)) {
    try {
      return BodyDivider(solid, body).make();
    } catch (const Error& error) {
      if (error.code() != ErrorCode::unsupported) throw;
      if (!refusal) refusal = error;
    }
  }
  if (refusal) throw *refusal;
  return std::nullopt;
}

}  // namespace isopatch::segmentation

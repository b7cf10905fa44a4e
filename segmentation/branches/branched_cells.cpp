#include "segmentation/branches/branched_cells.hpp"

#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/branches/internal/branch_room.hpp"
#include "segmentation/branches/internal/branch_tops.hpp"
#include "segmentation/branches/internal/inserted_branch.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/sweeps/require_all_of.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

class BodyDivider {
 public:
  BodyDivider(const Brep& solid, const MainBody& body) : solid_(solid), body_(body) {}

  BranchedCells make() {
    CellComplex complex = turned_body();
    BranchTops tops(solid_);
    for (std::size_t b = 0; b < body_.branches.size(); ++b) {
      const Branch& branch = body_.branches[b];
      BranchPlace place = layout_.places[b];
      tops.find(branch, place);
      complex = inserted_branch(solid_, complex, branch, place, tops.cut_face());
    }
    BranchedCells result{tops.with(std::move(complex)), body_.axis, static_cast<int>(body_.branches.size())};
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

  const Brep& solid_;
  const MainBody& body_;
  BranchLayout layout_;
};

}  // namespace

std::optional<Eigen::Vector3d> branched_about(const Brep& solid) {
  const std::vector<MainBody> bodies = main_bodies(solid);
  return bodies.empty() ? std::nullopt : std::optional(bodies.front().axis);
}

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

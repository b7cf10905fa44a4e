#include "app/problem/overlapping_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

namespace isopatch::app {
namespace {

using geometry::BlockSide;
using geometry::Brep;
using segmentation::HexModel;

// Parts of one solid have one surface between them; files of blocks agree to less than that share of the
// size.
constexpr double agreement = 1e-5;
constexpr int points_along = 10;

struct SampledSide {
  BlockSide side;
  const Brep* brep = nullptr;
  FaceId face;
  std::vector<Eigen::Vector2d> uv;
  std::vector<Eigen::Vector3d> points;  // m
  Eigen::AlignedBox3d box;              // of the edges' points too
};

// Not symmetric, so that no edge along a diagonal has them.
SampledSide sampled(const HexModel& model, BlockSide side) {
  const Brep& brep = model.solids[static_cast<std::size_t>(side.block.value)].brep;
  SampledSide result{side, &brep, model.face(side).face, {}, {}, {}};
  const geometry::DomainBox domain = brep.domain(result.face);
  for (int j = 0; j < points_along; ++j)
    for (int i = 0; i < points_along; ++i) {
      const Eigen::Vector2d share((i + 0.5) / points_along, (j + 0.382) / points_along);
      const Eigen::Vector2d uv = domain.low + (domain.high - domain.low).cwiseProduct(share);
      if (!brep.contains(result.face, uv)) continue;
      result.uv.push_back(uv);
      result.points.push_back(brep.point(result.face, uv));
      result.box.extend(result.points.back());
    }
  for (const auto& loop : brep.face(result.face).loops)
    for (const geometry::EdgeUse use : loop)
      for (int i = 0; i <= points_along; ++i)
        result.box.extend(brep.point(use.edge, i / double(points_along)));
  return result;
}

Eigen::AlignedBox3d widened(const Eigen::AlignedBox3d& box, double by) {
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(by);
  return {box.min() - margin, box.max() + margin};
}

// Whether a sample of one side lies on the other, which faces it there: sides that meet along an edge do not.
bool lies_on(const SampledSide& one, const SampledSide& other, double reach) {
  const Eigen::AlignedBox3d box = widened(other.box, reach);
  for (std::size_t i = 0; i < one.points.size(); ++i) {
    if (!box.contains(one.points[i])) continue;
    const geometry::FaceProjection found = other.brep->project(other.face, one.points[i]);
    if (!(found.distance <= reach) || !other.brep->contains(other.face, found.uv)) continue;
    const double opposite =
        one.brep->outward_normal(one.face, one.uv[i]).dot(other.brep->outward_normal(other.face, found.uv));
    if (opposite < -0.9) return true;
  }
  return false;
}

bool is_known(const HexModel& model, BlockSide a, BlockSide b) {
  for (const geometry::TJoint& joint : model.topology.t_joints)
    for (const geometry::SidePart& part : joint.parts)
      if ((joint.whole == a && part.side == b) || (joint.whole == b && part.side == a)) return true;
  return false;
}

}  // namespace

std::vector<std::pair<BlockSide, BlockSide>> overlapping_sides(const HexModel& model) {
  std::vector<SampledSide> sides;
  for (std::size_t b = 0; b < model.solids.size(); ++b)
    for (const geometry::Side side : geometry::all_sides) {
      const BlockSide here{geometry::BlockId(static_cast<int>(b)), side};
      if (model.topology.face(model.topology.at(here)).uses.size() < 2) sides.push_back(sampled(model, here));
    }
  Eigen::AlignedBox3d all;
  for (const SampledSide& side : sides) all.extend(side.box);
  const double reach = sides.empty() ? 0 : agreement * all.diagonal().norm();
  std::vector<std::pair<BlockSide, BlockSide>> result;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const SampledSide &one = sides[i], &other = sides[j];
      if (one.side.block == other.side.block || !widened(one.box, reach).intersects(other.box)) continue;
      if ((lies_on(one, other, reach) || lies_on(other, one, reach)) &&
          !is_known(model, one.side, other.side))
        result.emplace_back(one.side, other.side);
    }
  return result;
}

}  // namespace isopatch::app

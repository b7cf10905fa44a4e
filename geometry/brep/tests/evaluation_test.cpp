#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <thread>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/data_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

using isopatch::test::data_file;

/// Solids of every kind of surface: plane, cylinder, cone, sphere, torus, spline; and by others where these
/// are there.
std::vector<Brep> solids() {
  std::vector<Brep> result = {make_brep(test::block(0.3, 0.2, 0.1))};
  for (const std::string& name : test::made_solids) result.push_back(test::made_brep(name));
  for (const char* name :
       {"models/screw.step", "models/block_torus_fillet3.step", "models/block_through_hole.step",
        "models/pipe_helix.step", "chair_stand/solids/segmented_objStandFiveParts1_seed002_5.xml"})
    if (const auto path = data_file(name); std::filesystem::exists(path))
      result.push_back(read_brep(path).brep);
  return result;
}

TEST(BrepEvaluation, IsTestedOnEveryKindOfSurface) {
  std::set<SurfaceKind> kinds;
  for (const Brep& brep : solids())
    for (const BrepFace& face : brep.faces()) kinds.insert(face.kind);
  using enum SurfaceKind;
  for (const SurfaceKind kind : {plane, cylinder, cone, sphere, torus, spline})
    EXPECT_TRUE(kinds.contains(kind)) << name(kind);
}

TEST(BrepEvaluation, CurvesInDomainsFollowTheEdges) {
  for (const Brep& brep : solids())
    for (std::size_t f = 0; f < brep.faces().size(); ++f)
      for (const auto& loop : brep.faces()[f].loops)
        for (const EdgeUse use : loop)
          for (const double t : {0.0, 0.21, 0.5, 1.0}) {
            const FaceId face(static_cast<int>(f));
            const Eigen::Vector2d uv = brep.domain_point(face, use, t);
            EXPECT_LT((brep.point(face, uv) - brep.point(use.edge, t)).norm(), 2e-4 * brep.size());
            // The chain rule: as the edge runs, its image in the domain runs. Curves of files are fitted, and
            // the derivatives of fits are poor at their ends.
            if (t == 0 || t == 1) continue;
            const Eigen::Vector3d along = brep.derivatives(face, uv) * brep.domain_tangent(face, use, t);
            const Eigen::Vector3d tangent = brep.tangent(use.edge, t);
            EXPECT_LT((along - tangent).norm(), 0.02 * tangent.norm() + 1e-6 * brep.size())
                << "face " << f << " edge " << use.edge.value << " t " << t;
          }
}

TEST(BrepEvaluation, EdgesBeginAndEndInTheirVertices) {
  for (const Brep& brep : solids())
    for (std::size_t e = 0; e < brep.edges().size(); ++e) {
      const EdgeId id(static_cast<int>(e));
      EXPECT_LT((brep.point(id, 0) - brep.vertex(brep.edge(id).start)).norm(), 5e-5 * brep.size());
      EXPECT_LT((brep.point(id, 1) - brep.vertex(brep.edge(id).end)).norm(), 5e-5 * brep.size());
    }
}

TEST(BrepEvaluation, DerivativesAreThoseOfDifferences) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.1, 0.9);
  for (const Brep& brep : solids())
    for (std::size_t f = 0; f < brep.faces().size(); ++f) {
      const FaceId face(static_cast<int>(f));
      const DomainBox box = brep.domain(face);
      const Eigen::Vector2d range = box.high - box.low;
      const Eigen::Vector2d uv =
          box.low + range.cwiseProduct(Eigen::Vector2d(uniform(random), uniform(random)));
      const auto d = brep.derivatives(face, uv);
      const Eigen::Matrix3d dd = brep.second_derivatives(face, uv);
      for (int k = 0; k < 2; ++k) {
        const Eigen::Vector2d step = 1e-5 * range(k) * Eigen::Vector2d::Unit(k);
        const Eigen::Vector3d slope =
            (brep.point(face, uv + step) - brep.point(face, uv - step)) / (2 * step(k));
        EXPECT_LT((slope - d.col(k)).norm(), 1e-6 * brep.size() / range(k));
        const auto difference =
            (brep.derivatives(face, uv + step) - brep.derivatives(face, uv - step)) / (2 * step(k));
        const double scale = 1e-5 * brep.size() / range(k);
        EXPECT_LT((difference.col(0) - dd.col(k)).norm(), scale / range(0));
        EXPECT_LT((difference.col(1) - dd.col(k + 1)).norm(), scale / range(1));
      }
    }
}

TEST(BrepEvaluation, NormalsPointOutwards) {
  const Brep brep = make_brep(test::prism(6));
  const Eigen::Vector3d middle(0, 0, 0.5);
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    const FaceId face(static_cast<int>(f));
    const DomainBox box = brep.domain(face);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    EXPECT_GT(brep.outward_normal(face, uv).dot(brep.point(face, uv) - middle), 0.1);
  }
}

TEST(BrepEvaluation, NearestPointsOfFacesAreFoundAgain) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const Brep& brep : solids())
    for (std::size_t f = 0; f < brep.faces().size(); ++f) {
      const FaceId face(static_cast<int>(f));
      const DomainBox box = brep.domain(face);
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector2d uv =
            box.low + (box.high - box.low).cwiseProduct(Eigen::Vector2d(uniform(random), uniform(random)));
        const Eigen::Vector3d on = brep.point(face, uv);
        const FaceProjection found = brep.project(face, on);
        EXPECT_LT(found.distance, 1e-9 * brep.size()) << "face " << f;
        // Off the surface by little: the foot is the same point, and not farther away.
        const double height = 1e-4 * brep.size();
        const Eigen::Vector3d off = on + height * brep.outward_normal(face, uv);
        for (const FaceProjection& foot : {brep.project(face, off), brep.project(face, off, uv)}) {
          EXPECT_LE(foot.distance, height * (1 + 1e-9));
          EXPECT_GT(foot.distance, 0.5 * height);
          EXPECT_NEAR((foot.point - brep.point(face, foot.uv)).norm(), 0, 1e-12 * brep.size());
        }
      }
    }
}

TEST(BrepEvaluation, NearestPointsOfEdgesAreFoundAgain) {
  for (const Brep& brep : solids())
    for (std::size_t e = 0; e < brep.edges().size(); ++e) {
      const EdgeId edge(static_cast<int>(e));
      for (const double t : {0.0, 0.3, 0.77, 1.0})
        EXPECT_LT(brep.project(edge, brep.point(edge, t)).distance, 1e-9 * brep.size());
    }
}

TEST(BrepEvaluation, EdgesAsNurbsCurvesAreExact) {
  for (const Brep& brep : solids())
    for (std::size_t e = 0; e < brep.edges().size(); ++e) {
      const EdgeId edge(static_cast<int>(e));
      const NurbsCurve curve = brep.curve(edge);
      EXPECT_LT((curve.point(curve.low()) - brep.point(edge, 0)).norm(), 1e-12 * brep.size());
      EXPECT_LT((curve.point(curve.high()) - brep.point(edge, 1)).norm(), 1e-12 * brep.size());
      for (const double s : {0.2, 0.5, 0.9}) {
        const Eigen::Vector3d on = curve.point(curve.low() + s * (curve.high() - curve.low()));
        EXPECT_LT(brep.project(edge, on).distance, 1e-9 * brep.size());
      }
    }
}

TEST(BrepEvaluation, AHoleDoesNotBelongToItsFace) {
  const Brep brep = test::made_brep("drilled");
  int faces = 0;
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    if (brep.faces()[f].loops.size() != 2) continue;
    const FaceId face(static_cast<int>(f));
    const EdgeUse rim = brep.faces()[f].loops[1].front();
    const Eigen::Vector2d middle = (brep.domain_point(face, rim, 0) + brep.domain_point(face, rim, 0.5)) / 2;
    EXPECT_FALSE(brep.contains(face, middle));
    EXPECT_TRUE(brep.contains(face, middle + 1.05 * (brep.domain_point(face, rim, 0.3) - middle)));
    ++faces;
  }
  EXPECT_EQ(faces, 2);
}

/// Sums over everything that a solid can be asked, in an order of its own.
double digest(const Brep& brep, int seed) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::vector<double> sums(brep.faces().size());
  std::vector<std::size_t> order(brep.faces().size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  for (const std::size_t f : order) {
    const FaceId face(static_cast<int>(f));
    const DomainBox box = brep.domain(face);
    for (int i = 1; i < 6; ++i) {
      const Eigen::Vector2d uv = box.low + i / 6.0 * (box.high - box.low);
      const Eigen::Vector3d on = brep.point(face, uv);
      sums[f] += on.sum() + brep.derivatives(face, uv).sum() + brep.project(face, on).uv.sum() +
                 brep.contains(face, uv);
    }
    for (const EdgeUse use : brep.faces()[f].loops.front())
      sums[f] += brep.point(use.edge, 0.3).sum() + brep.domain_point(face, use, 0.3).sum() +
                 brep.project(use.edge, brep.vertices().col(0)).t;
    sums[f] += brep.area(face);
  }
  double total = brep.volume();
  for (const double sum : sums) total += sum;
  return total;
}

TEST(BrepEvaluation, ThreadsDoNotDisturbEachOther) {
  for (int round = 0; round < 2; ++round) {
    const std::vector<Brep> shared = solids(), alone = solids();
    for (std::size_t s = 0; s < shared.size(); ++s) {
      std::vector<double> found(4);
      std::vector<std::thread> threads;
      for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] { found[static_cast<std::size_t>(i)] = digest(shared[s], i); });
      for (std::thread& thread : threads) thread.join();
      const double expected = digest(alone[s], 9);
      for (const double value : found) EXPECT_EQ(value, expected);
    }
  }
}

TEST(BrepEvaluation, ASolidWithoutAKernelIsNone) {
  EXPECT_ERROR(Brep(nullptr), ErrorCode::invalid_argument, "needs a kernel");
}

TEST(BrepEvaluation, IdsOutOfRangeAreRefused) {
  const Brep brep = make_brep(test::block(1, 1, 1));
  EXPECT_ERROR(brep.point(FaceId(6), Eigen::Vector2d::Zero()), ErrorCode::invalid_argument,
               "there is no face 6");
  EXPECT_ERROR(brep.point(EdgeId(-1), 0), ErrorCode::invalid_argument, "there is no edge -1");
  EXPECT_ERROR(brep.vertex(VertexId(8)), ErrorCode::invalid_argument, "there is no vertex 8");
  const EdgeUse use = brep.faces()[0].loops[0][0];
  EXPECT_ERROR(brep.domain_point(FaceId(0), {use.edge, !use.reversed}, 0), ErrorCode::invalid_argument,
               "does not use edge");
}

}  // namespace
}  // namespace isopatch::geometry

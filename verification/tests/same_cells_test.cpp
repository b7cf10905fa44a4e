// What a solid is cut into does not depend on how many processors there are: models are compared, and stored
// stages used again.

#include <gtest/gtest.h>
#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <variant>
#include <vector>

#include "geometry/brep/tests/made_solids.hpp"
#include "segmentation/decomposition/known_shape.hpp"

namespace isopatch::segmentation {
namespace {

/// Of this thread and those that it starts, for as long as it lives.
class OneProcessor {
 public:
  OneProcessor() : threads_(omp_get_max_threads()) {
    sched_getaffinity(0, sizeof before_, &before_);
    int first = 0;
    while (!CPU_ISSET(first, &before_)) ++first;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(first, &one);
    sched_setaffinity(0, sizeof one, &one);
    omp_set_num_threads(1);
  }
  ~OneProcessor() {
    sched_setaffinity(0, sizeof before_, &before_);
    omp_set_num_threads(threads_);
  }
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  int threads_;
  cpu_set_t before_;
};

/// All numbers of a complex: places, and which things are beside which.
std::vector<double> numbers_of(const geometry::CellComplex& complex) {
  std::vector<double> result;
  for (const Eigen::Vector3d& vertex : complex.vertices)
    result.insert(result.end(), vertex.begin(), vertex.end());
  for (const geometry::CellCurve& curve : complex.curves)
    if (const auto* own = std::get_if<geometry::NurbsCurve>(&curve.shape)) {
      const auto places = own->control_points().reshaped();
      result.insert(result.end(), places.begin(), places.end());
    }
  for (const geometry::CellEdge& edge : complex.edges)
    result.insert(result.end(), {double(edge.curve.value), double(edge.start.value), double(edge.end.value)});
  for (const geometry::CellFace& face : complex.faces)
    for (const geometry::EdgeUse& use : face.loop) result.push_back(2 * use.edge.value + use.reversed);
  for (const geometry::Cell& cell : complex.cells)
    for (const geometry::CellFaceUse& use : cell.faces) result.push_back(2 * use.face.value + use.reversed);
  return result;
}

std::vector<double> cut(const char* name) {
  const KnownShape known = known_shape(geometry::test::made_brep(name), {});
  return known.decomposition ? numbers_of(known.decomposition->complex) : std::vector<double>();
}

// Inclined walls are drafted beside each other; the others are of one kind each. (Searches for cuts end by
// time.)
TEST(CutSolids, AreTheSameOnOneProcessorAsOnAll) {
  for (const char* name : {"drafted_pocket", "square_end", "cross_bored", "ports"}) {
    const std::vector<double> on_all = cut(name);
    const OneProcessor one;
    EXPECT_GT(on_all.size(), 24U) << name;
    EXPECT_EQ(cut(name), on_all) << name;
  }
}

}  // namespace
}  // namespace isopatch::segmentation

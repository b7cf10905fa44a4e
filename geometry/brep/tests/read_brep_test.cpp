#include "geometry/brep/read_brep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/brep/edge_graph.hpp"
#include "geometry/brep/tests/data_file.hpp"

namespace isopatch::geometry {
namespace {

using test::data_file;

TEST(ReadBrep, TheBlockIsTheBlockOfTheTable) {
  const auto path = data_file("models/block.step");
  ISOPATCH_NEEDS(path);
  const BrepFile file = read_brep(path);
  EXPECT_EQ(file.brep.faces().size(), 6u);
  EXPECT_EQ(file.brep.edges().size(), 12u);
  EXPECT_EQ(file.brep.vertices().cols(), 8);
  const Eigen::Vector3d sides = file.brep.box()[1] - file.brep.box()[0];
  EXPECT_NEAR(file.brep.volume(), sides.prod(), 1e-12 * sides.prod());
}

TEST(ReadBrep, TheChairStandsNineSolidsAreCubesWithSixFaces) {
  double sum = 0;
  for (const char* part : {"1_seed002_3", "1_seed002_4", "1_seed002_5", "2", "3", "4_seed005_3",
                           "4_seed005_4", "4_seed005_5", "5"}) {
    SCOPED_TRACE(part);
    const auto path =
        data_file(std::string("chair_stand/solids/segmented_objStandFiveParts") + part + ".xml");
    ISOPATCH_NEEDS(path);
    const BrepFile file = read_brep(path);
    EXPECT_EQ(file.brep.faces().size(), 6u);
    EXPECT_EQ(file.brep.edges().size(), 12u);
    EXPECT_EQ(file.brep.vertices().cols(), 8);
    const EdgeGraph graph = edge_graph(file.brep);
    EXPECT_TRUE(topology(graph, boundary(graph)).contractible);
    std::printf("%s volume %.9g correction %.3g\n", part, file.brep.volume(), file.largest_correction);
    EXPECT_GT(file.brep.volume(), 0);
    sum += file.brep.volume();
  }
  std::printf("sum %.9g\n", sum);
}

}  // namespace
}  // namespace isopatch::geometry

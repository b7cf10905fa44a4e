#include "app/problem/reconstructed_solids.hpp"

#include <filesystem>

#include "app/tests/program_fixture.hpp"
#include "app/tests/stl_file.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/read_brep.hpp"

namespace isopatch::app {
namespace {

class ReconstructedSolids : public Program {
 protected:
  /// The triangles of a made solid in millimetres, as a file.
  std::string stl(const std::string& solid) const { return test::stl_file(folder_, solid); }
};

TEST_F(ReconstructedSolids, AreWrittenWithAReport) {
  const std::string file = stl("drilled"), folder = (folder_ / "made").string();
  ASSERT_EQ(run({"reconstruct", file, "-o", folder, "--length-unit", "mm"}), 0) << err_;
  EXPECT_NE(out_.find("7 faces (6 planes, 1 cylinder)"), std::string::npos) << out_;
  EXPECT_NE(out_.find("radius 5 mm"), std::string::npos) << out_;
  const geometry::BrepFile made = geometry::read_brep(folder_ / "made" / "drilled.step");
  EXPECT_NEAR(made.brep.volume() / geometry::test::made_brep("drilled").volume(), 1, 2e-6);
  const json report = json::parse(read_file(folder_ / "made" / "reconstruction.json"));
  EXPECT_EQ(report["faces"].size(), 7u);
  EXPECT_EQ(report["faces"][6]["name"], "plane_6");
  EXPECT_EQ(report["faces"][6]["kind"], "plane");
}

TEST_F(ReconstructedSolids, SayWhatAUnitIsTakenAsWhereNobodyDoes) {
  const std::string file = stl("drilled"), folder = (folder_ / "made").string();
  ASSERT_EQ(run({"reconstruct", file, "-o", folder}), 0) << err_;
  EXPECT_NE(err_.find("states no unit of length, so one unit is taken as 1 m"), std::string::npos) << err_;
  ASSERT_EQ(run({"reconstruct", file, "-o", folder, "--length-unit", "m"}), 0) << err_;
  EXPECT_EQ(err_.find("unit of length"), std::string::npos) << err_;
}

TEST_F(ReconstructedSolids, AreCutIntoBlocks) {
  ASSERT_EQ(run({"segment", stl("drilled"), "-o", (folder_ / "blocks").string(), "--length-unit", "mm"}), 0)
      << err_;
  EXPECT_NE(out_.find("4 hexahedra"), std::string::npos) << out_;
}

TEST_F(ReconstructedSolids, PassThePatchTestAsStudies) {
  stl("drilled");
  ASSERT_EQ(run_text(R"([model]
file = "drilled.stl"
length_unit = "mm"
[reconstruction]
tolerance = 2e-6
[[material]]
young = 1000
poisson = 0.25
[[support]]
faces = ["plane_1", "plane_2", "plane_3", "plane_4", "plane_5", "plane_6", "cylinder_1"]
displacement_gradient = [[0.001, 0, 0], [0, 0, 0], [0, 0, 0]]
)"),
            0)
      << err_;
  // lambda + 2 mu = 1200 Pa; half of it times 1e-6 and the volume, 6000 mm^3 less the bore of radius 5 mm.
  const json summary = json::parse(read_file(results() / "summary.json"));
  EXPECT_NEAR(summary["results"]["internal_energy"].get<double>() / (600e-6 * (6000 - 250 * M_PI) * 1e-9), 1,
              1e-5);
}

TEST_F(ReconstructedSolids, SectionIsForTrianglesAlone) {
  write_file(folder_ / "a.off",
             "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  EXPECT_EQ(run_text("[model]\nfile = \"a.off\"\n[reconstruction]\ntolerance = 1e-5\n[[material]]\nyoung = "
                     "1\npoisson = 0.2\n[[support]]\nfaces = [\"face 0\"]\ndisplacement = [0, 0, 0]\n"),
            2);
  EXPECT_NE(err_.find("[reconstruction] is for triangles"), std::string::npos) << err_;
}

TEST_F(ReconstructedSolids, AreAdvisedWherePatchesAreWanted) {
  EXPECT_EQ(run({"render", stl("block"), "-o", (folder_ / "a.png").string()}), 2);
  EXPECT_NE(err_.find("isopatch reconstruct"), std::string::npos) << err_;
}

TEST_F(ReconstructedSolids, AreDescribedByWhatWouldBecomeOfThem) {
  ASSERT_EQ(run({"info", stl("drilled"), "--length-unit", "mm"}), 0) << err_;
  EXPECT_NE(out_.find("closed, volume"), std::string::npos) << out_;
  EXPECT_NE(out_.find("7 faces (6 planes, 1 cylinder)"), std::string::npos) << out_;
  EXPECT_NE(out_.find("segmentation: looks swept along"), std::string::npos) << out_;
  ASSERT_EQ(run({"info", stl("drilled"), "--length-unit", "mm", "--json"}), 0) << err_;
  const json told = json::parse(out_);
  EXPECT_EQ(told["closed"], true);
  EXPECT_EQ(told["reconstruction"]["faces"].size(), 7u);
  // 6000 mm^3 less the bore of radius 5 mm, which has the triangles of a polygon.
  EXPECT_NEAR(told["volume"].get<double>() / ((6000 - 250 * M_PI) * 1e-9), 1, 0.01);
}

TEST_F(ReconstructedSolids, AreDescribedEvenIfTheyBoundNothing) {
  const std::string file = stl("block");
  std::string bytes = read_file(file);
  bytes.resize(bytes.size() - 50);  // without its last triangle
  bytes[80] = static_cast<char>(bytes[80] - 1);
  write_file(file, bytes);
  EXPECT_EQ(run({"info", file}), 2);
  EXPECT_NE(out_.find("bounds no solid"), std::string::npos) << out_;
  EXPECT_NE(err_.find("block.stl"), std::string::npos) << err_;
}

TEST_F(ReconstructedSolids, FileAndPlaceAreNamedWhereItFails) {
  EXPECT_EQ(run({"reconstruct", stl("spring"), "-o", (folder_ / "made").string()}), 2);
  EXPECT_NE(err_.find("spring.stl"), std::string::npos) << err_;
  EXPECT_NE(err_.find("m^2 around ("), std::string::npos) << err_;
}

}  // namespace
}  // namespace isopatch::app

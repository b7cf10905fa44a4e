#include "geometry/io/vtk_bezier.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkBezierHexahedron.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;

// A quarter ring of radii 1 and 2 and height 3, exact, degrees (1, 2, 1), raised to `degree`, the radius
// halved.
NurbsVolume quarter_ring(const std::array<int, 3>& degree) {
  Eigen::Matrix3Xd points(3, 12);
  Eigen::VectorXd weights(12);
  int n = 0;
  for (const double z : {0.0, 3.0})
    for (const auto& corner : {Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1), Eigen::Vector2d(0, 1)})
      for (const double r : {1.0, 2.0}) {
        points.col(n) << r * corner, z;
        weights[n++] = corner == Eigen::Vector2d(1, 1) ? std::sqrt(0.5) : 1.0;
      }
  NurbsVolume ring({KnotVector::bezier(1), KnotVector::bezier(2), KnotVector::bezier(1)}, points, weights);
  for (int d = 0; d < 3; ++d)
    if (degree[static_cast<std::size_t>(d)] > ring.degree(d))
      ring = elevate_degree(ring, d, degree[static_cast<std::size_t>(d)] - ring.degree(d));
  return insert_knots(insert_knots(ring, 0, {0.5}), 1, {0.3});
}

// The pieces as cells, with a field whose coefficients are those of a spline: rotated points.
BezierCells cells_of(const std::vector<NurbsVolume>& pieces) {
  BezierCells cells;
  for (std::size_t d = 0; d < 3; ++d) cells.degree[d] = pieces[0].degree(static_cast<int>(d));
  cells.cell_count = static_cast<int>(pieces.size());
  const Eigen::Index n = pieces[0].size();
  cells.points.resize(3, n * cells.cell_count);
  cells.weights.resize(n * cells.cell_count);
  Eigen::MatrixXd patch(1, cells.cell_count);
  for (int c = 0; c < cells.cell_count; ++c) {
    const NurbsVolume& piece = pieces[static_cast<std::size_t>(c)];
    cells.points.middleCols(n * c, n) = piece.control_points();
    cells.weights.segment(n * c, n) = piece.weights();
    patch(0, c) = 10 + c;
  }
  const Eigen::MatrixXd field =
      (Eigen::Matrix<double, 2, 3>() << 1, 2, 3, -4, 5, -6).finished() * cells.points;
  cells.point_fields.push_back({"displacement", field});
  cells.cell_fields.push_back({"patch", patch});
  return cells;
}

vtkNew<vtkUnstructuredGrid> read_back(const std::string& text) {
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->ReadFromInputStringOn();
  reader->SetInputString(text);
  reader->Update();
  vtkNew<vtkUnstructuredGrid> grid;
  grid->ShallowCopy(reader->GetOutput());
  return grid;
}

// VTK's own evaluation of a cell at parameters in [0, 1]^3: first the point, then the field.
Eigen::VectorXd evaluate(vtkUnstructuredGrid* grid, vtkIdType index, const Eigen::Vector3d& t) {
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(index, cell);
  std::vector<double> basis(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  Eigen::VectorXd result(5);
  int sub_cell = 0;
  cell->EvaluateLocation(sub_cell, t.data(), result.data(), basis.data());
  vtkDataArray* field = grid->GetPointData()->GetArray("displacement");
  result.tail(2).setZero();
  for (int component = 0; component < 2; ++component)
    for (std::size_t i = 0; i < basis.size(); ++i)
      result[3 + component] +=
          basis[i] * field->GetComponent(cell->GetPointId(static_cast<vtkIdType>(i)), component);
  return result;
}

class BezierDegrees : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(BezierDegrees, VtkEvaluatesTheSameGeometryAndField) {
  const std::vector<NurbsVolume> pieces = bezier_pieces(quarter_ring(GetParam()));
  ASSERT_EQ(pieces.size(), 4u);
  const auto grid = read_back(to_vtu(cells_of(pieces)));
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  for (vtkIdType c = 0; c < 4; ++c) {
    const NurbsVolume& piece = pieces[static_cast<std::size_t>(c)];
    ASSERT_EQ(grid->GetCellType(c), VTK_BEZIER_HEXAHEDRON);
    EXPECT_EQ(grid->GetCellData()->GetArray("patch")->GetTuple1(c), 10 + static_cast<double>(c));
    for (const Eigen::Vector3d& t : {Eigen::Vector3d(0.1, 0.7, 0.4), Eigen::Vector3d(0, 0.25, 1),
                                     Eigen::Vector3d(0.9, 0.05, 0.85), Eigen::Vector3d(0.5, 1, 0.3)}) {
      const Eigen::Vector3d inside = piece.low().array() + t.array() * (piece.high() - piece.low()).array();
      const Eigen::Vector3d x = piece.point(inside);
      const Eigen::VectorXd found = evaluate(grid, c, t);
      // Some hundred operations on numbers below 32: far below 1e-13.
      EXPECT_LT((found.head(3) - x).norm(), 1e-13);
      EXPECT_NEAR(found[3], x[0] + 2 * x[1] + 3 * x[2], 1e-12);
      EXPECT_NEAR(found[4], -4 * x[0] + 5 * x[1] - 6 * x[2], 1e-12);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(VtkBezier, BezierDegrees,
                         testing::Values(std::array{1, 2, 1}, std::array{2, 2, 2}, std::array{3, 2, 1},
                                         std::array{2, 4, 3}, std::array{4, 3, 5}, std::array{1, 6, 2}));

TEST(VtkBezier, PointsOnTheRingKeepTheirRadius) {
  const auto grid = read_back(to_vtu(cells_of(bezier_pieces(quarter_ring({2, 3, 4})))));
  // Cells 1 and 3 end at the outer radius.
  for (const vtkIdType c : {1, 3})
    for (const double t : {0.0, 0.2, 0.6, 1.0})
      EXPECT_NEAR(evaluate(grid, c, {1, t, 0.5}).head(2).norm(), 2, 1e-14);
}

TEST(VtkBezier, WeightsAndDegreesAreTheActiveAttributes) {
  const auto grid = read_back(to_vtu(cells_of(bezier_pieces(quarter_ring({1, 2, 3})))));
  ASSERT_NE(grid->GetPointData()->GetRationalWeights(), nullptr);
  vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
  ASSERT_NE(degrees, nullptr);
  EXPECT_EQ(degrees->GetComponent(0, 0), 1);
  EXPECT_EQ(degrees->GetComponent(0, 1), 2);
  EXPECT_EQ(degrees->GetComponent(0, 2), 3);
}

TEST(VtkBezier, PiecesAreReadAsOneGrid) {
  const std::vector<NurbsVolume> pieces = bezier_pieces(quarter_ring({2, 3, 2}));
  std::string bytes;
  const std::vector<std::vector<NurbsVolume>> parts = {{pieces[0]}, {pieces[1], pieces[2]}, {pieces[3]}};
  write_vtu(
      {1, 2, 1}, [&](std::size_t i) { return cells_of(parts[i]); },
      [&](std::string_view more) { bytes += more; });
  const auto grid = read_back(bytes);
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  ASSERT_EQ(grid->GetNumberOfPoints(), 4 * 36);
  ASSERT_NE(grid->GetPointData()->GetRationalWeights(), nullptr);
  for (vtkIdType c = 0; c < 4; ++c) {
    const NurbsVolume& piece = pieces[static_cast<std::size_t>(c)];
    const Eigen::Vector3d t(0.3, 0.6, 0.8);
    const Eigen::Vector3d inside = piece.low().array() + t.array() * (piece.high() - piece.low()).array();
    EXPECT_LT((evaluate(grid, c, t).head(3) - piece.point(inside)).norm(), 1e-13);
  }
  const auto other = [&](std::size_t i) {
    return cells_of(bezier_pieces(quarter_ring({2, 3, i == 0 ? 2 : 3})));
  };
  EXPECT_THROW(write_vtu({4, 4}, other, [](std::string_view) {}), Error);
  EXPECT_THROW(write_vtu({3}, other, [](std::string_view) {}), Error);
}

TEST(VtkBezier, SinglePrecisionHalvesTheNumbersAndKeepsSevenDigits) {
  const BezierCells cells = cells_of(bezier_pieces(quarter_ring({3, 3, 3})));
  const std::string full = to_vtu(cells);
  const std::string single = to_vtu(cells, Precision::single);
  // Per point: 3 + 1 + 2 numbers at 8 bytes or 4, and the connectivity's 8.
  EXPECT_NEAR(static_cast<double>(full.size() - single.size()), 256 * 6 * 4 + 4 * 4, 64);
  const auto exact = read_back(full);
  const auto grid = read_back(single);
  for (vtkIdType c = 0; c < 4; ++c)
    EXPECT_LT((evaluate(grid, c, {0.2, 0.5, 0.9}) - evaluate(exact, c, {0.2, 0.5, 0.9})).norm(), 2e-5);
}

TEST(VtkBezier, NeedsNoWeightsWhereAllAreEqual) {
  const NurbsVolume cube = elevate_degree(elevate_degree(NurbsVolume(), 0, 1), 2, 2);
  BezierCells cells = cells_of({cube});
  cells.weights.resize(0);
  const auto grid = read_back(to_vtu(cells));
  EXPECT_EQ(grid->GetPointData()->GetRationalWeights(), nullptr);
  EXPECT_LT((evaluate(grid, 0, {0.2, 0.5, 0.9}).head(3) - Eigen::Vector3d(0.2, 0.5, 0.9)).norm(), 1e-14);
}

std::string message_of(const BezierCells& cells) {
  try {
    to_vtu(cells);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "no error";
}

TEST(VtkBezier, RefusesWhatDoesNotFit) {
  const BezierCells good = cells_of(bezier_pieces(quarter_ring({1, 2, 1})));
  EXPECT_EQ(message_of(good), "no error");
  BezierCells bad = good;
  bad.weights.conservativeResize(3);
  EXPECT_THAT(message_of(bad), HasSubstr("48 points and 3 weights for 4 cells"));
  bad = good;
  bad.weights[7] = 0;
  EXPECT_THAT(message_of(bad), HasSubstr("a weight is not positive"));
  bad = good;
  bad.point_fields[0].values(1, 3) = std::nan("");
  EXPECT_THAT(message_of(bad), HasSubstr("'displacement' has a value that is not finite"));
  bad = good;
  bad.cell_fields[0].values.resize(1, 3);
  EXPECT_THAT(message_of(bad), HasSubstr("'patch' has 1 x 3 values for 4 cells"));
  bad = good;
  bad.point_fields[0].name = "RationalWeights";
  EXPECT_THAT(message_of(bad), HasSubstr("'RationalWeights' is taken"));
}

TEST(VtkBezier, CollectionOpensItsFiles) {
  const auto folder = std::filesystem::temp_directory_path() / "isopatch_vtm_test";
  std::filesystem::create_directories(folder / "run");
  const std::vector<NurbsVolume> pieces = bezier_pieces(quarter_ring({1, 2, 1}));
  write_file(folder / "run/a.vtu", to_vtu(cells_of(pieces)));
  write_file(folder / "run/b.vtu", to_vtu(cells_of({pieces[0]})));
  write_file(folder / "all.vtm", to_vtm({{"patch <0>", "run/a.vtu"}, {"patch 1", "run/b.vtu"}}));
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName((folder / "all.vtm").c_str());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  ASSERT_NE(blocks, nullptr);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
  EXPECT_STREQ(blocks->GetMetaData(0u)->Get(vtkCompositeDataSet::NAME()), "patch <0>");
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0))->GetNumberOfCells(), 4);
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(1))->GetNumberOfCells(), 1);
  std::filesystem::remove_all(folder);
  EXPECT_THROW(to_vtm({{"a", "/tmp/a.vtu"}}), Error);
}

}  // namespace
}  // namespace isopatch::geometry

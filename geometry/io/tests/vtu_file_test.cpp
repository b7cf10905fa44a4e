#include "geometry/io/vtu_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkHexahedron.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;

// A quarter ring of radii 1 and 2 and height 3, exact, raised to `degree`, of 2 x 2 x 1 elements.
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

// The patch whose control points are the Bezier points of all elements.
NurbsVolume bezier_form(const NurbsVolume& patch) {
  NurbsVolume result = patch;
  for (int d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots(d).breaks();
    const std::vector<int> multiplicities = patch.knots(d).multiplicities();
    for (std::size_t b = 1; b + 1 < breaks.size(); ++b)
      if (multiplicities[b] < patch.degree(d))
        result = insert_knots(
            result, d, std::vector(static_cast<std::size_t>(patch.degree(d) - multiplicities[b]), breaks[b]));
  }
  return result;
}

VtuGrid grid_of(const NurbsVolume& net) {
  return {net.sizes(), {net.degree(0), net.degree(1), net.degree(2)}};
}

// The bytes of a file, whatever the order in which they come.
struct Bytes {
  std::string text;
  PlacedByteSink sink() {
    return [this](std::uint64_t place, std::string_view bytes) {
      text.resize(std::max<std::size_t>(text.size(), place + bytes.size()));
      std::copy(bytes.begin(), bytes.end(), text.begin() + static_cast<std::ptrdiff_t>(place));
    };
  }
};

const Eigen::Matrix<double, 2, 3> turning = (Eigen::Matrix<double, 2, 3>() << 1, 2, 3, -4, 5, -6).finished();

// Patches with a field whose coefficients are those of a spline: turned points.
std::string bezier_file(const std::vector<NurbsVolume>& patches, Precision precision = Precision::full) {
  std::vector<VtuGrid> grids;
  std::vector<int> numbers;
  for (const NurbsVolume& patch : patches) {
    grids.push_back(grid_of(bezier_form(patch)));
    numbers.push_back(10 + static_cast<int>(numbers.size()));
  }
  Bytes bytes;
  VtuFile file(VtuCell::bezier_hexahedron, grids,
               {{"RationalWeights", 1, precision}, {"displacement", 2, precision}}, {{"patch", numbers}},
               bytes.sink(), precision);
  std::int64_t first = 0;
  for (const NurbsVolume& patch : patches) {
    const NurbsVolume net = bezier_form(patch);
    file.points(first, net.control_points());
    file.field(0, first, net.weights().transpose());
    file.field(1, first, turning * net.control_points());
    first += net.size();
  }
  file.finish();
  return bytes.text;
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

// Largest error of VTK's places and fields in a patch of 2 x 2 x 1 elements whose cells begin at `first`.
double error(vtkUnstructuredGrid* grid, const NurbsVolume& patch, vtkIdType first = 0) {
  double result = 0;
  const std::vector<NurbsVolume> pieces = bezier_pieces(patch);
  for (vtkIdType c = 0; c < 4; ++c)
    for (const Eigen::Vector3d& t : {Eigen::Vector3d(0.1, 0.7, 0.4), Eigen::Vector3d(0, 0.25, 1),
                                     Eigen::Vector3d(0.9, 0.05, 0.85), Eigen::Vector3d(0.5, 1, 0.3)}) {
      const NurbsVolume& piece = pieces[static_cast<std::size_t>(c)];
      const Eigen::Vector3d inside = piece.low().array() + t.array() * (piece.high() - piece.low()).array();
      const Eigen::Vector3d x = piece.point(inside);
      Eigen::VectorXd exact(5);
      exact << x, turning * x;
      const double difference = (evaluate(grid, first + c, t) - exact).norm();
      if (!(difference <= result)) result = difference;
    }
  return result;
}

class BezierDegrees : public testing::TestWithParam<std::array<int, 3>> {};

TEST_P(BezierDegrees, VtkEvaluatesTheSameGeometryAndField) {
  const NurbsVolume patch = quarter_ring(GetParam());
  const auto grid = read_back(bezier_file({patch}));
  ASSERT_EQ(grid->GetNumberOfCells(), 4);
  // Elements share the points between them.
  EXPECT_EQ(grid->GetNumberOfPoints(), bezier_form(patch).size());
  EXPECT_EQ(grid->GetCellType(3), VTK_BEZIER_HEXAHEDRON);
  EXPECT_EQ(grid->GetCellData()->GetArray("patch")->GetTuple1(3), 10);
  // Some hundred operations on numbers below 32: far below 1e-12.
  EXPECT_LT(error(grid, patch), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(VtuFile, BezierDegrees,
                         testing::Values(std::array{1, 2, 1}, std::array{2, 2, 2}, std::array{3, 2, 1},
                                         std::array{2, 4, 3}, std::array{4, 3, 5}, std::array{1, 6, 2}));

TEST(VtuFile, PatchesOfDifferentDegreesAreOneGrid) {
  const NurbsVolume first = quarter_ring({2, 3, 2}), second = quarter_ring({1, 4, 3});
  const auto grid = read_back(bezier_file({first, second}));
  ASSERT_EQ(grid->GetNumberOfCells(), 8);
  ASSERT_NE(grid->GetPointData()->GetRationalWeights(), nullptr);
  vtkDataArray* degrees = grid->GetCellData()->GetHigherOrderDegrees();
  ASSERT_NE(degrees, nullptr);
  EXPECT_EQ(degrees->GetComponent(0, 1), 3);
  EXPECT_EQ(degrees->GetComponent(7, 1), 4);
  EXPECT_EQ(grid->GetCellData()->GetArray("patch")->GetTuple1(7), 11);
  EXPECT_LT(error(grid, first), 1e-12);
  EXPECT_LT(error(grid, second, 4), 1e-12);
}

// VTK takes older files to list the points of an edge in another order.
TEST(VtuFile, TheVersionIsTheOneWhoseOrderOfPointsIsWritten) {
  const NurbsVolume patch = quarter_ring({3, 3, 3});
  std::string text = bezier_file({patch});
  const auto at = text.find("version=\"2.2\"");
  ASSERT_NE(at, text.npos);
  text.replace(at, 13, "version=\"2.0\"");
  EXPECT_GT(error(read_back(text), patch), 0.01);
}

TEST(VtuFile, SinglePrecisionHalvesTheNumbersAndKeepsSevenDigits) {
  const NurbsVolume patch = quarter_ring({3, 3, 3});
  const std::string full = bezier_file({patch}), single = bezier_file({patch}, Precision::single);
  EXPECT_NEAR(static_cast<double>(full.size() - single.size()), bezier_form(patch).size() * 6 * 4, 64);
  EXPECT_LT(error(read_back(single), patch), 2e-5);
}

// Two unit cubes of 2 x 3 x 1 and 1 x 1 x 2 cells, the second one at x = 5.
struct Cubes {
  std::vector<VtuGrid> grids = {{{3, 4, 2}}, {{2, 2, 3}}};
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd(3, 36);
  Cubes() {
    Eigen::Index at = 0;
    for (const VtuGrid& grid : grids)
      for (int k = 0; k < grid.points[2]; ++k)
        for (int j = 0; j < grid.points[1]; ++j)
          for (int i = 0; i < grid.points[0]; ++i)
            points.col(at++) << (&grid == &grids[1] ? 5.0 : 0.0) + 1.0 * i / (grid.points[0] - 1),
                1.0 * j / (grid.points[1] - 1), 1.0 * k / (grid.points[2] - 1);
  }
};

TEST(VtuFile, HexahedraShareTheirNodesAndFillTheGrids) {
  const Cubes cubes;
  Bytes bytes;
  VtuFile file(VtuCell::hexahedron, cubes.grids, {{"x", 1}}, {{"patch", {7, 8}}, {"material", {0, 1}}},
               bytes.sink());
  file.points(0, cubes.points);
  file.field(0, 0, cubes.points.row(0));
  file.finish();
  const auto grid = read_back(bytes.text);
  ASSERT_EQ(grid->GetNumberOfPoints(), 36);
  ASSERT_EQ(grid->GetNumberOfCells(), 8);
  double volume = 0;
  for (vtkIdType c = 0; c < 8; ++c) {
    ASSERT_EQ(grid->GetCellType(c), VTK_HEXAHEDRON);
    // Corners 0, 1, 3, 4 span a brick, with a positive volume.
    const auto corner = [&](int i) {
      return Eigen::Vector3d(Eigen::Map<Eigen::Vector3d>(grid->GetCell(c)->GetPoints()->GetPoint(i)));
    };
    const Eigen::Vector3d o = corner(0), a = corner(1) - o, b = corner(3) - o, d = corner(4) - o;
    EXPECT_LT((corner(6) - (o + a + b + d)).norm(), 1e-15);
    volume += a.cross(b).dot(d);
    EXPECT_EQ(grid->GetCellData()->GetArray("patch")->GetTuple1(c), c < 6 ? 7 : 8);
    EXPECT_EQ(grid->GetCellData()->GetArray("material")->GetTuple1(c), c < 6 ? 0 : 1);
  }
  EXPECT_NEAR(volume, 2, 1e-14);
  EXPECT_EQ(grid->GetPointData()->GetArray("x")->GetTuple1(35), 6);
}

TEST(VtuFile, CellFieldsAreCountedGridByGrid) {
  const Cubes cubes;
  Bytes bytes;
  const VtuCellField numbers{"number", [](std::size_t grid, std::int64_t cell) {
                               return static_cast<float>(100 * static_cast<std::int64_t>(grid) + cell);
                             }};
  VtuFile file(VtuCell::hexahedron, cubes.grids, {}, {}, bytes.sink(), Precision::full, {numbers});
  file.points(0, cubes.points);
  file.finish();
  const auto grid = read_back(bytes.text);
  for (vtkIdType c = 0; c < 8; ++c)
    EXPECT_EQ(grid->GetCellData()->GetArray("number")->GetTuple1(c), c < 6 ? double(c) : 94 + double(c));
  const VtuCellField nothing{"gone", [](std::size_t, std::int64_t) { return std::nanf(""); }};
  Bytes ignored;
  VtuFile broken(VtuCell::hexahedron, cubes.grids, {}, {}, ignored.sink(), Precision::full, {nothing});
  broken.points(0, cubes.points);
  EXPECT_ERROR(broken.finish(), ErrorCode::invalid_argument, "'gone' has a value that is not finite");
}

TEST(VtuFile, NumbersMayComeInAnyOrder) {
  const Cubes cubes;
  const auto written = [&](std::vector<Eigen::Index> starts) {
    Bytes bytes;
    VtuFile file(VtuCell::hexahedron, cubes.grids, {{"x", 3}}, {}, bytes.sink());
    for (const Eigen::Index start : starts) file.points(start, cubes.points.middleCols(start, 12));
    for (const Eigen::Index start : starts) file.field(0, start, 2 * cubes.points.middleCols(start, 12));
    file.finish();
    return bytes.text;
  };
  EXPECT_EQ(written({0, 12, 24}), written({24, 0, 12}));
}

TEST(VtuFile, QuadrilateralsLookWhereTheyShould) {
  for (const bool turned : {false, true}) {
    Bytes bytes;
    VtuFile file(VtuCell::quadrilateral, {{{2, 2, 1}, {1, 1, 1}, turned}}, {}, {}, bytes.sink());
    file.points(0, (Eigen::Matrix3Xd(3, 4) << 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0).finished());
    file.finish();
    const auto grid = read_back(bytes.text);
    ASSERT_EQ(grid->GetNumberOfCells(), 1);
    ASSERT_EQ(grid->GetCellType(0), VTK_QUAD);
    vtkPoints* points = grid->GetCell(0)->GetPoints();
    const auto corner = [&](int i) {
      return Eigen::Vector3d(Eigen::Map<Eigen::Vector3d>(points->GetPoint(i)));
    };
    const Eigen::Vector3d o = corner(0);
    EXPECT_EQ((corner(1) - o).cross(corner(2) - o)[2], turned ? -1 : 1);
  }
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return "no error";
}

TEST(VtuFile, RefusesWhatDoesNotFit) {
  const auto open = [](VtuCell cell, const std::vector<VtuGrid>& grids, const std::vector<VtuField>& fields,
                       const std::vector<VtuLabel>& labels) {
    return message_of([&] { VtuFile(cell, grids, fields, labels, [](std::uint64_t, std::string_view) {}); });
  };
  const VtuGrid cube{{2, 2, 2}};
  EXPECT_EQ(open(VtuCell::hexahedron, {cube}, {{"a"}}, {}), "no error");
  EXPECT_THAT(open(VtuCell::hexahedron, {}, {}, {}), HasSubstr("no grid"));
  EXPECT_THAT(open(VtuCell::hexahedron, {{{2, 1, 2}}}, {}, {}), HasSubstr("1 points along direction 2"));
  EXPECT_THAT(open(VtuCell::bezier_hexahedron, {{{4, 3, 3}, {2, 2, 2}}}, {}, {}),
              HasSubstr("4 points along direction 1 for cells of degree 2"));
  EXPECT_THAT(open(VtuCell::hexahedron, {cube}, {{"a"}, {"a"}}, {}), HasSubstr("'a' is taken"));
  EXPECT_THAT(open(VtuCell::hexahedron, {cube}, {{"b"}, {""}}, {}), HasSubstr("a field has no name"));
  EXPECT_THAT(open(VtuCell::hexahedron, {cube}, {{"HigherOrderDegrees"}}, {}), HasSubstr("is taken"));
  EXPECT_THAT(open(VtuCell::hexahedron, {cube}, {}, {{"patch", {1, 2}}}), HasSubstr("2 values for 1 grids"));
  VtuFile file(VtuCell::hexahedron, {cube}, {{"a"}}, {}, [](std::uint64_t, std::string_view) {});
  EXPECT_THAT(message_of([&] { file.field(0, 0, Eigen::MatrixXd::Constant(1, 8, std::nan(""))); }),
              HasSubstr("'a' has a value that is not finite"));
  EXPECT_THAT(message_of([&] { file.field(0, 0, Eigen::MatrixXd::Constant(1, 8, 1e300)); }),
              HasSubstr("too large for single precision"));
  EXPECT_THAT(message_of([&] { file.field(0, 0, Eigen::MatrixXd::Zero(2, 8)); }),
              HasSubstr("2 components where 1"));
}

}  // namespace
}  // namespace isopatch::geometry

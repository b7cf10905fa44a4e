// Whole runs, their files for ParaView put through VTK's own filters and held against the stored solution.

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkAppendFilter.h>
#include <vtkCellData.h>
#include <vtkCompositeDataIterator.h>
#include <vtkContourFilter.h>
#include <vtkCutter.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkGenericCell.h>
#include <vtkGeometryFilter.h>
#include <vtkInformation.h>
#include <vtkLineSource.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkProbeFilter.h>
#include <vtkTableBasedClipDataSet.h>
#include <vtkThreshold.h>
#include <vtkTriangleFilter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/program.hpp"
#include "app/results/stored_results.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"

namespace isopatch::verification {
namespace {

using Eigen::Vector3d;
using geometry::Parameter;

// The blocks of a collection with their names, groups gone.
struct Block {
  std::string group, name;
  vtkSmartPointer<vtkUnstructuredGrid> grid;
};

std::vector<Block> blocks_of(const std::filesystem::path& collection) {
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(collection.c_str());
  reader->Update();
  auto* groups = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  std::vector<Block> result;
  for (unsigned g = 0; g < groups->GetNumberOfBlocks(); ++g) {
    auto* blocks = vtkMultiBlockDataSet::SafeDownCast(groups->GetBlock(g));
    for (unsigned b = 0; b < blocks->GetNumberOfBlocks(); ++b)
      result.push_back({groups->GetMetaData(g)->Get(vtkCompositeDataSet::NAME()),
                        blocks->GetMetaData(b)->Get(vtkCompositeDataSet::NAME()),
                        vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(b))});
  }
  return result;
}

// All blocks as one grid, points in the same place being one.
vtkSmartPointer<vtkUnstructuredGrid> merged(const std::vector<Block>& blocks) {
  vtkNew<vtkAppendFilter> append;
  append->MergePointsOn();
  append->SetTolerance(0);
  for (const Block& block : blocks) append->AddInputData(block.grid);
  append->Update();
  return append->GetOutput();
}

Vector3d point(vtkDataSet* data, vtkIdType i) {
  Vector3d result;
  data->GetPoint(i, result.data());
  return result;
}

double value(vtkDataSet* data, const char* field, vtkIdType i, int component = 0) {
  return data->GetPointData()->GetArray(field)->GetComponent(i, component);
}

vtkSmartPointer<vtkPolyData> triangles(vtkPolyData* surface) {
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(surface);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> surface_of(vtkDataSet* data) {
  vtkNew<vtkGeometryFilter> filter;
  filter->SetInputData(data);
  filter->Update();
  return triangles(vtkPolyData::SafeDownCast(filter->GetOutput()));
}

// Calls visit(corners, twice the area times the normal) for each triangle.
template <class Visit>
void for_each_triangle(vtkPolyData* surface, Visit visit) {
  for (vtkIdType c = 0; c < surface->GetNumberOfCells(); ++c) {
    vtkIdList* ids = surface->GetCell(c)->GetPointIds();
    const std::array<vtkIdType, 3> corners = {ids->GetId(0), ids->GetId(1), ids->GetId(2)};
    const Vector3d a = point(surface, corners[0]), b = point(surface, corners[1]),
                   d = point(surface, corners[2]);
    visit(corners, (b - a).cross(d - a));
  }
}

double area_of(vtkPolyData* surface) {
  double result = 0;
  for_each_triangle(surface, [&](const auto&, const Vector3d& normal) { result += normal.norm() / 2; });
  return result;
}

double volume_inside(vtkPolyData* surface) {
  double result = 0;
  for_each_triangle(surface, [&](const auto& corners, const Vector3d& normal) {
    result += point(surface, corners[0]).dot(normal) / 6;
  });
  return result;
}

vtkIdType open_edges(vtkPolyData* surface) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->BoundaryEdgesOn();
  edges->NonManifoldEdgesOn();
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

// A folder of results that goes at the end.
struct Results {
  explicit Results(const std::string& example, std::vector<std::string> more = {})
      : directory(std::filesystem::path(::testing::TempDir()) /
                  ("isopatch_paraview_" + example + "_" + std::to_string(::getpid()))) {
    std::ostringstream out, err;
    const std::string study = std::string(ISOPATCH_SOURCE_DIR) + "/examples/" + example + "/study.toml";
    std::vector<std::string> words = {"run",     study,   "--output",           directory.string(),
                                      "--quiet", "--set", "output.report=false"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(app::run_program(words, {out, err}), 0) << err.str();
    summary = nlohmann::json::parse(read_file(directory / "summary.json"));
    stored = iga::read_result(directory / "results.h5");
    cells = blocks_of(directory / "results.vtm");
    whole = merged(cells);
    surface = surface_of(whole);
  }
  ~Results() { std::filesystem::remove_all(directory); }
  double number(const char* key) const { return summary.at(nlohmann::json::json_pointer(key)).get<double>(); }

  std::filesystem::path directory;
  nlohmann::json summary;
  iga::StoredResult stored;
  std::vector<Block> cells;
  vtkSmartPointer<vtkUnstructuredGrid> whole;
  vtkSmartPointer<vtkPolyData> surface;
};

const Results& link() {
  static const Results results("link");
  return results;
}

const Results& pipes() {
  static const Results results("pipe_joint");
  return results;
}

// What the probe command finds in the link.
app::StoredValues probed(const Vector3d& place) {
  app::StoredProbe where;
  where.point = place;
  return app::probe(link().stored, where);
}

// How far a von Mises stress in the link is from what the probe command finds within 20 um: at interfaces of
// patches the stress jumps, both sides are right, and straight pieces pass curved ones by up to their
// sagitta.
double off_by(double von_mises, const Vector3d& place) {
  constexpr double beside = 60e-6;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Vector3d& step : {Vector3d(0, 0, 0), Vector3d(beside, 0, 0), Vector3d(-beside, 0, 0),
                               Vector3d(0, beside, 0), Vector3d(0, -beside, 0)})
    try {
      smallest = smaller(smallest, std::abs(probed(place + step).values.von_mises - von_mises));
    } catch (const Error&) {  // outside of the part
    }
  return smallest;
}

vtkSmartPointer<vtkPolyData> slice(vtkDataSet* data, const Vector3d& origin, const Vector3d& normal) {
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  vtkNew<vtkCutter> cutter;
  cutter->SetInputData(data);
  cutter->SetCutFunction(plane);
  cutter->Update();
  return triangles(cutter->GetOutput());
}

TEST(ParaviewFields, VolumeAndAreaAreThePartsWithinHalfAPercent) {
  for (const Results* results : {&link(), &pipes()}) {
    EXPECT_NEAR(volume_inside(results->surface) / results->number("/model/volume"), 1, 0.005);
    EXPECT_NEAR(area_of(results->surface) / results->number("/model/boundary_area"), 1, 0.005);
  }
}

TEST(ParaviewFields, MergedBlocksAreClosed) {
  for (const Results* results : {&link(), &pipes()}) {
    EXPECT_EQ(open_edges(results->surface), 0);
    vtkIdType points = 0;
    for (const Block& block : results->cells) points += block.grid->GetNumberOfPoints();
    EXPECT_LT(results->whole->GetNumberOfPoints(), points);
  }
}

TEST(ParaviewFields, BlocksAreNamedByMaterialAndPatch) {
  const std::vector<Block>& blocks = pipes().cells;
  ASSERT_EQ(blocks.size(), 16u);
  std::vector<std::string> groups;
  for (const Block& block : blocks) {
    groups.push_back(block.group);
    const auto patch = static_cast<int>(block.grid->GetCellData()->GetArray("patch")->GetTuple1(0));
    EXPECT_EQ(block.name, "patch " + std::to_string(patch));
    EXPECT_EQ(block.group, pipes().stored.field.materials[static_cast<std::size_t>(patch)].name);
  }
  for (const char* material : {"steel", "copper", "brass"})
    EXPECT_THAT(groups, ::testing::Contains(material));
}

TEST(ParaviewFields, EveryNodeHasTheSolution) {
  const iga::ElasticField& field = link().stored.field;
  const double stress = link().number("/results/max_von_mises"),
               far = link().number("/results/max_displacement");
  for (std::size_t p = 0; p < field.patches.size(); p += 3)
    for (vtkIdType i = 7; i < link().cells[p].grid->GetNumberOfPoints(); i += 97) {
      vtkUnstructuredGrid* grid = link().cells[p].grid;
      const iga::Location at =
          iga::locate(iga::ElasticField{{field.patches[p]}, {field.displacement[p]}, {field.materials[p]}},
                      point(grid, i));
      ASSERT_LT(at.distance, 1e-9);
      const iga::FieldValues exact = iga::evaluate(field, static_cast<int>(p), at.parameter);
      // Single precision, and a place found to a billionth.
      EXPECT_NEAR(value(grid, "displacement", i, 1), exact.displacement[1], 1e-6 * far);
      EXPECT_NEAR(value(grid, "stress", i, 0), exact.stress(0, 0), 1e-5 * stress);
      EXPECT_NEAR(value(grid, "stress", i, 4), exact.stress(1, 2), 1e-5 * stress);
      EXPECT_NEAR(value(grid, "strain", i, 5), exact.strain(0, 2), 1e-5 * exact.strain.norm() + 1e-9);
      EXPECT_NEAR(value(grid, "von_mises", i), exact.von_mises, 1e-5 * stress);
    }
}

TEST(ParaviewFields, VonMisesIsNeverNegativeAndReachesThePeak) {
  for (const Results* results : {&link(), &pipes()}) {
    std::array<double, 2> range{};
    results->whole->GetPointData()->GetArray("von_mises")->GetRange(range.data());
    EXPECT_GE(range[0], 0);
    EXPECT_GE(range[1], 0.97 * results->number("/results/max_von_mises"));
  }
}

TEST(ParaviewFields, ASliceLiesInItsPlaneAndCarriesTheLoad) {
  const Vector3d origin(0.05, 0, 0), normal = Vector3d::UnitX();
  const auto cut = slice(link().whole, origin, normal);
  ASSERT_GT(cut->GetNumberOfCells(), 100);
  double area = 0;
  Vector3d force = Vector3d::Zero();
  for_each_triangle(cut, [&](const std::array<vtkIdType, 3>& corners, const Vector3d& twice) {
    for (const vtkIdType c : corners) {
      EXPECT_LT(std::abs((point(cut, c) - origin).dot(normal)), 1e-12);
      const Vector3d traction(value(cut, "stress", c, 0), value(cut, "stress", c, 3),
                              value(cut, "stress", c, 5));
      force += twice.norm() / 6 * traction;
    }
    area += twice.norm() / 2;
  });
  // The shank is 16 mm x 12 mm there.
  EXPECT_NEAR(area / 192e-6, 1, 1e-3);
  EXPECT_NEAR(force[0], 10e3, 0.01 * 10e3);
  EXPECT_NEAR(force[1], -2e3, 0.01 * 2e3);
}

TEST(ParaviewFields, ALineOfProbesFindsWhatTheProbeCommandFinds) {
  vtkNew<vtkLineSource> line;
  line->SetPoint1(-0.019, 0.001, 0.004);
  line->SetPoint2(0.113, 0.001, 0.004);
  line->SetResolution(100);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputConnection(line->GetOutputPort());
  probe->SetSourceData(link().whole);
  probe->Update();
  vtkDataSet* found = probe->GetOutput();
  int inside = 0;
  for (vtkIdType i = 0; i <= 100; ++i) {
    if (found->GetPointData()->GetArray("vtkValidPointMask")->GetTuple1(i) == 0) continue;
    ++inside;
    const app::StoredValues exact = probed(point(found, i));
    // Between nodes of straight pieces the field is interpolated: 1 % of what it has at its largest.
    EXPECT_LT(off_by(value(found, "von_mises", i), point(found, i)),
              0.01 * link().number("/results/max_von_mises"))
        << i;
    EXPECT_NEAR(value(found, "displacement", i, 1), exact.values.displacement[1],
                0.01 * link().number("/results/max_displacement"));
  }
  // All but the two bores, 20 and 14 mm of 132 mm.
  EXPECT_NEAR(inside, 101 - 26, 2);
}

TEST(ParaviewFields, ThresholdAndClipKeepToTheirBounds) {
  const double limit = 0.3 * link().number("/results/max_von_mises");
  vtkNew<vtkThreshold> threshold;
  threshold->SetInputData(link().whole);
  threshold->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "von_mises");
  threshold->SetThresholdFunction(vtkThreshold::THRESHOLD_UPPER);
  threshold->SetUpperThreshold(limit);
  threshold->Update();
  EXPECT_GT(threshold->GetOutput()->GetNumberOfCells(), 100);

  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.03, 0, 0);
  plane->SetNormal(1, 0, 0);
  vtkNew<vtkTableBasedClipDataSet> clip;
  clip->SetInputData(link().whole);
  clip->SetClipFunction(plane);
  clip->Update();
  std::array<double, 6> bounds{};
  clip->GetOutput()->GetBounds(bounds.data());
  EXPECT_NEAR(bounds[0], 0.03, 1e-8);
  EXPECT_NEAR(bounds[1], 0.114, 1e-4);
}

// How far the points of a contour in a patch are from having its value there, at worst.
double worst_of_contour(const iga::ElasticField& field, std::size_t patch, vtkUnstructuredGrid* grid,
                        double level) {
  vtkNew<vtkContourFilter> contour;
  contour->SetInputData(grid);
  contour->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "von_mises");
  contour->SetValue(0, level);
  contour->Update();
  const iga::ElasticField alone{
      {field.patches[patch]}, {field.displacement[patch]}, {field.materials[patch]}};
  double worst = 0;
  for (vtkIdType i = 0; i < contour->GetOutput()->GetNumberOfPoints(); ++i) {
    // The nearest point of the patch: chords of a hollow surface lie outside of it.
    const iga::Location at = iga::locate(alone, point(contour->GetOutput(), i));
    worst = larger(worst, std::abs(iga::evaluate(alone, 0, at.parameter).von_mises - level));
  }
  return worst;
}

TEST(ParaviewFields, ContoursOfVonMisesHaveTheirValueToOnePercentOfTheLargest) {
  for (const Results* results : {&link(), &pipes()}) {
    const double largest = results->number("/results/max_von_mises");
    for (const Block& block : results->cells) {
      const auto patch = static_cast<std::size_t>(block.grid->GetCellData()->GetArray("patch")->GetTuple1(0));
      for (int tenth = 1; tenth < 10; ++tenth)
        EXPECT_LT(worst_of_contour(results->stored.field, patch, block.grid, 0.1 * tenth * largest),
                  0.01 * largest)
            << block.name << " at " << tenth << " tenths";
    }
  }
}

TEST(ParaviewFields, SupportsLoadsAndBoundariesAreSurfacesThatLookOut) {
  const std::vector<Block> faces = blocks_of(link().directory / "results_boundaries.vtm");
  std::set<std::string> names;
  double outward = 0;
  for (const Block& block : faces) {
    names.insert(block.group + "/" + block.name);
    const auto surface = surface_of(block.grid);
    if (block.group != "boundaries") {
      const double area = link().number(block.group == "supports" ? "/supports/0/area" : "/loads/0/area");
      EXPECT_NEAR(area_of(surface) / area, 1, 0.005);
    }
    EXPECT_GT(value(block.grid, "von_mises", 0), 0);
    for_each_triangle(surface, [&](const auto& corners, const Vector3d& normal) {
      if (block.name == "bore_left") outward += normal.dot(point(surface, corners[0]));
    });
  }
  EXPECT_THAT(names,
              ::testing::IsSupersetOf({"supports/left bore", "loads/right bore", "boundaries/bore_left"}));
  // The bore is about the origin: out of the part is towards its axis. Twice its area times its radius.
  EXPECT_NEAR(outward / (-2 * 7.54e-4 * 0.01), 1, 0.01);
}

// VTK's own evaluation of a field of a Bezier cell at parameters in [0, 1]^3.
Eigen::VectorXd evaluate(vtkUnstructuredGrid* grid, vtkIdType index, const Parameter<3>& t,
                         const char* field) {
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(index, cell);
  std::vector<double> basis(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  Vector3d place;
  int sub_cell = 0;
  cell->EvaluateLocation(sub_cell, t.data(), place.data(), basis.data());
  if (!field) return place;
  vtkDataArray* values = grid->GetPointData()->GetArray(field);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values->GetNumberOfComponents());
  for (std::size_t i = 0; i < basis.size(); ++i)
    for (Eigen::Index c = 0; c < result.size(); ++c)
      result[c] +=
          basis[i] * values->GetComponent(cell->GetPointId(static_cast<vtkIdType>(i)), static_cast<int>(c));
  return result;
}

// Parameter of the patch at parameters of its element, elements counted with the first direction fastest.
Parameter<3> in_patch(const geometry::NurbsVolume& patch, int element, const Parameter<3>& t) {
  Parameter<3> result;
  for (int d = 0; d < 3; ++d) {
    const auto breaks = patch.knots(d).breaks();
    const auto e = static_cast<std::size_t>(element % patch.knots(d).element_count());
    element /= patch.knots(d).element_count();
    result[d] = breaks[e] + t[d] * (breaks[e + 1] - breaks[e]);
  }
  return result;
}

TEST(ParaviewFields, ExactCellsAreTheSolutionAndShareTheirPoints) {
  const iga::ElasticField& field = link().stored.field;
  const std::vector<Block> blocks = blocks_of(link().directory / "results_exact.vtm");
  ASSERT_EQ(blocks.size(), field.patches.size());
  const Parameter<3> anywhere(0.17, 0.62, 0.88), node(1.0 / 3, 2.0 / 3, 1);
  for (std::size_t p = 0; p < blocks.size(); ++p) {
    vtkUnstructuredGrid* grid = blocks[p].grid;
    const geometry::NurbsVolume& patch = field.patches[p];
    ASSERT_EQ(grid->GetNumberOfCells(), 8);
    EXPECT_EQ(grid->GetNumberOfPoints(), 7 * 7 * 7);
    ASSERT_NE(grid->GetPointData()->GetRationalWeights(), nullptr) << "all blocks have weights";
    EXPECT_EQ(grid->GetPointData()->GetArray("von_mises"), nullptr) << "it is no polynomial";
    for (int element = 0; element < 8; ++element) {
      const iga::FieldValues exact =
          iga::evaluate(field, static_cast<int>(p), in_patch(patch, element, anywhere));
      EXPECT_LT((evaluate(grid, element, anywhere, nullptr) - exact.place).norm(), 1e-8 * 0.1);
      EXPECT_LT((evaluate(grid, element, anywhere, "displacement") - exact.displacement).norm(),
                1e-8 * 5.8e-4);
      const iga::FieldValues at = iga::evaluate(field, static_cast<int>(p), in_patch(patch, element, node));
      const Eigen::VectorXd stress = evaluate(grid, element, node, "stress");
      EXPECT_LT((stress.head<3>() - at.stress.diagonal()).norm(), 1e-8 * 3.4e8);
      EXPECT_NEAR(stress[5], at.stress(0, 2), 1e-8 * 3.4e8);
    }
  }
}

// More patches than blocks: one block a material, patches as numbers of cells.
TEST(ParaviewFields, ManyPatchesAreFewFiles) {
  const auto directory = std::filesystem::path(::testing::TempDir()) / "isopatch_paraview_many";
  std::filesystem::create_directories(directory);
  write_file(directory / "study.toml", R"(
[model]
generate = "box"
patches = [6, 6, 3]
[[material]]
name = "steel"
young = "210 GPa"
poisson = 0.3
[[support]]
faces = ["x_min"]
displacement = [0, 0, 0]
[[load]]
faces = ["x_max"]
traction = ["1 MPa", 0, 0]
)");
  std::ostringstream out, err;
  ASSERT_EQ(app::run_program({"run", (directory / "study.toml").string(), "-q", "--set", "output.pieces=2"},
                             {out, err}),
            0)
      << err.str();
  for (const char* collection : {"results.vtm", "results_exact.vtm"}) {
    const std::vector<Block> blocks = blocks_of(directory / "results" / collection);
    ASSERT_EQ(blocks.size(), 1u) << collection;
    EXPECT_EQ(blocks[0].group, "steel");
    EXPECT_EQ(blocks[0].name, "108 patches");
    std::array<double, 2> range{};
    blocks[0].grid->GetCellData()->GetArray("patch")->GetRange(range.data());
    EXPECT_EQ(range[1], 107);
  }
  const auto whole = merged(blocks_of(directory / "results/results.vtm"));
  EXPECT_EQ(whole->GetNumberOfPoints(), 108 * 27);  // shared within a patch
  EXPECT_NEAR(volume_inside(surface_of(whole)), 1, 1e-9);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace isopatch::verification

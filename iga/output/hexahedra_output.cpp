#include "iga/output/hexahedra_output.hpp"

#include <algorithm>

#include "geometry/io/vtu_file.hpp"
#include "iga/output/internal/error_cells.hpp"
#include "iga/spaces/internal/patch_batches.hpp"

namespace isopatch::iga {
namespace {

using geometry::Side;
using Points = Eigen::Matrix3Xd;

const std::vector<geometry::VtuField> fields = {{"displacement", 3},   {"strain", 6},           {"stress", 6},
                                                {"von_mises", 1},      {"principal_stress", 3}, {"tresca", 1},
                                                {"scaled_jacobian", 1}};

std::vector<geometry::GridParameters<3>> grids_of(const ElasticField& field,
                                                  const geometry::MultiPatch& model, int least) {
  const std::vector<ElementPieces> pieces = straight_pieces(model, field.patches, least);
  std::vector<geometry::GridParameters<3>> result;
  for (std::size_t p = 0; p < pieces.size(); ++p) result.push_back(grid_of(field.patches[p], pieces[p]));
  return result;
}

geometry::VtuGrid vtu_grid(const geometry::GridParameters<3>& grid) {
  return {
      {static_cast<int>(grid[0].size()), static_cast<int>(grid[1].size()), static_cast<int>(grid[2].size())}};
}

// The nodes on a patch's faces, the same for all patches that share them.
class PatchSurface {
 public:
  PatchSurface(const SurfacePoints& surface, int patch, const std::array<int, 3>& sizes) : sizes_(sizes) {
    for (const Side side : geometry::all_sides)
      faces_[static_cast<std::size_t>(side)] = surface.face(patch, side);
  }
  // Puts them in their places of plane k of direction 3.
  void put(Eigen::Index k, Points& plane) const {
    const Eigen::Index m = sizes_[0], n = sizes_[1], o = sizes_[2];
    for (Eigen::Index j = 0; j < n; ++j) {
      plane.col(m * j) = of(Side::west).col(j + n * k);
      plane.col(m * j + m - 1) = of(Side::east).col(j + n * k);
    }
    plane.leftCols(m) = of(Side::south).middleCols(m * k, m);
    plane.rightCols(m) = of(Side::north).middleCols(m * k, m);
    if (k == 0) plane = of(Side::front);
    if (k == o - 1) plane = of(Side::back);
  }

 private:
  const Points& of(Side side) const { return faces_[static_cast<std::size_t>(side)]; }
  std::array<int, 3> sizes_;
  std::array<Points, 6> faces_;
};

void write_plane(const FieldPlane& plane, std::int64_t first, geometry::VtuFile& file) {
  file.points(first, plane.points);
  file.field(0, first, plane.displacement);
  file.field(1, first, plane.strain);
  file.field(2, first, plane.stress);
  file.field(3, first, plane.von_mises);
  file.field(4, first, plane.principal);
  file.field(5, first, plane.tresca);
  file.field(6, first, plane.scaled_jacobian);
}

}  // namespace

std::vector<int> material_numbers(const ElasticField& field) {
  std::vector<Material> known;
  std::vector<int> result;
  for (const Material& material : field.materials) {
    const auto same = [&](const Material& other) {
      return other.name == material.name && other.lambda == material.lambda && other.mu == material.mu &&
             other.density == material.density;
    };
    const auto at = std::find_if(known.begin(), known.end(), same);
    result.push_back(static_cast<int>(at - known.begin()));
    if (at == known.end()) known.push_back(material);
  }
  return result;
}

HexahedraOutput::HexahedraOutput(const ElasticField& field, const geometry::MultiPatch& model, int least,
                                 const std::optional<FitOptions>& fit)
    : field_(field),
      materials_(material_numbers(field)),
      grids_(grids_of(field, model, least)),
      fit_(fit ? std::optional(fit_grids(field, model, *fit, grids_)) : std::nullopt),
      surface_(model, field.patches, grids_) {}

BorrowedStress HexahedraOutput::write(const std::vector<int>& patches,
                                      const geometry::PlacedByteSink& sink) const {
  std::vector<geometry::VtuGrid> grids;
  std::vector<geometry::GridParameters<3>> parameters;
  std::vector<int> materials;
  std::vector<std::int64_t> first = {0};
  for (const int p : patches) {
    parameters.push_back(grids_[static_cast<std::size_t>(p)]);
    grids.push_back(vtu_grid(parameters.back()));
    materials.push_back(materials_[static_cast<std::size_t>(p)]);
    first.push_back(first.back() + grids.back().point_count());
  }
  geometry::VtuFile file(geometry::VtuCell::hexahedron, grids, fields,
                         {{"patch", patches}, {"material", materials}}, sink, geometry::Precision::full,
                         error_cells(field_, patches, parameters));
  BorrowedStress borrowed;
  for_each_plane<FieldPlane>(
      first,
      [&](std::size_t i, const auto& take) {
        PlaneFields planes(field_, patches[i], grids_[static_cast<std::size_t>(patches[i])]);
        const PatchSurface surface(surface_, patches[i], grids[i].points);
        const std::int64_t size = std::int64_t{grids[i].points[0]} * grids[i].points[1];
        for (int k = 0; k < grids[i].points[2]; ++k) {
          FieldPlane& plane = planes.plane(k);
          surface.put(k, plane.points);
          take(plane, first[i] + size * k);
        }
      },
      [&](const FieldPlane& plane, std::int64_t at) {
        write_plane(plane, at, file);
        borrowed.add(plane.borrowed);
      });
  file.finish();
  return borrowed;
}

void HexahedraOutput::write_faces(const std::vector<geometry::PatchFace>& faces,
                                  const geometry::PlacedByteSink& sink) const {
  std::vector<geometry::VtuGrid> grids;
  std::vector<int> patches, materials;
  std::vector<std::array<std::vector<double>, 3>> parameters;
  for (const geometry::PatchFace& face : faces) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    const auto d = static_cast<std::size_t>(direction(face.side));
    const auto tangents = geometry::tangents(face.side);
    parameters.push_back(grids_[p]);
    parameters.back()[d] = {is_high(face.side) ? grids_[p][d].back() : grids_[p][d].front()};
    const auto count = [&](int t) { return static_cast<int>(grids_[p][static_cast<std::size_t>(t)].size()); };
    // The tangents' cross product looks along the third direction but for direction 2, and high ends look
    // out.
    grids.push_back({{count(tangents[0]), count(tangents[1]), 1}, {1, 1, 1}, (d == 1) == is_high(face.side)});
    patches.push_back(face.patch.value);
    materials.push_back(materials_[p]);
  }
  geometry::VtuFile file(geometry::VtuCell::quadrilateral, grids, fields,
                         {{"patch", patches}, {"material", materials}}, sink);
  std::int64_t first = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    PlaneFields planes(field_, patches[f], parameters[f]);
    const Points points = surface_.face(patches[f], faces[f].side);
    std::int64_t done = 0;
    for (int k = 0; k < planes.sizes()[2]; ++k) {
      FieldPlane& plane = planes.plane(k);
      plane.points = points.middleCols(done, plane.points.cols());
      write_plane(plane, first + done, file);
      done += plane.points.cols();
    }
    first += done;
  }
  file.finish();
}

}  // namespace isopatch::iga

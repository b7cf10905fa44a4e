#include "geometry/io/read_mfem_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "geometry/io/mfem_numbering.hpp"
#include "geometry/io/mfem_topology.hpp"
#include "geometry/io/reader_limits.hpp"
#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {
namespace {

constexpr int max_attribute = 2'000'000'000;
constexpr int cube = 5;    // MFEM's number of a hexahedron
constexpr int square = 3;  // and of a quadrilateral

class MfemReader {
 public:
  MfemReader(std::string_view text, const std::string& source) : in_(text, source, 1, '#') {}

  PatchSet read() {
    read_head();
    read_topology();
    PatchSet result;
    if (in_.peek() == "patches")
      result.patches = read_patches();
    else
      result.patches = read_numbered();
    result.boundaries = mfem_boundaries(topology_, in_.source());
    result.interfaces = mfem_interfaces(topology_);
    return result;
  }

 private:
  void read_head() {
    in_.expect("MFEM");
    in_.expect("NURBS");
    meets_in_parts_ = in_.peek() == "NC-patch";
    if (meets_in_parts_) in_.word("'NC-patch'");
    in_.expect("mesh");
    const std::string_view version = in_.word("the version");
    if (version != "v1.0" && (version != "v1.1" || meets_in_parts_))
      in_.fail(fmt::format("version {}; v1.0{} supported", quoted(version),
                           meets_in_parts_ ? " of NC-patch meshes is" : " and v1.1 are"),
               ErrorCode::unsupported);
    has_spacing_ = version == "v1.1" || meets_in_parts_;
    in_.expect("dimension");
    if (const int dimension = in_.integer("the dimension", 1, 3); dimension != 3)
      in_.fail(fmt::format("a mesh of dimension {}; volumes (dimension 3) are needed", dimension),
               ErrorCode::unsupported);
  }

  template <std::size_t N>
  std::array<int, N> vertices() {
    std::array<int, N> result{};
    for (int& v : result) v = in_.integer("a vertex", 0, max_control_points);
    return result;
  }

  int shape(int wanted, const char* name) {
    const int attribute = in_.integer("an attribute", -max_attribute, max_attribute);
    if (const int type = in_.integer("a geometry type", 0, 100); type != wanted)
      in_.fail(fmt::format("geometry type {}; {} ({}) is supported here", type, wanted, name),
               ErrorCode::unsupported);
    return attribute;
  }

  void read_topology() {
    in_.expect("elements");
    const int patches = in_.integer("the number of elements (patches)", 1, max_patches);
    const int first_line = in_.line();
    for (int p = 0; p < patches; ++p) {
      if (meets_in_parts_) in_.integer("the rank of an element", 0, max_attribute);
      shape(cube, "cube");
      if (meets_in_parts_ && in_.integer("the refinement of an element", 0, 100) != 0)
        in_.fail("elements (patches) that are divided into others are not supported", ErrorCode::unsupported);
      topology_.patches.push_back(vertices<8>());
    }
    in_.expect("boundary");
    const int boundary = in_.integer("the number of boundary elements", 0, 6 * max_patches);
    for (int b = 0; b < boundary; ++b) {
      const int attribute = shape(square, "square");
      topology_.boundary.push_back({attribute, vertices<4>(), in_.line()});
    }
    if (meets_in_parts_) read_hanging_vertices();
    in_.expect("edges");
    edges_line_ = in_.line();
    const int edges = in_.integer("the number of edges", 0, 12 * max_patches);
    for (int e = 0; e < edges; ++e) {
      const int knots = in_.integer("a knot vector's number", 0, 12 * max_patches);
      const auto [from, to] = vertices<2>();
      topology_.edges.push_back({knots, from, to});
    }
    if (!meets_in_parts_) {
      in_.expect("vertices");
      topology_.vertex_count = in_.integer("the number of vertices", 8, 8 * max_patches);
    }
    check_vertices();
    topology_.faces =
        located(in_.source(), first_line, "elements", [&] { return mfem_faces(topology_.patches); });
  }

  // Vertices within faces, and the number of all vertices. Their places are those of control points as well.
  void read_hanging_vertices() {
    hanging_line_ = in_.line();
    if (in_.peek() == "vertex_to_knotspan") {
      in_.word("'vertex_to_knotspan'");
      const int count = in_.integer("the number of vertices within faces", 0, 8 * max_patches);
      for (int i = 0; i < count; ++i) {
        MfemHangingVertex vertex;
        vertex.vertex = in_.integer("a vertex", 0, max_control_points);
        for (int& element : vertex.element) element = in_.integer("a knot span", 0, max_control_points);
        vertex.face = vertices<4>();
        hanging_.push_back(vertex);
      }
    }
    if (in_.peek() == "vertex_parents")
      in_.fail("patches that were divided after they had been made are not supported",
               ErrorCode::unsupported);
    in_.expect("coordinates");
    topology_.vertex_count = in_.integer("the number of vertices", 8, 8 * max_patches);
    if (in_.integer("the number of coordinates", 1, 10) != 3)
      in_.fail("vertices must have three coordinates", ErrorCode::unsupported);
    for (int i = 0; i < 3 * topology_.vertex_count; ++i) in_.number("a coordinate of a vertex");
  }

  void check_vertices() {
    std::vector<bool> used(static_cast<std::size_t>(topology_.vertex_count));
    for (const auto& patch : topology_.patches)
      for (const int v : patch) {
        if (v >= topology_.vertex_count)
          in_.fail(fmt::format("{} vertices, but an element has vertex {}", topology_.vertex_count, v));
        used[static_cast<std::size_t>(v)] = true;
      }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) in_.fail(fmt::format("vertex {} belongs to no element", unused - used.begin()));
  }

  KnotVector read_knots(const std::string& name) {
    const int degree = in_.integer("the degree of " + name, 1, KnotVector::max_degree);
    const int count = in_.integer("the number of control points of " + name, 2, max_control_points);
    const int line = in_.line();
    const std::size_t knot_count = static_cast<std::size_t>(count) + static_cast<std::size_t>(degree) + 1;
    in_.require_room(knot_count, fmt::format("{} knots of {}", knot_count, name));
    std::vector<double> knots(knot_count);
    for (double& knot : knots) knot = in_.number("a knot of " + name);
    return located(in_.source(), line, name, [&] { return KnotVector(degree, std::move(knots)); });
  }

  std::vector<NurbsVolume> read_patches() {
    in_.expect("patches");
    std::vector<NurbsVolume> result;
    for (std::size_t p = 0; p < topology_.patches.size(); ++p)
      result.push_back(read_patch(fmt::format("patch {}", p)));
    in_.expect_end("the last patch");
    return result;
  }

  NurbsVolume read_patch(const std::string& name) {
    in_.expect("knotvectors");
    if (in_.integer("the number of knot vectors of " + name, 1, 3) != 3)
      in_.fail(name + ": three knot vectors are needed", ErrorCode::unsupported);
    const int line = in_.line();
    NurbsVolume::KnotVectors knots;
    for (std::size_t d = 0; d < 3; ++d) knots[d] = read_knots(fmt::format("{}, direction {}", name, d));
    in_.expect("dimension");
    if (in_.integer("the dimension of " + name, 1, 10) != 3)
      in_.fail(name + ": control points must have three coordinates", ErrorCode::unsupported);
    const std::string_view kind = in_.word("'controlpoints'");
    const bool cartesian = kind == "controlpoints_cartesian";
    if (!cartesian && kind != "controlpoints" && kind != "controlpoints_homogeneous")
      in_.fail(fmt::format("{} found where 'controlpoints' of {} are expected", quoted(kind), name));
    const auto count = located(in_.source(), line, name,
                               [&] { return checked_control_points(knots[0], knots[1], knots[2]); });
    in_.require_room(static_cast<std::size_t>(4 * count),
                     fmt::format("{} control points of {}", count, name));
    Eigen::Matrix4Xd points(4, count);
    for (Eigen::Index i = 0; i < count; ++i) {
      for (double& x : points.col(i)) x = in_.number("a control point of " + name);
      if (!(points(3, i) > 0))
        in_.fail(fmt::format("weight {} of {} is {}; weights must be positive", i, name, points(3, i)));
    }
    return located(in_.source(), line, name, [&] {
      return cartesian ? NurbsVolume(std::move(knots), points.topRows<3>(), points.row(3).transpose())
                       : NurbsVolume::from_homogeneous(std::move(knots), points);
    });
  }

  std::vector<NurbsVolume> read_numbered() {
    in_.expect("knotvectors");
    const int count = in_.integer("the number of knot vectors", 1, 12 * max_patches);
    std::vector<KnotVector> knots;
    for (int k = 0; k < count; ++k) knots.push_back(read_knots(fmt::format("knot vector {}", k)));
    const int line = in_.line();
    topology_.divided = located(in_.source(), hanging_line_, "vertex_to_knotspan",
                                [&] { return mfem_divided_faces(hanging_, topology_, knots); });
    if (has_spacing_) skip_spacing(count);
    const std::vector<NurbsVolume::KnotVectors> spaces =
        located(in_.source(), edges_line_, "edges", [&] { return mfem_spaces(topology_, knots); });
    std::vector<std::array<int, 3>> sizes;
    for (const auto& space : spaces) {
      located(in_.source(), line, "patches",
              [&] { return checked_control_points(space[0], space[1], space[2]); });
      sizes.push_back({space[0].size(), space[1].size(), space[2].size()});
    }
    std::vector<int> edge_sizes;
    for (const MfemEdge& edge : topology_.edges)
      edge_sizes.push_back(knots[static_cast<std::size_t>(edge.knot_vector)].size());
    const MfemNumbering numbering = located(in_.source(), line, "patches", [&] {
      MfemNumbering made(topology_, std::move(sizes), edge_sizes);
      if (!topology_.divided.empty())
        for (std::size_t p = 0; p < spaces.size(); ++p) made.patch(p);  // whether sides and their parts agree
      return made;
    });
    const Coefficients coefficients = read_coefficients(numbering);
    if (in_.peek() == "mfem_mesh_end") in_.word("'mfem_mesh_end'");
    in_.expect_end("the last control point");
    return build(spaces, numbering, coefficients, line);
  }

  // What later refinements would do in MFEM; the patches are those of the knot vectors.
  void skip_spacing(int knot_vectors) {
    if (in_.peek() == "refinements") {
      in_.word("'refinements'");
      for (int d = 0; d < 3; ++d) in_.integer("a factor of refinement", 0, max_attribute);
    }
    if (in_.peek() == "knotvector_refinements") {
      in_.word("'knotvector_refinements'");
      for (int k = 0; k < knot_vectors; ++k)
        skip_numbers(in_.integer("the number of a knot vector's refinements", 0, max_control_points));
    }
    in_.expect("spacing");
    const int formulas = in_.integer("the number of spacing formulas", 0, 12 * max_patches);
    for (int f = 0; f < formulas; ++f) {
      in_.integer("the knot vector of a spacing formula", 0, knot_vectors - 1);
      in_.integer("the kind of a spacing formula", 0, 1000);
      const int integers = in_.integer("the number of integers of a spacing formula", 0, max_control_points);
      const int reals = in_.integer("the number of reals of a spacing formula", 0, max_control_points);
      skip_numbers(integers);
      skip_numbers(reals);
    }
  }

  void skip_numbers(int count) {
    for (int i = 0; i < count; ++i) in_.number("a number of a spacing formula");
  }

  struct Coefficients {
    Eigen::VectorXd weights;
    Eigen::Matrix3Xd points;
  };

  Coefficients read_coefficients(const MfemNumbering& numbering) {
    const std::int64_t size = numbering.size();
    Coefficients result;
    const std::string_view kind = in_.word("'weights'");
    if (kind != "weights" && kind != "unitweights")
      in_.fail(
          fmt::format(
              "{} found where 'weights' is expected; periodic and partly active meshes are not supported",
              quoted(kind)),
          ErrorCode::unsupported);
    const bool given = kind == "weights";
    in_.require_room(static_cast<std::size_t>((given ? 4 : 3) * size), fmt::format("{} coefficients", size));
    result.weights = Eigen::VectorXd::Ones(size);
    if (given)
      for (double& w : result.weights) w = in_.number("a weight");
    const int ordering = read_space();
    result.points =
        in_.peek() == "NURBS_patches" ? points_by_patch(numbering) : points_by_number(size, ordering);
    return result;
  }

  // Ordering 0: all x, all y, all z; 1: point by point.
  Eigen::Matrix3Xd points_by_number(std::int64_t size, int ordering) {
    Eigen::Matrix3Xd points(3, size);
    for (std::int64_t n = 0; n < 3 * size; ++n) {
      const Eigen::Index row = ordering == 0 ? n / size : n % 3;
      const Eigen::Index column = ordering == 0 ? n % size : n / 3;
      points(row, column) = in_.number("a coordinate");
    }
    return points;
  }

  int read_space() {
    const bool has_version = in_.peek() == "MFEM";
    if (has_version) in_.expect("MFEM");
    in_.expect("FiniteElementSpace");
    if (has_version) in_.expect("v1.0");
    in_.expect("FiniteElementCollection:");
    if (const std::string_view name = in_.word("the collection"); !name.starts_with("NURBS"))
      in_.fail(fmt::format("collection {}; NURBS is supported", quoted(name)), ErrorCode::unsupported);
    in_.expect("VDim:");
    if (in_.integer("VDim", 1, 100) != 3) in_.fail("VDim must be 3: points in space", ErrorCode::unsupported);
    in_.expect("Ordering:");
    const int ordering = in_.integer("Ordering", 0, 1);
    if (has_version)
      for (const char* word : {"End:", "MFEM", "FiniteElementSpace", "v1.0"}) in_.expect(word);
    return ordering;
  }

  Eigen::Matrix3Xd points_by_patch(const MfemNumbering& numbering) {
    in_.expect("NURBS_patches");
    Eigen::Matrix3Xd points(3, numbering.size());
    for (std::size_t p = 0; p < topology_.patches.size(); ++p)
      for (const std::int64_t number : numbering.patch(p))
        for (int d = 0; d < 3; ++d) points(d, number) = in_.number("a coordinate of a patch");
    return points;
  }

  std::vector<NurbsVolume> build(const std::vector<NurbsVolume::KnotVectors>& spaces,
                                 const MfemNumbering& numbering, const Coefficients& all, int line) {
    std::vector<NurbsVolume> result;
    for (std::size_t p = 0; p < spaces.size(); ++p) {
      const std::vector<std::int64_t> numbers = numbering.patch(p);
      result.push_back(located(in_.source(), line, fmt::format("patch {}", p), [&] {
        return NurbsVolume(spaces[p], all.points(Eigen::all, numbers), all.weights(numbers));
      }));
    }
    return result;
  }

  TextScanner in_;
  MfemTopology topology_;
  std::vector<MfemHangingVertex> hanging_;
  int edges_line_ = 1;
  int hanging_line_ = 1;
  bool has_spacing_ = false;
  bool meets_in_parts_ = false;  // an NC-patch mesh
};

}  // namespace

PatchSet read_mfem_mesh(std::string_view text, const std::string& source) {
  return MfemReader(text, source).read();
}

}  // namespace isopatch::geometry

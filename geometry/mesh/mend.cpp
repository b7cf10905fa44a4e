#include "geometry/mesh/mend.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/weld.hpp"

namespace isopatch::geometry {
namespace {

std::string counted(int number, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

/// Leaves out the triangles for which `is_left_out` holds; how many.
template <class Test>
int leave_out(TriangleMesh& mesh, Test is_left_out) {
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (!is_left_out(t)) mesh.triangles.col(kept++) = mesh.triangles.col(t);
  const int gone = static_cast<int>(mesh.triangles.cols() - kept);
  mesh.triangles.conservativeResize(3, kept);
  return gone;
}

/// For each triangle, whether one before it has the same three vertices.
std::vector<bool> repeated(const TriangleMesh& mesh) {
  std::vector<std::array<int, 4>> keys;
  for (int t = 0; t < mesh.triangles.cols(); ++t) {
    std::array<int, 4> key{mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t), t};
    std::sort(key.begin(), key.begin() + 3);
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> result(keys.size(), false);
  for (std::size_t i = 1; i < keys.size(); ++i)
    result[static_cast<std::size_t>(keys[i][3])] =
        std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin());
  return result;
}

std::string place(const TriangleMesh& mesh, const TriangleSide& side) {
  const auto text = [&](int corner) {
    const Eigen::Vector3d p = mesh.vertices.col(mesh.triangles(corner % 3, side.triangle));
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x(), p.y(), p.z());
  };
  return fmt::format("the edge from {} to {}", text(side.side), text(side.side + 1));
}

struct AtEdge {
  int low, high, triangle;
  bool rising;
  auto operator<=>(const AtEdge&) const = default;
};

/// Turns triangles so that neighbours agree; how many. Edges have two triangles each.
int agree(TriangleMesh& mesh, std::vector<int>& shell) {
  const auto count = static_cast<std::size_t>(mesh.triangles.cols());
  std::vector<AtEdge> sides;
  for (int t = 0; t < mesh.triangles.cols(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int from = mesh.triangles(i, t), to = mesh.triangles((i + 1) % 3, t);
      sides.push_back({std::min(from, to), std::max(from, to), t, from < to});
    }
  std::sort(sides.begin(), sides.end());
  struct Link {
    int other;
    bool turned;
  };
  std::vector<std::vector<Link>> links(count);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
    const AtEdge &a = sides[i], &b = sides[i + 1];
    links[static_cast<std::size_t>(a.triangle)].push_back({b.triangle, a.rising == b.rising});
    links[static_cast<std::size_t>(b.triangle)].push_back({a.triangle, a.rising == b.rising});
  }
  std::vector<int> turned(count, -1);
  shell.assign(count, -1);
  int shells = 0, changed = 0;
  std::vector<int> open;
  for (std::size_t first = 0; first < count; ++first) {
    if (turned[first] >= 0) continue;
    turned[first] = 0;
    open = {static_cast<int>(first)};
    for (std::size_t next = 0; next < open.size(); ++next) {
      const auto t = static_cast<std::size_t>(open[next]);
      shell[t] = shells;
      for (const Link& link : links[t]) {
        int& other = turned[static_cast<std::size_t>(link.other)];
        const int wanted = turned[t] ^ static_cast<int>(link.turned);
        if (other < 0) {
          other = wanted;
          open.push_back(link.other);
        } else if (other != wanted) {
          throw Error(ErrorCode::not_manifold,
                      "the triangles bound no solid: the surface has one side only, as a Moebius strip");
        }
      }
    }
    if (2 * std::count_if(open.begin(), open.end(),
                          [&](int t) { return turned[static_cast<std::size_t>(t)] == 1; }) >
        static_cast<std::ptrdiff_t>(open.size()))
      for (const int t : open) turned[static_cast<std::size_t>(t)] ^= 1;
    ++shells;
  }
  for (std::size_t t = 0; t < count; ++t)
    if (turned[t] == 1) {
      std::swap(mesh.triangles(1, static_cast<Eigen::Index>(t)),
                mesh.triangles(2, static_cast<Eigen::Index>(t)));
      ++changed;
    }
  return changed;
}

double shell_volume(const TriangleMesh& mesh, const std::vector<int>& shell, int which,
                    const Eigen::Vector3d& middle) {
  double sum = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (shell[static_cast<std::size_t>(t)] == which)
      sum += area_vector(mesh, t).dot(mesh.vertices.col(mesh.triangles(0, t)) - middle) / 6;
  return sum;
}

Eigen::AlignedBox3d shell_box(const TriangleMesh& mesh, const std::vector<int>& shell, int which) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (shell[static_cast<std::size_t>(t)] == which)
      for (int i = 0; i < 3; ++i) box.extend(mesh.vertices.col(mesh.triangles(i, t)));
  return box;
}

void turn_shell(TriangleMesh& mesh, const std::vector<int>& shell, int which) {
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    if (shell[static_cast<std::size_t>(t)] == which) std::swap(mesh.triangles(1, t), mesh.triangles(2, t));
}

/// The shell of the largest volume looks outwards, those within it inwards; returns how many were turned.
int turn_shells(TriangleMesh& mesh, const std::vector<int>& shell) {
  const int shells = 1 + *std::max_element(shell.begin(), shell.end());
  const Eigen::Vector3d middle = mesh.vertices.rowwise().mean();
  std::vector<double> volumes;
  for (int s = 0; s < shells; ++s) volumes.push_back(shell_volume(mesh, shell, s, middle));
  const int outer =
      static_cast<int>(std::max_element(volumes.begin(), volumes.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                       volumes.begin());
  const Eigen::AlignedBox3d whole = shell_box(mesh, shell, outer);
  int turned = 0;
  for (int s = 0; s < shells; ++s) {
    const bool inverted = (volumes[static_cast<std::size_t>(s)] > 0) != (s == outer);
    if (s != outer && !whole.contains(shell_box(mesh, shell, s)))
      throw Error(
          ErrorCode::not_manifold,
          fmt::format("the triangles bound {} bodies that lie beside each other; give each a file of its own",
                      shells));
    if (!inverted) continue;
    turn_shell(mesh, shell, s);
    ++turned;
  }
  return turned;
}

void require_two_at_each_edge(const TriangleMesh& mesh) {
  const MeshNeighbours found = neighbours(mesh);
  if (!found.open.empty())
    throw Error(ErrorCode::not_manifold,
                fmt::format("the triangles bound no solid: {}, among them {}; close the holes",
                            counted(static_cast<int>(found.open.size()), "edge has one triangle only",
                                    "edges have one triangle only"),
                            place(mesh, found.open.front())));
  if (!found.overused.empty())
    throw Error(ErrorCode::not_manifold,
                fmt::format("the triangles bound no solid: {}, among them {}; parts that touch along an edge "
                            "must be joined or parted",
                            counted(static_cast<int>(found.overused.size()),
                                    "edge has more than two triangles", "edges have more than two triangles"),
                            place(mesh, found.overused.front())));
}

}  // namespace

MendedMesh mended(const TriangleMesh& mesh, double tolerance) {
  MendedMesh result;
  result.mesh = weld(mesh, tolerance).mesh;
  const std::vector<bool> twice = repeated(result.mesh);
  const int copies =
      leave_out(result.mesh, [&](Eigen::Index t) { return twice[static_cast<std::size_t>(t)]; });
  if (copies > 0)
    result.remarks.push_back(counted(copies, "triangle that occurs twice was left out",
                                     "triangles that occur twice were left out"));
  if (result.mesh.triangles.cols() == 0) throw Error(ErrorCode::bad_format, "there are no triangles");
  require_two_at_each_edge(result.mesh);
  std::vector<int> shell;
  const int turned = agree(result.mesh, shell);
  if (turned > 0)
    result.remarks.push_back(counted(turned, "triangle did not agree with its neighbours and was turned",
                                     "triangles did not agree with their neighbours and were turned"));
  const int shells = turn_shells(result.mesh, shell);
  if (shells > 0)
    result.remarks.push_back(
        counted(shells, "shell was inside out and was turned", "shells were inside out and were turned"));
  return result;
}

}  // namespace isopatch::geometry

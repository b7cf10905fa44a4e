#pragma once

#include <random>
#include <utility>
#include <vector>

#include "segmentation/decomposition/combinatorics/cell_graph.hpp"

namespace isopatch::segmentation::test {

/// Which 3-connected planar maps are drawn.
enum class RandomKind {
  simple,  ///< three edges at each vertex: new edges join two new vertices on sides of a face
  mixed    ///< new edges also join corners, existing and new
};

/// A random 3-connected planar map: edges added across faces of a tetrahedron, as Tutte builds them all from
/// wheels.
class RandomMap {
 public:
  explicit RandomMap(std::uint32_t seed, RandomKind kind) : random_(seed), kind_(kind) {}

  /// Of at least so many vertices, one more at most.
  CellGraph of(int vertices) {
    faces_ = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    count_ = 4;
    while (count_ < vertices) divide();
    return cell_graph(count_, faces_);
  }

 private:
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }

  // One edge across a random face, between ends that no side has in common.
  void divide() {
    const int f = below(static_cast<int>(faces_.size()));
    const int n = static_cast<int>(faces_[f].size());
    // Places around the face: 2 k is corner k, 2 k + 1 the middle of side k.
    int a = below(2 * n), b = below(2 * n);
    if (kind_ == RandomKind::simple) a |= 1, b |= 1;
    const int apart = std::abs(a - b), gap = std::min(apart, 2 * n - apart);
    if (gap < 2 || (gap == 2 && a % 2 == 0)) return;
    if (a > b) std::swap(a, b);
    const int second = place(f, b), first = place(f, a);
    split(f, first, second);
  }

  // The vertex at a place; a new one goes into both faces of its side. Higher places first: those before keep
  // their numbers.
  int place(int f, int at) {
    const int n = static_cast<int>(faces_[f].size());
    const int u = faces_[f][at / 2], v = faces_[f][(at / 2 + 1) % n];
    if (at % 2 == 0) return u;
    const int middle = count_++;
    for (std::vector<int>& face : faces_)
      for (std::size_t k = 0; k < face.size(); ++k) {
        const int p = face[k], q = face[(k + 1) % face.size()];
        if ((p == u && q == v) || (p == v && q == u)) {
          face.insert(face.begin() + static_cast<std::ptrdiff_t>(k) + 1, middle);
          break;
        }
      }
    return middle;
  }

  void split(int f, int first, int second) {
    std::vector<int> one, other;
    std::vector<int>& face = faces_[f];
    const std::size_t n = face.size();
    std::size_t start = 0;
    while (face[start] != first) ++start;
    std::size_t k = start;
    for (; face[k % n] != second; ++k) one.push_back(face[k % n]);
    one.push_back(second);
    for (; face[k % n] != first; ++k) other.push_back(face[k % n]);
    other.push_back(first);
    face = one;
    faces_.push_back(other);
  }

  std::mt19937 random_;
  RandomKind kind_;
  std::vector<std::vector<int>> faces_;
  int count_ = 0;
};

inline CellGraph random_map(std::uint32_t seed, int vertices, RandomKind kind) {
  return RandomMap(seed, kind).of(vertices);
}

}  // namespace isopatch::segmentation::test

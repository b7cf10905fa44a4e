#include "segmentation/decomposition/combinatorics/internal/map_code.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace isopatch::segmentation {
namespace {

// Walks a map from a dart, and from the next ones writes only what may become smaller.
class CodeWriter {
 public:
  CodeWriter(const PlanarMap& map, const Darts& around, const std::vector<char16_t>& kinds)
      : map_(map), around_(around), kinds_(kinds), number_(map.vertices), entry_(map.vertices) {}

  // Replaces `best` by the description from a dart if that is smaller, or if there is none.
  void improve(std::u16string& best, int start, bool mirrored) {
    mirrored_ = mirrored;
    std::fill(number_.begin(), number_.end(), -1);
    order_.clear();
    text_.clear();
    bool smaller = best.empty();
    discover(start);
    discover(around_.twin[start]);
    for (std::size_t k = 0; k < order_.size(); ++k) {
      const int first = entry_[order_[k]];
      int dart = first;
      do {
        if (!write(letter(dart), best, smaller)) return;
        if (!kinds_.empty() && !write(kinds_[dart], best, smaller)) return;
        dart = turned(dart);
      } while (dart != first);
      if (!write(vertex_end, best, smaller)) return;
    }
    best = text_;
  }

 private:
  static constexpr char16_t vertex_end = 65535;

  // By the dart that leaves it, towards where it was found from.
  void discover(int dart) {
    const int vertex = map_.corners[dart];
    number_[vertex] = static_cast<int>(order_.size());
    entry_[vertex] = dart;
    order_.push_back(vertex);
  }

  char16_t letter(int dart) {
    const int back = around_.twin[dart], target = map_.corners[back];
    if (number_[target] < 0) discover(back);
    return static_cast<char16_t>(number_[target]);
  }

  int turned(int dart) const {
    return mirrored_ ? around_.next[around_.twin[dart]] : around_.twin[around_.previous[dart]];
  }

  // False as soon as the text is larger than the best.
  bool write(char16_t value, const std::u16string& best, bool& smaller) {
    text_.push_back(value);
    if (smaller) return true;
    const char16_t other = best[text_.size() - 1];
    smaller = value < other;
    return value <= other;
  }

  const PlanarMap& map_;
  const Darts& around_;
  const std::vector<char16_t>& kinds_;
  bool mirrored_ = false;
  std::vector<int> number_, entry_, order_;
  std::u16string text_;
};

// What is the same around a dart and its mirror image: degrees of its ends, sizes of the faces beside it, its
// kind.
using DartSort = std::array<int, 5>;

DartSort sort_of(const PlanarMap& map, const Darts& around, const std::vector<char16_t>& kinds, int dart,
                 bool mirrored) {
  const auto degree = [&](int d) {
    const int vertex = map.corners[d];
    return around.out_begin[vertex + 1] - around.out_begin[vertex];
  };
  const int twin = around.twin[dart];
  int left = map.size(around.face[dart]), right = map.size(around.face[twin]);
  if (mirrored) std::swap(left, right);
  return {degree(dart), degree(twin), left, right, kinds.empty() ? 0 : kinds[dart]};
}

struct CodeStart {
  DartSort sort;
  int dart;
  bool mirrored;
};

// The starts of the rarest sort, the least of those that are equally rare: the same in isomorphic maps.
std::vector<CodeStart> rarest(std::vector<CodeStart> starts) {
  std::sort(starts.begin(), starts.end(),
            [](const CodeStart& a, const CodeStart& b) { return a.sort < b.sort; });
  std::size_t best = 0, best_count = starts.size() + 1;
  for (std::size_t begin = 0; begin < starts.size();) {
    std::size_t end = begin;
    while (end < starts.size() && starts[end].sort == starts[begin].sort) ++end;
    if (end - begin < best_count) best = begin, best_count = end - begin;
    begin = end;
  }
  starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(best + best_count), starts.end());
  starts.erase(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(best));
  return starts;
}

}  // namespace

std::u16string map_code(const PlanarMap& map, const Darts& around, const std::vector<char16_t>& kinds,
                        bool mirrored_too) {
  std::vector<CodeStart> starts;
  for (int d = 0; d < static_cast<int>(map.corners.size()); ++d) {
    starts.push_back({sort_of(map, around, kinds, d, false), d, false});
    if (mirrored_too) starts.push_back({sort_of(map, around, kinds, d, true), d, true});
  }
  CodeWriter writer(map, around, kinds);
  std::u16string best;
  for (const CodeStart& start : rarest(std::move(starts))) writer.improve(best, start.dart, start.mirrored);
  return best;
}

}  // namespace isopatch::segmentation

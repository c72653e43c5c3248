/// Disjoint sets (union-find).
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace fieldfab {

/// A partition of the numbers 0 to count - 1 into disjoint sets, by union-find with path halving (Tarjan and van
/// Leeuwen 1984). At first each number is a set of its own.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  /// Returns the representative of the set that contains `v`: its least member. Amortized O(log count).
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  /// Merges the sets that contain `a` and `b`.
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t x = find(a), y = find(b);
    parent_[std::max(x, y)] = std::min(x, y);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace fieldfab

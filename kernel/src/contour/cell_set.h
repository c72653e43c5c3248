/// Cells of a grid, numbered.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace fieldfab::contouring {

using Cell = std::array<std::int64_t, 3>;  ///< of a grid that covers space

/// A set of cells, kept as one bit per cell in blocks of 8 x 8 x 8, so that large boxes of cells are added and searched
/// quickly. Coordinates are taken modulo 2^24.
class CellSet {
 public:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// Adds all cells from `lower` to `upper`, both included.
  void add(const Cell& lower, const Cell& upper) {
    for_blocks(lower, upper, [&](const Part& part) {
      Block& block = blocks_[make(part.key)];
      for (std::size_t z = part.first[2]; z <= part.last[2]; ++z) block.bits[z] |= part.layer;
      return true;
    });
  }
  void add(const CellSet& other) {
    for (const auto& [key, number] : other.at_) {
      Block& block = blocks_[make(key)];
      for (std::size_t z = 0; z < block.bits.size(); ++z) block.bits[z] |= other.blocks_[number].bits[z];
    }
  }

  /// Numbers the cells from 0 on, and returns how many there are.
  std::size_t number() {
    std::uint32_t count = 0;
    for (Block& block : blocks_)
      for (std::size_t z = 0; z < block.bits.size(); ++z) {
        block.before[z] = count;
        count += static_cast<std::uint32_t>(std::popcount(block.bits[z]));
      }
    return count;
  }

  /// Calls visit(number) for each cell from `lower` to `upper`, both included, until one call returns false; the number
  /// of a cell that is not in the set is `none`. Returns whether no call did.
  template <class Visit>
  bool for_numbers(const Cell& lower, const Cell& upper, const Visit& visit) const {
    return for_blocks(lower, upper, [&](const Part& part) {
      const auto found = at_.find(part.key);
      const Block* const block = found == at_.end() ? nullptr : &blocks_[found->second];
      for (std::size_t z = part.first[2]; z <= part.last[2]; ++z)
        for (std::uint64_t left = part.layer; left != 0; left &= left - 1) {
          const std::uint64_t cell = left & -left;
          const bool there = block != nullptr && (block->bits[z] & cell) != 0;
          if (!visit(there ? block->before[z] + static_cast<std::uint32_t>(std::popcount(block->bits[z] & (cell - 1)))
                           : none))
            return false;
        }
      return true;
    });
  }

 private:
  static constexpr int level = 3;
  static constexpr std::int64_t side = 1 << level;  ///< of a block, in cells
  struct Block {
    std::array<std::uint64_t, side> bits{};    ///< by z: bit x + 8 y
    std::array<std::uint32_t, side> before{};  ///< by z: number of the first cell
  };
  /// Cells of a box in one block.
  struct Part {
    std::uint64_t key;
    std::array<std::size_t, 3> first, last;
    std::uint64_t layer;  ///< bits of one z
  };

  std::uint32_t make(std::uint64_t key) {
    const auto [at, is_new] = at_.try_emplace(key, static_cast<std::uint32_t>(blocks_.size()));
    if (is_new) blocks_.emplace_back();
    return at->second;
  }

  template <class Visit>
  static bool for_blocks(const Cell& lower, const Cell& upper, const Visit& visit) {
    Cell block;
    const auto of = [](std::int64_t cell) { return cell >> level; };
    for (block[2] = of(lower[2]); block[2] <= of(upper[2]); ++block[2])
      for (block[1] = of(lower[1]); block[1] <= of(upper[1]); ++block[1])
        for (block[0] = of(lower[0]); block[0] <= of(upper[0]); ++block[0]) {
          Part part{};
          for (std::size_t i = 0; i < 3; ++i) {
            part.key = part.key << 21 | (static_cast<std::uint64_t>(block[i]) & 0x1fffff);
            part.first[i] = static_cast<std::size_t>(std::max(lower[i] - side * block[i], std::int64_t{0}));
            part.last[i] = static_cast<std::size_t>(std::min(upper[i] - side * block[i], side - 1));
          }
          const std::uint64_t row =
              ((std::uint64_t{2} << part.last[0]) - 1) & ~((std::uint64_t{1} << part.first[0]) - 1);
          for (std::size_t y = part.first[1]; y <= part.last[1]; ++y) part.layer |= row << (y << level);
          if (!visit(part)) return false;
        }
    return true;
  }

  std::unordered_map<std::uint64_t, std::uint32_t> at_;  ///< by key: index into blocks_
  std::vector<Block> blocks_;
};

}  // namespace fieldfab::contouring

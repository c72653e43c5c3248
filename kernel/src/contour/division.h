/// Cells of a block that are halved, as often as it takes to see what is in them.
#pragma once

#include "clear.h"
#include "octree.h"

namespace fieldfab::contouring {

/// A cell that has to be divided, since a neighbour's points show more on their common boundary than its corners do; or since a
/// neighbour is divided and the cell has several patches, which only cells without smaller neighbours can have.
struct DivisionRequest {
  LatticePoint block;  ///< lower corner of the block it is in
  LatticePoint lower;
  int level;
  bool only_ambiguous;  ///< only where the cell, or the one that it is part of, has several patches or a face with two readings
  auto operator<=>(const DivisionRequest&) const = default;
};

/// The divisions of one block, as they are made: round by round, in each of which all cells of one level that are not clear are
/// halved.
class BlockRefiner {
 public:
  /// `field` must be good in the block and about it.
  BlockRefiner(const Lattice& lattice, const LatticePoint& block, FieldPtr field)
      : lattice_(lattice), block_(block), field_(std::move(field)) {}

  [[nodiscard]] const LatticePoint& block() const { return block_; }
  void add_unclear(std::vector<UnclearCell> cells);
  /// Cells that are not clear and not divided either: those of the next round.
  [[nodiscard]] const std::vector<UnclearCell>& unclear() const { return unclear_; }

  /// Leaves the cells as they are that are not seen to be folded.
  void give_up_unproved() {
    give_up([](const UnclearCell& cell) { return !cell.folded; });
  }
  [[nodiscard]] const std::vector<UnclearCell>& given_up() const { return given_up_; }

  /// Halves the cells that are not clear; then unclear() has those of their parts that are not.
  void advance();
  /// Halves the cells that hold the one asked for, and that one itself, where the request holds for them; those of their parts
  /// that have no simple surface, too, as far as the level `finest`.
  void divide(const DivisionRequest& request, int finest);

  /// What divisions made since the last call ask of the cells around: of their own size, divided as well.
  void collect_requests(std::vector<DivisionRequest>& requests);

  [[nodiscard]] bool empty() const { return divisions_.empty(); }
  /// Hands the divisions over to the block.
  void move_to(Block& block);

 private:
  struct Place {
    std::uint32_t* division;  ///< where the index of the cell's division is kept
    LatticePoint lower;
    int level;
  };
  void give_up(bool (*which)(const UnclearCell&));
  [[nodiscard]] Place place_of(const LatticePoint& lower, int level);
  std::uint32_t make(const LatticePoint& lower, int level, const Field& field);
  [[nodiscard]] double least_value(unsigned child) const;
  void divide_ambiguous(std::uint32_t division, int finest);
  [[nodiscard]] bool is_ambiguous(const Place& place) const;
  void request(const LatticePoint& lower, int level, bool only_ambiguous, std::vector<DivisionRequest>& requests) const;

  const Lattice& lattice_;
  const LatticePoint block_;
  FieldPtr field_;
  std::vector<UnclearCell> unclear_, given_up_;
  std::vector<Division> divisions_;
  std::vector<std::uint32_t> division_of_;
  std::array<float, 27> values_{};  ///< of the division that was made last
  std::size_t requested_ = 0;       ///< how many divisions have had their requests collected
};

}  // namespace fieldfab::contouring

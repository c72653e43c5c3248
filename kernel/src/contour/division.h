/// Repeated halving of a block's cells, until their content is resolved.
#pragma once

#include "clear.h"
#include "octree.h"

namespace fieldfab::contouring {

/// A cell to divide. Either the points of a neighbour show more on the common boundary than the
/// corners of the cell do; or a neighbour is divided and the cell has several patches, which only a
/// cell without smaller neighbours may have.
struct DivisionRequest {
  LatticePoint block;  ///< lower corner of the block that contains the cell
  LatticePoint lower;
  int level;
  /// Divide only if the cell, or the cell that contains it, has several patches or an ambiguous
  /// face.
  bool only_ambiguous;
  auto operator<=>(const DivisionRequest&) const = default;
};

/// Divisions of one block, made in rounds. Each round halves all unclear cells of one level.
class BlockRefiner {
 public:
  /// `field` must equal the solid in the block and around it.
  BlockRefiner(const Lattice& lattice, const LatticePoint& block, FieldPtr field)
      : lattice_(lattice), block_(block), field_(std::move(field)) {}

  [[nodiscard]] const LatticePoint& block() const { return block_; }
  void add_unclear(std::vector<UnclearCell> cells);
  /// Cells that are neither clear nor divided: those of the next round.
  [[nodiscard]] const std::vector<UnclearCell>& unclear() const { return unclear_; }

  /// Gives up the cells that are not seen to be folded; they stay as they are.
  void give_up_unproved() {
    give_up([](const UnclearCell& cell) { return !cell.folded; });
  }
  [[nodiscard]] const std::vector<UnclearCell>& given_up() const { return given_up_; }

  /// Halves the unclear cells; unclear() then returns their parts that are not clear.
  void advance();
  /// Halves the requested cell and the cells that contain it, if the condition of the request holds
  /// for them. Also halves parts that have no simple surface, down to the level `finest`.
  void divide(const DivisionRequest& request, int finest);

  /// Appends the requests of the divisions made since the last call: neighbours of the same size
  /// must be divided as well.
  void collect_requests(std::vector<DivisionRequest>& requests);

  [[nodiscard]] bool empty() const { return divisions_.empty(); }
  /// Moves the divisions into the block.
  void move_to(Block& block);

 private:
  struct Place {
    std::uint32_t* division;  ///< location of the index of the cell's division
    LatticePoint lower;
    int level;
  };
  /// A cell whose parts were examined, and where those of them stand that are not clear. Cells with the same Field,
  /// beside it along axes that the Field does not read, are alike.
  struct Examined {
    LatticePoint lower;
    std::size_t first, last;
  };
  void give_up(bool (*which)(const UnclearCell&));
  void examine_parts(const UnclearCell& cell, const Division& division, std::vector<UnclearCell>& parts);
  /// `box`: the part and `overlap` around it, in which `field` has the solid's sign. Appends the part unless it is
  /// clear.
  void examine_part(const Division& division, unsigned child, const Box& box, FieldPtr field,
                    std::vector<UnclearCell>& parts);
  [[nodiscard]] Place place_of(const LatticePoint& lower, int level);
  std::uint32_t make(const LatticePoint& lower, int level);
  void divide_ambiguous(std::uint32_t division, int finest);
  [[nodiscard]] bool is_ambiguous(const Place& place) const;
  void request(const LatticePoint& lower, int level, bool only_ambiguous, std::vector<DivisionRequest>& requests) const;

  const Lattice& lattice_;
  const LatticePoint block_;
  FieldPtr field_;
  std::vector<UnclearCell> unclear_, given_up_;
  std::vector<Division> divisions_;
  std::vector<std::uint32_t> division_of_;
  std::size_t requested_ = 0;  ///< number of divisions whose requests have been collected
};

}  // namespace fieldfab::contouring

/// A cube of stock: a k-d tree of functional cells, and its subtraction of tools (Hahn Fig. 3.1).
#pragma once

#include <optional>
#include <random>

#include "cell.h"
#include "fieldfab/cam/stock/stock.h"
#include "sweep.h"

namespace fieldfab::cam {

/// Intervals of one sweep on the lines through a region along each axis, computed on demand.
class WindowSet {
 public:
  explicit WindowSet(const StockLattice& lattice) : lattice_(&lattice) {}
  /// Sets the sweep and the region, which is extended by one point on each side. Returns false if
  /// the sweep contains no point of it.
  bool start(const Sweep& sweep, const Region& region);
  const Window& along(int axis);
  /// The points within the sweep's bounding box.
  [[nodiscard]] const Region& reach() const { return reach_; }

 private:
  const StockLattice* lattice_;
  const Sweep* sweep_ = nullptr;
  Region reach_;
  std::array<Window, 3> windows_;
  std::array<bool, 3> filled_{};
};

class Brick {
 public:
  struct Tally {
    std::uint64_t direct = 0, indirect = 0, conflict = 0, halved = 0;
  };

  Brick(const Region& region, bool solid);

  [[nodiscard]] const Region& region() const { return region_; }
  /// Whether the brick is wholly solid or empty, without samples.
  [[nodiscard]] bool uniform() const {
    return nodes_.size() == 1 && nodes_[0].content < Cell::Content::columns && !samples_.size();
  }
  [[nodiscard]] bool empty() const { return nodes_.size() == 1 && nodes_[0].content == Cell::Content::empty; }
  /// A stroke that may reach the brick, and its result there.
  struct Pass {
    const Sweep* sweep;
    const Stroke* stroke;
    StrokeResult result{};
  };
  /// Subtracts the strokes in their order, or only reports contact for strokes that do not remove
  /// material.
  void cut(std::span<Pass> passes, const Stock& stock);
  /// Frees unused memory; worthwhile after many passes.
  void settle(const StockLattice& lattice) {
    if (samples_.size() != tidied_) tidy(lattice);
  }
  /// Sets the contents: solid points and the samples on their edges.
  void assign(const Occupancy& solid, SampleMap samples, const Stock& stock);

  /// Assigns all samples to cut 0, the first surface.
  void forget_cuts();

  [[nodiscard]] bool solid(const Index3& point, const StockLattice& lattice) const;
  /// The sample that a solid point owns on its edge along an axis, upwards or downwards. Returns
  /// the far end of the edge if no sample is stored.
  [[nodiscard]] Sample sample(const Index3& point, int axis, bool upwards, const StockLattice& lattice) const;
  /// Sets the bits of all solid points.
  void occupy(Occupancy& shape, const StockLattice& lattice) const;
  void count(StockStatistics& statistics) const;
  [[nodiscard]] double volume(const StockLattice& lattice) const;

 private:
  friend class StockBytes;
  /// Sweeps of a few passes on the lines through the brick, while they are processed.
  struct Batch;
  struct Change {
    std::size_t column;
    Sample lower, upper;
  };

  [[nodiscard]] const Cell& leaf(const Index3& point) const;
  [[nodiscard]] Region solid_bounds(const StockLattice& lattice) const;
  void occupy(const Cell& cell, Occupancy& shape, const StockLattice& lattice) const;
  void cut_columns(int node, Batch& batch, std::size_t pass, const Stock& stock);
  void cut_edges(int node, Batch& batch, std::size_t pass, const StockLattice& lattice);
  bool plan_columns(const Cell& cell, const Window& window, const Stroke& stroke, const StockLattice& lattice,
                    std::vector<Change>& changes, StrokeResult& result) const;
  void cut_edges(const Cell& cell, const Stroke& stroke, const StockLattice& lattice, WindowSet& windows);
  void commit(Cell& cell, const std::vector<Change>& changes) const;
  void divide(int node, const Stroke& stroke, const Stock& stock, WindowSet& windows);
  void rebuild(int node, const Occupancy& solid, const Occupancy& covered, int axis, std::int8_t facing,
               const Stroke& stroke, const Stock& stock);
  void make_columns(Cell& cell, int axis, std::int8_t facing, const Occupancy& solid,
                    const StockLattice& lattice) const;
  void tidy(const StockLattice& lattice);

  Region region_;
  std::vector<Cell> nodes_;
  SampleMap samples_;
  std::size_t tidied_ = 0;  ///< number of samples after the last tidy()
  Tally tally_;
  std::minstd_rand random_{12345};
};

}  // namespace fieldfab::cam

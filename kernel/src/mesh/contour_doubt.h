/// Uncertain cells, gathered to places.
#pragma once

#include <span>
#include <vector>

#include "contour_clear.h"
#include "fieldfab/mesh/certainty.h"

namespace fieldfab::contouring {

/// Collects cells that are not clear, and joins those that are neighbours.
class DoubtMap {
 public:
  explicit DoubtMap(const Lattice& lattice) : lattice_(lattice) {}
  void add(std::span<const UnclearCell> cells);
  /// Writes counts, sizes and the places; clears the doubt where there are none.
  void write(Certainty& certainty) const;

 private:
  struct Cell {
    LatticePoint voxel;  ///< the voxel that it is in
    Box box;
    double side;
  };

  const Lattice& lattice_;
  std::vector<Cell> cells_;
};

}  // namespace fieldfab::contouring

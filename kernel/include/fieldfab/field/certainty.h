/// How certain a mesh or a distance field is: where something of the solid may have been missed, and how large that could be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fieldfab/core/geometry.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// A connected region in which the Field's intervals and slopes could not prove that all of the surface is shown.
struct UncertainPlace {
  Box box;
  double thickness = 0;  ///< mm: what may be hidden here fits into cells of this edge
};

/// A cell that may hide some of the surface.
struct UncertainCell {
  std::array<std::int32_t, 3> voxel;  ///< the cell of a regular lattice that it is, or is part of
  Box box;
  double side;  ///< its edge, mm
};

/// Why places were left uncertain.
enum class Doubt {
  none,
  not_looked,     ///< it was not asked for
  finest_size,    ///< the smallest cells allowed are not small enough: edges thinner than these, or surfaces that touch
  not_proved,     ///< nothing is seen to be missing, but the Field's slopes are too roughly known to exclude it
  too_many,       ///< more cells would have to be divided than the limit allows
  slopes_unknown  ///< the Field does not tell how fast its value changes, so that nothing can be proved
};

/// The answer to "is all of the solid shown?". Certain where, in each cell, the interval of the Field excludes a surface,
/// or its slopes prove that there is one sheet of it at most (docs/contouring.md).
struct Certainty {
  std::size_t count = 0;               ///< uncertain places
  double largest = 0;                  ///< mm: longest side of the largest place
  double thickness = 0;                ///< mm: what may be hidden is thinner than this somewhere; 0 where all is certain
  std::vector<UncertainPlace> places;  ///< the largest ones first, at most `most_places`
  Doubt doubt = Doubt::none;           ///< the weightiest reason
  double finest = 0;                   ///< mm: edge of the smallest cell that was looked at
  double wanted_voxel = 0;             ///< mm: cells that would show what is missing, about; 0 where that is not known
  double wanted_triangles = 0;         ///< how many triangles these would make, about

  static constexpr std::size_t most_places = 1000;
  [[nodiscard]] bool certain() const { return doubt == Doubt::none; }
  /// One line for people: "certain", or how many places are not, how large they are, and why.
  [[nodiscard]] std::string text() const;
  /// Writes counts, sizes and places, cells of neighbouring voxels being one place; clears the doubt where there are none.
  void gather(std::span<const UncertainCell> cells);
  /// Takes another's places, too: certain only where both are.
  void add(const Certainty& other);
};

/// What cells of a regular lattice over `region` show of a solid, as in an Asdf, whose smallest cells are these: its sides are
/// divided into ceil(side / voxel). A cell is certain where the Field's interval excludes a surface in it, or its slopes prove
/// that there is one sheet at most. Time goes with the area of the surface. The same for any number of threads. Throws bad_input
/// for a region or voxel that is not finite and positive (flat in z is allowed), cancelled.
Certainty certainty_of_cells(const Field& field, const Box& region, double voxel, Progress& progress = Progress::none());

}  // namespace fieldfab

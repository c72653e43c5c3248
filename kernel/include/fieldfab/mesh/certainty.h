/// How certain a mesh is: where something of the solid may have been missed, and how large that could be.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "fieldfab/core/geometry.h"

namespace fieldfab {

/// A connected region in which the Field's intervals and slopes could not prove that the mesh shows all of the surface.
struct UncertainPlace {
  Box box;
  double thickness = 0;  ///< mm: what may be hidden here fits into cells of this edge
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

/// The answer to "is all of the solid in this mesh?". Certain where, in each cell, the interval of the Field excludes a surface,
/// or its slopes prove that there is one sheet of it at most (docs/contouring.md).
struct Certainty {
  std::size_t count = 0;               ///< uncertain places
  double largest = 0;                  ///< mm: longest side of the largest place
  double thickness = 0;                ///< mm: what may be hidden is thinner than this somewhere; 0 where all is certain
  std::vector<UncertainPlace> places;  ///< the largest ones first, at most `most_places`
  Doubt doubt = Doubt::none;           ///< the weightiest reason
  double finest = 0;                   ///< mm: edge of the smallest cell that was looked at

  static constexpr std::size_t most_places = 1000;
  [[nodiscard]] bool certain() const { return doubt == Doubt::none; }
  /// One line for people: "certain", or how many places are not, how large they are, and why.
  [[nodiscard]] std::string text() const;
};

}  // namespace fieldfab

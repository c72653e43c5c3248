/// Certainty of a mesh or a distance field: the places at which parts of the solid may be missing, and the size of such
/// parts.
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

/// A connected region in which the Field's intervals and slopes do not prove that the whole surface is represented.
struct UncertainPlace {
  Box box;
  double thickness = 0;  ///< edge of the cells in which a missing part would fit, mm
};

/// A cell that may contain an undetected part of the surface.
struct UncertainCell {
  std::array<std::int32_t, 3> voxel;  ///< index (i, j, k) of the lattice cell that contains it
  Box box;
  double side;  ///< edge of the cell, mm
};

/// Reason for uncertainty.
enum class Doubt {
  none,
  not_looked,  ///< the proof was not requested
  /// the smallest permitted cells are too large: edges or gaps are thinner than these, or surfaces touch
  finest_size,
  not_proved,     ///< no missing part was detected, but the bounds of the Field's slopes are too wide for a proof
  too_many,       ///< the proof needs more subdivided cells than the limit permits
  slopes_unknown  ///< the Field has no bounds of its slopes, so that no proof is possible
};

/// Whether a mesh or distance field represents the whole solid. It is certain if, in each cell, the interval of the
/// Field excludes a surface, or its slopes prove that the surface has at most one sheet (docs/contouring.md).
struct Certainty {
  std::size_t count = 0;  ///< number of uncertain places
  double largest = 0;     ///< longest side of the largest place, mm
  /// upper bound of the thickness of missing parts, mm; 0 if certain
  double thickness = 0;
  std::vector<UncertainPlace> places;  ///< sorted by size, largest first; at most `most_places`
  Doubt doubt = Doubt::none;           ///< the most serious reason
  double finest = 0;                   ///< edge of the smallest cell examined, mm
  double wanted_voxel = 0;             ///< estimated cell edge that would represent the missing parts, mm; 0 if unknown
  double wanted_triangles = 0;         ///< estimated number of triangles at that cell edge

  static constexpr std::size_t most_places = 1000;
  [[nodiscard]] bool certain() const { return doubt == Doubt::none; }
  /// Returns one line for people: "certain", or the number and size of the uncertain places and the reason.
  [[nodiscard]] std::string text() const;
  /// Sets the counts, sizes and places from `cells`. Cells of neighbouring voxels form one place. Clears the doubt if
  /// `cells` is empty.
  void gather(std::span<const UncertainCell> cells);
  /// Merges the places of `other`. The result is certain only if both are.
  void add(const Certainty& other);
};

/// Certainty of a regular lattice over `region`, such as the smallest cells of an Asdf. Each side is divided into
/// ceil(side / voxel) cells. A cell is certain if the Field's interval excludes a surface in it, or its slopes prove at
/// most one sheet. Time is proportional to the area of the surface. The result does not depend on the number of
/// threads. Throws Error(bad_input) unless region and voxel are finite and positive (a region flat in z is allowed),
/// Error(cancelled).
Certainty certainty_of_cells(const Field& field, const Box& region, double voxel,
                             Progress& progress = Progress::none());

}  // namespace fieldfab

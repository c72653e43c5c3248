/// From a solid to its surface: the one place that knows regions, default cells, and whether faces or a contour are taken.
#pragma once

#include <optional>

#include "fieldfab/contour/contour.h"
#include "fieldfab/solid/solid.h"

namespace fieldfab {

/// How finely to work.
struct Resolution {
  std::optional<double> voxel = {};      ///< side of the smallest cell, mm; default_voxel() where not given
  std::optional<double> max_error = {};  ///< how far the result may be from the solid, mm; a tenth of the cell where not given
  std::optional<Box> region = {};        ///< only what is in it, capped; found where not given
  bool features = true;                  ///< whether edges are kept sharp
  bool exact = true;                     ///< whether the solid's own faces are taken where they can be had
};

/// A surface, and what it was made with.
struct Surface {
  ContourMesh mesh;
  bool exact = false;  ///< the solid's own faces, not a contour
  Box region;          ///< mm
  double voxel = 0;    ///< mm
};

/// The region to work in: `wanted` where given (checked), else the solid's own, else what solid_bounds() finds, a little grown.
/// Throws bad_input for an unbounded solid, naming the axes and asking for bounds, and for an empty one unless that is allowed
/// (any box will do for it then).
enum class EmptySolid { refused, allowed };
Box working_bounds(const Solid& solid, const std::optional<Box>& wanted, Progress& progress = Progress::none(),
                   EmptySolid empty = EmptySolid::refused);

/// The cell to work with where none is asked for, mm: the solid's own resolution, else so many cells along the region's longest
/// side. Throws bad_input unless `cells` is positive.
constexpr double default_cells = 128;
double default_voxel(const Solid& solid, const Box& region, double cells = default_cells);

/// The colour of each vertex of a mesh of all parts together: that of the part with the least value there, light grey where it
/// has none. Empty where no part has a colour.
std::vector<Colour> vertex_colours(const TriangleMesh& mesh, const Model& model);

/// The closed surface of a solid. Throws bad_input, too_large, cancelled, as contour() and working_bounds() do.
Surface surface(const Solid& solid, const Resolution& resolution, Progress& progress = Progress::none(),
                EmptySolid empty = EmptySolid::refused);

}  // namespace fieldfab

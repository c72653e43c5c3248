/// From a solid to its surface: selection of the region, the cell size, and exact faces or a contour.
#pragma once

#include <optional>

#include "fieldfab/contour/contour.h"
#include "fieldfab/field/certainty.h"
#include "fieldfab/solid/solid.h"

namespace fieldfab {

/// Resolution of a surface.
struct Resolution {
  std::optional<double> voxel = {};  ///< edge of the smallest cell, mm; default: default_voxel()
  /// permitted distance between result and solid, mm; default: a tenth of the cell
  std::optional<double> max_error = {};
  std::optional<Box> region = {};  ///< region to work in; the solid is capped at its faces; default: working_bounds()
  bool features = true;            ///< whether sharp edges are reconstructed
  bool exact = true;               ///< whether exact faces of the solid are preferred, if available
};

/// A surface with the parameters used.
struct Surface {
  ContourMesh mesh;
  bool exact = false;  ///< whether the mesh has the exact faces of the solid instead of a contour
  Box region;          ///< region used, mm
  double voxel = 0;    ///< mm
};

/// Returns the region to work in: `wanted` if given (checked), otherwise the solid's own region, otherwise the result
/// of solid_bounds(), slightly expanded. Throws Error(bad_input) for an unbounded solid, with the axes, and for an
/// empty one unless permitted (the region is then arbitrary); Error(cancelled).
enum class EmptySolid { refused, allowed };
Box working_bounds(const Solid& solid, const std::optional<Box>& wanted, Progress& progress = Progress::none(),
                   EmptySolid empty = EmptySolid::refused);

/// Returns the default cell edge, mm: the solid's own resolution, otherwise the longest side of the region divided by
/// `cells`. Throws Error(bad_input) unless cells > 0.
constexpr double default_cells = 128;
double default_voxel(const Solid& solid, const Box& region, double cells = default_cells);

/// Cell edge of a lattice, and its certainty.
struct LatticeCells {
  double voxel = 0;  ///< mm
  Certainty certainty;
};

/// Returns the cell edge for results without smaller cells in thin places, such as distance fields: default_voxel(), or
/// half or a quarter of it if only that represents the whole solid. Throws as certainty_of_cells().
LatticeCells lattice_cells(const Solid& solid, const Box& region, Progress& progress = Progress::none());

/// Returns a colour per vertex for a mesh of all parts together: the colour of the part with the least value there,
/// light grey if that part has none. Empty if no part has a colour.
std::vector<Colour> vertex_colours(const TriangleMesh& mesh, const Model& model);

/// Computes the closed surface of a solid. Throws Error(bad_input), Error(too_large), Error(cancelled), as contour()
/// and working_bounds().
Surface surface(const Solid& solid, const Resolution& resolution, Progress& progress = Progress::none(),
                EmptySolid empty = EmptySolid::refused);

}  // namespace fieldfab

/// Booleans of axis-aligned boxes by cells: the planes of all faces divide space into a grid whose
/// cells are solid or empty as a whole.
#pragma once

#include <optional>
#include <vector>

#include "leaf.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Axis-aligned boxes, combined like the Part that they come from.
struct Boxes {
  Part::Kind kind = Part::Kind::nothing;
  Box box = {};  ///< of a leaf
  std::vector<Boxes> children = {};
};

/// Returns the axis-aligned box that a solid is, or nullopt if it is not one.
std::optional<Box> box_of(const Polyhedron& solid);

/// Whether the grid of the boxes, and that of surface_of() with growth, has few enough cells.
bool have_few_cells(const Boxes& boxes, bool grown);

/// Returns the surface of the combined boxes, with vertices only where edges of the solid meet. It
/// is exact, except that all faces are moved outwards by `growth` mm, and faces at most `same` mm
/// apart are in one plane. Parts without thickness vanish. Without growth, throws bad_input if
/// solids touch only along an edge or at a corner; with growth they are joined there.
Polyhedron surface_of(const Boxes& boxes, double same, double growth, Progress& progress);

}  // namespace fieldfab::openscad

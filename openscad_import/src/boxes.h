/// What boxes along the axes make, by cells: the planes of all their faces divide space into a grid, and each of its cells is
/// solid or empty as a whole.
#pragma once

#include <optional>
#include <vector>

#include "leaf.h"
#include "polyhedron.h"

namespace fieldfab::openscad {

/// Boxes along the axes, joined as the Part is that they are of.
struct Boxes {
  Part::Kind kind = Part::Kind::nothing;
  Box box = {};  ///< of a leaf
  std::vector<Boxes> children = {};
};

/// The box along the axes that a solid is; nothing where it is none.
std::optional<Box> box_of(const Polyhedron& solid);

/// Whether their grid, and that of `surface_of` grown, has few enough cells.
bool have_few_cells(const Boxes& boxes, bool grown);

/// The surface of what they make, with corners where edges of the solid meet only; exact, but for all faces being moved out by
/// `growth` mm; faces no farther apart than `same` mm are in one plane. What has no thickness is not there. Without growth it
/// throws bad_input where solids touch along an edge or at a corner only; with it they become one.
Polyhedron surface_of(const Boxes& boxes, double same, double growth, Progress& progress);

}  // namespace fieldfab::openscad

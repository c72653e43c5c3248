/// Each filter is a file of this folder.
#pragma once

#include "../filter.h"

namespace fieldfab::meshlab {

Filter remesh();           ///< any soup to a closed mesh, through a distance field
Filter offset_layer();     ///< outwards or inwards
Filter hollow();           ///< a wall, with drain holes
Filter combine_layers();   ///< union, intersection, difference, sharp or with a fillet
Filter lattice_infill();   ///< a wall, and a lattice within
Filter frep_solid();       ///< from a formula
Filter volume_solid();     ///< from a CT volume, at a threshold
Filter deviation();        ///< from another layer, a file or a formula, as quality and colour
Filter validity_report();  ///< whether it can be made: closed, manifold, free of self-intersections

}  // namespace fieldfab::meshlab

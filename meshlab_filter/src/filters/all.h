/// Filters; each one is a file of this folder.
#pragma once

#include "../filter.h"

namespace fieldfab::meshlab {

Filter remesh();           ///< converts any triangle soup to a closed mesh, by a distance field
Filter offset_layer();     ///< moves the surface outwards or inwards
Filter hollow();           ///< leaves a wall, with drain holes
Filter combine_layers();   ///< union, intersection, difference; sharp or with a fillet
Filter lattice_infill();   ///< fills a wall with a lattice
Filter frep_solid();       ///< a solid from a formula
Filter volume_solid();     ///< a solid from a CT volume, by a threshold
Filter deviation();        ///< distance from another layer, a file or a formula, as quality and colour
Filter validity_report();  ///< whether the layer is closed, manifold, free of self-intersections

}  // namespace fieldfab::meshlab

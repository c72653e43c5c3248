/// The surface of a stock as one closed mesh whose level flats are merged.
#pragma once

#include <vector>

#include "deviation_gauge.h"
#include "fieldfab/cam/stock/stock.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

struct ClosedMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> cuts;  ///< what made each vertex
  std::vector<float> deviations;    ///< of each vertex, where they are measured
};

/// Made slice by slice, so that never more than a few slices are there with all their vertices. The gauge, where there is one, is
/// shown all of them. Throws cancelled, too_large.
ClosedMesh closed_mesh(const Stock& stock, DeviationGauge* gauge, Progress& progress);
/// From pieces that are there already.
ClosedMesh closed_mesh(const SurfacePieces& pieces);

}  // namespace fieldfab::cam

/// Closed mesh of a stock's surface, with coplanar axis-aligned regions simplified.
#pragma once

#include <vector>

#include "deviation_gauge.h"
#include "fieldfab/cam/stock/stock.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

struct ClosedMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> cuts;  ///< cut that made each vertex
  std::vector<float> deviations;    ///< signed distance of each vertex to the target, mm; empty if
                                    ///< not measured
};

/// Makes the mesh slice by slice, so that only a few slices are stored with all their vertices. All
/// vertices at samples are reported to the gauge unless it is nullptr. Throws Error(cancelled),
/// Error(too_large).
ClosedMesh closed_mesh(const Stock& stock, StockEdges edges, DeviationGauge* gauge, Progress& progress);
/// Makes the mesh from existing pieces, with edges as sampled.
ClosedMesh closed_mesh(const SurfacePieces& pieces);

}  // namespace fieldfab::cam

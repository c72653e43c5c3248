/// Strokes of tools on planned stock.
#pragma once

#include <vector>

#include "fieldfab/cam/base/tool_solid.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/cam/stock/lattice.h"

namespace fieldfab::cam {

/// Half the diagonal of a lattice's cells, mm, as seen along an axis: if that is one of the lattice's, across it.
double half_diagonal(const StockLattice& lattice, const Vec3& axis);

/// Returns the cutting part of a tool up to a height of `length` mm above its tip, thinner by `by` mm: a point belongs
/// to it if all points within that distance across the axis belong to the tool. Round parts become chords inside.
std::vector<ToolPiece> thinned(const Tool& tool, double by, double length);

/// Returns the end points of straight segments of a move, each at most `step` mm long; arcs become chords.
std::vector<Vec3> segments(const Vec3& from, const Move& move, double step);

}  // namespace fieldfab::cam

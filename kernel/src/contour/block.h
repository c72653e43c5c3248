/// One block: sampled, its sign changes located, its cells merged.
#pragma once

#include <optional>

#include "clear.h"
#include "octree.h"

namespace fieldfab::contouring {

/// What the surface in a cube comes to, for merging it with its seven siblings.
struct Patch {
  std::uint8_t corners = 0;          ///< as in Leaf; 0 or 255 where there is no surface in the cube
  std::vector<SurfacePoint> points;  ///< all crossings in the closed cube
  Vec3 vertex = Vec3::Zero();
  [[nodiscard]] bool uniform() const { return is_uniform(corners); }
};

/// What the cells of a block are, before any is divided.
struct BlockView {
  std::optional<Patch> patch;        ///< where all of the block is one
  std::vector<UnclearCell> unclear;  ///< cells that may hide something
  bool complete = false;             ///< nothing of that is to be looked into, and so the cells are merged
  bool known = false;                ///< whether the Field told its slopes anywhere
  std::size_t crossed = 0;           ///< how many cells the surface is seen to pass
};

/// Samples `field` (the solid, good in the block and about it) at the block's 9x9x9 lattice points, looks whether its cells are
/// clear, and merges them. Where all of the block is one patch `block` gets its crossings only, until it is known how far it
/// merges.
BlockView view_block(const Field& field, const Lattice& lattice, const LatticePoint& lower, const ContourSettings& settings,
                     Block& block);

/// The same with the cells that are divided in `block`, taking all others to be clear.
std::optional<Patch> sample_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                                  const ContourSettings& settings, Block& block);

/// Whether all points lie in one plane, to a thousandth of `max_error`; sets `vertex` to their middle.
bool is_flat(const std::vector<SurfacePoint>& points, double max_error, Vec3& vertex);

/// Leaves of points in one plane only those that say where it leaves `cell`: two on each face.
void thin(std::vector<SurfacePoint>& points, const Box& cell);

/// Whether one vertex in `cell`, and with `features` one on each of its faces, reproduces all `points` to `max_error`; sets
/// `vertex`.
bool reproduces(const std::vector<SurfacePoint>& points, const Box& cell, const ContourSettings& settings, Vec3& vertex);

}  // namespace fieldfab::contouring

/// Sampling of one block, location of its sign changes, and merging of its cells.
#pragma once

#include <optional>

#include "clear.h"
#include "octree.h"

namespace fieldfab::contouring {

/// Surface in a cube, as far as its merging with the seven sibling cubes needs it.
struct Patch {
  std::uint8_t corners = 0;          ///< as in Leaf; 0 or 255 if no surface passes the cube
  std::vector<SurfacePoint> points;  ///< all crossings in the closed cube
  Vec3 vertex = Vec3::Zero();
  [[nodiscard]] bool uniform() const { return is_uniform(corners); }
};

/// Cells of a block before any is divided.
struct BlockView {
  std::optional<Patch> patch;        ///< the patch, if all of the block is one patch
  std::vector<UnclearCell> unclear;  ///< cells that may hide some of the surface
  bool complete = false;             ///< true if no unclear cell is to be examined; the cells are merged then
  bool known = false;                ///< whether the Field returned slopes anywhere
  std::size_t crossed = 0;           ///< number of cells that the surface is seen to pass
};

/// Samples `field` at the 9x9x9 lattice points of the block, finds the cells that are not clear,
/// and merges the cells. `field` must equal the solid in the block and around it. If the whole
/// block is one patch, `block` gets its crossings only, since the largest cube that it merges into
/// is not known yet.
BlockView view_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                     const ContourSettings& settings, Block& block);

/// Samples a block whose divided cells are in `block`, and treats all other cells as clear.
std::optional<Patch> sample_block(const Field& field, const Lattice& lattice, const LatticePoint& lower,
                                  const ContourSettings& settings, Block& block);

/// Returns whether all points lie in one plane, within `max_error` / 1000, and sets `vertex` to
/// their mean.
bool is_flat(const std::vector<SurfacePoint>& points, double max_error, Vec3& vertex);

/// Removes points in one plane except those at which the plane leaves `cell`: two on each face.
void thin(std::vector<SurfacePoint>& points, const Box& cell);

/// Returns the permitted surface deviation in a cell with edges of `side`, mm. In parts of a voxel it is smaller in
/// proportion: what is thinner than a voxel must not shrink by as much as the whole may deviate.
double permitted_error(const ContourSettings& settings, double side);

/// Returns whether one vertex in `cell`, and with `features` one more on each face, reproduces all
/// `points` within the permitted error. Sets `vertex`.
bool reproduces(const std::vector<SurfacePoint>& points, const Box& cell, const ContourSettings& settings,
                Vec3& vertex);

}  // namespace fieldfab::contouring

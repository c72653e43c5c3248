// Volumes of OpenVDB.
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>

#include <fstream>

#include "fieldfab/core/file.h"
#include "volume/parts.h"

namespace fieldfab {
namespace {

VolumePtr open(const Path& path) {
  openvdb::initialize();
  openvdb::FloatGrid::Ptr grid;
  try {
    // A stream that throws at its end. OpenVDB's own stream continues beyond it and allocates
    // memory for missing data.
    std::ifstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit | std::ios::eofbit);
    file.open(path, std::ios::binary);
    openvdb::io::Stream stream(file, false);
    for (const auto& each : *stream.getGrids())
      if (grid = openvdb::gridPtrCast<openvdb::FloatGrid>(each); grid) break;
  } catch (const std::exception&) {
    refuse(path, "is no .vdb file, or a damaged one");
  }
  if (!grid) refuse(path, "holds no grid of 32-bit real numbers");
  const openvdb::CoordBBox active = grid->evalActiveVoxelBoundingBox();
  if (active.empty()) refuse(path, "holds a grid without samples");
  if (!grid->transform().isLinear()) refuse(path, "holds a grid that is not linear");
  // One sample of background on all sides, which is not solid; the surface of a level set may end
  // there.
  openvdb::CoordBBox box = active;
  box.expand(1);
  const openvdb::Coord dim = box.dim();
  SampleLattice lattice;
  sample_count({dim.x(), dim.y(), dim.z()}, path);
  lattice.size = {dim.x(), dim.y(), dim.z()};
  require_memory(lattice.count() * sizeof(float), path.string());
  const auto place = [&](const openvdb::Vec3d& at) {
    const openvdb::Vec3d world = grid->transform().indexToWorld(at);
    return Vec3(world.x(), world.y(), world.z());
  };
  const openvdb::Vec3d low(box.min().x(), box.min().y(), box.min().z());
  lattice.origin = place(low);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    openvdb::Vec3d next = low;
    next[static_cast<int>(axis)] += 1;
    const Vec3 step = place(next) - lattice.origin;
    lattice.spacing[axis] = step.norm();
    if (!(lattice.spacing[axis] > 0)) refuse(path, "holds a grid with an impossible transform");
    lattice.axes.col(axis) = step / lattice.spacing[axis];
  }
  if (lattice.axes.isIdentity(1e-12)) lattice.axes.setIdentity();
  std::vector<float> densities(lattice.count());
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, densities.data());
  openvdb::tools::copyToDense(*grid, dense);
  if (grid->getGridClass() != openvdb::GRID_LEVEL_SET) return volume_of(std::move(densities), lattice);
  for (float& density : densities) density = -density;
  return volume_of(std::move(densities), lattice, 0.0);
}

}  // namespace

extern "C" const VdbVolumePart fieldfab_vdb_volume = {open};

}  // namespace fieldfab

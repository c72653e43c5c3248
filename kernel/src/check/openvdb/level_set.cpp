#include "check/level_set.h"

#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/FastSweeping.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetMeasure.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tools/ValueTransformer.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <atomic>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file_buffer.h"
#include "fieldfab/core/parallel.h"
#include "volume/openvdb/float_grid.h"

namespace fieldfab {
namespace {

constexpr int leaf_side = 8;

// Where parts of a design touch, the Field is 0 on a plane inside the solid. Such planes are at
// round numbers, so samples are shifted away from them.
const Vec3 shift{0.3819660, 0.2360680, 0.4142136};  // voxels

/// A cube of side leaf_side << level voxels with its lower corner at `lower`, in voxels.
struct Cube {
  openvdb::Coord lower;
  int level;
  FieldPtr field;
};

/// Writes like openvdb::io::File, which opens files by name and does not report a full disk.
struct Archive : openvdb::io::Archive {
  using openvdb::io::Archive::write;
};

/// The grid counts voxels from the middle of the bounds, since OpenVDB's volume is a sum over the
/// surface whose error grows with the distance from the origin.
class VdbLevelSet : public LevelSet {
 public:
  VdbLevelSet(const Field& solid, const Box& bounds, double voxel, Progress& progress);
  [[nodiscard]] bool empty() const override { return !grid_; }
  [[nodiscard]] double volume() const override;
  [[nodiscard]] double area() const override;
  [[nodiscard]] double value(const Vec3& point) const override;
  [[nodiscard]] std::vector<Vec3> surface_points() const override;
  void save(const std::filesystem::path& path) const override;

 private:
  [[nodiscard]] Vec3 in_mm(const Vec3& voxels) const { return origin_ + voxel_ * voxels; }
  [[nodiscard]] Vec3 in_mm(const openvdb::Coord& at) const { return in_mm(Vec3(at.x(), at.y(), at.z())); }

  openvdb::FloatGrid::Ptr grid_;  // null if no surface was found
  double voxel_;                  // mm
  Vec3 origin_;                   // mm
};

VdbLevelSet::VdbLevelSet(const Field& solid, const Box& bounds, double voxel, Progress& progress)
    : voxel_(voxel), origin_(bounds.centre() + voxel * shift) {
  openvdb::initialize();
  const auto band = static_cast<float>(half_width);
  auto grid = openvdb::FloatGrid::create(band);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);

  // Cubes within half_width voxels of the surface.
  const auto box_of = [&](const Cube& cube) {
    const double side = leaf_side << cube.level;
    const Vec3 lower = in_mm(cube.lower);
    return Box{lower, lower + Vec3::Constant((side - 1) * voxel)}.grown(half_width * voxel);
  };
  int level = 0;
  const double reach = bounds.size().maxCoeff() / 2 / voxel + half_width + 1;  // from the middle, voxels
  while ((leaf_side << level) < reach) ++level;
  std::vector<Cube> open;
  const openvdb::Coord origin(-(leaf_side << level));
  for (int i = 0; i < 8; ++i) {
    const int side = leaf_side << level;
    open.push_back(
        {origin.offsetBy((i & 1) * side, (i >> 1 & 1) * side, (i >> 2) * side), level, solid.shared_from_this()});
  }
  for (; !open.empty(); --level) {
    progress.check();
    std::vector<char> keep(open.size());
    parallel_for(open.size(), [&](std::size_t i) {
      Restriction here = open[i].field->restricted(box_of(open[i]));
      keep[i] = !here.range.decided();
      open[i].field = std::move(here.field);
    });
    if (level == 0) {
      std::size_t kept = 0;
      for (std::size_t i = 0; i < open.size(); ++i)
        if (keep[i] != 0) std::swap(open[kept++], open[i]);
      open.resize(kept);
      break;
    }
    std::vector<Cube> next;
    for (std::size_t i = 0; i < open.size(); ++i)
      for (int child = 0; keep[i] != 0 && child < 8; ++child) {
        const int side = leaf_side << (level - 1);
        next.push_back({open[i].lower.offsetBy((child & 1) * side, (child >> 1 & 1) * side, (child >> 2) * side),
                        level - 1, open[i].field});
      }
    open = std::move(next);
  }

  std::vector<openvdb::FloatTree::LeafNodeType*> leafs;
  for (const Cube& cube : open) {
    leafs.push_back(new openvdb::FloatTree::LeafNodeType(cube.lower, band, true));
    grid->tree().addLeaf(leafs.back());  // the tree owns it
  }
  std::atomic<bool> has_inside = false;
  parallel_for(open.size(), [&](std::size_t i) {
    progress.check();
    constexpr std::size_t count = leaf_side * leaf_side * leaf_side;
    std::array<float, count> x, y, z, value, dx, dy, dz;
    for (openvdb::Index n = 0; n < count; ++n) {
      const Vec3 at = in_mm(leafs[i]->offsetToGlobalCoord(n));
      x[n] = static_cast<float>(at.x()), y[n] = static_cast<float>(at.y()), z[n] = static_cast<float>(at.z());
    }
    open[i].field->gradients({x.data(), y.data(), z.data(), count}, value.data(), {dx.data(), dy.data(), dz.data()});
    bool inside = false;
    for (openvdb::Index n = 0; n < count; ++n) {
      const double slope = std::sqrt(double{dx[n]} * dx[n] + double{dy[n]} * dy[n] + double{dz[n]} * dz[n]);
      double distance = value[n] / slope / voxel;  // to first order
      if (!std::isfinite(distance)) distance = value[n] < 0 ? -1 : 1;
      leafs[i]->setValueOn(n, static_cast<float>(std::clamp(distance, -half_width, half_width)));
      if (distance < 0) inside = true;
    }
    if (inside) has_inside = true;
  });
  progress.check();
  if (!has_inside) return;
  openvdb::tools::signedFloodFill(grid->tree());
  // Only the samples next to sign changes are kept; the distances are swept from there. (OpenVDB
  // can also rebuild a level set through a mesh, but that fills cavities.)
  grid_ = openvdb::tools::sdfToSdf(*grid);
  progress.check();
}

double VdbLevelSet::volume() const {
  return empty() ? 0 : openvdb::tools::levelSetVolume(*grid_, false) * std::pow(voxel_, 3);
}
double VdbLevelSet::area() const {
  return empty() ? 0 : openvdb::tools::levelSetArea(*grid_, false) * std::pow(voxel_, 2);
}

double VdbLevelSet::value(const Vec3& p) const {
  const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> sampler(*grid_);
  const Vec3 at = (p - origin_) / voxel_;
  return sampler.isSample(openvdb::Vec3R(at.x(), at.y(), at.z())) * voxel_;
}

std::vector<Vec3> VdbLevelSet::surface_points() const {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  std::vector<Vec3> result;
  if (empty()) return result;
  openvdb::tools::volumeToMesh(*grid_, points, quads, 0.0);
  result.reserve(points.size());
  for (const auto& p : points) result.push_back(in_mm(Vec3(p.x(), p.y(), p.z())));
  return result;
}

void VdbLevelSet::save(const std::filesystem::path& path) const {
  const auto mm = static_cast<float>(voxel_);
  // Distances are in voxels here; the tree's values outside its leafs, and its background, are
  // distances, too.
  const openvdb::FloatGrid::Ptr grid = grid_->deepCopy();
  openvdb::tools::changeBackground(grid->tree(), mm * grid->background());
  openvdb::tools::foreach (grid->beginValueAll(), [mm](const openvdb::FloatGrid::ValueAllIter& value) {
    if (value.isVoxelValue()) value.setValue(mm * *value);
  });
  openvdb::tools::signedFloodFill(grid->tree());
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel_));
  grid->transform().postTranslate({origin_.x(), origin_.y(), origin_.z()});
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setName("surface");
  PendingFile file(path);
  FileBuffer buffer(file);
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);
  Archive().write(stream, openvdb::GridPtrVec{grid}, true);
  file.commit();
}

std::unique_ptr<LevelSet> made(const Field& solid, const Box& bounds, double voxel, Progress& progress) {
  return std::make_unique<VdbLevelSet>(solid, bounds, voxel, progress);
}

}  // namespace

extern "C" const LevelSetPart fieldfab_level_set = {made};

}  // namespace fieldfab

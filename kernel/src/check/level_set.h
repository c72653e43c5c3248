/// An OpenVDB level set of a solid, made from the Field alone.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// A signed distance grid of at least `half_width` voxels to either side, swept by OpenVDB from samples of the Field.
class LevelSet {
 public:
  static constexpr double half_width = 4;

  static std::unique_ptr<LevelSet> of(const Field& solid, const Box& bounds, double voxel, Progress& progress);
  virtual ~LevelSet() = default;
  [[nodiscard]] virtual bool empty() const = 0;
  [[nodiscard]] virtual double volume() const = 0;  ///< mm^3
  [[nodiscard]] virtual double area() const = 0;    ///< mm^2
  /// Signed distance, mm; where it is more than half_width voxels, at least that.
  [[nodiscard]] virtual double value(const Vec3& point) const = 0;
  /// Points of the surface, as OpenVDB meshes it.
  [[nodiscard]] virtual std::vector<Vec3> surface_points() const = 0;
  /// Writes it in mm. Throws io.
  virtual void save(const std::filesystem::path& path) const = 0;
};

/// Of the part "openvdb" (core/module.h), as `fieldfab_level_set`.
struct LevelSetPart {
  std::unique_ptr<LevelSet> (*of)(const Field& solid, const Box& bounds, double voxel, Progress& progress);
};

}  // namespace fieldfab

/// OpenVDB level set of a solid, made from its Field alone.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// A signed distance grid of at least `half_width` voxels on both sides of the surface, swept by
/// OpenVDB from samples of the Field.
class LevelSet {
 public:
  static constexpr double half_width = 4;

  static std::unique_ptr<LevelSet> of(const Field& solid, const Box& bounds, double voxel, Progress& progress);
  virtual ~LevelSet() = default;
  [[nodiscard]] virtual bool empty() const = 0;
  [[nodiscard]] virtual double volume() const = 0;  ///< mm^3
  [[nodiscard]] virtual double area() const = 0;    ///< mm^2
  /// Signed distance, mm; beyond half_width voxels a lower bound of it.
  [[nodiscard]] virtual double value(const Vec3& point) const = 0;
  /// Points of the surface in OpenVDB's mesh.
  [[nodiscard]] virtual std::vector<Vec3> surface_points() const = 0;
  /// Writes the grid in mm. Throws io.
  virtual void save(const std::filesystem::path& path) const = 0;
};

/// Function of the part "openvdb" (core/module.h), exported as `fieldfab_level_set`.
struct LevelSetPart {
  std::unique_ptr<LevelSet> (*of)(const Field& solid, const Box& bounds, double voxel, Progress& progress);
};

}  // namespace fieldfab

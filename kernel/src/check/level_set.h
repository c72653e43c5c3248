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

  LevelSet(const Field& solid, const Box& bounds, double voxel, Progress& progress);
  ~LevelSet();
  [[nodiscard]] bool empty() const;
  [[nodiscard]] double volume() const;  ///< mm^3
  [[nodiscard]] double area() const;    ///< mm^2
  /// Signed distance, mm; where it is more than half_width voxels, at least that.
  [[nodiscard]] double value(const Vec3& point) const;
  /// Points of the surface, as OpenVDB meshes it.
  [[nodiscard]] std::vector<Vec3> surface_points() const;
  /// Writes it in mm. Throws io.
  void save(const std::filesystem::path& path) const;

 private:
  struct Vdb;
  std::unique_ptr<Vdb> vdb_;
};

}  // namespace fieldfab

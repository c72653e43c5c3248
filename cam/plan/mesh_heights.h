/// The upper surface of a mesh, straight from its triangles.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

class MeshHeights {
 public:
  /// For a Field that is a closed mesh, moved, turned or scaled or not; nullptr for any other.
  static std::unique_ptr<MeshHeights> of(const Field& field, const Rectangle& area);

  /// Heights at `wide` x `high` places from corner to corner of a rectangle inside the area; `low` where there is nothing higher.
  [[nodiscard]] std::vector<float> heights(const Rectangle& area, int wide, int high, double low) const;

  /// The highest z of the surface over a square; minus infinity where there is nothing.
  [[nodiscard]] double highest(const Rectangle& square) const;

 private:
  using Triangle = std::array<Vec3, 3>;
  template <class Visit>
  void each_bin(const Rectangle& box, const Visit& visit) const;

  std::vector<Triangle> triangles_;              // those that are not upright
  Lattice<std::uint32_t> bins_;                  // squares of the plane
  std::vector<std::uint32_t> starts_, members_;  // triangles by bin, from starts_[bin] to starts_[bin + 1]
};

}  // namespace fieldfab::cam

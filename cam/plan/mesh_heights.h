/// The upper surface of a mesh, computed directly from its triangles.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "fieldfab/cam/plan/plane.h"
#include "fieldfab/field/field.h"

namespace fieldfab::cam {

class MeshHeights {
 public:
  /// Heights of a Field that is a closed mesh, possibly moved, rotated or scaled; nullptr for any
  /// other Field.
  static std::unique_ptr<MeshHeights> of(const Field& field, const Rectangle& area);

  /// Heights at `wide` x `high` points of a rectangle inside the area, corners included; at least
  /// `low`.
  [[nodiscard]] std::vector<float> heights(const Rectangle& area, int wide, int high, double low) const;

  /// Greatest z of the surface over a square; minus infinity if there is none.
  [[nodiscard]] double highest(const Rectangle& square) const;

 private:
  using Triangle = std::array<Vec3, 3>;
  template <class Visit>
  void each_bin(const Rectangle& box, const Visit& visit) const;

  std::vector<Triangle> triangles_;  // those that are not vertical
  Lattice<std::uint32_t> bins_;      // squares of the plane
  // triangles by bin, from starts_[bin] to starts_[bin + 1]
  std::vector<std::uint32_t> starts_, members_;
};

}  // namespace fieldfab::cam

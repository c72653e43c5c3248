/// Cross-checks of a solid against OpenVDB and CGAL: an independent opinion of everything the kernel made of it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/certainty.h"
#include "fieldfab/field/field.h"
#include "fieldfab/field/measure.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// One measured value against its bound.
struct CheckRow {
  std::string name;  ///< what was measured, e.g. "mesh self-intersections (CGAL)"
  double measured = 0;
  double bound = 0;  ///< passes where measured <= bound
  std::string unit;  ///< "", "mm", "%", ...
  [[nodiscard]] bool passed() const { return measured <= bound; }
};

struct CheckReport {
  std::vector<CheckRow> rows;
  Certainty certainty;  ///< what the mesh says of itself
  Measures measures;    ///< of the solid, from its Field
  [[nodiscard]] bool passed() const;
};

struct CheckSettings {
  double voxel = 0;
  double max_error = -1;
  std::uint32_t seed = 1;
  int samples = 20000;  ///< random points for the ASDF and for inside/outside tests
  int searches = 2000;  ///< for parts that the mesh lacks
};

/// Builds the Asdf and the mesh of `field` over `bounds` and measures both (see docs/checks.md for each row and its bound).
CheckReport check(const Field& field, const Box& bounds, const CheckSettings& settings, Progress& progress = Progress::none());

/// What CGAL says of a mesh.
struct MeshVerdict {
  bool manifold = false, closed = false, outward = false;
  std::size_t self_intersections = 0, degenerate = 0, components = 0;
  double volume = 0, area = 0;
  [[nodiscard]] bool valid() const { return manifold && closed && outward && self_intersections == 0 && degenerate == 0; }
};
MeshVerdict inspect(const TriangleMesh& mesh);

}  // namespace fieldfab

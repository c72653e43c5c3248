/// Cross-checks of a solid's representations against OpenVDB and CGAL as independent implementations.
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

/// A measured value and its bound.
struct CheckRow {
  std::string name;  ///< name of the measurement, such as "mesh self-intersections (CGAL)"
  double measured = 0;
  double bound = 0;  ///< greatest permitted value
  std::string unit;  ///< unit: "", "mm", "%" and so on
  [[nodiscard]] bool passed() const { return measured <= bound; }
};

/// Result of check().
struct CheckReport {
  std::vector<CheckRow> rows;
  Certainty certainty;  ///< certainty of the mesh
  Measures measures;    ///< volume and area of the solid, from its Field
  [[nodiscard]] bool passed() const;
};

/// Parameters of check().
struct CheckSettings {
  double voxel = 0;
  double max_error = -1;
  std::uint32_t seed = 1;
  int samples = 20000;  ///< number of random points for tests of the ASDF and of the inside
  int searches = 2000;  ///< number of random searches for parts missing in the mesh
};

/// Builds the Asdf and the mesh of `field` over `bounds` and measures both; docs/checks.md lists each row and its
/// bound. Throws as Asdf::build() and contour().
CheckReport check(const Field& field, const Box& bounds, const CheckSettings& settings,
                  Progress& progress = Progress::none());

/// Validity of a mesh according to CGAL.
struct MeshVerdict {
  bool manifold = false, closed = false, outward = false;
  std::size_t self_intersections = 0, degenerate = 0, components = 0;
  double volume = 0, area = 0;
  [[nodiscard]] bool valid() const {
    return manifold && closed && outward && self_intersections == 0 && degenerate == 0;
  }
};
/// Tests a mesh with CGAL. `volume` is mm^3, `area` mm^2.
MeshVerdict inspect(const TriangleMesh& mesh);

}  // namespace fieldfab

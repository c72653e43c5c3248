/// Deviation of a stock's surface from a target solid.
#pragma once

#include <cstdint>
#include <vector>

namespace fieldfab::cam {

/// Histogram of areas by a value, with bins of relative width 1/2000. Sums are integers, so that the result does not
/// depend on the order of additions.
class AreaHistogram {
 public:
  /// Adds `area` mm^2 at `value`.
  void add(double value, double area);
  void add(const AreaHistogram& other);
  /// Returns the areas in `count` equal steps from `from` to `to`, mm^2. The first and last step include all values
  /// beyond.
  [[nodiscard]] std::vector<double> steps(double from, double to, std::size_t count) const;

 private:
  struct Bin {
    std::int64_t area = 0, moment = 0;  ///< sum of areas in 2^-32 mm^2, and of value times area in 2^-32 mm^3
  };
  Bin& bin(int index);

  int first_ = 0;  ///< index of the first bin
  std::vector<Bin> bins_;
};

/// Deviation of a finished stock from its target, mm. All members except `at_vertex` refer to the vertices before flat
/// areas are merged.
struct Deviation {
  double deepest = 0, highest = 0;        ///< greatest gouge depth and greatest excess height, mm; neither is negative
  double mean = 0, root_mean_square = 0;  ///< mean and root mean square of signed distances, weighted by area, mm
  AreaHistogram areas;                    ///< surface area by signed distance
  /// signed distance per vertex of the closed mesh, mm; positive: excess material
  std::vector<float> at_vertex;
};

}  // namespace fieldfab::cam

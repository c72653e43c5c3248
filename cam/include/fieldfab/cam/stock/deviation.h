/// How the surface of a stock differs from a solid.
#pragma once

#include <cstdint>
#include <vector>

namespace fieldfab::cam {

/// Areas by a value, in bins that are a 2000th of the value wide. Sums are whole numbers: their order does not matter.
class AreaHistogram {
 public:
  /// Adds so many mm^2.
  void add(double value, double area);
  void add(const AreaHistogram& other);
  /// Areas in `count` even steps between two values, mm^2; what is beyond counts in the first and the last step.
  [[nodiscard]] std::vector<double> steps(double from, double to, std::size_t count) const;

 private:
  struct Bin {
    std::int64_t area = 0, moment = 0;  ///< the sum of areas, and of values times areas: in 2^-32 mm^2 and mm^3
  };
  Bin& bin(int index);

  int first_ = 0;  ///< of the bins that are there
  std::vector<Bin> bins_;
};

/// How a finished stock differs from its target. All but `at_vertex` is found at all vertices of its surface, before its flats
/// are merged.
struct Deviation {
  double deepest = 0, highest = 0;        ///< gouge and excess at their worst, mm; neither below 0
  double mean = 0, root_mean_square = 0;  ///< of signed distances, weighed by area, mm
  AreaHistogram areas;                    ///< of surface by signed distance
  std::vector<float> at_vertex;           ///< of the closed mesh, signed: above 0 where material is left over
};

}  // namespace fieldfab::cam

/// How much of a surface has which value.
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

}  // namespace fieldfab::cam

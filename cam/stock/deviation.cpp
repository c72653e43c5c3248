#include "fieldfab/cam/stock/deviation.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fieldfab::cam {
namespace {

constexpr double units = 4294967296.0;  // per mm^2 or mm^3

/// Bin of a value: the upper bits of its binary representation, which are the exponent and eleven
/// binary digits. Values near 0 share one bin.
int index_of(double value) {
  constexpr int digits = 23 - 11;
  const int zero = std::bit_cast<int>(0x1p-20F) >> digits,
            at = std::bit_cast<int>(static_cast<float>(std::abs(value))) >> digits;
  const int from_zero = std::max(at - zero, 0);
  return value < 0 ? -from_zero : from_zero;
}

}  // namespace

AreaHistogram::Bin& AreaHistogram::bin(int index) {
  if (bins_.empty()) first_ = index;
  if (index < first_) {
    bins_.insert(bins_.begin(), static_cast<std::size_t>(first_ - index), Bin{});
    first_ = index;
  }
  const auto at = static_cast<std::size_t>(index - first_);
  if (at >= bins_.size()) bins_.resize(at + 1);
  return bins_[at];
}

void AreaHistogram::add(double value, double area) {
  Bin& to = bin(index_of(value));
  to.area += std::llrint(area * units), to.moment += std::llrint(value * area * units);
}

void AreaHistogram::add(const AreaHistogram& other) {
  if (other.bins_.empty()) return;
  bin(other.first_);
  bin(other.first_ + static_cast<int>(other.bins_.size()) - 1);
  for (std::size_t i = 0; i < other.bins_.size(); ++i) {
    Bin& to = bins_[static_cast<std::size_t>(other.first_ - first_) + i];
    to.area += other.bins_[i].area, to.moment += other.bins_[i].moment;
  }
}

std::vector<double> AreaHistogram::steps(double from, double to, std::size_t count) const {
  std::vector<double> areas(count, 0);
  for (const Bin& bin : bins_) {
    if (bin.area == 0) continue;
    const double mean = static_cast<double>(bin.moment) / static_cast<double>(bin.area);
    const double step = std::floor((mean - from) / (to - from) * static_cast<double>(count));
    areas[static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(count - 1)))] +=
        static_cast<double>(bin.area) / units;
  }
  return areas;
}

}  // namespace fieldfab::cam

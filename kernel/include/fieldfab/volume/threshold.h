/// Segmentation thresholds: the density that separates the solid from its surroundings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// Histogram of densities.
struct Histogram {
  double least = 0, greatest = 0;  ///< least and greatest density
  double first = 0, width = 1;     ///< bin i counts densities from first + i * width up to the start of bin i + 1
  std::vector<std::uint64_t> counts;
  std::uint64_t samples = 0;

  [[nodiscard]] double middle(std::size_t bin) const { return first + (static_cast<double>(bin) + 0.5) * width; }
};

/// Counts all samples: one bin per value for integers of at most 16 bits, otherwise 4096 bins. Reads the volume once or
/// twice, with `memory` bytes at a time. Throws Error(bad_input) with the position of a density that is NaN or
/// infinite, Error(io), Error(cancelled).
Histogram histogram(const Volume& volume, std::size_t memory, Progress& progress = Progress::none());

/// Returns Otsu's threshold, which maximizes the variance between two classes (Otsu 1979).
double otsu_threshold(const Histogram& histogram);
/// Returns the mean of the two most frequent densities on both sides of Otsu's threshold: the ISO 50 value of CT
/// metrology. A blurred edge crosses this density at its true position.
double halfway_threshold(const Histogram& histogram);
/// Returns the density below which `percent` of the samples lie.
double percentile(const Histogram& histogram, double percent);

/// A threshold rule: a number, "halfway", "otsu", or a percentile such as "90%". parse() throws Error(bad_input).
struct ThresholdRule {
  enum class Kind { automatic, value, halfway, otsu, percent } kind = Kind::automatic;
  double number = 0;
  static ThresholdRule parse(std::string_view text);
};

/// Returns the threshold by a rule. `automatic` is the file's own threshold if it has one, otherwise "halfway". Throws
/// Error(bad_input) if the solid would be empty or fill the volume.
double threshold_by(const ThresholdRule& rule, const Volume& volume, std::size_t memory,
                    Progress& progress = Progress::none());

}  // namespace fieldfab

/// The density that separates solid from nothing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fieldfab/volume/volume.h"

namespace fieldfab {

/// How many samples have which density.
struct Histogram {
  double least = 0, greatest = 0;  ///< of all densities
  double first = 0, width = 1;     ///< bin i holds densities from first + i * width up to the next bin's
  std::vector<std::uint64_t> counts;
  std::uint64_t samples = 0;

  [[nodiscard]] double middle(std::size_t bin) const { return first + (static_cast<double>(bin) + 0.5) * width; }
};

/// Counts all samples: a bin for each number where they are whole numbers of at most 16 bits, 4096 bins otherwise. Reads the
/// volume once or twice. Throws bad_input where a density is NaN or infinite, telling where.
Histogram histogram(const Volume& volume, std::size_t memory, Progress& progress = Progress::none());

/// Otsu's threshold: the density that splits the histogram into two classes that differ most (Otsu 1979).
double otsu_threshold(const Histogram& histogram);
/// The density halfway between the two that are most common, on either side of Otsu's threshold: ISO 50, as measuring with CT has
/// it. Where an edge is blurred, halfway up is where it was.
double halfway_threshold(const Histogram& histogram);
/// The density that `percent` of the samples lie below.
double percentile(const Histogram& histogram, double percent);

/// A threshold as asked for: a number, "halfway", "otsu", or "90%" (of the samples are below). Throws bad_input.
struct ThresholdRule {
  enum class Kind { automatic, value, halfway, otsu, percent } kind = Kind::automatic;
  double number = 0;
  static ThresholdRule parse(std::string_view text);
};

/// The threshold by a rule; automatic is the file's own where it has one, else halfway. Throws bad_input where nothing, or
/// everything, would be solid.
double threshold_by(const ThresholdRule& rule, const Volume& volume, std::size_t memory, Progress& progress = Progress::none());

}  // namespace fieldfab

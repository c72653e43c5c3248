#include "fieldfab/volume/threshold.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

constexpr std::size_t bins_of_reals = 4096;

bool is_small_whole(SampleType type) { return size_of(type) <= 2; }

[[noreturn]] void not_a_number(const SampleLattice& lattice, std::size_t slice, std::size_t at) {
  const auto width = static_cast<std::size_t>(lattice.size[0]);
  throw Error(ErrorKind::bad_input, "volume",
              fmt::format("the density of sample ({}, {}, {}) is not a finite number", at % width, at / width, slice));
}

struct Extremes {
  float least, most;
};

/// Throws for NaN and infinity.
Extremes extremes_of(const SampleLattice& lattice, std::size_t k, const float* density) {
  constexpr std::size_t lanes = 16;  // partial results, for vectorisation
  std::array<float, lanes> least, most, wild{};
  least.fill(density[0]), most.fill(density[0]);
  const auto add = [&](std::size_t lane, float d) {
    least[lane] = d < least[lane] ? d : least[lane];
    most[lane] = d > most[lane] ? d : most[lane];
    wild[lane] += d - d;  // 0, or NaN
  };
  const std::size_t n = lattice.slice();
  std::size_t i = 0;
  for (; i + lanes <= n; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) add(lane, density[i + lane]);
  for (; i < n; ++i) add(0, density[i]);
  if (std::any_of(wild.begin(), wild.end(), [](float w) { return w != 0; }))
    not_a_number(lattice, k,
                 static_cast<std::size_t>(
                     std::find_if(density, density + n, [](float d) { return !std::isfinite(d); }) - density));
  return {*std::min_element(least.begin(), least.end()), *std::max_element(most.begin(), most.end())};
}

/// Returns the least and greatest density. Throws for NaN and infinity.
std::pair<double, double> extent(const Volume& volume, std::size_t memory, Progress& progress) {
  std::vector<Extremes> of_slice(static_cast<std::size_t>(volume.lattice().size[2]));
  for_slices(volume, memory, progress, "looking at the densities",
             [&](std::size_t /*part*/, std::size_t k, const float* densities) {
               of_slice[k] = extremes_of(volume.lattice(), k, densities);
             });
  std::pair<double, double> whole{of_slice[0].least, of_slice[0].most};
  for (const auto& [least, most] : of_slice)
    whole.first = std::min<double>(whole.first, least), whole.second = std::max<double>(whole.second, most);
  return whole;
}

}  // namespace

Histogram histogram(const Volume& volume, std::size_t memory, Progress& progress) {
  Histogram histogram;
  std::tie(histogram.least, histogram.greatest) = extent(volume, memory, progress);
  const double range = histogram.greatest - histogram.least;
  const bool whole = is_small_whole(volume.type()) && range < 65536;
  const std::size_t bins = whole ? static_cast<std::size_t>(range) + 1 : bins_of_reals;
  histogram.first = whole ? histogram.least - 0.5 : histogram.least;
  histogram.width = whole ? 1 : range > 0 ? range / static_cast<double>(bins) : 1;
  std::vector<std::vector<std::uint64_t>> of_part(most_slice_parts, std::vector<std::uint64_t>(bins));
  for_slices(volume, memory, progress, "counting densities",
             [&](std::size_t part, std::size_t /*k*/, const float* densities) {
               std::vector<std::uint64_t>& counts = of_part[part];
               for (std::size_t i = 0; i < volume.lattice().slice(); ++i) {
                 const auto bin = static_cast<std::size_t>((densities[i] - histogram.first) / histogram.width);
                 ++counts[std::min(bin, bins - 1)];
               }
             });
  histogram.counts.assign(bins, 0);
  for (const auto& counts : of_part)
    for (std::size_t i = 0; i < bins; ++i) histogram.counts[i] += counts[i];
  histogram.samples = volume.lattice().count();
  return histogram;
}

double otsu_threshold(const Histogram& histogram) {
  double all = 0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i)
    all += static_cast<double>(histogram.counts[i]) * static_cast<double>(i);
  const auto samples = static_cast<double>(histogram.samples);
  double below = 0, sum_below = 0, best = -1;
  std::size_t first_best = 0, last_best = 0;
  for (std::size_t i = 0; i + 1 < histogram.counts.size(); ++i) {
    below += static_cast<double>(histogram.counts[i]);
    sum_below += static_cast<double>(histogram.counts[i]) * static_cast<double>(i);
    if (below == 0 || below == samples) continue;
    const double difference = sum_below / below - (all - sum_below) / (samples - below);
    const double between = below * (samples - below) * difference * difference;
    if (between > best) best = between, first_best = i;
    if (between == best) last_best = i;
  }
  // Bins up to the best one are below: the threshold is the upper border of that bin, or the middle
  // of the empty bins that follow.
  return histogram.first +
         (0.5 * (static_cast<double>(first_best) + static_cast<double>(last_best)) + 1) * histogram.width;
}

namespace {

/// Mode of the densities in bins first .. last: starts at the narrow window that holds most, and
/// moves its middle to the mean of its content.
double most_common(const Histogram& histogram, std::size_t first, std::size_t last) {
  const std::size_t reach = std::max<std::size_t>(1, histogram.counts.size() / 80);
  const auto window = [&](std::size_t middle) {
    return std::pair{std::max(middle, first + reach) - reach, std::min(middle + reach, last)};
  };
  std::size_t best = first;
  std::uint64_t most = 0;
  for (std::size_t middle = first; middle <= last; ++middle) {
    const auto [low, high] = window(middle);
    std::uint64_t here = 0;
    for (std::size_t i = low; i <= high; ++i) here += histogram.counts[i];
    if (here > most) most = here, best = middle;
  }
  double mean = static_cast<double>(best);
  for (int step = 0; step < 20; ++step) {
    const auto [low, high] = window(static_cast<std::size_t>(std::lround(mean)));
    double weight = 0, sum = 0;
    for (std::size_t i = low; i <= high; ++i)
      weight += static_cast<double>(histogram.counts[i]),
          sum += static_cast<double>(histogram.counts[i]) * static_cast<double>(i);
    if (weight == 0) break;
    const bool still = std::abs(sum / weight - mean) < 1e-3;
    mean = sum / weight;
    if (still) break;
  }
  return histogram.first + (mean + 0.5) * histogram.width;
}

}  // namespace

double halfway_threshold(const Histogram& histogram) {
  const double otsu = otsu_threshold(histogram);
  const auto border = static_cast<std::size_t>(
      std::clamp((otsu - histogram.first) / histogram.width, 1.0, static_cast<double>(histogram.counts.size()) - 1));
  return 0.5 * (most_common(histogram, 0, border - 1) + most_common(histogram, border, histogram.counts.size() - 1));
}

double percentile(const Histogram& histogram, double percent) {
  const double wanted = percent / 100 * static_cast<double>(histogram.samples);
  double below = 0;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const auto here = static_cast<double>(histogram.counts[i]);
    if (here > 0 && below + here >= wanted)
      return histogram.first + (static_cast<double>(i) + (wanted - below) / here) * histogram.width;
    below += here;
  }
  return histogram.greatest;
}

ThresholdRule ThresholdRule::parse(std::string_view text) {
  if (text.empty() || text == "auto") return {};
  if (text == "halfway") return {Kind::halfway, 0};
  if (text == "otsu") return {Kind::otsu, 0};
  const bool percent = text.ends_with('%');
  const std::string_view digits = percent ? text.substr(0, text.size() - 1) : text;
  ThresholdRule rule{percent ? Kind::percent : Kind::value, 0};
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), rule.number);
  if (failure != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(rule.number) ||
      (percent && (rule.number < 0 || rule.number > 100)))
    throw Error(ErrorKind::bad_input, "threshold",
                fmt::format("'{:.40}' is not a density, a share such as 90%, halfway, or otsu", text));
  return rule;
}

double threshold_by(const ThresholdRule& rule, const Volume& volume, std::size_t memory, Progress& progress) {
  using Kind = ThresholdRule::Kind;
  const bool own = rule.kind == Kind::automatic && volume.own_threshold();
  const bool counted = !own && rule.kind != Kind::value;
  double threshold = own ? *volume.own_threshold() : rule.number;
  std::pair<double, double> range;
  if (counted) {
    const Histogram counts = histogram(volume, memory, progress);
    range = {counts.least, counts.greatest};
    if (counts.least == counts.greatest)
      throw Error(ErrorKind::bad_input, "volume",
                  fmt::format("every density is {}: there is no surface", counts.least));
    threshold = rule.kind == Kind::percent ? percentile(counts, rule.number)
                : rule.kind == Kind::otsu  ? otsu_threshold(counts)
                                           : halfway_threshold(counts);
  } else {
    range = extent(volume, memory, progress);
  }
  if (threshold <= range.first || threshold > range.second) {
    if (rule.kind == Kind::percent)
      return std::clamp(threshold, std::nextafter(range.first, range.second), range.second);
    throw Error(
        ErrorKind::bad_input, "threshold",
        fmt::format("{} is outside of the densities, which go from {} to {}", threshold, range.first, range.second));
  }
  return threshold;
}

}  // namespace fieldfab

#include "fieldfab/volume/clean.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab {
namespace {

/// Connected pieces of samples of one kind that share faces: at most 2^32 - 1 samples. Union-find
/// over runs along x would be faster; this takes a few passes over an array of numbers.
class Pieces {
 public:
  Pieces(const std::vector<bool>& solid, const std::array<int, 3>& size) : sets_(solid.size()), count_(solid.size()) {
    const auto row = static_cast<std::uint32_t>(size[0]), slice = row * static_cast<std::uint32_t>(size[1]);
    const auto end = static_cast<std::uint32_t>(solid.size());
    for (std::uint32_t at = 0; at < end; ++at) {
      if (at % row != 0 && solid[at] == solid[at - 1]) sets_.unite(at, at - 1);
      if (at % slice >= row && solid[at] == solid[at - row]) sets_.unite(at, at - row);
      if (at >= slice && solid[at] == solid[at - slice]) sets_.unite(at, at - slice);
    }
    for (std::uint32_t at = 0; at < end; ++at) ++count_[sets_.find(at)];
  }
  [[nodiscard]] std::uint32_t of(std::size_t at) { return sets_.find(static_cast<std::uint32_t>(at)); }
  [[nodiscard]] std::size_t samples(std::uint32_t piece) const { return count_[piece]; }

 private:
  DisjointSets sets_;
  std::vector<std::uint32_t> count_;
};

}  // namespace

Denoising Denoising::parse(std::string_view text) {
  const auto colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  Denoising denoising;
  if (kind.empty() || kind == "none") return denoising;
  denoising.kind = kind == "median" ? Kind::median : kind == "gaussian" ? Kind::gaussian : Kind::anisotropic;
  if (denoising.kind == Kind::anisotropic && kind != "anisotropic")
    throw Error(ErrorKind::bad_input, "denoise",
                fmt::format("'{:.40}' is none of median, gaussian, anisotropic", text));
  if (colon == std::string_view::npos) return denoising;
  const std::string_view digits = text.substr(colon + 1);
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), denoising.amount);
  if (failure != std::errc{} || end != digits.data() + digits.size() || !(denoising.amount > 0) ||
      denoising.amount > 100)
    throw Error(ErrorKind::bad_input, "denoise", fmt::format("'{:.40}' is not a number above 0, up to 100", digits));
  return denoising;
}

VolumePtr cleaned(VolumePtr volume, double threshold, bool below, const CleanSettings& settings, Progress& progress) {
  if (!settings.keep_largest && !settings.least_island && !settings.least_hole) return volume;
  const SampleLattice lattice = volume->lattice();
  if (lattice.count() > std::numeric_limits<std::uint32_t>::max())
    throw Error(ErrorKind::too_large, "volume", "too many samples to find the pieces of the solid");
  require_memory(14 * lattice.count(), "volume");
  std::vector<float> densities = read_all(*volume, progress);
  const double sample_volume = lattice.spacing.prod() * std::abs(lattice.axes.determinant());
  const auto turn_over = [&](bool of_solid, const auto& goes) {
    progress.check();
    progress.report(0, of_solid ? "removing islands" : "closing holes");
    std::vector<bool> solid(densities.size());
    for (std::size_t i = 0; i < densities.size(); ++i)
      solid[i] = below ? densities[i] < threshold : densities[i] > threshold;
    Pieces pieces(solid, lattice.size);
    for (std::size_t i = 0; i < densities.size(); ++i)
      if (solid[i] == of_solid && goes(pieces, pieces.of(i))) {
        const double mirrored = 2 * threshold - densities[i];
        const double beyond = below == of_solid ? std::nextafter(static_cast<float>(threshold), INFINITY)
                                                : std::nextafter(static_cast<float>(threshold), -INFINITY);
        densities[i] = static_cast<float>(below == of_solid ? std::max(mirrored, beyond) : std::min(mirrored, beyond));
      }
  };
  if (settings.keep_largest || settings.least_island) {
    std::optional<std::uint32_t> largest;
    turn_over(true, [&](Pieces& pieces, std::uint32_t piece) {
      if (settings.keep_largest && !largest) {
        std::size_t most = 0;
        for (std::size_t i = 0; i < densities.size(); ++i) {
          const bool solid = below ? densities[i] < threshold : densities[i] > threshold;
          if (solid && pieces.samples(pieces.of(i)) > most) most = pieces.samples(pieces.of(i)), largest = pieces.of(i);
        }
      }
      return (settings.keep_largest && piece != *largest) ||
             (settings.least_island &&
              static_cast<double>(pieces.samples(piece)) * sample_volume < *settings.least_island);
    });
  }
  if (settings.least_hole) {
    std::vector<std::uint8_t> reaches_out;
    turn_over(false, [&](Pieces& pieces, std::uint32_t piece) {
      if (reaches_out.empty()) {  // pieces that touch the border are outside, not holes
        reaches_out.assign(densities.size(), 0);
        const auto [nx, ny, nz] = lattice.size;
        std::size_t at = 0;
        for (int k = 0; k < nz; ++k)
          for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i, ++at)
              if (i == 0 || j == 0 || k == 0 || i == nx - 1 || j == ny - 1 || k == nz - 1)
                reaches_out[pieces.of(at)] = 1;
      }
      return reaches_out[piece] == 0 &&
             static_cast<double>(pieces.samples(piece)) * sample_volume < *settings.least_hole;
    });
  }
  return volume_of(std::move(densities), lattice, volume->own_threshold());
}

}  // namespace fieldfab

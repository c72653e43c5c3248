// Denoising is done by ITK: this tests the parameters passed to it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/volume/clean.h"

namespace fieldfab {
namespace {

double spread(const Volume& volume) {
  std::vector<float> all(volume.lattice().count());
  volume.read(0, volume.lattice().size[2], all.data());
  double sum = 0, squares = 0;
  for (const float d : all) sum += d, squares += double{d} * d;
  const auto n = static_cast<double>(all.size());
  return std::sqrt(squares / n - sum / n * (sum / n));
}

TEST(Denoise, FiltersSmooth) {
  std::mt19937 random(12);
  std::normal_distribution<float> noise(100, 30);
  SampleLattice lattice;
  lattice.size = {24, 24, 24};
  std::vector<float> densities(lattice.count());
  for (float& density : densities) density = noise(random);
  const VolumePtr volume = volume_of(std::move(densities), lattice);
  for (const char* filter : {"median", "median:2", "gaussian:1", "anisotropic:3"})
    EXPECT_LT(spread(*denoised(volume, Denoising::parse(filter))), 0.75 * spread(*volume)) << filter;
  EXPECT_EQ(denoised(volume, Denoising::parse("none")), volume);
  EXPECT_THROW(Denoising::parse("sharpen"), Error);
  EXPECT_THROW(Denoising::parse("median:-1"), Error);
}

TEST(Denoise, MediansAndMeansAreThoseOfTheNeighbourhood) {
  // A single bright sample: removed by the median, spread by a Gaussian without loss.
  SampleLattice lattice;
  lattice.size = {17, 17, 17};
  lattice.spacing = {0.5, 0.5, 0.5};
  std::vector<float> densities(lattice.count(), 10.0F);
  densities[8 + 17 * (8 + 17 * 8)] = 1010;
  const VolumePtr volume = volume_of(std::move(densities), lattice);
  std::vector<float> after(lattice.count());
  denoised(volume, Denoising::parse("median"))->read(0, 17, after.data());
  for (const float density : after) EXPECT_EQ(density, 10);
  denoised(volume, Denoising::parse("gaussian:0.5"))->read(0, 17, after.data());
  double sum = 0, moment = 0;
  for (int k = 0; k < 17; ++k)
    for (int j = 0; j < 17; ++j)
      for (int i = 0; i < 17; ++i) {
        const double more = after[static_cast<std::size_t>(i + 17 * (j + 17 * k))] - 10;
        sum += more, moment += more * 0.25 * (i - 8) * (i - 8);
      }
  EXPECT_NEAR(sum, 1000, 5);
  EXPECT_NEAR(moment / sum, 0.25, 0.02);  // sigma squared, mm2
}

}  // namespace
}  // namespace fieldfab

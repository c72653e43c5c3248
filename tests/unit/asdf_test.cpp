// The distance field: exact where required, compact, with valid files.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;
const FieldPtr ball = frep::make_field(s::sphere(1));
const Box around{{-1.2, -1.3, -1.4}, {1.3, 1.2, 1.1}};

TEST(AsdfTest, InterpolatesToWithinItsError) {
  for (const double max_error : {0.0, 0.005, 0.02}) {
    const auto asdf = Asdf::build(*ball, around, {0.05, max_error, true});
    double worst = 0;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < 20000; ++i) {
      Vec3 direction(unit(random), unit(random), unit(random));
      if (direction.norm() < 0.1) continue;
      direction.normalize();
      // points of the surface lie in leafs
      worst = std::max(worst, std::abs(asdf->value(direction) - 0.0));
    }
    // In a smallest cell the interpolation error is due to curvature, about voxel^2 / 4; 16 bits
    // add 1/32767 of a cell.
    EXPECT_LT(worst, max_error + 0.05 * 0.05 / 2);
  }
}

TEST(AsdfTest, KeepsEverySampleToMaxError) {
  // At lattice points merging and quantization to 16 bits are the only errors.
  const double max_error = 0.01;
  const auto asdf = Asdf::build(*ball, {Vec3::Constant(-1.5), Vec3::Constant(1.5)}, {3.0 / 64, max_error, true});
  const double far = asdf->voxel() * std::sqrt(3.0);
  int samples = 0;
  for (int k = 0; k <= 64; ++k)
    for (int j = 0; j <= 64; ++j)
      for (int i = 0; i <= 64; ++i) {
        const Vec3 p = Vec3::Constant(-1.5) + Vec3(i, j, k) * (3.0 / 64);
        const double stored = asdf->value(p), truth = p.norm() - 1;
        if (std::abs(std::abs(stored) - far) < 1e-5) {
          EXPECT_EQ(stored < 0, truth < 0);
          continue;
        }
        ++samples;
        EXPECT_LT(std::abs(stored - truth), max_error * 1.1 + 1e-4);
      }
  EXPECT_GT(samples, 5000);
}

TEST(AsdfTest, MergesFlatThingsAndNeedsFewBytes) {
  const auto cube =
      Asdf::build(*frep::make_field(s::box(2, 2, 2)), {Vec3::Constant(-1.3), Vec3::Constant(1.3)}, {2.6 / 100});
  const auto plain = Asdf::build(*frep::make_field(s::box(2, 2, 2)), {Vec3::Constant(-1.3), Vec3::Constant(1.3)},
                                 {2.6 / 100, 0, false});
  EXPECT_LT(cube->statistics().cells() * 5, plain->statistics().cells());
  for (const auto& asdf : {cube, plain}) {
    const AsdfStatistics counts = asdf->statistics();
    EXPECT_LE(counts.bytes, 24 * counts.cells());
    EXPECT_GT(counts.leafs, 0U);
  }
}

TEST(AsdfTest, TakesAnyRegion) {
  for (const Box& region : {Box{{-1.1, -1.1, -0.05}, {1.1, 1.1, 0.031}}, Box{{-1.5, -1.2, 0}, {1.5, 1.2, 0}},
                            Box{{0.2, -2, -1}, {0.9, 2, 1.7}}}) {
    const auto asdf = Asdf::build(*ball, region, {0.03});
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 3000; ++i) {
      const Vec3 p = region.lower + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(region.size());
      if (std::abs(p.norm() - 1) > 0.04) {
        EXPECT_EQ(asdf->value(p) < 0, p.norm() < 1) << p.transpose();
      }
    }
  }
  EXPECT_THROW(Asdf::build(*ball, {{0, 0, 0}, {0, 1, 1}}, {0.1}), Error);
  EXPECT_THROW(Asdf::build(*ball, {{0, 0, 0}, {-1, 1, 1}}, {0.1}), Error);
  EXPECT_THROW(Asdf::build(*ball, {{0, 0, 0}, {INFINITY, 1, 1}}, {0.1}), Error);
  EXPECT_THROW(Asdf::build(*ball, around, {0}), Error);
  EXPECT_THROW(Asdf::build(*ball, around, {NAN}), Error);
  EXPECT_THROW(Asdf::build(*ball, around, {1e-12}), Error);
}

TEST(AsdfTest, SlicesScalesAndShootsRays) {
  const auto asdf = Asdf::build(*ball, around, {0.04});
  const auto disc = asdf->slice(0.6);
  EXPECT_EQ(disc->lattice()[2], 0);
  EXPECT_LT(disc->value({0.7, 0, 0.6}), 0);
  EXPECT_GT(disc->value({0.9, 0, 0.6}), 0);
  EXPECT_THROW(asdf->slice(7), Error);
  const auto large = asdf->rescaled(10);
  EXPECT_NEAR(large->value({9.9, 0, 0}), -0.1, 0.05);
  EXPECT_THROW(asdf->rescaled(-1), Error);
  EXPECT_NEAR(*asdf->ray({-5, 0, 0}, {2, 0, 0}), 4, 0.005);
  EXPECT_NEAR(*asdf->ray({0, 0.3, 5}, {0, 0, -1}), 5 - std::sqrt(1 - 0.09), 0.005);
  EXPECT_FALSE(asdf->ray({-5, 1.1, 0}, {1, 0, 0}).has_value());
  EXPECT_FALSE(asdf->ray({-5, 0, 0}, {-1, 0, 0}).has_value());
}

class AsdfFiles : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path); }
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("fieldfab_" + std::to_string(::getpid()) + ".asdf");
};

TEST_F(AsdfFiles, ComeBackAsTheyWere) {
  const auto asdf = Asdf::build(*ball, around, {0.06});
  asdf->save(path);
  const auto again = Asdf::load(path);
  EXPECT_EQ(again->region(), asdf->region());
  EXPECT_EQ(again->lattice(), asdf->lattice());
  EXPECT_EQ(again->statistics().cells(), asdf->statistics().cells());
  // Half a quantum, plus rounding to 16 bits.
  const double bound = 0.5 * AsdfFileSettings{}.quantum_for(asdf->voxel()) + 4e-5;
  for (double x = -1.1; x < 1.2; x += 0.0371) {
    EXPECT_NEAR(again->value({x, 0.1, 0.2}), asdf->value({x, 0.1, 0.2}), bound);
    EXPECT_EQ(again->value({x, 0.1, 0.2}) < 0, asdf->value({x, 0.1, 0.2}) < 0);
  }
  again->save(path);
  const auto once_more = Asdf::load(path);
  for (double x = -1.1; x < 1.2; x += 0.0371)
    EXPECT_NEAR(once_more->value({x, 0.1, 0.2}), again->value({x, 0.1, 0.2}), 4e-5);
}

TEST_F(AsdfFiles, HoldLevelsAndRegions) {
  const auto asdf = Asdf::build(*ball, around, {0.01});
  asdf->save(path, {-1, 3});
  const AsdfFileInfo info = Asdf::look(path);
  ASSERT_EQ(info.levels.size(), 3U);
  EXPECT_GT(info.levels[0].blocks, 8U);
  for (int level = 0; level < 3; ++level) {
    const auto here = Asdf::load(path, {level, {}});
    EXPECT_EQ(here->region(), asdf->region());
    EXPECT_NEAR(here->voxel(), asdf->voxel() * (1 << level), 0.02 * asdf->voxel() * (1 << level));
    EXPECT_EQ(here->statistics().cells(), info.levels[static_cast<std::size_t>(level)].cells);
    for (double x = -1.05; x < 1.1; x += 0.0371) {
      const double truth = ball->value({x, 0.1, 0.2}), value = here->value({x, 0.1, 0.2}), cell = 0.01 * (1 << level);
      const bool in_leaf = std::abs(value) < 1.6 * cell;
      EXPECT_TRUE(in_leaf ? std::abs(value - truth) < 0.15 * cell : (value < 0) == (truth < 0)) << x;
    }
  }
  EXPECT_THROW(Asdf::load(path, {3, {}}), Error);
  const Box corner{{0.2, 0.2, 0.2}, {1, 1, 1}};
  const auto part = Asdf::load(path, {0, corner});
  EXPECT_LT(part->statistics().leafs, asdf->statistics().leafs / 2);
  const auto all = Asdf::load(path);
  for (double x = 0.21; x < 1; x += 0.0371) EXPECT_EQ(part->value({x, 0.3, 0.4}), all->value({x, 0.3, 0.4}));
}

TEST_F(AsdfFiles, ThatAreDamagedAreRefused) {
  Asdf::build(*ball, around, {0.2})->save(path);
  const std::string whole = read_file(path);
  std::mt19937 random(2);
  for (std::size_t i = 0; i < 400; ++i) {
    std::string bytes = whole;
    if (i % 2 == 0)
      bytes[random() % bytes.size()] ^= static_cast<char>(1U << random() % 8);
    else
      bytes.resize(random() % bytes.size());
    write_file(path, bytes);
    EXPECT_THROW(Asdf::load(path), Error) << i;
  }
}

TEST_F(AsdfFiles, OfKokopelliAreRead) {
  const auto torus = Asdf::load(TEST_DATA "/asdf/kokopelli_torus_24.asdf");
  EXPECT_EQ(torus->lattice(), (std::array<int, 3>{24, 24, 9}));
  const auto tangle = Asdf::load(TEST_DATA "/asdf/kokopelli_tanglecube_32.asdf");
  EXPECT_EQ(tangle->lattice(), (std::array<int, 3>{32, 32, 32}));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p(1.6 * unit(random), 1.6 * unit(random), 0.6 * unit(random));
    const double ring = std::hypot(p.x(), p.y()) - 1, truth = std::hypot(ring, p.z()) - 0.4;
    if (std::abs(truth) > 0.05) {
      EXPECT_EQ(torus->value(p) < 0, truth < 0) << p.transpose();
    } else if (std::abs(torus->value(p)) < 0.2) {
      // in a leaf: the distance itself, up to the curvature in a cell of 0.13
      EXPECT_NEAR(torus->value(p), truth, 0.03);
    }
  }
  const FieldPtr field = frep::make_field(frep::parse_vm(read_file(TEST_DATA "/frep/tanglecube.vm")));
  int wrong = 0;
  for (int k = 1; k < 32; ++k)  // at lattice points the file stores the value itself, in 16 bits
    for (int j = 1; j < 32; ++j)
      for (int i = 1; i < 32; ++i) {
        const Vec3 p = Vec3::Constant(-2.5) + Vec3(i, j, k) * (5.0 / 32);
        wrong += std::abs(field->value(p)) > 0.5 && (tangle->value(p) < 0) != (field->value(p) < 0);
      }
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace fieldfab

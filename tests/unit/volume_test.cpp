// Volumes: each routine against its slow, obvious twin, and against solids of known size.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "../family.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/field/surface_distance.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/solid/scan_solid.h"
#include "fieldfab/volume/distances.h"

namespace fieldfab {
namespace {

SampleLattice lattice_of(int nx, int ny, int nz, const Vec3& spacing = Vec3::Ones(),
                         const Vec3& origin = Vec3::Zero()) {
  SampleLattice lattice;
  lattice.size = {nx, ny, nz};
  lattice.spacing = spacing;
  lattice.origin = origin;
  return lattice;
}

template <class Density>
VolumePtr volume_by(const SampleLattice& lattice, const Density& density) {
  std::vector<float> densities;
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i)
        densities.push_back(static_cast<float>(
            density(Vec3(lattice.origin + lattice.axes * lattice.spacing.cwiseProduct(Vec3(i, j, k))))));
  return volume_of(std::move(densities), lattice);
}

VolumePtr random_volume(const SampleLattice& lattice, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(100, 30);
  return volume_by(lattice, [&](const Vec3&) { return noise(random); });
}

float density_at(const Volume& volume, int i, int j, int k) {
  std::vector<float> slice(volume.lattice().slice());
  volume.read(k, 1, slice.data());
  return slice[static_cast<std::size_t>(i) +
               static_cast<std::size_t>(volume.lattice().size[0]) * static_cast<std::size_t>(j)];
}

/// Trilinear interpolation of densities, the slow twin; `at` in samples.
double trilinear(const Volume& volume, const Vec3& at) {
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::array<int, 3> sample{};
    for (int axis = 0; axis < 3; ++axis) {
      const int low = std::min(static_cast<int>(at[axis]), volume.lattice().size[static_cast<std::size_t>(axis)] - 2);
      const bool upper = (corner >> axis & 1) != 0;
      sample[static_cast<std::size_t>(axis)] = low + (upper ? 1 : 0);
      weight *= upper ? at[axis] - low : 1 - (at[axis] - low);
    }
    sum += weight * density_at(volume, sample[0], sample[1], sample[2]);
  }
  return sum;
}

double uniform(std::mt19937& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

TEST(VolumeField, StaysSmoothWhereItIsJoinedWithOtherSolids) {
  // Interpolated noise has a crease at every cell; contouring must not search for edges there, also
  // if another solid is adjacent.
  std::mt19937 random(5);
  std::normal_distribution<double> grain(0, 6);
  const VolumePtr scan = volume_by(lattice_of(14, 14, 14), [&](const Vec3& p) {
    return 100 + 20 * (5 - (p - Vec3::Constant(6.5)).norm()) + grain(random);
  });
  const FieldPtr noise = scale(volume_field(*scan, {100, false, 0.02}), Vec3::Constant(0.8));
  EXPECT_TRUE(noise->sampled());
  EXPECT_TRUE(offset(noise, 0.1)->sampled());
  const FieldPtr ball = offset(translate(box_field({Vec3::Constant(-0.5), Vec3::Constant(0.5)}), {30, 0, 0}), 1);
  const Box bounds{{-1, -1, -1}, {34, 12, 12}};
  const auto triangles = [&](const FieldPtr& field) {
    const TriangleMesh mesh = contour(*field, bounds, {0.4});
    return std::count_if(mesh.triangles.begin(), mesh.triangles.end(),
                         [&](const auto& t) { return mesh.vertices[t[0]][0] < 20; });
  };
  const auto alone = triangles(noise);
  EXPECT_GT(alone, 1000);
  // Curves on cells' faces are bent as for any solid; edges would triple the number.
  EXPECT_LT(triangles(unite(noise, ball)), 1.4 * static_cast<double>(alone));
  EXPECT_LT(triangles(blend(noise, ball, 0.5)), 1.4 * static_cast<double>(alone));
  // Both solids meet in a fillet; the other solid's own edges elsewhere stay sharp.
  const FieldPtr plate = box_field({{-0.9, -0.9, -0.9}, {11.9, 11.9, 1.2}}), both = blend(plate, noise, 2);
  EXPECT_FALSE(both->sampled());
  ContourSettings without{0.4};
  without.features = false;
  const auto plain = contour(*both, bounds, without).triangles.size();
  const TriangleMesh sharp = contour(*both, bounds, {0.4});
  EXPECT_LT(sharp.triangles.size(), 1.5 * static_cast<double>(plain));
  EXPECT_TRUE(std::any_of(sharp.vertices.begin(), sharp.vertices.end(),
                          [](const auto& v) { return std::hypot(v[0] + 0.9, v[1] + 0.9, v[2] + 0.9) < 1e-3; }));
}

TEST(VolumeField, IsTrilinearBetweenSamplesAndEmptyOutside) {
  const SampleLattice lattice = lattice_of(7, 5, 6, {0.5, 0.7, 1.3}, {10, -3, 2});
  const VolumePtr volume = random_volume(lattice, 1);
  for (const bool below : {false, true}) {
    const FieldPtr solid = volume_field(*volume, {100, below, 0.01});
    std::mt19937 random(2);
    for (int n = 0; n < 2000; ++n) {
      const Vec3 samples(uniform(random, 0, 6), uniform(random, 0, 4), uniform(random, 0, 5));
      const Vec3 p = lattice.origin + lattice.spacing.cwiseProduct(samples);
      const double wanted = (below ? -1 : 1) * (100 - trilinear(*volume, samples)) * 0.01;
      const Box box = solid->known_bounds();
      EXPECT_TRUE(box.contains(lattice.box().lower) && !box.contains(lattice.box().grown(0.002).lower));
      const double cap = std::max((box.lower - p).maxCoeff(), (p - box.upper).maxCoeff());
      EXPECT_NEAR(solid->value(p), std::max(wanted, cap), 2e-5);
    }
    for (int n = 0; n < 500; ++n) {
      Vec3 p(uniform(random, 8, 15), uniform(random, -5, 2), uniform(random, 0, 11));
      EXPECT_TRUE(solid->known_bounds().contains(p) || solid->value(p) > 0);
    }
  }
}

TEST(VolumeField, GradientsAreDifferences) {
  const VolumePtr volume = random_volume(lattice_of(9, 8, 7, {0.5, 0.7, 1.3}), 3);
  const FieldPtr solid = volume_field(*volume, {100, false, 0.02});
  std::mt19937 random(4);
  const double h = 1e-3;
  for (int n = 0; n < 500; ++n) {
    // Off the planes of samples, where slopes are discontinuous.
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
      p[axis] = volume->lattice().spacing[axis] * (static_cast<int>(uniform(random, 1, 5)) + uniform(random, 0.1, 0.9));
    const Vec3 slope = solid->gradient(p);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec3 step = h * Vec3::Unit(axis);
      EXPECT_NEAR(slope[axis], (double{solid->value(p + step)} - solid->value(p - step)) / (2 * h), 5e-3);
    }
  }
}

TEST(VolumeField, IntervalsHoldEveryValue) {
  const VolumePtr volume = random_volume(lattice_of(40, 33, 30, {0.5, 0.7, 1.3}, {-5, 0, 7}), 5);
  const FieldPtr solid = volume_field(*volume, {100, false, 0.02});
  std::mt19937 random(6);
  for (int n = 0; n < 300; ++n) {
    const Vec3 a(uniform(random, -8, 18), uniform(random, -3, 26), uniform(random, 4, 50));
    const double reach = std::pow(10.0, uniform(random, -2, 1.3));
    const Box box{a, a + Vec3(uniform(random, 0, reach), uniform(random, 0, reach), uniform(random, 0, reach))};
    const Interval range = solid->interval(box);
    for (int m = 0; m < 60; ++m) {
      const Vec3 p = box.lower +
                     box.size().cwiseProduct(Vec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1)));
      EXPECT_TRUE(range.contains(solid->value(p)));
    }
  }
}

/// A scanned ball: a ramp of densities a few mm wide, constant elsewhere.
FieldPtr scanned_ball(double radius) {
  const VolumePtr ball = volume_by(lattice_of(41, 41, 41, Vec3::Ones(), Vec3::Constant(-20)), [&](const Vec3& p) {
    return std::clamp(100 - 40 * (p.norm() - radius), 0.0, 200.0);
  });
  return volume_field(*ball, isosurface(*ball, 100));
}

TEST(Distances, AreThoseToTheNearestPointOfTheSurface) {
  constexpr double radius = 8, reach = 6, voxel = 0.5;
  const FieldPtr ball = scanned_ball(radius);
  EXPECT_LT(ball->value({15, 0, 0}), 3);  // far from 7: densities contain no more information
  const FieldPtr told = distances(ball, ball->known_bounds(), {reach, voxel});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-14, 14);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p(place(random), place(random), place(random));
    const double distance = p.norm() - radius, found = told->value(p);
    EXPECT_EQ(found < 0, ball->value(p) < 0);
    if (std::abs(distance) < 2 * voxel || std::abs(distance) > reach - voxel) continue;
    // The surface itself is trilinear between samples with a spacing of 1 mm.
    ASSERT_NEAR(found, distance, 0.15 * voxel + 0.03) << p.transpose();
    EXPECT_NEAR(told->gradient(p).norm(), 1, 0.15);
  }
  EXPECT_NEAR(told->value({0, 0, 0}), -reach, 1e-3);
}

TEST(Distances, AreAsOneByOneOnARandomSolid) {
  const VolumePtr noise = halved(halved(random_volume(lattice_of(32, 32, 32), 7)));
  const FieldPtr solid = volume_field(*noise, isosurface(*noise, 100));
  constexpr double voxel = 0.5, reach = 3;
  const Box bounds = solid->known_bounds();
  const FieldPtr told = distances(solid, bounds, {reach, voxel});
  // The slow, obvious twin: least distance to any sign change on a lattice four times as fine.
  std::vector<Vec3> surface;
  constexpr double step = voxel / 4;
  const Vec3 cells = (bounds.size() / step).array().ceil() + 2;
  const auto at = [&](int i, int j, int k) -> Vec3 { return bounds.lower + step * Vec3(i - 1, j - 1, k - 1); };
  for (int k = 0; k < cells.z(); ++k)
    for (int j = 0; j < cells.y(); ++j)
      for (int i = 0; i < cells.x(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3 a = at(i, j, k), b = at(i + (axis == 0), j + (axis == 1), k + (axis == 2));
          if ((solid->value(a) < 0) != (solid->value(b) < 0)) surface.emplace_back((a + b) / 2);
        }
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0, 1);
  int compared = 0;
  double sum = 0;
  for (int n = 0; n < sample_or_all(120, 400); ++n) {
    const Vec3 p = bounds.lower + Vec3(share(random), share(random), share(random)).cwiseProduct(bounds.size());
    double least = reach;
    for (const Vec3& s : surface) least = std::min(least, (s - p).norm());
    const double found = told->value(p);
    EXPECT_EQ(found < 0, solid->value(p) < 0);
    if (least < 2 * voxel) continue;  // near the surface the value is the solid's own
    ++compared;
    sum += std::abs(std::abs(found) - least);
    // interpolation cuts off ridges, where two parts are equally near
    EXPECT_GT(std::abs(found), least - 0.3 * voxel);
    EXPECT_LT(std::abs(found), least + 0.6 * voxel);  // the lattice may have missed a small piece
  }
  EXPECT_GT(compared, sample_or_all(6, 20));
  EXPECT_LT(sum / compared, 0.1 * voxel);
}

TEST(Distances, MakeOffsetsAndBlendsOfScansRight) {
  const FieldPtr ball = scanned_ball(8), told = distances(ball, ball->known_bounds(), {5, 0.5});
  const TriangleMesh grown = contour(*offset(told, 4), {{-19, -19, -19}, {19, 19, 19}}, {0.5});
  // The scan's own surface is 0.02 mm too far in between its samples.
  EXPECT_NEAR(grown.volume(), 4 * std::numbers::pi / 3 * 12 * 12 * 12, 4 * std::numbers::pi * 12 * 12 * 0.04);
  // A plate far below the ball stays flat; by densities it would rise throughout the scan's box.
  const FieldPtr plate = box_field({{-18, -18, -18}, {18, 18, -14}});
  const FieldPtr both = blend(plate, told, 3);
  EXPECT_GT(both->value({15, 15, -13.99}), 0);
  EXPECT_LT(blend(plate, ball, 3)->value({15, 15, -13.99}), 0);
}

TEST(Distances, RefuseWhatMakesNone) {
  const FieldPtr ball = scanned_ball(8);
  EXPECT_THROW((void)distances(ball, ball->known_bounds(), {0, 0.5}), Error);
  EXPECT_THROW((void)distances(ball, Box::everything(), {1, 0.5}), Error);
  EXPECT_THROW((void)distances(ball, ball->known_bounds(), {1, 1e-3}), Error);
}

TEST(SurfaceDistance, OfAScansOwnSurfaceIsSmallEverywhere) {
  // Between noisy samples a descent along the gradient oscillates; points of the surface must still
  // have a small distance.
  std::mt19937 random(11);
  std::normal_distribution<double> grain(100, 30);
  SampleLattice lattice;
  lattice.size = {40, 40, 40};
  std::vector<float> densities(lattice.count());
  for (float& density : densities) density = static_cast<float>(grain(random));
  const FieldPtr solid = volume_field(*halved(volume_of(std::move(densities), lattice)), {100, false, 0.2});
  constexpr double cell = 0.5;
  const TriangleMesh mesh = contour(*solid, solid->known_bounds().grown(1), {cell});
  std::vector<float> found(mesh.vertices.size());
  surface_distances(*solid, mesh.vertices, found);
  double squares = 0;
  std::size_t count = 0;
  // a solid that ends at the lattice's border may be arbitrarily thin
  const Box inner = solid->known_bounds().grown(-1);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3 p(mesh.vertices[i][0], mesh.vertices[i][1], mesh.vertices[i][2]);
    if (!inner.contains(p)) continue;
    squares += found[i] * found[i];
    ++count;
    EXPECT_LT(std::abs(found[i]), 4 * cell) << p.transpose() << ": " << solid->value(p);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 0.1 * cell);
}

TEST(SurfaceDistance, IsThatOfClosedForms) {
  std::mt19937 random(4);
  std::uniform_real_distribution<float> place(-4, 4);
  std::vector<std::array<float, 3>> places(5000);
  for (auto& p : places) p = {place(random), place(random), place(random)};
  std::vector<float> found(places.size());
  // Values that are no distances: the squared distance from the centre minus a square.
  const frep::Expression x = frep::Expression::x(), y = frep::Expression::y(), z = frep::Expression::z();
  surface_distances(*frep::make_field(x * x + y * y + z * z - 4), places, found);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const float radius = std::hypot(places[i][0], places[i][1], places[i][2]);
    if (radius > 0.1F) {
      EXPECT_NEAR(found[i], radius - 2, 1e-3);
    }
  }
}

TEST(Threshold, OtsuIsTheBestOfAll) {
  std::mt19937 random(7);
  for (int n = 0; n < 50; ++n) {
    Histogram histogram;
    histogram.first = -3;
    histogram.width = 2;
    for (int i = 0; i < 40; ++i) histogram.counts.push_back(random() % 4 == 0 ? 0 : random() % 1000);
    for (const auto count : histogram.counts) histogram.samples += count;
    // Between-class variance of every threshold, from the definition (Otsu).
    const auto variance = [&](double threshold) {
      double weight[2] = {}, sum[2] = {};
      for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        const int side = histogram.middle(i) > threshold ? 1 : 0;
        weight[side] += static_cast<double>(histogram.counts[i]);
        sum[side] += static_cast<double>(histogram.counts[i]) * histogram.middle(i);
      }
      const double apart = sum[0] / weight[0] - sum[1] / weight[1];
      return weight[0] * weight[1] * apart * apart;
    };
    double best = 0;
    for (std::size_t i = 0; i + 1 < histogram.counts.size(); ++i)
      if (const double here = variance(histogram.middle(i) + 1); here > best) best = here;
    EXPECT_NEAR(variance(otsu_threshold(histogram)) / best, 1, 1e-9);
  }
}

TEST(Threshold, PercentilesLeaveThatManyBelow) {
  const VolumePtr volume = random_volume(lattice_of(30, 30, 30), 8);
  std::vector<float> all(volume->lattice().count());
  volume->read(0, 30, all.data());
  std::sort(all.begin(), all.end());
  for (const double percent : {1.0, 25.0, 50.0, 90.0, 99.0}) {
    const double threshold = threshold_by(ThresholdRule::parse(std::to_string(percent) + "%"), *volume, 1 << 20);
    const auto below = std::lower_bound(all.begin(), all.end(), threshold) - all.begin();
    EXPECT_NEAR(static_cast<double>(below) / static_cast<double>(all.size()), percent / 100, 1e-3);
  }
  EXPECT_THROW(threshold_by(ThresholdRule::parse("1000"), *volume, 1 << 20), Error);
  EXPECT_THROW(ThresholdRule::parse("many"), Error);
  EXPECT_THROW(ThresholdRule::parse("101%"), Error);
}

TEST(Threshold, DensitiesThatAreNoNumbersAreRefused) {
  for (const double wild : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    const VolumePtr volume =
        volume_by(lattice_of(6, 5, 4), [&](const Vec3& p) { return p == Vec3(3, 2, 1) ? wild : p.x(); });
    try {
      histogram(*volume, 1 << 20);
      FAIL();
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("(3, 2, 1)"), std::string::npos) << error.what();
    }
  }
}

TEST(Volumes, AxesThatRunBackwardsAreTurned) {
  SampleLattice lattice = lattice_of(4, 5, 6, {1, 2, 3}, {10, 20, 30});
  lattice.axes.diagonal() << -1, 1, -1;
  const VolumePtr volume = random_volume(lattice, 9), straight = straightened(volume);
  EXPECT_TRUE(straight->lattice().straight());
  EXPECT_EQ(straight->lattice().origin, Vec3(7, 20, 15));
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i) EXPECT_EQ(density_at(*straight, i, j, k), density_at(*volume, 3 - i, j, 5 - k));
  lattice.axes = Eigen::AngleAxisd(0.3, Vec3::UnitX()).toRotationMatrix();
  const VolumePtr askew = random_volume(lattice, 9);
  EXPECT_EQ(straightened(askew), askew);
}

TEST(Volumes, AskewOnesStandWhereTheyShould) {
  SampleLattice lattice = lattice_of(30, 30, 30, {1, 1, 1.5}, {5, -40, 8});
  lattice.axes = (Eigen::AngleAxisd(0.4, Vec3::UnitX()) * Eigen::AngleAxisd(-0.7, Vec3::UnitZ())).toRotationMatrix();
  const Vec3 centre = lattice.origin + lattice.axes * Vec3(14, 15, 20);
  const VolumePtr volume = volume_by(lattice, [&](const Vec3& p) { return 100 - (p - centre).norm(); });
  const FieldPtr solid = volume_field(*volume, isosurface(*volume, 91));
  std::mt19937 random(10);
  for (int n = 0; n < 200; ++n) {
    const Vec3 towards = Vec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)).normalized();
    EXPECT_LT(solid->value(centre + 8.9 * towards), 0);
    EXPECT_GT(solid->value(centre + 9.1 * towards), 0);
  }
}

TEST(Volumes, CroppedAndHalved) {
  const VolumePtr volume = random_volume(lattice_of(9, 8, 7, {1, 2, 3}, {1, 1, 1}), 11);
  const VolumePtr part = cropped(volume, {2, 1, 3}, {4, 5, 2});
  EXPECT_EQ(part->lattice().origin, Vec3(3, 3, 10));
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i) EXPECT_EQ(density_at(*part, i, j, k), density_at(*volume, i + 2, j + 1, k + 3));
  EXPECT_THROW(cropped(volume, {6, 0, 0}, {4, 2, 2}), Error);
  EXPECT_THROW(cropped(volume, {0, 0, 0}, {2147483647, 2, 2}), Error);

  // A linear volume stays linear except at the border.
  const VolumePtr slope = volume_by(lattice_of(11, 11, 11), [](const Vec3& p) { return p.x() + 2 * p.y() - p.z(); });
  const VolumePtr half = halved(slope);
  EXPECT_EQ(half->lattice().size, (std::array{6, 6, 6}));
  for (int i = 1; i < 5; ++i) EXPECT_NEAR(density_at(*half, i, 2, 3), 2 * i + 2 * 4 - 6, 1e-4);
}

TEST(Clean, CrumbsGoAndCavitiesAreFilled) {
  const auto ball = [](const Vec3& p, const Vec3& centre, double radius) { return radius - (p - centre).norm(); };
  const VolumePtr volume = volume_by(lattice_of(40, 30, 30), [&](const Vec3& p) {
    const double hollow = std::min(ball(p, {12, 15, 15}, 9), -ball(p, {12, 15, 15}, 4));
    return 100 + 10 * std::max({hollow, ball(p, {30, 15, 15}, 5), ball(p, {35, 4, 4}, 1.5)});
  });
  const auto pieces = [&](const CleanSettings& settings) {
    const VolumePtr clean = cleaned(volume, 100, false, settings);
    const FieldPtr solid = volume_field(*clean, isosurface(*clean, 100));
    return std::array{solid->value({12, 15, 22}) < 0, solid->value({12, 15, 15}) < 0, solid->value({30, 15, 15}) < 0,
                      solid->value({35, 4, 4}) < 0};
  };
  EXPECT_EQ(pieces({}), (std::array{true, false, true, true}));
  EXPECT_EQ(pieces({{}, true, {}, {}}), (std::array{true, false, false, false}));
  EXPECT_EQ(pieces({{}, false, 50, {}}), (std::array{true, false, true, false}));
  EXPECT_EQ(pieces({{}, false, {}, 1e9}), (std::array{true, true, true, true}));
  EXPECT_EQ(pieces({{}, false, {}, 10}), (std::array{true, false, true, true}));
  // After inversion a former cavity is a piece of its own.
  const VolumePtr inverted = cleaned(volume, 100, true, {{}, true, {}, {}});
  EXPECT_GE(density_at(*inverted, 12, 15, 15), 100);
  EXPECT_LT(density_at(*inverted, 1, 1, 1), 100);
}

class Import : public testing::Test {
 protected:
  void TearDown() override {
    for (const auto& path : {first, second}) std::filesystem::remove(path);
  }
  static std::filesystem::path temporary(const char* name) {
    return std::filesystem::temp_directory_path() / ("fieldfab_import_" + std::to_string(::getpid()) + name);
  }
  std::filesystem::path first = temporary("1.asdf"), second = temporary("2.asdf");
};

/// Waves with a little noise: some cells merge, others do not.
VolumePtr waves(const SampleLattice& lattice) {
  std::mt19937 random(13);
  std::normal_distribution<double> noise(0, 0.01);
  return volume_by(lattice, [&](const Vec3& p) {
    return 1000 * (std::sin(p.x() / 6) * std::cos(p.y() / 7) + std::sin(p.z() / 5) + (p.x() > 40 ? noise(random) : 0));
  });
}

TEST_F(Import, TheFileIsTheSameForAnyMemoryAndThreads) {
  const VolumePtr volume = waves(lattice_of(150, 70, 131));
  const Scan scan{volume, isosurface(*volume, 200)};
  import_scan(scan, first, {});
  for (const std::size_t memory : {std::size_t{1} << 16, std::size_t{3} << 20}) {
    const ThreadLimit one(memory == 1 << 16 ? 1 : 0);
    import_scan(scan, second, {-1, {}, memory});
    EXPECT_EQ(read_file(first), read_file(second));
  }
}

TEST_F(Import, TheSurfaceIsThatOfTheSamples) {
  const VolumePtr volume = waves(lattice_of(100, 70, 81, {0.5, 0.5, 1}, {3, 4, 5}));
  const Scan scan{volume, isosurface(*volume, 200)};
  import_scan(scan, first, {0.05, {}});
  const auto asdf = Asdf::load(first);
  const FieldPtr truth = volume_field(*volume, scan.surface);
  EXPECT_EQ(asdf->region(), volume->lattice().box());
  // In both directions: near each point of one surface the other solid changes its sign, within the
  // tolerance.
  const auto farther = [&](const Field& of, const Field& from, double distance) {
    std::mt19937 random(15);
    int found = 0, missed = 0;
    while (found < 4000) {
      Vec3 low = asdf->region().lower +
                 asdf->region().size().cwiseProduct(
                     Vec3(uniform(random, 0.02, 0.96), uniform(random, 0.02, 0.96), uniform(random, 0.02, 0.96)));
      Vec3 high = low + uniform(random, 0.2, 1) * Vec3::Unit(static_cast<Eigen::Index>(random() % 3));
      const bool inside = of.value(low) < 0;
      if (inside == (of.value(high) < 0)) continue;
      for (int i = 0; i < 30; ++i) {
        const Vec3 middle = 0.5 * (low + high);
        ((of.value(middle) < 0) == inside ? low : high) = middle;
      }
      ++found;
      bool near = false;
      for (const Vec3& way : {from.gradient(low), of.gradient(low), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Vec3 step = distance * way.normalized();
        near = near || (from.value(low + step) < 0) != (from.value(low - step) < 0);
      }
      missed += near ? 0 : 1;
    }
    return missed;
  };
  EXPECT_EQ(farther(*asdf, *truth, 0.051), 0);
  EXPECT_EQ(farther(*truth, *asdf, 0.051), 0);
}

TEST_F(Import, BallsComeBackWithTheirDiameters) {
  // Spacing 0.2 mm (0.2 x 0.2 x 0.3), blurred, noisy: the diameter must be accurate to 0.02 mm.
  std::mt19937 random(14);
  std::normal_distribution<double> noise(0, 15);
  for (const double diameter : {3.0, 7.3}) {
    const SampleLattice lattice = lattice_of(50, 50, 36, {0.2, 0.2, 0.3});
    const Vec3 centre(4.93, 4.87, 5.21);
    const VolumePtr volume = volume_by(lattice, [&](const Vec3& p) {
      return 500 * (1 - std::erf(((p - centre).norm() - diameter / 2) / 0.35)) + noise(random);
    });
    const Scan scan = take_scan(volume, {});
    import_scan(scan, first, {});
    const auto asdf = Asdf::load(first);
    const double volume_of_ball = contour(*asdf, asdf->region(), {0.2, 0.01, false}).volume();
    EXPECT_NEAR(std::cbrt(6 * volume_of_ball / std::numbers::pi), diameter, 0.02);
  }
}

TEST_F(Import, CylindersComeBackWithTheirDiameters) {
  // Through the lattice from end to end, slightly tilted, blurred and noisy.
  std::mt19937 random(16);
  std::normal_distribution<double> noise(0, 15);
  const Vec3 along = Vec3(0.1, 0.05, 1).normalized(), through(4.93, 4.87, 5.21);
  for (const double diameter : {3.0, 7.3}) {
    const SampleLattice lattice = lattice_of(50, 50, 36, {0.2, 0.2, 0.3});
    const VolumePtr volume = volume_by(lattice, [&](const Vec3& p) {
      const Vec3 off = p - through;
      return 500 * (1 - std::erf(((off - off.dot(along) * along).norm() - diameter / 2) / 0.35)) + noise(random);
    });
    import_scan(take_scan(volume, {}), first, {});
    const auto asdf = Asdf::load(first);
    const double held = contour(*asdf, asdf->region(), {0.2, 0.01, false}).volume();
    const double length = asdf->region().size().z() / along.z();
    EXPECT_NEAR(2 * std::sqrt(held / length / std::numbers::pi), diameter, 0.02);
  }
}

TEST_F(Import, LevelsAreHalves) {
  const VolumePtr volume = waves(lattice_of(101, 71, 81));
  import_scan({volume, isosurface(*volume, 200)}, first, {-1, {-1, 3}});
  ASSERT_EQ(Asdf::look(first).levels.size(), 3U);
  EXPECT_EQ(Asdf::load(first, {2, {}})->lattice(), (std::array{25, 17, 20}));
  const auto fine = Asdf::load(first), coarse = Asdf::load(first, {1, {}});
  const Vec3 inside(9, 3, 8);
  EXPECT_EQ(fine->value(inside) < 0, coarse->value(inside) < 0);
}

TEST_F(Import, WhatIsCancelledLeavesNothing) {
  const VolumePtr volume = waves(lattice_of(80, 80, 80));
  Progress progress([&](double fraction, const std::string&) {
    if (fraction > 0) progress.cancel();
  });
  EXPECT_THROW(import_scan({volume, isosurface(*volume, 200)}, first, {-1, {}, 1 << 16}, progress), Error);
  EXPECT_FALSE(std::filesystem::exists(first));
}

}  // namespace
}  // namespace fieldfab

// Scans: the mesh has the topology of the trilinear interpolation of the samples, and reports
// certainty.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "../family.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/volume/volume_field.h"

namespace fieldfab {
namespace {

long euler(const TriangleMesh& mesh) {
  std::set<std::array<std::uint32_t, 2>> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) edges.insert({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.triangles.size());
}

/// Small cubes of a solid, centred at points that divide a box evenly, its border included, with
/// air around them.
class Cubes {
 public:
  Cubes(const Field& field, const Box& box, const std::array<int, 3>& count)
      : size_{count[0] + 3, count[1] + 3, count[2] + 3} {
    solid_.resize(static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1]) *
                  static_cast<std::size_t>(size_[2]));
    const Vec3 side = box.size().cwiseQuotient(Vec3(count[0], count[1], count[2]));
    for (int k = 0; k <= count[2]; ++k)
      for (int j = 0; j <= count[1]; ++j)
        for (int i = 0; i <= count[0]; ++i)
          solid_[index(i + 1, j + 1, k + 1)] = field.value(box.lower + side.cwiseProduct(Vec3(i, j, k))) < 0;
  }

  /// Euler characteristic of the union of the closed cubes, or of its interior. The two differ if
  /// cubes touch in an edge or a corner only; then the topology of the solid differs from that of
  /// its cubes, too.
  [[nodiscard]] long euler(bool closed) const {
    long sum = 0;
    for (int k = 1; k < size_[2]; ++k)
      for (int j = 1; j < size_[1]; ++j)
        for (int i = 1; i < size_[0]; ++i)
          for (int element = 0; element < 8; ++element) {  // bit a: it extends along axis a
            bool any = false, all = true;
            for (int cube = 0; cube < 8; ++cube) {
              if ((cube & element) != 0) continue;
              const bool here = solid_[index(i - (cube & 1), j - (cube >> 1 & 1), k - (cube >> 2))];
              any = any || here, all = all && here;
            }
            const int dimension = (element & 1) + (element >> 1 & 1) + (element >> 2);
            if (closed ? any : all) sum += (dimension % 2 == 0 ? 1 : -1) * (closed ? 1 : -1);
          }
    return sum;
  }

 private:
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return static_cast<std::size_t>(i + size_[0] * (j + size_[1] * k));
  }
  std::array<int, 3> size_;
  std::vector<bool> solid_;
};

TEST(ScanCertain, NoiseHasItsOwnTopology) {
  int certain = 0, compared = 0;
  const int all = sample_or_all(20, 60);
  for (int seed = 0; seed < all; ++seed) {
    std::mt19937 random(static_cast<unsigned>(seed));
    std::normal_distribution<float> noise(0, 1);
    SampleLattice lattice;
    lattice.size = {5, 6, 4};
    lattice.spacing = seed % 2 == 0 ? Vec3(1, 1, 1) : Vec3(0.338, 0.338, 0.5);
    lattice.origin = {-3.7, 11.3, 0.2};
    std::vector<float> samples(lattice.count());
    for (float& sample : samples) sample = noise(random) - (seed % 3 == 0 ? 1.0F : 0.3F);
    const FieldPtr field = volume_field(*volume_of(samples, lattice), {0, false, 0.3});
    const double finer = seed % 5 == 4 ? 0.4 : 1;
    const ContourMesh mesh =
        contour(*field, field->known_bounds().grown(0.1), {finer * lattice.spacing.minCoeff(), -1, true});
    const MeshVerdict verdict = inspect(mesh);
    EXPECT_TRUE(verdict.valid()) << seed;
    if (!mesh.certainty.certain()) continue;
    ++certain;
    constexpr int fine = 24;
    const Cubes cubes(*field, lattice.box(), {4 * fine, 5 * fine, 3 * fine});
    const long wanted = cubes.euler(true);
    if (cubes.euler(false) != wanted) continue;  // the cubes are too large to decide
    ++compared;
    EXPECT_EQ(euler(mesh), 2 * wanted) << seed << " " << finer;
  }
  EXPECT_GT(certain, all * 9 / 10);
  EXPECT_GT(compared, all / 2);
}

TEST(ScanCertain, ASingleSampleIsThere) {
  for (const Vec3& at : {Vec3(3, 3, 3), Vec3(0, 3, 3), Vec3(7, 0, 2), Vec3(7, 7, 7)}) {
    SampleLattice lattice;
    lattice.size = {8, 8, 8};
    lattice.spacing = {0.25, 0.3, 0.7};
    std::vector<float> samples(lattice.count(), 0);
    samples[static_cast<std::size_t>(at.x() + 8 * (at.y() + 8 * at.z()))] = 100;
    const FieldPtr field = volume_field(*volume_of(samples, lattice), {99.9, false, 0.01});
    const ContourMesh mesh = contour(*field, field->known_bounds().grown(1), {0.25, -1, true});
    EXPECT_TRUE(mesh.certainty.certain()) << mesh.certainty.text();
    EXPECT_EQ(euler(mesh), 2) << at.transpose();
  }
}

TEST(ScanCertain, LargerCellsAndTurnedScansAreToldOf) {
  SampleLattice lattice;
  lattice.size = {8, 8, 8};
  std::vector<float> samples(lattice.count(), 0);
  samples[static_cast<std::size_t>(3 + 8 * (3 + 8 * 3))] = 100;
  const FieldPtr field = volume_field(*volume_of(samples, lattice), {50, false, 0.01});
  EXPECT_FALSE(contour(*field, field->known_bounds().grown(1), {1.5, -1, true}).certainty.certain());
  const FieldPtr turned = rotate(field, {0, 0, 1}, 0.3);
  EXPECT_FALSE(contour(*turned, turned->known_bounds().grown(1), {1, -1, true}).certainty.certain());
  const FieldPtr mirrored = translate(scale(field, {-1, 2, 1}), {0.1, 0.2, 0.3});
  EXPECT_TRUE(contour(*mirrored, mirrored->known_bounds().grown(1), {1, -1, true}).certainty.certain());
}

TEST(ScanCertain, AreCutWhereTheRegionEnds) {
  SampleLattice lattice;
  lattice.size = {9, 9, 9};
  const FieldPtr field = volume_field(*volume_of(std::vector<float>(lattice.count(), 100), lattice), {50, false, 0.01});
  const ContourMesh whole = contour(*field, lattice.box(), {1, -1, true});
  EXPECT_TRUE(whole.certainty.certain());
  EXPECT_NEAR(whole.volume(), 8 * 8 * 8, 2);
  for (const double inside : {0.1, 0.4, 0.7})
    EXPECT_NEAR(contour(*field, lattice.box().grown(-inside), {1, -1, true}).bounds().size().x(), 8 - 2 * inside, 0.01)
        << inside;
}

}  // namespace
}  // namespace fieldfab

// Distances to a mesh on a lattice, against mesh_field(), which is an independent implementation.
#include "fieldfab/mesh/mesh_distances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../family.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab {
namespace {

TriangleMesh ball_at(const Vec3& centre, double voxel = 0.3) {
  const FieldPtr ball = translate(frep::make_field(frep::shapes::sphere(1)), centre);
  return contour(*ball, Box{centre.array() - 1.2, centre.array() + 1.2}, {voxel});
}

void append(TriangleMesh& mesh, const TriangleMesh& other, bool inverted) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (auto t : other.triangles) {
    if (inverted) std::swap(t[0], t[1]);
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

TriangleMesh cube(float side) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back({(i & 1) ? side : 0.0F, (i & 2) ? side : 0.0F, (i & 4) ? side : 0.0F});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

void expect_as_the_field(const TriangleMesh& mesh, const DistanceLattice& lattice, double reach) {
  const std::vector<float> found = mesh_distances(mesh, lattice, reach);
  const FieldPtr field = mesh_field(mesh);
  ASSERT_EQ(static_cast<double>(found.size()), lattice.points());
  std::size_t n = 0, within = 0;
  for (int k = 0; k < lattice.size[2]; ++k)
    for (int j = 0; j < lattice.size[1]; ++j)
      for (int i = 0; i < lattice.size[0]; ++i, ++n) {
        const Vec3 p = lattice.origin + lattice.spacing * Vec3(i, j, k);
        const double expected = std::clamp(static_cast<double>(field->value(p)), -reach, reach);
        if (std::abs(expected) < 1e-5)  // on the surface the sign is undefined
          ASSERT_NEAR(std::abs(found[n]), 0, 2e-5) << p.transpose();
        else
          ASSERT_NEAR(found[n], expected, 2e-5) << p.transpose();
        within += std::abs(expected) < reach ? 1 : 0;
      }
  EXPECT_GT(within, found.size() / 50);
}

TEST(MeshDistances, AgreeWithTheMeshFieldOnOverlapsAndInvertedParts) {
  TriangleMesh mesh = ball_at({0, 0, 0});
  append(mesh, ball_at({1.1, 0.2, 0.1}), false);
  append(mesh, ball_at({-2.5, 0, 0}), true);
  const Vec3 corner(-4.03, -1.51, -1.52);
  expect_as_the_field(mesh, sample_or_all<DistanceLattice>({corner, 0.19, {35, 16, 16}}, {corner, 0.11, {60, 28, 28}}),
                      sample_or_all(0.4, 0.25));
  expect_as_the_field(mesh, sample_or_all<DistanceLattice>({corner, 0.23, {29, 14, 14}}, {corner, 0.13, {52, 24, 24}}),
                      2.0);
}

TEST(MeshDistances, HoldOnPlacesThatLieOnEdgesAndFaces) {
  expect_as_the_field(cube(2), {{-1, -1, -1}, 0.5, {9, 9, 9}}, 0.9);
  expect_as_the_field(cube(1), {{-0.5, -0.5, -0.5}, 0.25, {9, 9, 9}}, 0.6);
}

TEST(MeshDistances, AFewFlatTrianglesAreEnoughForALargeLattice) {
  TriangleMesh mesh = cube(1);
  for (auto& p : mesh.vertices) {  // rotated, so that no face is axis-aligned
    const float x = p[0], y = p[1], z = p[2];
    p = {0.8F * x - 0.6F * y, 0.48F * x + 0.64F * y - 0.6F * z, 0.36F * x + 0.48F * y + 0.8F * z};
  }
  expect_as_the_field(mesh, {{-0.71, -0.72, -0.13}, 0.05, {38, 45, 37}}, 0.1);
}

TEST(MeshDistances, LidsCloseWhatIsOpen) {
  TriangleMesh mesh = cube(3);
  mesh.triangles.resize(10);  // without the face x = 3
  Lids lids = lids_of(mesh);
  EXPECT_EQ(lids.triangles.size(), 2u);
  EXPECT_EQ(lids.rims, 1u);
  EXPECT_NEAR(lids.area, 9, 1e-6);
  EXPECT_TRUE(lids.are_good(mesh));
  mesh = closed_by(lids, mesh);
  EXPECT_NEAR(mesh.volume(), 27, 1e-5);
  EXPECT_TRUE(lids_of(mesh).triangles.empty());
  expect_as_the_field(mesh, {{-0.53, -0.54, -0.55}, 0.2, {21, 21, 21}}, 0.5);
}

TEST(MeshDistances, LidsAreGoodWhereTheyAreSmallAndDoNotLieOverThemselves) {
  TriangleMesh inverted_face = cube(3);
  for (std::size_t t : {10, 11}) std::swap(inverted_face.triangles[t][0], inverted_face.triangles[t][1]);
  const Lids over_it = lids_of(inverted_face);  // twice, so that the winding number is 1
  EXPECT_TRUE(over_it.are_good(inverted_face));
  EXPECT_NEAR(closed_by(over_it, inverted_face).volume(), 27, 1e-5);
  EXPECT_FALSE(lids_of(cube(3)).are_good(cube(3)));  // there are none
  TriangleMesh sheet = cube(3);
  sheet.triangles.resize(2);
  EXPECT_FALSE(lids_of(sheet).are_good(sheet));
  // A box over a long thin L, without its lower face: the centre of the rim is outside of it.
  const std::vector<std::array<float, 2>> corners{{0, 0}, {10, 0}, {10, 1}, {1, 1}, {1, 10}, {0, 10}};
  TriangleMesh bent;
  for (const float z : {0.0F, 5.0F})
    for (const auto& [x, y] : corners) bent.vertices.push_back({x, y, z});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t next = (i + 1) % 6;
    bent.triangles.insert(bent.triangles.end(), {{i, next, next + 6}, {i, next + 6, i + 6}});
  }
  bent.triangles.insert(bent.triangles.end(), {{6, 7, 8}, {6, 8, 9}, {6, 9, 10}, {6, 10, 11}});
  const Lids along_it = lids_of(bent);
  EXPECT_TRUE(along_it.middles.empty());
  EXPECT_NEAR(along_it.area, 19, 1e-5);
  EXPECT_NEAR(closed_by(along_it, bent).volume(), 95, 1e-4);
  // not a single loop but two joined ones: triangles to the centre, which overlap
  TriangleMesh twice = bent;
  append(twice, bent, false);
  for (auto& t : twice.triangles)
    for (std::uint32_t& vertex : t)
      if (vertex % 12 < 6) vertex %= 12;
  const Lids folded = lids_of(twice);
  EXPECT_EQ(folded.middles.size(), 1u);
  EXPECT_FALSE(folded.are_good(twice));
}

TEST(MeshDistances, LidsCloseWhateverIsLeftOfAMesh) {
  const TriangleMesh whole = ball_at({0, 0, 0}, 0.15);
  for (unsigned seed = 0; seed < 150; ++seed) {
    std::mt19937 random(seed);
    const auto chance = [&] { return std::uniform_real_distribution<float>(0, 1)(random); };
    TriangleMesh mesh = whole;
    const float share = chance(), coarse = 0.02F + chance();
    const std::array<float, 3> middle{2 * chance() - 1, 2 * chance() - 1, 2 * chance() - 1};
    std::erase_if(mesh.triangles, [&](const auto& t) {
      float away = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) away += std::abs(mesh.vertices[t[0]][axis] - middle[axis]);
      return seed % 2 == 0 ? chance() < share : away < 2 * share;
    });
    if (seed % 3 == 0)  // coincident vertices, flat edges, and rims that are lines
      for (auto& p : mesh.vertices)
        for (float& x : p) x = coarse * std::round(x / coarse);
    if (mesh.triangles.empty()) continue;
    const TriangleMesh closed = closed_by(lids_of(mesh), mesh);
    EXPECT_TRUE(lids_of(closed).triangles.empty()) << seed;
  }
}

TEST(MeshDistances, RefusesWhatItCannotDo) {
  TriangleMesh open = cube(1);
  open.triangles.pop_back();
  const DistanceLattice lattice{{-1, -1, -1}, 0.5, {8, 8, 8}};
  EXPECT_THROW(mesh_distances(open, lattice, 1), Error);
  EXPECT_THROW(mesh_distances({}, lattice, 1), Error);
  EXPECT_THROW(mesh_distances(cube(1), {{-1, -1, -1}, 0, {8, 8, 8}}, 1), Error);
  EXPECT_THROW(mesh_distances(cube(1), {{-1, -1, 0.5}, 0.5, {8, 8, 8}}, 1), Error);
  EXPECT_THROW(mesh_distances(cube(1), {{-1, -1, -1}, 1e-6, {2000000000, 2000000000, 2000000000}}, 1), Error);
  TriangleMesh nowhere = cube(1);
  nowhere.vertices[3][0] = NAN;
  EXPECT_THROW(mesh_distances(nowhere, lattice, 1), Error);
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(mesh_distances(cube(1), lattice, 1, cancelled), Error);
}

}  // namespace
}  // namespace fieldfab

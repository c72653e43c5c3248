// Meshes in bricks against the mesh in one piece, which is the slow twin: the same triangles, and seams that close.
#include "fieldfab/contour/bricks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <map>
#include <random>

#include "../family.h"
#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/temporary.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"

namespace fieldfab {
namespace {

namespace shapes = frep::shapes;
using Position = std::array<float, 3>;
using Corners = std::array<Position, 3>;

/// Triangles by the coordinates of their corners, the least corner first, in ascending order.
std::vector<Corners> by_coordinates(const TriangleMesh& mesh) {
  std::vector<Corners> triangles;
  for (const auto& t : mesh.triangles) {
    Corners corners{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

/// Random numbers of one case.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  /// An integer in [low, high).
  int draw(int low, int high) { return std::uniform_int_distribution<int>(low, high - 1)(engine_); }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }

 private:
  std::mt19937 engine_;
};

/// A box with large flat faces, with balls cut out or added, some as thin walls or with a gyroid's.
frep::Expression random_solid(Dice& dice) {
  const auto draw = [&](int low, int high) { return dice.draw(low, high); };
  const auto number = [&](double low, double high) { return dice.number(low, high); };
  frep::Expression solid = shapes::box(number(10, 18), number(10, 18), number(4, 18));
  if (draw(0, 2) == 0) solid = shapes::rotate_z(shapes::rotate_x(solid, number(0, 1)), number(0, 1));
  for (int i = draw(0, 4); i > 0; --i) {
    const frep::Expression ball =
        shapes::move(shapes::sphere(number(1, 6)), number(-8, 8), number(-8, 8), number(-8, 8));
    solid = draw(0, 2) == 0 ? shapes::subtract(solid, ball) : min(solid, ball);
  }
  if (draw(0, 3) == 0) solid = shapes::shell(solid, number(0.1, 1));
  if (draw(0, 3) == 0) solid = max(solid, shapes::shell(shapes::gyroid(number(2, 6)), number(0.2, 1)));
  return solid;
}

/// Calls visit for each brick.
template <class Visit>
void for_each(const ContourBricks& bricks, const Visit& visit) {
  for (int z = 0; z < bricks.count()[2]; ++z)
    for (int y = 0; y < bricks.count()[1]; ++y)
      for (int x = 0; x < bricks.count()[0]; ++x) visit(std::array<int, 3>{x, y, z});
}

class RandomBricks : public ::testing::TestWithParam<unsigned> {};

TEST_P(RandomBricks, HaveTheTrianglesOfTheMeshInOnePiece) {
  Dice dice(GetParam());
  const Box region{Vec3::Constant(-10), Vec3::Constant(10)};
  const auto asdf =
      Asdf::build(*frep::make_field(random_solid(dice)), region, {20.0 / dice.draw(40, 90), -1, dice.draw(0, 4) > 0});
  const Temporary scratch(std::filesystem::temp_directory_path() / fmt::format("fieldfab_bricks_{}.asdf", getpid()));
  const std::filesystem::path& file = scratch.path();
  asdf->save(file);
  const auto whole = Asdf::load(file);
  // The region itself, or bounds that cut the solid off; cells of the file, or others.
  const Box bounds = dice.draw(0, 3) == 0 ? Box{Vec3(-7, -6, -5), Vec3(6, 7, 8)} : region;
  const ContourSettings settings{dice.draw(0, 3) == 0 ? 0.23 : whole->finest(), dice.draw(0, 4) == 0 ? 0.0 : -1};
  const ContourMesh expected = contour(*whole, bounds, settings);

  const ContourBricks bricks(bounds, settings, 32);
  TriangleMesh joined;
  std::map<Position, std::uint32_t> number;
  for_each(bricks, [&](const std::array<int, 3>& brick) {
    const auto part = Asdf::load(file, {0, bricks.surroundings(brick)});
    const BrickMesh mesh = bricks.mesh(*part, brick);
    std::vector<std::uint32_t> index(mesh.vertices.size());
    for (std::uint32_t i = 0; i < index.size(); ++i) {
      const auto [found, added] = number.try_emplace(mesh.vertices[i], joined.vertices.size());
      if (added) joined.vertices.push_back(mesh.vertices[i]);
      index[i] = found->second;
      EXPECT_TRUE(added || std::binary_search(mesh.seam.begin(), mesh.seam.end(), i)) << "a vertex beside the seams";
    }
    for (const auto& t : mesh.triangles) joined.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  });
  EXPECT_EQ(joined.vertices.size(), expected.vertices.size());
  EXPECT_TRUE(by_coordinates(joined) == by_coordinates(expected));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBricks, ::testing::Range(0U, sample_or_all(8U, 24U)));

TEST(Bricks, RefuseWhatTheyCannotMesh) {
  const Box region{Vec3::Constant(-2), Vec3::Constant(2)};
  const auto ball = frep::make_field(shapes::sphere(1));
  const ContourBricks bricks(region, {0.05}, 32);
  EXPECT_THROW(bricks.mesh(*ball, {0, 0, 0}), Error);  // a formula's faces merge over any number of bricks
  const auto asdf = Asdf::build(*ball, region, {0.05});
  EXPECT_EQ(bricks.count(), (std::array<int, 3>{3, 3, 3}));
  EXPECT_THROW(bricks.mesh(*asdf, {3, 0, 0}), Error);
  EXPECT_THROW(bricks.surroundings({0, -1, 0}), Error);
  EXPECT_THROW(ContourBricks(region, {0.05}, 48), Error);
  EXPECT_THROW(ContourBricks(region, {0.05}, 16), Error);
  EXPECT_THROW(ContourBricks(region, {0.0}, 32), Error);
}

TEST(Bricks, AreOneWhereTheSolidIsSmall) {
  const Box region{Vec3::Constant(-2), Vec3::Constant(2)};
  const auto asdf = Asdf::build(*frep::make_field(shapes::sphere(1)), region, {0.05});
  const ContourBricks bricks(region, {0.05});
  EXPECT_EQ(bricks.count(), (std::array<int, 3>{1, 1, 1}));
  const BrickMesh mesh = bricks.mesh(*asdf, {0, 0, 0});
  EXPECT_TRUE(mesh.seam.empty());
  const ContourMesh whole = contour(*asdf, region, {0.05});
  EXPECT_EQ(mesh.vertices, whole.vertices);
  EXPECT_EQ(mesh.triangles, whole.triangles);
}

}  // namespace
}  // namespace fieldfab

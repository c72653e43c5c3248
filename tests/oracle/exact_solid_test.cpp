// Exact solids of meshes against the winding number of the same triangles at sampled points.
#include "fieldfab/mesh/exact_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "fieldfab/core/error.h"
#include "fieldfab/mesh/mesh_field.h"

namespace fieldfab {
namespace {

TriangleMesh box(const Vec3& middle, const Vec3& half,
                 const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity()) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign((corner & 4) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 1) != 0 ? 1 : -1);
    const Vec3 at = middle + turn * half.cwiseProduct(sign);
    mesh.vertices.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
  }
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                    {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

TriangleMesh inverted(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

TriangleMesh joined(const std::vector<TriangleMesh>& meshes) {
  TriangleMesh all;
  for (const TriangleMesh& mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& t : mesh.triangles) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

std::optional<TriangleMesh> faces_of(const TriangleMesh& mesh) {
  const auto solid = exact_solid_of(mesh);
  return solid ? in_single_precision(solid->polyhedron()) : std::nullopt;
}

TEST(ExactSolid, IsWhatManyBoxesWindAround) {
  int had = 0, with_hollows = 0;
  for (unsigned seed = 0; seed < 120; ++seed) {
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto anywhere = [&](double reach) {
      return Vec3(between(-reach, reach), between(-reach, reach), between(-reach, reach));
    };
    const auto turn = [&] {
      return Eigen::Quaterniond(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalized();
    };
    const bool whole_numbers = seed % 4 == 0, all_inward = seed % 5 == 0;
    std::vector<TriangleMesh> boxes;
    for (unsigned n = 0; n < 1 + seed % 5; ++n) {
      if (whole_numbers) {
        boxes.push_back(
            box(anywhere(4).array().round(), Vec3(between(1, 4), between(1, 4), between(1, 4)).array().round()));
      } else {
        const Vec3 middle = anywhere(6), half(between(1, 4), between(1, 4), between(1, 4));
        const Eigen::Quaterniond turned = turn();
        boxes.push_back(box(middle, half, turned));
        if (n % 2 == 1) boxes.push_back(inverted(box(middle, 0.5 * half, turned)));
      }
      if (all_inward) boxes.back() = inverted(boxes.back());
    }
    const TriangleMesh mesh = joined(boxes);
    const auto solid = exact_solid_of(mesh);
    if (!solid) continue;
    const auto faces = in_single_precision(solid->polyhedron());
    ASSERT_TRUE(faces && bounds_a_solid(to_polyhedron(*faces))) << seed;
    ++had;
    with_hollows += !whole_numbers && !all_inward && boxes.size() > 1 ? 1 : 0;
    const FieldPtr before = mesh_field(mesh), after = mesh_field(*faces);
    for (int n = 0; n < 500; ++n) {
      const Vec3 p = anywhere(11);
      if (std::abs(after->value(p)) < 1e-3 || std::abs(before->value(p)) < 1e-3) continue;
      EXPECT_EQ(before->value(p) < 0, after->value(p) < 0) << seed << ": " << p.transpose();
    }
  }
  EXPECT_GT(had, 60);
  EXPECT_GT(with_hollows, 10);
}

TEST(ExactSolid, OfABoxIsTheBox) {
  const auto faces = faces_of(box({1, 2, 3}, {1, 2, 3}));
  ASSERT_TRUE(faces);
  EXPECT_EQ(faces->triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(faces->volume(), 48);
  EXPECT_DOUBLE_EQ(faces_of(inverted(box({1, 2, 3}, {1, 2, 3})))->volume(), 48);
}

TEST(ExactSolid, HasHollowsOnlyWhereTheyAreWithin) {
  const TriangleMesh outer = box(Vec3::Zero(), Vec3::Constant(2));
  EXPECT_NEAR(faces_of(joined({outer, inverted(box(Vec3::Zero(), Vec3::Constant(1)))}))->volume(), 64 - 8, 1e-9);
  // protrudes
  EXPECT_EQ(exact_solid_of(joined({outer, inverted(box({2, 0, 0}, Vec3::Constant(1)))})).has_value(), false);
  // duplicate shell
  EXPECT_EQ(exact_solid_of(joined({outer, outer, inverted(box(Vec3::Zero(), Vec3::Constant(1)))})).has_value(), false);
}

TEST(ExactSolid, IsNotHadOfWhatIsOpenOrCrossesItself) {
  TriangleMesh open = box(Vec3::Zero(), Vec3::Constant(2));
  open.triangles.pop_back();
  EXPECT_EQ(exact_solid_of(open).has_value(), false);
  TriangleMesh pulled = box(Vec3::Zero(), Vec3::Constant(2));
  pulled.vertices[0] = {5, 0.3F, 0.2F};  // through the opposite face
  EXPECT_EQ(exact_solid_of(pulled).has_value(), false);
  EXPECT_EQ(exact_solid_of(TriangleMesh()).has_value(), false);
}

TEST(ExactSolid, IsRightOrRefusedWhereSolidsTouch) {
  int right = 0, refused = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937 random(seed);
    const auto whole = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    constexpr int side = 4;
    ExactSolid solid;
    std::array<bool, side * side * side> filled{};
    try {
      for (int n = 0; n < 5; ++n) {
        const Eigen::Array3i lower(whole(0, side - 1), whole(0, side - 1), whole(0, side - 1));
        const Eigen::Array3i upper = (lower + Eigen::Array3i(whole(1, 3), whole(1, 3), whole(1, 3))).min(side);
        const Vec3 half = (upper - lower).cast<double>() / 2;
        const auto operation = n < 3 || whole(0, 2) > 0 ? Operation::unite : Operation::subtract;
        for (int cell = 0; cell < side * side * side; ++cell) {
          const Eigen::Array3i at(cell % side, cell / side % side, cell / side / side);
          if ((at >= lower).all() && (at < upper).all()) filled[cell] = operation == Operation::unite;
        }
        solid = combined(solid, ExactSolid(to_polyhedron(box(lower.cast<double>().matrix() + half, half))), operation);
      }
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
      ++refused;
      continue;
    }
    if (solid.empty()) continue;
    const FieldPtr field = mesh_field(to_mesh(solid.polyhedron()));
    for (int cell = 0; cell < side * side * side; ++cell)
      EXPECT_EQ(field->value({cell % side + 0.5, cell / side % side + 0.5, cell / side / side + 0.5}) < 0, filled[cell])
          << seed << ": " << cell;
    ++right;
  }
  EXPECT_GT(right, 150);
  EXPECT_GT(refused, 10);
}

TEST(ExactSolid, OfManyIsJoinedInAnOrderInWhichItCanBe) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    std::mt19937 random(seed);
    std::vector<ExactSolid> cubes;
    for (int i = 0; i < 12; ++i)
      cubes.emplace_back(to_polyhedron(box(Vec3(i % 2, i / 2 % 2, i / 4) + Vec3::Constant(0.5), Vec3::Constant(0.5))));
    // among the first cubes, half touch along edges or at corners only
    std::shuffle(cubes.begin(), cubes.end(), random);
    const ExactSolid block = all_of(cubes, Operation::unite, Progress::none());
    EXPECT_NEAR(to_mesh(block.polyhedron()).volume(), 12, 1e-9) << seed;
    EXPECT_FALSE(block.touches_itself());
  }
  const auto cube = [](const Vec3& at) { return ExactSolid(to_polyhedron(box(at, Vec3::Constant(0.5)))); };
  EXPECT_THROW(all_of({cube({0, 0, 0}), cube({1, 1, 0})}, Operation::unite, Progress::none()), Error);
}

TEST(ExactSolid, StopsWhenItIsCancelled) {
  Progress cancelled;
  cancelled.cancel();
  EXPECT_THROW(exact_solid_of(box(Vec3::Zero(), Vec3::Constant(2)), cancelled), Error);
}

}  // namespace
}  // namespace fieldfab

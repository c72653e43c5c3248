// Contouring against CGAL: valid for any Field, and accurate where the Field is resolved.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "../family.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"

namespace fieldfab {
namespace {

namespace s = frep::shapes;
using frep::Expression;

void expect_valid(const TriangleMesh& mesh, const std::string& what) {
  const MeshVerdict verdict = inspect(mesh);
  EXPECT_TRUE(verdict.valid()) << what << ": manifold " << verdict.manifold << " closed " << verdict.closed
                               << " outward " << verdict.outward << " self-intersections " << verdict.self_intersections
                               << " degenerate " << verdict.degenerate;
}

struct Sample {
  const char* name;
  Expression solid;
  double volume;  // 0: no closed form
};

std::vector<Sample> samples() {
  return {{"cube", s::box(2, 2, 2), 8},
          {"sphere", s::sphere(1.2), 4.0 / 3 * std::numbers::pi * 1.728},
          {"hollow ball", s::shell(s::sphere(1.2), 0.4), 4.0 / 3 * std::numbers::pi * (2.744 - 1)},
          {"torus", s::torus(1, 0.4), 2 * std::numbers::pi * std::numbers::pi * 0.16},
          {"gyroid shell", s::intersect(s::shell(s::gyroid(1.5), 0.2), s::sphere(1.5)), 0},
          {"twisted box", s::twist(s::box(1.4, 1.4, 2), 0.6), 1.4 * 1.4 * 2},
          {"tapered box", s::taper(s::box(1.6, 1.6, 2), 2, 0.5), 1.6 * 1.6 * (2 + 2.0 / 48)},
          {"cube less sphere", s::subtract(s::box(2, 2, 2), s::sphere(1.2)), 0}};
}

// Ten rotations about two axes; only the first is aligned.
TEST(Contour, IsValidForEveryShapeResolutionAndTurn) {
  for (const Sample& sample : samples())
    for (int turn = 0; turn < 10; turn += sample_or_all(3, 1)) {
      const FieldPtr solid =
          rotate(rotate(frep::make_field(sample.solid), Vec3::UnitZ(), 0.37 * turn), {1, 0.3, 0}, 0.53 * turn);
      for (const double voxel : {0.2, 0.11, 0.06}) {
        if (turn % (voxel == 0.2 ? 1 : voxel == 0.11 ? 2 : 5) != 0) continue;  // finer ones take most of the time
        const TriangleMesh mesh = contour(*solid, {Vec3::Constant(-2.1), Vec3::Constant(2.1)}, {voxel});
        const std::string what =
            std::string(sample.name) + " turn " + std::to_string(turn) + " voxel " + std::to_string(voxel);
        expect_valid(mesh, what);
        if (sample.volume > 0) {
          EXPECT_NEAR(mesh.volume(), sample.volume, 0.3 * voxel * voxel * mesh.area()) << what;
        }
      }
    }
}

TEST(Contour, KeepsACubeACube) {
  for (const double voxel : {0.3, 0.1, 0.037}) {
    const TriangleMesh mesh =
        contour(*frep::make_field(s::box(2, 2, 2)), {Vec3::Constant(-1.5), Vec3::Constant(1.5)}, {voxel});
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3 p((corner & 1U) != 0 ? 1 : -1, (corner & 2U) != 0 ? 1 : -1, (corner & 4U) != 0 ? 1 : -1);
      double nearest = 1;
      for (const auto& v : mesh.vertices) nearest = std::min(nearest, (Vec3(v[0], v[1], v[2]) - p).norm());
      EXPECT_LT(nearest, 1e-3 * voxel);
    }
    EXPECT_NEAR(mesh.volume(), 8, 1e-3 * voxel * 24);
  }
}

/// Area-weighted quantile of the mesh's distance from the solid, to first order, in voxels, sampled
/// at seven points per triangle.
double distance_quantile(const TriangleMesh& mesh, const Field& solid, double voxel, double share) {
  std::vector<std::pair<double, double>> distances;  // with the area that each represents
  double area = 0;
  for (const auto& triangle : mesh.triangles) {
    std::array<Vec3, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& v = mesh.vertices[triangle[i]];
      corner[i] = {v[0], v[1], v[2]};
    }
    const double size = 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
    for (const Vec3& weight :
         {Vec3(1, 1, 1), Vec3(4, 1, 1), Vec3(1, 4, 1), Vec3(1, 1, 4), Vec3(1, 1, 0), Vec3(0, 1, 1), Vec3(1, 0, 1)}) {
      const Vec3 p = (weight[0] * corner[0] + weight[1] * corner[1] + weight[2] * corner[2]) / weight.sum();
      distances.emplace_back(std::abs(solid.value(p)) / solid.gradient(p).norm() / voxel, size / 7);
    }
    area += size;
  }
  std::sort(distances.begin(), distances.end());
  double below = 0;
  for (const auto& [distance, weight] : distances)
    if ((below += weight) >= share * area) return distance;
  return distances.back().first;
}

// A naive lattice method cuts corners and leaves sawtooth edges on a rotated cube.
/// Faces that almost lie in a plane of the lattice, at .634 here: on the rims of merged cells, of which some end in
/// each eighth plane.
TEST(Contour, KeepsBoxesWhoseFacesAreNextToPlanesOfTheLattice) {
  for (int axis = 0; axis < 3; ++axis)
    for (int plane = -8; plane < 24; ++plane)
      for (const double off : {-5e-4, -2e-4, -1e-4, 1e-4, 5e-4}) {
        const Vec3 lower(-14.4, -13.2, -12.6);
        Vec3 upper(14.3, 12.9, 13.3);
        upper[axis] = plane + 0.634 + off;
        const std::string text = fmt::format("max(max(max({} - x, x - {}), max({} - y, y - {})), max({} - z, z - {}))",
                                             lower.x(), upper.x(), lower.y(), upper.y(), lower.z(), upper.z());
        const ContourMesh mesh =
            contour(*frep::make_field(frep::parse_infix(text)), {Vec3::Constant(-40), Vec3::Constant(40)}, {1});
        const double volume = (upper - lower).prod();
        // Vertices keep a 2048th of a merged cell's edge from its rim.
        EXPECT_NEAR(mesh.volume(), volume, 3e-4 * volume) << text;
        EXPECT_TRUE(inspect(mesh).valid()) << text;
      }
}

TEST(Contour, KeepsTheEdgesAndCornersOfTurnedCubes) {
  int exact = 0, corners = 0;
  for (int turn = 1; turn <= 8; ++turn)
    for (const double voxel : {0.2, 0.07}) {
      const Eigen::Matrix3d rotation =
          (Eigen::AngleAxisd(0.37 * turn, Vec3(1, 0.3, 0).normalized()) * Eigen::AngleAxisd(0.53 * turn, Vec3::UnitZ()))
              .matrix();
      const FieldPtr solid = transform(frep::make_field(s::box(2, 2, 2)), Eigen::Affine3d(rotation));
      const TriangleMesh mesh = contour(*solid, {Vec3::Constant(-2.1), Vec3::Constant(2.1)}, {voxel});
      EXPECT_LT(distance_quantile(mesh, *solid, voxel, 0.99), 1e-3) << "turn " << turn;
      EXPECT_LT(distance_quantile(mesh, *solid, voxel, 0.999), 0.1) << "turn " << turn;
      for (int i = 0; i < 8; ++i) {
        const Vec3 corner = rotation * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& v : mesh.vertices)
          nearest = std::min(nearest, (corner - Vec3(v[0], v[1], v[2])).norm() / voxel);
        EXPECT_LT(nearest, 0.03) << "turn " << turn << " corner " << i;
        exact += nearest < 1e-3;
        ++corners;
      }
    }
  EXPECT_GE(exact, corners * 95 / 100);
}

/// Sharpening mends areas of 16 cells at the same time: these solids have many, with edges across their borders.
TEST(Contour, IsTheSameForAnyNumberOfThreads) {
  const Expression word = s::extrude(frep::shapes::text("Sharp &\nequal", 5, 0.8), 2, 0);
  const FieldPtr cut = subtract(rotate(frep::make_field(s::box(30, 24, 20)), {1, 0.3, 0}, 0.4),
                                rotate(frep::make_field(s::cylinder(3, 40)), Vec3::UnitX(), 0.9));
  for (const auto& [solid, bounds, voxel] :
       {std::tuple{frep::make_field(word), Box{Vec3(-1, -13, -1), Vec3(25, 7, 3)}, 0.4},
        std::tuple{cut, Box{Vec3::Constant(-24), Vec3::Constant(24)}, 0.5}}) {
    ContourMesh first;
    for (const int threads : {1, 2, 3, 8}) {
      const ThreadLimit limit(threads);
      const ContourMesh mesh = contour(*solid, bounds, {voxel});
      if (threads == 1) first = mesh;
      EXPECT_GT(mesh.triangles.size(), 5000U);
      EXPECT_EQ(mesh.triangles, first.triangles) << threads;
      EXPECT_EQ(mesh.vertices, first.vertices) << threads;
    }
    expect_valid(first, "the mesh of all threads");
  }
}

// A wedge of 20 degrees is thinner than a voxel up to three voxels from its edge.
TEST(Contour, KeepsTheEdgeOfAKnife) {
  const Expression knife = s::intersect(
      s::intersect(s::half_space(0, 0.1736, 0.9848, 0), s::half_space(0, 0.1736, -0.9848, 0)), s::box(2, 2, 2));
  const FieldPtr solid = rotate(rotate(frep::make_field(knife), Vec3::UnitZ(), 0.6), Vec3::UnitX(), 0.4);
  const TriangleMesh mesh = contour(*solid, {Vec3::Constant(-2.1), Vec3::Constant(2.1)}, {0.04});
  expect_valid(mesh, "knife");
  EXPECT_NEAR(mesh.volume(), 0.1763 * 2, 0.002);
}

// Vertices on the edges between flat and round faces lie on the flat ones, wherever these are between lattice planes.
TEST(Contour, KeepsFlatFacesFlatBesideRoundOnes) {
  const Expression part = s::subtract(s::box(10, 8, 6), s::move(s::sphere(3), 1, 2, 3));
  int flat = 0;
  constexpr int placements = 20;
  for (int i = 0; i < placements; ++i) {
    const Vec3 place = i * Vec3(0.037, 0.053, 0.029);
    const FieldPtr solid = frep::make_field(s::move(part, place.x(), place.y(), place.z()));
    const Box bounds = contour(*solid, {{-6, -5, -4}, {7, 6, 5}}, {0.5}).bounds();
    const double off = std::max((bounds.lower - place + Vec3(5, 4, 3)).cwiseAbs().maxCoeff(),
                                (bounds.upper - place - Vec3(5, 4, 3)).cwiseAbs().maxCoeff());
    EXPECT_LT(off, 0.01) << i;  // 0.02 cells
    flat += off < 2e-6;         // some floats
  }
  EXPECT_GE(flat, 0.8 * placements);
}

TEST(Contour, IsValidForFieldsThatAreNone) {
  // Noise, the tip of a double cone, discontinuities, creases, NaN: validity does not depend on the
  // Field.
  const Expression x = Expression::x(), y = Expression::y(), z = Expression::z();
  const Expression wave = frep::sin(x * 127.1 + y * 311.7 + z * 74.7) * 43758.5453;
  const std::vector<std::pair<const char*, Expression>> wild{
      {"noise", frep::mod(wave, 1.0) - 0.5},
      {"cone", frep::sqrt(frep::square(x) + frep::square(y)) - frep::abs(z)},
      {"saddles", frep::sin(x * 31.0) + frep::sin(y * 29.0 + x * 7.0) + frep::sin(z * 37.0 + y * 5.0)},
      {"steps", frep::floor(x * 3.0) + frep::floor(y * 3.0) - frep::floor(z * 5.0)},
      {"nan", frep::sqrt(x) - y},
      {"touching",
       frep::min(frep::max(frep::max(frep::abs(x - 0.5) - 0.5, frep::abs(y) - 0.5), frep::abs(z) - 0.5),
                 frep::max(frep::max(frep::abs(x + 0.5) - 0.5, frep::abs(y - 1.0) - 0.5), frep::abs(z) - 0.5))},
      {"sheet", frep::square(x)},
      {"compare", frep::compare(frep::square(x) + frep::square(y), 0.7)}};
  for (const auto& [name, expression] : wild)
    for (const double voxel : {0.25, sample_or_all(0.16, 0.1)}) {
      ContourSettings settings{voxel};
      settings.most_divided = 4'000;  // a Field that is rough at any scale would use all of them
      const ContourMesh mesh = contour(*frep::make_field(expression), {Vec3::Constant(-1.1), {1.2, 1.3, 1}}, settings);
      expect_valid(mesh, name);
      EXPECT_TRUE(!mesh.certainty.certain() || std::string(name) != "noise");
    }
}

TEST(Contour, CapsASolidAtTheBounds) {
  const TriangleMesh mesh = contour(*frep::make_field(s::sphere(1)), {{-2, -2, -2}, {2, 2, 0}}, {0.05});
  expect_valid(mesh, "half a ball");
  EXPECT_NEAR(mesh.volume(), 2.0 / 3 * std::numbers::pi, 0.01);
  EXPECT_NEAR(mesh.bounds().upper.z(), 0, 1e-4);
  const TriangleMesh full = contour(*frep::make_field(-Expression(1.0)), {{0, 0, 0}, {1, 2, 3}}, {0.1});
  EXPECT_NEAR(full.volume(), 6, 1e-3);
}

TEST(Contour, WithoutFeaturesCutsEdgesOffByACellOnly) {
  const Box bounds{Vec3::Constant(-10), Vec3::Constant(10)};
  const TriangleMesh box = contour(*frep::make_field(s::box(19, 19, 19)), bounds, {.voxel = 0.5, .features = false});
  expect_valid(box, "box");
  EXPECT_GT(box.volume(), 19 * 19 * 19 - 12 * 19 * 0.5 * 0.5);
  EXPECT_LT(box.triangles.size(), 20000U);  // its flat faces are still simplified
}

TEST(Contour, RefusesNonsenseAndStopsWhenTold) {
  const FieldPtr ball = frep::make_field(s::sphere(1));
  const Box bounds{Vec3::Constant(-1), Vec3::Constant(1)};
  EXPECT_THROW(contour(*ball, bounds, {0}), Error);
  EXPECT_THROW(contour(*ball, bounds, {NAN}), Error);
  EXPECT_THROW(contour(*ball, bounds, {1e-9}), Error);
  EXPECT_THROW(contour(*ball, {{0, 0, 0}, {1, 1, 0}}, {0.1}), Error);
  EXPECT_THROW(contour(*ball, {{0, 0, 0}, {1, 1, INFINITY}}, {0.1}), Error);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(contour(*ball, bounds, {0.1}, progress), Error);
  EXPECT_TRUE(contour(*frep::make_field(s::sphere(-1)), bounds, {0.1}).triangles.empty());
}

// OpenVDB's volume is a sum over the surface whose errors grow with the distance from the origin.
TEST(Check, PassesWhatIsRightAtAnyScaleAndPlace) {
  for (const double size : {1e-3, 1.0, 1e3}) {
    const FieldPtr solid =
        frep::make_field(s::move(s::scale(s::rotate_x(s::subtract(s::box(2, 1, 1), s::sphere(0.7)), 0.4), size),
                                 400 * size, -400 * size, 200 * size));
    const Vec3 centre = size * Vec3(400, -400, 200);
    const CheckReport report =
        check(*solid, {centre - Vec3::Constant(1.5 * size), centre + Vec3::Constant(1.5 * size)}, {0.015 * size});
    for (const CheckRow& row : report.rows)
      EXPECT_TRUE(row.passed()) << size << ": " << row.name << ' ' << row.measured << " > " << row.bound;
  }
}

TEST(Check, PassesWhatIsRight) {
  for (const Sample& sample : samples()) {
    const FieldPtr solid = rotate(frep::make_field(sample.solid), {1, 2, 3}, 0.7);
    const CheckReport report = check(*solid, {Vec3::Constant(-2.1), Vec3::Constant(2.1)}, {0.06});
    for (const CheckRow& row : report.rows)
      EXPECT_TRUE(row.passed()) << sample.name << ": " << row.name << ' ' << row.measured << " > " << row.bound;
  }
}

TEST(Check, SeesWhatIsWrong) {
  TriangleMesh mesh = contour(*frep::make_field(s::sphere(1)), {Vec3::Constant(-1.2), Vec3::Constant(1.2)}, {0.1});
  ASSERT_TRUE(inspect(mesh).valid());
  TriangleMesh broken = mesh;
  broken.triangles.pop_back();
  EXPECT_FALSE(inspect(broken).closed);
  broken = mesh;
  std::swap(broken.triangles[5][0], broken.triangles[5][1]);
  EXPECT_FALSE(inspect(broken).manifold);
  broken = mesh;
  for (auto& t : broken.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(inspect(broken).outward);
  broken = mesh;
  broken.vertices[7] = {0, 0, 5};
  broken.vertices[90] = {0.2F, 0.1F, -4};
  EXPECT_GT(inspect(broken).self_intersections, 0U);
}

/// An inconsistent Field: values differ by `shift` from its gradients and intervals.
class Shifted final : public Field {
 public:
  Shifted(FieldPtr inner, float shift) : inner_(std::move(inner)), shift_(shift) {}
  void values(const Points& points, float* out) const noexcept override {
    inner_->values(points, out);
    for (std::size_t i = 0; i < points.count; ++i) out[i] += shift_;
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    inner_->gradients(points, out, slopes);
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return inner_->interval(box); }

 private:
  FieldPtr inner_;
  float shift_;
};

TEST(Check, FailsForAFieldWhoseValuesAreOffByTwoVoxels) {
  const auto liar = std::make_shared<Shifted>(frep::make_field(s::sphere(1)), 0.12F);
  bool caught = false;
  try {
    caught = !check(*liar, {Vec3::Constant(-1.3), Vec3::Constant(1.3)}, {0.06}).passed();
  } catch (const Error& error) {
    caught = error.kind() == ErrorKind::internal;
  }
  EXPECT_TRUE(caught);
}

}  // namespace
}  // namespace fieldfab

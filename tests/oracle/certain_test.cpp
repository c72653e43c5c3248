// Complete, or it tells where not: hard solids from one cell thick to a thousandth, against closed forms and against a
// lattice 16 times finer, which knows nothing of intervals and slopes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

#include "../family.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/mesh_field.h"
#include "thin_solid.h"

namespace fieldfab {
namespace {

constexpr double pi = std::numbers::pi;

FieldPtr solid_of(const std::string& text) { return frep::make_field(frep::parse_infix(text)); }

/// Vertices less edges plus faces: 2 for each ball, 0 for each torus.
long euler(const TriangleMesh& mesh) {
  return static_cast<long>(mesh.vertices.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

struct Hard {
  std::string name, text;
  Box bounds;
  double voxel;
  double volume;    ///< mm3; negative where there is no closed form
  double accuracy;  ///< of the volume, as a part of it
  long euler;       ///< what it must be where the mesh is certain
};

Box cube_about_zero(double half) { return {Vec3::Constant(-half), Vec3::Constant(half)}; }

/// One cell is a millimetre; parts are `t` mm thick.
std::vector<Hard> family(double t) {
  std::vector<Hard> all;
  const Box room = cube_about_zero(8.3);
  const auto add = [&](const char* name, std::string text, double volume, double accuracy, long number) {
    all.push_back({fmt::format("{} {}", name, t), std::move(text), room, 1, volume, accuracy, number});
  };
  add("plate", fmt::format("box(12, 10, {})", t), 120 * t, 1e-3, 2);
  add("plate between lattice planes", fmt::format("move(box(12, 10, {}), dz = 0.37)", t), 120 * t, 1e-3, 2);
  add("plate beside a block", fmt::format("box(14, 12, {}) | move(box(4, 4, 5), dz = 2.5)", t), 168 * t + 80 - 8 * t,
      2e-3, 2);
  add("slit", fmt::format("difference(box(10, 10, 10), move(box(8, {}, 12), dy = 0.21))", t), 1000 - 80 * t, 1e-3, 0);
  add("wall between bores",
      fmt::format(
          "difference(difference(box(14, 8, 6), move(cylinder(2.5, 8), dx = {0})), move(cylinder(2.5, 8), dx = -{0}))",
          2.5 + t / 2),
      14 * 8 * 6 - 2 * pi * 6.25 * 6, 2e-3, -2);
  add("shell of a ball", fmt::format("shell(sphere(6), {})", t),
      4 * pi / 3 * (std::pow(6 + t / 2, 3) - std::pow(6 - t / 2, 3)), 0.02, 4);
  for (int turn = 1; turn <= 10; turn += sample_or_all(4, 1))
    add(fmt::format("plate turned {} times", turn).c_str(),
        fmt::format("rotate_z(rotate_x(box(9, 7, {}), {}), {})", t, 17 * turn, 23 * turn), 63 * t, 0.01, 2);
  if (t >= 0.02) {
    add("needle", fmt::format("rotate_y(rotate_x(box({0}, {0}, 12), 33), 21)", t), 12 * t * t, 0.06, 2);
    add("round needle", fmt::format("rotate_x(cylinder({}, 12), 40)", t / 2), 3 * pi * t * t, 0.1, 2);
  }
  return all;
}

/// What is measured of one hard solid; `told` where the mesh says that it is not certain.
struct Outcome {
  bool valid = false, told = false, right = false;
  double volume = 0;
  long euler = 0;
};

Outcome try_one(const Hard& hard, std::size_t most_divided) {
  ContourSettings settings{hard.voxel};
  settings.most_divided = most_divided;
  const ContourMesh mesh = contour(*solid_of(hard.text), hard.bounds, settings);
  Outcome outcome;
  outcome.valid = inspect(mesh).valid();
  outcome.told = !mesh.certainty.certain();
  outcome.volume = mesh.volume();
  outcome.euler = euler(mesh);
  outcome.right = std::abs(outcome.volume - hard.volume) <= hard.accuracy * hard.volume && outcome.euler == hard.euler;
  return outcome;
}

/// Whether a mesh from the values at the lattice's points alone, which is all that OpenVDB's and libfive's meshers ask
/// of a smallest cell, lacks a twentieth of the volume or is of another genus.
bool lattice_loses(const Hard& hard) {
  ContourSettings settings{hard.voxel};
  settings.depth = 0;
  const ContourMesh mesh = contour(*solid_of(hard.text), hard.bounds, settings);
  return std::abs(mesh.volume() - hard.volume) > 0.05 * hard.volume || euler(mesh) != hard.euler;
}

TEST(Certain, ThinPartsAreThereOrAreTold) {
  int certain = 0, all = 0, lost_by_lattice = 0;
  for (const double t : {1.0, 0.3, 0.1, 0.03, 0.01, 0.001})
    for (const Hard& hard : family(t)) {
      const Outcome outcome = try_one(hard, t >= 0.1 ? 200'000 : 30'000);
      EXPECT_TRUE(outcome.valid) << hard.name;
      EXPECT_TRUE(outcome.told || outcome.right)
          << hard.name << " is said to be certain: volume " << outcome.volume << " of " << hard.volume
          << ", Euler number " << outcome.euler << " of " << hard.euler;
      if (t >= 0.3) {
        EXPECT_FALSE(outcome.told) << hard.name;
      }
      certain += !outcome.told;
      lost_by_lattice += lattice_loses(hard);
      ++all;
    }
  fmt::print("{} of {} certain; the lattice's points alone lose {}\n", certain, all, lost_by_lattice);
  EXPECT_GT(lost_by_lattice, all - certain);
}

TEST(Certain, PointsEdgesAndTouchingBallsAreThereOrAreTold) {
  const Box room = cube_about_zero(8.3);
  const double ball = 4 * pi / 3;
  std::vector<Hard> all{
      {"cone's tip", "cone(5, 12)", room, 1, 100 * pi, 0.01, 2},
      {"knife edge", "rotate_x(rotate_x(box(8, 20, 20), 4) & move(rotate_x(box(9, 20, 20), -4), dz = 19.6), 12)", room,
       1, -1, 0.02, -1},
      {"faces a millionth apart", "union(move(box(4, 6, 6), dx = -2), move(box(4, 6, 6), dx = 2.000001))", room, 1, 288,
       1e-3, 4},
      {"balls that touch", "union(move(sphere(2), dx = -2), move(sphere(2), dx = 2))", room, 1, 16 * ball, 0.02, -1},
      // Thinner than a tenth of a cell, by which merged cells may deviate.
      {"long needle", "cylinder(0.05, 200)", {{-1, -1, -101}, {1, 1, 101}}, 200.0 / 128, pi / 2, 0.05, 2},
      {"thin ring", "torus(50, 0.2)", {{-51, -51, -1}, {51, 51, 1}}, 100.0 / 128, 4 * pi * pi, 0.02, 0},
  };
  for (const double gap : {0.3, 0.1, 0.03, 0.01, -0.01, -0.03, -0.1, -0.3})
    all.push_back({fmt::format("balls {} apart", gap),
                   fmt::format("union(move(sphere(2), dx = -{0}), move(sphere(2), dx = {0}))", 2 + gap / 2), room, 1,
                   16 * ball, 0.04, gap > 0 ? 4 : 2});
  for (const Hard& hard : all) {
    const Outcome outcome = try_one(hard, 100'000);
    EXPECT_TRUE(outcome.valid) << hard.name;
    if (outcome.told) continue;
    if (hard.euler >= 0) {
      EXPECT_EQ(outcome.euler, hard.euler) << hard.name;
    }
    if (hard.volume >= 0) {
      EXPECT_NEAR(outcome.volume, hard.volume, hard.accuracy * hard.volume) << hard.name;
    }
    EXPECT_NE(hard.name, "balls that touch") << "certain of what is neither one nor two";
  }
}

/// The mesh of a box about a centre.
TriangleMesh box_mesh(const Vec3& size, const Eigen::Matrix3d& turn, const Vec3& centre) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Vec3 at = centre + turn * (size / 2).cwiseProduct(sign);
    mesh.vertices.push_back({static_cast<float>(at.x()), static_cast<float>(at.y()), static_cast<float>(at.z())});
  }
  const std::array<std::array<std::uint32_t, 4>, 6> faces{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const auto& face : faces) {
    mesh.triangles.push_back({face[0], face[1], face[2]});
    mesh.triangles.push_back({face[0], face[2], face[3]});
  }
  return mesh;
}

TEST(Certain, MeshesOfThinPlatesAreWhole) {
  int certain = 0, all = 0;
  for (const double place : {0.0, 0.4, 0.7})  // in cells
    for (const double t : {0.5, 0.1})
      for (int n = 0; n <= 5; n += sample_or_all(3, 1)) {
        const Eigen::Matrix3d turn =
            (Eigen::AngleAxisd(0.3 * n, Vec3::UnitX()) * Eigen::AngleAxisd(0.4 * n, Vec3::UnitZ())).toRotationMatrix();
        const TriangleMesh plate = box_mesh({9, 7, t}, turn, place * Vec3(1, 0.8, 0.6));
        const ContourMesh mesh = contour(*mesh_field(plate), cube_about_zero(8.3), {1});
        const std::string name = fmt::format("{} mm at {}, turned {} times: {}", t, place, n, mesh.certainty.text());
        certain += mesh.certainty.certain(), ++all;
        EXPECT_TRUE(inspect(mesh).valid()) << name;
        EXPECT_EQ(euler(mesh), 2) << name;
        EXPECT_NEAR(inspect(mesh).volume, 63 * t, 0.01 * 63 * t) << name;
      }
  EXPECT_GE(certain, all * 5 / 6);
}

/// The mesh of a contour has notches at its edges, of which nothing is proved; but all of it is found.
TEST(Certain, MeshesOfContoursLoseNoThinParts) {
  for (const Hard& hard : family(0.3)) {
    const ContourMesh drawn = contour(*solid_of(hard.text), hard.bounds, {hard.voxel});
    if (!drawn.certainty.certain()) continue;
    const ContourMesh mesh = contour(*mesh_field(drawn), hard.bounds, {hard.voxel});
    EXPECT_TRUE(inspect(mesh).valid()) << hard.name;
    EXPECT_NEAR(inspect(mesh).volume, hard.volume, std::max(0.06, hard.accuracy) * hard.volume)
        << hard.name << ": " << mesh.certainty.text();
    EXPECT_TRUE(!mesh.certainty.certain() || euler(mesh) == hard.euler) << hard.name;
  }
}

/// A cubic lattice of n^3 nodes with square bars between neighbours has a handle for each bar more than a tree needs.
TEST(Certain, LatticesHaveAllTheirHandles) {
  for (const int n : {2, 3, 4})
    for (const double bar : {1.2, 0.5, 0.2}) {
      const double pitch = 15.0 / (n - 1), reach = 15 + bar;
      std::string text;
      for (int axis = 0; axis < 3; ++axis)
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            std::array<double, 3> size{bar, bar, bar}, at{};
            size[static_cast<std::size_t>(axis)] = reach;
            at[static_cast<std::size_t>((axis + 1) % 3)] = -7.5 + i * pitch;
            at[static_cast<std::size_t>((axis + 2) % 3)] = -7.5 + j * pitch;
            text += fmt::format("{}move(box({}, {}, {}), dx = {}, dy = {}, dz = {})", text.empty() ? "" : " | ",
                                size[0], size[1], size[2], at[0], at[1], at[2]);
          }
      const ContourMesh mesh = contour(*solid_of(text), cube_about_zero(9.1), {1});
      const long nodes = n * n * n, bars = 3 * n * n * (n - 1), handles = bars - nodes + 1;
      EXPECT_TRUE(inspect(mesh).valid()) << n << ' ' << bar;
      EXPECT_TRUE(mesh.certainty.certain() || bar < 0.5) << n << ' ' << bar << ' ' << mesh.certainty.text();
      if (!mesh.certainty.certain()) continue;
      EXPECT_EQ(euler(mesh), 2 - 2 * handles) << n << ' ' << bar;
      const double volume =
          static_cast<double>(nodes) * bar * bar * bar + static_cast<double>(bars) * bar * bar * (pitch - bar);
      EXPECT_NEAR(mesh.volume(), volume, 5e-3 * volume) << n << ' ' << bar;
    }
}

/// Which points of a lattice a mesh holds: by the parity of its crossings with lines along x.
class Mask {
 public:
  Mask(const Box& bounds, int side) : bounds_(bounds), side_(side), inside_(count(side), false) {}
  Mask(const Box& bounds, int side, const TriangleMesh& mesh) : Mask(bounds, side) {
    std::vector<std::vector<double>> rows(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (const auto& triangle : mesh.triangles) cross(mesh, triangle, rows);
    for (int z = 0; z < side; ++z)
      for (int y = 0; y < side; ++y) {
        std::vector<double>& row = rows[static_cast<std::size_t>(y + side * z)];
        std::sort(row.begin(), row.end());
        for (int x = 0; x < side; ++x)
          inside_[index(x, y, z)] =
              (std::upper_bound(row.begin(), row.end(), point(x, y, z).x()) - row.begin()) % 2 == 1;
      }
  }
  [[nodiscard]] Vec3 point(int x, int y, int z) const {
    return bounds_.lower + bounds_.size().cwiseProduct((Vec3(x, y, z).array() + 0.5).matrix() / side_);
  }
  [[nodiscard]] bool at(int x, int y, int z) const { return inside_[index(x, y, z)]; }
  /// Whether the mesh has some surface within `reach` points of one.
  [[nodiscard]] bool changes_near(int x, int y, int z, int reach) const {
    const bool here = at(x, y, z);
    for (int ring = 1; ring <= reach; ++ring)
      for (int dz = -ring; dz <= ring; ++dz)
        for (int dy = -ring; dy <= ring; ++dy)
          for (int dx = -ring; dx <= ring; ++dx) {
            if (std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) != ring) continue;
            const int px = x + dx, py = y + dy, pz = z + dz;
            if (std::min({px, py, pz}) < 0 || std::max({px, py, pz}) >= side_) continue;
            if (at(px, py, pz) != here) return true;
          }
    return false;
  }

 private:
  static std::size_t count(int side) {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  }
  [[nodiscard]] std::size_t index(int x, int y, int z) const {
    return static_cast<std::size_t>(x + side_ * (y + side_ * z));
  }

  void cross(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& triangle,
             std::vector<std::vector<double>>& rows) const {
    std::array<Vec3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& v = mesh.vertices[triangle[i]];
      p[i] = Vec3(v[0], v[1], v[2]);
    }
    const auto range = [&](int axis) {
      const double low = std::min({p[0][axis], p[1][axis], p[2][axis]}),
                   high = std::max({p[0][axis], p[1][axis], p[2][axis]});
      const double step = bounds_.size()[axis] / side_;
      return std::pair{std::max(0, static_cast<int>(std::floor((low - bounds_.lower[axis]) / step - 0.5))),
                       std::min(side_ - 1, static_cast<int>(std::ceil((high - bounds_.lower[axis]) / step - 0.5)))};
    };
    const auto [low_y, high_y] = range(1);
    const auto [low_z, high_z] = range(2);
    const auto side = [](const Vec3& a, const Vec3& b, double y, double z) {
      return (b.y() - a.y()) * (z - a.z()) - (b.z() - a.z()) * (y - a.y());
    };
    for (int z = low_z; z <= high_z; ++z)
      for (int y = low_y; y <= high_y; ++y) {
        const Vec3 at = point(0, y, z);
        const double a = side(p[1], p[2], at.y(), at.z()), b = side(p[2], p[0], at.y(), at.z()),
                     c = side(p[0], p[1], at.y(), at.z());
        if (!((a > 0) == (b > 0) && (b > 0) == (c > 0))) continue;
        rows[static_cast<std::size_t>(y + side_ * z)].push_back((a * p[0].x() + b * p[1].x() + c * p[2].x()) /
                                                                (a + b + c));
      }
  }

  Box bounds_;
  int side_;
  std::vector<bool> inside_;
};

struct ThinSolid {
  bool certain = false;
  bool empty = true;             ///< No point of the finer lattice is inside.
  bool seen_by_lattice = false;  ///< A lattice of the cells' size has a point inside.
  std::string fault;             ///< What the mesh lacks although it is certain, or why it is not valid.
};

/// Contours a solid with few divisions and, where the mesh says that it is certain, compares it with the solid on a
/// lattice 16 times finer than the cells.
ThinSolid contour_and_compare(const std::string& text) {
  constexpr int voxels = 6, finer = 16, side = voxels * finer;
  const Box bounds = cube_about_zero(3);
  const FieldPtr solid = solid_of(text);
  ContourSettings settings{1};
  settings.most_divided = 30'000;
  const ContourMesh mesh = contour(*solid, bounds, settings);
  ThinSolid found;
  if (!mesh.triangles.empty() && !inspect(mesh).valid()) found.fault = "the mesh is not valid";
  found.certain = mesh.certainty.certain();
  if (!found.certain) return found;
  const Mask made(bounds, side, mesh);
  const FieldPtr cut = intersect(solid, box_field(bounds));
  std::vector<float> x(side), y(side), z(side), value(side);
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j) {
      for (int l = 0; l < side; ++l) {
        const Vec3 p = made.point(l, j, k);
        const auto at = static_cast<std::size_t>(l);
        x[at] = static_cast<float>(p.x()), y[at] = static_cast<float>(p.y()), z[at] = static_cast<float>(p.z());
      }
      cut->values({x.data(), y.data(), z.data(), side}, value.data());
      for (int l = 0; l < side; ++l) {
        const float here = value[static_cast<std::size_t>(l)];
        found.empty = found.empty && !(here < 0);
        found.seen_by_lattice =
            found.seen_by_lattice || (here < 0 && l % finer == 0 && j % finer == 0 && k % finer == 0);
        if ((here < 0) == made.at(l, j, k)) continue;
        // A mesh may be so small that it holds no point of the lattice.
        const Vec3 p = made.point(l, j, k);
        const bool vertex_near = std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](const auto& v) {
          return (Vec3(v[0], v[1], v[2]) - p).cwiseAbs().maxCoeff() < settings.voxel;
        });
        if (vertex_near || made.changes_near(l, j, k, finer)) continue;
        found.fault = fmt::format("at {} {} {} the value is {}, and no surface is near", p.x(), p.y(), p.z(), here);
        return found;
      }
    }
  return found;
}

TEST(Certain, RandomThinSolidsAreNeverCertainAndWrong) {
  const std::size_t count = sample_or_all<std::size_t>(15, 500);
  std::mt19937 random(20261123);
  std::vector<std::string> texts(count);
  for (std::string& text : texts) text = random_thin_solid(random);
  std::vector<ThinSolid> found(count);
  std::atomic<std::size_t> compared = 0;
  parallel_for(count, [&](std::size_t i) {
    found[i] = contour_and_compare(texts[i]);
    if (const std::size_t number = ++compared; number % 500 == 0) fmt::print(stderr, "{} compared\n", number);
  });
  for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(found[i].fault, "") << "number " << i << ": " << texts[i];
  const auto number = [&](bool ThinSolid::*property) {
    return std::count_if(found.begin(), found.end(),
                         [&](const ThinSolid& solid) { return solid.certain && solid.*property; });
  };
  const auto certain = number(&ThinSolid::certain);
  fmt::print(
      "{} of {} certain, {} of them with nothing at the finer lattice's points; a lattice of the cells' size sees "
      "something of {}\n",
      certain, count, number(&ThinSolid::empty), number(&ThinSolid::seen_by_lattice));
  // Most meet each other in edges sharper than the budget shows.
  EXPECT_GE(certain, static_cast<std::ptrdiff_t>(count / 5));
}

TEST(Certain, TellsWhichCellsWouldShowWhatIsMissing) {
  for (const char* text : {"shell(sphere(4), 0.08)", "box(7, 6, 0.08) | rotate_x(box(7, 6, 0.08), 40)"}) {
    const FieldPtr solid = solid_of(text);
    ContourSettings settings{1};
    settings.most_divided = 150;
    const Certainty told = contour(*solid, cube_about_zero(4.4), settings).certainty;
    ASSERT_EQ(told.doubt, Doubt::too_many) << text;
    EXPECT_NEAR(told.wanted_voxel, 0.04, 0.015) << text;
    const ContourMesh shown = contour(*solid, cube_about_zero(4.4), {told.wanted_voxel, 0});
    EXPECT_TRUE(shown.certainty.certain()) << text << ": " << shown.certainty.text();
    const auto triangles = static_cast<double>(shown.triangles.size());
    EXPECT_GT(told.wanted_triangles, 0.4 * triangles) << text;
    EXPECT_LT(told.wanted_triangles, 2.5 * triangles) << text;
  }
}

}  // namespace
}  // namespace fieldfab

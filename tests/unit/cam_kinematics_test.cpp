// Machines whose rotary axes do not intersect, against explicit rotations.
#include "../../cam/machine/kinematics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace fieldfab::cam {
namespace {

/// A point rotated about a line.
Vec3 turned(const Vec3& p, const Vec3& on_line, const Vec3& direction, double angle) {
  return on_line + Eigen::AngleAxisd(angle, direction) * (p - on_line);
}

class Kinds : public ::testing::TestWithParam<Kinematics::Kind> {};

TEST_P(Kinds, AxesWithCentresOfTheirOwn) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-80, 80), angle(-1.5, 1.5), unit(-1, 1);
  for (int round = 0; round < 200; ++round) {
    Kinematics k;
    k.kind = GetParam();
    k.centre = {1000, 0, 0};  // without effect if both axes have their own centre
    for (const char letter : {'A', 'C'}) {
      RotaryAxis axis;
      axis.letter = letter;
      axis.direction = Vec3(unit(random), unit(random), unit(random)).normalized();
      axis.centre = Vec3(place(random), place(random), place(random));
      k.axes.push_back(axis);
    }
    const PoseSolver solver(k);
    const double length = 30 + unit(random);
    const AxisPose at{{place(random), place(random), place(random)}, {angle(random), angle(random)}};
    const auto [tip, axis] = solver.pose(at, length);
    EXPECT_NEAR(axis.norm(), 1, 1e-12);
    EXPECT_LT((solver.position(tip, at.angles, length) - at.position).norm(), 1e-9);
    // Explicitly: the tool's tip and a point above it in machine coordinates, the head's inner axis
    // first; then both mapped to the part, the table's outer axis first.
    const bool head[2] = {k.kind != Kinematics::Kind::table_table, k.kind == Kinematics::Kind::head_head};
    std::array<Vec3, 2> points{Vec3(0, 0, 0), Vec3(0, 0, 1)};
    for (Vec3& p : points) {
      for (int i = 1; i >= 0; --i)
        if (head[i])
          p = turned(p, *k.axes[static_cast<std::size_t>(i)].centre + length * Vec3::UnitZ(),
                     k.axes[static_cast<std::size_t>(i)].direction, at.angles[static_cast<std::size_t>(i)]);
      p += at.position;
      for (int i = 0; i < 2; ++i)
        if (!head[i])
          p = turned(p, *k.axes[static_cast<std::size_t>(i)].centre, k.axes[static_cast<std::size_t>(i)].direction,
                     -at.angles[static_cast<std::size_t>(i)]);
    }
    EXPECT_LT((points[0] - tip).norm(), 1e-9);
    EXPECT_LT((points[1] - points[0] - axis).norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Kinds,
                         ::testing::Values(Kinematics::Kind::table_table, Kinematics::Kind::head_head,
                                           Kinematics::Kind::head_table),
                         [](const auto& test) {
                           std::string name(name_of(test.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace fieldfab::cam

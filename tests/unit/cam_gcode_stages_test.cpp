// Stages of reading G-code, each on its own: cutter compensation, machine coordinates, arcs, holes, threads, splines.
// Expected values are closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "gcode/arcs.h"
#include "gcode/compensation.h"
#include "gcode/decoder.h"
#include "gcode/holes.h"
#include "gcode/machine_motions.h"
#include "gcode/sources.h"
#include "gcode/splines.h"
#include "gcode/threads.h"
#include "gcode/travel.h"

namespace fieldfab::cam::gcode {
namespace {

using Kind = Motion::Kind;
constexpr double pi = std::numbers::pi;

AxisValues place(double x, double y, double z = 0) {
  AxisValues values;
  values.at = {x, y, z};
  return values;
}

Motion move(Kind kind, const AxisValues& to) {
  Motion motion;
  motion.kind = kind;
  motion.end = to;
  return motion;
}

Motion line(double x, double y, double z = 0) { return move(Kind::feed, place(x, y, z)); }

Motion arc(double x, double y, const Vec2& centre, int turns) {
  Motion motion = line(x, y);
  motion.kind = Kind::arc;
  motion.centre = centre;
  motion.turns = turns;
  return motion;
}

void expect_line(const Motion& motion, double x, double y, double z = 0) {
  EXPECT_EQ(motion.kind, Kind::feed);
  EXPECT_NEAR((motion.end.xyz() - Vec3(x, y, z)).norm(), 0, 1e-9) << motion.end.xyz().transpose();
}

void expect_arc(const Motion& motion, double x, double y, const Vec2& centre, int turns) {
  EXPECT_EQ(motion.kind, Kind::arc);
  EXPECT_NEAR((motion.end.xyz() - Vec3(x, y, 0)).norm(), 0, 1e-9) << motion.end.xyz().transpose();
  EXPECT_NEAR((motion.centre - centre).norm(), 0, 1e-9) << motion.centre.transpose();
  EXPECT_EQ(motion.turns, turns);
}

/// The path of the tool's centre from the origin, with the tool at the left (1) or right (-1) of the program's path.
std::vector<Motion> compensated(int side, double radius, const std::vector<Motion>& program) {
  std::vector<Motion> centre;
  Compensation compensation([&](const Motion& motion) { centre.push_back(motion); });
  compensation.start(side, radius, {});
  for (const Motion& motion : program) compensation.give(motion);
  compensation.stop();
  return centre;
}

TEST(compensation, passes_motions_while_it_is_off) {
  std::vector<Motion> out;
  Compensation compensation([&](const Motion& motion) { out.push_back(motion); });
  compensation.give(line(1, 2, 3));
  ASSERT_EQ(out.size(), 1U);
  expect_line(out[0], 1, 2, 3);
  EXPECT_FALSE(compensation.on());
}

TEST(compensation, entry_ends_beside_the_path) {
  const auto left = compensated(1, 3, {line(10, 0)});
  ASSERT_EQ(left.size(), 1U);
  expect_line(left[0], 10, 3);
  expect_line(compensated(-1, 3, {line(10, 0)})[0], 10, -3);
  EXPECT_THROW(compensated(1, 10, {line(10, 0)}), Refusal);
}

// The entry arc is tangent to the path at its end. Its centre (c, 10) is as far from (0, 0) as from (8, 10).
TEST(compensation, entry_along_an_arc) {
  const auto out = compensated(1, 2, {arc(10, 10, {0, 10}, 1)});
  ASSERT_EQ(out.size(), 1U);
  expect_arc(out[0], 8, 10, {-2.25, 10}, 1);
}

TEST(compensation, outer_corner_becomes_an_arc) {
  const auto out = compensated(1, 3, {line(10, 0), line(10, -10)});
  ASSERT_EQ(out.size(), 3U);
  expect_line(out[0], 10, 3);
  expect_arc(out[1], 13, 0, {10, 0}, -1);
  expect_line(out[2], 13, -10);
}

TEST(compensation, outer_corner_before_a_rapid_is_straight) {
  const auto out = compensated(1, 3, {line(10, 0), move(Kind::rapid, place(10, -10))});
  ASSERT_EQ(out.size(), 3U);
  EXPECT_EQ(out[1].kind, Kind::rapid);
  EXPECT_NEAR((out[1].end.xyz() - Vec3(13, 0, 0)).norm(), 0, 1e-9);
}

TEST(compensation, reversal_goes_around_the_point) {
  const auto out = compensated(1, 3, {line(10, 0), line(0, 0)});
  ASSERT_EQ(out.size(), 3U);
  expect_arc(out[1], 10, -3, {10, 0}, -1);
  expect_line(out[2], 0, -3);
}

TEST(compensation, inner_corner_shortens_the_move_before) {
  const auto out = compensated(1, 3, {line(10, 0), line(10, 10)});
  ASSERT_EQ(out.size(), 2U);
  expect_line(out[0], 7, 3);
  expect_line(out[1], 7, 10);
  EXPECT_THROW(compensated(1, 3, {line(10, 0), line(10, 5), line(8, 5), line(8, 0)}), Refusal);
}

// The line y = 3 meets the circle of radius 10 - 3.
TEST(compensation, inner_corner_with_an_arc) {
  const auto out = compensated(1, 3, {line(10, 0), arc(0, 10, {0, 0}, 1)});
  ASSERT_EQ(out.size(), 2U);
  expect_line(out[0], std::sqrt(40.0), 3);
  expect_arc(out[1], 0, 7, {0, 0}, 1);
  EXPECT_THROW(compensated(1, 3, {line(10, 0), arc(6, 0, {8, 0}, 1)}), Refusal);
}

TEST(compensation, tangent_moves_have_no_corner) {
  const auto out = compensated(-1, 2, {line(10, 0), arc(15, 5, {10, 5}, 1), line(15, 20)});
  ASSERT_EQ(out.size(), 3U);
  expect_line(out[0], 10, -2);
  expect_arc(out[1], 17, 5, {10, 5}, 1);
  expect_line(out[2], 17, 20);
}

TEST(compensation, motions_in_a_corner_keep_their_order_and_occur_at_the_corner) {
  Motion dwell = move(Kind::dwell, place(10, 0));
  dwell.seconds = 2;
  const auto out = compensated(1, 3, {line(10, 0), dwell, line(10, 0, -1), line(10, 10, -1)});
  ASSERT_EQ(out.size(), 4U);
  expect_line(out[0], 7, 3);
  EXPECT_EQ(out[1].kind, Kind::dwell);
  EXPECT_NEAR((out[1].end.xyz() - Vec3(7, 3, 0)).norm(), 0, 1e-9);
  expect_line(out[2], 7, 3, -1);
  expect_line(out[3], 7, 10, -1);
}

TEST(compensation, a_move_across_the_plane_does_not_enter) {
  const auto out = compensated(1, 3, {line(0, 0, -5), line(10, 0, -5)});
  ASSERT_EQ(out.size(), 2U);
  expect_line(out[0], 0, 0, -5);
  expect_line(out[1], 10, 3, -5);
}

TEST(compensation, of_the_plane_g18) {
  std::vector<Motion> program{line(0, 0, 10), line(10, 0, 10)};
  for (Motion& motion : program) motion.plane = ArcPlane::zx;
  const auto out = compensated(1, 3, program);  // z is the plane's first axis, x its second
  ASSERT_EQ(out.size(), 2U);
  expect_line(out[0], 3, 0, 7);
  expect_line(out[1], 10, 0, 7);
}

TEST(compensation, a_new_start_forgets_the_path_before) {
  std::vector<Motion> out;
  Compensation compensation([&](const Motion& motion) { out.push_back(motion); });
  compensation.start(1, 3, {});
  compensation.give(line(10, 0));
  EXPECT_EQ(compensation.centre(), place(10, 3));
  EXPECT_TRUE(out.empty());
  compensation.stop();
  EXPECT_EQ(out.size(), 1U);
  compensation.start(-1, 1, place(20, 0));
  compensation.give(line(20, 5));
  compensation.stop();
  ASSERT_EQ(out.size(), 2U);
  expect_line(out[1], 21, 5);
}

TEST(tracks, intersections) {
  const Track a{true, {0, 0}, {}, 5}, b{true, {6, 0}, {}, 5}, far{true, {20, 0}, {}, 5},
      x_axis{false, {9, 0}, {1, 0}, 0};
  const auto circles = intersections(a, b);
  ASSERT_TRUE(circles);
  EXPECT_NEAR(((*circles)[0] - Vec2(3, 4)).norm(), 0, 1e-12);
  EXPECT_NEAR(((*circles)[1] - Vec2(3, -4)).norm(), 0, 1e-12);
  const auto line_and_circle = intersections(x_axis, a);
  ASSERT_TRUE(line_and_circle);
  EXPECT_NEAR(((*line_and_circle)[0] - Vec2(5, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR(((*line_and_circle)[1] - Vec2(-5, 0)).norm(), 0, 1e-12);
  EXPECT_FALSE(intersections(a, far));
  EXPECT_FALSE(intersections({false, {0, 6}, {1, 0}, 0}, a));
  EXPECT_FALSE(intersections(a, a));
}

TEST(travel, of_lines_arcs_and_rotary_moves) {
  EXPECT_DOUBLE_EQ(travel_of({}, line(3, 4)).along(), 5);
  EXPECT_NEAR(arc_length({10, 0}, {0, 10}, {0, 0}, 1), 5 * pi, 1e-12);
  EXPECT_NEAR(arc_length({10, 0}, {0, 10}, {0, 0}, -1), 15 * pi, 1e-12);
  EXPECT_NEAR(arc_length({10, 0}, {10, 0}, {0, 0}, 2), 40 * pi, 1e-12);
  Motion helix = arc(0, 10, {0, 0}, 1);
  helix.end.at[2] = 3;
  EXPECT_NEAR(travel_of(place(10, 0), helix).along(), std::hypot(5 * pi, 3), 1e-12);
  Motion turn;
  turn.end.at[3] = 90;
  EXPECT_NEAR(travel_of({}, turn).along(), pi / 2, 1e-12);
}

/// A frame, the stage that it belongs to, and the motions that leave it.
struct Machine {
  Frame frame;
  Notes notes;
  std::vector<Motion> out;
  MachineMotions stage{frame, AxisValues{}, notes, [this](const Motion& motion) { out.push_back(motion); }};
};

TEST(machine_motions, positions_and_centres_in_machine_coordinates) {
  Machine machine;
  machine.frame.origin = place(1, 2, 3);
  machine.frame.rotation = 90;
  Motion first = line(10, 0);
  first.end.at[3] = 180;
  machine.stage.give(first);
  machine.stage.give(arc(0, 10, {0, 0}, 1));
  ASSERT_EQ(machine.out.size(), 2U);
  EXPECT_NEAR((machine.out[0].end.xyz() - Vec3(1, 12, 3)).norm(), 0, 1e-9);
  EXPECT_NEAR(machine.out[0].end.at[3], pi, 1e-12);
  EXPECT_EQ(machine.out[1].kind, Kind::arc);
  EXPECT_NEAR((machine.out[1].end.xyz() - Vec3(-9, 2, 3)).norm(), 0, 1e-9);
  EXPECT_NEAR((machine.out[1].centre - Vec2(1, 2)).norm(), 0, 1e-9);
  EXPECT_EQ(machine.stage.at(), place(0, 10));
}

TEST(machine_motions, arcs_out_of_their_plane_become_chords) {
  Machine machine;
  machine.frame.rotation = 30;
  Motion half = line(0, 0, -10);  // about the origin of z and x, from z = 10
  half.kind = Kind::arc;
  half.plane = ArcPlane::zx;
  half.turns = 1;
  half.feed = 60 * 10 * pi;
  half.seconds = -1;
  half.line = 7;
  machine.stage.give(line(0, 0, 10));
  machine.stage.give(half);
  ASSERT_GT(machine.out.size(), 50U);
  Vec3 before(0, 0, 10);
  const Vec3 first_axis(0, 0, 1), second_axis(std::cos(pi / 6), std::sin(pi / 6), 0);
  double seconds = 0;
  for (std::size_t i = 1; i < machine.out.size(); ++i) {
    const Vec3 end = machine.out[i].end.xyz();
    EXPECT_EQ(machine.out[i].kind, Kind::feed);
    EXPECT_NEAR(end.norm(), 10, 1e-9);
    EXPECT_NEAR(end.dot(first_axis.cross(second_axis)), 0, 1e-9);
    EXPECT_GT(end.dot(second_axis), -1e-9);
    EXPECT_GT(((end + before) / 2).norm(), 10 - 0.001001);
    seconds += machine.out[i].seconds;
    before = end;
  }
  EXPECT_NEAR((before - Vec3(0, 0, -10)).norm(), 0, 1e-9);
  EXPECT_NEAR(seconds, 1, 1e-9);
  const auto notes = machine.notes.take();
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].line, 7);
}

TEST(machine_motions, computes_the_duration_of_feeds_under_g93) {
  Machine machine;
  Motion feed = line(3, 4);
  feed.feed = 10;
  feed.seconds = -1;
  machine.stage.give(feed);
  EXPECT_DOUBLE_EQ(machine.out[0].seconds, 30);
}

TEST(machine_motions, a_change_of_the_frame_does_not_move_the_machine) {
  Machine machine;
  machine.stage.give(line(3, 4));
  Frame next;
  next.origin = place(1, 1);
  next.tool = place(0, 0, 10);
  machine.stage.change_frame(next);
  EXPECT_EQ(machine.stage.at(), place(2, 3, -10));
  EXPECT_THROW(machine.stage.give(line(2e12, 0)), Refusal);
}

/// A control without predefined parameters.
struct NoPredefined final : PredefinedParameters {
  [[nodiscard]] double numbered(int) const override { return 0; }
  [[nodiscard]] std::optional<double> named(std::string_view) const override { return std::nullopt; }
};

FlowWord flow_word(const std::string& text) {
  NoPredefined predefined;
  const Parameters parameters(predefined);
  Line source;
  source.read(text);
  FlowWord word;
  EXPECT_TRUE(read_flow_word(source, parameters, word, true)) << text;
  return word;
}

TEST(sources, flow_words) {
  EXPECT_EQ(flow_word("o100 sub").keyword, "sub");
  EXPECT_EQ(flow_word("N20 O[50+50] endsub [3]").label, "100");
  EXPECT_EQ(flow_word("o<Drill> elseif [1]").keyword, "elseif");
  EXPECT_EQ(flow_word("O0012").label, "12");
  EXPECT_THROW(flow_word("o1 jump"), Refusal);
}

TEST(sources, places_of_subroutines_and_programs) {
  NoPredefined predefined;
  const Parameters parameters(predefined);
  LineCount count(100);
  Sources sources("G0 X1\nO5\no<a> sub\nG0 X2\no<a> endsub\n", "part.ngc", {}, count, parameters);
  const Position start{&sources.program()};
  EXPECT_EQ(sources.subroutine("a", start).line, 3);
  EXPECT_EQ(sources.program(5, start).line, 2);
  EXPECT_EQ(count.lines(), 5U);
  EXPECT_EQ(sources.subroutine("a", start).line, 3);  // known without a search
  EXPECT_EQ(count.lines(), 5U);
  EXPECT_THROW(sources.subroutine("b", start), Refusal);
  EXPECT_THROW(sources.program(6, start), Refusal);
}

Circle circle(const std::string& text, const Vec2& from, const Vec2& to, const Modes& modes = {}) {
  NoPredefined predefined;
  Parameters parameters(predefined);
  Decoder decoder(parameters, Dialect::linuxcnc, true, [](const std::string&) {});
  Line source;
  source.read(text);
  int motion = 800;
  Command command;
  decoder.decode(source, motion, command);
  return circle_of(command.block, modes, text.starts_with("G3") ? 1 : -1, from, to);
}

TEST(circles, from_the_words_of_a_block) {
  EXPECT_EQ(circle("G3 X0 Y10 I-10", {10, 0}, {0, 10}).centre, Vec2(0, 0));
  EXPECT_EQ(circle("G3 X0 Y10 I-10 P3", {10, 0}, {0, 10}).turns, 3);
  EXPECT_EQ(circle("G2 X0 Y10 I-10", {10, 0}, {0, 10}).turns, -1);
  Modes modes;
  modes.arcs_absolute = true;
  EXPECT_EQ(circle("G3 X0 Y10 I1 J1", {10, 1}, {1, 10}, modes).centre, Vec2(1, 1));
  modes.arcs_absolute = false;
  modes.inch = true;
  EXPECT_EQ(circle("G3 X0 Y1 I-1", {25.4, 0}, {0, 25.4}, modes).centre, Vec2(0, 0));
}

TEST(circles, a_radius_means_the_short_arc_and_a_negative_one_the_long_arc) {
  EXPECT_NEAR(circle("G3 X0 Y10 R10", {10, 0}, {0, 10}).centre.norm(), 0, 1e-12);
  EXPECT_NEAR((circle("G3 X0 Y10 R-10", {10, 0}, {0, 10}).centre - Vec2(10, 10)).norm(), 0, 1e-12);
  EXPECT_NEAR((circle("G2 X0 Y10 R10", {10, 0}, {0, 10}).centre - Vec2(10, 10)).norm(), 0, 1e-12);
}

TEST(circles, refusals) {
  EXPECT_THROW(circle("G3 X0 Y10 R2", {10, 0}, {0, 10}), Refusal);       // too small
  EXPECT_THROW(circle("G3 X0 Y10 R10", {10, 0}, {10, 0}), Refusal);      // a full circle
  EXPECT_THROW(circle("G3 X0 Y10", {10, 0}, {0, 10}), Refusal);          // neither R nor a centre
  EXPECT_THROW(circle("G3 X0 Y10 I-9", {10, 0}, {0, 10}), Refusal);      // two radii
  EXPECT_THROW(circle("G3 X0 Y10 I-10 K1", {10, 0}, {0, 10}), Refusal);  // another plane
  EXPECT_THROW(circle("G3 X0 Y10 I-10 P0", {10, 0}, {0, 10}), Refusal);
}

struct Made {
  std::vector<HoleStep> steps;
  int counted = 0;
  [[nodiscard]] double height(std::size_t i, std::size_t axis = 2) const { return steps.at(i).to.at[axis]; }
  /// One letter a step.
  [[nodiscard]] std::string letters() const {
    std::string all;
    for (const HoleStep& step : steps) all += "rfdts"[static_cast<std::size_t>(step.kind)];
    return all;
  }
};

Made made(const Hole& hole) {
  Made result;
  make_hole(
      hole, [&](const HoleStep& step) { result.steps.push_back(step); }, [&] { ++result.counted; });
  return result;
}

Hole hole_of(int code, int turning = 0) {
  Hole hole;
  hole.code = code;
  hole.place = place(1, 2, 99);
  hole.r = 2, hole.bottom = -10, hole.clear = 5;
  hole.turning = turning;
  return hole;
}

TEST(holes, drilling_with_and_without_a_dwell) {
  const Made drilled = made(hole_of(810));
  EXPECT_EQ(drilled.letters(), "fr");
  EXPECT_EQ(drilled.steps[0].to, place(1, 2, -10));
  EXPECT_EQ(drilled.steps[1].to, place(1, 2, 5));
  EXPECT_EQ(made(hole_of(820)).letters(), "fdr");
  EXPECT_EQ(made(hole_of(890)).letters(), "fdf");
  const Made reamed = made(hole_of(850));
  EXPECT_EQ(reamed.letters(), "ffr");
  EXPECT_DOUBLE_EQ(reamed.height(1), 2);
}

TEST(holes, pecks) {
  Hole hole = hole_of(830);
  hole.peck = 5;  // 2, -3, -8, -10
  const Made deep = made(hole);
  EXPECT_EQ(deep.letters(), "frrfrrfr");
  EXPECT_EQ(deep.counted, 2);
  EXPECT_DOUBLE_EQ(deep.height(0), -3);
  EXPECT_DOUBLE_EQ(deep.height(1), 2);
  EXPECT_DOUBLE_EQ(deep.height(2), -3 + 0.254);
  EXPECT_DOUBLE_EQ(deep.height(6), -10);
  hole.code = 730;  // only breaks the chip
  EXPECT_EQ(made(hole).letters(), "frfrfr");
  hole.peck = 1e-6;
  EXPECT_THROW(made(hole), Refusal);
}

TEST(holes, taps_turn_back) {
  const Made right = made(hole_of(840, 1));
  EXPECT_EQ(right.letters(), "ftdft");
  EXPECT_EQ(right.steps[1].turning, -1);
  EXPECT_EQ(right.steps[4].turning, 1);
  EXPECT_THROW(made(hole_of(840, -1)), Refusal);
  EXPECT_THROW(made(hole_of(740, 1)), Refusal);
  EXPECT_EQ(made(hole_of(740, -1)).letters(), "ftdft");
}

TEST(holes, boring_stops_the_spindle) {
  EXPECT_EQ(made(hole_of(860, 1)).letters(), "fdtrt");
  EXPECT_EQ(made(hole_of(880, 1)).letters(), "fdtsrt");
  EXPECT_THROW(made(hole_of(860)), Refusal);
}

TEST(holes, back_boring_in_another_plane) {
  Hole hole = hole_of(870, 1);
  hole.plane = ArcPlane::yz;  // along x; y and z are the plane's axes
  hole.aside = {0.5, 0.25};
  hole.end = -4;
  const Made bored = made(hole);
  EXPECT_EQ(bored.letters(), "rtrrtfftrrrt");
  EXPECT_EQ(bored.steps[0].to, place(2, 2.5, 99.25));
  EXPECT_EQ(bored.steps[2].to, place(-10, 2.5, 99.25));
  EXPECT_EQ(bored.steps[3].to, place(-10, 2, 99));
  EXPECT_EQ(bored.steps[5].to, place(-4, 2, 99));
  EXPECT_EQ(bored.steps[10].to, place(5, 2, 99));
}

TEST(threads, depths_grow_by_the_degression_until_the_full_depth) {
  Thread thread;
  thread.x = 20, thread.start = 0, thread.end = -30;
  thread.pitch = 1.5, thread.peak = -2, thread.first_cut = 0.4, thread.full = 1, thread.degression = 2;
  thread.springs = 1;
  std::vector<ThreadMove> moves;
  int counted = 0;
  cut_thread(
      thread, [&](const ThreadMove& move) { moves.push_back(move); }, [&] { ++counted; });
  // Depths 0.4, 0.4 sqrt(2), and so on up to 0.4 sqrt(6) < 1; then twice 1. The last move returns to the drive line.
  ASSERT_EQ(moves.size(), (6U + 2) * 4 + 1);
  EXPECT_EQ(counted, 6);
  for (std::size_t pass = 0; pass < 8; ++pass) {
    const double depth = pass < 6 ? 0.4 * std::sqrt(static_cast<double>(pass + 1)) : 1;
    EXPECT_NEAR(moves[4 * pass + 2].x, 18 - depth, 1e-12);
    EXPECT_DOUBLE_EQ(moves[4 * pass + 2].z, -30);
    EXPECT_DOUBLE_EQ(moves[4 * pass + 2].pitch, 1.5);
    EXPECT_DOUBLE_EQ(moves[4 * pass + 3].pitch, 0);
    EXPECT_NEAR(moves[4 * pass].x, 20 + (1 - depth), 1e-12);
  }
  EXPECT_DOUBLE_EQ(moves.back().x, 20);
}

TEST(threads, tapers_at_both_ends) {
  Thread thread;
  thread.x = 20, thread.start = 0, thread.end = -30;
  thread.pitch = 1.5, thread.peak = -2, thread.first_cut = 0.5, thread.full = 1, thread.degression = 1;
  thread.taper = 2, thread.entry = thread.exit = true;
  std::vector<ThreadMove> moves;
  cut_thread(
      thread, [&](const ThreadMove& move) { moves.push_back(move); }, [] {});
  ASSERT_EQ(moves.size(), 2U * 6 + 1);
  EXPECT_DOUBLE_EQ(moves[1].x, 20 - 2 - 0.5 + 1);
  EXPECT_DOUBLE_EQ(moves[2].z, -2);
  EXPECT_DOUBLE_EQ(moves[2].pitch, 1.5 * std::hypot(2, 1) / 2);
  EXPECT_DOUBLE_EQ(moves[3].z, -28);
  EXPECT_DOUBLE_EQ(moves[4].z, -30);
}

// A quarter of a circle is a rational quadratic curve with the middle weight sqrt(1/2).
TEST(splines, nurbs_of_a_circle) {
  Nurbs curve({10, 0});
  curve.add({10, 10}, std::sqrt(0.5));
  curve.add({0, 10}, 1);
  std::vector<Vec2> points;
  curve.flatten([&](const Vec2& point) { points.push_back(point); });
  ASSERT_GT(points.size(), 20U);
  Vec2 before(10, 0);
  for (const Vec2& point : points) {
    EXPECT_NEAR(point.norm(), 10, 1e-9);
    EXPECT_GT(((point + before) / 2).norm(), 10 - 0.00101);
    before = point;
  }
  EXPECT_EQ(before, Vec2(0, 10));
}

TEST(splines, nurbs_of_order_two_is_its_polygon) {
  Nurbs curve({0, 0});
  curve.set_order(2);
  curve.set_first_weight(3);
  curve.add({10, 0}, 1);
  curve.add({10, 5}, 2);
  double length = 0;
  Vec2 before(0, 0);
  curve.flatten([&](const Vec2& point) {
    EXPECT_TRUE(std::abs(point.y()) < 1e-12 || std::abs(point.x() - 10) < 1e-12);
    length += (point - before).norm();
    before = point;
  });
  EXPECT_NEAR(length, 15, 1e-9);
}

TEST(splines, refusals) {
  Nurbs curve({0, 0});
  EXPECT_THROW(curve.set_order(1), Refusal);
  EXPECT_THROW(curve.set_order(33), Refusal);
  curve.add({1, 0}, 1);
  EXPECT_THROW(curve.flatten([](const Vec2&) {}), Refusal);
}

TEST(splines, a_cubic_within_its_tolerance) {
  const std::array<Vec2, 4> control{Vec2(0, 0), Vec2(0, 10), Vec2(10, 10), Vec2(10, 0)};
  const auto exact = [&](double t) -> Vec2 { return {30 * t * t - 20 * t * t * t, 30 * t * (1 - t)}; };
  std::vector<Vec2> points{{0, 0}};
  flatten(control, [&](const Vec2& point) { points.push_back(point); });
  EXPECT_EQ(points.back(), Vec2(10, 0));
  for (double t = 0; t <= 1; t += 0.001) {
    double nearest = 1e9;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Vec2 chord = points[i] - points[i - 1], off = exact(t) - points[i - 1];
      const double share = std::clamp(off.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (off - share * chord).norm());
    }
    EXPECT_LE(nearest, 0.0011);
  }
}

}  // namespace
}  // namespace fieldfab::cam::gcode

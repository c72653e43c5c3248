// Feeds by the removed material, against closed forms.
#include "fieldfab/cam/plan/feeds.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace fieldfab::cam {
namespace {

constexpr double depth = 2, radius = 3, feed = 600;

Tool cutter() {
  Tool tool;
  tool.diameter = 2 * radius;
  tool.flute = 12;
  tool.length = 30;
  return tool;
}

/// 80 x 60 x 10 mm, its top at z 0.
MeasuredStock block() { return MeasuredStock(Stock({{0, 0, -10}, {80, 60, 0}}, {.cell = 0.2})); }

/// The tip's feed at a place, from moves that pass it along x.
double feed_at(const std::vector<Move>& moves, double x, double y) {
  for (std::size_t k = 1; k < moves.size(); ++k) {
    const Vec3 &a = moves[k - 1].to, &b = moves[k].to;
    if (!moves[k].rapid() && std::abs(a.y() - y) < 1e-9 && std::abs(b.y() - y) < 1e-9 && std::min(a.x(), b.x()) <= x &&
        x <= std::max(a.x(), b.x()))
      return moves[k].feed;
  }
  return 0;
}

double chip(double width) { return width >= radius ? 1 : std::sqrt(width * (2 * radius - width)) / radius; }

/// Passes along x at these y, each from outside of the block to its other side.
std::vector<Move> passes(const std::vector<double>& heights) {
  std::vector<Move> moves{{{-20, 0, 20}, 0}};
  for (const double y : heights) {
    moves.push_back({{-20, y, 20}, 0});
    moves.push_back({{-20, y, -depth}, 0});
    moves.push_back({{100, y, -depth}, feed});
    moves.push_back({{100, y, 20}, 0});
  }
  return moves;
}

TEST(Feeds, FollowTheWidthOfCut) {
  // Ten passes of 3 mm beside each other, then one of 1 mm, one of 0.2 mm and a slot of 6 mm; all rims are halfway
  // between two planes of the lattice.
  const std::vector<double> at{0.1, 3.1, 6.1, 9.1, 12.1, 15.1, 18.1, 21.1, 24.1, 27.1, 28.1, 28.3, 50.1};
  FeedReport report;
  const std::vector<Move> moves = block().adjust(passes(at), cutter(), {}, 3, {.least = 0.4, .most = 2.5}, report);
  EXPECT_NEAR(report.usual, 3.1 * depth, 0.01);  // the first pass: those up to it are 12 of 13
  const auto factor = [&](double y) { return feed_at(moves, 40, y) / feed; };
  const auto expect = [&](double y, double expected) {  // a ladder of steps of 15 %, downwards
    EXPECT_LE(factor(y), expected * 1.02) << y;
    EXPECT_GE(factor(y), expected / 1.19) << y;
  };
  for (const double y : {3.1, 9.1, 18.1, 27.1}) EXPECT_NEAR(factor(y), 1, 1e-9) << y;
  expect(28.1, 1 / chip(1));
  expect(28.3, 2.5);
  expect(50.1, 0.5);
  // In air it is fast, and slow before it gets to the block's side, which its rim meets at x = -3.
  EXPECT_NEAR(feed_at(moves, -15, 50.1) / feed, 2.5, 0.35);
  EXPECT_LT(feed_at(moves, -3.2, 50.1) / feed, 1.6);
  EXPECT_LT(feed_at(moves, -1.2, 50.1) / feed, 0.6);
  EXPECT_NEAR(feed_at(moves, 95, 50.1) / feed, 2.5, 0.35);
  EXPECT_LE(report.rate_after, report.rate_before);
  EXPECT_NEAR(report.rate_before, 6 * depth * feed, 0.02 * 6 * depth * feed);
}

TEST(Feeds, KeepTheWayAndTheFeedOfDescents) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(5, 75), y(5, 55), bulge(-0.8, 0.8);
  std::vector<Move> moves{{{10, 10, 20}, 0}, {{10, 10, 2}, 0}, {{10, 10, -1}, 100}};
  for (int i = 0; i < 60; ++i) moves.push_back({{x(random), y(random), -1}, feed, i % 3 == 0 ? bulge(random) : 0});
  moves.push_back({{40, 30, -3}, 200});  // a ramp
  FeedReport report;
  MeasuredStock stock = block();
  const std::vector<Move> adjusted = stock.adjust(moves, cutter(), {}, 6, {}, report);
  EXPECT_NEAR(lengths(adjusted).cut, lengths(moves).cut, 1e-6);
  EXPECT_EQ(lengths(adjusted).rapid, lengths(moves).rapid);
  EXPECT_LE(report.rate_after, report.rate_before * (1 + 1e-9));
  std::size_t k = 0;
  for (const Move& move : moves) {  // all ends, in their order
    while (k < adjusted.size() && (adjusted[k].to - move.to).norm() > 1e-9) {
      EXPECT_GE(adjusted[k].feed, 0.4 * move.feed - 1e-9);
      EXPECT_LE(adjusted[k].feed, 2.5 * move.feed + 1e-9);
      ++k;
    }
    ASSERT_LT(k, adjusted.size());
    ++k;
  }
  EXPECT_EQ(k, adjusted.size());
  // The plunge is as planned once it meets material, at z 0; the ramp never is faster there.
  for (std::size_t i = 1; i < adjusted.size(); ++i) {
    if (adjusted[i].rapid() || adjusted[i].to.z() >= adjusted[i - 1].to.z() - 1e-9) continue;
    const bool plunges = adjusted[i].to.z() < -0.05 && adjusted[i].to.z() > -1 - 1e-9;
    EXPECT_LE(adjusted[i].feed, plunges ? 100 + 1e-9 : 500) << i;
  }
  // The second time there is nothing to remove: all of it is air.
  for (const Move& move : stock.adjust(moves, cutter(), {}, 6, {}, report))
    EXPECT_TRUE(move.rapid() || move.feed > 200) << move.feed;
  EXPECT_EQ(report.usual, 0);
}

TEST(Feeds, AreCutFromTiltedPlanesToo) {
  Plane side;
  side.axes << 0, 0, 1, 1, 0, 0, 0, 1, 0;  // its z is the part's x
  side.origin = {30, -5.1, 80};            // in its own coordinates
  std::vector<Move> moves{{{-60, 0, 5}, 0}, {{-60, 0, -1}, 0}, {{60, 0, -1}, feed}};
  FeedReport report;
  const std::vector<Move> adjusted = block().adjust(moves, cutter(), side, 6, {}, report);
  EXPECT_NEAR(report.usual, 6 * 1, 0.01);
  EXPECT_GT(adjusted.size(), 4u);
}

}  // namespace
}  // namespace fieldfab::cam

// Arcs: G2 and G3.
#include <cmath>
#include <numbers>

#include "interpreter.h"

namespace fieldfab::cam::gcode {
namespace {

// LinuxCNC's tolerances of the difference between a circle's two radii, or between a radius and
// half its chord.
constexpr double radius_tolerance = 0.00127;  // mm
// mm, for radii whose difference is also more than a thousandth of the radius
constexpr double spiral_tolerance = 0.0282842712475;
constexpr double most_spiral = 100;  // factor of that

}  // namespace

double Interpreter::arc_length(const Vec2& from, const Vec2& to, const Vec2& centre, int turns) {
  const Vec2 a = from - centre, b = to - centre;
  const double around = 2 * std::numbers::pi;
  double sweep = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
  if (turns < 0) sweep = -sweep;
  while (sweep <= 1e-12) sweep += around;  // no angle means a full circle
  while (sweep > around + 1e-12) sweep -= around;
  return (sweep + around * (std::abs(turns) - 1)) * a.norm();
}

/// Centre and number of turns of the block's arc, from I, J, K or R.
Interpreter::Circle Interpreter::circle(const Vec2& from, const Vec2& to) const {
  static constexpr std::array<std::array<char, 3>, 3> offset_letters{
      {{'i', 'j', 'k'}, {'k', 'i', 'j'}, {'j', 'k', 'i'}}};
  const auto& [first, second, other] = offset_letters[static_cast<std::size_t>(modes_.plane)];
  const int code = block_.code(GGroup::motion) == Block::none ? modes_.motion : block_.code(GGroup::motion);
  const int direction = code == 30 ? 1 : -1;
  Circle circle;
  int turns = 1;
  if (block_.has('p')) {
    turns = whole(block_['p'], 1'000'000);
    if (turns < 1) refuse("an arc with P{}: turns are 1 or more", turns);
  }
  circle.turns = direction * turns;
  const bool centred = block_.has(first) || block_.has(second);
  if (block_.has(other)) refuse("{} in an arc of another plane", static_cast<char>(other - 32));
  if (block_.has('r')) {
    if (centred) refuse("an arc with R and a centre");
    const double radius = length(block_['r']), size = std::abs(radius);
    const Vec2 chord = to - from;
    const double half = chord.norm() / 2;
    if (half == 0) refuse("an arc with R that ends where it begins");
    if (half - size > radius_tolerance) refuse("the radius {} is too small to reach the arc's end", block_['r']);
    const double aside = std::sqrt(std::max(0.0, size * size - half * half));
    // of the direction from the arc's start to its end
    const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
    circle.centre = (from + to) / 2 + left * aside * (direction * (radius > 0 ? 1 : -1));
    return circle;
  }
  if (!centred) refuse("an arc without R and without its centre's offsets");
  if (modes_.arcs_absolute) {
    if (!block_.has(first) || !block_.has(second))
      refuse("under G90.1 an arc needs {} and {}", static_cast<char>(first - 32), static_cast<char>(second - 32));
    circle.centre = {length(block_[first]), length(block_[second])};
  } else {
    circle.centre =
        from + Vec2(block_.has(first) ? length(block_[first]) : 0, block_.has(second) ? length(block_[second]) : 0);
  }
  const double begin = (circle.centre - from).norm(), end = (circle.centre - to).norm(), off = std::abs(begin - end);
  if (begin < radius_tolerance || end < radius_tolerance) refuse("an arc with a radius of 0");
  const double tolerance = modes_.inch ? spiral_tolerance * 2.54 : spiral_tolerance;
  if (off > most_spiral * tolerance || (off > tolerance && off > 0.001 * std::max(begin, end)))
    refuse("the arc begins {:.4f} mm from its centre and ends {:.4f} mm from it", begin, end);
  return circle;
}

void Interpreter::arc() {
  const PlaneAxes axes = axes_of(modes_.plane);
  static constexpr std::array<char, 9> letters{'x', 'y', 'z', 'a', 'b', 'c', 'u', 'v', 'w'};
  if (block_.machine_coordinates) refuse("G53 goes with G0 and G1 only");
  if (block_.has('r') && !block_.has(letters[axes.first]) && !block_.has(letters[axes.second]) && !block_.has_radius &&
      !block_.has_angle)
    refuse("an arc with R and no place to end in its plane");
  if (modes_.feed_mode == 930 && !block_.has('f')) refuse("under G93 each arc needs its F word");
  require_feed();
  const AxisValues& from = compensation_.side != 0 && compensation_.entered ? compensation_.programmed : at_;
  const AxisValues to = target();
  const Circle found = circle({from.at[axes.first], from.at[axes.second]}, {to.at[axes.first], to.at[axes.second]});
  if (compensation_.side != 0)
    compensated_arc(to, found);
  else
    move_arc(to, found.centre, found.turns);
}

}  // namespace fieldfab::cam::gcode

#include "arcs.h"

#include <cmath>

namespace fieldfab::cam::gcode {
namespace {

// LinuxCNC's tolerances of the difference between a circle's two radii, or between a radius and half its chord.
constexpr double radius_tolerance = 0.00127;  // mm
// mm, for radii whose difference is also more than a thousandth of the radius
constexpr double spiral_tolerance = 0.0282842712475;
constexpr double most_spiral = 100;  // factor of that

/// Letters of the centre's offsets along the first, second and third axis of a plane.
constexpr std::array<std::array<char, 3>, 3> offset_letters{{{'i', 'j', 'k'}, {'k', 'i', 'j'}, {'j', 'k', 'i'}}};

char upper(char letter) { return static_cast<char>(letter - 32); }

/// Centre of an arc of a radius. Anticlockwise with a positive radius it is to the left of the chord.
Vec2 centre_by_radius(double radius, double word, int direction, const Vec2& from, const Vec2& to) {
  const double size = std::abs(radius);
  const Vec2 chord = to - from;
  const double half = chord.norm() / 2;
  if (half == 0) refuse("an arc with R that ends where it begins");
  if (half - size > radius_tolerance) refuse("the radius {} is too small to reach the arc's end", word);
  const double aside = std::sqrt(std::max(0.0, size * size - half * half));
  // of the direction from the arc's start to its end
  const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
  return (from + to) / 2 + left * aside * (direction * (radius > 0 ? 1 : -1));
}

void check_radii(double begin, double end, bool inch) {
  if (begin < radius_tolerance || end < radius_tolerance) refuse("an arc with a radius of 0");
  const double off = std::abs(begin - end), tolerance = inch ? spiral_tolerance * 2.54 : spiral_tolerance;
  if (off > most_spiral * tolerance || (off > tolerance && off > 0.001 * std::max(begin, end)))
    refuse("the arc begins {:.4f} mm from its centre and ends {:.4f} mm from it", begin, end);
}

}  // namespace

std::string without_idle_offsets(Block& block, const Modes& modes) {
  const auto& [first, second, across] = offset_letters[static_cast<std::size_t>(modes.plane)];
  std::string removed;
  for (const char letter : {first, second, across}) {
    if (!block.has(letter) || (letter != across && !block.has('r'))) continue;
    if (block[letter] != 0) removed += fmt::format("{}{}", removed.empty() ? "" : " and ", upper(letter));
    block.words &= ~(1U << static_cast<unsigned>(letter - 'a'));
  }
  return removed.empty() ? removed : fmt::format("{} of an arc that has no use for it: passed over", removed);
}

Circle circle_of(const Block& block, const Modes& modes, int direction, const Vec2& from, const Vec2& to) {
  const auto& [first, second, other] = offset_letters[static_cast<std::size_t>(modes.plane)];
  Circle circle;
  int turns = 1;
  if (block.has('p')) {
    turns = whole(block['p'], 1'000'000);
    if (turns < 1) refuse("an arc with P{}: turns are 1 or more", turns);
  }
  circle.turns = direction * turns;
  const bool centred = block.has(first) || block.has(second);
  if (block.has(other)) refuse("{} in an arc of another plane", upper(other));
  if (block.has('r')) {
    if (centred) refuse("an arc with R and a centre");
    circle.centre = centre_by_radius(modes.length(block['r']), block['r'], direction, from, to);
    return circle;
  }
  if (!centred) refuse("an arc without R and without its centre's offsets");
  if (modes.arcs_absolute) {
    if (!block.has(first) || !block.has(second))
      refuse("under G90.1 an arc needs {} and {}", upper(first), upper(second));
    circle.centre = {modes.length(block[first]), modes.length(block[second])};
  } else {
    const auto offset = [&](char letter) { return block.has(letter) ? modes.length(block[letter]) : 0; };
    circle.centre = from + Vec2(offset(first), offset(second));
  }
  check_radii((circle.centre - from).norm(), (circle.centre - to).norm(), modes.inch);
  return circle;
}

}  // namespace fieldfab::cam::gcode

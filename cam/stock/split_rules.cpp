#include <fmt/format.h>

#include <cctype>
#include <cmath>

#include "fieldfab/core/error.h"
#include "good_bad.h"

namespace fieldfab::cam {
namespace {

/// The plane of an interval nearest to the middle of its cell.
int plane_of(const SplitInterval& interval, const Region& region) {
  const int middle = region.first(interval.axis) + region.count(interval.axis) / 2;
  return std::clamp(middle, interval.first, interval.last);
}

/// Distance from the plane to the nearest side of the cell, mm.
double from_side(const SplitInterval& interval, const Region& region, const Vec3& spacing) {
  const int plane = plane_of(interval, region);
  return spacing[interval.axis] * std::min(plane - region.first(interval.axis), region.last(interval.axis) + 1 - plane);
}

int rank_of_type(const SplitInterval& interval) { return interval.complete ? 2 : interval.sole ? 1 : 0; }

}  // namespace

std::vector<SplitRule> parse_split_rules(const std::string& text) {
  std::vector<SplitRule> rules;
  std::string word;
  const auto finish = [&] {
    if (word.empty()) return;
    if (word == "CTD")
      rules.push_back(SplitRule::closest_toolcut_direction);
    else if (word == "SPT")
      rules.push_back(SplitRule::split_plane_type);
    else if (word == "FFS")
      rules.push_back(SplitRule::furthest_from_side);
    else if (word == "FEFS")
      rules.push_back(SplitRule::far_enough_from_side);
    else if (word == "FEFS-FFS")
      rules.push_back(SplitRule::far_enough_then_furthest);
    else if (word == "RS")
      rules.push_back(SplitRule::random_selection);
    else
      throw Error(ErrorKind::bad_input, "rules",
                  fmt::format("\"{}\" is none of CTD, SPT, FFS, FEFS, FEFS-FFS, RS", word));
    word.clear();
  };
  for (const char c : text) {
    if (c == ',' || c == ' ' || c == '\t')
      finish();
    else
      word.push_back(static_cast<char>(std::toupper(static_cast<unsigned char>(c))));
  }
  finish();
  return rules;
}

SplitChoice choose_split(const std::vector<SplitInterval>& intervals, const Region& region, const Vec3& spacing,
                         const std::vector<SplitRule>& rules, const Vec3& tool_axis, double tool_radius,
                         std::minstd_rand& random) {
  std::vector<const SplitInterval*> left;
  for (const SplitInterval& interval : intervals) left.push_back(&interval);
  // Each rule keeps the candidates with the highest score.
  const auto keep = [&](const auto& liking) {
    double most = -1e300;
    for (const SplitInterval* interval : left) most = std::max(most, static_cast<double>(liking(*interval)));
    std::erase_if(left,
                  [&](const SplitInterval* interval) { return static_cast<double>(liking(*interval)) < most - 1e-9; });
  };
  const auto far_enough = [&](const SplitInterval& i) { return from_side(i, region, spacing) > tool_radius ? 1 : 0; };
  const auto furthest = [&](const SplitInterval& i) { return from_side(i, region, spacing); };
  for (const SplitRule rule : rules) {
    if (left.size() < 2) break;
    switch (rule) {
      case SplitRule::closest_toolcut_direction:
        keep([&](const SplitInterval& i) { return -std::abs(tool_axis[i.axis]); });
        break;
      case SplitRule::split_plane_type: keep(rank_of_type); break;
      case SplitRule::furthest_from_side: keep(furthest); break;
      case SplitRule::far_enough_from_side: keep(far_enough); break;
      case SplitRule::far_enough_then_furthest: {
        const std::size_t before = left.size();
        keep(far_enough);
        if (left.size() == before) keep(furthest);
        break;
      }
      case SplitRule::random_selection: left = {left[random() % left.size()]}; break;
    }
  }
  return {left.front()->axis, plane_of(*left.front(), region), left.front()->kind};
}

}  // namespace fieldfab::cam

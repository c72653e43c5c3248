#include "good_bad.h"

#include <bit>

namespace fieldfab::cam {
namespace {

using Word = Occupancy::Word;

/// An empty map of a region's lines along an axis.
GoodBadMap blank(const Region& region, int axis) {
  const int ua = (axis + 1) % 3, va = (axis + 2) % 3;
  GoodBadMap map{axis, region.first(ua), region.first(va), region.count(ua), region.count(va), {}, {}, {}};
  map.pixels.assign(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height), Pixel::none);
  return map;
}

/// Properties of the runs of 64 lines, as bit masks: a run exists, a second run exists, a run
/// touches an end.
struct Runs {
  Word one = 0, more = 0, first = 0, last = 0;
  void add(Word start) { more |= one & start, one |= start; }
  [[nodiscard]] Pixel pixel(int bit) const {
    const Word b = Word{1} << bit;
    if (!(one & b)) return Pixel::none;
    if (more & b) return Pixel::bad;
    if (first & b) return last & b ? Pixel::none : Pixel::positive;
    return last & b ? Pixel::negative : Pixel::segment;
  }
};

/// Calls body(u, v) for the lines of a map's axis whose bit is set in any of the planes that
/// `plane` returns.
template <class Plane>
void mark_lines(const Occupancy& shape, GoodBadMap& map, std::vector<char>& marks, const Plane& plane) {
  marks.assign(map.pixels.size(), 0);
  const Region& r = shape.region();
  for (int z = r.lower[2]; z <= r.upper[2]; ++z)
    for (int y = r.lower[1]; y <= r.upper[1]; ++y)
      for (std::size_t w = 0; w < shape.words(); ++w) {
        Word bits = plane(w, y, z) & shape.valid(w);
        if (!bits) continue;
        if (map.axis == 0) {
          marks[map.index(y, z)] = 1;
          continue;
        }
        for (; bits; bits &= bits - 1) {
          const int x = r.lower[0] + static_cast<int>(w) * 64 + std::countr_zero(bits);
          marks[map.axis == 1 ? map.index(z, x) : map.index(x, y)] = 1;
        }
      }
}

}  // namespace

Occupancy Occupancy::part(const Region& region) const {
  Occupancy result(region);
  const auto shift = static_cast<std::size_t>(region.lower[0] - region_.lower[0]);
  for (int z = region.lower[2]; z <= region.upper[2]; ++z)
    for (int y = region.lower[1]; y <= region.upper[1]; ++y) {
      const Word* from = row(y, z);
      Word* to = result.row(y, z);
      for (std::size_t w = 0; w < result.words_; ++w) {
        const std::size_t at = w + shift / 64;
        Word bits = from[at] >> (shift % 64);
        if (shift % 64 && at + 1 < words_) bits |= from[at + 1] << (64 - shift % 64);
        to[w] = bits & result.valid(w);
      }
    }
  return result;
}

std::vector<std::pair<int, int>> Occupancy::runs(int axis) const {
  const Region& r = region_;
  const int ua = (axis + 1) % 3, va = (axis + 2) % 3;
  const auto width = static_cast<std::size_t>(r.count(ua));
  std::vector<std::pair<int, int>> result(width * static_cast<std::size_t>(r.count(va)),
                                          {r.last(axis) + 1, r.first(axis) - 1});
  const auto line = [&](int u, int v) -> std::pair<int, int>& {
    return result[static_cast<std::size_t>(v - r.first(va)) * width + static_cast<std::size_t>(u - r.first(ua))];
  };
  if (axis == 0) {
    for (int z = r.lower[2]; z <= r.upper[2]; ++z)
      for (int y = r.lower[1]; y <= r.upper[1]; ++y)
        for (std::size_t w = 0; w < words_; ++w) {
          const Word bits = row(y, z)[w];
          if (!bits) continue;
          const int from = r.lower[0] + static_cast<int>(w) * 64;
          auto& [first, last] = line(y, z);
          first = std::min(first, from + std::countr_zero(bits)), last = from + 63 - std::countl_zero(bits);
        }
    return result;
  }
  const std::size_t across = axis == 1 ? 2 : 1, along = axis == 1 ? 1 : 2;
  for (int other = r.lower[across]; other <= r.upper[across]; ++other)
    for (std::size_t w = 0; w < words_; ++w) {
      Word seen = 0, previous = 0;
      const auto each = [&](Word bits, const auto& body) {
        for (; bits; bits &= bits - 1) {
          const int x = r.lower[0] + static_cast<int>(w) * 64 + std::countr_zero(bits);
          body(axis == 1 ? line(other, x) : line(x, other));
        }
      };
      for (int k = r.lower[along]; k <= r.upper[along] + 1; ++k) {
        const Word bits = k > r.upper[along] ? 0 : axis == 1 ? row(k, other)[w] : row(other, k)[w];
        each(bits & ~seen, [&](std::pair<int, int>& run) { run.first = k; });
        each(previous & ~bits, [&](std::pair<int, int>& run) { run.second = k - 1; });
        seen |= bits, previous = bits;
      }
    }
  return result;
}

GoodBadMap good_bad_map(const Occupancy& solid, int axis) {
  const Region& r = solid.region();
  GoodBadMap map = blank(r, axis);
  if (axis == 0) {
    for (int z = r.lower[2]; z <= r.upper[2]; ++z)
      for (int y = r.lower[1]; y <= r.upper[1]; ++y) {
        const Word* row = solid.row(y, z);
        int starts = 0;
        Word carry = 0;
        for (std::size_t w = 0; w < solid.words(); ++w) {
          starts += std::popcount(row[w] & ~(row[w] << 1 | carry));
          carry = row[w] >> 63;
        }
        const bool first = row[0] & 1, last = solid.at({r.upper[0], y, z});
        Pixel& pixel = map.pixels[map.index(y, z)];
        if (starts > 1)
          pixel = Pixel::bad;
        else if (starts == 1)
          pixel = first ? (last ? Pixel::none : Pixel::positive) : last ? Pixel::negative : Pixel::segment;
      }
    return map;
  }
  // 64 lines at a time: along y within each z, or along z within each y.
  const std::size_t across = axis == 1 ? 2 : 1, along = axis == 1 ? 1 : 2;
  for (int other = r.lower[across]; other <= r.upper[across]; ++other)
    for (std::size_t w = 0; w < solid.words(); ++w) {
      Runs runs;
      Word previous = 0;
      for (int k = r.lower[along]; k <= r.upper[along]; ++k) {
        const Word bits = axis == 1 ? solid.row(k, other)[w] : solid.row(other, k)[w];
        runs.add(bits & ~previous);
        if (k == r.lower[along]) runs.first = bits;
        previous = bits;
      }
      runs.last = previous;
      if (!runs.one) continue;
      const int count = std::min(64, r.count(0) - static_cast<int>(w) * 64);
      for (int bit = 0; bit < count; ++bit) {
        const int x = r.lower[0] + static_cast<int>(w) * 64 + bit;
        map.pixels[axis == 1 ? map.index(other, x) : map.index(x, other)] = runs.pixel(bit);
      }
    }
  return map;
}

bool functional(const GoodBadMap& map, bool both_ends, std::int8_t& facing) {
  bool positive = false, negative = false;
  for (const Pixel pixel : map.pixels) {
    if (pixel == Pixel::bad) return false;
    positive |= pixel == Pixel::positive || pixel == Pixel::segment;
    negative |= pixel == Pixel::negative || pixel == Pixel::segment;
  }
  if (positive && negative && !both_ends) return false;
  facing = static_cast<std::int8_t>(positive && negative ? 0 : negative ? -1 : 1);
  return true;
}

namespace {

/// Solid points of the columns that the cell's own direction cannot represent, as rows of bits.
Occupancy unresolved_columns(const Occupancy& solid, const GoodBadMap& own, std::int8_t facing, bool both_ends) {
  const Region& r = solid.region();
  Occupancy points(r);
  for (int v = 0; v < own.height; ++v)
    for (int u = 0; u < own.width; ++u) {
      const Pixel pixel = own.pixels[own.index(own.u0 + u, own.v0 + v)];
      const bool fine = pixel == Pixel::none ||
                        (both_ends ? pixel != Pixel::bad : pixel == (facing < 0 ? Pixel::negative : Pixel::positive));
      if (fine) continue;
      Index3 p;
      const auto a = static_cast<std::size_t>(own.axis);
      p[(a + 1) % 3] = own.u0 + u, p[(a + 2) % 3] = own.v0 + v;
      for (p[a] = r.lower[a]; p[a] <= r.upper[a]; ++p[a]) points.set(p);
    }
  return points;
}

/// Marks the lines of a map that cross the surface at an unresolved column.
void mark_unresolved(const Occupancy& solid, const Occupancy& columns, GoodBadMap& map) {
  const Region& r = solid.region();
  mark_lines(solid, map, map.unresolved, [&](std::size_t w, int y, int z) -> Word {
    const Word here = solid.row(y, z)[w], here_columns = columns.row(y, z)[w];
    if (map.axis == 0) {
      // Bit i represents the edge from i to i + 1.
      const bool more = w + 1 < solid.words();
      const Word next = here >> 1 | (more ? solid.row(y, z)[w + 1] << 63 : 0);
      const Word next_columns = here_columns >> 1 | (more ? columns.row(y, z)[w + 1] << 63 : 0);
      Word edges = (here ^ next) & (here_columns | next_columns);
      if (!more) edges &= solid.valid(w) >> 1;
      return edges;
    }
    const int y1 = map.axis == 1 ? y + 1 : y, z1 = map.axis == 2 ? z + 1 : z;
    if (y1 > r.upper[1] || z1 > r.upper[2]) return 0;
    return (here ^ solid.row(y1, z1)[w]) & (here_columns | columns.row(y1, z1)[w]);
  });
}

/// A rectangle of pixels, both ends included.
struct Rect {
  int u0, u1, v0, v1;
};

/// Bounding rectangles of the connected regions of pixels for which `wanted` returns true, row by
/// row (Hahn 5.3).
template <class Wanted>
std::vector<Rect> regions_of(const GoodBadMap& map, const Wanted& wanted) {
  std::vector<Rect> done, previous, current;
  for (int v = 0; v < map.height; ++v) {
    current.clear();
    for (int u = 0; u < map.width; ++u) {
      if (!wanted(map.index(map.u0 + u, map.v0 + v))) continue;
      const int start = u;
      while (u + 1 < map.width && wanted(map.index(map.u0 + u + 1, map.v0 + v))) ++u;
      current.push_back({start, u, v, v});
    }
    for (Rect& c : current)
      std::erase_if(previous, [&](const Rect& p) {
        if (p.u0 > c.u1 + 1 || p.u1 < c.u0 - 1) return false;
        c = {std::min(c.u0, p.u0), std::max(c.u1, p.u1), std::min(c.v0, p.v0), v};
        return true;
      });
    done.insert(done.end(), previous.begin(), previous.end());
    previous.swap(current);
  }
  done.insert(done.end(), previous.begin(), previous.end());
  for (Rect& rect : done) rect = {rect.u0 + map.u0, rect.u1 + map.u0, rect.v0 + map.v0, rect.v1 + map.v0};
  return done;
}

/// Split planes that isolate a region from the nearest ones that conflict with it, along both axes
/// of the map (Hahn Fig. 3.9).
void isolate(const GoodBadMap& map, const Rect& region, const std::vector<Rect>& conflicts, SplitInterval::Kind kind,
             std::vector<SplitInterval>& intervals) {
  for (const bool along_u : {true, false}) {
    const int axis = (map.axis + (along_u ? 1 : 2)) % 3;
    const int low = along_u ? region.u0 : region.v0, high = along_u ? region.u1 : region.v1;
    // The nearest conflict on each side. A conflict belongs to the side that it extends to farther,
    // and its near end counts.
    bool have_left = false, have_right = false;
    int left_end = 0, right_start = 0;
    for (const Rect& c : conflicts) {
      const int c_low = along_u ? c.u0 : c.v0, c_high = along_u ? c.u1 : c.v1;
      if (c_low < low && (!have_left || c_high > left_end)) have_left = true, left_end = c_high;
      if (c_high > high && (!have_right || c_low < right_start)) have_right = true, right_start = c_low;
      // A conflict within the region's extent lies inside: planes at its ends separate partially.
      if (c_low >= low && c_high <= high) {
        if (c_low > low) intervals.push_back({kind, axis, c_low, c_low, false, false});
        if (c_high < high) intervals.push_back({kind, axis, c_high + 1, c_high + 1, false, false});
      }
    }
    if (have_left) {
      if (left_end < low)
        intervals.push_back({kind, axis, left_end + 1, low, true, false});
      else if (left_end < high)
        intervals.push_back({kind, axis, left_end + 1, left_end + 1, false, false}),
            intervals.push_back({kind, axis, low, low, false, false});
      else
        intervals.push_back({kind, axis, low, low, false, false});
    }
    if (have_right) {
      if (right_start > high)
        intervals.push_back({kind, axis, high + 1, right_start, true, false});
      else if (right_start > low)
        intervals.push_back({kind, axis, right_start, right_start, false, false}),
            intervals.push_back({kind, axis, high + 1, high + 1, false, false});
      else
        intervals.push_back({kind, axis, high + 1, high + 1, false, false});
    }
  }
}

/// A run of a line between two surfaces, as the range of possible first points of an upper child.
struct Segment {
  int first, last;
  bool low_unresolved, high_unresolved;
};

/// Intersects [first, last] with the segments in their order, and removes the segments that
/// contribute. Returns whether one of them touches unresolved surface (Hahn Fig. 3.17).
bool take_overlapping(std::vector<Segment>& segments, int& first, int& last) {
  bool all_resolved = true;
  std::erase_if(segments, [&](const Segment& s) {
    if (s.first > last || s.last < first) return false;
    first = std::max(first, s.first), last = std::min(last, s.last);
    if (s.low_unresolved || s.high_unresolved) all_resolved = false;
    return true;
  });
  return !all_resolved;
}

/// Split intervals from sets of overlapping segments (Hahn Fig. 3.16).
void overlap_sets(std::vector<Segment>& segments, int axis, std::vector<SplitInterval>& series) {
  while (!segments.empty()) {
    int first = std::numeric_limits<int>::min(), last = std::numeric_limits<int>::max();
    if (take_overlapping(segments, first, last))
      series.push_back({SplitInterval::Kind::direct, axis, first, last, false, false});
  }
}

/// Direct split planes along the map's axis (Hahn 3.2.3).
void direct_splits(const Occupancy& solid, const Occupancy& covered, const Occupancy& columns, const GoodBadMap& map,
                   std::vector<SplitInterval>& intervals) {
  const Region& r = solid.region();
  const auto a = static_cast<std::size_t>(map.axis);
  std::vector<Segment> left, tool, right;
  int unresolved_low = std::numeric_limits<int>::max(), unresolved_high = std::numeric_limits<int>::min();
  for (int v = map.v0; v < map.v0 + map.height; ++v)
    for (int u = map.u0; u < map.u0 + map.width; ++u) {
      const std::size_t index = map.index(u, v);
      if (!map.unresolved[index] || (map.pixels[index] != Pixel::bad && map.pixels[index] != Pixel::segment)) continue;
      // Crossings of the surface along the line: crossing i lies between points at[i] - 1 and
      // at[i].
      struct Crossing {
        int at;
        bool unresolved;
      };
      std::vector<Crossing> crossings;
      Index3 p;
      p[(a + 1) % 3] = u, p[(a + 2) % 3] = v;
      bool before = false, before_column = false;
      std::vector<bool> touched(1, false);  // between crossings: whether the tool is present
      for (p[a] = r.lower[a]; p[a] <= r.upper[a]; ++p[a]) {
        const bool here = solid.at(p), here_column = columns.at(p);
        if (p[a] > r.lower[a] && here != before) {
          crossings.push_back({p[a], here_column || before_column});
          touched.push_back(false);
          if (crossings.back().unresolved)
            unresolved_low = std::min(unresolved_low, p[a] - 1), unresolved_high = std::max(unresolved_high, p[a]);
        }
        if (covered.at(p)) touched.back() = true;
        before = here, before_column = here_column;
      }
      const auto segment = [&](std::size_t i) {
        return Segment{crossings[i].at, crossings[i + 1].at, crossings[i].unresolved, crossings[i + 1].unresolved};
      };
      for (std::size_t i = 0; i < touched.size(); ++i) {
        if (!touched[i]) continue;
        if (i >= 1 && i < crossings.size()) tool.push_back(segment(i - 1));
        if (i >= 2) left.push_back(segment(i - 2));
        if (i + 1 < crossings.size()) right.push_back(segment(i));
      }
    }
  std::vector<SplitInterval> series;
  overlap_sets(tool, map.axis, series);
  for (SplitInterval& interval : series) (void)take_overlapping(left, interval.first, interval.last);
  for (SplitInterval& interval : series) (void)take_overlapping(right, interval.first, interval.last);
  overlap_sets(left, map.axis, series);
  overlap_sets(right, map.axis, series);
  for (SplitInterval& interval : series) {
    if (interval.first > unresolved_high) interval.first = unresolved_high;
    if (interval.last < unresolved_low) interval.last = unresolved_low;
    interval.sole = series.size() == 1;
  }
  intervals.insert(intervals.end(), series.begin(), series.end());
}

}  // namespace

std::vector<SplitInterval> split_intervals(const Occupancy& solid, const Occupancy& covered, int axis,
                                           std::int8_t facing, bool both_ends) {
  std::array<GoodBadMap, 3> maps;
  for (int a = 0; a < 3; ++a) maps[static_cast<std::size_t>(a)] = good_bad_map(solid, a);
  const Occupancy columns = unresolved_columns(solid, maps[static_cast<std::size_t>(axis)], facing, both_ends);
  for (GoodBadMap& map : maps) {
    mark_unresolved(solid, columns, map);
    mark_lines(solid, map, map.tool, [&](std::size_t w, int y, int z) { return covered.row(y, z)[w]; });
  }
  const auto is_bad = [&](Pixel pixel) { return pixel == Pixel::bad || (!both_ends && pixel == Pixel::segment); };
  std::vector<SplitInterval> intervals;
  for (const GoodBadMap& map : maps) {
    const bool has_bad = std::any_of(map.pixels.begin(), map.pixels.end(), is_bad);
    if (!has_bad) {
      // The only conflict is between signs.
      for (const Pixel sign : {Pixel::positive, Pixel::negative}) {
        const auto conflicts = regions_of(map, [&](std::size_t i) {
          return map.pixels[i] == (sign == Pixel::positive ? Pixel::negative : Pixel::positive);
        });
        for (const Rect& region :
             regions_of(map, [&](std::size_t i) { return map.pixels[i] == sign && map.unresolved[i]; }))
          isolate(map, region, conflicts, SplitInterval::Kind::conflict, intervals);
      }
      continue;
    }
    direct_splits(solid, covered, columns, map, intervals);
    if (map.axis == axis) continue;
    // Surface that is unresolved here need not be isolated if the third direction can represent it.
    const GoodBadMap& third = maps[static_cast<std::size_t>(3 - map.axis - axis)];
    // the cell's own axis lies in the planes of both maps
    const auto shared = static_cast<std::size_t>(axis);
    const auto range_of_bad = [&] {
      std::pair<int, int> range{std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
      const bool along_u = (third.axis + 1) % 3 == static_cast<int>(shared);
      for (int v = third.v0; v < third.v0 + third.height; ++v)
        for (int u = third.u0; u < third.u0 + third.width; ++u) {
          const std::size_t i = third.index(u, v);
          if (!third.unresolved[i] || !is_bad(third.pixels[i])) continue;
          const int at = along_u ? u : v;
          range = {std::min(range.first, at), std::max(range.second, at)};
        }
      return range;
    }();
    const bool along_u = (map.axis + 1) % 3 == axis;
    const auto needed = [&](std::size_t i) {
      if (map.pixels[i] == Pixel::none || is_bad(map.pixels[i]) || !map.unresolved[i] || !map.tool[i]) return false;
      const int u = map.u0 + static_cast<int>(i % static_cast<std::size_t>(map.width));
      const int v = map.v0 + static_cast<int>(i / static_cast<std::size_t>(map.width));
      const int at = along_u ? u : v;
      return range_of_bad.first > range_of_bad.second || (at >= range_of_bad.first && at <= range_of_bad.second);
    };
    const auto bad = regions_of(map, [&](std::size_t i) { return is_bad(map.pixels[i]); });
    for (const Rect& region : regions_of(map, needed))
      isolate(map, region, bad, SplitInterval::Kind::indirect, intervals);
  }
  // A plane at a side of the cell does not divide it.
  const Region& r = solid.region();
  for (SplitInterval& interval : intervals) {
    interval.first = std::max(interval.first, r.first(interval.axis) + 1);
    interval.last = std::min(interval.last, r.last(interval.axis));
  }
  std::erase_if(intervals, [](const SplitInterval& interval) { return interval.first > interval.last; });
  return intervals;
}

}  // namespace fieldfab::cam

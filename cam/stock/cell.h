/// Parts of a multidirectional height map (Hahn 2010, 3, 4.2, 5.1): lattice points with half-open
/// ownership, cells, samples.
///
/// A lattice point is solid or air. A solid point owns the intersections of the surface with the
/// edges to its air neighbours. Every point belongs to one cell of one brick, so that two cells
/// cannot disagree about a point.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "fieldfab/cam/stock/lattice.h"

namespace fieldfab::cam {

/// Axes across an axis, in cyclic order.
constexpr auto axis_u(int axis) { return (axis + 1) % 3; }
constexpr auto axis_v(int axis) { return (axis + 2) % 3; }

/// A point by its coordinates in the frame of an axis.
inline Index3 point_of(int axis, int u, int v, int k) {
  Index3 p{};
  p[static_cast<std::size_t>(axis)] = k;
  p[static_cast<std::size_t>(axis_u(axis))] = u;
  p[static_cast<std::size_t>(axis_v(axis))] = v;
  return p;
}

/// A box of lattice points, both ends included.
struct Region {
  Index3 lower{0, 0, 0}, upper{-1, -1, -1};

  [[nodiscard]] int count(int axis) const {
    return upper[static_cast<std::size_t>(axis)] - lower[static_cast<std::size_t>(axis)] + 1;
  }
  [[nodiscard]] int first(int axis) const { return lower[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] int last(int axis) const { return upper[static_cast<std::size_t>(axis)]; }
  [[nodiscard]] bool contains(const Index3& p) const {
    return p[0] >= lower[0] && p[0] <= upper[0] && p[1] >= lower[1] && p[1] <= upper[1] && p[2] >= lower[2] &&
           p[2] <= upper[2];
  }
  [[nodiscard]] bool meets(const Region& other) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (upper[a] < other.lower[a] || other.upper[a] < lower[a]) return false;
    return true;
  }
};

/// The intersection of two regions; counts of 0 or less if it is empty.
inline Region common(const Region& a, const Region& b) {
  Region r;
  for (std::size_t i = 0; i < 3; ++i)
    r.lower[i] = std::max(a.lower[i], b.lower[i]), r.upper[i] = std::min(a.upper[i], b.upper[i]);
  return r;
}

/// Intersection of the surface with an edge of the lattice: position along the edge, mm from the
/// lattice's corner, and the cut that made it (0: the stock's first surface).
struct Sample {
  float at = 0;
  std::uint32_t cut = 0;
};

/// Hash map of samples by edge: those on a brick's edges, except the ends of its cells' columns. An
/// edge is identified by its lower point and its axis.
class SampleMap {
 public:
  using Key = std::uint32_t;
  /// Key of an edge whose lower point lies at most one step outside of a region. The region has at
  /// most 1021 points along an axis.
  static Key key(const Index3& from, int axis, const Region& region) {
    const auto part = [&](std::size_t a) { return static_cast<Key>(from[a] - region.lower[a] + 1); };
    return static_cast<Key>(axis) | part(0) << 2 | part(1) << 12 | part(2) << 22;
  }
  [[nodiscard]] const Sample* find(Key key) const {
    if (slots_.empty()) return nullptr;
    for (std::size_t i = slot(key);; i = after(i)) {
      if (slots_[i].key == key) return &slots_[i].sample;
      if (slots_[i].key == none) return nullptr;
    }
  }
  /// Stores the sample unless the stored one is lower (keep_upper(): higher).
  void keep_lower(Key key, Sample sample) {
    Sample& kept = place(key, sample);
    if (sample.at < kept.at) kept = sample;
  }
  void keep_upper(Key key, Sample sample) {
    Sample& kept = place(key, sample);
    if (sample.at > kept.at) kept = sample;
  }
  void put(Key key, Sample sample) { place(key, sample) = sample; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] std::size_t bytes() const { return slots_.capacity() * sizeof(Slot); }
  template <class Change>
  void change(const Change& body) {
    for (Slot& slot : slots_)
      if (slot.key != none) body(slot.sample);
  }
  /// Number of slots, including empty ones. for_each() calls `body(key, sample)` for all samples in
  /// an order that gives a map with as many slots the same layout.
  [[nodiscard]] std::size_t slots() const { return slots_.size(); }
  template <class Body>
  void for_each(const Body& body) const {
    std::size_t first = 0;
    while (first < slots_.size() && slots_[first].key != none) ++first;
    for (std::size_t k = 0, i = first; k < slots_.size(); ++k, i = after(i))
      if (slots_[i].key != none) body(slots_[i].key, slots_[i].sample);
  }
  /// Allocates slots of an empty map.
  void make_slots(std::size_t count) { slots_ = std::vector<Slot>(count); }
  /// Removes the samples for whose key `wanted` returns false.
  template <class Wanted>
  void sift(const Wanted& wanted) {
    std::vector<Slot> old;
    old.swap(slots_);
    std::size_t left = 0;
    for (const Slot& slot : old) left += slot.key != none && wanted(slot.key);
    count_ = 0;
    if (!left) return;
    slots_ = std::vector<Slot>(left + left / 4 + 8);
    for (const Slot& slot : old)
      if (slot.key != none && wanted(slot.key)) place(slot.key, slot.sample);
  }

 private:
  static constexpr Key none = std::numeric_limits<Key>::max();
  struct Slot {
    Key key = none;
    Sample sample;
  };
  [[nodiscard]] std::size_t after(std::size_t i) const { return i + 1 < slots_.size() ? i + 1 : 0; }
  /// The hash is a fraction of the number of slots, which need not be a power of two.
  [[nodiscard]] std::size_t slot(Key key) const {
    const auto hash = static_cast<std::uint32_t>((key ^ key >> 15) * 2654435769u);
    return static_cast<std::size_t>(static_cast<std::uint64_t>(hash) * slots_.size() >> 32);
  }
  Sample& place(Key key, Sample sample) {
    if ((count_ + 1) * 6 > slots_.size() * 5) grow();
    for (std::size_t i = slot(key);; i = after(i)) {
      if (slots_[i].key == key) return slots_[i].sample;
      if (slots_[i].key != none) continue;
      ++count_;
      slots_[i] = {key, sample};
      return slots_[i].sample;
    }
  }
  void grow() {
    std::vector<Slot> old(slots_.size() + slots_.size() / 2 + 16);
    old.swap(slots_);
    count_ = 0;
    for (const Slot& slot : old)
      if (slot.key != none) place(slot.key, slot.sample);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

/// Set of the solid points of a region: rows of bits along x.
class Occupancy {
 public:
  using Word = std::uint64_t;

  explicit Occupancy(const Region& region)
      : region_(region),
        words_(static_cast<std::size_t>((region.count(0) + 63) / 64)),
        bits_(words_ * static_cast<std::size_t>(region.count(1)) * static_cast<std::size_t>(region.count(2))) {}

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] std::size_t words() const { return words_; }
  Word* row(int y, int z) { return &bits_[offset(y, z)]; }
  [[nodiscard]] const Word* row(int y, int z) const { return &bits_[offset(y, z)]; }
  [[nodiscard]] bool at(const Index3& p) const {
    const auto x = static_cast<std::size_t>(p[0] - region_.lower[0]);
    return row(p[1], p[2])[x / 64] >> (x % 64) & 1;
  }
  void set(const Index3& p) {
    const auto x = static_cast<std::size_t>(p[0] - region_.lower[0]);
    row(p[1], p[2])[x / 64] |= Word{1} << (x % 64);
  }
  /// Sets the points of a row from x0 to x1 inclusive.
  void set_row(int x0, int x1, int y, int z) {
    Word* bits = row(y, z);
    const auto from = static_cast<std::size_t>(x0 - region_.lower[0]),
               to = static_cast<std::size_t>(x1 - region_.lower[0]);
    for (std::size_t w = from / 64; w <= to / 64; ++w) {
      Word mask = ~Word{0};
      if (w == from / 64) mask &= ~Word{0} << (from % 64);
      if (w == to / 64) mask &= ~Word{0} >> (63 - to % 64);
      bits[w] |= mask;
    }
  }
  /// Removes the points of another set with the same region.
  void subtract(const Occupancy& other) {
    for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] &= ~other.bits_[i];
  }
  /// Sets runs of points along an axis in a part of the region. `run(u, v)` returns the first and
  /// the last point of a line's run, which is clipped to the part. The run is empty if the last
  /// point precedes the first.
  template <class Run>
  void set_runs(const Region& part, int axis, const Run& run);
  /// Mask of the bits of a row's word that lie in the region.
  [[nodiscard]] Word valid(std::size_t word) const {
    const auto left = static_cast<std::size_t>(region_.count(0)) - word * 64;
    return left >= 64 ? ~Word{0} : (Word{1} << left) - 1;
  }
  void fill() {
    for (std::size_t i = 0; i < bits_.size(); ++i) bits_[i] = valid(i % words_);
  }
  [[nodiscard]] bool none() const {
    return std::all_of(bits_.begin(), bits_.end(), [](Word w) { return w == 0; });
  }
  [[nodiscard]] bool all() const {
    for (std::size_t i = 0; i < bits_.size(); ++i)
      if (bits_[i] != valid(i % words_)) return false;
    return true;
  }
  /// First and last solid point of each line along an axis, u fastest. The last precedes the first
  /// for an empty line.
  [[nodiscard]] std::vector<std::pair<int, int>> runs(int axis) const;
  /// The same set restricted to a smaller region.
  [[nodiscard]] Occupancy part(const Region& region) const;

 private:
  [[nodiscard]] std::size_t offset(int y, int z) const {
    return (static_cast<std::size_t>(z - region_.lower[2]) * static_cast<std::size_t>(region_.count(1)) +
            static_cast<std::size_t>(y - region_.lower[1])) *
           words_;
  }
  Region region_;
  std::size_t words_;
  std::vector<Word> bits_;
};

template <class Run>
void Occupancy::set_runs(const Region& part, int axis, const Run& run) {
  const int ua = (axis + 1) % 3, va = (axis + 2) % 3;
  const auto cut = [&](int u, int v) {
    auto [first, last] = run(u, v);
    return std::pair{std::max(first, part.first(axis)), std::min(last, part.last(axis))};
  };
  if (axis == 0) {
    for (int v = part.first(va); v <= part.last(va); ++v)
      for (int u = part.first(ua); u <= part.last(ua); ++u)
        if (const auto [first, last] = cut(u, v); first <= last) set_row(first, last, u, v);
    return;
  }
  // 64 lines at a time: the bit changes at the start of a run and after its end.
  const int across = 3 - axis, count = part.count(axis);
  std::vector<Word> changes(static_cast<std::size_t>(count) + 1);
  for (int other = part.first(across); other <= part.last(across); ++other)
    for (std::size_t w = 0; w < words_; ++w) {
      const int from = std::max(part.lower[0], region_.lower[0] + static_cast<int>(w) * 64);
      const int to = std::min(part.upper[0], region_.lower[0] + static_cast<int>(w) * 64 + 63);
      if (from > to) continue;
      std::fill(changes.begin(), changes.end(), Word{0});
      for (int x = from; x <= to; ++x) {
        const auto [first, last] = axis == 2 ? cut(x, other) : cut(other, x);
        if (first > last) continue;
        const Word bit = Word{1} << ((x - region_.lower[0]) % 64);
        changes[static_cast<std::size_t>(first - part.first(axis))] ^= bit;
        changes[static_cast<std::size_t>(last + 1 - part.first(axis))] ^= bit;
      }
      Word state = 0;
      for (int k = 0; k < count; ++k) {
        state ^= changes[static_cast<std::size_t>(k)];
        const int at = part.first(axis) + k;
        if (state) (axis == 2 ? row(other, at) : row(at, other))[w] |= state;
      }
    }
}

/// A box of lattice points whose solid points are contiguous on each line along its axis: a 3-way
/// height map. Its columns store both ends of these runs. All other samples are in the brick's
/// SampleMap.
struct Cell {
  enum class Content : std::uint8_t { solid, empty, columns, split };
  Region region;
  Content content = Content::solid;
  std::int8_t axis = 2;    ///< of the columns, or normal to the plane of a split cell
  std::int8_t facing = 0;  ///< 1: only upper ends vary, -1: only lower ends, 0: both may
  int plane = 0;           ///< of a split cell: the upper child's first point along the axis
  int children = 0;        ///< index of the lower child; the upper child follows it
  /// Upper and lower end of each column, u fastest. `lower` is empty if all columns begin below the
  /// cell.
  struct Ends {
    std::vector<float> at;
    std::vector<std::uint32_t> cut;
    [[nodiscard]] bool empty() const { return at.empty(); }
    [[nodiscard]] Sample operator[](std::size_t i) const { return {at[i], cut[i]}; }
    void put(std::size_t i, Sample sample) { at[i] = sample.at, cut[i] = sample.cut; }
    void assign(std::size_t count, float value) { at.assign(count, value), cut.assign(count, 0); }
    void clear() { at.clear(), cut.clear(); }
    [[nodiscard]] std::size_t bytes() const {
      return at.capacity() * sizeof(float) + cut.capacity() * sizeof(std::uint32_t);
    }
  };
  Ends upper, lower;

  [[nodiscard]] std::size_t column(int u, int v) const {
    const int ua = (axis + 1) % 3, va = (axis + 2) % 3;
    return static_cast<std::size_t>(v - region.first(va)) * static_cast<std::size_t>(region.count(ua)) +
           static_cast<std::size_t>(u - region.first(ua));
  }
};

/// End of a column that is solid beyond its cell; -beyond for a column without solid points.
constexpr float beyond = std::numeric_limits<float>::infinity();

/// Points of a column, along the cell's axis; none if `first` is above `last`.
struct ColumnPoints {
  int first, last;
};
/// The solid points of a column.
inline ColumnPoints solid_points(const Cell& cell, std::size_t column, const StockLattice& lattice) {
  ColumnPoints points{cell.region.first(cell.axis), cell.region.last(cell.axis)};
  if (cell.content != Cell::Content::columns) return points;
  const float upper = cell.upper.at[column];
  if (upper != beyond)
    points.last = upper == -beyond ? points.first - 1 : std::min(points.last, lattice.below(cell.axis, upper));
  if (!cell.lower.empty() && cell.lower.at[column] != -beyond)
    points.first = std::max(points.first, lattice.above(cell.axis, cell.lower.at[column]));
  return points;
}

}  // namespace fieldfab::cam

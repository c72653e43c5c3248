// Cells of a brick: their bounds, division and samples.
#include "brick.h"

#include <cmath>

#include "good_bad.h"

namespace fieldfab::cam {

Brick::Brick(const Region& region, bool solid) : region_(region) {
  Cell cell;
  cell.region = region;
  cell.content = solid ? Cell::Content::solid : Cell::Content::empty;
  nodes_.push_back(std::move(cell));
}

/// A box that contains all solid points (Hahn 5.3).
Region Brick::solid_bounds(const StockLattice& lattice) const {
  Region bounds{region_.upper, region_.lower};
  const auto add = [&](const Region& r) {
    for (std::size_t a = 0; a < 3; ++a)
      bounds.lower[a] = std::min(bounds.lower[a], r.lower[a]), bounds.upper[a] = std::max(bounds.upper[a], r.upper[a]);
  };
  for (const Cell& cell : nodes_) {
    if (cell.content == Cell::Content::solid) add(cell.region);
    if (cell.content != Cell::Content::columns) continue;
    const auto a = static_cast<std::size_t>(cell.axis), ua = (a + 1) % 3, va = (a + 2) % 3;
    Region r{cell.region.upper, cell.region.lower};
    float lowest = beyond, highest = -beyond;
    std::size_t column = 0;
    for (int v = cell.region.lower[va]; v <= cell.region.upper[va]; ++v)
      for (int u = cell.region.lower[ua]; u <= cell.region.upper[ua]; ++u, ++column) {
        if (cell.upper.at[column] == -beyond) continue;
        r.lower[ua] = std::min(r.lower[ua], u), r.upper[ua] = std::max(r.upper[ua], u);
        r.lower[va] = std::min(r.lower[va], v), r.upper[va] = std::max(r.upper[va], v);
        highest = std::max(highest, cell.upper.at[column]);
        lowest = std::min(lowest, cell.lower.empty() ? -beyond : cell.lower.at[column]);
      }
    if (highest == -beyond) continue;
    r.lower[a] =
        lowest == -beyond ? cell.region.lower[a] : std::max(cell.region.lower[a], lattice.above(cell.axis, lowest));
    r.upper[a] =
        highest == beyond ? cell.region.upper[a] : std::min(cell.region.upper[a], lattice.below(cell.axis, highest));
    add(r);
  }
  return bounds;
}

/// Sets the bits of a cell's solid points within the shape's region.
void Brick::occupy(const Cell& cell, Occupancy& shape, const StockLattice& lattice) const {
  if (cell.content == Cell::Content::empty || cell.content == Cell::Content::split) return;
  const Region r = common(cell.region, shape.region());
  if (r.count(0) <= 0 || r.count(1) <= 0 || r.count(2) <= 0) return;
  if (cell.content == Cell::Content::solid) {
    for (int z = r.lower[2]; z <= r.upper[2]; ++z)
      for (int y = r.lower[1]; y <= r.upper[1]; ++y) shape.set_row(r.lower[0], r.upper[0], y, z);
    return;
  }
  shape.set_runs(r, cell.axis, [&](int u, int v) {
    const ColumnPoints points = solid_points(cell, cell.column(u, v), lattice);
    return std::pair{points.first, points.last};
  });
}

void Brick::occupy(Occupancy& shape, const StockLattice& lattice) const {
  for (const Cell& cell : nodes_) occupy(cell, shape, lattice);
}

/// Builds cells for a region with known solid points, all samples of which are in the map.
void Brick::rebuild(int node, const Occupancy& solid, const Occupancy& covered, int axis, std::int8_t facing,
                    const Stroke& stroke, const Stock& stock) {
  const Region r = solid.region();
  Cell& cell = nodes_[static_cast<std::size_t>(node)];
  if (solid.none() || solid.all()) {
    cell.content = solid.none() ? Cell::Content::empty : Cell::Content::solid;
    return;
  }
  // Prefers the cell's own direction, then the one nearest to the tool's.
  const StockSettings& settings = stock.settings();
  std::array<int, 3> axes{axis, (axis + 1) % 3, (axis + 2) % 3};
  if (std::abs(stroke.to.axis[axes[2]]) > std::abs(stroke.to.axis[axes[1]])) std::swap(axes[1], axes[2]);
  for (const int a : axes) {
    std::int8_t faces = 0;
    if (!functional(good_bad_map(solid, a), settings.both_ends, faces)) continue;
    make_columns(cell, a, faces, solid, stock.lattice());
    return;
  }
  const std::vector<SplitInterval> intervals = split_intervals(solid, covered, axis, facing, settings.both_ends);
  SplitChoice choice;
  if (intervals.empty()) {
    int longest = 0;
    for (int a = 1; a < 3; ++a)
      if (r.count(a) > r.count(longest)) longest = a;
    choice = {longest, r.first(longest) + r.count(longest) / 2, SplitInterval::Kind::direct};
    ++tally_.halved;
  } else {
    double radius = 0;
    if (stroke.piece)
      for (const Zone& zone : stroke.piece->zones) radius = std::max({radius, zone.r0, zone.r1});
    choice = choose_split(intervals, r, stock.lattice().spacing(), settings.rules, stroke.to.axis, radius, random_);
    ++(choice.kind == SplitInterval::Kind::direct     ? tally_.direct
       : choice.kind == SplitInterval::Kind::indirect ? tally_.indirect
                                                      : tally_.conflict);
  }
  cell.content = Cell::Content::split;
  cell.axis = static_cast<std::int8_t>(choice.axis);
  cell.plane = choice.plane;
  const int children = cell.children = static_cast<int>(nodes_.size());
  std::array<Region, 2> parts{r, r};
  parts[0].upper[static_cast<std::size_t>(choice.axis)] = choice.plane - 1;
  parts[1].lower[static_cast<std::size_t>(choice.axis)] = choice.plane;
  nodes_.resize(nodes_.size() + 2);  // the reference `cell` is now invalid
  for (int i = 0; i < 2; ++i)
    nodes_[static_cast<std::size_t>(children + i)].region = parts[static_cast<std::size_t>(i)];
  for (int i = 0; i < 2; ++i) {
    const Region& part = parts[static_cast<std::size_t>(i)];
    rebuild(children + i, solid.part(part), covered.part(part), axis, facing, stroke, stock);
  }
}

void Brick::make_columns(Cell& cell, int axis, std::int8_t facing, const Occupancy& solid,
                         const StockLattice& lattice) const {
  const Region& r = cell.region;
  const int ua = axis_u(axis), va = axis_v(axis);
  cell.content = Cell::Content::columns;
  cell.axis = static_cast<std::int8_t>(axis);
  cell.facing = facing;
  const std::size_t count = static_cast<std::size_t>(r.count(ua)) * static_cast<std::size_t>(r.count(va));
  cell.upper.assign(count, beyond);
  cell.lower.clear();
  const std::vector<std::pair<int, int>> runs = solid.runs(axis);
  for (int v = r.first(va); v <= r.last(va); ++v)
    for (int u = r.first(ua); u <= r.last(ua); ++u) {
      const std::size_t column = cell.column(u, v);
      const auto [first, last] = runs[column];
      if (first > last) {
        cell.upper.at[column] = -beyond;
        continue;
      }
      if (last < r.last(axis)) {
        const Sample* kept = samples_.find(SampleMap::key(point_of(axis, u, v, last), axis, region_));
        cell.upper.put(column, kept ? *kept : Sample{lattice.at(axis, last + 1), 0});
        // The end must lie above its point, despite rounding.
        if (cell.upper.at[column] <= lattice.at(axis, last))
          cell.upper.at[column] = std::nextafter(lattice.at(axis, last), beyond);
      }
      if (first > r.first(axis)) {
        if (cell.lower.empty()) cell.lower.assign(count, -beyond);
        const Sample* kept = samples_.find(SampleMap::key(point_of(axis, u, v, first - 1), axis, region_));
        cell.lower.put(column, kept ? *kept : Sample{lattice.at(axis, first - 1), 0});
        if (cell.lower.at[column] >= lattice.at(axis, first))
          cell.lower.at[column] = std::nextafter(lattice.at(axis, first), -beyond);
      }
    }
}

/// Removes samples that columns store, and those of points that are no longer solid.
void Brick::tidy(const StockLattice& lattice) {
  Occupancy shape(region_);
  occupy(shape, lattice);
  const bool divided = nodes_.size() > 1;
  samples_.sift([&](SampleMap::Key key) {
    const int axis = static_cast<int>(key & 3);
    Index3 p, q;
    for (std::size_t a = 0; a < 3; ++a)
      p[a] = q[a] = region_.lower[a] - 1 + static_cast<int>(key >> (2 + 10 * a) & 1023);
    ++q[static_cast<std::size_t>(axis)];
    const bool p_here = region_.contains(p), q_here = region_.contains(q);
    if ((p_here && shape.at(p)) == (q_here && shape.at(q))) return false;
    if (!p_here || !q_here) return true;
    const Cell& one = leaf(p);
    return !(one.content == Cell::Content::columns && one.axis == axis && (!divided || &one == &leaf(q)));
  });
  tidied_ = samples_.size();
}

void Brick::assign(const Occupancy& solid, SampleMap samples, const Stock& stock) {
  nodes_.assign(1, Cell{});
  nodes_[0].region = region_;
  samples_ = std::move(samples);
  rebuild(0, solid, Occupancy(region_), 2, 0, Stroke{}, stock);
  tally_ = {};
  tidy(stock.lattice());
}

void Brick::forget_cuts() {
  samples_.change([](Sample& sample) { sample.cut = 0; });
  for (Cell& cell : nodes_)
    for (Cell::Ends* const ends : {&cell.upper, &cell.lower}) std::fill(ends->cut.begin(), ends->cut.end(), 0);
}

const Cell& Brick::leaf(const Index3& point) const {
  const Cell* cell = &nodes_[0];
  while (cell->content == Cell::Content::split)
    cell = &nodes_[static_cast<std::size_t>(cell->children +
                                            (point[static_cast<std::size_t>(cell->axis)] >= cell->plane ? 1 : 0))];
  return *cell;
}

bool Brick::solid(const Index3& point, const StockLattice& lattice) const {
  const Cell& cell = leaf(point);
  if (cell.content != Cell::Content::columns) return cell.content == Cell::Content::solid;
  const std::size_t column = cell.column(point[static_cast<std::size_t>(axis_u(cell.axis))],
                                         point[static_cast<std::size_t>(axis_v(cell.axis))]);
  const float at = lattice.at(cell.axis, point[static_cast<std::size_t>(cell.axis)]);
  return at < cell.upper.at[column] && (cell.lower.empty() || at > cell.lower.at[column]);
}

Sample Brick::sample(const Index3& point, int axis, bool upwards, const StockLattice& lattice) const {
  const auto a = static_cast<std::size_t>(axis);
  Index3 from = point;
  if (!upwards) --from[a];
  const float near = lattice.at(axis, point[a]), far = lattice.at(axis, point[a] + (upwards ? 1 : -1));
  Sample found{far, 0};
  const auto nearer = [&](const Sample& sample) {
    if (upwards ? sample.at < found.at || (sample.at == found.at && !found.cut)
                : sample.at > found.at || (sample.at == found.at && !found.cut))
      found = sample;
  };
  if (const Sample* kept = samples_.find(SampleMap::key(from, axis, region_))) nearer(*kept);
  const Cell& cell = leaf(point);
  if (cell.content == Cell::Content::columns && cell.axis == axis) {
    const std::size_t column =
        cell.column(point[static_cast<std::size_t>(axis_u(axis))], point[static_cast<std::size_t>(axis_v(axis))]);
    if (upwards) nearer(cell.upper[column]);
    if (!upwards && !cell.lower.empty()) nearer(cell.lower[column]);
  }
  found.at = upwards ? std::max(found.at, near) : std::min(found.at, near);
  return found;
}

double Brick::volume(const StockLattice& lattice) const {
  double volume = 0;
  for (const Cell& cell : nodes_) {
    if (cell.content == Cell::Content::split || cell.content == Cell::Content::empty) continue;
    const int axis = cell.axis, ua = axis_u(axis), va = axis_v(axis);
    const Region& r = cell.region;
    const double half = 0.5 * lattice.spacing()[axis];
    const double low = lattice.at(axis, r.first(axis)) - (r.first(axis) > 0 ? half : 0);
    const double high =
        lattice.at(axis, r.last(axis)) + (r.last(axis) < lattice.cells()[static_cast<std::size_t>(axis)] ? half : 0);
    for (int v = r.first(va); v <= r.last(va); ++v)
      for (int u = r.first(ua); u <= r.last(ua); ++u) {
        double from = low, to = high;
        if (cell.content == Cell::Content::columns) {
          const std::size_t column = cell.column(u, v);
          to = std::min(to, static_cast<double>(cell.upper.at[column]));
          if (!cell.lower.empty()) from = std::max(from, static_cast<double>(cell.lower.at[column]));
        }
        const double share = (u == 0 || u == lattice.cells()[static_cast<std::size_t>(ua)] ? 0.5 : 1) *
                             (v == 0 || v == lattice.cells()[static_cast<std::size_t>(va)] ? 0.5 : 1);
        if (to > from) volume += share * (to - from) * lattice.spacing()[ua] * lattice.spacing()[va];
      }
  }
  return volume;
}

void Brick::count(StockStatistics& statistics) const {
  statistics.direct += tally_.direct, statistics.indirect += tally_.indirect;
  statistics.conflict += tally_.conflict, statistics.halved += tally_.halved;
  statistics.bytes += sizeof(Brick) + samples_.bytes() + nodes_.capacity() * sizeof(Cell);
  statistics.embedded_samples += samples_.size();
  for (const Cell& cell : nodes_) {
    if (cell.content == Cell::Content::split)
      ++statistics.splits;
    else
      ++statistics.cells;
    statistics.bytes += cell.upper.bytes() + cell.lower.bytes();
    for (const auto* ends : {&cell.upper, &cell.lower})
      statistics.column_samples += static_cast<std::uint64_t>(
          std::count_if(ends->at.begin(), ends->at.end(), [](float at) { return std::isfinite(at); }));
  }
}

}  // namespace fieldfab::cam

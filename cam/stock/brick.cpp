#include "brick.h"

#include <cmath>

#include "good_bad.h"
#include "rows.h"

namespace fieldfab::cam {
namespace {

constexpr auto axis_u(int axis) { return (axis + 1) % 3; }
constexpr auto axis_v(int axis) { return (axis + 2) % 3; }

Index3 point_of(int axis, int u, int v, int k) {
  Index3 p{};
  p[static_cast<std::size_t>(axis)] = k;
  p[static_cast<std::size_t>(axis_u(axis))] = u;
  p[static_cast<std::size_t>(axis_v(axis))] = v;
  return p;
}

/// Index of the first point at or above a coordinate, and of the last point at or below it.
int from(const StockLattice& lattice, int axis, float coordinate) { return lattice.below(axis, coordinate) + 1; }
int up_to(const StockLattice& lattice, int axis, float coordinate) { return lattice.above(axis, coordinate) - 1; }

/// Where the surface crosses the edge of the lattice from a point q that a stroke removes to its neighbour p, which
/// stays, mm from the lattice's corner: at the end of the stroke's interval on that line. `after`: p follows q along
/// axis d.
float crossing_between(const Index3& p, const Index3& q, int d, bool after, const Window& across,
                       const StockLattice& lattice) {
  const int u = q[static_cast<std::size_t>(axis_u(d))], v = q[static_cast<std::size_t>(axis_v(d))];
  const float place = lattice.at(d, q[static_cast<std::size_t>(d)]),
              other = lattice.at(d, p[static_cast<std::size_t>(d)]);
  if (!across.has(u, v)) return place;
  const std::size_t line = across.index(u, v);
  if (!(across.entry[line] <= across.exit[line])) return place;
  return after ? std::clamp(across.exit[line], place, other) : std::clamp(across.entry[line], other, place);
}

}  // namespace

bool WindowSet::start(const Sweep& sweep, const Region& region) {
  sweep_ = &sweep;
  filled_.fill(false);
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    const double spacing = lattice_->spacing()[axis];
    const double low = std::clamp(sweep.bounds().lower[axis] / spacing, -1e6, 1e8),
                 high = std::clamp(sweep.bounds().upper[axis] / spacing, -1e6, 1e8);
    reach_.lower[a] = std::max({static_cast<int>(std::ceil(low - 1e-6)), region.lower[a] - 1, 0});
    reach_.upper[a] = std::min({static_cast<int>(std::floor(high + 1e-6)), region.upper[a] + 1, lattice_->cells()[a]});
    if (reach_.lower[a] > reach_.upper[a]) return false;
  }
  return true;
}

const Window& WindowSet::along(int axis) {
  Window& window = windows_[static_cast<std::size_t>(axis)];
  if (filled_[static_cast<std::size_t>(axis)]) return window;
  filled_[static_cast<std::size_t>(axis)] = true;
  window.axis = axis;
  window.u0 = reach_.first(axis_u(axis)), window.u1 = reach_.last(axis_u(axis));
  window.v0 = reach_.first(axis_v(axis)), window.v1 = reach_.last(axis_v(axis));
  window.clear();
  sweep_->fill(window, *lattice_);
  return window;
}

Brick::Brick(const Region& region, bool solid) : region_(region) {
  Cell cell;
  cell.region = region;
  cell.content = solid ? Cell::Content::solid : Cell::Content::empty;
  nodes_.push_back(std::move(cell));
}

struct Brick::Batch {
  static constexpr std::size_t most = 16;
  std::span<Pass> passes;
  std::vector<WindowSet> windows;
  std::array<bool, most> here{};
};

// Passes are processed in batches. First they cut the columns, one pass after the other. Then the
// samples across the columns are updated only for points that all passes of the batch have left
// solid.
void Brick::cut(std::span<Pass> passes, const Stock& stock) {
  const StockLattice& lattice = stock.lattice();
  thread_local Batch batch;
  batch.windows.assign(Batch::most, WindowSet(lattice));
  const Region solid = solid_bounds(lattice);
  for (std::size_t begin = 0; begin < passes.size() && !empty(); begin += Batch::most) {
    batch.passes = passes.subspan(begin, std::min(Batch::most, passes.size() - begin));
    for (std::size_t i = 0; i < batch.passes.size(); ++i) {
      batch.here[i] = batch.windows[i].start(*batch.passes[i].sweep, solid);
      if (batch.here[i]) cut_columns(0, batch, i, stock);
    }
    for (std::size_t i = 0; i < batch.passes.size(); ++i)
      if (batch.here[i] && batch.passes[i].stroke->removes) cut_edges(0, batch, i, lattice);
  }
  if (samples_.size() > 2 * tidied_ + 512) tidy(lattice);
}

namespace {

/// Whether the reached points meet a cell or are adjacent to it.
bool come_near(const Region& cell, const Region& reach) {
  for (std::size_t a = 0; a < 3; ++a)
    if (cell.upper[a] + 1 < reach.lower[a] || reach.upper[a] < cell.lower[a] - 1) return false;
  return true;
}

/// Whether the reached points meet, or are adjacent to, the lower and the upper child of a split
/// cell.
std::pair<bool, bool> sides_met(const Cell& split, const Region& reach) {
  return {reach.first(split.axis) <= split.plane, reach.last(split.axis) >= split.plane - 1};
}

}  // namespace

void Brick::cut_columns(int node, Batch& batch, std::size_t pass, const Stock& stock) {
  Cell& cell = nodes_[static_cast<std::size_t>(node)];
  WindowSet& windows = batch.windows[pass];
  const Stroke& stroke = *batch.passes[pass].stroke;
  if (cell.content == Cell::Content::empty || !come_near(cell.region, windows.reach())) return;
  if (cell.content == Cell::Content::split) {
    const int children = cell.children;
    const auto [lower, upper] = sides_met(cell, windows.reach());
    if (lower) cut_columns(children, batch, pass, stock);
    if (upper) cut_columns(children + 1, batch, pass, stock);
    return;
  }
  if (cell.content == Cell::Content::solid) {
    // A solid cell has no direction of columns yet: the axis nearest to the tool's is the most
    // likely one.
    int axis = 2;
    stroke.to.axis.cwiseAbs().maxCoeff(&axis);
    cell.axis = static_cast<std::int8_t>(axis);
    cell.facing = 0;
  }
  thread_local std::vector<Change> changes;
  changes.clear();
  const StockLattice& lattice = stock.lattice();
  bool fits = plan_columns(cell, windows.along(cell.axis), stroke, lattice, changes, batch.passes[pass].result);
  if (!stroke.removes) return;
  if (fits && !stock.settings().both_ends)
    for (const Change& change : changes) {
      const bool up = std::isfinite(change.upper.at), down = change.lower.at != -beyond;
      if (up && cell.facing >= 0 && !down)
        cell.facing = 1;
      else if (down && cell.facing <= 0 && !up)
        cell.facing = -1;
      else if (up || down)
        fits = false;
    }
  if (fits) return commit(cell, changes);
  // All samples must be in the map before the cell is rebuilt.
  for (std::size_t i = 0; i <= pass; ++i)
    if (batch.here[i] && batch.passes[i].stroke->removes) cut_edges(node, batch, i, lattice);
  divide(node, stroke, stock, windows);
}

void Brick::cut_edges(int node, Batch& batch, std::size_t pass, const StockLattice& lattice) {
  const Cell& cell = nodes_[static_cast<std::size_t>(node)];
  if (cell.content == Cell::Content::empty || !come_near(cell.region, batch.windows[pass].reach())) return;
  if (cell.content == Cell::Content::split) {
    const auto [lower, upper] = sides_met(cell, batch.windows[pass].reach());
    if (lower) cut_edges(cell.children, batch, pass, lattice);
    if (upper) cut_edges(cell.children + 1, batch, pass, lattice);
    return;
  }
  cut_edges(cell, *batch.passes[pass].stroke, lattice, batch.windows[pass]);
}

Brick::Points Brick::solid_points(const Cell& cell, std::size_t column, const StockLattice& lattice) {
  Points points{cell.region.first(cell.axis), cell.region.last(cell.axis)};
  if (cell.content != Cell::Content::columns) return points;
  const float upper = cell.upper.at[column];
  if (upper != beyond)
    points.last = upper == -beyond ? points.first - 1 : std::min(points.last, lattice.below(cell.axis, upper));
  if (!cell.lower.empty() && cell.lower.at[column] != -beyond)
    points.first = std::max(points.first, lattice.above(cell.axis, cell.lower.at[column]));
  return points;
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

/// Computes the changes of a cell's columns by a stroke. Returns false if a column would be divided
/// in two.
bool Brick::plan_columns(const Cell& cell, const Window& window, const Stroke& stroke, const StockLattice& lattice,
                         std::vector<Change>& changes, StrokeResult& result) const {
  const int axis = cell.axis, ua = axis_u(axis), va = axis_v(axis);
  const Region& r = cell.region;
  const int low = r.first(axis), high = r.last(axis), cells_u = lattice.cells()[static_cast<std::size_t>(ua)],
            cells_v = lattice.cells()[static_cast<std::size_t>(va)],
            cells_a = lattice.cells()[static_cast<std::size_t>(axis)];
  const double half = 0.5 * lattice.spacing()[axis];
  // The part of the axis that the cell's points represent.
  const double from_mm = lattice.at(axis, low) - (low > 0 ? half : 0),
               to_mm = lattice.at(axis, high) + (high < cells_a ? half : 0);
  bool representable = true;
  const bool columns = cell.content == Cell::Content::columns;
  const int first_u = std::max(window.u0, r.first(ua)), count_u = std::min(window.u1, r.last(ua)) - first_u + 1;
  if (count_u <= 0) return true;
  thread_local std::vector<std::uint8_t> flags;
  flags.resize(static_cast<std::size_t>(count_u) + 8);
  for (int v = std::max(window.v0, r.first(va)); v <= std::min(window.v1, r.last(va)); ++v) {
    const std::size_t row = window.index(first_u, v);
    const float* const tops = columns ? &cell.upper.at[cell.column(first_u, v)] : nullptr;
    if (!flag_contacts(&window.entry[row], &window.exit[row], tops, count_u, flags.data())) continue;
    for_each_flag(flags.data(), count_u, [&](int i) {
      const int u = first_u + i;
      const std::size_t at = row + static_cast<std::size_t>(i);
      const float a = window.entry[at], b = window.exit[at];
      const std::size_t column = cell.column(u, v);
      const Sample upper = columns ? cell.upper[column] : Sample{beyond, 0};
      const Sample lower = columns && !cell.lower.empty() ? cell.lower[column] : Sample{-beyond, 0};
      if (a >= upper.at || b <= lower.at) return;
      const int k0 = from(lattice, axis, a), k1 = up_to(lattice, axis, b);
      if (k0 > k1 || k0 > high + 1 || k1 < low - 1) return;
      const Points points = columns ? solid_points(cell, column, lattice) : Points{low, high};
      if (points.first > points.last) return;
      const bool below = points.first<k0, above = points.last> k1;
      const double length = std::min({static_cast<double>(b), static_cast<double>(upper.at), to_mm}) -
                            std::max({static_cast<double>(a), static_cast<double>(lower.at), from_mm});
      if (length > 0) {
        const double share = (u == 0 || u == cells_u ? 0.5 : 1) * (v == 0 || v == cells_v ? 0.5 : 1);
        result.volume += share * length * lattice.spacing()[ua] * lattice.spacing()[va];
      }
      const int met = std::min(points.last, k1) - std::max(points.first, k0) + 1;
      if (met > 0) {
        result.points += static_cast<std::uint64_t>(met);
        const Index3 p = point_of(axis, u, v, std::max(points.first, k0));
        for (int d = 0; d < 3; ++d) result.place[d] = lattice.at(d, p[static_cast<std::size_t>(d)]);
      }
      if (below && above) {
        representable = false;
      } else if (below) {
        changes.push_back({column, lower, {std::min(a, upper.at), stroke.cut}});
      } else if (above) {
        changes.push_back({column, {std::max(b, lower.at), stroke.cut}, upper});
      } else {
        changes.push_back({column, {-beyond, 0}, {-beyond, 0}});
      }
    });
  }
  return representable;
}

/// Updates the samples across the columns: those of solid points with a neighbour that the tool has
/// removed.
void Brick::cut_edges(const Cell& cell, const Stroke& stroke, const StockLattice& lattice, WindowSet& windows) {
  const int axis = cell.axis, ua = axis_u(axis), va = axis_v(axis);
  const Region& r = cell.region;
  const Window& window = windows.along(axis);
  const bool columns = cell.content == Cell::Content::columns;
  const float cell_low = lattice.at(axis, r.first(axis)), cell_high = lattice.at(axis, r.last(axis));
  const int first_u = std::max(window.u0, r.first(ua) - 1), count_u = std::min(window.u1, r.last(ua) + 1) - first_u + 1;
  const int first_v = std::max(window.v0, r.first(va) - 1), last_v = std::min(window.v1, r.last(va) + 1);
  if (count_u <= 0 || first_v > last_v) return;
  // Tops of the columns of three consecutive rows, with one more column at both ends; -beyond
  // outside of the cell.
  thread_local std::vector<float> tops;
  thread_local std::vector<std::uint8_t> flags;
  const auto stride = static_cast<std::size_t>(count_u) + 2;
  tops.assign(3 * stride, -beyond);
  const auto inverse = static_cast<float>(1 / lattice.spacing()[axis]);
  flags.resize(static_cast<std::size_t>(count_u) + 8);
  const auto load = [&](int v) {
    float* const row = &tops[static_cast<std::size_t>((v + 3) % 3) * stride];
    std::fill(row, row + stride, -beyond);
    if (v < r.first(va) || v > r.last(va)) return;
    const int from_u = std::max(first_u - 1, r.first(ua)), to_u = std::min(first_u + count_u, r.last(ua));
    if (from_u <= to_u)
      load_tops(columns ? &cell.upper.at[cell.column(from_u, v)] : nullptr, to_u - from_u + 1, lattice.spacing()[axis],
                static_cast<float>(r.last(axis)), row + (from_u - first_u + 1));
  };
  load(first_v - 1), load(first_v);
  for (int v = first_v; v <= last_v; ++v) {
    load(v + 1);
    const std::size_t row = window.index(first_u, v);
    const float* const around[3] = {&tops[static_cast<std::size_t>((v + 2) % 3) * stride],
                                    &tops[static_cast<std::size_t>((v + 3) % 3) * stride],
                                    &tops[static_cast<std::size_t>((v + 4) % 3) * stride]};
    if (!flag_neighbours(&window.entry[row], &window.exit[row], around[0] + 1, around[1] + 1, around[2] + 1, count_u,
                         inverse, flags.data()))
      continue;
    for_each_flag(flags.data(), count_u, [&](int i) {
      const int u = first_u + i;
      const std::size_t at = row + static_cast<std::size_t>(i);
      const float a = window.entry[at], b = window.exit[at];
      if (a > cell_high || b < cell_low) return;
      int k0 = 0, k1 = -1;
      for (int side = 0; side < 4; ++side) {
        const bool along_u = side < 2, after = side % 2;  // the neighbour follows the column
        const int pu = u + (along_u ? (after ? 1 : -1) : 0), pv = v + (along_u ? 0 : (after ? 1 : -1));
        if (pu < r.first(ua) || pu > r.last(ua) || pv < r.first(va) || pv > r.last(va)) continue;
        const std::size_t column = cell.column(pu, pv);
        if (columns && (cell.upper.at[column] <= a || (!cell.lower.empty() && cell.lower.at[column] >= b))) continue;
        float covered_from = beyond, covered_to = -beyond;
        if (window.has(pu, pv)) {
          const std::size_t other = window.index(pu, pv);
          covered_from = window.entry[other], covered_to = window.exit[other];
          if (covered_from <= a && covered_to >= b) continue;
        }
        if (k0 > k1) {
          k0 = std::max(from(lattice, axis, a), r.first(axis)), k1 = std::min(up_to(lattice, axis, b), r.last(axis));
          if (k0 > k1) break;
        }
        const Points points = solid_points(cell, column, lattice);
        for (int k = std::max(k0, points.first); k <= std::min(k1, points.last); ++k) {
          const float level = lattice.at(axis, k);
          if (level >= covered_from && level <= covered_to) {
            k = std::min(k1, up_to(lattice, axis, covered_to));  // skip covered points
            continue;
          }
          const int d = along_u ? ua : va;
          const Window& across = windows.along(d);
          const Index3 p = point_of(axis, pu, pv, k), q = point_of(axis, u, v, k);
          const float place = crossing_between(p, q, d, after, across, lattice);
          if (after)
            samples_.keep_upper(SampleMap::key(q, d, region_), {place, stroke.cut});
          else
            samples_.keep_lower(SampleMap::key(p, d, region_), {place, stroke.cut});
        }
      }
    });
  }
}

void Brick::commit(Cell& cell, const std::vector<Change>& changes) const {
  if (changes.empty()) return;
  const std::size_t count = static_cast<std::size_t>(cell.region.count(axis_u(cell.axis))) *
                            static_cast<std::size_t>(cell.region.count(axis_v(cell.axis)));
  if (cell.content == Cell::Content::solid) {
    cell.content = Cell::Content::columns;
    cell.upper.assign(count, beyond);
  }
  for (const Change& change : changes) {
    cell.upper.put(change.column, change.upper);
    if (change.lower.at != -beyond && cell.lower.empty()) cell.lower.assign(count, -beyond);
    if (!cell.lower.empty()) cell.lower.put(change.column, change.lower);
  }
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
    const Points points = solid_points(cell, cell.column(u, v), lattice);
    return std::pair{points.first, points.last};
  });
}

void Brick::occupy(Occupancy& shape, const StockLattice& lattice) const {
  for (const Cell& cell : nodes_) occupy(cell, shape, lattice);
}

/// Divides a cell whose columns cannot represent the result of a stroke (Hahn Fig. 3.1).
void Brick::divide(int node, const Stroke& stroke, const Stock& stock, WindowSet& windows) {
  const StockLattice& lattice = stock.lattice();
  Cell cell = std::move(nodes_[static_cast<std::size_t>(node)]);
  const Region r = cell.region;
  const int axis = cell.axis, ua = axis_u(axis), va = axis_v(axis);
  Occupancy solid(r), covered(r);
  occupy(cell, solid, lattice);
  const auto keep = [&](int u, int v, int k, bool upwards, Sample sample) {
    if (upwards)
      samples_.keep_lower(SampleMap::key(point_of(axis, u, v, k), axis, region_), sample);
    else
      samples_.keep_upper(SampleMap::key(point_of(axis, u, v, k - 1), axis, region_), sample);
  };
  const Window& window = windows.along(axis);
  for (int v = r.first(va); v <= r.last(va); ++v)
    for (int u = r.first(ua); u <= r.last(ua); ++u) {
      const std::size_t column = cell.column(u, v);
      const Points points = solid_points(cell, column, lattice);
      if (points.first > points.last) continue;
      // The ends of columns become samples of the map.
      if (cell.content == Cell::Content::columns) {
        if (cell.upper.at[column] != beyond) keep(u, v, points.last, true, cell.upper[column]);
        if (!cell.lower.empty() && cell.lower.at[column] != -beyond)
          keep(u, v, points.first, false, cell.lower[column]);
      }
      if (!window.has(u, v)) continue;
      const std::size_t at = window.index(u, v);
      const float a = window.entry[at], b = window.exit[at];
      if (a > b) continue;
      const int k0 = from(lattice, axis, a), k1 = up_to(lattice, axis, b);
      if (k0 > k1) continue;
      if (k0 - 1 >= points.first && k0 - 1 <= points.last) keep(u, v, k0 - 1, true, {a, stroke.cut});
      if (k1 + 1 >= points.first && k1 + 1 <= points.last) keep(u, v, k1 + 1, false, {b, stroke.cut});
    }
  covered.set_runs(r, axis, [&](int u, int v) {
    if (!window.has(u, v)) return std::pair{0, -1};
    const std::size_t at = window.index(u, v);
    if (window.entry[at] > window.exit[at]) return std::pair{0, -1};
    return std::pair{from(lattice, axis, window.entry[at]), up_to(lattice, axis, window.exit[at])};
  });
  solid.subtract(covered);
  Cell fresh;
  fresh.region = r;
  nodes_[static_cast<std::size_t>(node)] = std::move(fresh);
  rebuild(node, solid, covered, axis, cell.facing, stroke, stock);
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

// Subtraction of strokes from a brick.
#include <cmath>

#include "brick.h"
#include "rows.h"

namespace fieldfab::cam {
namespace {

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

/// The place on a lattice line along `axis`, mm from the lattice's corner.
Vec3 place_on(int axis, int u, int v, float along, const StockLattice& lattice) {
  Vec3 place;
  place[axis] = along;
  place[axis_u(axis)] = lattice.at(axis_u(axis), u), place[axis_v(axis)] = lattice.at(axis_v(axis), v);
  return place;
}

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
      const ColumnPoints points = columns ? solid_points(cell, column, lattice) : ColumnPoints{low, high};
      if (points.first > points.last) return;
      const bool below = points.first<k0, above = points.last> k1;
      const double length = std::min({static_cast<double>(b), static_cast<double>(upper.at), to_mm}) -
                            std::max({static_cast<double>(a), static_cast<double>(lower.at), from_mm});
      if (length > 0) {
        const double share = (u == 0 || u == cells_u ? 0.5 : 1) * (v == 0 || v == cells_v ? 0.5 : 1);
        // The first place counts; a lattice point is preferred below.
        if (result.volume == 0)
          result.place = place_on(axis, u, v, std::max({a, lower.at, static_cast<float>(from_mm)}), lattice);
        result.volume += share * length * lattice.spacing()[ua] * lattice.spacing()[va];
      }
      const int met = std::min(points.last, k1) - std::max(points.first, k0) + 1;
      if (met > 0) {
        result.points += static_cast<std::uint64_t>(met);
        result.place = place_on(axis, u, v, lattice.at(axis, std::max(points.first, k0)), lattice);
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
        const ColumnPoints points = solid_points(cell, column, lattice);
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
      const ColumnPoints points = solid_points(cell, column, lattice);
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

}  // namespace fieldfab::cam

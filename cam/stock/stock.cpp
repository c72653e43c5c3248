#include "fieldfab/cam/stock/stock.h"

#include <fmt/format.h>

#include <cmath>

#include "brick.h"
#include "field_brick.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "stroke_log.h"
#include "sweep.h"

namespace fieldfab::cam {
Stock::Stock(const Box& box, const StockSettings& settings)
    : settings_(settings), lattice_(box, settings.cell, settings.cell_height) {
  divide_into_bricks();
  for (int z = 0; z < bricks_along_[2]; ++z)
    for (int y = 0; y < bricks_along_[1]; ++y)
      for (int x = 0; x < bricks_along_[0]; ++x)
        bricks_[brick_index(x, y, z)] = std::make_shared<Brick>(brick_region({x, y, z}), true);
}

Stock::Stock(const Field& field, const Box& box, const StockSettings& settings, Progress& progress)
    : settings_(settings), lattice_(box, settings.cell, settings.cell_height), first_(field.shared_from_this()) {
  divide_into_bricks();
  parallel_for(bricks_.size(), [&](std::size_t i) {
    progress.check();
    const auto nx = static_cast<std::size_t>(bricks_along_[0]), ny = static_cast<std::size_t>(bricks_along_[1]);
    bricks_[i] = brick_of(
        field, brick_region({static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / nx / ny)}),
        *this);
  });
}

Stock::Stock(const StockLattice& lattice, const StockSettings& settings) : settings_(settings), lattice_(lattice) {
  divide_into_bricks();
}

Stock::Stock(const Stock&) = default;
Stock::Stock(Stock&&) noexcept = default;
Stock& Stock::operator=(const Stock&) = default;
Stock& Stock::operator=(Stock&&) noexcept = default;
Stock::~Stock() = default;

void Stock::divide_into_bricks() {
  constexpr int most = 1020;  // range of SampleMap's keys
  brick_ = settings_.brick > 0 ? std::min(settings_.brick, most) : most;
  double bricks = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    bricks_along_[a] = lattice_.cells()[a] / brick_ + 1;
    bricks *= bricks_along_[a];
  }
  if (bricks > 50e6)
    throw Error(ErrorKind::too_large, "stock", fmt::format("{:.0f} million bricks; take larger cells", bricks / 1e6));
  bricks_.resize(static_cast<std::size_t>(bricks));
}

Region Stock::brick_region(const Index3& brick) const {
  Region region;
  for (std::size_t a = 0; a < 3; ++a) {
    region.lower[a] = brick[a] * brick_;
    region.upper[a] = std::min(region.lower[a] + brick_ - 1, lattice_.cells()[a]);
  }
  return region;
}

/// Bricks with material near a sweep.
std::vector<std::size_t> Stock::bricks_near(const Sweep& sweep) const {
  std::vector<std::size_t> found;
  const Vec3& h = lattice_.spacing();
  Index3 low, high;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double first = std::floor((sweep.bounds().lower[axis] - h[axis]) / (h[axis] * brick_));
    const double last = std::floor((sweep.bounds().upper[axis] + h[axis]) / (h[axis] * brick_));
    if (!(last >= 0) || !(first < bricks_along_[a])) return found;
    low[a] = static_cast<int>(std::clamp(first, 0.0, bricks_along_[a] - 1.0));
    high[a] = static_cast<int>(std::clamp(last, 0.0, bricks_along_[a] - 1.0));
  }
  const bool many = (high[0] - low[0] + 1) * (high[1] - low[1] + 1) * (high[2] - low[2] + 1) > 2;
  for (int z = low[2]; z <= high[2]; ++z)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int x = low[0]; x <= high[0]; ++x) {
        const std::size_t index = brick_index(x, y, z);
        const Brick& brick = *bricks_[index];
        if (brick.empty()) continue;
        if (many) {
          const Region& r = brick.region();
          Vec3 lower, upper;
          for (int a = 0; a < 3; ++a)
            lower[a] = lattice_.at(a, r.first(a) - 1), upper[a] = lattice_.at(a, r.last(a) + 1);
          if (!sweep.near(0.5 * (lower + upper), 0.5 * (upper - lower).norm() + h.maxCoeff())) continue;
        }
        found.push_back(index);
      }
  return found;
}

std::vector<StrokeResult> Stock::cut(std::span<const Stroke> strokes, Progress& progress) {
  std::vector<StrokeResult> results(strokes.size());
  constexpr std::size_t most_at_once = 1024;
  const Box domain{Vec3::Zero(), lattice_.box().size()};
  std::vector<char> changed(bricks_.size());
  std::vector<std::vector<std::uint32_t>> near(bricks_.size());  // by brick: strokes near it
  for (std::size_t begin = 0; begin < strokes.size(); begin += most_at_once) {
    progress.check();
    const std::size_t count = std::min(most_at_once, strokes.size() - begin);
    std::vector<std::unique_ptr<Sweep>> sweeps(count);
    std::vector<std::vector<std::size_t>> meets(count);  // by stroke: bricks near it
    parallel_for((count + 31) / 32, [&](std::size_t group) {
      for (std::size_t i = group * 32; i < std::min(count, group * 32 + 32); ++i) {
        const Stroke& stroke = strokes[begin + i];
        ToolPose from = stroke.from, to = stroke.to;
        from.tip -= lattice_.box().lower, to.tip -= lattice_.box().lower;
        sweeps[i] = std::make_unique<Sweep>(*stroke.piece, from, to);
        meets[i] = bricks_near(*sweeps[i]);
        if (!meets[i].empty()) sweeps[i]->build(tolerance(), domain);
      }
    });
    std::vector<std::size_t> touched;
    for (std::size_t i = 0; i < count; ++i)
      for (const std::size_t brick : meets[i]) {
        if (near[brick].empty()) touched.push_back(brick);
        near[brick].push_back(static_cast<std::uint32_t>(i));
      }
    std::vector<std::vector<StrokeResult>> met(touched.size());  // results of the passes, by brick
    parallel_for(touched.size(), [&](std::size_t t) {
      std::shared_ptr<Brick>& brick = bricks_[touched[t]];
      if (brick.use_count() > 1) brick = std::make_shared<Brick>(*brick);
      std::vector<Brick::Pass> passes;
      passes.reserve(near[touched[t]].size());
      for (const std::uint32_t i : near[touched[t]]) passes.push_back({sweeps[i].get(), &strokes[begin + i]});
      for (std::size_t first = 0; first < passes.size() && !progress.cancelled(); first += 64)
        brick->cut(std::span(passes).subspan(first, std::min<std::size_t>(64, passes.size() - first)), *this);
      changed[touched[t]] = 1;
      for (const Brick::Pass& pass : passes) met[t].push_back(pass.result);
    });
    // Sequential, so that sums and positions do not depend on the number of threads.
    for (std::size_t t = 0; t < touched.size(); ++t)
      for (std::size_t k = 0; k < met[t].size(); ++k) {
        StrokeResult& result = results[begin + near[touched[t]][k]];
        if ((met[t][k].points && !result.points) || (met[t][k].volume > 0 && result.volume == 0))
          result.place = met[t][k].place + lattice_.box().lower;
        result.volume += met[t][k].volume;
        result.points += met[t][k].points;
      }
    for (const std::size_t brick : touched) near[brick].clear();
    progress.check();
    for (std::size_t i = 0; i < count; ++i) {
      if (meets[i].empty() || !strokes[begin + i].removes) continue;
      if (!strokes_ || strokes_->full() || strokes_.use_count() > 1)
        strokes_ = std::make_shared<StrokeLog>(std::move(strokes_));
      strokes_->add(strokes[begin + i], lattice_.box().lower);
    }
  }
  parallel_for(bricks_.size(), [&](std::size_t i) {
    if (changed[i]) bricks_[i]->settle(lattice_);
  });
  return results;
}

bool Stock::solid(const Index3& p) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (p[a] < 0 || p[a] > lattice_.cells()[a]) return false;
  return bricks_[brick_index(p[0] / brick_, p[1] / brick_, p[2] / brick_)]->solid(p, lattice_);
}

double Stock::volume() const {
  double volume = 0;
  for (const auto& brick : bricks_) volume += brick->volume(lattice_);
  return volume;
}

void Stock::forget_cuts() {
  strokes_.reset(), first_.reset();
  parallel_for(bricks_.size(), [&](std::size_t i) {
    if (bricks_[i]->uniform()) return;
    bricks_[i] = std::make_shared<Brick>(*bricks_[i]);
    bricks_[i]->forget_cuts();
  });
}

StockStatistics Stock::statistics() const {
  StockStatistics statistics;
  statistics.bytes = bricks_.capacity() * sizeof(bricks_[0]);
  if (strokes_) statistics.bytes += strokes_->bytes();
  for (const auto& brick : bricks_) brick->count(statistics);
  return statistics;
}

std::uint64_t Stock::bytes_unlike(const Stock& other) const {
  StockStatistics statistics;
  for (std::size_t i = 0; i < bricks_.size(); ++i)
    if (i >= other.bricks_.size() || bricks_[i] != other.bricks_[i]) bricks_[i]->count(statistics);
  return statistics.bytes;
}

}  // namespace fieldfab::cam

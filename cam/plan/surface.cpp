// The upper surface of a solid: a lattice of heights with local refinement.
#include "fieldfab/cam/plan/surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/render/heights.h"
#include "hidden_parts.h"
#include "mesh_heights.h"

namespace fieldfab::cam {

/// Makes a Surface of a Field.
class SurfaceSampler {
 public:
  SurfaceSampler(const Field& field, const Box& bounds, const SurfaceSettings& settings, Progress& progress)
      : field_(field),
        bounds_(bounds),
        settings_(settings),
        progress_(progress),
        surface_(new Surface),
        hidden_(bounds, slack(), 3 * settings.cell) {}

  std::shared_ptr<const Surface> make() {
    check();
    sample();
    find_rough_squares();
    find_ribs();
    refine();
    return surface_;
  }

 private:
  void check() const {
    if (!bounds_.valid() || !(bounds_.size().minCoeff() > 0))
      throw Error(ErrorKind::bad_input, "bounds", "milling needs finite bounds with a size along x, y and z");
    if (!(settings_.cell > 0) || !(settings_.tolerance > 0))
      throw Error(ErrorKind::bad_input, "resolution", "cell and tolerance must be above 0");
    const double samples = bounds_.size().x() * bounds_.size().y() / (settings_.cell * settings_.cell);
    if (samples > 2e9)
      throw Error(ErrorKind::too_large, "resolution", fmt::format("{:.3g} samples; use larger cells", samples));
    require_memory(static_cast<std::uintmax_t>(samples * 24), "the surface");
  }

  /// Samples one square beyond the bounds on each side, which includes the walls of the bounds.
  void sample() {
    const double cell = settings_.cell;
    const Vec2 size = Rectangle::of(bounds_).size();
    const int wide = static_cast<int>(std::ceil(size.x() / cell - 1e-6)) + 3,
              high = static_cast<int>(std::ceil(size.y() / cell - 1e-6)) + 3;
    const Vec2 first = bounds_.lower.head<2>() - Vec2::Constant(cell) - 0.5 * (Vec2(wide - 3, high - 3) * cell - size);
    surface_->floor_ = bounds_.lower.z();
    surface_->heights_ = HeightMap(wide, high, cell, first, 0);
    mesh_ = MeshHeights::of(field_, {first, first + Vec2(wide - 1, high - 1) * cell});
    surface_->heights_.values =
        heights_of({first, first + Vec2(wide - 1, high - 1) * cell}, wide, high, bounds_.lower.z(), progress_);
  }

  /// Heights at `wide` x `high` points of a rectangle, corners included.
  [[nodiscard]] std::vector<float> heights_of(const Rectangle& area, int wide, int high, double low,
                                              Progress& progress) const {
    const Vec2 half(0.5 * area.size().x() / (wide - 1), 0.5 * area.size().y() / (high - 1));
    const Box region{{area.lower.x() - half.x(), area.lower.y() - half.y(), low},
                     {area.upper.x() + half.x(), area.upper.y() + half.y(), bounds_.upper.z()}};
    std::vector<float> found =
        mesh_ ? mesh_->heights(area, wide, high, low) : heights(field_, region, wide, high, progress);
    const Rectangle inside = Rectangle::of(bounds_).grown(1e-9);
    std::size_t i = 0;
    for (int row = 0; row < high; ++row)
      for (int column = 0; column < wide; ++column, ++i) {
        const Vec2 p = area.lower + 2 * Vec2(half.x() * column, half.y() * row);
        found[i] = inside.contains(p) ? std::clamp(found[i], static_cast<float>(bounds_.lower.z()),
                                                   static_cast<float>(bounds_.upper.z()))
                                      : static_cast<float>(bounds_.lower.z());
      }
    return found;
  }

  /// Marks squares whose samples and neighbours do not lie on one smooth surface. The error of
  /// bilinear interpolation is about an eighth of the second difference.
  void find_rough_squares() {
    const HeightMap& h = surface_->heights_;
    rough_.assign(h.values.size(), 0);
    const auto bend = [](float a, float b, float c) { return std::abs(a - 2 * b + c); };
    const auto most = static_cast<float>(4 * settings_.tolerance);
    parallel_for(static_cast<std::size_t>(h.height), [&](std::size_t r) {
      const int row = static_cast<int>(r);
      for (int column = 0; column + 1 < h.width && row + 1 < h.height; ++column) {
        bool rough = false;
        for (int v = row; v <= row + 1; ++v)
          for (int u = column; u <= column + 1; ++u) {
            if (u > 0 && u + 1 < h.width) rough |= bend(h.at(u - 1, v), h.at(u, v), h.at(u + 1, v)) > most;
            if (v > 0 && v + 1 < h.height) rough |= bend(h.at(u, v - 1), h.at(u, v), h.at(u, v + 1)) > most;
          }
        rough |= std::abs(h.at(column, row) - h.at(column + 1, row) - h.at(column, row + 1) +
                          h.at(column + 1, row + 1)) > most;
        if (rough) rough_[h.index(column, row)] = 1;
      }
    });
  }

  /// Marks squares in which the solid may rise above the samples, by the Field or the mesh.
  void find_ribs() {
    const HeightMap& h = surface_->heights_;
    if (mesh_) {
      parallel_for(static_cast<std::size_t>(h.height - 1), [&](std::size_t r) {
        progress_.check();
        const int row = static_cast<int>(r);
        for (int column = 0; column + 1 < h.width; ++column)
          if (mesh_->highest({h.place(column, row), h.place(column + 1, row + 1)}) > top_of(h, column, row) + slack())
            rough_[h.index(column, row)] = 1;
      });
      return;
    }
    constexpr int tile = 32;
    const int wide = (h.width + tile - 2) / tile, high = (h.height + tile - 2) / tile;
    parallel_for(static_cast<std::size_t>(wide * high), [&](std::size_t t) {
      progress_.check();
      const int left = static_cast<int>(t) % wide * tile, low = static_cast<int>(t) / wide * tile;
      hidden_.search(field_, h, left, low, std::min(left + tile, h.width - 1), std::min(low + tile, h.height - 1),
                     [&](const SuspectSquare& square) { rough_[h.index(square.column, square.row)] = 1; });
    });
  }

  /// Height by which the solid may rise above the samples between them, mm, as find_rough_squares()
  /// permits.
  [[nodiscard]] double slack() const { return 4 * settings_.tolerance; }
  [[nodiscard]] static double top_of(const HeightMap& h, int column, int row) {
    return std::max({h.at(column, row), h.at(column + 1, row), h.at(column, row + 1), h.at(column + 1, row + 1)});
  }

  /// Raises fine samples to the upper bound of the solid between them, so that a cutter keeps clear
  /// of features thinner than their spacing. Returns the number of squares that were raised without
  /// proof of such a feature; `place` receives one of them.
  std::size_t raise_ribs(HeightMap& fine, Vec3& place) const {
    std::size_t doubtful = 0;
    HeightMap raised = fine;
    const auto raise = [&](int column, int row, const HiddenParts::Top& top) {
      if (!(top.z > top_of(fine, column, row) + slack())) return;
      if (!top.sure) {
        ++doubtful;
        place << fine.place(column + 0.5, row + 0.5), top.z;
      }
      for (const int v : {row, row + 1})
        for (const int u : {column, column + 1}) raised.at(u, v) = std::max(raised.at(u, v), static_cast<float>(top.z));
    };
    if (mesh_) {
      for (int row = 0; row + 1 < fine.height; ++row)
        for (int column = 0; column + 1 < fine.width; ++column)
          raise(column, row, {mesh_->highest({fine.place(column, row), fine.place(column + 1, row + 1)}), true});
    } else {
      hidden_.search(field_, fine, 0, 0, fine.width - 1, fine.height - 1, [&](const SuspectSquare& square) {
        // For a Field without slopes, intervals alone are too loose a bound; the fine samples have to do.
        if (square.slopes) raise(square.column, square.row, hidden_.highest(fine, square));
      });
    }
    fine = std::move(raised);
    return doubtful;
  }

  void refine() {
    std::vector<std::size_t> squares;
    for (std::size_t i = 0; i < rough_.size(); ++i)
      if (rough_[i] != 0) squares.push_back(i);
    int parts = std::clamp(static_cast<int>(std::ceil(settings_.cell / settings_.tolerance)), 2, 16);
    constexpr std::size_t most = 400'000'000;  // samples: 1.6 GB
    while (parts > 2 && squares.size() * static_cast<std::size_t>((parts + 1) * (parts + 1)) > most) --parts;
    const std::size_t samples = static_cast<std::size_t>((parts + 1) * (parts + 1));
    require_memory(squares.size() * samples * sizeof(float), "the fine parts of the surface");
    Surface& s = *surface_;
    s.fine_side_ = parts + 1;
    s.fine_index_.assign(s.heights_.values.size(), -1);
    s.fine_.resize(squares.size());
    std::vector<Surface::Doubtful> doubtful(squares.size());
    std::atomic<std::size_t> done{0};
    parallel_for(squares.size(), [&](std::size_t k) {
      progress_.check();
      const int column = static_cast<int>(squares[k] % static_cast<std::size_t>(s.heights_.width));
      const int row = static_cast<int>(squares[k] / static_cast<std::size_t>(s.heights_.width));
      s.fine_index_[squares[k]] = static_cast<std::int32_t>(k);
      HeightMap fine(parts + 1, parts + 1, s.heights_.cell / parts, s.heights_.place(column, row), 0);
      fine.values = heights_of({s.heights_.place(column, row), s.heights_.place(column + 1, row + 1)}, parts + 1,
                               parts + 1, s.floor_, Progress::none());
      Surface::Doubtful& here = doubtful[k];
      here.count = raise_ribs(fine, here.place);
      s.fine_[k] = std::move(fine.values);
      if (const std::size_t n = ++done; n % 1024 == 0)
        progress_.report(static_cast<double>(n) / static_cast<double>(squares.size()), "refining edges");
    });
    for (const Surface::Doubtful& here : doubtful) {
      if (s.doubtful_.count == 0) s.doubtful_.place = here.place;
      s.doubtful_.count += here.count;
    }
    s.top_ = s.floor_;
    for (const float z : s.heights_.values) s.top_ = std::max<double>(s.top_, z);
    for (const auto& block : s.fine_)
      for (const float z : block) s.top_ = std::max<double>(s.top_, z);
  }

  const Field& field_;
  Box bounds_;
  SurfaceSettings settings_;
  Progress& progress_;
  std::shared_ptr<Surface> surface_;
  HiddenParts hidden_;
  std::vector<std::uint8_t> rough_;
  std::unique_ptr<MeshHeights> mesh_;  // heights directly from the triangles, if the solid is a mesh
};

std::shared_ptr<const Surface> Surface::of(const Field& field, const Box& bounds, const SurfaceSettings& settings,
                                           Progress& progress) {
  return SurfaceSampler(field, bounds, settings, progress).make();
}

std::shared_ptr<const Surface> Surface::of(HeightMap heights, double floor) {
  auto surface = std::make_shared<Surface>();
  for (float& z : heights.values) z = std::max(z, static_cast<float>(floor));
  surface->top_ = *std::max_element(heights.values.begin(), heights.values.end());
  surface->heights_ = std::move(heights);
  surface->floor_ = floor;
  return surface;
}

double Surface::height(const Vec2& p) const {
  const Vec2 at = (p - heights_.origin) / heights_.cell;
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() <= heights_.width - 1 && at.y() <= heights_.height - 1)) return floor_;
  const int i = std::min(static_cast<int>(at.x()), heights_.width - 2),
            j = std::min(static_cast<int>(at.y()), heights_.height - 2);
  const auto blend = [](float a, float b, float c, float d, double u, double v) {
    return (1 - v) * (a + u * (b - a)) + v * (c + u * (d - c));
  };
  const float* const block = fine(i, j);
  if (block == nullptr)
    return blend(heights_.at(i, j), heights_.at(i + 1, j), heights_.at(i, j + 1), heights_.at(i + 1, j + 1), at.x() - i,
                 at.y() - j);
  const Vec2 within = (at - Vec2(i, j)) * (fine_side_ - 1);
  const int u = std::min(static_cast<int>(within.x()), fine_side_ - 2),
            v = std::min(static_cast<int>(within.y()), fine_side_ - 2);
  const float* const corner = block + v * fine_side_ + u;
  return blend(corner[0], corner[1], corner[fine_side_], corner[fine_side_ + 1], within.x() - u, within.y() - v);
}

}  // namespace fieldfab::cam

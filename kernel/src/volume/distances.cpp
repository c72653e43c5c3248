#include "fieldfab/volume/distances.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../field/chunk.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/volume/volume_field.h"

namespace fieldfab {
namespace {

constexpr double bytes_a_place = 16;  // including working memory

/// Distances on a lattice: each sample gets from its neighbours the point of the surface that is
/// nearest.
class Sweeping {
 public:
  Sweeping(const Field& solid, const SampleLattice& lattice, double reach, Progress& progress)
      : solid_(solid),
        lattice_(lattice),
        reach_(static_cast<float>(reach)),
        progress_(progress),
        value_(lattice.count()),
        foot_(lattice.count(), nobody),
        square_(lattice.count(), reach_ * reach_) {}

  /// Returns signed distances, within the reach.
  std::vector<float> run() {
    read_values();
    find_feet();
    for (int round = 0; round < 2; ++round)
      for (unsigned way = 0; way < 8; ++way) {
        progress_.report((1 + 8 * round + way) / 17.0, "distances");
        sweep(way);
      }
    refine();
    for (std::size_t i = 0; i < value_.size(); ++i)
      value_[i] = std::copysign(std::sqrt(square_[i]), value_[i] < 0 ? -1.0F : 1.0F);
    return std::move(value_);
  }

 private:
  using Vec3f = Eigen::Vector3f;
  static constexpr std::uint32_t nobody = ~0u;

  [[nodiscard]] int size(std::size_t axis) const { return lattice_.size[axis]; }
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size(1)) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size(0)) +
           static_cast<std::size_t>(i);
  }
  [[nodiscard]] Vec3f place(int i, int j, int k) const {
    return (lattice_.origin + Vec3(i, j, k).cwiseProduct(lattice_.spacing)).cast<float>();
  }

  void read_values() {
    parallel_for(static_cast<std::size_t>(size(2)), [&](std::size_t k) {
      progress_.check();
      const auto width = static_cast<std::size_t>(size(0));
      std::vector<float> x(width), y(width), z(width);
      for (int j = 0; j < size(1); ++j) {
        for (std::size_t i = 0; i < width; ++i) {
          const Vec3f p = place(static_cast<int>(i), j, static_cast<int>(k));
          x[i] = p.x(), y[i] = p.y(), z[i] = p.z();
        }
        solid_.values({x.data(), y.data(), z.data(), width}, &value_[index(0, j, static_cast<int>(k))]);
      }
    });
  }

  /// Finds the feet, the points at which the surface crosses an edge of the lattice; both ends of
  /// the edge get the foot.
  void find_feet() {
    struct Crossing {
      std::size_t lower, upper;  // ends
      Vec3f at;
    };
    std::vector<std::vector<Crossing>> of_slice(static_cast<std::size_t>(size(2)));
    parallel_for(of_slice.size(), [&](std::size_t slice) {
      progress_.check();
      const auto k = static_cast<int>(slice);
      for (int j = 0; j < size(1); ++j)
        for (int i = 0; i < size(0); ++i)
          for (int axis = 0; axis < 3; ++axis) {
            const std::array<int, 3> next{i + (axis == 0), j + (axis == 1), k + (axis == 2)};
            if (next[static_cast<std::size_t>(axis)] == size(static_cast<std::size_t>(axis))) continue;
            const std::size_t a = index(i, j, k), b = index(next[0], next[1], next[2]);
            if ((value_[a] < 0) != (value_[b] < 0))
              of_slice[slice].push_back({a, b, zero(place(i, j, k), place(next[0], next[1], next[2]))});
          }
    });
    for (const std::vector<Crossing>& crossings : of_slice) {
      progress_.check();
      for (const Crossing& crossing : crossings) {
        feet_.push_back(crossing.at);
        const auto foot = static_cast<std::uint32_t>(feet_.size() - 1);
        for (const std::size_t end : {crossing.lower, crossing.upper}) offer(end, place_of(end), foot);
      }
    }
  }

  /// Bisection between two points of different sign.
  [[nodiscard]] Vec3f zero(Vec3f a, Vec3f b) const {
    const bool inside = solid_.value(a.cast<double>()) < 0;
    for (int halving = 0; halving < 12; ++halving) {
      const Vec3f middle = (a + b) / 2;
      ((solid_.value(middle.cast<double>()) < 0) == inside ? a : b) = middle;
    }
    return (a + b) / 2;
  }

  [[nodiscard]] Vec3f place_of(std::size_t i) const {
    const auto row = static_cast<std::size_t>(size(0)), slice = lattice_.slice();
    return place(static_cast<int>(i % row), static_cast<int>(i / row % static_cast<std::size_t>(size(1))),
                 static_cast<int>(i / slice));
  }

  void offer(std::size_t i, const Vec3f& at, std::uint32_t foot) {
    const float square = (feet_[foot] - at).squaredNorm();
    if (square < square_[i]) square_[i] = square, foot_[i] = foot;
  }

  /// Propagates feet from one corner of the lattice to the opposite one.
  void sweep(unsigned way) {
    const std::array<int, 3> step{way & 1 ? -1 : 1, way & 2 ? -1 : 1, way & 4 ? -1 : 1};
    const auto along = [&](std::size_t axis, auto&& body) {
      const int n = size(axis);
      for (int t = 0; t < n; ++t) body(step[axis] > 0 ? t : n - 1 - t, t > 0);
    };
    const auto row = static_cast<std::ptrdiff_t>(size(0)), slice = static_cast<std::ptrdiff_t>(lattice_.slice());
    along(2, [&](int k, bool behind_z) {
      progress_.check();
      along(1, [&](int j, bool behind_y) {
        along(0, [&](int i, bool behind_x) {
          const std::size_t here = index(i, j, k);
          const auto ask = [&](std::ptrdiff_t by) {
            const std::uint32_t foot = foot_[here - static_cast<std::size_t>(by)];
            if (foot != nobody && foot != foot_[here]) offer(here, place(i, j, k), foot);
          };
          if (behind_x) ask(step[0]);
          if (behind_y) ask(step[1] * row);
          if (behind_z) ask(step[2] * slice);
        });
      });
    });
  }

  /// Feet are about a voxel apart. From the nearest foot this follows the surface to a nearer
  /// point.
  void refine() {
    parallel_for(static_cast<std::size_t>(size(2)), [&](std::size_t k) {
      progress_.check();
      std::vector<std::size_t> places;
      const auto flush = [&] {
        follow(places);
        places.clear();
      };
      for (std::size_t i = k * lattice_.slice(); i < (k + 1) * lattice_.slice(); ++i) {
        if (foot_[i] == nobody) continue;
        places.push_back(i);
        if (places.size() == chunk_size) flush();
      }
      flush();
    });
  }

  void follow(const std::vector<std::size_t>& places) {
    using Rows = Eigen::Matrix<float, 3, chunk_size, Eigen::RowMajor>;
    Rows at, slope;
    Chunk value;
    const auto voxel = static_cast<float>(lattice_.spacing.x());
    const auto ask = [&] {
      solid_.gradients({at.row(0).data(), at.row(1).data(), at.row(2).data(), places.size()}, value.data(),
                       {slope.row(0).data(), slope.row(1).data(), slope.row(2).data()});
    };
    for (std::size_t n = 0; n < places.size(); ++n) at.col(static_cast<Eigen::Index>(n)) = feet_[foot_[places[n]]];
    ask();
    // Moves along the tangent plane towards the sample, then back to the surface.
    for (std::size_t n = 0; n < places.size(); ++n) {
      const auto c = static_cast<Eigen::Index>(n);
      const Vec3f normal = slope.col(c).normalized(), way = place_of(places[n]) - at.col(c);
      const Vec3f tangent = way - normal.dot(way) * normal;
      at.col(c) += tangent * std::min(1.0F, 1.5F * voxel / std::max(tangent.norm(), 1e-30F));
    }
    for (int step = 0; step < 2; ++step) {
      ask();
      for (std::size_t n = 0; n < places.size(); ++n) {
        const auto c = static_cast<Eigen::Index>(n);
        const Vec3f g = slope.col(c);
        const float left = std::abs(value[n]) / g.norm();
        if (step == 0)
          at.col(c) -= g * (value[n] / g.squaredNorm());
        else if (const float square = (place_of(places[n]) - at.col(c)).squaredNorm();
                 left < 0.02F * voxel && square < square_[places[n]])
          square_[places[n]] = square;
      }
    }
  }

  const Field& solid_;
  const SampleLattice& lattice_;
  float reach_;
  Progress& progress_;
  std::vector<float> value_;
  std::vector<std::uint32_t> foot_;  // foot of each sample found so far; square of its distance
  std::vector<float> square_;
  std::vector<Vec3f> feet_;
};

/// A Field that equals the solid next to its surface, and distances farther away.
class DistanceField final : public Field {
 public:
  DistanceField(FieldPtr solid, FieldPtr far, double voxel)
      : solid_(std::move(solid)), far_(std::move(far)), voxel_(static_cast<float>(voxel)) {}

  void values(const Points& points, float* out) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk far;
      solid_->values(part, out + first);
      far_->values(part, far.data());
      for (std::size_t i = 0; i < part.count; ++i) out[first + i] = mixed(out[first + i], far[i]);
    });
  }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    for_chunks(points, [&](const Points& part, std::size_t first) {
      Chunk far, dx, dy, dz;
      const std::array<float*, 3> to{slopes.dx + first, slopes.dy + first, slopes.dz + first};
      const std::array<const float*, 3> from{dx.data(), dy.data(), dz.data()};
      solid_->gradients(part, out + first, {to[0], to[1], to[2]});
      far_->gradients(part, far.data(), {dx.data(), dy.data(), dz.data()});
      for (std::size_t i = 0; i < part.count; ++i) {
        const float own = out[first + i], share = share_of_far(own, far[i]);
        // The share itself grows with the distance.
        const float growth = share > 0 && share < 1 ? (far[i] - own) / std::copysign(voxel_, far[i]) : 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          float& slope = to[axis][i];
          slope = (share < 1 ? (1 - share) * slope : 0) + (share > 0 ? (share + growth) * from[axis][i] : 0);
        }
        out[first + i] = mixed(own, far[i]);
      }
    });
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override {
    return range(solid_->interval(box), far_->interval(box));
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    solid_->restrict_all(boxes, purpose, out);
    if (purpose == Purpose::occupancy) return;  // the solid is the same
    std::vector<Restriction> far(boxes.size());
    far_->restrict_all(boxes, purpose, far);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const bool away = is_away(out[i].range, far[i].range);
      out[i].range = range(out[i].range, far[i].range);
      if (away)
        out[i].field = far[i].field;
      else if (out[i].field == solid_ && far[i].field == far_)
        out[i].field = *this;
      else
        out[i].field = std::make_shared<DistanceField>(std::move(out[i].field), std::move(far[i].field), voxel_);
    }
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return solid_->known_bounds(); }
  [[nodiscard]] bool sampled() const noexcept override { return solid_->sampled(); }
  [[nodiscard]] bool smooth() const noexcept override { return solid_->smooth(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return solid_->cost() + far_->cost(); }

 private:
  /// 0 within a voxel of the surface, 1 beyond two voxels, and 0 if the lattice has missed a thin
  /// part.
  [[nodiscard]] float share_of_far(float own, float far) const {
    return (own < 0) == (far < 0) && own == own ? std::clamp(std::abs(far) / voxel_ - 1, 0.0F, 1.0F) : 0;
  }
  [[nodiscard]] float mixed(float own, float far) const {
    const float share = share_of_far(own, far);
    return share == 0 ? own : share == 1 ? far : own + share * (far - own);
  }
  /// Whether only distances count in the box.
  [[nodiscard]] bool is_away(const Interval& own, const Interval& far) const {
    return (own.lower >= 0 && !own.maybe_nan && far.lower >= 2 * voxel_) || (own.inside() && far.upper <= -2 * voxel_);
  }
  [[nodiscard]] Interval range(const Interval& own, const Interval& far) const {
    if (is_away(own, far)) return far;
    return {std::min(own.lower, far.lower), std::max(own.upper, far.upper), own.maybe_nan};
  }

  FieldPtr solid_, far_;
  float voxel_;
};

}  // namespace

FieldPtr distances(FieldPtr solid, const Box& bounds, const DistanceSettings& settings, Progress& progress) {
  if (!(settings.reach > 0) || !std::isfinite(settings.reach))
    throw Error(ErrorKind::bad_input, "reach", "must be above 0 mm");
  if (!(settings.voxel >= 0) || !std::isfinite(settings.voxel))
    throw Error(ErrorKind::bad_input, "voxel", "must be above 0 mm");
  if (bounds.size().minCoeff() < 0 || !bounds.size().allFinite())
    throw Error(ErrorKind::bad_input, "distances", "the solid has no bounds; give some");
  const double longest = (bounds.size().array() + 2 * settings.reach).maxCoeff();
  const double voxel = settings.voxel > 0 ? settings.voxel : longest / 160;
  const Box region = bounds.grown(settings.reach + 2 * voxel);
  SampleLattice lattice;
  const Vec3 cells = (region.size() / voxel).array().ceil();
  require_memory(static_cast<std::uintmax_t>(std::min((cells.array() + 1).prod() * bytes_a_place, 1e18)), "distances");
  for (int axis = 0; axis < 3; ++axis) lattice.size[static_cast<std::size_t>(axis)] = static_cast<int>(cells[axis]) + 1;
  lattice.spacing = Vec3::Constant(voxel);
  lattice.origin = region.lower;
  std::vector<float> far = Sweeping(*solid, lattice, std::max(settings.reach, 3 * voxel), progress).run();
  for (float& distance : far) distance = -distance;  // as densities, which are greater inside
  return std::make_shared<DistanceField>(
      std::move(solid), volume_field(*volume_of(std::move(far), lattice), {0, false, 1}, progress), voxel);
}

}  // namespace fieldfab

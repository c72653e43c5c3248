#include "fieldfab/asdf/asdf.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "asdf_tree.h"
#include "fieldfab/core/error.h"

namespace fieldfab {

Asdf::Asdf(Box region, std::array<int, 3> lattice, double max_error, std::shared_ptr<const Tree> tree)
    : region_(std::move(region)), lattice_(lattice), max_error_(max_error), tree_(std::move(tree)) {
  for (std::size_t axis = 0; axis < 3; ++axis) count_[axis] = std::max(lattice[axis], 1);
}

/// A cell, and the range of the lattice that it covers.
struct Asdf::Place {
  CellWord word;
  LatticeRange range;
};

namespace {

/// Returns the coordinates of a point in lattice cells from the region's lower corner.
std::array<double, 3> lattice_point(const Box& region, const std::array<int, 3>& lattice, const Vec3& p) {
  std::array<double, 3> at{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    if (lattice[axis] > 0) at[axis] = (p[a] - region.lower[a]) / region.size()[a] * lattice[axis];
  }
  return at;
}

/// Returns the position of a point in a leaf, 0 to 1 along each axis.
std::array<float, 3> within(const std::array<double, 3>& at, const LatticeRange& range) {
  std::array<float, 3> t{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    t[axis] = static_cast<float>(std::clamp((at[axis] - range.first[axis]) / range.count[axis], 0.0, 1.0));
  return t;
}

float mix(float a, float b, float t) { return a + (b - a) * t; }

/// Trilinear interpolation; in spite of rounding the result is never beyond the values of the
/// corners.
float interpolate(const LeafSamples& s, const std::array<float, 3>& t) {
  float low = s.corner(0), high = low;
  std::array<float, 8> v;
  for (std::size_t i = 0; i < 8; ++i) v[i] = s.corner(i), low = std::min(low, v[i]), high = std::max(high, v[i]);
  for (std::size_t i = 0; i < 8; i += 2) v[i] = mix(v[i], v[i + 1], t[0]);
  const float lower = mix(v[0], v[2], t[1]), upper = mix(v[4], v[6], t[1]);
  return std::clamp(mix(lower, upper, t[2]), low, high);
}

}  // namespace

double Asdf::voxel() const {
  double largest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (lattice_[axis] > 0)
      largest = std::max(largest, region_.size()[static_cast<Eigen::Index>(axis)] / lattice_[axis]);
  return largest;
}

double Asdf::finest() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (lattice_[axis] > 0)
      smallest = std::min(smallest, region_.size()[static_cast<Eigen::Index>(axis)] / lattice_[axis]);
  return smallest;
}

Asdf::Place Asdf::find(const std::array<double, 3>& at) const noexcept {
  Place place{tree_->cells[root_], {first_, count_}};
  while (place.word.kind() == CellKind::branch) {
    unsigned number = 0, bit = 0;
    const unsigned axes = place.word.axes();
    for (std::size_t axis = 0; axis < 3; ++axis) {  // inlined LatticeRange::child()
      if ((axes >> axis & 1U) == 0) continue;
      int &first = place.range.first[axis], &count = place.range.count[axis];
      const int lower = count / 2;
      const bool upper = at[axis] >= first + lower;
      number |= static_cast<unsigned>(upper) << bit++;
      first += upper ? lower : 0;
      count = upper ? count - lower : lower;
    }
    place.word = tree_->cells[place.word.first_child() + number];
  }
  return place;
}

namespace {

/// Whether a range contains a point; points on its upper planes belong to the next range.
bool holds(const LatticeRange& range, const std::array<double, 3>& at) {
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    inside &= at[axis] >= range.first[axis] && at[axis] < range.first[axis] + range.count[axis];
  return inside;
}

}  // namespace

void Asdf::values(const Points& points, float* out) const noexcept {
  const auto far = static_cast<float>(voxel() * 1.7320508);
  Place place{{}, {{}, {0, 0, 0}}};  // cell of the previous point: neighbours usually share a cell
  for (std::size_t i = 0; i < points.count; ++i) {
    const Vec3 p(points.x[i], points.y[i], points.z[i]);
    if (!(p.allFinite())) {
      out[i] = far;
      continue;
    }
    const double beyond = std::max((region_.lower - p).maxCoeff(), (p - region_.upper).maxCoeff());
    // The faces of the region, rounded to floats, belong to it.
    if (beyond > 1e-6 * (std::abs(region_.lower.cwiseAbs().maxCoeff()) + region_.upper.cwiseAbs().maxCoeff())) {
      out[i] = far + static_cast<float>(beyond);
      continue;
    }
    const std::array<double, 3> at = lattice_point(region_, lattice_, p);
    if (!holds(place.range, at)) place = find(at);
    switch (place.word.kind()) {
      case CellKind::leaf: out[i] = interpolate(tree_->leafs[place.word.samples()], within(at, place.range)); break;
      case CellKind::filled: out[i] = -far; break;
      default: out[i] = far;
    }
  }
}

void Asdf::gradients(const Points& points, float* out, const Gradients& slopes) const noexcept {
  values(points, out);
  for (std::size_t i = 0; i < points.count; ++i) {
    slopes.dx[i] = slopes.dy[i] = slopes.dz[i] = 0;
    const Vec3 p(points.x[i], points.y[i], points.z[i]);
    if (!p.allFinite()) continue;
    const std::array<double, 3> at = lattice_point(region_, lattice_, p);
    const Place place = find(at);
    if (place.word.kind() != CellKind::leaf) continue;
    const LeafSamples& s = tree_->leafs[place.word.samples()];
    const std::array<float, 3> t = within(at, place.range);
    const std::array<float*, 3> to{&slopes.dx[i], &slopes.dy[i], &slopes.dz[i]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (lattice_[axis] == 0) continue;
      std::array<float, 3> low = t, high = t;
      low[axis] = 0;
      high[axis] = 1;
      const double length = region_.size()[static_cast<Eigen::Index>(axis)] / lattice_[axis] * place.range.count[axis];
      *to[axis] = static_cast<float>((interpolate(s, high) - interpolate(s, low)) / length);
    }
  }
}

Interval Asdf::interval(const Box& box) const noexcept {
  const auto far = static_cast<float>(voxel() * 1.7320508);
  const Interval anything{-std::max(tree_->greatest, far), std::numeric_limits<float>::infinity(), true};
  if (!box.lower.allFinite() || !box.upper.allFinite()) return anything;
  // Points are rounded to floats before the lookup, so the box gets a margin.
  constexpr double slack = 1e-3;
  std::array<double, 3> low = lattice_point(region_, lattice_, box.lower),
                        high = lattice_point(region_, lattice_, box.upper);
  Interval range = Interval::of(0);
  bool any = false;
  const auto add = [&](float lower, float upper) {
    range = any ? Interval{std::min(range.lower, lower), std::max(range.upper, upper), false}
                : Interval{lower, upper, false};
    any = true;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    low[axis] -= slack;
    high[axis] += slack;
    if (box.lower[a] < region_.lower[a] || box.upper[a] > region_.upper[a]) {
      const double beyond = std::max({region_.lower[a] - box.lower[a], box.upper[a] - region_.upper[a], 0.0});
      add(far, far + static_cast<float>(beyond) * 1.000001F + far);
      if (range.upper <
          far + static_cast<float>((box.upper - region_.upper).cwiseMax(region_.lower - box.lower).maxCoeff()))
        range.upper = std::numeric_limits<float>::infinity();
    }
  }
  std::vector<Place> open{{tree_->cells[root_], {first_, count_}}};
  for (int looked = 0; !open.empty(); ++looked) {
    if (looked > 2048)
      return {std::min(range.lower, -std::max(tree_->greatest, far)),
              std::max(range.upper, std::max(tree_->greatest, far)), false};
    const Place place = open.back();
    open.pop_back();
    bool meets = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      meets = meets && high[axis] >= place.range.first[axis] &&
              low[axis] <= place.range.first[axis] + place.range.count[axis];
    if (!meets) continue;
    switch (place.word.kind()) {
      case CellKind::filled: add(-far, -far); break;
      case CellKind::empty: add(far, far); break;
      case CellKind::leaf: {
        const LeafSamples& s = tree_->leafs[place.word.samples()];
        const auto [least, most] = std::minmax_element(s.distance.begin(), s.distance.end());
        add(s.step * static_cast<float>(*least), s.step * static_cast<float>(*most));
        break;
      }
      case CellKind::branch:
        for (unsigned i = 0; i < 1U << std::popcount(place.word.axes()); ++i)
          open.push_back({tree_->cells[place.word.first_child() + i], place.range.child(place.word.axes(), i)});
    }
  }
  return any ? range : Interval{far, std::numeric_limits<float>::infinity(), false};
}

void Asdf::restrict_all(std::span<const Box> boxes, Purpose /*purpose*/, std::span<Restriction> out) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) out[i] = {interval(boxes[i]), subtree(boxes[i])};
}

RestrictedField Asdf::subtree(const Box& box) const {
  if (!box.lower.allFinite() || !box.upper.allFinite()) return *this;
  constexpr double slack = 1e-3;
  const std::array<double, 3> low = lattice_point(region_, lattice_, box.lower),
                              high = lattice_point(region_, lattice_, box.upper);
  std::uint32_t root = root_;
  LatticeRange covered{first_, count_};
  while (tree_->cells[root].kind() == CellKind::branch) {
    const CellWord word = tree_->cells[root];
    unsigned number = 0, bit = 0;
    bool one = true;
    for (unsigned axis = 0; axis < 3; ++axis) {
      if ((word.axes() >> axis & 1U) == 0) continue;
      const double middle = covered.first[axis] + covered.lower_count(static_cast<int>(axis));
      const bool upper = low[axis] - slack > middle;
      one = one && (upper || high[axis] + slack < middle);
      number |= static_cast<unsigned>(upper) << bit++;
    }
    if (!one) break;
    root = word.first_child() + number;
    covered = covered.child(word.axes(), number);
  }
  if (root == root_) return *this;
  auto part = std::shared_ptr<Asdf>(new Asdf(*this));
  part->root_ = root;
  part->first_ = covered.first;
  part->count_ = covered.count;
  return part;
}

AsdfStatistics Asdf::statistics() const {
  AsdfStatistics counts;
  struct Open {
    std::uint32_t cell;
    int depth;
  };
  for (std::vector<Open> open{{root_, 0}}; !open.empty();) {
    const auto [cell, depth] = open.back();
    open.pop_back();
    const CellWord word = tree_->cells[cell];
    counts.depth = std::max(counts.depth, depth);
    switch (word.kind()) {
      case CellKind::empty: ++counts.empty; break;
      case CellKind::filled: ++counts.filled; break;
      case CellKind::leaf: ++counts.leafs; break;
      case CellKind::branch:
        ++counts.branches;
        for (unsigned i = 0; i < 1U << std::popcount(word.axes()); ++i)
          open.push_back({word.first_child() + i, depth + 1});
    }
  }
  counts.bytes = tree_->cells.capacity() * sizeof(CellWord) + tree_->leafs.capacity() * sizeof(LeafSamples);
  return counts;
}

namespace {

/// Returns the cells of a tree that meet the plane at lattice height z, as cells of a flat tree.
BuildCell cut(const Asdf::Tree& tree, CellWord word, const LatticeRange& range, double z) {
  BuildCell cell;
  cell.kind = word.kind();
  if (cell.kind == CellKind::leaf) {
    const LeafSamples& s = tree.leafs[word.samples()];
    const auto t = static_cast<float>(std::clamp((z - range.first[2]) / range.count[2], 0.0, 1.0));
    for (std::size_t i = 0; i < 4; ++i) cell.corners[i] = cell.corners[i + 4] = mix(s.corner(i), s.corner(i + 4), t);
  }
  if (cell.kind != CellKind::branch) return cell;
  const bool splits_z = (word.axes() & 4U) != 0;
  const unsigned upper = splits_z && z >= range.first[2] + range.lower_count(2) ? 1 : 0;
  const unsigned flat = word.axes() & 3U, count = 1U << std::popcount(flat);
  const auto child = [&](unsigned i) {
    const unsigned number = i | (splits_z ? upper << std::popcount(flat) : 0U);
    return cut(tree, tree.cells[word.first_child() + number], range.child(word.axes(), number), z);
  };
  if (flat == 0) return child(0);
  cell.axes = flat;
  for (unsigned i = 0; i < count; ++i) cell.children.push_back(child(i));
  return cell;
}

}  // namespace

std::shared_ptr<const Asdf> Asdf::slice(double z) const {
  if (!(z >= region_.lower.z() && z <= region_.upper.z()))
    throw Error(ErrorKind::bad_input, "slice", "the height is outside of the region");
  Box flat = region_;
  flat.lower.z() = flat.upper.z() = z;
  const double at = lattice_point(region_, lattice_, {0, 0, z})[2];
  return std::shared_ptr<const Asdf>(
      new Asdf(flat, {lattice_[0], lattice_[1], 0}, max_error_,
               std::make_shared<Tree>(packed(cut(*tree_, tree_->cells[root_], {first_, count_}, at)))));
}

std::shared_ptr<const Asdf> Asdf::rescaled(double factor) const {
  if (!(factor > 0) || !std::isfinite(factor))
    throw Error(ErrorKind::bad_input, "rescale", "the factor must be a positive number");
  auto tree = std::make_shared<Tree>(*tree_);
  for (LeafSamples& samples : tree->leafs) samples.step *= static_cast<float>(factor);
  tree->greatest *= static_cast<float>(factor);
  return std::shared_ptr<const Asdf>(
      new Asdf({factor * region_.lower, factor * region_.upper}, lattice_, factor * max_error_, tree));
}

std::optional<double> Asdf::ray(const Vec3& origin, const Vec3& direction) const {
  const double length = direction.norm();
  if (!(length > 0) || !origin.allFinite() || !std::isfinite(length))
    throw Error(ErrorKind::bad_input, "ray", "origin and direction must be finite, and the direction not 0");
  const Vec3 d = direction / length;
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0) {
      if (origin[axis] < region_.lower[axis] || origin[axis] > region_.upper[axis]) return std::nullopt;
      continue;
    }
    const double a = (region_.lower[axis] - origin[axis]) / d[axis], b = (region_.upper[axis] - origin[axis]) / d[axis];
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  }
  // The ray passes from cell to cell; in a leaf in steps of a quarter of the smallest cell,
  // followed by bisection of the crossing.
  const double step = voxel() / 4, nudge = voxel() * 1e-4;
  for (double t = near; t <= far;) {
    const Vec3 p = origin + t * d;
    const std::array<double, 3> at = lattice_point(region_, lattice_, p);
    const Place place = find(at);
    if (place.word.kind() == CellKind::filled) return t;
    double leave = far;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      if (d[a] == 0 || lattice_[axis] == 0) continue;
      const double plane = region_.lower[a] + region_.size()[a] / lattice_[axis] *
                                                  (place.range.first[axis] + (d[a] > 0 ? place.range.count[axis] : 0));
      leave = std::min(leave, std::max(t, (plane - origin[a]) / d[a]));
    }
    if (place.word.kind() == CellKind::leaf) {
      double outside = t;
      for (double s = t; s <= leave + nudge; s += std::min(step, std::max(leave - s, nudge))) {
        if (value(origin + s * d) < 0) {
          double inside = s;
          for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (inside + outside);
            (value(origin + middle * d) < 0 ? inside : outside) = middle;
          }
          return inside;
        }
        outside = s;
        if (s >= leave) break;
      }
    }
    t = leave + nudge;
  }
  return std::nullopt;
}

}  // namespace fieldfab

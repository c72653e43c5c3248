// Marching squares in one block, with crossings at the Field's own surface and corners.
#include "contour_block.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "fieldfab/field/plane_bounds.h"

namespace fieldfab::cam {
namespace {

/// Samples one block of squares and extracts its segments.
class Block {
 public:
  Block(const Field& field, const Squares& squares, double level, const Part& part)
      : field_(field),
        squares_(squares),
        level_(static_cast<float>(level)),
        part_(part),
        wide_(part.right - part.left + 1) {}

  /// `missed`: receives parts that the samples do not show, unless nullptr.
  void trace(std::vector<Piece>& pieces, MissedParts* missed) {
    sample();
    if (missed != nullptr) look_between_samples(field_, part_, *missed);
    find_crossings();
    if (count_ == 0) return;
    close_in();
    const std::size_t first = pieces.size();
    for (int j = part_.low; j < part_.high; ++j)
      for (int i = part_.left; i < part_.right; ++i) connect(i, j, pieces);
    if (!field_.sampled()) place_corners({pieces.data() + first, pieces.size() - first});
  }

 private:
  static constexpr std::size_t side = block_side + 1, most_crossings = 2 * side * side;

  /// Adds squares in which part of the contour may have been missed.
  void look_between_samples(const Field& field, const Part& part, MissedParts& missed) const {
    if (part.left >= part.right || part.low >= part.high) return;
    const auto box_of = [&](double beyond) {
      return Box{{squares_.x(part.left) - beyond, squares_.y(part.low) - beyond, squares_.z},
                 {squares_.x(part.right) + beyond, squares_.y(part.high) + beyond, squares_.z}};
    };
    // A little larger than the squares, so that a bulge of the contour across a side is seen from
    // both squares.
    const Box box = box_of(squares_.cell / 8);
    const Restriction here = field.restricted(box);
    if (is_clear(here, box) || is_one_curve(*here.field, box)) return;
    if (part.right - part.left > 1 || part.high - part.low > 1) {
      const int u = (part.left + part.right + 1) / 2, v = (part.low + part.high + 1) / 2;
      for (const Part& quarter : {Part{part.left, part.low, u, v}, Part{u, part.low, part.right, v},
                                  Part{part.left, v, u, part.high}, Part{u, v, part.right, part.high}})
        look_between_samples(*here.field, quarter, missed);
      return;
    }
    const bool inside = value_[sample_index(part.left, part.low)] < 0;
    for (const auto& [i, j] :
         {std::pair{part.right, part.low}, std::pair{part.left, part.high}, std::pair{part.right, part.high}})
      if ((value_[sample_index(i, j)] < 0) != inside) return;
    constexpr int deepest = 4;
    const Box square = intersection(box_of(0), squares_.region.at(squares_.z));
    if (square.valid()) look_into(*here.field, square, inside, deepest, missed);
  }

  /// Whether interval or slopes prove that a Field is on one side of the level throughout a box.
  [[nodiscard]] bool is_clear(const Restriction& here, const Box& box) const {
    if (!here.range.maybe_nan && (here.range.lower > level_ || here.range.upper < level_)) return true;
    const PlaneBounds plane = plane_bounds(*here.field, box);
    const double level = level_;
    return plane.known && (plane.lower() > level || plane.upper() < level);
  }

  /// Whether the Field is proved to increase throughout a box along its mean slope. Then the
  /// contour there is the graph of a function.
  [[nodiscard]] static bool is_one_curve(const Field& field, const Box& box) {
    const PlaneBounds plane = plane_bounds(field, box);
    Vec3 along = plane.slope;
    along.z() = 0;
    if (!plane.known || !(along.norm() > 0)) return false;
    along.normalize();
    Interval slope;
    field.slopes(box, {&along, 1}, {&slope, 1});
    return !slope.maybe_nan && slope.lower >= 0 && slope.upper > 0;
  }

  /// Searches a square with four corners on one side for the other side, by subdivision. Returns
  /// whether it is found.
  bool look_into(const Field& field, const Box& box, bool inside, int depth, MissedParts& missed) const {
    const Restriction here = field.restricted(box);
    if (is_clear(here, box)) return false;
    const Vec3 middle = box.centre();
    if ((here.field->value(middle) < level_) != inside) {
      if (missed.lost++ == 0) missed.place = middle.head<2>();
      return true;
    }
    if (depth == 0) {
      if (!plane_bounds(*here.field, box).known) return false;
      if (missed.unproved++ == 0 && missed.lost == 0) missed.place = middle.head<2>();
      return false;
    }
    for (int quarter = 0; quarter < 4; ++quarter) {
      Box part = box;
      for (int axis = 0; axis < 2; ++axis) ((quarter >> axis & 1) != 0 ? part.lower : part.upper)[axis] = middle[axis];
      if (look_into(*here.field, part, inside, depth - 1, missed)) return true;
    }
    return false;
  }

  [[nodiscard]] std::size_t sample_index(int i, int j) const {
    return static_cast<std::size_t>(j - part_.low) * static_cast<std::size_t>(wide_) +
           static_cast<std::size_t>(i - part_.left);
  }

  /// Values of the Field minus the level; positive outside of the region.
  void evaluate(std::size_t count, const float* x, const float* y, float* out) const {
    std::array<float, most_crossings> z;
    std::fill_n(z.data(), count, static_cast<float>(squares_.z));
    field_.values({x, y, z.data(), count}, out);
    const Rectangle& r = squares_.region;
    for (std::size_t k = 0; k < count; ++k) {
      const double beyond =
          std::max(std::max(r.lower.x() - x[k], x[k] - r.upper.x()), std::max(r.lower.y() - y[k], y[k] - r.upper.y()));
      const float value = out[k] - level_;
      out[k] = value != value ? 1.0F : beyond > 0 ? std::max(value, static_cast<float>(beyond)) : value;
    }
  }

  void sample() {
    std::array<float, side * side> x, y;
    std::size_t count = 0;
    for (int j = part_.low; j <= part_.high; ++j)
      for (int i = part_.left; i <= part_.right; ++i, ++count) x[count] = squares_.x(i), y[count] = squares_.y(j);
    evaluate(count, x.data(), y.data(), value_.data());
  }

  void find_crossings() {
    for (int j = part_.low; j <= part_.high; ++j)
      for (int i = part_.left; i <= part_.right; ++i) {
        const std::size_t here = sample_index(i, j);
        if (i < part_.right) add_crossing(here, sample_index(i + 1, j), i, j, 0);
        if (j < part_.high) add_crossing(here, sample_index(i, j + 1), i, j, 1);
      }
  }

  void add_crossing(std::size_t a, std::size_t b, int i, int j, int along_y) {
    std::int32_t& slot = slot_[2 * a + static_cast<std::size_t>(along_y)];
    slot = -1;
    const bool a_in = value_[a] < 0, b_in = value_[b] < 0;
    if (a_in == b_in) return;
    slot = static_cast<std::int32_t>(count_);
    const int bi = i + 1 - along_y, bj = j + along_y;
    Ends& e = ends_[count_++];
    e.inside = {squares_.x(a_in ? i : bi), squares_.y(a_in ? j : bj)};
    e.outside = {squares_.x(a_in ? bi : i), squares_.y(a_in ? bj : j)};
    e.value_inside = value_[a_in ? a : b], e.value_outside = value_[a_in ? b : a];
  }

  /// Regula falsi in the Illinois form, all crossings in step; only bisection after a few rounds, since convergence is
  /// slow at a discontinuity. Separate from the search in the kernel's contour/edges.cpp: in a plane, with floats, and
  /// on values less `level_` that are cut off at the region's border.
  void close_in() {
    const auto near = static_cast<float>(1e-3 * squares_.cell);
    std::array<float, most_crossings> value;
    std::array<std::int8_t, most_crossings> last{};
    for (int step = 0;; ++step) {
      float moved = 0;
      for (std::size_t k = 0; k < count_; ++k) {
        const Ends& e = ends_[k];
        constexpr int patience = 5;
        const float share =
            step > patience ? 0.5F : std::clamp(e.value_inside / (e.value_inside - e.value_outside), 0.0F, 1.0F);
        const float x = e.inside[0] + share * (e.outside[0] - e.inside[0]),
                    y = e.inside[1] + share * (e.outside[1] - e.inside[1]);
        if (step > 0) moved = std::max(moved, std::max(std::abs(x - x_[k]), std::abs(y - y_[k])));
        x_[k] = x, y_[k] = y;
      }
      if ((step > 0 && moved <= near) || step == 16) return;
      evaluate(count_, x_.data(), y_.data(), value.data());
      bool exact = true;
      for (std::size_t k = 0; k < count_; ++k) {
        Ends& e = ends_[k];
        const bool in = value[k] < 0;
        const std::int8_t side_now = in ? 1 : -1;
        exact &= value[k] == 0;
        (in ? e.inside : e.outside) = std::array{x_[k], y_[k]};
        (in ? e.value_inside : e.value_outside) = value[k];
        if (last[k] == side_now) (in ? e.value_outside : e.value_inside) *= 0.5F;
        last[k] = side_now;
      }
      if (exact) return;
    }
  }

  /// Adds the segments of one square (Keeter Fig. 6-8), each with the inside on its left.
  void connect(int i, int j, std::vector<Piece>& pieces) {
    const std::size_t a = sample_index(i, j), b = sample_index(i + 1, j), c = sample_index(i, j + 1),
                      d = sample_index(i + 1, j + 1);
    const int state =
        (value_[a] < 0 ? 1 : 0) | (value_[b] < 0 ? 2 : 0) | (value_[c] < 0 ? 4 : 0) | (value_[d] < 0 ? 8 : 0);
    enum { bottom, right, top, left };
    const auto piece = [&](int from, int to) {
      const auto place = [&](int side_of) {
        struct Place {
          Crossing key;
          std::int32_t slot;
        };
        switch (side_of) {
          case bottom: return Place{squares_.edge(i, j, 0), slot_[2 * a]};
          case right: return Place{squares_.edge(i + 1, j, 1), slot_[2 * b + 1]};
          case top: return Place{squares_.edge(i, j + 1, 0), slot_[2 * c]};
          default: return Place{squares_.edge(i, j, 1), slot_[2 * a + 1]};
        }
      };
      const auto start = place(from), end = place(to);
      const auto s = static_cast<std::size_t>(start.slot);
      const float none = std::numeric_limits<float>::quiet_NaN();
      pieces.push_back({start.key, end.key, {x_[s], y_[s]}, {none, none}});
      end_slot_.push_back({start.slot, end.slot, i, j});
    };
    switch (state) {
      case 1: return piece(bottom, left);
      case 2: return piece(right, bottom);
      case 3: return piece(right, left);
      case 4: return piece(left, top);
      case 5: return piece(bottom, top);
      case 7: return piece(right, top);
      case 8: return piece(top, right);
      case 10: return piece(top, bottom);
      case 11: return piece(top, left);
      case 12: return piece(left, right);
      case 13: return piece(bottom, right);
      case 14: return piece(left, bottom);
      case 6:
      case 9: {
        // inside corners are connected through the middle
        const bool joined = value_[a] + value_[b] + value_[c] + value_[d] < 0;
        if (state == 6) {
          if (joined) return piece(left, bottom), piece(right, top);
          return piece(right, bottom), piece(left, top);
        }
        if (joined) return piece(bottom, right), piece(top, left);
        return piece(bottom, left), piece(top, right);
      }
      default: return;
    }
  }

  /// Whether another segment passes through the same square.
  [[nodiscard]] bool two_pieces(std::size_t k, std::size_t count) const {
    const auto same = [&](std::size_t a, std::size_t b) {
      return end_slot_[a].i == end_slot_[b].i && end_slot_[a].j == end_slot_[b].j;
    };
    return (k > 0 && same(k, k - 1)) || (k + 1 < count && same(k, k + 1));
  }
  /// Whether all four corners of a square are on one side.
  [[nodiscard]] bool no_contour_in(int i, int j) const {
    const std::array<float, 4> x{squares_.x(i), squares_.x(i + 1), squares_.x(i), squares_.x(i + 1)};
    const std::array<float, 4> y{squares_.y(j), squares_.y(j), squares_.y(j + 1), squares_.y(j + 1)};
    std::array<float, 4> value;
    evaluate(4, x.data(), y.data(), value.data());
    const auto inside = std::count_if(value.begin(), value.end(), [](float v) { return v < 0; });
    return inside == 0 || inside == 4;
  }

  /// Places a corner where the tangents at both ends of a segment intersect at an angle, if that is
  /// near the square and the Field is zero there.
  void place_corners(std::span<Piece> pieces) {
    std::array<float, most_crossings> z, value, dx, dy, dz;
    std::fill_n(z.data(), count_, static_cast<float>(squares_.z));
    field_.gradients({x_.data(), y_.data(), z.data(), count_}, value.data(), {dx.data(), dy.data(), dz.data()});
    // along the region's border the contour is the border itself
    for (std::size_t k = 0; k < count_; ++k)
      for (int axis = 0; axis < 2; ++axis) {
        const double at = axis == 0 ? x_[k] : y_[k], near = 2e-3 * squares_.cell;
        const double side_of = std::abs(at - squares_.region.lower[axis]) < near   ? -1
                               : std::abs(at - squares_.region.upper[axis]) < near ? 1
                                                                                   : 0;
        if (side_of != 0)
          dx[k] = static_cast<float>(axis == 0 ? side_of : 0), dy[k] = static_cast<float>(axis == 0 ? 0 : side_of);
      }
    std::array<float, most_crossings> corner_x, corner_y, corner_value, steepness;
    std::array<std::size_t, most_crossings> whose;
    std::size_t found = 0;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const auto p = static_cast<std::size_t>(end_slot_[k].from), q = static_cast<std::size_t>(end_slot_[k].to);
      const Vec2 n(dx[p], dy[p]), m(dx[q], dy[q]);
      const double lengths = n.norm() * m.norm(), sine = n.x() * m.y() - n.y() * m.x();
      if (!(std::abs(sine) > 0.2 * lengths)) continue;  // sine of 11 degrees; also excludes NaN and 0
      const Vec2 a(x_[p], y_[p]), b(x_[q], y_[q]);
      const double along_n = n.dot(a), along_m = m.dot(b);
      const Vec2 corner((along_n * m.y() - along_m * n.y()) / sine, (along_m * n.x() - along_n * m.x()) / sine);
      const Vec2 low(squares_.x(end_slot_[k].i), squares_.y(end_slot_[k].j));
      // A corner's tip may lie in the adjacent square, between two samples, if that contains no
      // other segment.
      const Vec2 beside = ((corner - low) / squares_.cell).array().floor();
      if (beside.cwiseAbs().maxCoeff() > 1) continue;
      const int i = end_slot_[k].i + static_cast<int>(beside.x()), j = end_slot_[k].j + static_cast<int>(beside.y());
      const bool own = beside.isZero() && !two_pieces(k, pieces.size());
      if (!own && (beside.isZero() || !no_contour_in(i, j))) continue;
      corner_x[found] = static_cast<float>(corner.x()), corner_y[found] = static_cast<float>(corner.y());
      steepness[found] = static_cast<float>(std::min(n.norm(), m.norm()));
      whose[found++] = k;
      if (found == most_crossings) break;
    }
    if (found == 0) return;
    evaluate(found, corner_x.data(), corner_y.data(), corner_value.data());
    for (std::size_t f = 0; f < found; ++f)
      if (std::abs(corner_value[f]) <= 0.02F * steepness[f] * static_cast<float>(squares_.cell))
        pieces[whose[f]].corner = {corner_x[f], corner_y[f]};
  }

  struct Ends {
    std::array<float, 2> inside, outside;
    float value_inside, value_outside;
  };
  struct Slots {
    std::int32_t from, to;
    int i, j;
  };

  const Field& field_;
  const Squares& squares_;
  float level_;
  Part part_;
  int wide_;
  std::array<float, side * side> value_;
  // index of the edges along x and y that start at each sample
  std::array<std::int32_t, most_crossings> slot_;
  std::array<Ends, most_crossings> ends_;
  std::array<float, most_crossings> x_, y_;
  std::size_t count_ = 0;
  std::vector<Slots> end_slot_;
};

}  // namespace

void trace_block(const Field& field, const Squares& squares, double level, const Part& part, std::vector<Piece>& pieces,
                 MissedParts* missed) {
  Block(field, squares, level, part).trace(pieces, missed);
}

}  // namespace fieldfab::cam

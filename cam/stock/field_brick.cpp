#include "field_brick.h"

#include <algorithm>
#include <cmath>

namespace fieldfab::cam {
namespace {

/// Points as a batch for a Field.
struct Batch {
  std::vector<float> x, y, z, value;
  void add(const Vec3& p) {
    x.push_back(static_cast<float>(p.x())), y.push_back(static_cast<float>(p.y())),
        z.push_back(static_cast<float>(p.z()));
  }
  void evaluate(const Field& field) {
    value = std::vector<float>(x.size());
    field.values({x.data(), y.data(), z.data(), x.size()}, value.data());
  }
};

/// An edge of the lattice that the surface crosses, during the search for the crossing.
struct Crossing {
  Index3 inside;
  int axis;
  int step;             ///< towards the outer end, along the axis
  double in, out;       ///< bracket, as fractions of the edge from its inner end
  float at_in, at_out;  ///< values at the ends of the bracket

  /// Fraction of the edge for the next try: the zero of the line through the bracket's ends, or the middle.
  [[nodiscard]] double share(bool middle) const {
    const double t = std::isfinite(at_out) ? at_in / (static_cast<double>(at_in) - at_out) : 0.5;
    return middle ? 0.5 * (in + out) : in + (out - in) * std::clamp(t, 0.001, 0.999);
  }
};

template <class Body>
void for_points(const Region& region, const Body& body) {
  Index3 p;
  for (p[2] = region.lower[2]; p[2] <= region.upper[2]; ++p[2])
    for (p[1] = region.lower[1]; p[1] <= region.upper[1]; ++p[1])
      for (p[0] = region.lower[0]; p[0] <= region.upper[0]; ++p[0]) body(p);
}

/// Values of a Field at the lattice's points in and around a region, and the solid that they show.
class BrickSampler {
 public:
  BrickSampler(const Region& region, const Stock& stock)
      : region_(region), near_(region), stock_(stock), lattice_(stock.lattice()) {
    for (std::size_t a = 0; a < 3; ++a) {
      near_.lower[a] = std::max(0, near_.lower[a] - 1);
      near_.upper[a] = std::min(lattice_.cells()[a], near_.upper[a] + 1);
    }
  }

  std::shared_ptr<Brick> run(const Field& field) {
    const Restriction here = field.restricted({place(near_.lower), place(near_.upper)});
    if (here.range.decided()) return std::make_shared<Brick>(region_, here.range.inside());
    values_.resize(count(0) * count(1) * count(2));
    sample(near_, field.shared_from_this());
    Occupancy solid(region_);
    std::vector<Crossing> crossings;
    for_points(region_, [&](const Index3& p) {
      if (!(value(p) < 0)) return;
      solid.set(p);
      add_crossings(p, crossings);
    });
    locate(crossings, *here.field);
    auto brick = std::make_shared<Brick>(region_, false);
    brick->assign(solid, samples_of(crossings), stock_);
    return brick;
  }

 private:
  [[nodiscard]] Vec3 place(const Index3& p) const {
    return lattice_.box().lower + lattice_.spacing().cwiseProduct(Vec3(p[0], p[1], p[2]));
  }
  [[nodiscard]] std::size_t count(int axis) const { return static_cast<std::size_t>(near_.count(axis)); }
  [[nodiscard]] float& value(const Index3& p) {
    const auto along = [&](std::size_t a) { return static_cast<std::size_t>(p[a] - near_.lower[a]); };
    return values_[(along(2) * count(1) + along(1)) * count(0) + along(0)];
  }

  /// Halves a region while the interval of its points and their neighbours contains both signs.
  void sample(const Region& part, const FieldPtr& from) {
    Index3 low = part.lower, high = part.upper;
    for (std::size_t a = 0; a < 3; ++a) --low[a], ++high[a];
    const Restriction within = from->restricted({place(low), place(high)});
    if (within.range.decided())
      return for_points(part, [&](const Index3& p) { value(p) = within.range.inside() ? -1.0f : 1.0f; });
    std::size_t longest = 0;
    for (std::size_t a = 1; a < 3; ++a)
      if (part.count(static_cast<int>(a)) > part.count(static_cast<int>(longest))) longest = a;
    if (part.count(static_cast<int>(longest)) > 8) {
      std::array<Region, 2> halves{part, part};
      halves[0].upper[longest] = (part.lower[longest] + part.upper[longest]) / 2;
      halves[1].lower[longest] = halves[0].upper[longest] + 1;
      for (const Region& half : halves) sample(half, within.field);
      return;
    }
    Batch points;
    for_points(part, [&](const Index3& p) { points.add(place(p)); });
    points.evaluate(*within.field);
    std::size_t i = 0;
    for_points(part, [&](const Index3& p) { value(p) = points.value[i++]; });
  }

  /// The edges from a point inside to points outside.
  void add_crossings(const Index3& p, std::vector<Crossing>& crossings) {
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Index3 q = p;
        q[static_cast<std::size_t>(axis)] += step;
        if (!near_.contains(q) || value(q) < 0) continue;
        crossings.push_back({p, axis, step, 0, 1, value(p), value(q)});
      }
  }

  /// Plain regula falsi in six rounds, every third by bisection for crossings at which it converges slowly. Separate
  /// from the search in the kernel's contour/edges.cpp: it stores fractions of an edge, and the number of rounds is
  /// fixed.
  void locate(std::vector<Crossing>& crossings, const Field& field) const {
    for (int round = 0; round < 6 && !crossings.empty(); ++round) {
      const bool middle = round % 3 == 2;
      Batch batch;
      for (const Crossing& c : crossings) {
        Vec3 at = place(c.inside);
        at[c.axis] += c.step * lattice_.spacing()[c.axis] * c.share(middle);
        batch.add(at);
      }
      batch.evaluate(field);
      for (std::size_t i = 0; i < crossings.size(); ++i) {
        Crossing& c = crossings[i];
        const double t = c.share(middle);
        if (batch.value[i] < 0)
          c.in = t, c.at_in = batch.value[i];
        else
          c.out = t, c.at_out = batch.value[i];
      }
    }
  }

  [[nodiscard]] SampleMap samples_of(const std::vector<Crossing>& crossings) const {
    SampleMap samples;
    for (const Crossing& c : crossings) {
      Index3 from = c.inside;
      if (c.step < 0) --from[static_cast<std::size_t>(c.axis)];
      const double edges = c.inside[static_cast<std::size_t>(c.axis)] + c.step * c.share(false);
      samples.put(SampleMap::key(from, c.axis, region_), {static_cast<float>(lattice_.spacing()[c.axis] * edges), 0});
    }
    return samples;
  }

  Region region_;
  Region near_;  ///< the region and a point more on each side, within the lattice
  const Stock& stock_;
  const StockLattice& lattice_;
  std::vector<float> values_;  ///< at the points of `near_`
};

}  // namespace

std::shared_ptr<Brick> brick_of(const Field& field, const Region& region, const Stock& stock) {
  return BrickSampler(region, stock).run(field);
}

}  // namespace fieldfab::cam

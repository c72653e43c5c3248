#include "sharpen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "fieldfab/core/parallel.h"
#include "mesh_editor.h"
#include "surface_feature.h"

namespace fieldfab::contouring {
namespace {

/// A point of the mesh that is off the surface: a vertex, the middle of an edge, or the middle of a
/// triangle.
struct Flaw {
  std::array<std::uint32_t, 3> vertices;
  int count;  ///< number of vertices: 1, 2 or 3
  float error;
  /// Cube of space that contains the flaw; the flaws of one cube are mended together.
  std::array<std::int32_t, 3> area;
};

/// Distance of triangles from the surface.
struct Misfit {
  float farthest = 0;  ///< mm
  float squares = 0;   ///< squared distance, summed over area
  [[nodiscard]] bool closer_than(const Misfit& other) const { return squares <= 0.8F * other.squares; }
};

/// A patch to be replaced by a fan around one vertex.
struct Star {
  std::uint32_t vertex;
  std::vector<std::uint32_t> old;  ///< triangles of the patch
  /// Edges around the patch, each in the direction of the triangle inside.
  std::vector<std::array<std::uint32_t, 2>> rim;
};

// Search radii for features, in voxels. A wedge of 30 degrees that is thinner than a voxel
// continues for two.
constexpr std::array near_reaches{0.25F, 0.5F, 1.0F};
constexpr std::array far_reaches{2.0F};
constexpr float area_side = 16;  // in voxels; for a large expression, restriction takes most of the time

class Sharpener {
 public:
  Sharpener(const Field& solid, double voxel, double tolerance, std::span<const std::uint32_t> creased,
            TriangleMesh& mesh, Progress& progress)
      : solid_(solid),
        voxel_(static_cast<float>(voxel)),
        tolerance_(static_cast<float>(tolerance)),
        mesh_(mesh),
        progress_(progress),
        editor_(mesh, creased, 3 * voxel),
        open_(creased.begin(), creased.end()) {}

  void run() {
    constexpr int rounds = 6;
    for (int round = 0; round < rounds && !open_.empty(); ++round) {
      features_only_ = round < rounds / 2;
      if (round == rounds / 2) attempts_.clear();
      const std::vector<Flaw> flaws = find_flaws();
      open_.clear();
      for (std::size_t i = 0; i < flaws.size(); ++i) {
        if (i % 16 == 0) {
          const double done = round + static_cast<double>(i) / static_cast<double>(flaws.size());
          progress_.report(0.95 + 0.05 * done / rounds, "sharpening edges");
          progress_.check();
        }
        mend(flaws[i]);
      }
    }
  }

 private:
  [[nodiscard]] Eigen::Vector3f at(std::uint32_t vertex) const {
    return Eigen::Vector3f(mesh_.vertices[vertex].data());
  }
  [[nodiscard]] Eigen::Vector3f middle(const Flaw& flaw) const {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < flaw.count; ++i) sum += at(flaw.vertices[static_cast<std::size_t>(i)]);
    return sum / static_cast<float>(flaw.count);
  }

  /// Returns the vertices, edges and triangles of the open triangles that are off by more than the
  /// tolerance: vertices first, then edges, then triangles; in each area the largest error first.
  std::vector<Flaw> find_flaws() {
    std::vector<Flaw> places;
    std::sort(open_.begin(), open_.end());
    open_.erase(std::unique(open_.begin(), open_.end()), open_.end());
    for (const std::uint32_t t : open_) {
      const Triangle& v = mesh_.triangles[t];
      places.push_back({v, 3, 0, {}});
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = v[i], b = v[(i + 1) % 3];
        places.push_back({{a, 0, 0}, 1, 0, {}});
        places.push_back({{std::min(a, b), std::max(a, b), 0}, 2, 0, {}});
      }
    }
    const auto order = [](const Flaw& one, const Flaw& other) {
      return one.count != other.count ? one.count < other.count : one.vertices < other.vertices;
    };
    std::sort(places.begin(), places.end(), order);
    places.erase(
        std::unique(places.begin(), places.end(),
                    [&](const Flaw& one, const Flaw& other) { return !order(one, other) && !order(other, one); }),
        places.end());

    constexpr std::size_t chunk = 256;  // close to each other, since their numbers are
    parallel_for((places.size() + chunk - 1) / chunk, [&](std::size_t part) {
      progress_.check();
      Samples samples;
      const std::size_t first = part * chunk, last = std::min(places.size(), first + chunk);
      Box box{middle(places[first]).cast<double>(), middle(places[first]).cast<double>()};
      for (std::size_t i = first; i < last; ++i) {
        samples.add(middle(places[i]));
        box = united(box, middle(places[i]));
      }
      samples.ask(*solid_.restricted(box).field);
      for (std::size_t i = first; i < last; ++i) places[i].error = std::abs(samples.distance(i - first));
    });
    std::erase_if(places, [&](const Flaw& flaw) { return flaw.error <= tolerance_; });
    for (Flaw& flaw : places)
      for (std::size_t axis = 0; axis < 3; ++axis)
        flaw.area[axis] =
            static_cast<std::int32_t>(std::floor(middle(flaw)[static_cast<Eigen::Index>(axis)] / (area_side * voxel_)));
    std::stable_sort(places.begin(), places.end(), [](const Flaw& one, const Flaw& other) {
      if (one.count != other.count) return one.count < other.count;
      return one.area != other.area ? one.area < other.area : one.error > other.error;
    });
    return places;
  }

  /// Restricts the solid to an area and its surroundings.
  void enter(const std::array<std::int32_t, 3>& area) {
    if (area_field_ && area == area_) return;
    area_ = area;
    const double side = static_cast<double>(area_side * voxel_);
    const Vec3 lower = side * Vec3(area[0], area[1], area[2]);
    area_box_ = Box{lower, lower + Vec3::Constant(side)}.grown(side / 2);
    area_field_ = solid_.restricted(area_box_).field;
  }

  static Box united(const Box& box, const Eigen::Vector3f& point) {
    return {box.lower.cwiseMin(point.cast<double>()), box.upper.cwiseMax(point.cast<double>())};
  }

  /// Restricts the solid to everything that mending a flaw may touch: the triangles around it, and
  /// `reach` voxels around those.
  void confine(const Flaw& flaw, float reach) {
    const Vec3 centre = middle(flaw).cast<double>();
    local_box_ = {centre, centre};
    for (int i = 0; i < flaw.count; ++i)
      for (const std::uint32_t t : editor_.fan(flaw.vertices[static_cast<std::size_t>(i)]))
        for (const std::uint32_t vertex : mesh_.triangles[t]) local_box_ = united(local_box_, at(vertex));
    local_box_ = local_box_.grown(1.1 * static_cast<double>(reach * voxel_));
    const bool within = area_box_.contains(local_box_.lower) && area_box_.contains(local_box_.upper);
    local_ = (within ? *area_field_ : solid_).restricted(local_box_).field;
  }

  static std::uint64_t key_of(const Flaw& flaw) {
    std::uint64_t key = static_cast<std::uint64_t>(flaw.count);
    for (const std::uint32_t vertex : flaw.vertices) key = (key ^ vertex) * 0x9e3779b97f4a7c15U;
    return key;
  }

  void mend(const Flaw& flaw) {
    enter(flaw.area);
    local_ = area_field_;
    if (error_at(middle(flaw)) <= tolerance_) return;  // mended with another
    constexpr int most_attempts = 1;
    if (++attempts_[key_of(flaw)] > most_attempts) return;
    confine(flaw, near_reaches.back());
    if (flaw.count == 1) {
      move(flaw);
    } else if (flaw.count == 2) {
      if (!flip(flaw)) divide_edge(flaw);
    } else {
      divide_triangle(flaw);
    }
  }

  void move(const Flaw& flaw) {
    const std::uint32_t vertex = flaw.vertices[0];
    const auto fan = editor_.fan(vertex);
    if (fan.empty()) return;
    Star star{vertex, {fan.begin(), fan.end()}, {}};
    for (const std::uint32_t t : fan) {
      const Triangle& v = mesh_.triangles[t];
      const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
      star.rim.push_back({v[(i + 1) % 3], v[(i + 2) % 3]});
    }
    place(star, flaw);
  }

  /// Builds the star's triangles with its vertex on the sharpest feature near the flaw for which
  /// they are valid.
  bool place(const Star& star, const Flaw& flaw) {
    const Eigen::Vector3f centre = middle(flaw);
    const Position start = mesh_.vertices[star.vertex];
    const Misfit before = misfit(triangles(star.old));
    if (place_within(star, centre, before, near_reaches)) return true;
    mesh_.vertices[star.vertex] = start;
    confine(flaw, far_reaches.back());
    if (place_within(star, centre, before, far_reaches)) return true;
    mesh_.vertices[star.vertex] = start;
    return false;
  }

  template <std::size_t count>
  bool place_within(const Star& star, const Eigen::Vector3f& centre, const Misfit& before,
                    std::array<float, count> reaches) {
    for (float& reach : reaches) reach *= voxel_;
    constexpr int most_tries = 2;
    int tries = 0;
    const std::vector<PlacedVertex> features = features_near(*local_, local_box_, centre, reaches, scratch_);
    for (std::size_t r = 0; r < count && tries < most_tries; ++r) {
      PlacedVertex target = features[r];
      const bool sharp = target.directions > 1;
      if (features_only_ && !sharp) continue;
      // Found from tangent planes up to `reach` away; a curved crease is located better from nearer
      // planes.
      if (sharp) {
        const std::array closer_by{0.25F * reaches[r]};
        const PlacedVertex closer =
            features_near(*local_, local_box_, target.position.cast<float>(), closer_by, scratch_).front();
        if (closer.directions > 1) target = closer;
        ++tries;
      }
      const Eigen::Vector3f position = target.position.cast<float>();
      if (!local_box_.contains(target.position)) continue;
      mesh_.vertices[star.vertex] = {position.x(), position.y(), position.z()};
      if (span(star, before)) return true;
    }
    return false;
  }

  /// Replaces the star's old triangles by those between its rim and its vertex. If one would be
  /// folded over, the rim is moved past the triangle beyond; this equals flipping that edge first.
  bool span(Star star, Misfit before) {
    const bool on_surface = error_at(at(star.vertex)) < 0.5F * tolerance_;
    constexpr int greatest_growth = 3;
    for (int growth = 0; growth <= greatest_growth; ++growth) {
      std::vector<Triangle> fresh;
      fresh.reserve(star.rim.size());
      for (const auto& [a, b] : star.rim) fresh.push_back({a, b, star.vertex});
      const Misfit after = misfit(fresh);
      std::vector<std::size_t> folded;
      for (std::size_t i = 0; i < fresh.size(); ++i)
        if (!faces_out(i, fresh[i])) folded.push_back(i);
      if (folded.empty())
        return (after.closer_than(before) || (on_surface && after.farthest < 1.02F * before.farthest)) &&
               commit(star.old, fresh);
      for (const std::size_t i : folded)
        if (!grow(star, i, before)) return false;
    }
    return false;
  }

  /// Adds the triangle beyond one edge of the rim to the star.
  bool grow(Star& star, std::size_t edge, Misfit& before) {
    const auto [a, b] = star.rim[edge];
    std::array<std::uint32_t, 2> sides{};
    if (!editor_.sides(a, b, sides)) return false;
    const auto is_old = [&](std::uint32_t t) {
      return std::find(star.old.begin(), star.old.end(), t) != star.old.end();
    };
    if (is_old(sides[0]) == is_old(sides[1])) return false;
    const std::uint32_t beyond = is_old(sides[0]) ? sides[1] : sides[0];
    const std::uint32_t corner = opposite(beyond, a, b);
    if (std::any_of(star.rim.begin(), star.rim.end(), [&](const auto& other) { return other[0] == corner; }))
      return false;
    if (!local_box_.contains(at(corner).cast<double>())) return false;
    const Misfit added = misfit({&mesh_.triangles[beyond], 1});
    before = {std::max(before.farthest, added.farthest), before.squares + added.squares};
    star.old.push_back(beyond);
    star.rim[edge] = {a, corner};
    star.rim.push_back({corner, b});
    return true;
  }

  bool flip(const Flaw& flaw) {
    Diamond diamond;
    if (!find_diamond(flaw, diamond)) return false;
    const auto [old, from, to, one, other] = diamond;
    const Misfit before = misfit(triangles(old));
    const std::array<Triangle, 2> fresh{{{one, other, to}, {other, one, from}}};
    return misfit(fresh).closer_than(before) && faces_out(0, fresh[0]) && faces_out(1, fresh[1]) && commit(old, fresh);
  }

  void divide_edge(const Flaw& flaw) {
    Diamond diamond;
    if (!find_diamond(flaw, diamond)) return;
    const auto [old, from, to, one, other] = diamond;
    divide(flaw, {0, {old[0], old[1]}, {{one, from}, {to, one}, {other, to}, {from, other}}});
  }

  void divide_triangle(const Flaw& flaw) {
    const auto [a, b, c] = flaw.vertices;
    for (const std::uint32_t t : editor_.fan(a)) {
      if (mesh_.triangles[t] != flaw.vertices) continue;
      divide(flaw, {0, {t}, {{a, b}, {b, c}, {c, a}}});
      return;
    }
  }

  /// Gives the star a new vertex on the feature that the flaw misses.
  void divide(const Flaw& flaw, Star star) {
    const Eigen::Vector3f centre = middle(flaw);
    star.vertex = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back({centre.x(), centre.y(), centre.z()});
    if (!place(star, flaw)) mesh_.vertices.pop_back();
  }

  /// The two triangles at an edge.
  struct Diamond {
    std::array<std::uint32_t, 2> sides;
    std::uint32_t from, to;    ///< the edge, in the direction of the first triangle
    std::uint32_t one, other;  ///< the opposite vertices
  };
  bool find_diamond(const Flaw& edge, Diamond& diamond) const {
    const auto [a, b, unused] = edge.vertices;
    if (!editor_.sides(a, b, diamond.sides)) return false;
    diamond.one = opposite(diamond.sides[0], a, b);
    diamond.other = opposite(diamond.sides[1], a, b);
    const Triangle& first = mesh_.triangles[diamond.sides[0]];
    const auto i = static_cast<std::size_t>(std::find(first.begin(), first.end(), diamond.one) - first.begin());
    diamond.from = first[(i + 1) % 3];
    diamond.to = first[(i + 2) % 3];
    return diamond.one != diamond.other;
  }

  [[nodiscard]] std::uint32_t opposite(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const {
    const Triangle& v = mesh_.triangles[triangle];
    return *std::find_if(v.begin(), v.end(), [&](std::uint32_t vertex) { return vertex != a && vertex != b; });
  }

  [[nodiscard]] std::vector<Triangle> triangles(std::span<const std::uint32_t> numbers) const {
    std::vector<Triangle> found;
    for (const std::uint32_t t : numbers) found.push_back(mesh_.triangles[t]);
    return found;
  }

  void sample(std::span<const Triangle> triangles) {
    scratch_.clear();
    for (const Triangle& v : triangles) {
      const Eigen::Vector3f a = at(v[0]), b = at(v[1]), c = at(v[2]);
      scratch_.add((a + b + c) / 3.0F);
      for (const Eigen::Vector3f& p :
           {a, b, c, Eigen::Vector3f(0.5F * (a + b)), Eigen::Vector3f(0.5F * (b + c)), Eigen::Vector3f(0.5F * (c + a))})
        scratch_.add(p);
    }
    scratch_.ask(*local_);
  }
  static constexpr std::size_t samples_a_triangle = 7;

  Misfit misfit(std::span<const Triangle> triangles) {
    sample(triangles);
    Misfit misfit;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      const Triangle& v = triangles[i];
      float squares = 0;
      for (std::size_t j = samples_a_triangle * i; j < samples_a_triangle * (i + 1); ++j) {
        const float distance = scratch_.distance(j);
        squares += distance * distance;
        misfit.farthest = std::max(misfit.farthest, std::abs(distance));
      }
      misfit.squares += squares * (at(v[1]) - at(v[0])).cross(at(v[2]) - at(v[0])).norm();
    }
    return misfit;
  }

  float error_at(const Eigen::Vector3f& point) {
    scratch_.clear();
    scratch_.add(point);
    scratch_.ask(*local_);
    return std::abs(scratch_.distance(0));
  }

  /// Whether a triangle, number `i` of the last call of misfit(), is neither folded over nor
  /// degenerate.
  [[nodiscard]] bool faces_out(std::size_t i, const Triangle& v) const {
    const Eigen::Vector3f normal = (at(v[1]) - at(v[0])).cross(at(v[2]) - at(v[0]));
    const float area = normal.norm();
    if (area < 1e-6F * voxel_ * voxel_) return false;
    for (std::size_t j = samples_a_triangle * i; j < samples_a_triangle * (i + 1); ++j)
      if (normal.dot(scratch_.slope(j)) > 0.1F * area * scratch_.slope(j).norm()) return true;
    return false;
  }

  bool commit(std::span<const std::uint32_t> old, std::span<const Triangle> fresh) {
    if (!editor_.replace(old, fresh)) return false;
    for (const Triangle& triangle : fresh)
      for (const std::uint32_t vertex : triangle) {
        const auto fan = editor_.fan(vertex);
        open_.insert(open_.end(), fan.begin(), fan.end());
      }
    return true;
  }

  const Field& solid_;
  const float voxel_, tolerance_;
  TriangleMesh& mesh_;
  Progress& progress_;
  MeshEditor editor_;
  std::vector<std::uint32_t> open_;  ///< triangles still to be examined
  FieldPtr local_;                   ///< the solid inside `local_box_`, the neighbourhood() of the current flaw
  Box local_box_;
  std::array<std::int32_t, 3> area_{};  ///< the area that was entered last
  Box area_box_;
  FieldPtr area_field_;
  std::unordered_map<std::uint64_t, int> attempts_;  ///< by flaw: number of failures, so that it is not tried forever
  bool features_only_ = true;                        ///< smooth surfaces near a crease wait until it is done
  Samples scratch_;
};

}  // namespace

void sharpen(const Field& solid, double voxel, double tolerance, std::span<const std::uint32_t> creased,
             TriangleMesh& mesh, Progress& progress) {
  if (!creased.empty()) Sharpener(solid, voxel, tolerance, creased, mesh, progress).run();
}

}  // namespace fieldfab::contouring

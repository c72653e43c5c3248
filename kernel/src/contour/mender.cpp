#include "mender.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace fieldfab::contouring {
namespace {

// Search radii for features, in voxels. A wedge of 30 degrees that is thinner than a voxel
// continues for two.
constexpr std::array near_reaches{0.25F, 0.5F, 1.0F};
constexpr float far_reach = 2;

// Features are searched far away only where the surface turns by more than this, because only
// wedges and needles are thin.
constexpr float thin_cosine = 0.2F;

constexpr std::size_t samples_a_triangle = 7;

bool is_sharp(const PlacedVertex& feature) { return feature.directions > 1; }
bool is_corner(const PlacedVertex& feature) { return feature.directions > 2; }

Box united(const Box& box, const Eigen::Vector3f& point) {
  return {box.lower.cwiseMin(point.cast<double>()), box.upper.cwiseMax(point.cast<double>())};
}

}  // namespace

Eigen::Vector3f Draft::middle(const Flaw& flaw) const {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int i = 0; i < flaw.count; ++i) sum += at(flaw.vertices[static_cast<std::size_t>(i)]);
  return sum / static_cast<float>(flaw.count);
}

std::size_t Surroundings::cost() const {
  std::size_t sum = field->cost();
  for (const auto& [cell, block] : blocks) sum += block.field->cost();
  return sum;
}

/// Restricts the solid to everything that mending a flaw may touch: the triangles around it, and
/// `reach` voxels around those.
void Mender::confine(const Flaw& flaw, float reach) {
  const Vec3 centre = draft_.middle(flaw).cast<double>();
  local_box_ = {centre, centre};
  for (int i = 0; i < flaw.count; ++i)
    for (const std::uint32_t t : draft_.editor.fan(flaw.vertices[static_cast<std::size_t>(i)]))
      for (const std::uint32_t vertex : draft_.mesh.triangles[t]) local_box_ = united(local_box_, draft_.at(vertex));
  local_box_ = local_box_.grown(1.1 * static_cast<double>(reach * draft_.voxel));
  const auto holds = [&](const Box& box) { return box.contains(local_box_.lower) && box.contains(local_box_.upper); };
  const Surroundings::Block& block = block_of(flaw.cell);
  local_ = (holds(block.box)           ? *block.field
            : holds(surroundings_.box) ? *surroundings_.field
                                       : draft_.solid)
               .restricted(local_box_, Purpose::occupancy)
               .field;
}

/// Returns the solid in two cells along each axis and one cell around them; all are in the region.
const Surroundings::Block& Mender::block_of(const Cell& cell) {
  Cell lower = cell;
  for (std::int64_t& place : lower) place &= ~std::int64_t{1};
  Surroundings::Block& block = surroundings_.blocks[lower];
  if (!block.field) {
    MeshEditor::Region region{lower, lower, {}, {}, {}};
    for (std::size_t i = 0; i < 3; ++i) region.lower[i] -= 1, region.upper[i] += 3;
    block.box = draft_.editor.extent(region);
    block.field = surroundings_.field->restricted(block.box, Purpose::occupancy).field;
  }
  return block;
}

bool Mender::mend(const Flaw& flaw) {
  const std::span corners(flaw.vertices.data(), static_cast<std::size_t>(flaw.count));
  const bool moved =
      std::any_of(corners.begin(), corners.end(), [&](auto vertex) { return draft_.moved[vertex] != 0; });
  Diamond diamond{};
  Star star{};
  if (flaw.count == 2) {
    if (!find_diamond(flaw, diamond)) return !moved;
    const auto& [old, from, to, one, other] = diamond;
    star = {0, {old[0], old[1]}, {{one, from}, {to, one}, {other, to}, {from, other}}, {}};
  } else if (flaw.count == 3) {
    const auto [a, b, c] = flaw.vertices;
    for (const std::uint32_t t : draft_.editor.fan(a))
      if (draft_.mesh.triangles[t] == flaw.vertices) star = {0, {t}, {{a, b}, {b, c}, {c, a}}, {}};
    if (star.old.empty()) return !moved;
  }
  confine(flaw, near_reaches.back());
  if (moved && error_at(draft_.middle(flaw)) <= draft_.tolerance) return false;
  if (flaw.count == 1) {
    move(flaw);
    return true;
  }
  Misfit before;
  if (flaw.count == 3)
    before = misfit(triangles(star.old));
  else if (flip(diamond, before))
    return true;
  divide(flaw, star, before);
  return true;
}

void Mender::move(const Flaw& flaw) {
  const std::uint32_t vertex = flaw.vertices[0];
  const auto fan = draft_.editor.fan(vertex);
  if (fan.empty()) return;
  Star star{vertex, {fan.begin(), fan.end()}, {}, {vertex, draft_.mesh.vertices[vertex]}};
  for (const std::uint32_t t : fan) {
    const Triangle& v = draft_.mesh.triangles[t];
    const auto i = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
    star.rim.push_back({v[(i + 1) % 3], v[(i + 2) % 3]});
  }
  if (place(star, flaw, misfit(triangles(star.old)))) draft_.moved[vertex] = 1;
}

/// Gives the star a new vertex on the feature that the flaw misses.
void Mender::divide(const Flaw& flaw, Star star, const Misfit& before) {
  const Eigen::Vector3f centre = draft_.middle(flaw);
  star.vertex = region_.spare_vertices.back();
  draft_.mesh.vertices[star.vertex] = {centre.x(), centre.y(), centre.z()};
  if (place(star, flaw, before)) region_.spare_vertices.pop_back();
}

/// Builds the star's triangles with its vertex on the sharpest feature near the flaw for which
/// they are valid.
bool Mender::place(const Star& star, const Flaw& flaw, const Misfit& before) {
  const Eigen::Vector3f centre = draft_.middle(flaw);
  Position& position = draft_.mesh.vertices[star.vertex];
  const Position start = position;
  constexpr int most_tries = 2;
  int tries = 0;
  bool thin = false;
  for (const float voxels : near_reaches) {
    // The last search also tells whether to look farther away.
    const bool last = voxels == near_reaches.back();
    if (tries == most_tries && !last) continue;
    const float reach = voxels * draft_.voxel;
    const PlacedVertex feature = feature_near(*local_, local_box_, centre, reach, search_);
    if (last) thin = search_.least_cosine() < thin_cosine;
    if (tries == most_tries) break;
    if (place_on(star, feature, reach, before)) return true;
    if (is_sharp(feature)) ++tries;
  }
  if (thin) {
    position = start;
    confine(flaw, far_reach);
    const float reach = far_reach * draft_.voxel;
    if (place_on(star, feature_near(*local_, local_box_, centre, reach, search_), reach, before)) return true;
  }
  position = start;
  return false;
}

/// Builds the star's triangles with its vertex on a feature that was found up to `reach` mm away.
bool Mender::place_on(const Star& star, PlacedVertex target, float reach, const Misfit& before) {
  if (draft_.features_only && !is_sharp(target)) return false;
  // A curved crease is located better from nearer planes, and a corner of curved faces from still nearer ones: it is to
  // lie on flat faces exactly.
  for (int round = 0; is_sharp(target) && round < (is_corner(target) ? 3 : 1); ++round) {
    reach *= 0.25F;
    const PlacedVertex closer = feature_near(*local_, local_box_, target.position.cast<float>(), reach, search_);
    if (!is_sharp(closer)) break;
    const double moved = (closer.position - target.position).norm();
    target = closer;
    if (moved < static_cast<double>(draft_.tolerance)) break;
  }
  if (!local_box_.contains(target.position)) return false;
  const Eigen::Vector3f position = target.position.cast<float>();
  draft_.mesh.vertices[star.vertex] = {position.x(), position.y(), position.z()};
  return span(star, before);
}

/// Replaces the star's old triangles by those between its rim and its vertex. If one would be
/// folded over, the rim is moved past the triangle beyond; this equals flipping that edge first.
bool Mender::span(Star star, Misfit before) {
  constexpr int greatest_growth = 3;
  for (int growth = 0; growth <= greatest_growth; ++growth) {
    std::vector<Triangle> fresh;
    fresh.reserve(star.rim.size());
    for (const auto& [a, b] : star.rim) fresh.push_back({a, b, star.vertex});
    const Misfit after = misfit(fresh);
    std::vector<std::size_t> folded;
    for (std::size_t i = 0; i < fresh.size(); ++i)
      if (!faces_out(i, fresh[i])) folded.push_back(i);
    if (folded.empty()) {
      constexpr std::size_t at_the_vertex = 3;  // the sample at the last vertex of the first triangle
      const bool on_surface = std::abs(scratch_.distance(at_the_vertex)) < 0.5F * draft_.tolerance;
      return (after.closer_than(before) || (on_surface && after.farthest < 1.02F * before.farthest)) &&
             !is_near_another(star) && draft_.editor.replace(region_, star.old, fresh, star.displaced, made);
    }
    for (const std::size_t i : folded)
      if (!grow(star, i)) return false;
    const Misfit added = misfit(triangles(std::span(star.old).last(folded.size())));
    before = {std::max(before.farthest, added.farthest), before.squares + added.squares};
  }
  return false;
}

/// Whether the star's vertex is as near to another, on its rim or a triangle beyond, as no vertices on an edge of the
/// lattice are. Then that one is on the feature already; programs that join near vertices would tear the mesh there.
bool Mender::is_near_another(const Star& star) const {
  const Eigen::Vector3f place = draft_.at(star.vertex);
  const float least = draft_.voxel / 2048;
  const auto is_near = [&](std::uint32_t vertex) {
    return vertex != star.vertex && (draft_.at(vertex) - place).norm() < least;
  };
  return std::any_of(star.rim.begin(), star.rim.end(), [&](const auto& edge) {
    if (is_near(edge[0])) return true;
    if (!draft_.editor.holds_fan(region_, edge[0])) return false;  // others may change it
    const auto fan = draft_.editor.fan(edge[0]);
    return std::any_of(fan.begin(), fan.end(), [&](std::uint32_t t) {
      const Triangle& beyond = draft_.mesh.triangles[t];
      return std::any_of(beyond.begin(), beyond.end(), is_near);
    });
  });
}

/// Adds the triangle beyond one edge of the rim to the star.
bool Mender::grow(Star& star, std::size_t edge) {
  const auto [a, b] = star.rim[edge];
  std::array<std::uint32_t, 2> sides{};
  if (!draft_.editor.sides(a, b, sides)) return false;
  const auto is_old = [&](std::uint32_t t) { return std::find(star.old.begin(), star.old.end(), t) != star.old.end(); };
  if (is_old(sides[0]) == is_old(sides[1])) return false;
  const std::uint32_t beyond = is_old(sides[0]) ? sides[1] : sides[0];
  const std::uint32_t corner = opposite(beyond, a, b);
  if (std::any_of(star.rim.begin(), star.rim.end(), [&](const auto& other) { return other[0] == corner; }))
    return false;
  // Beyond the region others may change what this would read next, and no change would be accepted.
  if (!draft_.editor.holds(region_, corner) || !local_box_.contains(draft_.at(corner).cast<double>())) return false;
  star.old.push_back(beyond);
  star.rim[edge] = {a, corner};
  star.rim.push_back({corner, b});
  return true;
}

bool Mender::flip(const Diamond& diamond, Misfit& before) {
  const auto& [old, from, to, one, other] = diamond;
  const std::array<Triangle, 2> fresh{{{one, other, to}, {other, one, from}}};
  const std::array both{draft_.mesh.triangles[old[0]], draft_.mesh.triangles[old[1]], fresh[0], fresh[1]};
  measure(both);
  before = misfit(both, 0, 2);
  return misfit(both, 2, 2).closer_than(before) && faces_out(2, fresh[0]) && faces_out(3, fresh[1]) &&
         draft_.editor.replace(region_, old, fresh, {}, made);
}

bool Mender::find_diamond(const Flaw& edge, Diamond& diamond) const {
  const auto [a, b, unused] = edge.vertices;
  if (!draft_.editor.sides(a, b, diamond.sides)) return false;
  diamond.one = opposite(diamond.sides[0], a, b);
  diamond.other = opposite(diamond.sides[1], a, b);
  const Triangle& first = draft_.mesh.triangles[diamond.sides[0]];
  const auto i = static_cast<std::size_t>(std::find(first.begin(), first.end(), diamond.one) - first.begin());
  diamond.from = first[(i + 1) % 3];
  diamond.to = first[(i + 2) % 3];
  return diamond.one != diamond.other;
}

std::uint32_t Mender::opposite(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const {
  const Triangle& v = draft_.mesh.triangles[triangle];
  return *std::find_if(v.begin(), v.end(), [&](std::uint32_t vertex) { return vertex != a && vertex != b; });
}

std::vector<Triangle> Mender::triangles(std::span<const std::uint32_t> numbers) const {
  std::vector<Triangle> found;
  for (const std::uint32_t t : numbers) found.push_back(draft_.mesh.triangles[t]);
  return found;
}

/// Evaluates the solid at samples of triangles.
void Mender::measure(std::span<const Triangle> triangles) {
  scratch_.clear();
  for (const Triangle& v : triangles) {
    const Eigen::Vector3f a = draft_.at(v[0]), b = draft_.at(v[1]), c = draft_.at(v[2]);
    scratch_.add((a + b + c) / 3.0F);
    for (const Eigen::Vector3f& p :
         {a, b, c, Eigen::Vector3f(0.5F * (a + b)), Eigen::Vector3f(0.5F * (b + c)), Eigen::Vector3f(0.5F * (c + a))})
      scratch_.add(p);
  }
  scratch_.ask(*local_);
}

/// Returns the misfit of `count` triangles from number `first` on, of those that were measured.
Mender::Misfit Mender::misfit(std::span<const Triangle> measured, std::size_t first, std::size_t count) const {
  Misfit misfit;
  for (std::size_t i = first; i < first + count; ++i) {
    const Triangle& v = measured[i];
    float squares = 0;
    for (std::size_t j = samples_a_triangle * i; j < samples_a_triangle * (i + 1); ++j) {
      const float distance = scratch_.distance(j);
      squares += distance * distance;
      misfit.farthest = std::max(misfit.farthest, std::abs(distance));
    }
    misfit.squares += squares * (draft_.at(v[1]) - draft_.at(v[0])).cross(draft_.at(v[2]) - draft_.at(v[0])).norm();
  }
  return misfit;
}

Mender::Misfit Mender::misfit(std::span<const Triangle> triangles) {
  measure(triangles);
  return misfit(triangles, 0, triangles.size());
}

float Mender::error_at(const Eigen::Vector3f& point) {
  scratch_.clear();
  scratch_.add(point);
  scratch_.ask(*local_);
  return std::abs(scratch_.distance(0));
}

/// Whether a triangle, number `i` of the last call of measure(), is neither folded over nor
/// degenerate.
bool Mender::faces_out(std::size_t i, const Triangle& triangle) const {
  const Eigen::Vector3f normal =
      (draft_.at(triangle[1]) - draft_.at(triangle[0])).cross(draft_.at(triangle[2]) - draft_.at(triangle[0]));
  const float area = normal.norm();
  if (area < 1e-6F * draft_.voxel * draft_.voxel) return false;
  for (std::size_t j = samples_a_triangle * i; j < samples_a_triangle * (i + 1); ++j)
    if (normal.dot(scratch_.slope(j)) > 0.1F * area * scratch_.slope(j).norm()) return true;
  return false;
}

}  // namespace fieldfab::contouring

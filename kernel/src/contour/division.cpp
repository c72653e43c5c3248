#include "division.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <utility>

#include "edges.h"

namespace fieldfab::contouring {
namespace {

constexpr std::array<unsigned, 3> corner_stride{1, 3, 9};

/// The 3x3 signs on one face: bit u + 3 v, with u and v the next axes after `axis`.
unsigned face_of(unsigned inside, unsigned axis, bool upper) {
  const unsigned u = corner_stride[(axis + 1) % 3], v = corner_stride[(axis + 2) % 3],
                 base = upper ? 2 * corner_stride[axis] : 0;
  unsigned face = 0;
  for (unsigned j = 0; j < 3; ++j)
    for (unsigned i = 0; i < 3; ++i) face |= (inside >> (base + i * u + j * v) & 1U) << (i + 3 * j);
  return face;
}

}  // namespace

void BlockRefiner::add_unclear(std::vector<UnclearCell> cells) {
  unclear_ = std::move(cells);
  give_up([](const UnclearCell& cell) { return cell.field == nullptr; });
}

void BlockRefiner::give_up(bool (*which)(const UnclearCell&)) {
  const auto left =
      std::stable_partition(unclear_.begin(), unclear_.end(), [&](const UnclearCell& cell) { return !which(cell); });
  for (auto cell = left; cell != unclear_.end(); ++cell)
    given_up_.push_back({cell->lower, cell->level, nullptr, false});
  unclear_.erase(left, unclear_.end());
}

void BlockRefiner::advance() {
  std::vector<UnclearCell> parts;
  std::map<std::pair<const Field*, LatticePoint>, Examined> examined;  // by Field and place along the axes it reads
  for (const UnclearCell& cell : unclear_) {
    const std::uint32_t number = make(cell.lower, cell.level);
    const unsigned unread = cell.field->unread_axes();
    LatticePoint place = cell.lower;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((unread >> axis & 1U) != 0) place[axis] = 0;
    const auto [found, is_first] =
        examined.try_emplace({cell.field.get(), place}, Examined{cell.lower, parts.size(), 0});
    Examined& alike = found->second;
    if (is_first) {
      examine_parts(cell, divisions_[number], parts);
      alike.last = parts.size();
    } else {
      append_moved(parts, alike.first, alike.last,
                   moved(cell.lower, -alike.lower[0], -alike.lower[1], -alike.lower[2]));
    }
  }
  unclear_ = std::move(parts);
}

/// Appends the unclear parts of a cell that was halved last. Those beside each other along axes that the Field does not
/// read are alike, and share their Field.
void BlockRefiner::examine_parts(const UnclearCell& cell, const Division& division, std::vector<UnclearCell>& parts) {
  const unsigned unread = cell.field->unread_axes();
  const int level = division.level;
  std::array<unsigned, 8> child;
  std::array<Box, 8> boxes;
  std::array<Restriction, 8> here;
  std::size_t count = 0;
  for (unsigned which = 0; which < 8; ++which) {
    if ((which & unread) != 0) continue;
    child[count] = which;
    boxes[count++] =
        lattice_.cube(child_of(cell.lower, which, level), level).grown(sheet_overlap * lattice_.side(level));
  }
  cell.field->restrict_all({boxes.data(), count}, Purpose::occupancy, here);
  const std::size_t first = parts.size();
  for (std::size_t i = 0; i < count; ++i)
    if (!here[i].range.decided()) examine_part(division, child[i], boxes[i], std::move(here[i].field), parts);
  const std::size_t last = parts.size();
  for (unsigned beside = 1; beside < 8; ++beside)
    if ((beside & ~unread) == 0) append_moved(parts, first, last, child_of({}, beside, level));
}

void BlockRefiner::examine_part(const Division& division, unsigned child, const Box& box, FieldPtr field,
                                std::vector<UnclearCell>& parts) {
  if (field->affine()) return;
  const int level = division.level, halvings = lattice_.voxel_level() - level;
  const LatticePoint lower = child_of(division.lower, child, level);
  const std::uint8_t corners = division.corners(child);
  const bool ambiguous = !is_uniform(corners) && !is_simple(corners);
  const auto give_up = [&] { given_up_.push_back({lower, level, nullptr, false}); };
  if (field->smooth()) {
    if (!field->corners_tell(lattice_.cube(lower, level))) return give_up();
    if (ambiguous) parts.push_back({lower, level, std::move(field), true});
    return;
  }
  static thread_local std::vector<Eigen::Vector3f> normals;
  normals.clear();
  for (const Crossing& crossing : division.crossings)
    if (box.contains(crossing.point.position.cast<double>())) add_normal(crossing.point, normals);
  const SurfaceProof proof = prove_sheet(*field, box, normals, lattice_.side(level), halvings);
  if (proof.one_sheet || proof.empty) return;
  if (field->faceted() && !proof.folded && !is_uniform(corners) && !ambiguous) return give_up();
  const SurfaceProof closer = field->faceted() ? proof : prove_sheet_by_parts(*field, box, normals, halvings, 0);
  if (!closer.one_sheet) parts.push_back({lower, level, std::move(field), closer.folded || ambiguous});
}

void BlockRefiner::divide(const DivisionRequest& request, int finest) {
  for (;;) {
    const Place place = place_of(request.lower, request.level);
    if (*place.division != Division::none || (request.only_ambiguous && !is_ambiguous(place))) return;
    const std::uint32_t made = make(place.lower, place.level);
    divide_ambiguous(made, finest);
    if (place.level == request.level) return;
  }
}

void BlockRefiner::divide_ambiguous(std::uint32_t division, int finest) {
  for (unsigned child = 0; child < 8; ++child) {
    const int level = divisions_[division].level;
    const std::uint8_t corners = divisions_[division].corners(child);
    if (level <= finest || is_uniform(corners) || is_simple(corners)) continue;
    const LatticePoint lower = child_of(divisions_[division].lower, child, level);
    if (divisions_[division].parts[child] == Division::none) divide({block_, lower, level, false}, finest);
  }
}

/// Whether the corners of a cell show several patches, or a face that could be joined in two ways.
bool BlockRefiner::is_ambiguous(const Place& place) const {
  std::array<float, 8> x, y, z, value;
  const Box cell = lattice_.cube(place.lower, place.level);
  for (unsigned i = 0; i < 8; ++i) {
    x[i] = static_cast<float>((i & 1U) != 0 ? cell.upper.x() : cell.lower.x());
    y[i] = static_cast<float>((i & 2U) != 0 ? cell.upper.y() : cell.lower.y());
    z[i] = static_cast<float>((i & 4U) != 0 ? cell.upper.z() : cell.lower.z());
  }
  field_->values({x.data(), y.data(), z.data(), 8}, value.data());
  unsigned corners = 0;
  for (unsigned i = 0; i < 8; ++i) corners |= static_cast<unsigned>(value[i] < 0) << i;
  const auto signs = static_cast<std::uint8_t>(corners);
  return !is_uniform(signs) && !is_simple(signs);
}

/// The smallest cell that holds the one given, or that one itself; and where its division is kept.
BlockRefiner::Place BlockRefiner::place_of(const LatticePoint& lower, int level) {
  if (division_of_.empty()) division_of_.assign(block_side * block_side * block_side, Division::none);
  const int voxel_level = lattice_.voxel_level();
  std::array<int, 3> at{};
  Place place{nullptr, {}, voxel_level};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = (lower[axis] - block_[axis]) >> voxel_level;
    place.lower[axis] = block_[axis] + (at[axis] << voxel_level);
  }
  place.division = &division_of_[Block::cell(at[0], at[1], at[2])];
  while (place.level > level && *place.division != Division::none) {
    Division& division = divisions_[*place.division];
    place.level = division.level;
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
      child |= static_cast<unsigned>((lower[axis] - division.lower[axis]) >> division.level) << axis;
    place.lower = child_of(division.lower, child, division.level);
    place.division = &division.parts[child];
  }
  return place;
}

/// Neighbours find the same crossings on their common edges, since all ask for the solid's own values.
std::uint32_t BlockRefiner::make(const LatticePoint& lower, int level) {
  const FieldPtr solid = field_->restricted(lattice_.cube(lower, level)).field;
  const auto number = static_cast<std::uint32_t>(divisions_.size());
  *place_of(lower, level).division = number;
  Division division{lower, level - 1};
  std::array<std::array<float, 3>, 3> plane;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 3; ++i)
      plane[static_cast<std::size_t>(axis)][static_cast<std::size_t>(i)] =
          static_cast<float>(lattice_.plane(axis, lower[static_cast<std::size_t>(axis)] + (i << division.level)));
  std::array<float, 27> x, y, z, value;
  for (std::size_t i = 0; i < 27; ++i) x[i] = plane[0][i % 3], y[i] = plane[1][i / 3 % 3], z[i] = plane[2][i / 9];
  solid->values({x.data(), y.data(), z.data(), 27}, value.data());
  for (unsigned i = 0; i < 27; ++i) division.inside |= static_cast<unsigned>(value[i] < 0) << i;

  static thread_local std::vector<CrossedEdge> edges;
  static thread_local std::vector<SurfacePoint> points;
  edges.clear();
  std::size_t changes = 0;
  for (const unsigned step : corner_stride)
    changes += static_cast<std::size_t>(std::popcount(division.inside ^ division.inside >> step));
  division.crossings.reserve(changes);  // more than there are, since rows run into each other
  for (unsigned axis = 0; axis < 3; ++axis)
    for (unsigned i = 0; i < 27; ++i) {
      const unsigned next = i + corner_stride[axis];
      if (i / corner_stride[axis] % 3 == 2 || (division.inside >> i & 1U) == (division.inside >> next & 1U)) continue;
      division.crossings.push_back(
          {static_cast<std::uint8_t>(axis),
           {static_cast<std::uint8_t>(i % 3), static_cast<std::uint8_t>(i / 3 % 3), static_cast<std::uint8_t>(i / 9)},
           (division.inside >> i & 1U) != 0,
           {}});
      edges.push_back({static_cast<int>(axis),
                       {x[i], y[i], z[i]},
                       plane[axis][i / corner_stride[axis] % 3 + 1],
                       value[i],
                       value[next]});
    }
  locate_crossings(*solid, edges, lattice_.side(division.level), static_cast<float>(lattice_.float_step()), points);
  for (std::size_t i = 0; i < points.size(); ++i) division.crossings[i].point = points[i];
  divisions_.push_back(std::move(division));
  return number;
}

void BlockRefiner::collect_requests(std::vector<DivisionRequest>& requests) {
  for (; requested_ < divisions_.size(); ++requested_) {
    const Division& division = divisions_[requested_];
    const int level = division.level + 1, side = 1 << level;
    if (division.inside == 0 || division.inside == (1U << 27) - 1) continue;
    for (unsigned axis = 0; axis < 3; ++axis)
      for (const bool upper : {false, true}) {
        const unsigned face = face_of(division.inside, axis, upper);
        constexpr unsigned all_inside = (1U << 9) - 1;
        if (face == 0 || face == all_inside) continue;
        LatticePoint lower = division.lower;
        lower[axis] += upper ? side : -side;
        request(lower, level, is_plain_face(face), requests);
      }
    // An edge whose middle differs from both of its ends matters to all cells around it.
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (unsigned corner = 0; corner < 4; ++corner) {
        const bool high_u = (corner & 1U) != 0, high_v = (corner & 2U) != 0;
        const unsigned base = (high_u ? 2 * corner_stride[u] : 0) + (high_v ? 2 * corner_stride[v] : 0);
        const auto at = [&](unsigned i) { return (division.inside >> (base + i * corner_stride[axis]) & 1U) != 0; };
        if (at(1) == at(0) && at(1) == at(2)) continue;
        const bool plain = at(1) == at(0) || at(1) == at(2);
        LatticePoint by_u = division.lower, by_v = division.lower;
        by_u[u] += high_u ? side : -side;
        by_v[v] += high_v ? side : -side;
        LatticePoint by_both = by_u;
        by_both[v] = by_v[v];
        for (const LatticePoint& lower : {by_u, by_v, by_both}) request(lower, level, plain, requests);
      }
    }
  }
}

void BlockRefiner::request(const LatticePoint& lower, int level, bool only_ambiguous,
                           std::vector<DivisionRequest>& requests) const {
  const int mask = ~((1 << (lattice_.voxel_level() + block_level)) - 1);
  requests.push_back({{lower[0] & mask, lower[1] & mask, lower[2] & mask}, lower, level, only_ambiguous});
}

void BlockRefiner::move_to(Block& block) {
  block.divisions = std::move(divisions_);
  block.division_of = std::move(division_of_);
}

}  // namespace fieldfab::contouring

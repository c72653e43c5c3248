#include "mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/core/parallel.h"
#include "fieldfab/mesh/triangle_contact.h"

namespace fieldfab::contouring {
namespace {

constexpr std::uint32_t no_fan = std::numeric_limits<std::uint32_t>::max();

FloatBox box_of(const TriangleMesh& mesh, const Triangle& triangle) {
  FloatBox box;
  for (const std::uint32_t vertex : triangle) box.add(mesh.vertices[vertex]);
  return box;
}

Cell cell_at(const Position& point, double size) {
  Cell cell;
  for (std::size_t i = 0; i < 3; ++i) cell[i] = static_cast<std::int64_t>(std::floor(point[i] / size));
  return cell;
}

bool contains(const MeshEditor::Region& region, const FloatBox& box, double size) {
  const Cell low = cell_at(box.lower, size), high = cell_at(box.upper, size);
  for (std::size_t i = 0; i < 3; ++i)
    if (low[i] < region.lower[i] || high[i] >= region.upper[i]) return false;
  return true;
}

bool has(const Triangle& triangle, std::uint32_t vertex) {
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

}  // namespace

MeshEditor::MeshEditor(TriangleMesh& mesh, std::span<const std::uint32_t> seeds, double cell, double reach)
    : mesh_(mesh), cell_(cell), fan_of_(mesh.vertices.size(), no_fan) {
  std::vector<char> opened(mesh.vertices.size(), 0);
  for (const std::uint32_t t : seeds)
    for (const std::uint32_t vertex : mesh.triangles[t]) opened[vertex] = 1;
  const auto is_open = [&](std::uint32_t vertex) { return opened[vertex] != 0; };
  open_cells(is_open, static_cast<float>(reach));
  list_triangles(is_open);
}

/// Calls visit(part, triangle) for each triangle, in parallel; the triangles of a part follow each other.
template <class Visit>
void MeshEditor::for_triangles(const Visit& visit) const {
  parallel_for(parts(), [&](std::size_t part) {
    const std::size_t last = std::min(mesh_.triangles.size(), (part + 1) * triangles_a_part);
    for (std::size_t t = part * triangles_a_part; t < last; ++t) visit(part, static_cast<std::uint32_t>(t));
  });
}

/// Calls visit(number) for each cell that the box meets, CellSet::none for those that are not opened, until one call
/// returns false. Returns whether none did.
template <class Visit>
bool MeshEditor::for_cells(const FloatBox& box, const Visit& visit) const {
  return opened_.for_numbers(cell_at(box.lower, cell_), cell_at(box.upper, cell_), visit);
}

/// Opens the cells near triangles with opened vertices.
template <class IsOpen>
void MeshEditor::open_cells(const IsOpen& is_open, float reach) {
  std::vector<CellSet> near(parts());
  for_triangles([&](std::size_t part, std::uint32_t t) {
    const Triangle& triangle = mesh_.triangles[t];
    if (std::none_of(triangle.begin(), triangle.end(), is_open)) return;
    const FloatBox box = box_of(mesh_, triangle).grown(reach);
    near[part].add(cell_at(box.lower, cell_), cell_at(box.upper, cell_));
  });
  for (const CellSet& some : near) opened_.add(some);
  triangles_in_.resize(opened_.number());
}

/// Lists the triangles in opened cells and around opened vertices, in the order of their numbers.
template <class IsOpen>
void MeshEditor::list_triangles(const IsOpen& is_open) {
  struct Found {
    std::vector<std::pair<std::uint32_t, Listed>> in_cells;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> around;  // vertex, triangle
  };
  std::vector<Found> found(parts());
  for_triangles([&](std::size_t part, std::uint32_t t) {
    const FloatBox box = box_of(mesh_, mesh_.triangles[t]);
    for_cells(box, [&](std::uint32_t cell) {
      if (cell != CellSet::none) found[part].in_cells.emplace_back(cell, Listed{box, t});
      return true;
    });
    for (const std::uint32_t vertex : mesh_.triangles[t])
      if (is_open(vertex)) found[part].around.emplace_back(vertex, t);
  });
  for (const Found& some : found) {
    for (const auto& [cell, listed] : some.in_cells) triangles_in_[cell].push_back(listed);
    for (const auto& [vertex, triangle] : some.around) {
      if (fan_of_[vertex] == no_fan) {
        fan_of_[vertex] = static_cast<std::uint32_t>(fans_.size());
        fans_.emplace_back();
      }
      fans_[fan_of_[vertex]].push_back(triangle);
    }
  }
}

std::span<const std::uint32_t> MeshEditor::fan(std::uint32_t vertex) const {
  if (fan_of_[vertex] == no_fan) return {};
  return fans_[fan_of_[vertex]];
}

bool MeshEditor::sides(std::uint32_t a, std::uint32_t b, std::array<std::uint32_t, 2>& triangles) const {
  std::size_t count = 0;
  for (const std::uint32_t t : fan(a))
    if (has(mesh_.triangles[t], b)) {
      if (count == 2) return false;
      triangles[count++] = t;
    }
  return count == 2;
}

Cell MeshEditor::cell_of(const Position& point) const { return cell_at(point, cell_); }

bool MeshEditor::holds_fan(const Region& region, std::uint32_t vertex) const {
  FloatBox box;
  box.add(mesh_.vertices[vertex]);
  for (const std::uint32_t t : fan(vertex))
    for (const std::uint32_t corner : mesh_.triangles[t]) box.add(mesh_.vertices[corner]);
  return contains(region, box, cell_);
}

bool MeshEditor::holds(const Region& region, std::uint32_t vertex) const {
  FloatBox box;
  box.add(mesh_.vertices[vertex]);
  return contains(region, box, cell_);
}

Box MeshEditor::extent(const Region& region) const {
  Box box;
  for (int i = 0; i < 3; ++i) {
    box.lower[i] = cell_ * static_cast<double>(region.lower[static_cast<std::size_t>(i)]);
    box.upper[i] = cell_ * static_cast<double>(region.upper[static_cast<std::size_t>(i)]);
  }
  return box;
}

MeshEditor::Region MeshEditor::everything() {
  constexpr std::int64_t far = std::numeric_limits<std::int64_t>::max();
  return {{-far, -far, -far}, {far, far, far}, {}, {}, {}};
}

void MeshEditor::supply(Region& region, std::size_t count) {
  const auto deal = [](std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& to, std::size_t number,
                       auto& numbered) {
    while (from.size() < number) {
      from.push_back(static_cast<std::uint32_t>(numbered.size()));
      numbered.push_back({});
    }
    to.insert(to.end(), from.end() - static_cast<std::ptrdiff_t>(number), from.end());
    from.resize(from.size() - number);
  };
  deal(spare_vertices_, region.spare_vertices, count, mesh_.vertices);
  // By Euler's formula each vertex brings two triangles.
  deal(spare_triangles_, region.spare_triangles, 2 * count, mesh_.triangles);
  while (fan_of_.size() < mesh_.vertices.size()) {
    fan_of_.push_back(static_cast<std::uint32_t>(fans_.size()));
    fans_.emplace_back();
  }
}

void MeshEditor::take_back(Region& region) {
  spare_vertices_.insert(spare_vertices_.end(), region.spare_vertices.begin(), region.spare_vertices.end());
  spare_triangles_.insert(spare_triangles_.end(), region.spare_triangles.begin(), region.spare_triangles.end());
}

void MeshEditor::finish() {
  std::vector<std::uint32_t> number(mesh_.vertices.size(), 0);
  for (const std::uint32_t vertex : spare_vertices_) number[vertex] = 1;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < number.size(); ++i) {
    if (number[i] != 0) continue;
    mesh_.vertices[kept] = mesh_.vertices[i];
    number[i] = kept++;
  }
  mesh_.vertices.resize(kept);
  std::sort(spare_triangles_.begin(), spare_triangles_.end());
  auto spare = spare_triangles_.begin();
  std::size_t next = 0;
  for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
    if (spare != spare_triangles_.end() && *spare == t) {
      ++spare;
      continue;
    }
    for (std::size_t i = 0; i < 3; ++i) mesh_.triangles[next][i] = number[mesh_.triangles[t][i]];
    ++next;
  }
  mesh_.triangles.resize(next);
}

bool MeshEditor::replace(Region& region, std::span<const std::uint32_t> old, std::span<const Triangle> fresh,
                         Displaced displaced, std::vector<std::uint32_t>& changed) {
  for (const Triangle& triangle : fresh)
    if (!fits(region, triangle, old)) return false;
  for (std::size_t i = 0; i < fresh.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (triangles_overlap(mesh_.vertices, fresh[i], fresh[j])) return false;

  const bool moves = displaced.vertex != Displaced::none;
  if (moves) std::swap(mesh_.vertices[displaced.vertex], displaced.position);
  const bool inside = std::all_of(old.begin(), old.end(), [&](std::uint32_t t) {
    return contains(region, box_of(mesh_, mesh_.triangles[t]), cell_);
  });
  if (inside)
    for (const std::uint32_t t : old) strike(t);
  if (moves) std::swap(mesh_.vertices[displaced.vertex], displaced.position);
  if (!inside) return false;

  for (std::size_t i = 0; i < fresh.size(); ++i) {
    std::uint32_t t = 0;
    if (i < old.size()) {
      t = old[i];
    } else {
      t = region.spare_triangles.back();
      region.spare_triangles.pop_back();
    }
    mesh_.triangles[t] = fresh[i];
    enlist(t);
    changed.push_back(t);
  }
  return true;
}

void MeshEditor::enlist(std::uint32_t triangle) {
  const FloatBox box = box_of(mesh_, mesh_.triangles[triangle]);
  for_cells(box, [&](std::uint32_t cell) {
    triangles_in_[cell].push_back({box, triangle});
    return true;
  });
  for (const std::uint32_t vertex : mesh_.triangles[triangle])
    if (fan_of_[vertex] != no_fan) fans_[fan_of_[vertex]].push_back(triangle);
}

void MeshEditor::strike(std::uint32_t triangle) {
  for_cells(box_of(mesh_, mesh_.triangles[triangle]), [&](std::uint32_t cell) {
    if (cell != CellSet::none)
      std::erase_if(triangles_in_[cell], [&](const Listed& listed) { return listed.triangle == triangle; });
    return true;
  });
  for (const std::uint32_t vertex : mesh_.triangles[triangle])
    if (fan_of_[vertex] != no_fan) std::erase(fans_[fan_of_[vertex]], triangle);
}

bool MeshEditor::fits(Region& region, const Triangle& triangle, std::span<const std::uint32_t> old) const {
  if (is_degenerate(mesh_.vertices, triangle)) return false;
  const FloatBox box = box_of(mesh_, triangle);
  if (!contains(region, box, cell_)) return false;
  std::vector<std::uint32_t>& near = region.near;
  near.clear();
  const bool all_open = for_cells(box, [&](std::uint32_t cell) {
    if (cell == CellSet::none) return false;
    for (const auto& [its, t] : triangles_in_[cell])
      if (box.meets(its) && std::find(near.begin(), near.end(), t) == near.end() &&
          std::find(old.begin(), old.end(), t) == old.end())
        near.push_back(t);
    return true;
  });
  if (!all_open) return false;
  // An edge shared with a triangle that stays must be on the patch's rim: that triangle on one
  // side, the patch on the other.
  const auto shares_inner_edge = [&](const Triangle& other) {
    std::array<std::uint32_t, 3> common{};
    std::size_t count = 0;
    for (const std::uint32_t vertex : triangle)
      if (has(other, vertex)) common[count++] = vertex;
    return count == 2 && std::none_of(old.begin(), old.end(), [&](std::uint32_t t) {
             return has(mesh_.triangles[t], common[0]) && has(mesh_.triangles[t], common[1]);
           });
  };
  return std::none_of(near.begin(), near.end(), [&](std::uint32_t t) {
    const Triangle& other = mesh_.triangles[t];
    return shares_inner_edge(other) || triangles_overlap(mesh_.vertices, triangle, other);
  });
}

}  // namespace fieldfab::contouring

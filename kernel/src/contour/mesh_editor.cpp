#include "mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fieldfab/mesh/triangle_contact.h"

namespace fieldfab::contouring {
namespace {

constexpr std::uint32_t no_fan = std::numeric_limits<std::uint32_t>::max();

struct FloatBox {
  Position lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
  void add(const Position& p) {
    for (std::size_t i = 0; i < 3; ++i) lower[i] = std::min(lower[i], p[i]), upper[i] = std::max(upper[i], p[i]);
  }
  [[nodiscard]] FloatBox grown(float by) const {
    FloatBox box = *this;
    for (std::size_t i = 0; i < 3; ++i) box.lower[i] -= by, box.upper[i] += by;
    return box;
  }
  [[nodiscard]] bool meets(const FloatBox& other) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (upper[i] < other.lower[i] || other.upper[i] < lower[i]) return false;
    return true;
  }
};

FloatBox box_of(const TriangleMesh& mesh, const Triangle& triangle) {
  FloatBox box;
  for (const std::uint32_t vertex : triangle) box.add(mesh.vertices[vertex]);
  return box;
}

/// Calls visit(key) for each cell of that size that the box meets, until one call returns false.
/// Returns whether none did.
template <class Visit>
bool for_cells(const FloatBox& box, double size, const Visit& visit) {
  std::array<std::int64_t, 3> low, high;
  for (std::size_t i = 0; i < 3; ++i) {
    low[i] = static_cast<std::int64_t>(std::floor(box.lower[i] / size));
    high[i] = static_cast<std::int64_t>(std::floor(box.upper[i] / size));
  }
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z)
        if (!visit((static_cast<std::uint64_t>(x) & 0x1fffff) << 42 | (static_cast<std::uint64_t>(y) & 0x1fffff) << 21 |
                   (static_cast<std::uint64_t>(z) & 0x1fffff)))
          return false;
  return true;
}

bool has(const Triangle& triangle, std::uint32_t vertex) {
  return std::find(triangle.begin(), triangle.end(), vertex) != triangle.end();
}

}  // namespace

MeshEditor::MeshEditor(TriangleMesh& mesh, std::span<const std::uint32_t> seeds, double reach)
    : mesh_(mesh), cell_(2 * reach), fan_of_(mesh.vertices.size(), no_fan) {
  std::vector<bool> opened(mesh.vertices.size(), false);
  for (const std::uint32_t t : seeds)
    for (const std::uint32_t vertex : mesh.triangles[t]) opened[vertex] = true;
  for (const Triangle& triangle : mesh.triangles)
    if (opened[triangle[0]] || opened[triangle[1]] || opened[triangle[2]])
      for_cells(box_of(mesh, triangle).grown(static_cast<float>(reach)), cell_,
                [&](std::uint64_t key) { return triangles_in_.try_emplace(key), true; });
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for_cells(box_of(mesh, mesh.triangles[t]), cell_, [&](std::uint64_t key) {
      if (const auto found = triangles_in_.find(key); found != triangles_in_.end()) found->second.push_back(t);
      return true;
    });
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      if (!opened[vertex]) continue;
      if (fan_of_[vertex] == no_fan) {
        fan_of_[vertex] = static_cast<std::uint32_t>(fans_.size());
        fans_.emplace_back();
      }
      fans_[fan_of_[vertex]].push_back(t);
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

bool MeshEditor::replace(std::span<const std::uint32_t> old, std::span<const Triangle> fresh) {
  for (const Triangle& triangle : fresh)
    if (!fits(triangle, old)) return false;
  for (std::size_t i = 0; i < fresh.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (triangles_overlap(mesh_.vertices, fresh[i], fresh[j])) return false;

  for (const std::uint32_t t : old)
    for (const std::uint32_t vertex : mesh_.triangles[t])
      if (fan_of_[vertex] != no_fan) std::erase(fans_[fan_of_[vertex]], t);
  while (fan_of_.size() < mesh_.vertices.size()) {
    fan_of_.push_back(static_cast<std::uint32_t>(fans_.size()));
    fans_.emplace_back();
  }
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    auto t = static_cast<std::uint32_t>(mesh_.triangles.size());
    if (i < old.size()) {
      t = old[i];
      mesh_.triangles[t] = fresh[i];
    } else {
      mesh_.triangles.push_back(fresh[i]);
    }
    enlist(t);
  }
  return true;
}

void MeshEditor::enlist(std::uint32_t triangle) {
  for_cells(box_of(mesh_, mesh_.triangles[triangle]), cell_, [&](std::uint64_t key) {
    auto& listed = triangles_in_.at(key);
    if (std::find(listed.begin(), listed.end(), triangle) == listed.end()) listed.push_back(triangle);
    return true;
  });
  for (const std::uint32_t vertex : mesh_.triangles[triangle])
    if (fan_of_[vertex] != no_fan) fans_[fan_of_[vertex]].push_back(triangle);
}

bool MeshEditor::fits(const Triangle& triangle, std::span<const std::uint32_t> old) {
  if (is_degenerate(mesh_.vertices, triangle)) return false;
  const FloatBox box = box_of(mesh_, triangle);
  near_.clear();
  const bool all_open = for_cells(box, cell_, [&](std::uint64_t key) {
    const auto found = triangles_in_.find(key);
    if (found == triangles_in_.end()) return false;
    near_.insert(near_.end(), found->second.begin(), found->second.end());
    return true;
  });
  if (!all_open) return false;
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
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
  return std::none_of(near_.begin(), near_.end(), [&](std::uint32_t t) {
    const Triangle& other = mesh_.triangles[t];
    return std::find(old.begin(), old.end(), t) == old.end() && box.meets(box_of(mesh_, other)) &&
           (shares_inner_edge(other) || triangles_overlap(mesh_.vertices, triangle, other));
  });
}

}  // namespace fieldfab::contouring

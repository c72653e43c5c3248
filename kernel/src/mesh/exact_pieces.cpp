// Exact solid of a mesh, from its connected pieces.
#include <algorithm>
#include <cmath>
#include <map>

#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/mesh/exact_solid.h"

namespace fieldfab {
namespace {

/// Returns the pieces connected by edges; nullopt if an edge does not have exactly two triangles,
/// one on each side.
std::optional<std::vector<TriangleMesh>> pieces_of(const TriangleMesh& mesh) {
  struct Side {
    std::uint64_t edge;  // the smaller vertex, the larger one
    std::uint32_t triangle;
    bool forwards;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      sides.push_back({std::min(a, b) << 32U | std::max(a, b), t, a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.edge < b.edge; });
  DisjointSets sets(mesh.triangles.size());
  for (std::size_t i = 0; i < sides.size(); i += 2) {
    const bool two =
        i + 1 < sides.size() && sides[i].edge == sides[i + 1].edge && sides[i].forwards != sides[i + 1].forwards;
    if (!two || (i + 2 < sides.size() && sides[i].edge == sides[i + 2].edge)) return std::nullopt;
    sets.unite(sides[i].triangle, sides[i + 1].triangle);
  }
  std::map<std::uint32_t, std::size_t> number;
  std::vector<TriangleMesh> pieces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const std::size_t piece = number.try_emplace(sets.find(t), pieces.size()).first->second;
    if (piece == pieces.size()) pieces.emplace_back();
    pieces[piece].triangles.push_back(mesh.triangles[t]);
  }
  for (TriangleMesh& piece : pieces) {
    std::map<std::uint32_t, std::uint32_t> own;
    for (auto& triangle : piece.triangles)
      for (std::uint32_t& vertex : triangle) {
        const auto [found, is_new] = own.try_emplace(vertex, static_cast<std::uint32_t>(piece.vertices.size()));
        if (is_new) piece.vertices.push_back(mesh.vertices[vertex]);
        vertex = found->second;
      }
  }
  return pieces;
}

double volume_of(const ExactSolid& solid) { return to_mesh(solid.polyhedron()).volume(); }

}  // namespace

std::optional<ExactSolid> exact_solid_of(const TriangleMesh& mesh, Progress& progress) {
  const auto pieces = pieces_of(mesh);
  if (!pieces || pieces->empty()) return std::nullopt;
  double volume = 0;  // signed sum over all pieces
  std::vector<ExactSolid> outward, inward;
  try {
    for (TriangleMesh piece : *pieces) {
      progress.check();
      const bool faces_in = piece.volume() < 0;
      if (faces_in)
        for (auto& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
      const Polyhedron solid = to_polyhedron(piece);
      if (!bounds_a_solid(solid)) return std::nullopt;
      volume += piece.volume();
      (faces_in ? inward : outward).emplace_back(solid);
    }
    const bool has_hollows = !inward.empty() && !outward.empty();
    const ExactSolid whole = all_of(std::move(outward), Operation::unite, progress),
                     rest = all_of(std::move(inward), Operation::unite, progress);
    if (!has_hollows) return whole.empty() ? rest : whole;
    // If outward pieces overlap, a hollow may still have a positive winding number; a hollow that
    // sticks out is solid there.
    constexpr double nearly = 1e-6;
    const ExactSolid with_hollows = combined(whole, rest, Operation::subtract);
    const double outer = volume_of(whole), hollow = volume_of(rest);
    if (std::abs(outer + hollow - volume) > nearly * volume ||
        std::abs(outer - hollow - volume_of(with_hollows)) > nearly * volume)
      return std::nullopt;
    return with_hollows;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::cancelled) throw;
    return std::nullopt;
  }
}

}  // namespace fieldfab

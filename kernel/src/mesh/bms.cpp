#include "fieldfab/mesh/bms.h"

#include <bit>
#include <cstring>

namespace fieldfab {
namespace {

using Triple = std::array<std::uint32_t, 3>;
constexpr std::uint32_t none = 0xffffffff;

/// Returns for each triangle and each of its edges (from corner i to the next) the triangle with
/// that edge in the opposite direction.
std::vector<Triple> neighbours_of(const TriangleMesh& mesh) {
  const auto& triangles = mesh.triangles;
  // Edges by their first vertex.
  struct Edge {
    std::uint32_t to, triangle;
  };
  std::vector<std::uint32_t> first(mesh.vertices.size() + 2, 0);
  for (const Triple& t : triangles)
    for (const std::uint32_t v : t) ++first[v + 2];
  for (std::size_t v = 2; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Edge> edges(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) edges[first[triangles[t][i] + 1]++] = {triangles[t][(i + 1) % 3], t};

  const auto only_edge = [&](std::uint32_t from, std::uint32_t to) {
    std::uint32_t found = none;
    for (std::uint32_t e = first[from]; e < first[from + 1]; ++e) {
      if (edges[e].to != to) continue;
      if (found != none) return none;
      found = edges[e].triangle;
    }
    return found;
  };
  std::vector<Triple> neighbours(triangles.size(), {none, none, none});
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = triangles[t][i], b = triangles[t][(i + 1) % 3];
      if (only_edge(a, b) != none) neighbours[t][i] = only_edge(b, a);
    }
  return neighbours;
}

class Bytes {
 public:
  explicit Bytes(std::size_t size) { bytes_.reserve(size); }
  void add(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  void add(std::uint32_t number) { add(&number, sizeof number); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace

std::string to_bms(const TriangleMesh& mesh) {
  static_assert(std::endian::native == std::endian::little, "written as the memory holds it");
  constexpr std::uint32_t magic = 0xA0B0C0D0, version = 0x010000;
  constexpr std::size_t comment = 256;
  const std::vector<Triple> neighbours = neighbours_of(mesh);
  Bytes out(16 + comment + 12 * mesh.vertices.size() + 24 * mesh.triangles.size() + 24);
  out.add(magic);
  out.add(version);
  std::string words = "by Fieldfab, mm";
  words.resize(comment, ' ');
  out.add(words.data(), words.size());
  out.add(static_cast<std::uint32_t>(mesh.vertices.size()));
  out.add(static_cast<std::uint32_t>(mesh.triangles.size()));
  out.add(mesh.vertices.data(), 12 * mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out.add(mesh.triangles[t].data(), 12);
    out.add(neighbours[t].data(), 12);
  }
  const Box box = mesh.vertices.empty() ? Box{Vec3::Zero(), Vec3::Zero()} : mesh.bounds();
  for (int axis = 0; axis < 3; ++axis)
    for (const double end : {box.lower[axis], box.upper[axis]}) {
      const auto single = static_cast<float>(end);
      out.add(&single, sizeof single);
    }
  return out.take();
}

}  // namespace fieldfab

#include "fieldfab/mesh/mesh_distances.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "mesh/cgal/hole_lid.h"
#include "triangle_tree.h"

namespace fieldfab {
namespace {

constexpr int slab = 8;  // slices per task

Vec3 place(const std::array<float, 3>& p) { return {p[0], p[1], p[2]}; }

/// An edge that triangles pass more often from `from` to `to` than back, and the difference.
struct Rim {
  std::uint32_t from, to;
  int times;
};

std::vector<Rim> rims_of(const TriangleMesh& mesh) {
  struct Pass {
    std::uint64_t edge;  // the smaller vertex, the larger one
    int direction;
  };
  std::vector<Pass> passes;
  passes.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint64_t a = t[i], b = t[(i + 1) % 3];
      passes.push_back({std::min(a, b) << 32U | std::max(a, b), a < b ? 1 : -1});
    }
  std::sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) { return a.edge < b.edge; });
  std::vector<Rim> rims;
  for (std::size_t i = 0; i < passes.size();) {
    const std::uint64_t edge = passes[i].edge;
    int balance = 0;
    for (; i < passes.size() && passes[i].edge == edge; ++i) balance += passes[i].direction;
    const auto low = static_cast<std::uint32_t>(edge >> 32U), high = static_cast<std::uint32_t>(edge);
    if (balance > 0) rims.push_back({low, high, balance});
    if (balance < 0) rims.push_back({high, low, -balance});
  }
  return rims;
}

/// Returns the vertices of a rim in the order of a lid; empty if the rim is not one loop.
std::vector<std::uint32_t> loop_of(const std::vector<Rim>& edges) {
  std::unordered_map<std::uint32_t, std::uint32_t> next;
  for (const Rim& edge : edges)
    if (edge.times != 1 || !next.emplace(edge.to, edge.from).second) return {};
  std::vector<std::uint32_t> loop{edges.front().to};
  while (loop.size() <= edges.size()) {
    const auto found = next.find(loop.back());
    if (found == next.end()) return {};
    if (found->second == loop.front()) break;
    loop.push_back(found->second);
  }
  return loop.size() == edges.size() ? loop : std::vector<std::uint32_t>();
}

/// Closes a rim that is one loop by triangles of its own vertices. Returns false if there are none.
bool add_plain_lid(const std::vector<Rim>& edges, const TriangleMesh& mesh, Lids& lids) {
  const std::vector<std::uint32_t> loop = loop_of(edges);
  std::vector<Vec3> places;
  places.reserve(loop.size());
  for (const std::uint32_t vertex : loop) places.push_back(place(mesh.vertices[vertex]));
  const auto triangles = triangles_over(places);
  for (const auto& [a, b, c] : triangles) {
    lids.triangles.push_back({loop[a], loop[b], loop[c]});
    lids.area += 0.5 * (places[b] - places[a]).cross(places[c] - places[a]).norm();
  }
  return !triangles.empty();
}

/// Closes any rim by triangles to its middle. A lid with at most the area `slit`, mm2, counts as a
/// slit.
void add_cone(const std::vector<Rim>& edges, const TriangleMesh& mesh, double slit, Lids& lids) {
  Vec3 middle = Vec3::Zero(), areas = Vec3::Zero();
  for (const Rim& edge : edges) middle += place(mesh.vertices[edge.from]) / static_cast<double>(edges.size());
  const auto vertex = static_cast<std::uint32_t>(mesh.vertices.size() + lids.middles.size());
  lids.middles.push_back(
      {static_cast<float>(middle.x()), static_cast<float>(middle.y()), static_cast<float>(middle.z())});
  double whole = 0;
  for (const Rim& edge : edges) {
    const Vec3 a = place(mesh.vertices[edge.from]), b = place(mesh.vertices[edge.to]);
    const Vec3 area = 0.5 * edge.times * (a - middle).cross(b - middle);
    areas += area;
    whole += area.norm();
    for (int n = 0; n < edge.times; ++n) lids.triangles.push_back({edge.to, edge.from, vertex});
  }
  lids.area += whole;
  if (whole > slit) lids.folds = std::max(lids.folds, whole / areas.norm());
}

class Lattice {
 public:
  Lattice(const TriangleMesh& mesh, const DistanceLattice& lattice, double reach)
      : mesh_(mesh), lattice_(lattice), reach_(reach), square_(count(), static_cast<float>(reach * reach)) {
    list_triangles();
  }

  std::vector<float> run(Progress& progress) {
    std::atomic<int> done{0};
    parallel_for(triangles_of_.size(), [&](std::size_t task) {
      const int first = static_cast<int>(task) * slab, last = std::min(first + slab, lattice_.size[2]) - 1;
      for (std::size_t n = 0; n < triangles_of_[task].size(); ++n) {
        if (n % 4096 == 0) progress.check();
        measure(mesh_.triangles[triangles_of_[task][n]], first, last);
      }
      progress.report(0.9 * ++done / static_cast<double>(triangles_of_.size()), "distances");
    });
    progress.check();
    give_signs(progress);
    return std::move(square_);
  }

 private:
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(lattice_.size[0]) * static_cast<std::size_t>(lattice_.size[1]) *
           static_cast<std::size_t>(lattice_.size[2]);
  }
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice_.size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(lattice_.size[0]) +
           static_cast<std::size_t>(i);
  }
  [[nodiscard]] double at(int axis, int i) const { return lattice_.origin[axis] + lattice_.spacing * i; }
  [[nodiscard]] int first_from(int axis, double x) const {
    return static_cast<int>(std::clamp(std::ceil((x - lattice_.origin[axis]) / lattice_.spacing), 0.0,
                                       1.0 * lattice_.size[static_cast<std::size_t>(axis)]));
  }
  [[nodiscard]] int last_to(int axis, double x) const {
    return static_cast<int>(std::clamp(std::floor((x - lattice_.origin[axis]) / lattice_.spacing), -1.0,
                                       lattice_.size[static_cast<std::size_t>(axis)] - 1.0));
  }

  void list_triangles() {
    triangles_of_.resize((static_cast<std::size_t>(lattice_.size[2]) + slab - 1) / slab);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& v = mesh_.triangles[t];
      const double low = std::min({mesh_.vertices[v[0]][2], mesh_.vertices[v[1]][2], mesh_.vertices[v[2]][2]});
      const double high = std::max({mesh_.vertices[v[0]][2], mesh_.vertices[v[1]][2], mesh_.vertices[v[2]][2]});
      const int first = first_from(2, low - reach_), last = last_to(2, high + reach_);
      for (int task = first / slab; task <= last / slab && first <= last; ++task)
        triangles_of_[static_cast<std::size_t>(task)].push_back(static_cast<std::uint32_t>(t));
    }
  }

  /// Updates all samples within reach between two slices with the distance to a triangle. Rows run
  /// along the axis closest to its normal, so that few of their samples are near its plane.
  void measure(const std::array<std::uint32_t, 3>& triangle, int first_slice, int last_slice) {
    const Vec3 a = place(mesh_.vertices[triangle[0]]), b = place(mesh_.vertices[triangle[1]]),
               c = place(mesh_.vertices[triangle[2]]);
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto n = static_cast<std::size_t>(axis);
      first[n] = first_from(axis, std::min({a[axis], b[axis], c[axis]}) - reach_);
      last[n] = last_to(axis, std::max({a[axis], b[axis], c[axis]}) + reach_);
    }
    first[2] = std::max(first[2], first_slice);
    last[2] = std::min(last[2], last_slice);
    const Vec3 cross = (b - a).cross(c - a);
    const double length = cross.norm();
    Eigen::Index along = 0;
    const double steepness = length > 0 ? cross.cwiseAbs().maxCoeff(&along) / length : 0;
    const auto row = static_cast<int>(along), one = (row + 1) % 3, two = (row + 2) % 3;
    std::array<int, 3> i{};
    const auto R = static_cast<std::size_t>(row), A = static_cast<std::size_t>(one), B = static_cast<std::size_t>(two);
    for (i[B] = first[B]; i[B] <= last[B]; ++i[B])
      for (i[A] = first[A]; i[A] <= last[A]; ++i[A]) {
        Vec3 p;
        p[one] = at(one, i[A]), p[two] = at(two, i[B]);
        int from = first[R], to = last[R];
        if (steepness > 0) {
          const double plane = a[row] - (cross[one] * (p[one] - a[one]) + cross[two] * (p[two] - a[two])) / cross[row];
          from = std::max(from, first_from(row, plane - reach_ / steepness));
          to = std::min(to, last_to(row, plane + reach_ / steepness));
        }
        for (i[R] = from; i[R] <= to; ++i[R]) {
          p[row] = at(row, i[R]);
          float& square = square_[index(i[0], i[1], i[2])];
          square = std::min(square, static_cast<float>((nearest_place(p, a, b, c) - p).squaredNorm()));
        }
      }
  }

  /// Computes the winding number at each sample: how often the line along z through it crosses
  /// triangles on the way there.
  void give_signs(Progress& progress) {
    const auto rows = static_cast<std::size_t>(lattice_.size[1]);
    std::vector<std::vector<std::uint32_t>> triangles_of_row(rows);
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const auto& v = mesh_.triangles[t];
      const double low = std::min({mesh_.vertices[v[0]][1], mesh_.vertices[v[1]][1], mesh_.vertices[v[2]][1]});
      const double high = std::max({mesh_.vertices[v[0]][1], mesh_.vertices[v[1]][1], mesh_.vertices[v[2]][1]});
      for (int j = first_from(1, low); j <= last_to(1, high); ++j)
        triangles_of_row[static_cast<std::size_t>(j)].push_back(static_cast<std::uint32_t>(t));
    }
    parallel_for(rows, [&](std::size_t j) {
      progress.check();
      sign_row(static_cast<int>(j), triangles_of_row[j]);
    });
  }

  void sign_row(int j, const std::vector<std::uint32_t>& triangles) {
    const auto width = static_cast<std::size_t>(lattice_.size[0]), height = static_cast<std::size_t>(lattice_.size[2]);
    std::vector<int> turns((height + 1) * width, 0);
    const double y = at(1, j);
    for (const std::uint32_t t : triangles) {
      const auto& v = mesh_.triangles[t];
      const Vec3 a = place(mesh_.vertices[v[0]]), b = place(mesh_.vertices[v[1]]), c = place(mesh_.vertices[v[2]]);
      for (int i = first_from(0, std::min({a.x(), b.x(), c.x()})); i <= last_to(0, std::max({a.x(), b.x(), c.x()}));
           ++i) {
        const double x = at(0, i);
        const int turn = passes(a, b, x, y) + passes(b, c, x, y) + passes(c, a, x, y);
        if (turn == 0) continue;
        const double z = height_at(a, b, c, x, y);
        turns[static_cast<std::size_t>(first_from(2, z)) * width + static_cast<std::size_t>(i)] += turn;
      }
    }
    std::vector<int> winding(width, 0);
    for (std::size_t k = 0; k < height; ++k)
      for (std::size_t i = 0; i < width; ++i) {
        winding[i] += turns[k * width + i];
        float& value = square_[index(static_cast<int>(i), j, static_cast<int>(k))];
        value = std::copysign(std::sqrt(value), winding[i] != 0 ? -1.0F : 1.0F);
      }
  }

  const TriangleMesh& mesh_;
  DistanceLattice lattice_;
  double reach_;
  std::vector<float> square_;  ///< squares of distances; at the end signed distances
  std::vector<std::vector<std::uint32_t>> triangles_of_;
};

}  // namespace

Lids lids_of(const TriangleMesh& mesh) {
  const std::vector<Rim> all = rims_of(mesh);
  DisjointSets sets(mesh.vertices.size());
  for (const Rim& edge : all) sets.unite(edge.from, edge.to);
  std::map<std::uint32_t, std::vector<Rim>> rims;
  for (const Rim& edge : all) rims[sets.find(edge.from)].push_back(edge);
  Lids lids;
  lids.rims = rims.size(), lids.edges = all.size();
  const double slit = 1e-6 * mesh.area();
  for (const auto& [name, edges] : rims)
    if (!add_plain_lid(edges, mesh, lids)) add_cone(edges, mesh, slit, lids);
  return lids;
}

TriangleMesh closed_by(const Lids& lids, const TriangleMesh& mesh) {
  TriangleMesh closed = mesh;
  closed.vertices.insert(closed.vertices.end(), lids.middles.begin(), lids.middles.end());
  closed.triangles.insert(closed.triangles.end(), lids.triangles.begin(), lids.triangles.end());
  return closed;
}

std::vector<float> mesh_distances(const TriangleMesh& mesh, const DistanceLattice& lattice, double reach,
                                  Progress& progress) {
  if (mesh.triangles.empty()) throw Error(ErrorKind::bad_input, "mesh", "has no triangles");
  for (const auto& p : mesh.vertices)
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      throw Error(ErrorKind::bad_input, "mesh", "a vertex is not at a finite place");
  if (!std::isfinite(lattice.spacing) || lattice.spacing <= 0 || !std::isfinite(reach) || reach <= 0 ||
      !lattice.origin.allFinite() || *std::min_element(lattice.size.begin(), lattice.size.end()) < 2)
    throw Error(ErrorKind::bad_input, "lattice",
                "must have two points along each axis or more, and a spacing and reach above 0");
  if (!rims_of(mesh).empty()) throw Error(ErrorKind::bad_input, "mesh", "is not closed");
  const Box box = mesh.bounds();
  if (box.lower.z() < lattice.origin.z())
    throw Error(ErrorKind::bad_input, "lattice", "begins above the lowest place of the mesh");
  require_memory(static_cast<std::uintmax_t>(std::min(12 * lattice.points(), 1e18)), "distances");
  return Lattice(mesh, lattice, reach).run(progress);
}

}  // namespace fieldfab

#include "sharp_edges.h"

#include <algorithm>
#include <limits>
#include <span>

#include "fieldfab/core/parallel.h"
#include "fieldfab/mesh/triangle_contact.h"

namespace fieldfab::cam {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
using Place = SurfacePiece::Place;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A closed polygon of a cube's surface in the cube's faces.
struct Loop {
  std::vector<std::uint32_t> vertices;
  std::vector<std::size_t> seams;  ///< positions of those that are seams
};

class SharpEdges {
 public:
  SharpEdges(const SharpCubes& sharp, const StockLattice& lattice, const DeviationGauge* gauge, ClosedMesh& whole)
      : sharp_(sharp), lattice_(lattice), gauge_(gauge), whole_(whole), first_seam_(whole.cuts.size()) {}

  void run() {
    sort_seams();
    const std::size_t cubes = sharp_.cubes.size();
    first_.resize(cubes + 1, 0);
    for (std::size_t k = 0; k < cubes; ++k) first_[k + 1] = first_[k] + sharp_.cubes[k].triangles;
    find_sides();
    add_vertices();
    chosen_.assign(cubes, 0);
    parallel_for((cubes + 255) / 256, [&](std::size_t part) {
      for (std::size_t k = 256 * part; k < std::min(cubes, 256 * part + 256); ++k) choose(k);
    });
    // What one cube cannot have, the cubes beside it cannot have either.
    std::vector<std::uint32_t> failed;
    for (std::uint32_t k = 0; k < cubes; ++k)
      if (chosen_[k] == nothing_fits) failed.push_back(k);
    while (!failed.empty()) {
      const std::uint32_t k = failed.back();
      failed.pop_back();
      for (const std::uint32_t seam : seams_of(k)) {
        if (dropped_[seam]) continue;
        dropped_[seam] = true;
        for (const std::uint32_t other : sides_[seam])
          if (other != k && other != none && (choose(other), chosen_[other] == nothing_fits)) failed.push_back(other);
      }
      choose(k);
    }
    finish();
  }

 private:
  static constexpr std::uint8_t nothing_fits = 255;
  static constexpr std::uint8_t ways = 6;

  [[nodiscard]] std::span<const Triangle> triangles_of(std::size_t cube) const {
    return std::span(sharp_.triangles).subspan(first_[cube], first_[cube + 1] - first_[cube]);
  }

  void sort_seams() {
    seams_.resize(sharp_.seams.size());
    for (std::size_t i = 0; i < seams_.size(); ++i) {
      seams_[i] = sharp_.seams[i];
      if (seams_[i].ends[0] > seams_[i].ends[1]) std::swap(seams_[i].ends[0], seams_[i].ends[1]);
    }
    std::sort(seams_.begin(), seams_.end(), [](const Seam& a, const Seam& b) { return a.ends < b.ends; });
  }
  [[nodiscard]] std::uint32_t seam_between(std::uint32_t a, std::uint32_t b) const {
    const std::array<std::uint32_t, 2> ends{std::min(a, b), std::max(a, b)};
    const auto found = std::lower_bound(seams_.begin(), seams_.end(), ends,
                                        [](const Seam& seam, const auto& wanted) { return seam.ends < wanted; });
    return found != seams_.end() && found->ends == ends ? static_cast<std::uint32_t>(found - seams_.begin()) : none;
  }

  /// Edges at the rim of a cube's triangles.
  [[nodiscard]] Rim rim_of(std::size_t cube) const {
    Rim rim;
    find_rim(triangles_of(cube), rim);
    return rim;
  }
  [[nodiscard]] std::vector<std::uint32_t> seams_of(std::size_t cube) const {
    std::vector<std::uint32_t> seams;
    for (const auto& [a, b] : rim_of(cube))
      if (const std::uint32_t seam = seam_between(a, b); seam != none) seams.push_back(seam);
    return seams;
  }

  /// The two cubes at each seam. A seam that only one cube has is dropped.
  void find_sides() {
    sides_.assign(seams_.size(), {none, none});
    dropped_.assign(seams_.size(), false);
    for (std::uint32_t k = 0; k < sharp_.cubes.size(); ++k)
      for (const std::uint32_t seam : seams_of(k)) {
        auto& sides = sides_[seam];
        if (sides[0] == none)
          sides[0] = k;
        else if (sides[1] == none)
          sides[1] = k;
        else
          dropped_[seam] = true;
      }
    for (std::size_t i = 0; i < seams_.size(); ++i)
      if (sides_[i][1] == none) dropped_[i] = true;
  }

  /// Adds the vertices of seams, and one for each cube, which may be unused.
  void add_vertices() {
    auto& places = whole_.mesh.vertices;
    places.reserve(places.size() + seams_.size() + sharp_.cubes.size());
    for (const Seam& seam : seams_) places.push_back(seam.place), whole_.cuts.push_back(seam.cut);
    first_corner_ = places.size();
    for (std::size_t k = 0; k < sharp_.cubes.size(); ++k) {
      Place place = sharp_.cubes[k].corner;
      std::uint32_t cut = 0;
      Vec3 sum = Vec3::Zero();
      int count = 0;
      for (const std::uint32_t seam : seams_of(k)) {
        cut = std::max(cut, seams_[seam].cut);
        for (int d = 0; d < 3; ++d) sum[d] += seams_[seam].place[static_cast<std::size_t>(d)];
        ++count;
      }
      if (!sharp_.cubes[k].has_corner && count)
        for (std::size_t d = 0; d < 3; ++d) place[d] = static_cast<float>(sum[static_cast<Eigen::Index>(d)] / count);
      places.push_back(place);
      whole_.cuts.push_back(cut);
    }
    if (!gauge_) return;
    const std::vector<float> deviations = gauge_->distances(std::span(places).subspan(first_seam_));
    whole_.deviations.insert(whole_.deviations.end(), deviations.begin(), deviations.end());
  }

  /// The loops of a cube with the seams that were not dropped. Empty if the rim is no set of loops.
  [[nodiscard]] std::vector<Loop> loops_of(std::size_t cube) const {
    Rim rim = rim_of(cube);
    std::vector<Loop> loops;
    while (!rim.empty()) {
      Loop& loop = loops.emplace_back();
      auto edge = rim.back();
      const std::uint32_t start = edge[0];
      for (;;) {
        loop.vertices.push_back(edge[0]);
        const std::uint32_t seam = seam_between(edge[0], edge[1]);
        if (seam != none && !dropped_[seam]) {
          loop.seams.push_back(loop.vertices.size());
          loop.vertices.push_back(static_cast<std::uint32_t>(first_seam_ + seam));
        }
        rim.erase(std::find(rim.begin(), rim.end(), edge));
        if (edge[1] == start) break;
        const auto next = std::find_if(rim.begin(), rim.end(), [&](const auto& e) { return e[0] == edge[1]; });
        if (next == rim.end()) return {};
        edge = *next;
      }
    }
    return loops;
  }

  /// The old triangles of a loop without seams.
  [[nodiscard]] std::vector<Triangle> old_triangles(std::size_t cube, const Loop& loop) const {
    const auto old = triangles_of(cube);
    std::vector<char> taken(old.size());
    std::vector<std::uint32_t> reached = loop.vertices;
    std::vector<Triangle> found;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t i = 0; i < old.size(); ++i) {
        const auto has = [&](std::uint32_t v) { return std::find(reached.begin(), reached.end(), v) != reached.end(); };
        if (taken[i] || !(has(old[i][0]) || has(old[i][1]) || has(old[i][2]))) continue;
        taken[i] = more = true;
        found.push_back(old[i]);
        for (const std::uint32_t v : old[i])
          if (!has(v)) reached.push_back(v);
      }
    }
    return found;
  }

  /// Makes a cube's triangles in one of several ways. Returns false if there is no such way.
  bool make(std::size_t cube, std::uint8_t way, std::vector<Triangle>& into) {
    into.clear();
    const std::vector<Loop> loops = loops_of(cube);
    if (std::all_of(loops.begin(), loops.end(), [](const Loop& loop) { return loop.seams.empty(); })) {
      const auto old = triangles_of(cube);
      into.assign(old.begin(), old.end());
      return way == 0;
    }
    int with_seams = 0;
    for (const Loop& loop : loops) {
      if (loop.seams.empty()) {
        const std::vector<Triangle> old = old_triangles(cube, loop);
        into.insert(into.end(), old.begin(), old.end());
        continue;
      }
      // A second loop with seams has no vertex of its own.
      const auto corner = static_cast<std::uint32_t>(first_corner_ + cube);
      const bool may_have_corner = ++with_seams == 1;
      if (loop.seams.size() == 1) {
        if (way < 2)
          fan_from(loop.vertices, loop.seams[0], into);
        else if (may_have_corner && way == 2)
          fan(loop.vertices, corner, into);
        else
          return false;
      } else if (loop.seams.size() == 2) {
        if (way < 4)
          halves(loop, way, into);
        else if (may_have_corner && way == 4)
          fan(loop.vertices, corner, into);
        else
          return false;
      } else {
        if (may_have_corner && way == 0)
          fan(loop.vertices, corner, into);
        else if (way > 0 && way <= loop.seams.size())
          fan_from(loop.vertices, loop.seams[way - 1U], into);
        else
          return false;
      }
    }
    return true;
  }

  static void fan(const std::vector<std::uint32_t>& polygon, std::uint32_t tip, std::vector<Triangle>& into) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
      into.push_back({polygon[i], polygon[(i + 1) % polygon.size()], tip});
  }
  static void fan_from(const std::vector<std::uint32_t>& polygon, std::size_t from, std::vector<Triangle>& into) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
      into.push_back({polygon[from], polygon[(from + i) % n], polygon[(from + i + 1) % n]});
  }
  /// An edge from one seam to the other, and on each side of it a fan from one of them.
  static void halves(const Loop& loop, std::uint8_t way, std::vector<Triangle>& into) {
    const std::size_t n = loop.vertices.size(), one = loop.seams[0], other = loop.seams[1];
    std::vector<std::uint32_t> part;
    for (std::size_t i = one; i <= other; ++i) part.push_back(loop.vertices[i]);
    fan_from(part, way & 1 ? part.size() - 1 : 0, into);
    part.clear();
    for (std::size_t i = other; i <= one + n; ++i) part.push_back(loop.vertices[i % n]);
    fan_from(part, way & 2 ? part.size() - 1 : 0, into);
  }

  /// Whether a cube's triangles meet each other and the cube's faces in their common edges and vertices only.
  [[nodiscard]] bool fit(std::size_t cube, const std::vector<Triangle>& triangles) const {
    const auto& places = whole_.mesh.vertices;
    const Index3& lower = sharp_.cubes[cube].lower;
    const auto rim = rim_with_seams(cube);
    for (std::size_t d = 0; d < 3; ++d) {
      // Cubes beside the stock are flat: their triangles lie in the stock's face.
      const bool flat = lower[d] < 0 || lower[d] == lattice_.cells()[d];
      for (const int k : {lower[d], lower[d] + 1}) {
        if (flat || k < 0 || k > lattice_.cells()[d]) continue;
        const float level = SeamFinder::plane(lattice_, d, k);
        for (const Triangle& t : triangles)
          for (std::size_t i = 0; i < 3; ++i) {
            const std::array<std::uint32_t, 2> edge{t[i], t[(i + 1) % 3]};
            if (places[edge[0]][d] == level && places[edge[1]][d] == level &&
                std::find(rim.begin(), rim.end(), edge) == rim.end())
              return false;
          }
      }
    }
    for (const Triangle& t : triangles)
      if (is_degenerate(places, t)) return false;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (triangles_overlap(places, triangles[i], triangles[j])) return false;
    return true;
  }
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> rim_with_seams(std::size_t cube) const {
    std::vector<std::array<std::uint32_t, 2>> rim;
    for (const auto& [a, b] : rim_of(cube)) {
      const std::uint32_t seam = seam_between(a, b);
      if (seam == none || dropped_[seam]) {
        rim.push_back({a, b});
        continue;
      }
      const auto middle = static_cast<std::uint32_t>(first_seam_ + seam);
      rim.push_back({a, middle}), rim.push_back({middle, b});
    }
    return rim;
  }

  void choose(std::size_t cube) {
    thread_local std::vector<Triangle> triangles;
    for (std::uint8_t way = 0; way < ways; ++way) {
      if (!make(cube, way, triangles)) continue;
      if (triangles.size() == triangles_of(cube).size() &&
          std::equal(triangles.begin(), triangles.end(), triangles_of(cube).begin())) {
        chosen_[cube] = way;  // as it was
        return;
      }
      if (!fit(cube, triangles)) continue;
      chosen_[cube] = way;
      return;
    }
    chosen_[cube] = nothing_fits;
  }

  /// Adds the triangles, and removes the vertices that none of them has: new ones, and middles of loops.
  void finish() {
    std::vector<Triangle> triangles;
    std::vector<Triangle>& all = whole_.mesh.triangles;
    // Each seam adds a triangle to two cubes, and each corner some.
    all.reserve(all.size() + sharp_.triangles.size() + 2 * seams_.size() + sharp_.cubes.size() / 8);
    for (std::size_t k = 0; k < sharp_.cubes.size(); ++k) {
      make(k, chosen_[k], triangles);
      all.insert(all.end(), triangles.begin(), triangles.end());
    }
    std::vector<std::uint32_t> number(whole_.cuts.size(), none);
    for (const Triangle& t : all)
      for (const std::uint32_t v : t) number[v] = 0;
    std::uint32_t count = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] == none) continue;
      number[v] = count;
      whole_.mesh.vertices[count] = whole_.mesh.vertices[v], whole_.cuts[count] = whole_.cuts[v];
      if (!whole_.deviations.empty()) whole_.deviations[count] = whole_.deviations[v];
      ++count;
    }
    whole_.mesh.vertices.resize(count), whole_.cuts.resize(count);
    if (!whole_.deviations.empty()) whole_.deviations.resize(count);
    for (Triangle& t : all)
      for (std::uint32_t& v : t) v = number[v];
  }

  const SharpCubes& sharp_;
  const StockLattice& lattice_;
  const DeviationGauge* gauge_;
  ClosedMesh& whole_;
  std::size_t first_seam_, first_corner_ = 0;  ///< numbers of the first new vertices
  std::vector<Seam> seams_;                    ///< by ends
  std::vector<std::array<std::uint32_t, 2>> sides_;
  std::vector<char> dropped_;
  std::vector<std::size_t> first_;  ///< triangle of each cube
  std::vector<std::uint8_t> chosen_;
};

}  // namespace

void close_sharp_cubes(const SharpCubes& sharp, const StockLattice& lattice, const DeviationGauge* gauge,
                       ClosedMesh& whole) {
  SharpEdges(sharp, lattice, gauge, whole).run();
}

}  // namespace fieldfab::cam

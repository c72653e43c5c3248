// Simplification of axis-aligned flats. Squares of 2 x 2 to 32 x 32 vertices in the interior of a
// flat, all made by one cut, become one vertex in their middle. The squares are complete nodes of a
// quadtree on the lattice whose surroundings are coplanar, so that the result is the quadtree's
// mesh. It stays closed and manifold, because the neighbours of a square form one cycle round it.
// The surface is unchanged and has no folds: the line between the middles of two squares crosses
// their common side, and where four squares meet, their middles lie on the diagonals through that
// point.
#include "closed_mesh.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "sharp_edges.h"

namespace fieldfab::cam {
namespace {

constexpr unsigned doublings = 5;  // log2 of the largest square's edge length
constexpr std::uint8_t axis_part = VertexState::axis_part, not_level = VertexState::not_level;

using Triangle = std::array<std::uint32_t, 3>;

/// Interleaved bits of two coordinates (Morton order): the points of an aligned square are
/// consecutive.
std::uint32_t interleaved(std::uint32_t x, std::uint32_t y) {
  const auto spread = [](std::uint32_t v) {
    v = (v | v << 8) & 0x00FF00FFu, v = (v | v << 4) & 0x0F0F0F0Fu;
    v = (v | v << 2) & 0x33333333u;
    return (v | v << 1) & 0x55555555u;
  };
  return spread(x) | spread(y) << 1;
}

/// Simplifies flats piece by piece and assembles the mesh.
class Merging {
 public:
  /// Without `surfaces`, edges remain as they were sampled.
  Merging(const SurfacePieces& pieces, const CutSurfaces* surfaces, DeviationGauge* gauge)
      : pieces_(pieces), gauge_(gauge), parts_(pieces.size()) {
    if (gauge_) gauge_->begin(pieces.size());
    if (surfaces) seams_.emplace(pieces, *surfaces);
  }

  /// Registers a piece's vertices, before its triangles are made.
  void begin(std::size_t index) {
    std::vector<std::uint8_t>& level = parts_[index].level;
    level.reserve(pieces_[index].edges);
    const std::optional<Occupancy>& shape = pieces_[index].shape;
    pieces_[index].for_each_edge([&](const Index3& p, std::size_t axis) {
      const bool upwards = seams_ && shape && shape->at(p);
      level.push_back(static_cast<std::uint8_t>(axis | (upwards ? VertexState::upwards : 0)));
    });
    if (gauge_) gauge_->measure(index, pieces_[index].vertices);
  }

  /// Marks the vertices that are not in the interior of a flat, according to a piece's triangles.
  /// These may refer to the pieces after it, which must be registered.
  void mark(std::size_t index) {
    const SurfacePiece& piece = pieces_[index];
    if (gauge_) gauge_->measure(index, piece.middles);
    for (const Triangle& t : piece.corners) {
      std::array<const SurfacePiece::Place*, 3> at;
      std::array<std::uint8_t*, 3> level;
      std::array<std::uint8_t, 3> axis;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t owner = pieces_.owner(index, t[i]);
        const std::uint32_t v = t[i] & SurfacePiece::own_part;
        std::vector<std::uint8_t>& levels = parts_[owner].level;
        at[i] = &pieces_[owner].place(v);
        level[i] = v < levels.size() ? &levels[v] : nullptr;  // the middle of a loop has no entry
        // Other pieces' triangles may mark the same vertex concurrently.
        axis[i] = level[i] ? std::atomic_ref(*level[i]).load(std::memory_order_relaxed) & axis_part : axis_part;
      }
      const std::uint8_t a = axis[0];
      if (a < 3 && a == axis[1] && a == axis[2] && (*at[0])[a] == (*at[1])[a] && (*at[0])[a] == (*at[2])[a]) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (level[i]) std::atomic_ref(*level[i]).fetch_or(not_level, std::memory_order_relaxed);
    }
    if (seams_) find_sharp_cubes(index);
  }

  /// Finds a piece's squares. The piece and those before it must be marked.
  void merge(std::size_t index) {
    const SurfacePiece& piece = pieces_[index];
    Part& part = parts_[index];
    std::vector<std::uint32_t> goes_to(piece.size());
    for (std::uint32_t v = 0; v < goes_to.size(); ++v) goes_to[v] = v;
    const std::vector<Spot> spots = spots_on_flats(piece, part.level);
    part.level = {};
    // new index, and the two vertices beside the middle
    std::vector<std::array<std::uint32_t, 3>> squares;
    for (std::size_t i = 0, size = 1; i < spots.size(); i += size) {
      for (size = std::size_t{1} << 2 * doublings; size > 1 && !is_square(index, spots, i, size);) size /= 4;
      for (std::size_t k = i; k < i + size; ++k) goes_to[spots[k].second] = spots[i].second;
      // The last vertex of the first quarter and the first of the last quarter.
      if (size > 1)
        squares.push_back({spots[i].second, spots[i + size / 4 - 1].second, spots[i + 3 * size / 4].second});
    }
    std::vector<std::uint32_t> number(piece.size());
    for (std::uint32_t v = 0; v < goes_to.size(); ++v) {
      if (goes_to[v] != v) continue;
      number[v] = static_cast<std::uint32_t>(part.left.cuts.size());
      part.left.mesh.vertices.push_back(piece.place(v));
      part.left.cuts.push_back(piece.cut(v));
      if (gauge_) part.left.deviations.push_back(gauge_->at(index)[v]);
    }
    part.left.mesh.vertices.shrink_to_fit(), part.left.cuts.shrink_to_fit(), part.left.deviations.shrink_to_fit();
    for (const auto& [v, one, other] : squares) {
      for (std::size_t a = 0; a < 3; ++a)
        part.left.mesh.vertices[number[v]][a] = 0.5F * (piece.place(one)[a] + piece.place(other)[a]);
      if (gauge_) part.left.deviations[number[v]] = 0.5F * (gauge_->at(index)[one] + gauge_->at(index)[other]);
    }
    for (std::uint32_t& v : goes_to) v = number[v];
    part.now = std::move(goes_to);
    if (gauge_) gauge_->look(index, pieces_);
  }

  /// Adds the remaining vertices of merged pieces. Triangles may follow.
  void add_vertices(const std::vector<std::size_t>& group) {
    for (const std::size_t index : group) {
      parts_[index].first = static_cast<std::uint32_t>(vertices_);
      vertices_ += parts_[index].left.cuts.size();
      chunks_.push_back(std::exchange(parts_[index].left, {}));
    }
    if (vertices_ > std::numeric_limits<std::uint32_t>::max())
      throw Error(ErrorKind::too_large, "stock", "too many vertices");
  }

  /// Adds the remaining triangles of pieces. Requires the vertices of these pieces and of those
  /// after them.
  void add_triangles(const std::vector<std::size_t>& group) {
    const std::size_t first = chunks_.size();
    chunks_.resize(first + group.size());
    parallel_for(group.size(), [&](std::size_t k) {
      std::vector<Triangle>& left = chunks_[first + k].mesh.triangles;
      SharpCubes& sharp = parts_[group[k]].sharp;
      const auto rename = [&](std::uint32_t& v) {
        const Part& part = parts_[pieces_.owner(group[k], v)];
        v = part.first + part.now[v & SurfacePiece::own_part];
      };
      const std::span<const Triangle> corners = pieces_[group[k]].corners;
      auto next = sharp.triangles.begin();  // the triangles of sharp cubes are omitted, in their order
      for (Triangle t : corners) {
        if (next != sharp.triangles.end() && t == *next) {
          ++next;
          continue;
        }
        for (std::uint32_t& v : t) rename(v);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) left.push_back(t);
      }
      left.shrink_to_fit();
      for (Triangle& t : sharp.triangles)
        for (std::uint32_t& v : t) rename(v);
      for (Seam& seam : sharp.seams)
        for (std::uint32_t& v : seam.ends) rename(v);
    });
    for (const std::size_t index : group) {
      SharpCubes& sharp = parts_[index].sharp;
      sharp_.cubes.insert(sharp_.cubes.end(), sharp.cubes.begin(), sharp.cubes.end());
      sharp_.triangles.insert(sharp_.triangles.end(), sharp.triangles.begin(), sharp.triangles.end());
      sharp_.seams.insert(sharp_.seams.end(), sharp.seams.begin(), sharp.seams.end());
      sharp = {};
    }
  }
  /// Releases a piece.
  void forget(std::size_t index) {
    parts_[index] = {};
    if (gauge_) gauge_->forget(index);
  }

  ClosedMesh take() {
    ClosedMesh whole;
    const auto put_together = [&](auto& into, const auto& of) {
      std::size_t count = 0;
      for (ClosedMesh& chunk : chunks_) count += of(chunk).size();
      into.reserve(count);
      for (ClosedMesh& chunk : chunks_) {
        into.insert(into.end(), of(chunk).begin(), of(chunk).end());
        of(chunk) = {};
      }
    };
    put_together(whole.mesh.triangles, [](ClosedMesh& c) -> auto& { return c.mesh.triangles; });
    put_together(whole.mesh.vertices, [](ClosedMesh& c) -> auto& { return c.mesh.vertices; });
    put_together(whole.cuts, [](ClosedMesh& c) -> auto& { return c.cuts; });
    put_together(whole.deviations, [](ClosedMesh& c) -> auto& { return c.deviations; });
    if (!sharp_.cubes.empty()) close_sharp_cubes(sharp_, pieces_.lattice(), gauge_, whole);
    return whole;
  }

 private:
  /// A vertex on a flat: number of its flat, and its Morton index there.
  using Spot = std::pair<std::uint64_t, std::uint32_t>;
  struct Part {
    std::vector<std::uint8_t> level;  ///< for each edge's vertex: its axis, and whether all its
                                      ///< triangles are perpendicular to it
    std::vector<std::uint32_t> now;   ///< index of each vertex among the remaining ones
    ClosedMesh left;                  ///< the remaining vertices, without triangles
    std::uint32_t first = 0;          ///< index of the first of them in the whole mesh
    SharpCubes sharp;
  };

  /// Finds a piece's sharp cubes. Their vertices are not merged, so that the cubes' triangles stay in them.
  void find_sharp_cubes(std::size_t index) {
    SharpCubes& sharp = parts_[index].sharp;
    sharp = seams_->find(index, [&](std::size_t owner, std::uint32_t v) {
      return std::atomic_ref(parts_[owner].level[v]).load(std::memory_order_relaxed);
    });
    for (const Triangle& t : sharp.triangles)
      for (const std::uint32_t corner : t) {
        std::vector<std::uint8_t>& levels = parts_[pieces_.owner(index, corner)].level;
        const std::uint32_t v = corner & SurfacePiece::own_part;
        if (v < levels.size()) std::atomic_ref(levels[v]).fetch_or(not_level, std::memory_order_relaxed);
      }
  }

  /// A piece's vertices in the interior of flats, in Morton order.
  static std::vector<Spot> spots_on_flats(const SurfacePiece& piece, const std::vector<std::uint8_t>& level) {
    using Flat = std::array<std::uint32_t, 4>;  // axis, the edges' lower points, level, cut
    std::map<Flat, std::uint64_t> flats;
    Flat last{};
    std::uint64_t number = 0;
    std::vector<Spot> spots;
    spots.reserve(level.size());
    std::uint32_t v = 0;
    piece.for_each_edge([&](const Index3& p, std::size_t axis) {
      if ((level[v] & (axis_part | not_level)) == axis) {
        const Flat flat{static_cast<std::uint32_t>(axis) + 1, static_cast<std::uint32_t>(p[axis] + 1),
                        std::bit_cast<std::uint32_t>(piece.vertices[v][axis]), piece.cuts[v]};
        // vertices come row by row
        if (flat != last) number = flats.try_emplace(flat, flats.size()).first->second, last = flat;
        const auto along = [&](std::size_t a) {
          return static_cast<std::uint32_t>(p[a] - std::max(piece.region.lower[a], 0));
        };
        spots.emplace_back(number << 32 | interleaved(along((axis + 1) % 3), along((axis + 2) % 3)), v);
      }
      ++v;
    });
    std::sort(spots.begin(), spots.end());
    return spots;
  }

  /// Whether the given number of spots from an index on forms a complete square that may be merged.
  [[nodiscard]] bool is_square(std::size_t index, const std::vector<Spot>& spots, std::size_t from,
                               std::size_t size) const {
    if (spots[from].first % size != 0 || from + size > spots.size()) return false;
    if (spots[from + size - 1].first != spots[from].first + size - 1) return false;
    if (!gauge_) return true;
    const std::vector<float>& deviations = gauge_->at(index);
    float lowest = deviations[spots[from].second], highest = lowest;
    for (std::size_t k = from; k < from + size; ++k) {
      lowest = std::min(lowest, deviations[spots[k].second]);
      highest = std::max(highest, deviations[spots[k].second]);
    }
    return gauge_->alike(lowest, highest);
  }

  const SurfacePieces& pieces_;
  DeviationGauge* gauge_;
  std::optional<SeamFinder> seams_;
  std::vector<Part> parts_;
  SharpCubes sharp_;
  std::vector<ClosedMesh> chunks_;
  std::size_t vertices_ = 0;
};

}  // namespace

ClosedMesh closed_mesh(const Stock& stock, StockEdges edges, DeviationGauge* gauge, Progress& progress) {
  SurfacePieces pieces(stock);
  std::optional<CutSurfaces> surfaces;
  if (edges == StockEdges::sharp) surfaces.emplace(stock);
  if (surfaces && surfaces->none()) surfaces.reset();
  Merging merging(pieces, surfaces ? &*surfaces : nullptr, gauge);
  const std::vector<std::vector<std::size_t>> waves = pieces.waves();
  const auto each = [&](const std::vector<std::size_t>& wave, const auto& body) {
    parallel_for(wave.size(), [&](std::size_t k) {
      progress.check();
      body(wave[k]);
    });
  };
  const auto begin = [&](const std::vector<std::size_t>& wave) {
    each(wave, [&](std::size_t i) { pieces.make_vertices(i, stock), merging.begin(i); });
  };
  const auto end = [&](const std::vector<std::size_t>& wave) {
    merging.add_triangles(wave);
    for (const std::size_t i : wave) pieces[i] = {}, merging.forget(i);
  };
  begin(waves[0]);
  for (std::size_t w = 0; w < waves.size(); ++w) {
    if (w + 1 < waves.size()) begin(waves[w + 1]);
    each(waves[w], [&](std::size_t i) { pieces.march(i, stock, surfaces.has_value()), merging.mark(i); });
    each(waves[w], [&](std::size_t i) { merging.merge(i); });
    merging.add_vertices(waves[w]);
    if (w > 0) end(waves[w - 1]);
  }
  end(waves.back());
  return merging.take();
}

ClosedMesh closed_mesh(const SurfacePieces& pieces) {
  Merging merging(pieces, nullptr, nullptr);
  std::vector<std::size_t> all;
  for (const auto& wave : pieces.waves()) all.insert(all.end(), wave.begin(), wave.end());
  const auto each = [&](const auto& body) { parallel_for(all.size(), [&](std::size_t k) { body(all[k]); }); };
  each([&](std::size_t i) { merging.begin(i); });
  each([&](std::size_t i) { merging.mark(i); });
  each([&](std::size_t i) { merging.merge(i); });
  merging.add_vertices(all);
  merging.add_triangles(all);
  return merging.take();
}

TriangleMesh Stock::mesh(std::vector<std::uint32_t>* cuts, Progress& progress, StockEdges edges) const {
  ClosedMesh closed = closed_mesh(*this, edges, nullptr, progress);
  if (cuts) *cuts = std::move(closed.cuts);
  return std::move(closed.mesh);
}

}  // namespace fieldfab::cam

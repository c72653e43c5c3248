#include "cells.h"

#include <algorithm>
#include <map>

#include "block.h"
#include "by_leaf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::contouring {
namespace {

using Position = std::array<float, 3>;
using Triangle = std::array<std::uint32_t, 3>;

/// A curve seen from outside one of its two leafs: the inside of the solid is to its left.
struct CellCurve {
  std::uint32_t leaf, from, to, bend;
};

/// Vertices and triangles of a run of leafs. Their own vertices are numbered from `first_new` on,
/// and renumbered when runs are joined.
struct Piece {
  std::vector<Position> vertices;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> creased;  ///< triangles of cells that a sharp edge may pass through
};

constexpr std::uint32_t first_new = 1U << 31;

class CellFiller {
 public:
  /// `leafs`: those that are to be filled.
  CellFiller(const Field& solid, const Lattice& lattice, const Curves& curves, const ContourSettings& settings,
             std::span<const Leaf> leafs, Piece& piece)
      : solid_(solid), lattice_(lattice), curves_(curves), settings_(settings), leafs_(leafs), piece_(piece) {}

  /// Fills one leaf, given the curves on its faces.
  void fill(const Leaf& leaf, std::span<CellCurve> around) {
    const auto first = static_cast<std::uint32_t>(piece_.triangles.size());
    const std::size_t length = first_loop(around);
    if (length < around.size())
      fill_several(leaf, around);
    else if (!fill_flat(leaf, around))
      fill_fan(leaf, around);
    // The edges in divided cells are close enough to the surface already.
    if (settings_.features && leaf.level >= lattice_.voxel_level() && is_creased(leaf, around) && !is_smooth(leaf))
      for (auto t = first; t < piece_.triangles.size(); ++t) piece_.creased.push_back(t);
  }

 private:
  /// Orders `around` so that its first curves form a closed loop; returns their number.
  static std::size_t first_loop(std::span<CellCurve> around) {
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (around[i].to == around[0].from) return i + 1;
      const auto next = std::find_if(around.begin() + static_cast<std::ptrdiff_t>(i) + 1, around.end(),
                                     [&](const CellCurve& curve) { return curve.from == around[i].to; });
      if (next == around.end()) break;
      std::swap(around[i + 1], *next);
    }
    throw Error(ErrorKind::internal, "contour", "the curves around a cell do not close");
  }

  [[nodiscard]] Box box(const Leaf& leaf) const { return lattice_.cube(leaf.lower, leaf.level); }
  /// Edge of the cells that were merged into a leaf, or a voxel: the resolution of the surface
  /// there.
  [[nodiscard]] double cell_side(const Leaf& leaf) const {
    return lattice_.side(std::min(leaf.level, lattice_.voxel_level()));
  }
  [[nodiscard]] std::uint32_t bend_vertex(std::uint32_t bend) const {
    return static_cast<std::uint32_t>(curves_.positions.size()) + bend;
  }

  static Position to_floats(const Vec3& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }

  std::uint32_t add(const Vec3& position) {
    piece_.vertices.push_back(to_floats(position));
    return first_new + static_cast<std::uint32_t>(piece_.vertices.size() - 1);
  }

  /// Returns whether the surface turns by more than 25 degrees in a leaf and its tangent planes
  /// meet near by. If they do not, the cells are too coarse to detect an edge.
  [[nodiscard]] bool is_creased(const Leaf& leaf, std::span<const CellCurve> around) {
    constexpr float least_cosine = 0.9F;
    scratch_.clear();
    for (const CellCurve& curve : around) scratch_.push_back(curves_.points[curve.from]);
    const Eigen::Vector3f normal = scratch_[0].normal;
    return std::any_of(scratch_.begin(), scratch_.end(),
                       [&](const SurfacePoint& p) { return p.normal.dot(normal) < least_cosine; }) &&
           place_vertex(scratch_, box(leaf).grown(2 * cell_side(leaf))).error < 0.1 * cell_side(leaf);
  }

  /// Whether edges there come from noise, although the solid as a whole may have edges (a scan on a
  /// pedestal).
  [[nodiscard]] bool is_smooth(const Leaf& leaf) {
    const auto surroundings = [&](const Leaf& one) { return box(one).grown(cell_side(one)); };
    if (!near_) {
      Box all = surroundings(leafs_[0]);
      for (const Leaf& one : leafs_) all = hull(all, surroundings(one));
      near_ = solid_.restricted(all, Purpose::occupancy).field;
    }
    return near_->restricted(surroundings(leaf), Purpose::occupancy).field->smooth();
  }

  /// A straight loop of three or four points in one plane needs no vertex inside the cell.
  bool fill_flat(const Leaf& leaf, std::span<const CellCurve> loop) {
    if (loop.size() > 4) return false;
    for (const CellCurve& curve : loop)
      if (curve.bend != no_vertex) return false;
    const double flat = 0.5 * permitted_error(settings_, lattice_.side(leaf.level));
    for (const CellCurve& one : loop)
      for (const CellCurve& other : loop) {
        const SurfacePoint& p = curves_.points[one.from];
        const SurfacePoint& q = curves_.points[other.from];
        if (p.normal.dot(q.normal) < 0.97F || std::abs(p.normal.dot(q.position - p.position)) > flat) return false;
      }
    if (loop.size() == 3) {
      piece_.triangles.push_back({loop[2].from, loop[1].from, loop[0].from});
      return true;
    }
    // A diagonal must run through the inside of the cell, not along a face that may contain a
    // neighbour's triangles.
    const Box cell = box(leaf);
    const auto length = [&](std::size_t i) -> double {
      const Position& p = curves_.positions[loop[i].from];
      const Position& q = curves_.positions[loop[i + 2].from];
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        if (p[axis] == q[axis] && (p[axis] == cell.lower[a] || p[axis] == cell.upper[a]))
          return std::numeric_limits<double>::infinity();
        sum += (p[axis] - q[axis]) * (p[axis] - q[axis]);
      }
      return sum;
    };
    const double first = length(0), second = length(1);
    if (std::isinf(first) && std::isinf(second)) return false;
    const std::size_t i = first <= second ? 0 : 1;
    const std::array<std::uint32_t, 4> v{loop[i].from, loop[i + 1].from, loop[i + 2].from, loop[(i + 3) % 4].from};
    piece_.triangles.push_back({v[2], v[1], v[0]});
    piece_.triangles.push_back({v[3], v[2], v[0]});
    return true;
  }

  /// Connects a vertex strictly inside the cell with the loop on its faces. The triangles meet in
  /// their common edges only, since each ray from that vertex leaves the convex cell through one
  /// point.
  void fill_fan(const Leaf& leaf, std::span<const CellCurve> loop) {
    const Box cell = box(leaf);
    Vec3 vertex = leaf.vertex.cast<double>();
    if (!leaf.merged) {
      scratch_.clear();
      for (const CellCurve& curve : loop) scratch_.push_back(curves_.points[curve.from]);
      vertex = place_vertex(scratch_, cell).position;
    }
    const Box inner = cell.grown(-lattice_.margin(leaf.level));
    const std::uint32_t apex = add(vertex.cwiseMax(inner.lower).cwiseMin(inner.upper));
    for (const CellCurve& curve : loop) {
      if (curve.bend == no_vertex) {
        piece_.triangles.push_back({apex, curve.to, curve.from});
      } else {
        const std::uint32_t bend = bend_vertex(curve.bend);
        piece_.triangles.push_back({apex, bend, curve.from});
        piece_.triangles.push_back({apex, curve.to, bend});
      }
    }
  }

  /// Fills a smallest cell with several patches. The cell's centre counts as inside or outside.
  /// Each region of the boundary with the other sign is drawn in halfway to the centre and keeps
  /// its rim. Seen from the centre that is one layer, so no triangles intersect.
  void fill_several(const Leaf& leaf, std::span<const CellCurve> around) {
    if (leaf.merged) throw Error(ErrorKind::internal, "contour", "a merged cell has several patches");
    const Box cell = box(leaf);
    const bool centre_inside = solid_.value(cell.centre()) < 0;
    std::array<std::uint32_t, 8> drawn;
    drawn.fill(no_vertex);
    const auto is_other = [&](unsigned corner) {
      return (leaf.corners >> corner & 1U) != static_cast<unsigned>(centre_inside);
    };
    const auto draw = [&](unsigned corner) {
      if (drawn[corner] != no_vertex) return drawn[corner];
      const Vec3 place((corner & 1U) != 0 ? cell.upper.x() : cell.lower.x(),
                       (corner & 2U) != 0 ? cell.upper.y() : cell.lower.y(),
                       (corner & 4U) != 0 ? cell.upper.z() : cell.lower.z());
      return drawn[corner] = add(0.5 * (place + cell.centre()));
    };
    for (unsigned axis = 0; axis < 3; ++axis)
      for (unsigned side = 0; side < 2; ++side)
        fill_face_regions(cell, axis, side, centre_inside, around, is_other, draw);
  }

  template <class IsOther, class Draw>
  void fill_face_regions(const Box& cell, unsigned axis, unsigned side, bool centre_inside,
                         std::span<const CellCurve> around, const IsOther& is_other, const Draw& draw) {
    const auto a = static_cast<Eigen::Index>(axis), u = static_cast<Eigen::Index>((axis + 1) % 3),
               v = static_cast<Eigen::Index>((axis + 2) % 3);
    const double plane = side != 0 ? cell.upper[a] : cell.lower[a];
    const auto at = [&](std::uint32_t vertex, Eigen::Index i) {
      return static_cast<double>(curves_.positions[vertex][static_cast<std::size_t>(i)]);
    };

    // The rim of the face, counter-clockwise seen from outside: four corners, and a vertex between
    // two corners of different sign.
    std::array<unsigned, 4> corner{0U, 1U << u, 1U << u | 1U << v, 1U << v};
    if (side == 0) std::swap(corner[1], corner[3]);
    std::map<std::uint32_t, std::uint32_t> partner;  // joined by a curve in this face
    std::array<std::uint32_t, 4> crossing;           // on the rim between corners i and i+1
    crossing.fill(no_vertex);
    for (const CellCurve& curve : around) {
      if (at(curve.from, a) != plane || at(curve.to, a) != plane) continue;
      partner[curve.from] = curve.to;
      partner[curve.to] = curve.from;
      for (const std::uint32_t vertex : {curve.from, curve.to})
        for (std::size_t i = 0; i < 4; ++i) {
          const unsigned one = corner[i], next = corner[(i + 1) % 4];
          const Eigen::Index fixed = ((one ^ next) >> u & 1U) != 0 ? v : u;
          if (at(vertex, fixed) == ((one >> fixed & 1U) != 0 ? cell.upper[fixed] : cell.lower[fixed]))
            crossing[i] = vertex;
        }
    }

    // Each region of the other sign is a polygon of drawn-in corners and rim vertices; each is
    // walked once.
    std::array<bool, 4> walked{};
    for (std::size_t start = 0; start < 4; ++start) {
      if (walked[start] || !is_other(corner[start] | side << axis)) continue;
      std::vector<std::uint32_t> polygon;
      for (std::size_t i = start; !walked[i];) {
        walked[i] = true;
        polygon.push_back(draw(corner[i] | side << axis));
        if (crossing[i] == no_vertex) {
          i = (i + 1) % 4;
          continue;
        }
        polygon.push_back(crossing[i]);
        const std::uint32_t entry = partner.at(crossing[i]);
        polygon.push_back(entry);
        i = (static_cast<std::size_t>(std::find(crossing.begin(), crossing.end(), entry) - crossing.begin()) + 1) % 4;
      }
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        if (centre_inside)
          piece_.triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
        else
          piece_.triangles.push_back({polygon[0], polygon[i + 1], polygon[i]});
      }
    }
  }

  const Field& solid_;
  const Lattice& lattice_;
  const Curves& curves_;
  const ContourSettings& settings_;
  std::span<const Leaf> leafs_;
  FieldPtr near_;  ///< the solid around `leafs_`, once it was needed
  Piece& piece_;
  std::vector<SurfacePoint> scratch_;
};

/// Joins the pieces, which are emptied, behind the vertices of the curves.
FilledCells joined(const Curves& curves, std::vector<Piece>& pieces) {
  struct Place {
    std::size_t vertex, triangle;
  };
  std::vector<Place> first(pieces.size());
  Place end{curves.positions.size() + curves.bends.size(), 0};
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    first[i] = end;
    end.vertex += pieces[i].vertices.size(), end.triangle += pieces[i].triangles.size();
  }
  if (end.vertex >= first_new)
    throw Error(ErrorKind::too_large, "contour", "the mesh would have more than 2^31 vertices");
  FilledCells filled;
  TriangleMesh& mesh = filled.mesh;
  parallel_for(2, [&](std::size_t which) {
    if (which == 1) return mesh.triangles.resize(end.triangle);
    mesh.vertices.reserve(end.vertex);
    mesh.vertices = curves.positions;
    mesh.vertices.insert(mesh.vertices.end(), curves.bends.begin(), curves.bends.end());
    mesh.vertices.resize(end.vertex);
  });
  parallel_for(pieces.size(), [&](std::size_t i) {
    Piece& piece = pieces[i];
    std::copy(piece.vertices.begin(), piece.vertices.end(),
              mesh.vertices.begin() + static_cast<std::ptrdiff_t>(first[i].vertex));
    const auto offset = static_cast<std::uint32_t>(first[i].vertex);
    auto to = mesh.triangles.begin() + static_cast<std::ptrdiff_t>(first[i].triangle);
    for (Triangle triangle : piece.triangles) {
      for (std::uint32_t& vertex : triangle)
        if (vertex >= first_new) vertex = vertex - first_new + offset;
      *to++ = triangle;
    }
    piece.vertices = {};
    piece.triangles = {};
  });
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (const std::uint32_t t : pieces[i].creased)
      filled.creased.push_back(static_cast<std::uint32_t>(first[i].triangle) + t);
  return filled;
}

}  // namespace

FilledCells fill_cells(const Field& solid, const Lattice& lattice, const Octree& octree, const Curves& curves,
                       const ContourSettings& settings, Progress& progress) {
  const std::span<const Leaf> leafs = octree.leafs();
  std::vector<Piece> pieces(runs_of(leafs.size()));
  const auto list = [&](std::size_t i, const auto& add) {
    for (const FaceCurve& curve : curves.curves[i]) {
      add({curve.lower, curve.from, curve.to, curve.bend});
      add({curve.upper, curve.to, curve.from, curve.bend});
    }
  };
  treat_by_leaf<CellCurve>(leafs.size(), curves.curves.size(), list,
                           [&](std::size_t run, std::span<const std::uint32_t> start, std::span<CellCurve> around) {
                             progress.check();
                             const std::span here = leafs.subspan(run * leafs_a_run, start.size() - 1);
                             CellFiller filler(solid, lattice, curves, settings, here, pieces[run]);
                             for (std::size_t i = 0; i < here.size(); ++i)
                               if (start[i] < start[i + 1] && octree.extent().contains(here[i].lower))
                                 filler.fill(here[i], around.subspan(start[i], start[i + 1] - start[i]));
                           });
  return joined(curves, pieces);
}

}  // namespace fieldfab::contouring

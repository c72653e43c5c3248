#include "curves.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "by_leaf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::contouring {
namespace {

/// A vertex on the rim of a face. Sides are numbered from 0, counter-clockwise around the rim seen
/// from above the face.
struct RimPoint {
  std::uint32_t leaf;   ///< below the face
  std::uint32_t upper;  ///< the leaf above it
  std::uint32_t vertex;
  std::uint8_t axis;
  std::uint8_t side;
  bool leaving;  ///< counter-clockwise, the rim passes from inside the solid to outside here
};

/// Faces that meet in an edge along axis a, as pairs of the four cells around it: cell 0 is below
/// on both other axes u, v; 1 above on u; 2 above on both; 3 above on v. `side` is the side of the
/// face that the edge is on; `forward`, whether the rim runs along +a.
struct EdgeFace {
  int lower, upper, normal_offset, side;
  bool forward;
};
constexpr std::array<EdgeFace, 4> faces_of_edge{
    {{0, 1, 1, 1, true}, {1, 2, 2, 0, true}, {3, 2, 1, 3, false}, {0, 3, 2, 2, false}}};

class CurveTracer {
 public:
  CurveTracer(const Field& solid, const Lattice& lattice, const Octree& octree, Progress& progress)
      : solid_(solid), lattice_(lattice), octree_(octree), progress_(progress) {}

  Curves run(bool features) {
    std::vector<BlockPoints> found = points_of_blocks();
    take_points(found);
    join_rim_points(found);
    if (features) bend_curves();
    return std::move(out_);
  }

 private:
  struct BlockPoints {
    std::vector<SurfacePoint> points;
    std::vector<std::array<float, 3>> positions;
    std::vector<RimPoint> rim;  // vertices counted from the block's first
    std::uint32_t first = 0;    // number of the block's first vertex
  };

  [[nodiscard]] std::vector<BlockPoints> points_of_blocks() const {
    const auto& blocks = octree_.blocks();
    std::vector<BlockPoints> found(blocks.size());
    parallel_for(blocks.size(), [&](std::size_t i) {
      if (i % 64 == 0) progress_.check();
      found[i] = points_of(blocks[i]);
    });
    return found;
  }

  /// Moves the points out of the blocks and numbers them.
  void take_points(std::vector<BlockPoints>& found) {
    std::uint32_t count = 0;
    for (BlockPoints& block : found) {
      block.first = count;
      count += static_cast<std::uint32_t>(block.points.size());
    }
    parallel_for(2, [&](std::size_t which) { which == 0 ? out_.points.resize(count) : out_.positions.resize(count); });
    parallel_for(found.size(), [&](std::size_t i) {
      BlockPoints& block = found[i];
      std::copy(block.points.begin(), block.points.end(), out_.points.begin() + block.first);
      std::copy(block.positions.begin(), block.positions.end(), out_.positions.begin() + block.first);
      block.points = {};
      block.positions = {};
    });
  }

  BlockPoints points_of(const Block& block) const {
    BlockPoints found;
    const auto neighbours = octree_.lower_neighbours(block);
    for (const Crossing& crossing : block.crossings) {
      if (!is_wanted(block, crossing)) continue;
      std::array<std::uint32_t, 4> cells{};
      bool halved = false;
      for (std::size_t quadrant = 0; quadrant < 4; ++quadrant)
        cells[quadrant] = leaf_at(neighbours, cell_beside(crossing, quadrant), halved);
      if (!halved)
        add_point(crossing, cells, lattice_.plane_range(block.lower, lattice_.voxel_level(), crossing.lower), found);
    }
    for (const Division& division : block.divisions)
      for (const Crossing& crossing : division.crossings) add_point_of_division(division, crossing, found);
    return found;
  }

  /// Returns whether one of the four cells around an edge of voxels gets triangles.
  [[nodiscard]] bool is_wanted(const Block& block, const Crossing& crossing) const {
    const int step = lattice_.voxel_level();
    for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
      const std::array<int, 3> cell = cell_beside(crossing, quadrant);
      if (octree_.extent().contains(
              moved(block.lower, cell[0] * (1 << step), cell[1] * (1 << step), cell[2] * (1 << step))))
        return true;
    }
    return false;
  }

  /// Returns the cell in one quadrant around an edge, in the unit and from the origin of the
  /// crossing. Quadrant 0 is below on both other axes u, v; 1 above on u; 2 above on both; 3 above
  /// on v.
  static std::array<int, 3> cell_beside(const Crossing& crossing, std::size_t quadrant) {
    const auto a = static_cast<std::size_t>(crossing.axis), u = (a + 1) % 3, v = (a + 2) % 3;
    std::array<int, 3> cell{crossing.lower[0], crossing.lower[1], crossing.lower[2]};
    if (quadrant == 0 || quadrant == 3) --cell[u];
    if (quadrant == 0 || quadrant == 1) --cell[v];
    return cell;
  }

  /// An edge of a divided cell is an edge of the leafs if no cell around it is smaller. Several
  /// divisions may sample it; the division of the first cell of that size adds it.
  void add_point_of_division(const Division& division, const Crossing& crossing, BlockPoints& found) const {
    std::array<std::uint32_t, 4> cells{};
    bool taken = false;
    for (std::size_t quadrant = 0; quadrant < 4; ++quadrant) {
      const std::array<int, 3> beside = cell_beside(crossing, quadrant);
      const bool own = std::all_of(beside.begin(), beside.end(), [](int i) { return i == 0 || i == 1; });
      const int level = division.level;
      const CellFound cell = octree_.find(
          moved(division.lower, beside[0] * (1 << level), beside[1] * (1 << level), beside[2] * (1 << level)), level);
      if (cell.divided) return;
      if (cell.level == level && !taken) {
        if (!own) return;
        taken = true;
      }
      cells[quadrant] = checked(cell.leaf);
    }
    add_point(crossing, cells, lattice_.plane_range(division.lower, division.level, crossing.lower), found);
  }

  /// Adds the point on an edge, also to the rims of the faces between the four leafs around it.
  void add_point(const Crossing& crossing, const std::array<std::uint32_t, 4>& cells, const Box& edge,
                 BlockPoints& found) const {
    // An edge inside a leaf, or inside the face between two leafs, is not an edge of the leafs.
    int distinct = 1;
    for (std::size_t i = 1; i < 4; ++i)
      distinct += std::find(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(i), cells[i]) ==
                  cells.begin() + static_cast<std::ptrdiff_t>(i);
    if (distinct < 3) return;
    const auto vertex = static_cast<std::uint32_t>(found.points.size());
    found.points.push_back(crossing.point);
    found.positions.push_back(on_edge(crossing, edge));
    for (const EdgeFace& face : faces_of_edge) {
      const std::uint32_t lower = cells[static_cast<std::size_t>(face.lower)],
                          upper = cells[static_cast<std::size_t>(face.upper)];
      if (lower == upper || !(gets_triangles(lower) || gets_triangles(upper))) continue;
      found.rim.push_back({lower, upper, vertex, static_cast<std::uint8_t>((crossing.axis + face.normal_offset) % 3),
                           static_cast<std::uint8_t>(face.side), crossing.lower_inside == face.forward});
    }
  }

  [[nodiscard]] bool gets_triangles(std::uint32_t leaf) const {
    return octree_.extent().contains(octree_.leafs()[leaf].lower);
  }

  /// Returns the leaf of a cell, a voxel wide, counted from the lower corner of the first of
  /// `neighbours`; sets `halved` if the cell is divided.
  static std::uint32_t leaf_at(const std::array<const Block*, 8>& neighbours, std::array<int, 3> cell, bool& halved) {
    unsigned which = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0) {
        which |= 1U << axis;
        cell[axis] += block_side;
      }
    const Block* block = neighbours[which];
    if (block == nullptr) return checked(Division::none);
    const std::size_t number = Block::cell(cell[0], cell[1], cell[2]);
    if (block->division_at(number) != Division::none) {
      halved = true;
      return Division::none;
    }
    const std::uint16_t leaf = block->leaf_at(number);
    return checked(leaf == Block::no_leaf ? Division::none : block->first_leaf + leaf);
  }

  static std::uint32_t checked(std::uint32_t leaf) {
    if (leaf == Division::none)
      throw Error(ErrorKind::internal, "contour",
                  "a Field's interval or its restriction does not agree with its values");
    return leaf;
  }

  /// Position of the crossing, moved away from the ends of its edge, which runs from `edge.lower`
  /// along its axis to `edge.upper`.
  [[nodiscard]] std::array<float, 3> on_edge(const Crossing& crossing, const Box& edge) const {
    std::array<float, 3> position{};
    const double margin = lattice_.margin(edge_level(edge, crossing.axis));
    for (int axis = 0; axis < 3; ++axis) {
      double place = edge.lower[axis];
      if (axis == crossing.axis)
        place =
            std::clamp(static_cast<double>(crossing.point.position[axis]), place + margin, edge.upper[axis] - margin);
      position[static_cast<std::size_t>(axis)] = static_cast<float>(place);
    }
    return position;
  }
  /// Level of the edge: log2 of its length in finest cells.
  [[nodiscard]] int edge_level(const Box& edge, int axis) const {
    return static_cast<int>(std::lround(std::log2((edge.upper[axis] - edge.lower[axis]) / lattice_.side(0, axis))));
  }

  /// Joins the points around each face.
  void join_rim_points(const std::vector<BlockPoints>& found) {
    const std::size_t leafs = octree_.leafs().size();
    out_.curves.resize(runs_of(leafs));
    const auto list = [&](std::size_t i, const auto& add) {
      for (RimPoint point : found[i].rim) {
        point.vertex += found[i].first;
        add(point);
      }
    };
    treat_by_leaf<RimPoint>(leafs, found.size(), list,
                            [&](std::size_t run, std::span<const std::uint32_t> start, std::span<RimPoint> rim) {
                              progress_.check();
                              out_.curves[run].reserve(rim.size() / 2);
                              for (std::size_t i = 0; i + 1 < start.size(); ++i)
                                join_around(rim.subspan(start[i], start[i + 1] - start[i]), out_.curves[run]);
                            });
  }

  /// Joins the points on the faces above one leaf.
  void join_around(std::span<RimPoint> rim, std::vector<FaceCurve>& curves) const {
    std::sort(rim.begin(), rim.end(), [](const RimPoint& one, const RimPoint& other) {
      return one.upper != other.upper ? one.upper < other.upper : one.side < other.side;
    });
    for (std::size_t first = 0, last = 0; first < rim.size(); first = last) {
      while (last < rim.size() && rim[last].upper == rim[first].upper) ++last;
      if (last - first == 2 && rim[first].leaving != rim[first + 1].leaving)
        curves.push_back(joined(rim[first], rim[first + 1]));
      else if (last - first == 4)
        join_ambiguous(rim.subspan(first, 4), curves);
      else
        throw Error(ErrorKind::internal, "contour", "a face has an impossible number of crossings");
    }
  }

  static FaceCurve joined(const RimPoint& one, const RimPoint& other) {
    const RimPoint& leaving = one.leaving ? one : other;
    const RimPoint& entering = one.leaving ? other : one;
    return {one.leaf, one.upper, leaving.vertex, entering.vertex, no_vertex, one.axis};
  }

  /// Adds two curves across one ambiguous face: corners with the sign of its centre are joined, the
  /// two other corners are cut off.
  void join_ambiguous(std::span<const RimPoint> rim, std::vector<FaceCurve>& curves) const {
    const FaceCurve face{rim[0].leaf, rim[0].upper, 0, 0, no_vertex, rim[0].axis};
    const bool centre_inside = solid_.value(rectangle(face).centre()) < 0;
    for (std::size_t i = 0; i < 4; ++i)
      if (rim[i].leaving == centre_inside) curves.push_back(joined(rim[i], rim[(i + 1) % 4]));
  }

  /// Level of the face that a curve crosses.
  [[nodiscard]] int level_of(const FaceCurve& curve) const {
    return std::min(octree_.leafs()[curve.lower].level, octree_.leafs()[curve.upper].level);
  }
  [[nodiscard]] Box rectangle(const FaceCurve& curve) const {
    const Leaf& below = octree_.leafs()[curve.lower];
    const Leaf& above = octree_.leafs()[curve.upper];
    return intersection(lattice_.cube(below.lower, below.level), lattice_.cube(above.lower, above.level));
  }

  /// Adds a bend to a curve, at the intersection of the tangent lines at its ends, if the surface
  /// passes closer there than to the straight line. So sharp edges cross faces at the right points.
  /// If the intersection is on the rim of the face or beyond, the bend is halfway, and sharpen()
  /// moves it. On faces of merged cells, where halfway can be many voxels off, it is moved inwards.
  void bend_curves() {
    struct Bend {
      FaceCurve* curve;
      Vec3 place;
    };
    std::vector<std::vector<Bend>> accepted(out_.curves.size());
    parallel_for(accepted.size(), [&](std::size_t run) {
      progress_.check();
      std::vector<Bend> proposed;
      for (FaceCurve& curve : out_.curves[run])
        if (const auto place = propose_bend(curve)) proposed.push_back({&curve, *place});
      if (proposed.empty()) return;
      const std::size_t count = proposed.size();
      std::vector<float> x(2 * count), y(2 * count), z(2 * count), value(2 * count);
      for (std::size_t i = 0; i < count; ++i) {
        const Vec3 middle = middle_of(*proposed[i].curve);
        x[i] = static_cast<float>(proposed[i].place.x()), x[count + i] = static_cast<float>(middle.x());
        y[i] = static_cast<float>(proposed[i].place.y()), y[count + i] = static_cast<float>(middle.y());
        z[i] = static_cast<float>(proposed[i].place.z()), z[count + i] = static_cast<float>(middle.z());
      }
      solid_.values({x.data(), y.data(), z.data(), 2 * count}, value.data());
      for (std::size_t i = 0; i < count; ++i)
        if (std::abs(value[i]) < 0.5F * std::abs(value[count + i])) accepted[run].push_back(proposed[i]);
    });
    for (const auto& run : accepted)
      for (const Bend& bend : run) {
        FaceCurve& curve = *bend.curve;
        curve.bend = static_cast<std::uint32_t>(out_.bends.size());
        const Box inner = rectangle(curve).grown(-lattice_.margin(level_of(curve)));
        const int u = (curve.axis + 1) % 3, v = (curve.axis + 2) % 3;
        const auto within = [&](int axis) {
          return bend.place[axis] >= inner.lower[axis] && bend.place[axis] <= inner.upper[axis];
        };
        const bool merged = level_of(curve) > lattice_.voxel_level();
        Vec3 place = (within(u) && within(v)) || merged ? bend.place : middle_of(curve);
        for (const int axis : {u, v}) place[axis] = std::clamp(place[axis], inner.lower[axis], inner.upper[axis]);
        out_.bends.push_back(to_floats(place));
      }
  }

  static std::array<float, 3> to_floats(const Vec3& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
  }

  /// Midpoint of the straight line between a curve's ends; strictly inside the face, since the ends
  /// lie on different sides of it.
  [[nodiscard]] Vec3 middle_of(const FaceCurve& curve) const {
    const auto& p = out_.positions[curve.from];
    const auto& q = out_.positions[curve.to];
    return 0.5 * (Vec3(p[0], p[1], p[2]) + Vec3(q[0], q[1], q[2]));
  }

  [[nodiscard]] std::optional<Vec3> propose_bend(const FaceCurve& curve) const {
    // Cells with several patches are filled from straight curves only.
    if (!is_simple(octree_.leafs()[curve.lower].corners) || !is_simple(octree_.leafs()[curve.upper].corners))
      return std::nullopt;
    const SurfacePoint& from = out_.points[curve.from];
    const SurfacePoint& to = out_.points[curve.to];
    if (from.normal.dot(to.normal) > 0.9999F) return std::nullopt;
    const int u = (curve.axis + 1) % 3, v = (curve.axis + 2) % 3;
    const Eigen::Vector2d p(from.position[u], from.position[v]), q(to.position[u], to.position[v]);
    const Eigen::Vector2d n(from.normal[u], from.normal[v]), m(to.normal[u], to.normal[v]);
    const double cross = n.x() * m.y() - n.y() * m.x();
    if (std::abs(cross) < 1e-3 * n.norm() * m.norm() || cross == 0) return std::nullopt;
    const double a = n.dot(p), b = m.dot(q);
    const Eigen::Vector2d bend((a * m.y() - b * n.y()) / cross, (n.x() * b - m.x() * a) / cross);
    const Eigen::Vector2d along = q - p, off = bend - p;
    const double length = along.norm();
    // The curve is nearly straight.
    if (std::abs(along.x() * off.y() - along.y() * off.x()) < 1e-3 * length * length) return std::nullopt;
    const Box face = rectangle(curve);
    Vec3 place = face.lower;
    place[u] = bend.x();
    place[v] = bend.y();
    if (!face.grown(lattice_.side(std::min(level_of(curve), lattice_.voxel_level()))).contains(place))
      return std::nullopt;
    return place;
  }

  const Field& solid_;
  const Lattice& lattice_;
  const Octree& octree_;
  Progress& progress_;
  Curves out_;
};

}  // namespace

Curves trace_curves(const Field& solid, const Lattice& lattice, const Octree& octree, bool features,
                    Progress& progress) {
  return CurveTracer(solid, lattice, octree, progress).run(features);
}

}  // namespace fieldfab::contouring

#include "boxes.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <unordered_map>

#include "fieldfab/core/error.h"
#include "surface_field.h"

namespace fieldfab::openscad {
namespace {

using Kind = Part::Kind;
using Place = std::array<std::size_t, 3>;
using Planes = std::array<std::vector<double>, 3>;  // along each axis, ascending

/// Sorts planes. Of planes at most `same` mm apart only the first stays.
void tidy(std::vector<double>& planes, double same) {
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end(), [&](double a, double b) { return b - a <= same; }),
               planes.end());
}

void add_planes(const Boxes& boxes, Planes& planes) {
  if (boxes.kind == Kind::leaf)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const Vec3& corner : {boxes.box.lower, boxes.box.upper})
        planes[axis].push_back(corner[static_cast<Eigen::Index>(axis)]);
  for (const Boxes& child : boxes.children) add_planes(child, planes);
}

Planes cutting_planes(const Boxes& boxes, double same) {
  Planes planes;
  add_planes(boxes, planes);
  for (std::vector<double>& along : planes) tidy(along, same);
  return planes;
}

// A set of the eight cells around a point, as eight bits. Cell a + 2 b + 4 c is beyond the point
// along x, y and z if a, b and c are 1.
using Octants = unsigned;

/// Mirrors a set of cells across an axis.
constexpr Octants mirrored(Octants cells, unsigned axis) {
  constexpr std::array<Octants, 3> before{0b01010101, 0b00110011, 0b00001111};
  return ((cells & before[axis]) << (1U << axis)) | ((cells >> (1U << axis)) & before[axis]);
}

/// Whether the cells are connected through faces.
constexpr bool are_connected(Octants cells) {
  Octants reached = cells & (~cells + 1);
  for (int step = 0; step < 8; ++step)
    for (unsigned axis = 0; axis < 3; ++axis) reached |= cells & mirrored(reached, axis);
  return reached == cells;
}

/// Whether the surface between solid and empty cells touches itself at this point, so that it is
/// not 2-manifold.
bool touch(Octants solid) {
  static constexpr auto known = [] {
    std::array<bool, 256> table{};
    for (Octants cells = 0; cells < table.size(); ++cells)
      table[cells] = !are_connected(cells) || !are_connected(~cells & 255U);
    return table;
  }();
  return known[solid];
}

/// Whether the point is a corner of the solid: neither inside a face nor inside an edge.
bool are_corner(Octants solid) {
  return mirrored(solid, 0) != solid && mirrored(solid, 1) != solid && mirrored(solid, 2) != solid;
}

/// Cells between planes, and empty ones beyond the first and the last plane. Cell i lies before
/// plane i.
struct Grid {
  Planes planes;
  Place size{}, stride{};
  std::vector<std::uint8_t> solid;

  explicit Grid(Planes all) : planes(std::move(all)) {
    std::size_t cells = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      size[axis] = planes[axis].size() + 1;
      stride[axis] = cells;
      cells *= size[axis];
    }
    solid.resize(cells);
  }

  [[nodiscard]] std::size_t index(const Place& cell) const {
    return cell[0] * stride[0] + cell[1] * stride[1] + cell[2] * stride[2];
  }
  /// Returns the solid cells around the point where three planes meet.
  [[nodiscard]] Octants around(const Place& place) const {
    const std::uint8_t* const first = &solid[index(place)];
    Octants cells = 0;
    for (unsigned i = 0; i < 8; ++i)
      cells |= Octants{first[(i & 1U) * stride[0] + (i >> 1U & 1U) * stride[1] + (i >> 2U) * stride[2]]} << i;
    return cells;
  }
  [[nodiscard]] Vec3 point(const Place& place) const {
    return {planes[0][place[0]], planes[1][place[1]], planes[2][place[2]]};
  }
};

/// Returns the cell that contains a coordinate along an axis; the coordinate of a plane belongs to
/// the cell beyond it.
std::size_t cell_at(const std::vector<double>& planes, double at) {
  return static_cast<std::size_t>(std::upper_bound(planes.begin(), planes.end(), at) - planes.begin());
}

/// Boxes by their cells: from `first` to before `last` along each axis.
struct Spans {
  Kind kind;
  Place first{}, last{};
  std::vector<Spans> children = {};
};

Spans spans_of(const Boxes& boxes, const Planes& planes) {
  Spans spans{boxes.kind};
  for (const Boxes& child : boxes.children) spans.children.push_back(spans_of(child, planes));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t &first = spans.first[axis], &last = spans.last[axis];
    if (boxes.kind == Kind::leaf) {
      const auto along = static_cast<Eigen::Index>(axis);
      first = cell_at(planes[axis], boxes.box.lower[along]);
      last = cell_at(planes[axis], boxes.box.upper[along]);
    } else if (!spans.children.empty()) {
      first = spans.children.front().first[axis];
      last = spans.children.front().last[axis];
    }
    for (const Spans& child : spans.children) {
      if (boxes.kind == Kind::subtract) break;
      const bool grows = boxes.kind == Kind::unite;
      first = grows ? std::min(first, child.first[axis]) : std::max(first, child.first[axis]);
      last = grows ? std::max(last, child.last[axis]) : std::min(last, child.last[axis]);
    }
  }
  return spans;
}

/// Cells with one z, from a first x and y to before a last.
class Layer {
 public:
  Layer(std::size_t z, std::array<std::size_t, 2> first, std::array<std::size_t, 2> last)
      : z_(z), first_(first), last_(last), solid_((last[0] - first[0]) * (last[1] - first[1])) {}

  [[nodiscard]] const std::vector<std::uint8_t>& solid() const { return solid_; }

  /// Adds the cells of a part.
  void add(const Spans& part) {
    const std::array first{std::max(first_[0], part.first[0]), std::max(first_[1], part.first[1])},
        last{std::min(last_[0], part.last[0]), std::min(last_[1], part.last[1])};
    if (z_ < part.first[2] || z_ >= part.last[2] || first[0] >= last[0] || first[1] >= last[1]) return;
    if (part.kind == Kind::leaf) {
      for (std::size_t y = first[1]; y < last[1]; ++y)
        std::fill_n(&solid_[index(first[0], y)], last[0] - first[0], std::uint8_t{1});
    } else if (part.kind == Kind::unite) {
      for (const Spans& child : part.children) add(child);
    } else {
      Layer common(z_, first, last);
      common.add(part.children.front());
      for (std::size_t i = 1; i < part.children.size(); ++i) {
        Layer other(z_, first, last);
        other.add(part.children[i]);
        for (std::size_t j = 0; j < other.solid_.size(); ++j)
          if ((other.solid_[j] != 0) == (part.kind == Kind::subtract)) common.solid_[j] = 0;
      }
      for (std::size_t y = first[1]; y < last[1]; ++y)
        for (std::size_t x = first[0]; x < last[0]; ++x) solid_[index(x, y)] |= common.solid_[common.index(x, y)];
    }
  }

 private:
  [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
    return (y - first_[1]) * (last_[0] - first_[0]) + x - first_[0];
  }

  std::size_t z_;
  std::array<std::size_t, 2> first_, last_;
  std::vector<std::uint8_t> solid_;
};

Grid grid_of(const Boxes& boxes, double same, Progress& progress) {
  Grid grid(cutting_planes(boxes, same));
  const Spans spans = spans_of(boxes, grid.planes);
  for (std::size_t z = spans.first[2]; z < spans.last[2]; ++z) {
    progress.check();
    Layer layer(z, {0, 0}, {grid.size[0], grid.size[1]});
    layer.add(spans);
    std::copy(layer.solid().begin(), layer.solid().end(), &grid.solid[z * grid.stride[2]]);
  }
  return grid;
}

/// Extends each solid cell by `growth` along an axis, in both directions.
Grid grown_along(std::size_t axis, const Grid& grid, double growth) {
  const std::vector<double>& before = grid.planes[axis];
  Planes planes = grid.planes;
  planes[axis].clear();
  for (const double at : before)
    for (const double moved : {at - growth, at + growth}) planes[axis].push_back(moved);
  tidy(planes[axis], 0);
  Grid result(std::move(planes));
  const std::vector<double>& after = result.planes[axis];
  const std::size_t inner = grid.stride[axis], outer = grid.solid.size() / (inner * grid.size[axis]);
  for (std::size_t cell = 1; cell < after.size(); ++cell) {
    const double middle = 0.5 * (after[cell - 1] + after[cell]);
    // Cells within `growth`.
    const std::size_t first = cell_at(before, middle - growth), last = cell_at(before, middle + growth);
    for (std::size_t from = first; from <= last; ++from)
      for (std::size_t i = 0; i < outer; ++i) {
        const std::uint8_t* const source = &grid.solid[(i * grid.size[axis] + from) * inner];
        std::uint8_t* const target = &result.solid[(i * result.size[axis] + cell) * inner];
        for (std::size_t j = 0; j < inner; ++j) target[j] |= source[j];
      }
  }
  return result;
}

/// Makes triangles of the faces between solid and empty cells. All faces in one plane with the same
/// orientation are triangulated together. An edge ends at the same points in all faces that share
/// it: at corners of the solid.
class Surface {
 public:
  /// Throws bad_input if the surface touches itself.
  explicit Surface(const Grid& grid) : grid_(grid) {
    for (std::size_t axis = 0; axis < 3; ++axis) planes_[axis].resize(grid.planes[axis].size());
    for (std::size_t z = 0; z + 1 < grid.size[2]; ++z)
      for (std::size_t y = 0; y + 1 < grid.size[1]; ++y) find_faces(y, z);
  }

  void add_plane(std::size_t axis, std::size_t plane) {
    axis_ = axis;
    plane_ = plane;
    const std::vector<Face>& faces = planes_[axis][plane];
    looks_.assign(grid_.size[across(0)] * grid_.size[across(1)], Looks::nowhere);
    for (const Face& face : faces) looks(face.cell) = face.way;
    for (const Looks way : {Looks::forwards, Looks::backwards})
      if (std::any_of(faces.begin(), faces.end(), [&](const Face& face) { return face.way == way; })) add_faces(way);
  }
  [[nodiscard]] Polyhedron take() { return std::move(surface_); }

 private:
  enum class Looks : std::uint8_t { nowhere, forwards, backwards };
  using FlatPlace = std::array<std::size_t, 2>;  // along the two axes after the normal of the plane
  struct Face {
    FlatPlace cell;
    Looks way;
  };

  /// Finds the cells with one y and z that have a face beyond them.
  void find_faces(std::size_t y, std::size_t z) {
    const std::uint8_t* const row = &grid_.solid[grid_.index({0, y, z})];
    const std::size_t up = grid_.stride[1], back = grid_.stride[2];
    Octants cells = 0;
    for (std::size_t x = 0; x + 1 < grid_.size[0]; ++x) {
      const std::uint8_t* const next = row + x + 1;
      const Octants beyond = (Octants{next[0]} << 1U) | (Octants{next[up]} << 3U) | (Octants{next[back]} << 5U) |
                             (Octants{next[up + back]} << 7U);
      cells = (cells >> 1U & 0b01010101U) | beyond;
      if (cells == 0 || cells == 255) continue;
      if (touch(cells)) throw Error(ErrorKind::bad_input, "boxes", "they touch along an edge or at a corner");
      const Place at{x, y, z};
      for (unsigned axis = 0; axis < 3; ++axis) {
        const bool here = (cells & 1U) != 0, there = (cells >> (1U << axis) & 1U) != 0;
        if (here != there)
          planes_[axis][at[axis]].push_back(
              {{at[(axis + 1) % 3], at[(axis + 2) % 3]}, here ? Looks::forwards : Looks::backwards});
      }
    }
  }

  [[nodiscard]] std::size_t across(std::size_t i) const { return (axis_ + 1 + i) % 3; }
  [[nodiscard]] Place place(const FlatPlace& flat) const {
    Place result{};
    result[axis_] = plane_;
    result[across(0)] = flat[0];
    result[across(1)] = flat[1];
    return result;
  }
  [[nodiscard]] Looks& looks(const FlatPlace& cell) { return looks_[cell[1] * grid_.size[across(0)] + cell[0]]; }

  /// Returns the edges of the faces with one orientation, from corner to corner, with the face on
  /// the left.
  [[nodiscard]] std::multimap<FlatPlace, FlatPlace> edges(Looks way) {
    const auto is_corner = [&](const FlatPlace& at) { return are_corner(grid_.around(place(at))); };
    std::multimap<FlatPlace, FlatPlace> found;
    for (const Face& face : planes_[axis_][plane_]) {
      if (face.way != way) continue;
      const auto [i, j] = face.cell;  // the cell between planes i - 1 and i, and j - 1 and j
      struct Side {
        FlatPlace start, beyond;  // start point of the side, and the cell beyond the side
        std::size_t along, step;
      };
      constexpr std::size_t back = -1;
      for (const Side& side : {Side{{i - 1, j - 1}, {i, j - 1}, 0, 1}, Side{{i, j - 1}, {i + 1, j}, 1, 1},
                               Side{{i, j}, {i, j + 1}, 0, back}, Side{{i - 1, j}, {i - 1, j}, 1, back}}) {
        if (looks(side.beyond) == way || !is_corner(side.start)) continue;
        FlatPlace end = side.start;
        do end[side.along] += side.step;
        while (!is_corner(end));
        found.emplace(side.start, end);
      }
    }
    return found;
  }

  void add_faces(Looks way) {
    Region region;
    std::vector<std::uint32_t> corners;  // of all outlines
    for (auto open = edges(way); !open.empty();) {
      region.outlines.emplace_back();
      const FlatPlace first = open.begin()->first;
      FlatPlace at = first;
      do {
        region.outlines.back().emplace_back(grid_.planes[across(0)][at[0]], grid_.planes[across(1)][at[1]]);
        corners.push_back(corner(place(at)));
        const auto edge = open.find(at);
        at = edge->second;
        open.erase(edge);
      } while (at != first);
    }
    for (auto [a, b, c] : triangulate(region)) {
      if (way == Looks::backwards) std::swap(b, c);
      surface_.triangles.push_back({corners[a], corners[b], corners[c]});
    }
  }

  std::uint32_t corner(const Place& at) {
    const auto [known, is_new] =
        corners_.try_emplace(grid_.index(at), static_cast<std::uint32_t>(surface_.vertices.size()));
    if (is_new) surface_.vertices.push_back(grid_.point(at));
    return known->second;
  }

  const Grid& grid_;
  std::array<std::vector<std::vector<Face>>, 3> planes_;
  std::size_t axis_ = 0, plane_ = 0;
  std::vector<Looks> looks_;  // of the faces in the plane, by the cell before it
  std::unordered_map<std::size_t, std::uint32_t> corners_;
  Polyhedron surface_;
};

}  // namespace

std::optional<Box> box_of(const Polyhedron& solid) {
  if (solid.vertices.size() != 8 || solid.triangles.size() != 12 || !is_closed(solid)) return std::nullopt;
  const Box box = solid.bounds();
  std::set<unsigned> corners;
  std::array<unsigned, 8> octant{};
  for (std::size_t i = 0; i < 8; ++i) {
    const Vec3& p = solid.vertices[i];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const auto along = static_cast<Eigen::Index>(axis);
      if (p[along] != box.lower[along] && p[along] != box.upper[along]) return std::nullopt;
      if (p[along] == box.upper[along]) octant[i] |= 1U << axis;
    }
    corners.insert(octant[i]);
  }
  const auto is_in_face = [&](const Triangle& t) {
    const unsigned same = octant[t[0]] & octant[t[1]] & octant[t[2]],
                   differ = octant[t[0]] | octant[t[1]] | octant[t[2]];
    return same != 0 || differ != 7;
  };
  const bool is_box = corners.size() == 8 && std::all_of(solid.triangles.begin(), solid.triangles.end(), is_in_face);
  return is_box ? std::optional(box) : std::nullopt;
}

bool have_few_cells(const Boxes& boxes, bool grown) {
  constexpr double most = 64e6;
  double cells = 1;
  for (const auto& along : cutting_planes(boxes, 0)) cells *= (grown ? 2.0 : 1.0) * static_cast<double>(along.size());
  return cells <= most;
}

Polyhedron surface_of(const Boxes& boxes, double same, double growth, Progress& progress) {
  Grid grid = grid_of(boxes, same, progress);
  for (std::size_t axis = 0; axis < 3 && growth > 0; ++axis) grid = grown_along(axis, grid, growth);
  Surface surface(grid);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t plane = 0; plane < grid.planes[axis].size(); ++plane) {
      progress.check();
      surface.add_plane(axis, plane);
    }
  return surface.take();
}

}  // namespace fieldfab::openscad

#include "clear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "octree.h"

namespace fieldfab::contouring {
namespace {

/// Examines a block, then its parts if the block is not clear as a whole.
class BlockInspector {
 public:
  BlockInspector(const Lattice& lattice, const LatticePoint& block, const BlockSamples& samples)
      : lattice_(lattice), block_(block), samples_(samples) {
    open_.fill(true);
  }

  std::vector<UnclearCell> run(const Field& field) {
    std::vector<std::uint32_t> points(samples_.points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) points[i] = i;
    inspect({0, 0, 0}, block_side, field, points);
    if (failures_ > rough)
      for (UnclearCell& cell : unclear_) cell.field.reset(), cell.folded = false;
    return std::move(unclear_);
  }
  [[nodiscard]] bool known() const { return known_; }

 private:
  using Corner = std::array<int, 3>;  // in cells from the block's lower corner
  // With this many folded cells, half of the block, the surface is no sheet, and smaller cells
  // would be folded too.
  static constexpr int rough = 256;
  // So many normals of a large part give the direction in which the Field grows as well as all of them.
  static constexpr std::size_t enough_normals = 24;

  [[nodiscard]] LatticePoint point(const Corner& at) const {
    const int step = lattice_.voxel_level();
    return moved(block_, at[0] << step, at[1] << step, at[2] << step);
  }
  [[nodiscard]] Box cube(const Corner& at, int side) const {
    int level = lattice_.voxel_level();
    for (int s = side; s > 1; s /= 2) ++level;
    return lattice_.cube(point(at), level).grown(sheet_overlap * lattice_.voxel());
  }

  void add(const Corner& at, FieldPtr field, bool folded) {
    unclear_.push_back({point(at), lattice_.voxel_level(), std::move(field), folded});
  }

  /// Leaves edges of triangles that the corners show as they are: scanned meshes consist of them.
  void add_faceted(const Corner& at, const Field& field, bool folded) {
    const bool hidden = folded || is_uniform(samples_.corners[Block::cell(at[0], at[1], at[2])]) || is_ambiguous(at);
    failures_ += hidden;
    add(at, hidden ? field.shared_from_this() : nullptr, hidden);
  }

  /// Whether the corners of a cell show several patches, or an ambiguous face.
  [[nodiscard]] bool is_ambiguous(const Corner& at) const {
    const std::uint8_t corners = samples_.corners[Block::cell(at[0], at[1], at[2])];
    return !is_uniform(corners) && !is_simple(corners);
  }

  [[nodiscard]] bool any_open(const Corner& at, int side) const {
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x)
          if (open_[Block::cell(x, y, z)]) return true;
    return false;
  }

  void inspect(const Corner& at, int side, const Field& field, std::span<const std::uint32_t> points) {
    if (field.affine()) {
      known_ = true;
      return;
    }
    if (field.smooth()) return inspect_samples(at, side, field);
    if (failures_ > rough) return leave_open_cells(at, side);
    const Box box = cube(at, side);
    normals_.clear();
    const std::size_t step = 1 + points.size() / enough_normals;
    for (std::size_t i = 0; i < points.size(); i += step) add_normal(samples_.points[points[i]], normals_);
    const SurfaceProof proof = prove_sheet(field, box, normals_, lattice_.voxel(), 0);
    known_ = known_ || proof.known;
    if (proof.one_sheet || proof.empty) return;
    if (side == 1) {
      if (field.faceted()) return add_faceted(at, field, proof.folded);
      // After many failures a closer examination gets less effort.
      constexpr int patience = 24;
      const SurfaceProof closer =
          prove_sheet_by_parts(field, box, normals_, 0, failures_ > patience + successes_ ? 0 : 2);
      ++(closer.one_sheet ? successes_ : failures_);
      if (!closer.one_sheet) add(at, field.shared_from_this(), closer.folded || is_ambiguous(at));
      return;
    }
    if (proof.known) close_far_cells(at, side, proof.change);
    inspect_parts(at, side / 2, field, proof.known, points);
  }

  /// Parts beside each other along axes that the Field does not read are alike: those at the lower end tell what is in
  /// the others.
  void inspect_parts(const Corner& at, int half, const Field& field, bool known,
                     std::span<const std::uint32_t> points) {
    const unsigned unread = field.unread_axes();
    const auto corner_of = [&](unsigned part) {
      return Corner{at[0] + static_cast<int>(part & 1U) * half, at[1] + static_cast<int>(part >> 1 & 1U) * half,
                    at[2] + static_cast<int>(part >> 2) * half};
    };
    std::array<Corner, 8> corner;
    std::array<Box, 8> boxes;
    std::size_t count = 0;
    for (unsigned part = 0; part < 8; ++part) {
      const Corner here = corner_of(part);
      if ((part & unread) != 0 || !any_open(here, half)) continue;
      corner[count] = here;
      boxes[count++] = cube(here, half);
    }
    std::array<Restriction, 8> parts;
    // Of a cell the sign is enough: what is not near its surface counts no more. Larger parts keep their values, which
    // close_far_cells() asks, and what covers the kinks of others.
    field.restrict_all({boxes.data(), count}, half == 1 ? Purpose::occupancy : Purpose::value, parts);
    const bool simpler = std::any_of(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(count),
                                     [&](const Restriction& part) { return part.field.get() != &field; });
    if (!simpler && !known) return leave_open_cells(at, 2 * half);
    const std::size_t first = unclear_.size();
    const int failures = failures_, successes = successes_;
    std::vector<std::uint32_t> inner;
    for (std::size_t i = 0; i < count; ++i) {
      if (parts[i].range.decided()) continue;
      inner.clear();
      for (const std::uint32_t j : points)
        if (boxes[i].contains(samples_.points[j].position.cast<double>())) inner.push_back(j);
      inspect(corner[i], half, *parts[i].field, inner);
    }
    const std::size_t last = unclear_.size();
    const int failed = failures_ - failures, succeeded = successes_ - successes;
    const LatticePoint lower = point(at);
    for (unsigned beside = 1; beside < 8; ++beside) {
      if ((beside & ~unread) != 0) continue;
      const LatticePoint there = point(corner_of(beside));
      append_moved(unclear_, first, last, {there[0] - lower[0], there[1] - lower[1], there[2] - lower[2]});
      failures_ += failed, successes_ += succeeded;
    }
  }

  /// Between samples a cell shows all of the surface unless its corners are ambiguous. A trilinear
  /// function takes its extremes at the corners, and has one sheet if their signs make one patch.
  void inspect_samples(const Corner& at, int side, const Field& field) {
    const auto corners_tell = [&](const Corner& cell) {
      return field.corners_tell(lattice_.cube(point(cell), lattice_.voxel_level()));
    };
    // Cells on the diagonal have the sides of all others.
    bool all_tell = true;
    for (int i = 0; i < side && all_tell; ++i) all_tell = corners_tell({at[0] + i, at[1] + i, at[2] + i});
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x) {
          const Corner cell{x, y, z};
          if (!open_[Block::cell(x, y, z)]) continue;
          if (!all_tell && !corners_tell(cell)) {
            add(cell, nullptr, false);
          } else {
            known_ = true;
            if (is_ambiguous(cell)) add(cell, field.shared_from_this(), true);
          }
        }
  }

  /// Leaves open cells as they are. A Field that is the same in all parts of a cube (a mesh, a
  /// scan) is expensive to evaluate and returns little more for each part.
  void leave_open_cells(const Corner& at, int side) {
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x)
          if (open_[Block::cell(x, y, z)]) add({x, y, z}, nullptr, false);
  }

  /// Closes cells whose corners have one sign and lie farther from zero than the value can change
  /// on the way to any point of the cell.
  void close_far_cells(const Corner& at, int side, double change) {
    constexpr int row = block_side + 1;
    for (int z = at[2]; z < at[2] + side; ++z)
      for (int y = at[1]; y < at[1] + side; ++y)
        for (int x = at[0]; x < at[0] + side; ++x) {
          const std::size_t cell = Block::cell(x, y, z);
          if (!open_[cell] || !is_uniform(samples_.corners[cell])) continue;
          const float* value = samples_.values + x + row * (y + row * z);
          float least = std::numeric_limits<float>::infinity();
          for (const int corner : {0, 1, row, row + 1, row * row, row * row + 1, row * row + row, row * row + row + 1})
            least = std::min(least, std::abs(value[corner]));
          if (static_cast<double>(least) > change) open_[cell] = false;
        }
  }

  const Lattice& lattice_;
  const LatticePoint& block_;
  const BlockSamples& samples_;
  std::array<bool, block_side * block_side * block_side> open_;
  std::vector<UnclearCell> unclear_;
  std::vector<Eigen::Vector3f> normals_;
  int failures_ = 0, successes_ = 0;  ///< of closer examinations
  bool known_ = false;
};

}  // namespace

std::vector<UnclearCell> unclear_cells(const Field& field, const Lattice& lattice, const LatticePoint& block,
                                       const BlockSamples& samples, bool& known) {
  BlockInspector inspector(lattice, block, samples);
  std::vector<UnclearCell> unclear = inspector.run(field);
  known = known || inspector.known();
  return unclear;
}

}  // namespace fieldfab::contouring

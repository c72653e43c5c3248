/// Adaptively sampled distance field: the interchange format (Keeter 2.3, 2.4).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"

namespace fieldfab {

/// How an Asdf is built.
struct AsdfSettings {
  double voxel = 0;       ///< wanted edge of the smallest cell, mm; the region's sides are divided into ceil(side / voxel) cells
  double max_error = -1;  ///< leaf cells merge while interpolation stays within this many mm; negative: a tenth of a voxel
  bool merge_leafs = true;  ///< false: a plain octree of smallest leaf cells
};

/// Counts of the cells of an Asdf, by kind.
struct AsdfStatistics {
  std::size_t filled = 0, empty = 0, branches = 0, leafs = 0;
  std::size_t bytes = 0;  ///< all memory held by the tree
  int depth = 0;
  [[nodiscard]] std::size_t cells() const { return filled + empty + branches + leafs; }
};

/// What to read of an .asdf file.
struct AsdfPart {
  int level = 0;              ///< 0 is the finest
  std::optional<Box> region;  ///< only blocks that meet it; elsewhere the result is empty. In the region's own coordinates
};

/// How an .asdf file is written.
struct AsdfFileSettings {
  /// Distances are kept as multiples of this many mm, so that none moves by more than half of it; negative: 1/1024 of a voxel.
  double quantum = -1;
  int levels = 1;  ///< how many resolutions the file holds, each half of the one before
  /// The quantum in mm. Throws bad_input for 0.
  [[nodiscard]] double quantum_for(double voxel) const;
};

/// What an .asdf file holds, as far as its directory tells; no levels for kokopelli's.
struct AsdfFileInfo {
  struct Level {
    Box region;
    std::array<int, 3> lattice;
    std::size_t blocks, cells, bytes;
  };
  std::vector<Level> levels;
  double quantum = 0;
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< see Asdf::placement()
  std::size_t file_size = 0;
};

/// An octree over a lattice of any size whose cells split and merge an axis at a time. A cell is FILLED, EMPTY, a BRANCH, or a
/// LEAF with distance samples at its eight corners, interpolated trilinearly. Distances are kept near the surface only
/// (a "superficial" field): in FILLED and EMPTY cells the value is minus or plus the smallest cell's diagonal.
/// Memory: at most 24 bytes a cell (4 for the cell, 20 for a leaf's samples in 16 bits with a scale).
class Asdf final : public Field {
 public:
  /// Samples `field` over `region`. The same tree for any number of threads. Throws bad_input for a region or voxel that is not
  /// finite and positive (a flat z axis gives a 2D Asdf), too_large where it would not fit in memory, cancelled.
  static std::shared_ptr<const Asdf> build(const Field& field, const Box& region, const AsdfSettings& settings,
                                           Progress& progress = Progress::none());
  /// Reads an .asdf file, ours or kokopelli's version 2.0, or a part of one of ours. Throws io, or bad_input for a damaged file.
  static std::shared_ptr<const Asdf> load(const std::filesystem::path& path, const AsdfPart& part = {});
  /// What a file holds, without reading its cells. Throws as load().
  static AsdfFileInfo look(const std::filesystem::path& path);
  /// Writes an .asdf file (docs/asdf-format.md). Throws io.
  void save(const std::filesystem::path& path, const AsdfFileSettings& settings = {},
            Progress& progress = Progress::none()) const;

  void values(const Points& points, float* out) const noexcept override;
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override;
  [[nodiscard]] Interval interval(const Box& box) const noexcept override;
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override;
  [[nodiscard]] Box known_bounds() const noexcept override { return region_; }
  [[nodiscard]] bool sampled() const noexcept override { return true; }
  [[nodiscard]] std::size_t cost() const noexcept override { return 64; }

  [[nodiscard]] const Box& region() const { return region_; }
  /// Smallest cells along each axis; 0 on a flat axis.
  [[nodiscard]] const std::array<int, 3>& lattice() const { return lattice_; }
  /// Edge of the smallest cell, mm: the largest of the three axes.
  [[nodiscard]] double voxel() const;
  /// The smallest of the three: what a mesh needs to show all that is there.
  [[nodiscard]] double finest() const;
  [[nodiscard]] double max_error() const { return max_error_; }
  /// From the region's coordinates to space: where a scan lies askew. This Field itself is in the region's coordinates.
  [[nodiscard]] const Eigen::Affine3d& placement() const { return placement_; }
  /// The solid where it is in space.
  [[nodiscard]] FieldPtr placed() const;
  [[nodiscard]] AsdfStatistics statistics() const;

  /// The cut at height z as a 2D Asdf (flat in z). Throws bad_input where z is outside the region.
  [[nodiscard]] std::shared_ptr<const Asdf> slice(double z) const;
  /// The same solid `factor` times as large, about the origin. Throws bad_input unless factor > 0.
  [[nodiscard]] std::shared_ptr<const Asdf> rescaled(double factor) const;
  /// Distance along the ray from `origin` to the first point that is inside, or nothing. `direction` need not have length 1.
  [[nodiscard]] std::optional<double> ray(const Vec3& origin, const Vec3& direction) const;

  /// How the cells are kept; private to the asdf folder.
  struct Tree;

 private:
  friend class AsdfFile;
  Asdf(Box region, std::array<int, 3> lattice, double max_error, std::shared_ptr<const Tree> tree);
  /// The cell at a point of the lattice: descends from root_.
  struct Place;
  [[nodiscard]] Place find(const std::array<double, 3>& at) const noexcept;
  /// The smallest subtree that answers for all of a box.
  [[nodiscard]] FieldPtr subtree(const Box& box) const;

  Box region_;
  std::array<int, 3> lattice_{};
  double max_error_ = 0;
  Eigen::Affine3d placement_ = Eigen::Affine3d::Identity();
  std::shared_ptr<const Tree> tree_;
  std::uint32_t root_ = 0;                ///< the cell this Field begins at; a restriction shares the tree and begins lower
  std::array<int, 3> first_{}, count_{};  ///< the lattice cells that root_ covers
};

}  // namespace fieldfab

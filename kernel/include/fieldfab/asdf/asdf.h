/// Adaptively sampled distance field (ASDF): the interchange format (Frisken et al. 2000; Keeter 2.3, 2.4).
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

/// Parameters for building an Asdf.
struct AsdfSettings {
  /// wanted edge of the smallest cell, mm; each side of the region is divided into ceil(side / voxel) cells
  double voxel = 0;
  /// permitted interpolation error of merged leaf cells, mm; negative: a tenth of a voxel
  double max_error = -1;
  bool merge_leafs = true;  ///< false: a regular octree of smallest leaf cells
};

/// Numbers of cells of an Asdf, by kind.
struct AsdfStatistics {
  std::size_t filled = 0, empty = 0, branches = 0, leafs = 0;
  std::size_t bytes = 0;  ///< memory of the tree, bytes
  int depth = 0;
  [[nodiscard]] std::size_t cells() const { return filled + empty + branches + leafs; }
};

/// Selection of the part of an .asdf file to read.
struct AsdfPart {
  int level = 0;  ///< resolution level; 0 is the finest
  /// only blocks that overlap this box are read, the rest is empty; in the coordinates of the file's region, mm
  std::optional<Box> region;
};

/// Parameters for writing an .asdf file.
struct AsdfFileSettings {
  /// Quantum of stored distances, mm: each is rounded to a multiple of it, with an error of at most half. Negative:
  /// 1/1024 of a voxel.
  double quantum = -1;
  int levels = 1;  ///< number of resolution levels, each half as fine as the previous one
  /// Returns the quantum in mm for a voxel edge in mm. Throws Error(bad_input) if the quantum is 0.
  [[nodiscard]] double quantum_for(double voxel) const;
};

/// Directory of an .asdf file. There are no levels for kokopelli's version of the format.
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

/// A Field interpolated from an octree over a lattice of any size, whose cells split and merge one axis at a time. A
/// cell is FILLED, EMPTY, a BRANCH, or a LEAF with distance samples at its eight corners, interpolated trilinearly.
/// Distances are kept only near the surface: in FILLED and EMPTY cells the value is minus or plus the diagonal of the
/// smallest cell. Points outside the region, and points with NaN or infinite coordinates, have positive values. Memory:
/// at most 24 bytes per cell (4 for the cell, 20 for a leaf's samples, in 16 bits with a common scale).
class Asdf final : public Field {
 public:
  /// Samples `field` over `region`, mm. NaN counts as outside. The result does not depend on the number of threads.
  /// Throws Error(bad_input) unless region and voxel are finite and positive (a region flat in z gives a 2D Asdf),
  /// Error(too_large) if the result exceeds the memory, Error(cancelled).
  static std::shared_ptr<const Asdf> build(const Field& field, const Box& region, const AsdfSettings& settings,
                                           Progress& progress = Progress::none());
  /// Reads an .asdf file of Fieldfab or of kokopelli (version 2.0), or a part of a Fieldfab file. Throws Error(io),
  /// Error(bad_input) for a damaged file.
  static std::shared_ptr<const Asdf> load(const std::filesystem::path& path, const AsdfPart& part = {});
  /// Returns the directory of a file without reading its cells. Throws as load().
  static AsdfFileInfo look(const std::filesystem::path& path);
  /// Writes an .asdf file (docs/asdf-format.md), completely or not at all. Throws Error(io), Error(cancelled).
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
  /// Number of smallest cells along each axis; 0 on a flat axis.
  [[nodiscard]] const std::array<int, 3>& lattice() const { return lattice_; }
  /// Greatest edge of the smallest cell over the three axes, mm.
  [[nodiscard]] double voxel() const;
  /// Least edge of the smallest cell over the three axes, mm: the cell size that a mesh needs to represent all cells.
  [[nodiscard]] double finest() const;
  [[nodiscard]] double max_error() const { return max_error_; }
  /// Map from the region's coordinates to model space, for oblique scans. The values of this Field refer to the
  /// region's coordinates; see placed().
  [[nodiscard]] const Eigen::Affine3d& placement() const { return placement_; }
  /// Returns the solid in model space.
  [[nodiscard]] FieldPtr placed() const;
  [[nodiscard]] AsdfStatistics statistics() const;

  /// Returns the cross-section at height z as a 2D Asdf (flat in z). Throws Error(bad_input) if z is outside the
  /// region.
  [[nodiscard]] std::shared_ptr<const Asdf> slice(double z) const;
  /// Returns the solid scaled by `factor` about the origin. Throws Error(bad_input) unless factor > 0.
  [[nodiscard]] std::shared_ptr<const Asdf> rescaled(double factor) const;
  /// Returns the distance along the ray from `origin` to the first point inside, mm, or std::nullopt. `direction` may
  /// have any length above 0. Throws Error(bad_input) for a zero direction or for coordinates that are not finite.
  [[nodiscard]] std::optional<double> ray(const Vec3& origin, const Vec3& direction) const;

  /// Storage of the cells; private to the asdf folder.
  struct Tree;

 private:
  friend class AsdfFile;
  Asdf(Box region, std::array<int, 3> lattice, double max_error, std::shared_ptr<const Tree> tree);
  /// Cell at a point of the lattice, found by descent from root_.
  struct Place;
  [[nodiscard]] Place find(const std::array<double, 3>& at) const noexcept;
  /// The smallest subtree that contains a box.
  [[nodiscard]] RestrictedField subtree(const Box& box) const;

  Box region_;
  std::array<int, 3> lattice_{};
  double max_error_ = 0;
  Eigen::Affine3d placement_ = Eigen::Affine3d::Identity();
  std::shared_ptr<const Tree> tree_;
  /// root cell of this Field; a restriction shares the tree and has a lower root
  std::uint32_t root_ = 0;
  std::array<int, 3> first_{}, count_{};  ///< range of lattice cells covered by root_
};

}  // namespace fieldfab

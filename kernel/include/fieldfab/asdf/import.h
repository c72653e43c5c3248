/// Out-of-core construction of distance fields from lattices that exceed the memory (Keeter Algorithm 5.1).
#pragma once

#include <functional>

#include "fieldfab/asdf/asdf.h"

namespace fieldfab {

/// A solid as values at lattice points, read slice by slice.
struct LatticeSource {
  Box region;                                               ///< box from the first to the last point, mm
  std::array<int, 3> points;                                ///< number of points along each axis, at least 2
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< map from the region's coordinates to model space
  /// Writes the values of `count` slices from `first` on, x fastest; negative is inside. Called from several threads at
  /// the same time.
  std::function<void(int first, int count, float* out)> read;
};

/// Parameters of an import.
struct ImportSettings {
  /// permitted interpolation error of merged leaf cells, mm; negative: a tenth of the smallest cell side of the finest
  /// level
  double max_error = -1;
  AsdfFileSettings file;                        ///< file parameters; the number of levels is that of the lattices given
  std::size_t memory = std::size_t{512} << 20;  ///< memory for slices, bytes
};

/// Numbers of cells, leaf cells and blocks written.
struct ImportCounts {
  std::size_t cells = 0, leafs = 0, blocks = 0;
};

/// Writes the .asdf file of lattices, the finest first: bottom-up, by blocks and in parallel. Each slice is read once,
/// or a few times if memory is short. The file does not depend on memory and number of threads, because merging stops
/// at blocks of 64 cells; above them only blocks that are a single leaf, filled or empty are merged. Throws
/// Error(too_large) if two slices of 65 rows exceed `memory`, Error(io), Error(bad_input), Error(cancelled); there is
/// no file after an error.
ImportCounts import_asdf(const std::vector<LatticeSource>& levels, const std::filesystem::path& path,
                         const ImportSettings& settings, Progress& progress = Progress::none());

/// One of several shares of an import, each for its own process: share `part`, counted from 0, of `parts`.
struct ImportShare {
  int part = 0, parts = 1;
};
/// Computes one share of import_asdf() and writes an intermediate file for merge_parts(). Throws as import_asdf().
void import_part(const std::vector<LatticeSource>& levels, const std::filesystem::path& path,
                 const ImportSettings& settings, const ImportShare& share, Progress& progress = Progress::none());
/// Merges the intermediate files of all shares into the file that import_asdf() would write, byte for byte. Does not
/// read the values of the lattices. Throws Error(bad_input) if a share is missing or damaged, Error(io),
/// Error(cancelled).
ImportCounts merge_parts(const std::vector<LatticeSource>& levels, const std::vector<std::filesystem::path>& parts,
                         const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress = Progress::none());

}  // namespace fieldfab

/// Distance fields from values on a lattice that is too large to be held at once (Keeter Alg. 5.1).
#pragma once

#include <functional>

#include "fieldfab/asdf/asdf.h"

namespace fieldfab {

/// A solid as values at the points of a lattice, read slice by slice.
struct LatticeSource {
  Box region;                                               ///< from the first point to the last, mm
  std::array<int, 3> points;                                ///< along each axis, 2 or more
  Eigen::Affine3d placement = Eigen::Affine3d::Identity();  ///< from the region's coordinates to space
  /// Writes the values of `count` slices from `first` on, x fastest; called from many threads. Negative is inside.
  std::function<void(int first, int count, float* out)> read;
};

struct ImportSettings {
  double max_error = -1;  ///< of merged leafs, mm; negative: a tenth of the smallest cell side of the finest level
  AsdfFileSettings file;  ///< its levels are those given
  std::size_t memory = std::size_t{512} << 20;  ///< bytes for the slices held at a time
};

/// What an import came to.
struct ImportCounts {
  std::size_t cells = 0, leafs = 0, blocks = 0;
};

/// Writes the .asdf file of lattices, the finest first: bottom-up, block by block and in parallel, reading each slice once or,
/// where memory is short, a few times. The file is the same for any memory and any number of threads: merging stops at blocks of
/// 64 cells, above which only whole leaf, filled or empty blocks join. Throws too_large where two slices of 65 rows do not fit
/// into `memory`, io, bad_input, cancelled; then there is no file.
ImportCounts import_asdf(const std::vector<LatticeSource>& levels, const std::filesystem::path& path,
                         const ImportSettings& settings, Progress& progress = Progress::none());

/// The share of an import that one of several processes does: `part` of `parts`, from 0.
struct ImportShare {
  int part = 0, parts = 1;
};
/// Does a share of import_asdf() and writes what it makes, for merge_parts(). Throws as that does.
void import_part(const std::vector<LatticeSource>& levels, const std::filesystem::path& path, const ImportSettings& settings,
                 const ImportShare& share, Progress& progress = Progress::none());
/// Puts the files of all shares together: byte for byte the file that import_asdf() writes. The levels are asked for their places
/// only. Throws bad_input where a share is missing or damaged.
ImportCounts merge_parts(const std::vector<LatticeSource>& levels, const std::vector<std::filesystem::path>& parts,
                         const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress = Progress::none());

}  // namespace fieldfab

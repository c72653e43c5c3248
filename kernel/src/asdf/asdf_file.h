/// Writer and reader of .asdf files (docs/asdf-format.md); private to the asdf folder.
#pragma once

#include <map>

#include "asdf_block.h"
#include "fieldfab/core/file.h"

namespace fieldfab {

/// Writes an .asdf file block by block, so that it can be larger than memory.
class AsdfWriter {
 public:
  struct Header {
    double max_error = 0, quantum = 0;
    Eigen::Affine3d placement = Eigen::Affine3d::Identity();
  };
  AsdfWriter(const std::filesystem::path& path, const Header& header);

  /// Begins a level; the finest comes first.
  void begin_level(const Box& region, const std::array<int, 3>& lattice);
  /// Writes the block of the cell over a range. Blocks are stored in the order of the calls.
  void add(const LatticeRange& range, const EncodedBlock& block);
  /// Sets the cells above the blocks: a branch without children stands for the block over its
  /// range.
  void end_level(const BuildCell& trunk);
  /// Moves the file into place; throws io.
  void commit();

 private:
  struct Record {
    std::uint64_t offset;
    std::uint32_t size, raw_size, checksum, cells, leafs;
  };
  void add_trunk(const BuildCell& cell, const LatticeRange& range);

  PendingFile file_;
  Header header_;
  std::uint64_t size_;
  std::uint32_t levels_ = 0;
  std::map<std::array<int, 3>, Record> records_;  ///< of this level, by the first lattice cell
  std::string kinds_, corners_, table_, directory_;
  std::array<int, 3> lattice_{};
  Box region_;
};

/// Returns the cell in a trunk that stands for a block.
BuildCell block_mark();
inline bool is_block_mark(const BuildCell& cell) { return cell.kind == CellKind::branch && cell.children.empty(); }

/// Creates Asdfs from the content of files.
class AsdfFile {
 public:
  struct Contents {
    Box region;
    std::array<int, 3> lattice;
    double max_error;
    Eigen::Affine3d placement;
    Asdf::Tree tree;
  };
  /// Checks the content and creates an Asdf; throws bad_input.
  static std::shared_ptr<const Asdf> make(Contents contents, const std::filesystem::path& path);
  static Contents from_kokopelli(std::string_view bytes, const std::filesystem::path& path);
  static void write(const Asdf& asdf, AsdfWriter& writer, double quantum);
};

}  // namespace fieldfab

/// Blocks of an .asdf file: the cells below one cell that is at most brick_side lattice cells long, each block to be read alone.
#pragma once

#include <string>
#include <string_view>

#include "asdf_tree.h"

namespace fieldfab {

/// Lattice cells an axis of the cells that are blocks of their own in a file.
inline constexpr int brick_side = 64;

/// A block ready to be written, and what the file's directory tells about it.
struct EncodedBlock {
  std::string bytes;  ///< a zstd frame
  std::uint32_t raw_size = 0, cells = 0, leafs = 0;
};

/// The cells below and including `root`, which covers `range`. Distances become multiples of `quantum` mm: none moves by more
/// than half of that, none changes its sign. A corner that several leafs share is kept once.
EncodedBlock encode_block(const BuildCell& root, const LatticeRange& range, double quantum);

/// What encode_block() took, as a tree whose first cell is the root. Throws Error(bad_input) in the name of `place` unless the
/// bytes are exactly a block over `range` with these counts; takes no more memory than such a block can need.
Asdf::Tree decode_block(std::string_view bytes, const EncodedBlock& counts, const LatticeRange& range, double quantum,
                        const std::string& place);

/// A distance in steps of `quantum`; a negative one is never 0.
std::int32_t quantised(float distance, double quantum);

/// What a zstd frame holds, if that is exactly `size` bytes; nothing otherwise.
std::string decompressed(std::string_view frame, std::size_t size);
std::string compressed(std::string_view raw);

}  // namespace fieldfab

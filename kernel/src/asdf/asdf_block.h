/// Blocks of an .asdf file: the cells below one cell of at most brick_side lattice cells per axis.
/// Each block can be read alone.
#pragma once

#include <string>
#include <string_view>

#include "asdf_tree.h"

namespace fieldfab {

/// Greatest number of lattice cells per axis of the cells that are stored as blocks.
inline constexpr int brick_side = 64;

/// A block ready to be written, and its entry in the file's directory.
struct EncodedBlock {
  std::string bytes;  ///< a zstd frame
  std::uint32_t raw_size = 0, cells = 0, leafs = 0;
};

/// Encodes `root`, which covers `range`, and the cells below it. Distances become multiples of
/// `quantum` mm: each changes by at most half of that, and keeps its sign. A corner shared by
/// several leafs is stored once.
EncodedBlock encode_block(const BuildCell& root, const LatticeRange& range, double quantum);

/// Decodes a block as a tree whose first cell is the root. Throws Error(bad_input) with `place`
/// unless the bytes are exactly a block over `range` with these counts. Uses no more memory than
/// such a block can need.
Asdf::Tree decode_block(std::string_view bytes, const EncodedBlock& counts, const LatticeRange& range, double quantum,
                        const std::string& place);

/// Returns a distance in steps of `quantum`; a negative distance never becomes 0.
std::int32_t quantised(float distance, double quantum);

/// Returns the content of a zstd frame if it is exactly `size` bytes, otherwise an empty string.
std::string decompressed(std::string_view frame, std::size_t size);
std::string compressed(std::string_view raw);

}  // namespace fieldfab

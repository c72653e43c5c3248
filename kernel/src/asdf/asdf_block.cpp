// A block: one byte per cell, depth first (kind, split axes), followed by the distances of the
// corners in the order in which leafs need them. Each distance is the difference from a prediction
// by earlier corners of the leaf (docs/asdf-format.md).
#include "asdf_block.h"

#include <zstd.h>

#include <bit>
#include <cmath>
#include <memory>

#include "fieldfab/core/error.h"

namespace fieldfab {
namespace {

constexpr std::int32_t most_steps = 1 << 28;

/// Distances in steps at the lattice points of a block, as far as they are known.
class Corners {
 public:
  explicit Corners(const LatticeRange& range) : range_(range) {
    std::size_t points = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      stride_[axis] = points, points *= static_cast<std::size_t>(range.count[axis]) + 1;
    steps_.assign(points, unknown);
  }
  static constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();

  [[nodiscard]] std::int32_t& at(const LatticeRange& leaf, unsigned corner) {
    std::size_t index = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      index += stride_[axis] * static_cast<std::size_t>(leaf.first[axis] - range_.first[axis] +
                                                        static_cast<int>(corner >> axis & 1U) * leaf.count[axis]);
    return steps_[index];
  }

 private:
  LatticeRange range_;
  std::array<std::size_t, 3> stride_{};
  std::vector<std::int32_t> steps_;
};

/// Predicts a corner as a multilinear extrapolation of those before it; `last` for the first one.
std::int32_t expected(const std::array<std::int32_t, 8>& known, unsigned corner, std::int32_t last) {
  switch (std::popcount(corner)) {
    case 0: return last;
    case 1: return known[0];
    case 2: {
      const unsigned low = corner & (~corner + 1U), high = corner ^ low;
      return known[low] + known[high] - known[0];
    }
    default: return known[6] + known[5] + known[3] - known[4] - known[2] - known[1] + known[0];
  }
}

/// Writes small signed numbers as few bytes: 7 bits each, the lowest first.
void append_number(std::string& bytes, std::int64_t number) {
  auto bits = static_cast<std::uint64_t>(number << 1 ^ number >> 63);
  for (; bits >= 128; bits >>= 7U) bytes += static_cast<char>(bits | 128U);
  bytes += static_cast<char>(bits);
}

class Encoder {
 public:
  Encoder(const LatticeRange& range, double quantum) : corners_(range), quantum_(quantum) {}

  void add(const BuildCell& cell, const LatticeRange& range) {
    ++block.cells;
    kinds_ +=
        static_cast<char>(static_cast<unsigned>(cell.kind) | (cell.kind == CellKind::branch ? cell.axes << 2U : 0U));
    if (cell.kind == CellKind::leaf) add_corners(cell, range);
    for (std::size_t i = 0; i < cell.children.size(); ++i)
      add(cell.children[i], range.child(cell.axes, static_cast<unsigned>(i)));
  }
  EncodedBlock finish() {
    const std::string raw = kinds_ + numbers_;
    block.raw_size = static_cast<std::uint32_t>(raw.size());
    block.bytes = compressed(raw);
    return std::move(block);
  }

 private:
  void add_corners(const BuildCell& leaf, const LatticeRange& range) {
    ++block.leafs;
    std::array<std::int32_t, 8> known{};
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::int32_t& here = corners_.at(range, corner);
      if (here == Corners::unknown) {
        here = quantised(leaf.corners[corner], quantum_);
        append_number(numbers_, std::int64_t{here} - expected(known, corner, last_));
        last_ = here;
      }
      known[corner] = here;
    }
  }

  EncodedBlock block;
  Corners corners_;
  double quantum_;
  std::int32_t last_ = 0;
  std::string kinds_, numbers_;
};

class Decoder {
 public:
  Decoder(std::string_view raw, const EncodedBlock& counts, const LatticeRange& range, double quantum,
          const std::string& place)
      : kinds_(raw.substr(0, counts.cells)),
        numbers_(raw.substr(counts.cells)),
        corners_(range),
        quantum_(quantum),
        place_(place) {
    tree.cells.reserve(counts.cells);
    tree.leafs.reserve(counts.leafs);
    tree.cells.resize(1);
    add(0, range);
    if (next_kind_ != kinds_.size() || next_number_ != numbers_.size() || tree.leafs.size() != counts.leafs) damaged();
  }
  Asdf::Tree tree;

 private:
  [[noreturn]] void damaged() const {
    throw Error(ErrorKind::bad_input, place_, "is damaged or no .asdf file: a block's cells do not make a tree");
  }

  void add(std::size_t at, const LatticeRange& range) {
    if (next_kind_ >= kinds_.size()) damaged();
    const auto byte = static_cast<unsigned char>(kinds_[next_kind_++]);
    const auto kind = static_cast<CellKind>(byte & 3U);
    const unsigned axes = byte >> 2U;
    if (kind != CellKind::branch) {
      if (axes != 0) damaged();
      tree.cells[at] = kind == CellKind::leaf ? CellWord::leaf(tree.leafs.size()) : CellWord::of(kind);
      if (kind == CellKind::leaf) tree.leafs.push_back(leaf(range));
      return;
    }
    // Each split halves an axis with two cells or more, so the depth is bounded.
    if (axes == 0 || (axes & ~range.divisible()) != 0) damaged();
    const std::size_t first = tree.cells.size(), count = std::size_t{1} << std::popcount(axes);
    if (first + count > kinds_.size()) damaged();
    tree.cells.resize(first + count);
    tree.cells[at] = CellWord::branch(first, axes);
    for (std::size_t i = 0; i < count; ++i) add(first + i, range.child(axes, static_cast<unsigned>(i)));
  }

  LeafSamples leaf(const LatticeRange& range) {
    std::array<std::int32_t, 8> known{};
    std::array<float, 8> distances;
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::int32_t& here = corners_.at(range, corner);
      if (here == Corners::unknown) {
        const std::int64_t steps = number() + expected(known, corner, last_);
        if (steps < -most_steps || steps > most_steps) damaged();
        last_ = here = static_cast<std::int32_t>(steps);
      }
      known[corner] = here;
      distances[corner] = static_cast<float>(here * quantum_);
    }
    return LeafSamples::of(distances);
  }

  std::int64_t number() {
    std::uint64_t bits = 0;
    for (unsigned shift = 0; shift < 63; shift += 7) {
      if (next_number_ >= numbers_.size()) damaged();
      const auto byte = static_cast<unsigned char>(numbers_[next_number_++]);
      bits |= std::uint64_t{byte & 127U} << shift;
      if (byte < 128) return static_cast<std::int64_t>(bits >> 1U) ^ -static_cast<std::int64_t>(bits & 1U);
    }
    damaged();
  }

  std::string_view kinds_, numbers_;
  std::size_t next_kind_ = 0, next_number_ = 0;
  Corners corners_;
  double quantum_;
  const std::string& place_;
  std::int32_t last_ = 0;
};

}  // namespace

std::int32_t quantised(float distance, double quantum) {
  if (std::isnan(distance)) return most_steps;  // outside
  const double steps = std::clamp<double>(distance / quantum, -most_steps, most_steps);
  const auto nearest = static_cast<std::int32_t>(std::lround(steps));
  return distance < 0 ? std::min(nearest, -1) : nearest;
}

EncodedBlock encode_block(const BuildCell& root, const LatticeRange& range, double quantum) {
  Encoder encoder(range, quantum);
  encoder.add(root, range);
  return encoder.finish();
}

Asdf::Tree decode_block(std::string_view bytes, const EncodedBlock& counts, const LatticeRange& range, double quantum,
                        const std::string& place) {
  const std::string raw = decompressed(bytes, counts.raw_size);
  if (raw.size() != counts.raw_size || counts.cells > raw.size())
    throw Error(ErrorKind::bad_input, place, "is damaged or no .asdf file: a block cannot be decompressed");
  return Decoder(raw, counts, range, quantum, place).tree;
}

std::string compressed(std::string_view raw) {
  constexpr int effort = 6;
  std::string bytes(ZSTD_compressBound(raw.size()), '\0');
  const std::size_t size = ZSTD_compress(bytes.data(), bytes.size(), raw.data(), raw.size(), effort);
  if (ZSTD_isError(size) != 0) throw Error(ErrorKind::internal, "zstd", ZSTD_getErrorName(size));
  bytes.resize(size);
  return bytes;
}

std::string decompressed(std::string_view frame, std::size_t size) {
  std::string raw(size, '\0');
  const std::size_t got = ZSTD_decompress(raw.data(), raw.size(), frame.data(), frame.size());
  if (ZSTD_isError(got) != 0 || got != size) raw.clear();
  return raw;
}

}  // namespace fieldfab

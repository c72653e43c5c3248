// .asdf files: ours, compressed and with a checksum, and kokopelli's version 2.0.
//
// Ours, little-endian: "FFASDF1\n", crc32 of all that follows (4 bytes), then uncompressed size (8), then a zstd frame that holds
// the region (6 doubles), the lattice (3 ints), max_error (double), the numbers of cells and leafs (2 x 8 bytes), the cell words,
// the leafs.
#include <fmt/format.h>
#include <zlib.h>
#include <zstd.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <memory>

#include "asdf_tree.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab {
namespace {

constexpr std::string_view magic = "FFASDF1\n";

[[noreturn]] void damaged(const std::filesystem::path& path, const std::string& how) {
  throw Error(ErrorKind::bad_input, path.string(), "is damaged or no .asdf file: " + how);
}

/// Bytes read front to back, never past the end.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::filesystem::path& path) : bytes_(bytes), path_(path) {}
  template <class Value>
  Value take() {
    Value value;
    take(&value, sizeof value);
    return value;
  }
  void take(void* to, std::size_t size) {
    if (size > left()) damaged(path_, "it ends too early");
    std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

 private:
  std::string_view bytes_;
  const std::filesystem::path& path_;
  std::size_t at_ = 0;
};

template <class Value>
void append(std::string& bytes, const Value& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::uint32_t checksum(std::string_view bytes) {
  uLong sum = crc32(0, nullptr, 0);
  while (!bytes.empty()) {
    const std::size_t part = std::min<std::size_t>(bytes.size(), 1U << 30);
    sum = crc32(sum, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(part));
    bytes.remove_prefix(part);
  }
  return static_cast<std::uint32_t>(sum);
}

/// What a zstd frame holds, if that is `size` bytes; less or nothing otherwise. Memory grows with what is there, not with `size`,
/// which a damaged file may give as anything.
std::string decompressed(std::string_view frame, std::size_t size) {
  const std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> context(ZSTD_createDCtx(), &ZSTD_freeDCtx);
  std::string raw;
  ZSTD_inBuffer in{frame.data(), frame.size(), 0};
  std::vector<char> part(ZSTD_DStreamOutSize());
  for (std::size_t left = 1; left != 0;) {
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    const std::size_t before = in.pos;
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (ZSTD_isError(left) != 0 || out.pos > size - raw.size()) return {};
    raw.append(part.data(), out.pos);
    if (left != 0 && out.pos == 0 && in.pos == before) return {};  // it ends too early
  }
  return in.pos == in.size ? raw : std::string();
}

/// Every cell and every leaf must be reached exactly once, and no axis may be split that is one cell wide.
void verify(const Asdf::Tree& tree, const std::array<int, 3>& lattice, const std::filesystem::path& path) {
  struct Open {
    std::uint32_t cell;
    LatticeRange range;
  };
  std::size_t cells = 1, leafs = 0;
  std::vector<bool> seen_leaf(tree.leafs.size());
  std::vector<Open> open{{0, {{0, 0, 0}, {std::max(lattice[0], 1), std::max(lattice[1], 1), std::max(lattice[2], 1)}}}};
  while (!open.empty()) {
    const Open here = open.back();
    open.pop_back();
    const CellWord word = tree.cells[here.cell];
    if (word.kind() == CellKind::leaf) {
      if (word.samples() >= tree.leafs.size() || seen_leaf[word.samples()])
        damaged(path, "a cell refers to samples that are not its own");
      seen_leaf[word.samples()] = true;
      ++leafs;
    }
    if (word.kind() != CellKind::branch) continue;
    const std::size_t count = std::size_t{1} << std::popcount(word.axes()), first = word.first_child();
    if (word.axes() == 0 || (word.axes() & ~here.range.divisible()) != 0 || first <= here.cell ||
        first + count > tree.cells.size() || (cells += count) > tree.cells.size())
      damaged(path, "its cells do not make a tree");
    for (unsigned i = 0; i < count; ++i)
      open.push_back({static_cast<std::uint32_t>(first + i), here.range.child(word.axes(), i)});
  }
  if (cells != tree.cells.size() || leafs != tree.leafs.size()) damaged(path, "it holds cells that belong to nothing");
  for (const LeafSamples& samples : tree.leafs)
    if (!std::isfinite(samples.step) || samples.step <= 0) damaged(path, "a distance is not a number");
}

}  // namespace

/// Makes and takes apart Asdfs for files.
class AsdfFile {
 public:
  static std::string bytes_of(const Asdf& asdf) {
    std::string raw;
    for (const double bound : {asdf.region_.lower.x(), asdf.region_.lower.y(), asdf.region_.lower.z(), asdf.region_.upper.x(),
                               asdf.region_.upper.y(), asdf.region_.upper.z()})
      append(raw, bound);
    append(raw, asdf.lattice_);
    append(raw, asdf.max_error_);
    append(raw, std::uint64_t{asdf.tree_->cells.size()});
    append(raw, std::uint64_t{asdf.tree_->leafs.size()});
    raw.append(reinterpret_cast<const char*>(asdf.tree_->cells.data()), asdf.tree_->cells.size() * sizeof(CellWord));
    raw.append(reinterpret_cast<const char*>(asdf.tree_->leafs.data()), asdf.tree_->leafs.size() * sizeof(LeafSamples));
    return raw;
  }

  static std::shared_ptr<const Asdf> from_bytes(std::string_view raw, const std::filesystem::path& path) {
    ByteReader reader(raw, path);
    Box region;
    reader.take(region.lower.data(), 3 * sizeof(double));
    reader.take(region.upper.data(), 3 * sizeof(double));
    const auto lattice = reader.take<std::array<int, 3>>();
    const auto max_error = reader.take<double>();
    const auto cells = reader.take<std::uint64_t>(), leafs = reader.take<std::uint64_t>();
    if (cells == 0 || cells > CellWord::most_cells || leafs > cells ||
        cells * sizeof(CellWord) + leafs * sizeof(LeafSamples) != reader.left())
      damaged(path, "its counts do not fit its size");
    auto tree = std::make_shared<Asdf::Tree>();
    tree->cells.resize(cells);
    tree->leafs.resize(leafs);
    reader.take(tree->cells.data(), cells * sizeof(CellWord));
    reader.take(tree->leafs.data(), leafs * sizeof(LeafSamples));
    return make(region, lattice, max_error, std::move(tree), path);
  }

  static std::shared_ptr<const Asdf> make(const Box& region, const std::array<int, 3>& lattice, double max_error,
                                          std::shared_ptr<Asdf::Tree> tree, const std::filesystem::path& path) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (lattice[axis] < 0 || lattice[axis] > 1 << 24 ||
          (lattice[axis] > 0) != (region.size()[static_cast<Eigen::Index>(axis)] > 0))
        damaged(path, "its lattice does not fit its region");
    if (!region.valid() || !std::isfinite(max_error)) damaged(path, "its region is not finite");
    verify(*tree, lattice, path);
    for (const LeafSamples& samples : tree->leafs) tree->greatest = std::max(tree->greatest, 32768 * samples.step);
    return std::shared_ptr<const Asdf>(new Asdf(region, lattice, max_error, std::move(tree)));
  }

  static std::shared_ptr<const Asdf> from_kokopelli(std::string_view bytes, const std::filesystem::path& path);
};

namespace {

/// kokopelli's tree, depth first. A corner's distance stands where the first cell that has it comes, and is looked up by place
/// after that.
class KokopelliReader {
 public:
  KokopelliReader(ByteReader& reader, float scale, const std::filesystem::path& path)
      : reader_(reader), scale_(scale), path_(path) {}

  BuildCell cell(const LatticeRange& range) {
    BuildCell made;
    const auto kind = reader_.take<char>();
    if (kind == 'F' || kind == 'E' || kind == 'L') {
      made.kind = kind == 'F' ? CellKind::filled : kind == 'E' ? CellKind::empty : CellKind::leaf;
      for (unsigned corner = 0; corner < 8; ++corner) {
        // Theirs counts x as 4, y as 2, z as 1; ours x as 1, y as 2, z as 4.
        const unsigned ours = (corner >> 2 & 1U) | (corner & 2U) | (corner & 1U) << 2;
        made.corners[ours] = distance({range.first[0] + static_cast<int>(corner >> 2 & 1U) * range.count[0],
                                       range.first[1] + static_cast<int>(corner >> 1 & 1U) * range.count[1],
                                       range.first[2] + static_cast<int>(corner & 1U) * range.count[2]});
      }
      return made;
    }
    if (kind != 'B') damaged(path_, "an unknown kind of cell");
    const auto children = reader_.take<std::uint8_t>();
    unsigned axes = 0;
    for (unsigned child = 0; child < 8; ++child)
      if ((children >> child & 1U) != 0) axes |= (child >> 2 & 1U) | (child & 2U) | (child & 1U) << 2;
    std::uint8_t expected = 0;
    for (unsigned child = 0; child < 8; ++child)
      if ((((child >> 2 & 1U) | (child & 2U) | (child & 1U) << 2) & ~axes) == 0)
        expected = static_cast<std::uint8_t>(expected | 1U << child);
    if (children != expected || axes == 0 || (axes & ~range.divisible()) != 0)
      damaged(path_, "a branch with children that do not fit it");
    made.kind = CellKind::branch;
    made.axes = axes;
    made.children.resize(std::size_t{1} << std::popcount(axes));
    for (unsigned child = 0; child < 8; ++child) {
      if ((children >> child & 1U) == 0) continue;
      unsigned number = 0, bit = 0;
      for (unsigned axis = 0; axis < 3; ++axis)
        if ((axes >> axis & 1U) != 0) number |= (child >> (2 - axis) & 1U) << bit++;
      made.children[number] = cell(range.child(axes, number));
    }
    return made;
  }

 private:
  float distance(const std::array<int, 3>& corner) {
    const auto [at, is_new] = known_.try_emplace(corner, 0.0F);
    if (is_new) at->second = static_cast<float>(reader_.take<std::int16_t>()) / scale_;
    return at->second;
  }

  ByteReader& reader_;
  float scale_;
  const std::filesystem::path& path_;
  std::map<std::array<int, 3>, float> known_;
};

}  // namespace

std::shared_ptr<const Asdf> AsdfFile::from_kokopelli(std::string_view bytes, const std::filesystem::path& path) {
  ByteReader reader(bytes, path);
  reader.take<std::array<char, 4>>();
  if (reader.take<std::uint8_t>() != 2 || reader.take<std::uint8_t>() != 0)
    damaged(path, "not version 2.0 of kokopelli's format");
  Box region;
  for (int axis = 0; axis < 3; ++axis) {
    region.lower[axis] = reader.take<float>();
    region.upper[axis] = reader.take<float>();
  }
  const auto lattice = reader.take<std::array<int, 3>>();
  const auto scale = reader.take<float>();
  if (!region.valid() || !std::isfinite(scale) || scale <= 0) damaged(path, "its region or scale is not a number");
  for (const int n : lattice)
    if (n < 0 || n > 1 << 24) damaged(path, "its lattice is not possible");
  const LatticeRange all{{0, 0, 0}, {std::max(lattice[0], 1), std::max(lattice[1], 1), std::max(lattice[2], 1)}};
  const BuildCell root = KokopelliReader(reader, scale, path).cell(all);
  if (reader.left() != 0) damaged(path, "bytes follow the last cell");
  return make(region, lattice, 0, std::make_shared<Asdf::Tree>(packed(root)), path);
}

std::shared_ptr<const Asdf> Asdf::load(const std::filesystem::path& path) {
  const std::string file = read_file(path, std::uintmax_t{1} << 36);
  if (file.starts_with("ASDF")) return AsdfFile::from_kokopelli(file, path);
  if (!file.starts_with(magic) || file.size() < magic.size() + 12) damaged(path, "it does not begin as one");
  const std::string_view body = std::string_view(file).substr(magic.size() + 4);
  std::uint32_t sum = 0;
  std::memcpy(&sum, file.data() + magic.size(), 4);
  if (sum != checksum(body)) damaged(path, "its checksum is wrong");
  std::uint64_t size = 0;
  std::memcpy(&size, body.data(), 8);
  if (size > CellWord::most_cells * (sizeof(CellWord) + sizeof(LeafSamples)) + 1024) damaged(path, "its size is not possible");
  require_memory(2 * size, path.string());
  const std::string raw = decompressed(body.substr(8), size);
  if (raw.size() != size) damaged(path, "it cannot be decompressed");
  return AsdfFile::from_bytes(raw, path);
}

void Asdf::save(const std::filesystem::path& path) const {
  if (root_ != 0) throw Error(ErrorKind::internal, path.string(), "only a whole distance field can be saved");
  const std::string raw = AsdfFile::bytes_of(*this);
  std::string body;
  append(body, std::uint64_t{raw.size()});
  std::string packed_bytes(ZSTD_compressBound(raw.size()), '\0');
  const std::size_t packed_size = ZSTD_compress(packed_bytes.data(), packed_bytes.size(), raw.data(), raw.size(), 3);
  if (ZSTD_isError(packed_size) != 0) throw Error(ErrorKind::internal, path.string(), ZSTD_getErrorName(packed_size));
  body.append(packed_bytes, 0, packed_size);
  const std::uint32_t sum = checksum(body);
  PendingFile file(path);
  file.write(magic);
  file.write(&sum, sizeof sum);
  file.write(body);
  file.commit();
}

}  // namespace fieldfab

// .asdf files, version 2 (docs/asdf-format.md): a header, blocks, and a directory at the end, with
// the cells above the blocks and the positions of the blocks for each level.
#include "asdf_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <bit>
#include <cmath>

#include "byte_reader.h"
#include "fieldfab/core/mapped_file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"

namespace fieldfab {
namespace {

constexpr std::string_view magic = "FFASDF2\n";
constexpr std::size_t header_size = 160;
constexpr std::size_t most_directory = std::size_t{1} << 30, most_block = std::size_t{4} << 20;  // bytes, unpacked
constexpr std::uint32_t most_levels = 32;
constexpr unsigned char block_bit = 32;  // in a cell's byte

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

LatticeRange whole(const std::array<int, 3>& lattice) {
  return {{0, 0, 0}, {std::max(lattice[0], 1), std::max(lattice[1], 1), std::max(lattice[2], 1)}};
}

struct Header {
  double max_error, quantum;
  Eigen::Affine3d placement;
  std::uint32_t levels;
  std::uint64_t directory_offset, directory_size, directory_raw_size;
  std::uint32_t directory_checksum;
};

/// Entry of a level in the directory.
struct Level {
  Box region;
  std::array<int, 3> lattice;
  std::string kinds, corners;
  struct Block {
    std::uint64_t offset;
    std::uint32_t size, raw_size, checksum, cells, leafs;
  };
  std::vector<Block> blocks;
};

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Header read_header(std::string_view file, const std::filesystem::path& path) {
  if (!file.starts_with(magic) || file.size() < header_size) damaged(path, "it does not begin as one");
  ByteReader reader(file.substr(magic.size(), header_size - magic.size()), path);
  const auto sum = reader.take<std::uint32_t>();
  if (sum != checksum(file.substr(magic.size() + 4, header_size - magic.size() - 4)))
    damaged(path, "the checksum of its header is wrong");
  Header header{};
  header.levels = reader.take<std::uint32_t>();
  header.max_error = reader.take<double>();
  header.quantum = reader.take<double>();
  header.placement = Eigen::Affine3d::Identity();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) header.placement.matrix()(row, column) = reader.take<double>();
  header.directory_offset = reader.take<std::uint64_t>();
  header.directory_size = reader.take<std::uint64_t>();
  header.directory_raw_size = reader.take<std::uint64_t>();
  header.directory_checksum = reader.take<std::uint32_t>();
  if (header.levels == 0 || header.levels > most_levels || !std::isfinite(header.max_error) || !(header.quantum > 0) ||
      !std::isfinite(header.quantum) || !header.placement.matrix().allFinite() ||
      std::abs(header.placement.linear().determinant()) < 1e-9)
    damaged(path, "its header is not possible");
  return header;
}

std::vector<Level> read_directory(std::string_view file, const Header& header, const std::filesystem::path& path) {
  if (header.directory_offset > file.size() || header.directory_size > file.size() - header.directory_offset ||
      header.directory_raw_size > most_directory || header.directory_raw_size > 2000 * header.directory_size + 1000)
    damaged(path, "its directory is not in it");
  const std::string_view bytes = file.substr(header.directory_offset, header.directory_size);
  if (checksum(bytes) != header.directory_checksum) damaged(path, "the checksum of its directory is wrong");
  const std::string raw = decompressed(bytes, header.directory_raw_size);
  if (raw.size() != header.directory_raw_size) damaged(path, "its directory cannot be decompressed");
  ByteReader reader(raw, path);
  std::vector<Level> levels(header.levels);
  const auto take_text = [&](std::uint64_t size) {
    if (size > reader.left()) damaged(path, "its directory ends too early");
    std::string text(size, '\0');
    reader.take(text.data(), size);
    return text;
  };
  for (Level& level : levels) {
    reader.take(level.region.lower.data(), 3 * sizeof(double));
    reader.take(level.region.upper.data(), 3 * sizeof(double));
    level.lattice = reader.take<std::array<int, 3>>();
    const auto kinds = reader.take<std::uint32_t>(), corners = reader.take<std::uint32_t>(),
               blocks = reader.take<std::uint32_t>();
    level.kinds = take_text(kinds);
    level.corners = take_text(corners);
    if (std::uint64_t{blocks} * 28 > reader.left()) damaged(path, "its directory ends too early");
    level.blocks.resize(blocks);
    for (Level::Block& block : level.blocks) {
      block.offset = reader.take<std::uint64_t>();
      for (std::uint32_t* number : {&block.size, &block.raw_size, &block.checksum, &block.cells, &block.leafs})
        *number = reader.take<std::uint32_t>();
      if (block.offset > file.size() || block.size > file.size() - block.offset || block.raw_size > most_block ||
          block.cells > block.raw_size || block.leafs > block.cells)
        damaged(path, "a block is not in it");
    }
  }
  if (reader.left() != 0) damaged(path, "bytes follow its directory");
  return levels;
}

/// Assembles the tree of a level from its trunk and its blocks.
class Assembly {
 public:
  Assembly(std::string_view file, const Header& header, const Level& level, const std::optional<Box>& region,
           const std::filesystem::path& path)
      : file_(file), header_(header), level_(level), region_(region), path_(path) {}

  Asdf::Tree run() {
    require_memory(24 * total(), path_.string());
    tree_.cells.resize(1);
    add(0, whole(level_.lattice));
    if (next_kind_ != level_.kinds.size() || next_block_ != level_.blocks.size() ||
        next_corner_ != level_.corners.size())
      damaged(path_, "its directory holds more than its tree");
    std::vector<Asdf::Tree> parts(wanted_.size());
    parallel_for(wanted_.size(), [&](std::size_t i) {
      const Level::Block& block = level_.blocks[wanted_[i].block];
      const std::string_view bytes = file_.substr(block.offset, block.size);
      if (checksum(bytes) != block.checksum) damaged(path_, "the checksum of a block is wrong");
      EncodedBlock counts;
      counts.raw_size = block.raw_size, counts.cells = block.cells, counts.leafs = block.leafs;
      parts[i] = decode_block(bytes, counts, wanted_[i].range, header_.quantum, path_.string());
    });
    for (std::size_t i = 0; i < parts.size(); ++i) splice(wanted_[i].cell, parts[i]), parts[i] = {};
    return std::move(tree_);
  }

 private:
  struct Wanted {
    std::size_t cell, block;
    LatticeRange range;
  };

  [[nodiscard]] std::size_t total() const {
    std::size_t cells = level_.kinds.size();
    for (const Level::Block& block : level_.blocks) cells += block.cells;
    if (cells > CellWord::most_cells) throw Error(ErrorKind::too_large, path_.string(), "has more than 2^27 cells");
    return cells;
  }

  [[nodiscard]] bool is_wanted(const LatticeRange& range) const {
    if (!region_) return true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      if (level_.lattice[axis] == 0) continue;
      const double cell = level_.region.size()[a] / level_.lattice[axis];
      const double lower = level_.region.lower[a] + cell * range.first[axis], upper = lower + cell * range.count[axis];
      if (upper < region_->lower[a] || lower > region_->upper[a]) return false;
    }
    return true;
  }

  void add(std::size_t at, const LatticeRange& range) {
    if (next_kind_ >= level_.kinds.size()) damaged(path_, "its directory ends too early");
    const auto byte = static_cast<unsigned char>(level_.kinds[next_kind_++]);
    if ((byte & block_bit) != 0) {
      if (byte != block_bit || next_block_ >= level_.blocks.size() || range.longest() > brick_side)
        damaged(path_, "a block stands where none can be");
      if (is_wanted(range)) wanted_.push_back({at, next_block_, range});
      ++next_block_;
      return;
    }
    const auto kind = static_cast<CellKind>(byte & 3U);
    const unsigned axes = byte >> 2U;
    if (kind == CellKind::branch) {
      if (axes == 0 || (axes & ~range.divisible()) != 0) damaged(path_, "its cells do not make a tree");
      const std::size_t first = tree_.cells.size(), count = std::size_t{1} << std::popcount(axes);
      if (first + count > level_.kinds.size()) damaged(path_, "its directory ends too early");
      tree_.cells.resize(first + count);
      tree_.cells[at] = CellWord::branch(first, axes);
      for (std::size_t i = 0; i < count; ++i) add(first + i, range.child(axes, static_cast<unsigned>(i)));
      return;
    }
    if (axes != 0) damaged(path_, "its cells do not make a tree");
    tree_.cells[at] = CellWord::of(kind);
    if (kind != CellKind::leaf) return;
    std::array<std::int32_t, 8> steps;
    if (level_.corners.size() - next_corner_ < sizeof steps) damaged(path_, "its directory ends too early");
    std::memcpy(steps.data(), level_.corners.data() + next_corner_, sizeof steps);
    next_corner_ += sizeof steps;
    std::array<float, 8> distances;
    for (std::size_t i = 0; i < 8; ++i) distances[i] = static_cast<float>(steps[i] * header_.quantum);
    tree_.cells[at] = CellWord::leaf(tree_.leafs.size());
    tree_.leafs.push_back(LeafSamples::of(distances));
  }

  /// Inserts a block's tree at a cell.
  void splice(std::size_t cell, const Asdf::Tree& part) {
    const std::size_t shift = tree_.cells.size() - 1, leafs = tree_.leafs.size();  // the root replaces the cell
    const auto moved = [&](const CellWord& word) {
      if (word.kind() == CellKind::branch) return CellWord::branch(word.first_child() + shift, word.axes());
      return word.kind() == CellKind::leaf ? CellWord::leaf(word.samples() + leafs) : word;
    };
    tree_.cells[cell] = moved(part.cells[0]);
    for (std::size_t i = 1; i < part.cells.size(); ++i) tree_.cells.push_back(moved(part.cells[i]));
    tree_.leafs.insert(tree_.leafs.end(), part.leafs.begin(), part.leafs.end());
  }

  std::string_view file_;
  const Header& header_;
  const Level& level_;
  const std::optional<Box>& region_;
  const std::filesystem::path& path_;
  Asdf::Tree tree_;
  std::vector<Wanted> wanted_;
  std::size_t next_kind_ = 0, next_block_ = 0, next_corner_ = 0;
};

/// Returns a cell of a packed tree with its descendants.
BuildCell unpacked(const Asdf::Tree& tree, CellWord word) {
  BuildCell cell;
  cell.kind = word.kind();
  if (cell.kind == CellKind::leaf)
    for (std::size_t i = 0; i < 8; ++i) cell.corners[i] = tree.leafs[word.samples()].corner(i);
  if (cell.kind != CellKind::branch) return cell;
  cell.axes = word.axes();
  for (unsigned i = 0; i < 1U << std::popcount(cell.axes); ++i)
    cell.children.push_back(unpacked(tree, tree.cells[word.first_child() + i]));
  return cell;
}

/// Writes the blocks below a cell and returns the cells above them.
BuildCell trunk_of(const Asdf::Tree& tree, CellWord word, const LatticeRange& range, double quantum,
                   AsdfWriter& writer) {
  if (word.kind() != CellKind::branch) return unpacked(tree, word);
  if (range.longest() <= brick_side) {
    writer.add(range, encode_block(unpacked(tree, word), range, quantum));
    return block_mark();
  }
  BuildCell cell;
  cell.kind = CellKind::branch;
  cell.axes = word.axes();
  for (unsigned i = 0; i < 1U << std::popcount(cell.axes); ++i)
    cell.children.push_back(
        trunk_of(tree, tree.cells[word.first_child() + i], range.child(cell.axes, i), quantum, writer));
  return cell;
}

}  // namespace

BuildCell block_mark() {
  BuildCell mark;
  mark.kind = CellKind::branch;
  mark.axes = 7;  // a branch that splits all axes is never merged with another
  return mark;
}

AsdfWriter::AsdfWriter(const std::filesystem::path& path, const Header& header)
    : file_(path), header_(header), size_(header_size) {
  file_.write(std::string(header_size, '\0'));
}

void AsdfWriter::begin_level(const Box& region, const std::array<int, 3>& lattice) {
  region_ = region;
  lattice_ = lattice;
  records_.clear();
  kinds_.clear(), corners_.clear(), table_.clear();
  ++levels_;
}

void AsdfWriter::add(const LatticeRange& range, const EncodedBlock& block) {
  records_[range.first] = {size_,          static_cast<std::uint32_t>(block.bytes.size()),
                           block.raw_size, checksum(block.bytes),
                           block.cells,    block.leafs};
  file_.write(block.bytes);
  size_ += block.bytes.size();
}

void AsdfWriter::add_trunk(const BuildCell& cell, const LatticeRange& range) {
  if (is_block_mark(cell)) {
    const Record& record = records_.at(range.first);
    append(table_, record.offset);
    for (const std::uint32_t number : {record.size, record.raw_size, record.checksum, record.cells, record.leafs})
      append(table_, number);
    kinds_ += static_cast<char>(block_bit);
    return;
  }
  kinds_ +=
      static_cast<char>(static_cast<unsigned>(cell.kind) | (cell.kind == CellKind::branch ? cell.axes << 2U : 0U));
  if (cell.kind == CellKind::leaf)
    for (const float corner : cell.corners) append(corners_, quantised(corner, header_.quantum));
  for (std::size_t i = 0; i < cell.children.size(); ++i)
    add_trunk(cell.children[i], range.child(cell.axes, static_cast<unsigned>(i)));
}

void AsdfWriter::end_level(const BuildCell& trunk) {
  add_trunk(trunk, whole(lattice_));
  for (const double bound : {region_.lower.x(), region_.lower.y(), region_.lower.z(), region_.upper.x(),
                             region_.upper.y(), region_.upper.z()})
    append(directory_, bound);
  append(directory_, lattice_);
  for (const std::size_t size : {kinds_.size(), corners_.size(), table_.size() / 28})
    append(directory_, static_cast<std::uint32_t>(size));
  directory_ += kinds_ + corners_ + table_;
}

void AsdfWriter::commit() {
  const std::string directory = compressed(directory_);
  file_.write(directory);
  std::string body;
  append(body, levels_);
  append(body, header_.max_error);
  append(body, header_.quantum);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) append(body, header_.placement.matrix()(row, column));
  append(body, size_);
  append(body, std::uint64_t{directory.size()});
  append(body, std::uint64_t{directory_.size()});
  append(body, checksum(directory));
  body.resize(header_size - magic.size() - sizeof(std::uint32_t), '\0');
  std::string header(magic);
  append(header, checksum(body));
  header += body;
  file_.rewrite(0, header.data(), header.size());
  file_.commit();
}

std::shared_ptr<const Asdf> AsdfFile::make(Contents contents, const std::filesystem::path& path) {
  auto& [region, lattice, max_error, placement, tree] = contents;
  if (!region.valid() || !std::isfinite(max_error)) damaged(path, "its region is not finite");
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (lattice[axis] < 0 || lattice[axis] > 1 << 24 ||
        (lattice[axis] > 0) != (region.size()[static_cast<Eigen::Index>(axis)] > 0))
      damaged(path, "its lattice does not fit its region");
  for (const LeafSamples& samples : tree.leafs) tree.greatest = std::max(tree.greatest, 32768 * samples.step);
  std::shared_ptr<Asdf> asdf(new Asdf(region, lattice, max_error, std::make_shared<Asdf::Tree>(std::move(tree))));
  asdf->placement_ = placement;
  return asdf;
}

void AsdfFile::write(const Asdf& asdf, AsdfWriter& writer, double quantum) {
  writer.begin_level(asdf.region_, asdf.lattice_);
  writer.end_level(trunk_of(*asdf.tree_, asdf.tree_->cells[0], whole(asdf.lattice_), quantum, writer));
}

std::shared_ptr<const Asdf> Asdf::load(const std::filesystem::path& path, const AsdfPart& part) {
  const MappedFile mapped(path);
  const std::string_view file = text_of(mapped.bytes());
  if (file.starts_with("ASDF")) {
    if (part.level != 0) throw Error(ErrorKind::bad_input, path.string(), "has one level only");
    return AsdfFile::make(AsdfFile::from_kokopelli(file, path), path);
  }
  const Header header = read_header(file, path);
  const std::vector<Level> levels = read_directory(file, header, path);
  if (part.level < 0 || part.level >= static_cast<int>(levels.size()))
    throw Error(ErrorKind::bad_input, path.string(),
                fmt::format("has no level {}; there are 0 to {}", part.level, levels.size() - 1));
  const Level& level = levels[static_cast<std::size_t>(part.level)];
  for (const int n : level.lattice)
    if (n < 0 || n > 1 << 24) damaged(path, "its lattice is not possible");
  return AsdfFile::make({level.region, level.lattice, header.max_error, header.placement,
                         Assembly(file, header, level, part.region, path).run()},
                        path);
}

AsdfFileInfo Asdf::look(const std::filesystem::path& path) {
  const MappedFile mapped(path);
  const std::string_view file = text_of(mapped.bytes());
  AsdfFileInfo info;
  info.file_size = file.size();
  if (file.starts_with("ASDF")) return info;
  const Header header = read_header(file, path);
  info.quantum = header.quantum;
  info.placement = header.placement;
  for (const Level& level : read_directory(file, header, path)) {
    info.levels.push_back({level.region, level.lattice, level.blocks.size(), level.kinds.size(), 0});
    for (const auto& block : level.blocks)
      info.levels.back().cells += block.cells - 1, info.levels.back().bytes += block.size;
  }
  return info;
}

void Asdf::save(const std::filesystem::path& path, const AsdfFileSettings& settings, Progress& progress) const {
  if (root_ != 0) throw Error(ErrorKind::internal, path.string(), "only a whole distance field can be saved");
  if (settings.levels < 1 || settings.levels > static_cast<int>(most_levels))
    throw Error(ErrorKind::bad_input, "levels",
                fmt::format("{} levels; from 1 to {} are possible", settings.levels, most_levels));
  const double quantum = settings.quantum_for(voxel());
  AsdfWriter writer(path, {max_error_, quantum, placement_});
  AsdfFile::write(*this, writer, quantum);
  double cell = voxel();
  for (int level = 1; level < settings.levels; ++level) {
    cell *= 2;
    AsdfFile::write(*build(*this, region_, {cell, max_error_, true}, progress), writer, quantum);
  }
  writer.commit();
}

double AsdfFileSettings::quantum_for(double voxel) const {
  if (quantum < 0) return voxel / 1024;
  if (!(quantum > 0) || !std::isfinite(quantum))
    throw Error(ErrorKind::bad_input, "quantum", fmt::format("{} is not a positive number of mm", quantum));
  return quantum;
}

FieldPtr Asdf::placed() const {
  return placement_.matrix().isIdentity(0) ? shared_from_this() : transform(shared_from_this(), placement_);
}

}  // namespace fieldfab

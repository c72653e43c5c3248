#include "fieldfab/asdf/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <memory>

#include "asdf_cells.h"
#include "asdf_file.h"
#include "byte_reader.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/mapped_file.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

/// Rows of slices that the blocks of a layer, or of a part of it, need.
struct Slab {
  std::vector<float> values;
  std::array<int, 3> first{};  ///< lattice point of the first value
  std::array<int, 3> points{};

  [[nodiscard]] const float* row(int y, int z) const {
    return values.data() + static_cast<std::size_t>(points[0]) *
                               (static_cast<std::size_t>(y - first[1]) +
                                static_cast<std::size_t>(points[1]) * static_cast<std::size_t>(z - first[2]));
  }
};

/// Result for a brick, a cell that becomes a block of the file.
struct Brick {
  BuildCell root;  ///< a mark if there is a block
  EncodedBlock block;
};

/// Returns the bricks of a lattice in the order of reading and writing: layers from the bottom up,
/// each row by row.
std::vector<LatticeRange> bricks_of(const LatticeRange& whole) {
  std::vector<LatticeRange> bricks, open{whole};
  while (!open.empty()) {
    const LatticeRange range = open.back();
    open.pop_back();
    if (range.longest() <= brick_side) {
      bricks.push_back(range);
      continue;
    }
    const unsigned axes = range.divisible();
    for (unsigned i = 0; i < 1U << std::popcount(axes); ++i) open.push_back(range.child(axes, i));
  }
  std::sort(bricks.begin(), bricks.end(), [](const LatticeRange& a, const LatticeRange& b) {
    return std::array{a.first[2], a.first[1], a.first[0]} < std::array{b.first[2], b.first[1], b.first[0]};
  });
  return bricks;
}

std::array<int, 3> lattice_of(const LatticeSource& source) {
  return {source.points[0] - 1, source.points[1] - 1, source.points[2] - 1};
}

/// Makes bricks from the values of a lattice.
class BrickMaker {
 public:
  BrickMaker(const LatticeSource& source, double max_error, double quantum, std::size_t memory, Progress& progress)
      : source_(source),
        maker_(source.region, lattice_of(source), max_error, true, std::numeric_limits<std::uintmax_t>::max()),
        quantum_(quantum),
        memory_(memory),
        progress_(progress) {}

  /// Calls take(range, brick) for each of the bricks, in order.
  template <class Take>
  void run(const std::vector<LatticeRange>& bricks, const Take& take) {
    for (auto from = bricks.begin(); from != bricks.end();) {
      const auto to = end_of_batch(from, bricks.end());
      const Slab slab = read(*from, *(to - 1));
      std::vector<Brick> made(static_cast<std::size_t>(to - from));
      parallel_for(made.size(), [&](std::size_t i) {
        progress_.check();
        const LatticeRange& range = from[static_cast<std::ptrdiff_t>(i)];
        Brick& brick = made[i];
        brick.root = cells(slab, range);
        if (brick.root.kind != CellKind::branch) return;
        brick.block = encode_block(brick.root, range, quantum_);
        brick.root = block_mark();
      });
      for (std::size_t i = 0; i < made.size(); ++i) {
        const LatticeRange& range = from[static_cast<std::ptrdiff_t>(i)];
        take(range, std::move(made[i]));
        done_ += maker_.share(range);
      }
      progress_.report(done_, "importing the volume");
      from = to;
    }
  }

 private:
  using Place = std::vector<LatticeRange>::const_iterator;

  /// Returns the end of the bricks of one layer whose rows fit into memory together, at least one
  /// row of bricks.
  [[nodiscard]] Place end_of_batch(Place from, Place last) const {
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(source_.points[0]);
    const std::size_t slices = static_cast<std::size_t>(from->count[2]) + 1;
    Place to = from;
    for (; to != last && to->first[2] == from->first[2]; ++to) {
      const auto rows = static_cast<std::size_t>(to->first[1] + to->count[1] - from->first[1] + 1);
      if (to->first[1] != from->first[1] && rows * slices * row > memory_) break;
    }
    return to;
  }

  /// Reads the values from one brick to another of the same layer, in whole rows.
  [[nodiscard]] Slab read(const LatticeRange& from, const LatticeRange& to) const {
    Slab slab;
    slab.first = {0, from.first[1], from.first[2]};
    slab.points = {source_.points[0], to.first[1] + to.count[1] - from.first[1] + 1, from.count[2] + 1};
    const std::size_t part = static_cast<std::size_t>(slab.points[0]) * static_cast<std::size_t>(slab.points[1]);
    const std::size_t slice = static_cast<std::size_t>(source_.points[0]) * static_cast<std::size_t>(source_.points[1]);
    require_memory(sizeof(float) * (part * static_cast<std::size_t>(slab.points[2]) + (part == slice ? 0 : 2 * slice)),
                   "volume");
    slab.values.resize(part * static_cast<std::size_t>(slab.points[2]));
    parallel_for(static_cast<std::size_t>(slab.points[2]), [&](std::size_t k) {
      progress_.check();
      const int z = slab.first[2] + static_cast<int>(k);
      if (part == slice) return source_.read(z, 1, slab.values.data() + k * part);
      std::vector<float> whole(slice);
      source_.read(z, 1, whole.data());
      std::copy_n(whole.data() + static_cast<std::size_t>(slab.first[1]) * static_cast<std::size_t>(slab.points[0]),
                  part, slab.values.data() + k * part);
    });
    return slab;
  }

  BuildCell cells(const Slab& slab, const LatticeRange& range) {
    if (range.longest() <= block_side) {
      BlockSamples samples;
      std::array<std::size_t, 3> points;
      for (std::size_t axis = 0; axis < 3; ++axis) points[axis] = static_cast<std::size_t>(range.count[axis]) + 1;
      float* to = samples.value.data();
      for (int k = 0; k <= range.count[2]; ++k)
        for (int j = 0; j <= range.count[1]; ++j, to += points[0])
          std::copy_n(slab.row(range.first[1] + j, range.first[2] + k) + range.first[0], points[0], to);
      return maker_.block(samples.all(points), range);
    }
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    for (std::size_t i = 0; i < children.size(); ++i)
      children[i] = cells(slab, range.child(axes, static_cast<unsigned>(i)));
    return maker_.joined(std::move(children), axes, range);
  }

  const LatticeSource& source_;
  CellMaker maker_;
  double quantum_;
  std::size_t memory_;
  Progress& progress_;
  double done_ = 0;
};

/// Writes a level of a file: takes its bricks in order, then makes the cells above them.
class LevelWriter {
 public:
  LevelWriter(const LatticeSource& source, double max_error, AsdfWriter& writer, ImportCounts& counts)
      : maker_(source.region, lattice_of(source), max_error, true, std::numeric_limits<std::uintmax_t>::max()),
        writer_(writer),
        counts_(counts) {
    writer_.begin_level(source.region, lattice_of(source));
  }
  void take(const LatticeRange& range, Brick brick) {
    if (is_block_mark(brick.root)) {
      writer_.add(range, brick.block);
      counts_.cells += brick.block.cells, counts_.leafs += brick.block.leafs, ++counts_.blocks;
    }
    roots_.emplace(range.first, std::move(brick.root));
  }
  void finish() { writer_.end_level(trunk(maker_.whole())); }

 private:
  BuildCell trunk(const LatticeRange& range) {
    if (range.longest() <= brick_side) return std::move(roots_.at(range.first));
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    for (std::size_t i = 0; i < children.size(); ++i) children[i] = trunk(range.child(axes, static_cast<unsigned>(i)));
    return maker_.joined(std::move(children), axes, range);
  }

  CellMaker maker_;
  AsdfWriter& writer_;
  ImportCounts& counts_;
  std::map<std::array<int, 3>, BuildCell> roots_;  ///< of the bricks, by their first lattice cell
};

double smallest_side(const LatticeSource& source) {
  double side = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
    side = std::min(side, source.region.size()[static_cast<Eigen::Index>(axis)] / (source.points[axis] - 1));
  return side;
}

/// Error and quantum that the settings give for these levels.
struct Precision {
  double max_error, quantum;
  Precision(const std::vector<LatticeSource>& levels, const ImportSettings& settings,
            const std::filesystem::path& path) {
    for (const LatticeSource& level : levels)
      if (!level.region.valid() || level.region.size().minCoeff() <= 0 ||
          std::min({level.points[0], level.points[1], level.points[2]}) < 2)
        throw Error(ErrorKind::bad_input, path.string(),
                    "a lattice needs two points and a positive length along each axis");
    const double side = smallest_side(levels.front());
    max_error = settings.max_error < 0 ? side / 10 : settings.max_error;
    quantum = settings.file.quantum_for(side);
  }
};

// File of a part, for this machine only. For each level and each of its bricks in the part: kind,
// slack and corners of the root, then the block's numbers and its bytes.
constexpr std::string_view part_magic = "FFPART1\n";

/// Returns the bricks of a level that a part processes: whole layers.
std::vector<LatticeRange> share_of(std::vector<LatticeRange> bricks, const ImportShare& share) {
  std::vector<int> layers;
  for (const LatticeRange& brick : bricks)
    if (layers.empty() || layers.back() != brick.first[2]) layers.push_back(brick.first[2]);
  std::erase_if(bricks, [&](const LatticeRange& brick) {
    const auto layer =
        static_cast<std::size_t>(std::find(layers.begin(), layers.end(), brick.first[2]) - layers.begin());
    return layer * static_cast<std::size_t>(share.parts) / layers.size() != static_cast<std::size_t>(share.part);
  });
  return bricks;
}

}  // namespace

ImportCounts import_asdf(const std::vector<LatticeSource>& levels, const std::filesystem::path& path,
                         const ImportSettings& settings, Progress& progress) {
  const Precision precision(levels, settings, path);
  AsdfWriter writer(path, {precision.max_error, precision.quantum, levels.front().placement});
  ImportCounts counts;
  for (const LatticeSource& source : levels) {
    LevelWriter level(source, precision.max_error, writer, counts);
    BrickMaker(source, precision.max_error, precision.quantum, settings.memory, progress)
        .run(bricks_of({{0, 0, 0}, lattice_of(source)}),
             [&](const LatticeRange& range, Brick brick) { level.take(range, std::move(brick)); });
    level.finish();
  }
  writer.commit();
  return counts;
}

void import_part(const std::vector<LatticeSource>& levels, const std::filesystem::path& path,
                 const ImportSettings& settings, const ImportShare& share, Progress& progress) {
  if (share.parts < 1 || share.part < 0 || share.part >= share.parts)
    throw Error(ErrorKind::bad_input, "part", fmt::format("there is no part {} of {}", share.part, share.parts));
  const Precision precision(levels, settings, path);
  PendingFile file(path);
  std::string head(part_magic);
  append(head, share);
  file.write(head);
  for (const LatticeSource& source : levels)
    BrickMaker(source, precision.max_error, precision.quantum, settings.memory, progress)
        .run(share_of(bricks_of({{0, 0, 0}, lattice_of(source)}), share),
             [&](const LatticeRange& range, const Brick& brick) {
               std::string record;
               append(record, range.first);
               append(record, brick.root.kind);
               append(record, brick.root.slack);
               append(record, brick.root.corners);
               for (const std::uint32_t number : {brick.block.raw_size, brick.block.cells, brick.block.leafs,
                                                  static_cast<std::uint32_t>(brick.block.bytes.size())})
                 append(record, number);
               file.write(record);
               file.write(brick.block.bytes);
             });
  file.commit();
}

ImportCounts merge_parts(const std::vector<LatticeSource>& levels, const std::vector<std::filesystem::path>& parts,
                         const std::filesystem::path& path, const ImportSettings& settings, Progress& progress) {
  const Precision precision(levels, settings, path);
  AsdfWriter writer(path, {precision.max_error, precision.quantum, levels.front().placement});
  struct Part {
    MappedFile file;
    ByteReader reader;
    explicit Part(const std::filesystem::path& from)
        : file(from), reader({reinterpret_cast<const char*>(file.bytes().data()), file.bytes().size()}, from) {}
  };
  std::vector<std::unique_ptr<Part>> open;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    open.push_back(std::make_unique<Part>(parts[i]));
    const auto magic = open.back()->reader.take<std::array<char, 8>>();
    const auto share = open.back()->reader.take<ImportShare>();
    if (std::string_view(magic.data(), magic.size()) != part_magic || share.part != static_cast<int>(i) ||
        share.parts != static_cast<int>(parts.size()))
      throw Error(ErrorKind::bad_input, parts[i].string(),
                  fmt::format("is not part {} of {} of an import", i, parts.size()));
  }
  ImportCounts counts;
  for (const LatticeSource& source : levels) {
    progress.check();
    LevelWriter level(source, precision.max_error, writer, counts);
    const std::vector<LatticeRange> bricks = bricks_of({{0, 0, 0}, lattice_of(source)});
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const LatticeRange& range : share_of(bricks, {static_cast<int>(i), static_cast<int>(parts.size())})) {
        ByteReader& reader = open[i]->reader;
        if (reader.take<std::array<int, 3>>() != range.first)
          throw Error(ErrorKind::bad_input, parts[i].string(), "is a part of another volume's import");
        Brick brick;
        brick.root.kind = reader.take<CellKind>();
        brick.root.slack = reader.take<float>();
        brick.root.corners = reader.take<std::array<float, 8>>();
        for (std::uint32_t* number : {&brick.block.raw_size, &brick.block.cells, &brick.block.leafs})
          *number = reader.take<std::uint32_t>();
        brick.block.bytes.resize(std::min<std::size_t>(reader.take<std::uint32_t>(), reader.left()));
        reader.take(brick.block.bytes.data(), brick.block.bytes.size());
        if (brick.root.kind == CellKind::branch) brick.root = block_mark();
        level.take(range, std::move(brick));
      }
    level.finish();
  }
  writer.commit();
  return counts;
}

}  // namespace fieldfab

#include "fieldfab/asdf/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <map>

#include "asdf_cells.h"
#include "asdf_file.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab {
namespace {

/// Some rows of some slices: those that the blocks of one layer, or of a part of it, need.
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

class Importer {
 public:
  Importer(const LatticeSource& source, double max_error, double quantum, std::size_t memory, AsdfWriter& writer, Progress& progress)
      : source_(source),
        lattice_{source.points[0] - 1, source.points[1] - 1, source.points[2] - 1},
        maker_(source.region, lattice_, max_error, true, std::numeric_limits<std::uintmax_t>::max()),
        quantum_(quantum),
        memory_(memory),
        writer_(writer),
        progress_(progress) {}

  void run(ImportCounts& counts) {
    writer_.begin_level(source_.region, lattice_);
    std::vector<LatticeRange> bricks;
    collect(maker_.whole(), bricks);
    // In layers from the bottom up, and in each row by row: the order in which slices are read, and blocks written.
    std::sort(bricks.begin(), bricks.end(), [](const LatticeRange& a, const LatticeRange& b) {
      return std::array{a.first[2], a.first[1], a.first[0]} < std::array{b.first[2], b.first[1], b.first[0]};
    });
    for (auto from = bricks.cbegin(); from != bricks.cend();) {
      const auto to = end_of_batch(from, bricks.cend());
      import(from, to, counts);
      from = to;
    }
    writer_.end_level(trunk(maker_.whole()));
  }

 private:
  using Brick = std::vector<LatticeRange>::const_iterator;

  static void collect(const LatticeRange& range, std::vector<LatticeRange>& bricks) {
    if (range.longest() <= brick_side) return bricks.push_back(range);
    const unsigned axes = range.divisible();
    for (unsigned i = 0; i < 1U << std::popcount(axes); ++i) collect(range.child(axes, i), bricks);
  }

  /// The bricks of one layer whose rows fit into memory together, a row of bricks at least.
  [[nodiscard]] Brick end_of_batch(Brick from, Brick last) const {
    const std::size_t row = sizeof(float) * static_cast<std::size_t>(source_.points[0]);
    const std::size_t slices = static_cast<std::size_t>(from->count[2]) + 1;
    Brick to = from;
    for (; to != last && to->first[2] == from->first[2]; ++to) {
      const auto rows = static_cast<std::size_t>(to->first[1] + to->count[1] - from->first[1] + 1);
      // Each thread needs a slice to take the rows from, unless the rows are whole slices.
      if (to->first[1] != from->first[1] && rows * slices * row > memory_) break;
    }
    return to;
  }

  void import(Brick from, Brick to, ImportCounts& counts) {
    const Slab slab = read(*from, *(to - 1));
    struct Made {
      BuildCell root;
      EncodedBlock block;
    };
    std::vector<Made> made(static_cast<std::size_t>(to - from));
    parallel_for(made.size(), [&](std::size_t i) {
      progress_.check();
      const LatticeRange& range = from[static_cast<std::ptrdiff_t>(i)];
      BuildCell root = cells(slab, range);
      if (root.kind == CellKind::branch) {
        made[i].block = encode_block(root, range, quantum_);
        root = block_mark();
      }
      made[i].root = std::move(root);
    });
    for (std::size_t i = 0; i < made.size(); ++i) {
      const LatticeRange& range = from[static_cast<std::ptrdiff_t>(i)];
      if (is_block_mark(made[i].root)) {
        writer_.add(range, made[i].block);
        counts.cells += made[i].block.cells, counts.leafs += made[i].block.leafs, ++counts.blocks;
      }
      done_ += maker_.share(range);
      roots_.emplace(range.first, std::move(made[i].root));
    }
    progress_.report(done_, "importing the volume");
  }

  /// The values from one brick to another of the same layer, whole rows.
  [[nodiscard]] Slab read(const LatticeRange& from, const LatticeRange& to) const {
    Slab slab;
    slab.first = {0, from.first[1], from.first[2]};
    slab.points = {source_.points[0], to.first[1] + to.count[1] - from.first[1] + 1, from.count[2] + 1};
    const std::size_t part = static_cast<std::size_t>(slab.points[0]) * static_cast<std::size_t>(slab.points[1]);
    const std::size_t slice = static_cast<std::size_t>(source_.points[0]) * static_cast<std::size_t>(source_.points[1]);
    slab.values.resize(part * static_cast<std::size_t>(slab.points[2]));
    parallel_for(static_cast<std::size_t>(slab.points[2]), [&](std::size_t k) {
      progress_.check();
      const int z = slab.first[2] + static_cast<int>(k);
      if (part == slice) return source_.read(z, 1, slab.values.data() + k * part);
      std::vector<float> whole(slice);
      source_.read(z, 1, whole.data());
      std::copy_n(whole.data() + static_cast<std::size_t>(slab.first[1]) * static_cast<std::size_t>(slab.points[0]), part,
                  slab.values.data() + k * part);
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
    for (std::size_t i = 0; i < children.size(); ++i) children[i] = cells(slab, range.child(axes, static_cast<unsigned>(i)));
    return maker_.joined(std::move(children), axes, range);
  }

  /// The cells above the bricks.
  BuildCell trunk(const LatticeRange& range) {
    if (range.longest() <= brick_side) return std::move(roots_.at(range.first));
    const unsigned axes = range.divisible();
    std::vector<BuildCell> children(std::size_t{1} << std::popcount(axes));
    for (std::size_t i = 0; i < children.size(); ++i) children[i] = trunk(range.child(axes, static_cast<unsigned>(i)));
    return maker_.joined(std::move(children), axes, range);
  }

  const LatticeSource& source_;
  std::array<int, 3> lattice_;
  CellMaker maker_;
  double quantum_;
  std::size_t memory_;
  AsdfWriter& writer_;
  Progress& progress_;
  std::map<std::array<int, 3>, BuildCell> roots_;  ///< of the bricks, by their first lattice cell
  double done_ = 0;
};

double smallest_side(const LatticeSource& source) {
  double side = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
    side = std::min(side, source.region.size()[static_cast<Eigen::Index>(axis)] / (source.points[axis] - 1));
  return side;
}

}  // namespace

ImportCounts import_asdf(const std::vector<LatticeSource>& levels, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress) {
  for (const LatticeSource& level : levels)
    if (!level.region.valid() || level.region.size().minCoeff() <= 0 || std::min({level.points[0], level.points[1], level.points[2]}) < 2)
      throw Error(ErrorKind::bad_input, path.string(), "a lattice needs two points and a positive length along each axis");
  const double side = smallest_side(levels.front());
  const double max_error = settings.max_error < 0 ? side / 10 : settings.max_error, quantum = settings.file.quantum_for(side);
  AsdfWriter writer(path, {max_error, quantum, levels.front().placement});
  ImportCounts counts;
  for (const LatticeSource& level : levels) Importer(level, max_error, quantum, settings.memory, writer, progress).run(counts);
  writer.commit();
  return counts;
}

}  // namespace fieldfab

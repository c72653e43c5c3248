#include "octree.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "block.h"
#include "division.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::contouring {
namespace {

constexpr std::size_t bytes_a_block = 8192;  // a typical Block with its crossings, leafs, records and triangles

}  // namespace

/// A cube at or above block level.
struct Octree::Node {
  LatticePoint lower;
  int level;
  FieldPtr field;                   ///< the solid in this cube, until the cube is subdivided or sampled
  std::int32_t children = -1;       ///< index of the first of eight
  std::int32_t block = -1;          ///< index into blocks_
  std::optional<Patch> patch = {};  ///< known if the cube is uniform or one patch
  bool beyond = false;              ///< whether the cube is not within the extent; neither field nor patch are set then
  [[nodiscard]] bool open() const { return !patch && !beyond; }
};

Octree::Octree(const Field& solid, const Lattice& lattice, const Extent& extent, const ContourSettings& settings,
               Progress& progress)
    : lattice_(lattice), extent_(extent) {
  subdivide(solid, progress);
  sample_blocks(settings, progress);
  if (wants_half_voxel_ || too_deep_) return;
  number_leafs(merge_blocks(settings));
}

Octree::~Octree() = default;

void Octree::subdivide(const Field& solid, Progress& progress) {
  nodes_.push_back({{0, 0, 0}, lattice_.root_level(), solid.shared_from_this()});
  settle({&nodes_[0], 1});
  for (std::size_t first = 0, last = 1; first < last; first = last, last = nodes_.size()) {
    const int level = nodes_[first].level;
    progress.report(0.0, "searching for the surface");
    if (first > 0)
      parallel_for((last - first) / 8, [&](std::size_t i) {
        progress.check();
        settle({&nodes_[first + 8 * i], 8});
      });

    const auto open =
        static_cast<std::size_t>(std::count_if(nodes_.begin() + static_cast<std::ptrdiff_t>(first), nodes_.end(),
                                               [](const Node& node) { return node.open(); }));
    // A surface has four times as many cells on each finer level, so this is the number of blocks
    // to expect.
    const double blocks = static_cast<double>(open) * std::pow(4.0, level - block_root());
    if (open > 4096) require_memory(static_cast<std::uintmax_t>(blocks / 4) * bytes_a_block, "a mesh this fine");
    if (level == block_root()) return;
    for (std::size_t i = first; i < last; ++i) {
      if (i % 4096 == 0) progress.check();
      if (!nodes_[i].open()) continue;
      nodes_[i].children = static_cast<std::int32_t>(nodes_.size());
      for (unsigned child = 0; child < 8; ++child)
        nodes_.push_back({child_of(nodes_[i].lower, child, level - 1), level - 1, nodes_[i].field});
      nodes_[i].field.reset();
    }
  }
}

/// Restricts siblings, whose Field is still that of their parent, to their own cubes and a margin.
/// Completes those that the surface does not enter, and leaves out those beyond the extent.
void Octree::settle(std::span<Node> siblings) const {
  std::array<Box, 8> cube;
  std::array<Node*, 8> within;
  std::array<Restriction, 8> here;
  std::size_t count = 0;
  const FieldPtr parent = siblings[0].field;
  for (Node& node : siblings) {
    node.field.reset();
    node.beyond = !extent_.meets(node.lower, node.level);
    if (node.beyond) continue;
    cube[count] = lattice_.cube(node.lower, node.level).grown(sheet_overlap * lattice_.voxel());
    within[count++] = &node;
  }
  parent->restrict_all({cube.data(), count}, Purpose::value, here);
  for (std::size_t i = 0; i < count; ++i) {
    if (here[i].range.decided())
      within[i]->patch = Patch{static_cast<std::uint8_t>(here[i].range.inside() ? 255 : 0), {}};
    else
      within[i]->field = std::move(here[i].field);
  }
}

void Octree::sample_blocks(const ContourSettings& settings, Progress& progress) {
  std::vector<Node*> open;
  for (Node& node : nodes_)
    if (node.level == block_root() && node.open()) open.push_back(&node);
  std::vector<Block> sampled(open.size());
  std::vector<std::unique_ptr<BlockRefiner>> refiners(open.size());
  std::atomic<std::size_t> done{0};
  std::atomic<bool> known{false};
  std::atomic<std::size_t> crossed{0}, folded{0};
  std::vector<char> complete(open.size());
  const auto look = [&](std::size_t i) {
    progress.check();
    BlockView view = view_block(*open[i]->field, lattice_, open[i]->lower, settings, sampled[i]);
    if (view.known) known.store(true, std::memory_order_relaxed);
    open[i]->patch = std::move(view.patch);
    crossed += view.crossed;
    folded += static_cast<std::size_t>(
        std::count_if(view.unclear.begin(), view.unclear.end(), [](const UnclearCell& cell) { return cell.folded; }));
    complete[i] = view.complete;
    if (!view.unclear.empty()) {
      refiners[i] = std::make_unique<BlockRefiner>(lattice_, open[i]->lower, open[i]->field);
      refiners[i]->add_unclear(std::move(view.unclear));
    }
    if (const std::size_t count = ++done; count % 256 == 0)
      progress.report(0.6 * static_cast<double>(count) / static_cast<double>(open.size()), "sampling");
  };
  // A few blocks of a thin sheet suffice to show that the voxel is too large.
  constexpr std::size_t step = 8, enough = 32;
  const std::size_t first_ones = (open.size() + step - 1) / step;
  parallel_for(first_ones, [&](std::size_t i) { look(step * i); });
  if (first_ones >= enough && 2 * folded > crossed)
    wants_half_voxel_ = known && half_voxel_pays(step * folded, step * crossed, open.size(), settings);
  if (wants_half_voxel_) return;
  parallel_for(open.size(), [&](std::size_t i) {
    if (i % step != 0) look(i);
  });
  certainty_.doubt = known ? Doubt::finest_size : Doubt::slopes_unknown;
  wants_half_voxel_ = known && half_voxel_pays(folded, crossed, open.size(), settings);
  if (wants_half_voxel_) return;
  refine(open, settings, crossed, progress, refiners);
  if (too_deep_) return;
  parallel_for(open.size(), [&](std::size_t i) {
    if (complete[i] == 0 || (refiners[i] && !refiners[i]->empty())) {
      progress.check();
      sampled[i] = {};
      if (refiners[i]) refiners[i]->move_to(sampled[i]);
      open[i]->patch = sample_block(*open[i]->field, lattice_, open[i]->lower, settings, sampled[i]);
      refiners[i].reset();
    }
    open[i]->field.reset();
  });
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i]->patch && open[i]->patch->uniform()) continue;
    open[i]->block = static_cast<std::int32_t>(blocks_.size());
    blocks_.push_back(std::move(sampled[i]));
  }
}

bool Octree::half_voxel_pays(std::size_t folded, std::size_t crossed, std::size_t blocks,
                             const ContourSettings& settings) const {
  constexpr std::size_t few = 4000;  // halving so many one by one takes less time than a new start
  constexpr std::size_t sheet =
      200;  // a block with more of its 512 cells is rough and contains no sheet; half the voxel does not help
  return lattice_.voxel_level() > 0 && folded > few && folded < sheet * blocks && 6 * folded > crossed &&
         folded <= settings.most_divided && 4 * blocks * bytes_a_block < available_memory() / 2;
}

/// Halves unclear cells, level by level, and then the cells that their neighbours need halved.
void Octree::refine(std::span<Node* const> open, const ContourSettings& settings, std::size_t crossed,
                    Progress& progress, std::vector<std::unique_ptr<BlockRefiner>>& refiners) {
  std::vector<std::size_t> active;
  for (std::size_t i = 0; i < refiners.size(); ++i)
    if (refiners[i]) active.push_back(i);
  const int finest = halve_unclear_cells(active, settings, crossed, progress, refiners);
  if (finest < lattice_.voxel_level()) halve_neighbours(open, std::move(active), finest, settings, progress, refiners);
}

/// Returns the finest level made. Cells that only lack a proof are divided if they are few compared with the folded
/// cells or with the whole surface.
int Octree::halve_unclear_cells(std::span<const std::size_t> active, const ContourSettings& settings,
                                std::size_t crossed, Progress& progress,
                                std::vector<std::unique_ptr<BlockRefiner>>& refiners) {
  int finest = lattice_.voxel_level();
  std::size_t budget = settings.most_divided, folded_before = 0;
  while (finest > 0 && certainty_.doubt != Doubt::slopes_unknown) {
    std::size_t folded = 0, unproved = 0;
    for (const std::size_t i : active)
      for (const UnclearCell& cell : refiners[i]->unclear()) ++(cell.folded ? folded : unproved);
    if (unproved > std::max({std::size_t{2000}, crossed / 64, folded, folded_before})) {
      for (const std::size_t i : active) refiners[i]->give_up_unproved();
      certainty_.doubt = Doubt::not_proved;
      unproved = 0;
    }
    if (folded + unproved == 0) break;
    if (folded + unproved > budget) {
      certainty_.doubt = Doubt::too_many;
      break;
    }
    budget -= folded + unproved;
    folded_before = folded;
    const double level = lattice_.voxel_level() - finest;
    progress.report(0.6 + 0.15 * level / lattice_.voxel_level(), "looking closer");
    parallel_for(active.size(), [&](std::size_t i) {
      progress.check();
      refiners[active[i]]->advance();
    });
    --finest;
  }
  const auto add = [&](std::span<const UnclearCell> cells) {
    const int level = lattice_.voxel_level();
    for (const UnclearCell& cell : cells)
      uncertain_.push_back({{cell.lower[0] >> level, cell.lower[1] >> level, cell.lower[2] >> level},
                            lattice_.cube(cell.lower, cell.level),
                            lattice_.longest_side(cell.level)});
  };
  for (const std::size_t i : active) {
    add(refiners[i]->unclear());
    add(refiners[i]->given_up());
  }
  certainty_.gather(uncertain_);
  certainty_.finest = lattice_.longest_side(finest);
  if (certainty_.doubt == Doubt::finest_size && finest > 0) certainty_.doubt = Doubt::not_proved;
  if (settings.depth == 0) certainty_.doubt = Doubt::not_looked;
  return finest;
}

/// `active`: the blocks in which cells were halved since the last round.
void Octree::halve_neighbours(std::span<Node* const> open, std::vector<std::size_t> active, int finest,
                              const ContourSettings& settings, Progress& progress,
                              std::vector<std::unique_ptr<BlockRefiner>>& refiners) {
  std::map<LatticePoint, std::size_t> number;
  for (std::size_t i = 0; i < open.size(); ++i) number.emplace(open[i]->lower, i);
  std::size_t asked = 0;
  for (;;) {
    progress.check();
    std::vector<DivisionRequest> requests;
    for (const std::size_t i : active) refiners[i]->collect_requests(requests);
    std::sort(requests.begin(), requests.end());
    requests.erase(std::unique(requests.begin(), requests.end()), requests.end());
    if (requests.empty()) return;
    constexpr std::size_t few = 5'000;
    asked += requests.size();
    too_deep_ = asked > std::max(few, settings.most_divided);
    if (too_deep_) return;
    std::vector<std::span<const DivisionRequest>> of_block;
    active.clear();
    for (std::size_t i = 0, next = 0; i < requests.size(); i = next) {
      bool must = false;
      for (; next < requests.size() && requests[next].block == requests[i].block; ++next)
        must = must || !requests[next].only_ambiguous;
      const auto found = number.find(requests[i].block);
      if (found == number.end() && !must) continue;
      if (found == number.end())
        throw Error(ErrorKind::internal, "contour",
                    "a Field's interval or its restriction does not agree with its values");
      of_block.emplace_back(&requests[i], next - i);
      active.push_back(found->second);
    }
    parallel_for(active.size(), [&](std::size_t i) {
      progress.check();
      std::unique_ptr<BlockRefiner>& refiner = refiners[active[i]];
      if (!refiner) refiner = std::make_unique<BlockRefiner>(lattice_, open[active[i]]->lower, open[active[i]]->field);
      for (const DivisionRequest& request : of_block[i]) refiner->divide(request, finest);
      if (refiner->empty()) refiner.reset();
    });
    std::erase_if(active, [&](std::size_t i) { return !refiners[i]; });
  }
}

/// Makes the eight children of a cube one patch, if one vertex reproduces them.
void Octree::merge_children(Node& node, const ContourSettings& settings) {
  if (node.children < 0) return;
  const auto first = static_cast<std::size_t>(node.children);
  std::array<std::uint8_t, 8> corners{};
  bool all = true;
  unsigned any = 0, every = 255;
  for (std::size_t child = 0; child < 8; ++child) {
    const auto& patch = nodes_[first + child].patch;
    all = all && patch.has_value();
    if (!patch) continue;
    corners[child] = patch->corners;
    any |= patch->corners;
    every &= patch->corners;
  }
  if (!all) return;
  if (any == 0 || every == 255) {
    node.patch = Patch{static_cast<std::uint8_t>(any), {}};
    return;
  }
  if (node.level > extent_.greatest_leaf) return;
  Patch merged;
  std::size_t count = 0;
  for (std::size_t child = 0; child < 8; ++child) count += nodes_[first + child].patch->points.size();
  merged.points.reserve(count);
  if (settings.max_error <= 0 || !merge_corners(corners, merged.corners)) return;
  for (std::size_t child = 0; child < 8; ++child) {
    const auto& points = nodes_[first + child].patch->points;
    merged.points.insert(merged.points.end(), points.begin(), points.end());
  }
  const Box cell = lattice_.cube(node.lower, node.level);
  if (is_flat(merged.points, settings.max_error, merged.vertex))
    thin(merged.points, cell);
  else if (!reproduces(merged.points, cell, settings, merged.vertex))
    return;
  for (std::size_t child = 0; child < 8; ++child) nodes_[first + child].patch->points = {};
  node.patch = std::move(merged);
}

/// Returns the leafs that are a block or larger.
std::vector<Leaf> Octree::merge_blocks(const ContourSettings& settings) {
  // Children come after their parents, and all cubes of a level follow each other.
  for (std::size_t last = nodes_.size(), first = last; last > 0; last = first) {
    while (first > 0 && nodes_[first - 1].level == nodes_[last - 1].level) --first;
    parallel_for(last - first, [&](std::size_t i) { merge_children(nodes_[first + i], settings); });
  }

  // A patch that is not part of a larger one is a leaf; the blocks below it get its index.
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> leaf_of_node(nodes_.size(), none);
  std::vector<Leaf> leafs;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if (leaf_of_node[i] == none && node.patch && !node.patch->uniform()) {
      leaf_of_node[i] = static_cast<std::int32_t>(leafs.size());
      leafs.push_back({node.lower, node.patch->vertex.cast<float>(), node.level, node.patch->corners, true});
    }
    if (leaf_of_node[i] == none) continue;
    if (node.children >= 0)
      for (std::int32_t child = 0; child < 8; ++child)
        leaf_of_node[static_cast<std::size_t>(node.children + child)] = leaf_of_node[i];
    if (node.block >= 0) {
      Block& block = blocks_[static_cast<std::size_t>(node.block)];
      block.first_leaf = static_cast<std::uint32_t>(leaf_of_node[i]);
    }
  }
  parallel_for(nodes_.size(), [&](std::size_t i) { nodes_[i].patch.reset(); });
  nodes_ = {};
  return leafs;
}

void Octree::number_leafs(std::span<const Leaf> of_nodes) {
  leaf_count_ = of_nodes.size();
  for (Block& block : blocks_) {
    if (block.leafs.empty()) continue;  // part of a leaf of the nodes
    block.first_leaf = static_cast<std::uint32_t>(leaf_count_);
    leaf_count_ += block.leafs.size();
  }
  leafs_ = std::make_unique_for_overwrite<Leaf[]>(leaf_count_);
  std::copy(of_nodes.begin(), of_nodes.end(), leafs_.get());
  parallel_for(blocks_.size(), [&](std::size_t i) {
    Block& block = blocks_[i];
    std::copy(block.leafs.begin(), block.leafs.end(), leafs_.get() + block.first_leaf);
    block.leafs = {};
  });
  block_order_.resize(blocks_.size());
  std::iota(block_order_.begin(), block_order_.end(), 0U);
  std::sort(block_order_.begin(), block_order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return block_key(blocks_[a].lower) < block_key(blocks_[b].lower);
  });
  block_keys_.reserve(blocks_.size());
  for (const std::uint32_t block : block_order_) block_keys_.push_back(block_key(blocks_[block].lower));
}

std::uint64_t Octree::block_key(const LatticePoint& lower) const {
  std::uint64_t key = 0;
  for (const std::int32_t coordinate : lower) key = key << 21 | static_cast<std::uint64_t>(coordinate >> block_root());
  return key;
}

const Block* Octree::block_at(const LatticePoint& lower) const {
  if (*std::min_element(lower.begin(), lower.end()) < 0) return nullptr;
  const std::uint64_t key = block_key(lower);
  const auto found = std::lower_bound(block_keys_.begin(), block_keys_.end(), key);
  if (found == block_keys_.end() || *found != key) return nullptr;
  return &blocks_[block_order_[static_cast<std::size_t>(found - block_keys_.begin())]];
}

std::array<const Block*, 8> Octree::lower_neighbours(const Block& block) const {
  const int side = 1 << block_root();
  std::array<const Block*, 8> neighbours{};
  for (unsigned which = 0; which < 8; ++which)
    neighbours[which] = block_at(moved(block.lower, (which & 1U) != 0 ? -side : 0, (which & 2U) != 0 ? -side : 0,
                                       (which & 4U) != 0 ? -side : 0));
  return neighbours;
}

CellFound Octree::find(const LatticePoint& lower, int level) const {
  CellFound found;
  found.level = lattice_.voxel_level();
  found.block = block_at(lower);
  if (found.block == nullptr) return found;
  const Block& block = *found.block;
  const auto within = [&](std::size_t axis) { return (lower[axis] - block.lower[axis]) >> lattice_.voxel_level(); };
  const std::size_t cell = Block::cell(within(0), within(1), within(2));
  std::uint32_t leaf = block.leaf_at(cell) == Block::no_leaf ? Division::none : block.leaf_at(cell);
  std::uint32_t next = block.division_at(cell);
  while (next != Division::none && found.level > level) {
    const Division& division = block.divisions[next];
    unsigned child = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
      child |= static_cast<unsigned>((lower[axis] - division.lower[axis]) >> division.level) << axis;
    if (leaf == Division::none) leaf = division.leafs[child];
    next = division.parts[child];
    found.level = division.level;
  }
  found.divided = next != Division::none;
  if (leaf != Division::none) found.leaf = block.first_leaf + leaf;
  return found;
}

}  // namespace fieldfab::contouring

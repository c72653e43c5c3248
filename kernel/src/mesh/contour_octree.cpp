#include "contour_octree.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "contour_block.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"

namespace fieldfab::contouring {
namespace {

constexpr std::size_t bytes_a_block = 8192;  // a typical Block with its crossings, leafs, records and triangles

std::uint64_t block_key(const LatticePoint& lower) {
  std::uint64_t key = 0;
  for (const std::int32_t coordinate : lower) key = key << 21 | static_cast<std::uint64_t>(coordinate >> block_level);
  return key;
}

LatticePoint child_of(const LatticePoint& lower, unsigned child, int child_level) {
  return {lower[0] + (static_cast<int>(child & 1U) << child_level), lower[1] + (static_cast<int>(child >> 1 & 1U) << child_level),
          lower[2] + (static_cast<int>(child >> 2) << child_level)};
}

}  // namespace

/// A cube at or above block level.
struct Octree::Node {
  LatticePoint lower;
  int level;
  FieldPtr field;                   ///< the solid in this cube, while it is still to be subdivided or sampled
  std::int32_t children = -1;       ///< index of the first of eight
  std::int32_t block = -1;          ///< index among blocks_
  std::optional<Patch> patch = {};  ///< known where the cube is uniform or one patch
};

Octree::Octree(const Field& solid, const Lattice& lattice, const ContourSettings& settings, Progress& progress) {
  subdivide(solid, lattice, progress);
  sample_blocks(lattice, settings, progress);
  merge_blocks(lattice, settings.max_error);
  number_leafs();
}

Octree::~Octree() = default;

void Octree::subdivide(const Field& solid, const Lattice& lattice, Progress& progress) {
  nodes_.push_back({{0, 0, 0}, lattice.root_level(), solid.shared_from_this()});
  settle({&nodes_[0], 1}, lattice);
  for (std::size_t first = 0, last = 1; first < last; first = last, last = nodes_.size()) {
    const int level = nodes_[first].level;
    progress.report(0.0, "searching for the surface");
    if (first > 0)
      parallel_for((last - first) / 8, [&](std::size_t i) {
        progress.check();
        settle({&nodes_[first + 8 * i], 8}, lattice);
      });

    const auto open = static_cast<std::size_t>(std::count_if(nodes_.begin() + static_cast<std::ptrdiff_t>(first), nodes_.end(),
                                                             [](const Node& node) { return !node.patch; }));
    // A surface quarters its cells with each level; so this is what is to come, and no guess that a thin shape could exceed.
    const double blocks = static_cast<double>(open) * std::pow(4.0, level - block_level);
    if (open > 4096) require_memory(static_cast<std::uintmax_t>(blocks / 4) * bytes_a_block, "a mesh this fine");
    if (level == block_level) return;
    for (std::size_t i = first; i < last; ++i) {
      if (i % 4096 == 0) progress.check();
      if (nodes_[i].patch) continue;
      nodes_[i].children = static_cast<std::int32_t>(nodes_.size());
      for (unsigned child = 0; child < 8; ++child)
        nodes_.push_back({child_of(nodes_[i].lower, child, level - 1), level - 1, nodes_[i].field});
      nodes_[i].field.reset();
    }
  }
}

/// Restricts siblings, whose Field still is their parent's, to their own cubes; those that the surface misses are done with.
void Octree::settle(std::span<Node> siblings, const Lattice& lattice) {
  std::array<Box, 8> cube;
  std::array<Restriction, 8> here;
  for (std::size_t i = 0; i < siblings.size(); ++i) cube[i] = lattice.cube(siblings[i].lower, siblings[i].level);
  const FieldPtr parent = siblings[0].field;
  parent->restrict_all({cube.data(), siblings.size()}, Purpose::value, here);
  for (std::size_t i = 0; i < siblings.size(); ++i) {
    siblings[i].field = here[i].range.decided() ? nullptr : std::move(here[i].field);
    if (here[i].range.decided()) siblings[i].patch = Patch{static_cast<std::uint8_t>(here[i].range.inside() ? 255 : 0), {}};
  }
}

void Octree::sample_blocks(const Lattice& lattice, const ContourSettings& settings, Progress& progress) {
  std::vector<Node*> open;
  for (Node& node : nodes_)
    if (node.level == block_level && !node.patch) open.push_back(&node);
  std::vector<Block> sampled(open.size());
  std::atomic<std::size_t> done{0};
  parallel_for(open.size(), [&](std::size_t i) {
    progress.check();
    open[i]->patch = sample_block(*open[i]->field, lattice, open[i]->lower, settings, sampled[i]);
    open[i]->field.reset();
    if (const std::size_t count = ++done; count % 256 == 0)
      progress.report(0.8 * static_cast<double>(count) / static_cast<double>(open.size()), "sampling");
  });
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (open[i]->patch && open[i]->patch->uniform()) continue;
    open[i]->block = static_cast<std::int32_t>(blocks_.size());
    blocks_.push_back(std::move(sampled[i]));
  }
}

void Octree::merge_blocks(const Lattice& lattice, double max_error) {
  // Children come after their parents, so that going backwards meets them first.
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    Node& node = nodes_[i];
    if (node.children < 0) continue;
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
    if (!all) continue;
    if (any == 0 || every == 255) {
      node.patch = Patch{static_cast<std::uint8_t>(any), {}};
      continue;
    }
    Patch merged;
    std::size_t count = 0;
    for (std::size_t child = 0; child < 8; ++child) count += nodes_[first + child].patch->points.size();
    merged.points.reserve(count);
    if (max_error <= 0 || !merge_corners(corners, merged.corners)) continue;
    for (std::size_t child = 0; child < 8; ++child) {
      const auto& points = nodes_[first + child].patch->points;
      merged.points.insert(merged.points.end(), points.begin(), points.end());
    }
    const Box cell = lattice.cube(node.lower, node.level);
    if (is_flat(merged.points, max_error, merged.vertex))
      thin(merged.points, cell);
    else if (!reproduces(merged.points, cell, max_error, merged.vertex))
      continue;
    for (std::size_t child = 0; child < 8; ++child) nodes_[first + child].patch->points = {};
    node.patch = std::move(merged);
  }

  // What is one patch, and not part of a larger one, is a leaf; the blocks below it learn of it.
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> leaf_of_node(nodes_.size(), none);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    Node& node = nodes_[i];
    if (leaf_of_node[i] == none && node.patch && !node.patch->uniform()) {
      leaf_of_node[i] = static_cast<std::int32_t>(leafs_.size());
      leafs_.push_back({node.lower, node.level, node.patch->corners, node.patch->vertex});
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
  nodes_ = {};
}

void Octree::number_leafs() {
  for (Block& block : blocks_) {
    if (block.leafs.empty()) continue;  // part of a leaf that merge_blocks() made
    block.first_leaf = static_cast<std::uint32_t>(leafs_.size());
    leafs_.insert(leafs_.end(), block.leafs.begin(), block.leafs.end());
    block.leafs = {};
  }
  block_order_.resize(blocks_.size());
  std::iota(block_order_.begin(), block_order_.end(), 0U);
  std::sort(block_order_.begin(), block_order_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return block_key(blocks_[a].lower) < block_key(blocks_[b].lower); });
  block_keys_.reserve(blocks_.size());
  for (const std::uint32_t block : block_order_) block_keys_.push_back(block_key(blocks_[block].lower));
}

std::array<const Block*, 8> Octree::lower_neighbours(const Block& block) const {
  std::array<const Block*, 8> neighbours{};
  for (unsigned which = 0; which < 8; ++which) {
    LatticePoint lower = block.lower;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (which >> axis & 1U) lower[axis] -= block_side;
    if (*std::min_element(lower.begin(), lower.end()) < 0) continue;
    const std::uint64_t key = block_key(lower);
    const auto found = std::lower_bound(block_keys_.begin(), block_keys_.end(), key);
    if (found != block_keys_.end() && *found == key)
      neighbours[which] = &blocks_[block_order_[static_cast<std::size_t>(found - block_keys_.begin())]];
  }
  return neighbours;
}

}  // namespace fieldfab::contouring

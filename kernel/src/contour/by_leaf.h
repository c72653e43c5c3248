/// Items of leafs, such as points and curves on their faces, brought together by leaf on several threads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fieldfab/core/parallel.h"

namespace fieldfab::contouring {

/// So many consecutive leafs are a run, which one thread treats.
inline constexpr std::size_t leafs_a_run = 1024;

inline std::size_t runs_of(std::size_t leafs) { return (leafs + leafs_a_run - 1) / leafs_a_run; }

/// Brings items together by their member `leaf`, which is less than `leafs`, in one counting sort by runs and another
/// within each run. Items of a leaf stay in the order of their sources.
///
/// `list(source, add)` calls add(item) for each item of a source, the same ones whenever it is called: twice, the first
/// time to count them. Then `treat(run, start, items)` is called for each run: the items of the run's leaf i are
/// items[start[i]] to items[start[i + 1]]. Both are called on several threads.
template <class Item, class List, class Treat>
void treat_by_leaf(std::size_t leafs, std::size_t sources, const List& list, const Treat& treat) {
  const std::size_t runs = runs_of(leafs), parts = std::min<std::size_t>(sources, 128);
  const auto each_item = [&](std::size_t part, const auto& add) {
    for (std::size_t i = part * sources / parts; i < (part + 1) * sources / parts; ++i) list(i, add);
  };
  std::vector<std::size_t> next(parts * runs, 0);  // by part and run: first the number of items, then the next's place
  parallel_for(parts, [&](std::size_t part) {
    each_item(part, [&](const Item& item) { ++next[part * runs + item.leaf / leafs_a_run]; });
  });
  std::vector<std::size_t> first(runs + 1, 0);
  std::size_t count = 0;
  for (std::size_t run = 0; run < runs; ++run) {
    first[run] = count;
    for (std::size_t part = 0; part < parts; ++part) {
      std::size_t& here = next[part * runs + run];
      count += here;
      here = count - here;
    }
  }
  first[runs] = count;
  const auto by_run = std::make_unique_for_overwrite<Item[]>(count);
  parallel_for(parts, [&](std::size_t part) {
    each_item(part, [&](const Item& item) { by_run[next[part * runs + item.leaf / leafs_a_run]++] = item; });
  });
  parallel_for(runs, [&](std::size_t run) {
    const std::span<const Item> found(by_run.get() + first[run], first[run + 1] - first[run]);
    std::vector<std::uint32_t> start(std::min(leafs_a_run, leafs - run * leafs_a_run) + 1, 0);
    for (const Item& item : found) ++start[item.leaf % leafs_a_run + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<Item> items(found.size());
    std::vector<std::uint32_t> place(start.begin(), start.end() - 1);
    for (const Item& item : found) items[place[item.leaf % leafs_a_run]++] = item;
    treat(run, std::span<const std::uint32_t>(start), std::span<Item>(items));
  });
}

}  // namespace fieldfab::contouring

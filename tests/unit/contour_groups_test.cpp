// Sets of cells and items brought together by leaf, against obvious twins.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <random>
#include <set>

#include "contour/by_leaf.h"
#include "contour/cell_set.h"

namespace fieldfab::contouring {
namespace {

class Boxes : public ::testing::Test {
 protected:
  std::pair<Cell, Cell> box(int reach) {
    std::uniform_int_distribution<std::int64_t> place(-40, 40), size(0, reach);
    Cell lower, upper;
    for (std::size_t i = 0; i < 3; ++i) lower[i] = place(random_), upper[i] = lower[i] + size(random_);
    return {lower, upper};
  }
  template <class Visit>
  static void each(const Cell& lower, const Cell& upper, const Visit& visit) {
    for (std::int64_t x = lower[0]; x <= upper[0]; ++x)
      for (std::int64_t y = lower[1]; y <= upper[1]; ++y)
        for (std::int64_t z = lower[2]; z <= upper[2]; ++z) visit(Cell{x, y, z});
  }
  std::mt19937 random_{7};
};

TEST_F(Boxes, CellsHaveEachItsNumber) {
  for (int run = 0; run < 20; ++run) {
    CellSet some, others;
    std::set<Cell> twin;
    for (int i = 0; i < 8; ++i) {
      const auto [lower, upper] = box(i % 2 == 0 ? 30 : 2);
      (i < 4 ? some : others).add(lower, upper);
      each(lower, upper, [&](const Cell& cell) { twin.insert(cell); });
    }
    some.add(others);
    ASSERT_EQ(some.number(), twin.size());
    std::map<Cell, std::uint32_t> number;
    std::set<std::uint32_t> numbers;
    for (const Cell& cell : twin)
      some.for_numbers(cell, cell, [&](std::uint32_t found) { return numbers.insert(number[cell] = found), true; });
    EXPECT_EQ(numbers.size(), twin.size());
    EXPECT_EQ(*numbers.rbegin(), twin.size() - 1);
    for (int i = 0; i < 20; ++i) {
      const auto [lower, upper] = box(12);
      std::multiset<std::uint32_t> found, expected;
      EXPECT_TRUE(some.for_numbers(lower, upper, [&](std::uint32_t here) { return found.insert(here), true; }));
      each(lower, upper,
           [&](const Cell& cell) { expected.insert(twin.contains(cell) ? number.at(cell) : CellSet::none); });
      EXPECT_EQ(found, expected);
    }
  }
}

TEST_F(Boxes, ASearchOfCellsEndsWhereItIsTold) {
  CellSet cells;
  cells.add({-1, -1, -1}, {1, 1, 1});
  ASSERT_EQ(cells.number(), 27U);
  int calls = 0;
  EXPECT_FALSE(cells.for_numbers({-9, -9, -9}, {9, 9, 9}, [&](std::uint32_t) { return ++calls < 5; }));
  EXPECT_EQ(calls, 5);
}

struct Item {
  std::uint32_t leaf, number;
  bool operator==(const Item&) const = default;
};

TEST(ByLeaf, ItemsComeTogetherInTheOrderOfTheirSources) {
  std::mt19937 random(3);
  for (const std::size_t leafs : {std::size_t{1}, std::size_t{1023}, std::size_t{1024}, std::size_t{5000}}) {
    std::vector<std::vector<Item>> sources(300);
    std::uniform_int_distribution<std::uint32_t> leaf(0, static_cast<std::uint32_t>(leafs - 1)), many(0, 40);
    std::vector<Item> expected;
    for (auto& source : sources)
      for (std::uint32_t i = many(random); i > 0; --i) {
        source.push_back({leaf(random), static_cast<std::uint32_t>(expected.size())});
        expected.push_back(source.back());
      }
    std::stable_sort(expected.begin(), expected.end(), [](const Item& a, const Item& b) { return a.leaf < b.leaf; });
    std::vector<std::vector<Item>> found(runs_of(leafs));
    std::mutex lock;
    std::size_t starts = 0;
    treat_by_leaf<Item>(
        leafs, sources.size(),
        [&](std::size_t i, const auto& add) { std::for_each(sources[i].begin(), sources[i].end(), add); },
        [&](std::size_t run, std::span<const std::uint32_t> start, std::span<Item> items) {
          for (std::uint32_t i = 0; i + 1 < start.size(); ++i)
            for (std::uint32_t k = start[i]; k < start[i + 1]; ++k) EXPECT_EQ(items[k].leaf, run * leafs_a_run + i);
          found[run].assign(items.begin(), items.end());
          const std::lock_guard guard(lock);
          starts += start.size() - 1;
        });
    EXPECT_EQ(starts, leafs);
    std::vector<Item> all;
    for (const auto& run : found) all.insert(all.end(), run.begin(), run.end());
    EXPECT_EQ(all, expected);
  }
}

TEST(ByLeaf, NothingIsTreatedWithoutLeafs) {
  treat_by_leaf<Item>(
      0, 0, [](std::size_t, const auto&) { FAIL(); },
      [](std::size_t, std::span<const std::uint32_t>, std::span<Item>) { FAIL(); });
}

}  // namespace
}  // namespace fieldfab::contouring

// The graph of stages, and chains through it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>

#include "fieldfab/core/error.h"
#include "stages.h"

namespace fieldfab::cam {

const char* name_of(Kind kind) {
  constexpr const char* names[] = {"solid", "image", "bitmap", "outline", "surface", "paths"};
  return names[static_cast<std::size_t>(kind)];
}

const std::vector<Stage>& stages() {
  static const std::vector<Stage> all = [] {
    std::vector<Stage> table;
    for (auto make : {conversion_stages, flat_stages, surface_stages})
      for (Stage& stage : make()) table.push_back(std::move(stage));
    return table;
  }();
  return all;
}

const Stage& operation(const std::string& name, const std::string& place) {
  std::vector<std::string> names;
  for (const Stage& stage : stages()) {
    if (!stage.operation) continue;
    if (stage.name == name) return stage;
    names.push_back(stage.name);
  }
  throw Error(
      ErrorKind::bad_input, place,
      fmt::format("there is no operation '{}'{} Known are {}", name, suggestion(name, names), fmt::join(names, ", ")));
}

std::vector<const Stage*> chain(Kind from, const Stage& operation) {
  // Breadth-first search over the kinds of artifacts.
  std::map<Kind, const Stage*> came_by;
  std::deque<Kind> waiting{from};
  came_by[from] = nullptr;
  while (!waiting.empty()) {
    const Kind here = waiting.front();
    waiting.pop_front();
    for (const Stage& stage : stages())
      if (!stage.operation && stage.takes == here && !came_by.contains(stage.makes))
        came_by[stage.makes] = &stage, waiting.push_back(stage.makes);
  }
  if (!came_by.contains(operation.takes))
    throw Error(ErrorKind::bad_input, operation.name,
                fmt::format("works on: {}; no stage leads there from: {}", name_of(operation.takes), name_of(from)));
  std::vector<const Stage*> found{&operation};
  for (Kind kind = operation.takes; came_by[kind] != nullptr; kind = came_by[kind]->takes)
    found.push_back(came_by[kind]);
  std::reverse(found.begin(), found.end());
  return found;
}

}  // namespace fieldfab::cam

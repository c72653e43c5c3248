// Measures the scaling of f-reps' cost (Keeter 3.9, Figs 3-4 and 3-7 to 3-9) and writes CSV files
// into the given folder; tests/bench/plot_figures.py draws them. One thread; the best of several
// runs, because machines are shared.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>

#include "fieldfab/contour/contour.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/render/render.h"

namespace {

using namespace fieldfab;

/// Time of the fastest of several runs, seconds.
template <class Work>
double seconds(int runs, const Work& work) {
  double best = 1e9;
  while (runs-- > 0) {
    const auto started = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
  }
  return best;
}

FieldPtr vm(const char* name) {
  return frep::make_field(frep::simplify(frep::parse_vm(read_file(std::string(TEST_DATA "/frep/") + name))));
}

/// Lines of different text, forty characters each.
frep::Expression lines(int count) {
  std::string words;
  for (int line = 0; line < count; ++line) {
    for (int i = 0; i < 40; ++i) words += static_cast<char>('A' + (7 * i + 13 * line + i * line) % 26);
    words += '\n';
  }
  return frep::shapes::text(words, 6, 1);
}

/// Mean number of active nodes in boxes that the boundary crosses, by level.
void count_nodes(std::ofstream& file, const FieldPtr& root, const Box& square, int levels) {
  std::vector<std::pair<FieldPtr, Box>> open{{root, square}};
  for (int level = 0; level <= levels; ++level) {
    std::vector<std::pair<FieldPtr, Box>> next;
    double nodes = 0;
    std::size_t crossed = 0;
    for (const auto& [field, box] : open) {
      const Restriction here = field->restricted(box, Purpose::occupancy);
      if (here.range.decided()) continue;
      nodes += static_cast<double>(frep::active_nodes(*here.field));
      ++crossed;
      for (unsigned child = 0; child < 4; ++child) {
        Box part = box;
        for (int axis = 0; axis < 2; ++axis)
          ((child >> axis & 1U) != 0 ? part.lower : part.upper)[axis] = box.centre()[axis];
        next.emplace_back(here.field, part);
      }
    }
    file << fmt::format("{},{},{}\n", level, crossed, nodes / static_cast<double>(std::max<std::size_t>(crossed, 1)));
    open = std::move(next);
  }
}

}  // namespace

int main(int count, char** arguments) {
  const std::string folder = count > 1 ? arguments[1] : ".";
  const ThreadLimit one(1);
  const Box square{{-1, -1, 0}, {1, 1, 0}}, cube{Vec3::Constant(-2.5), Vec3::Constant(2.5)};
  const FieldPtr prospero = vm("prospero.vm"), tanglecube = vm("tanglecube.vm");

  std::ofstream resolution(folder + "/cost_resolution.csv");
  resolution << "what,resolution,seconds\n";
  for (const int n : {128, 256, 512, 1024, 2048, 4096})
    resolution << fmt::format("prospero bitmap,{},{}\n", n, seconds(5, [&] {
                                render(*prospero, square, {RenderMode::bitmap, n});
                              }));
  for (const int n : {64, 128, 256, 512})
    resolution << fmt::format("tanglecube height map,{},{}\n", n, seconds(3, [&] {
                                render(*tanglecube, cube, {RenderMode::height, n});
                              }));
  for (const int n : {32, 64, 128, 256})
    resolution << fmt::format("tanglecube mesh,{},{}\n", n, seconds(3, [&] { contour(*tanglecube, cube, {5.0 / n}); }));

  std::ofstream size(folder + "/cost_size.csv");
  size << "lines,nodes,seconds\n";
  for (const int n : {1, 3, 10, 30, 100, 300, 1000}) {
    const frep::Expression text = lines(n);
    const FieldPtr field = frep::make_field(text);
    const Box page{{0, -11.0 * n, 0}, {240, 8, 0}};
    size << fmt::format("{},{},{}\n", n, frep::node_count(text), seconds(3, [&] {
                          render(*field, page, {RenderMode::bitmap, 1024});
                        }));
  }

  std::ofstream active(folder + "/active_nodes.csv");
  active << "level,boxes,nodes\n";
  count_nodes(active, prospero, square, 9);
  return 0;
}

#include "sharpen.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_set>

#include "fieldfab/core/parallel.h"
#include "mender.h"

namespace fieldfab::contouring {
namespace {

// Space is divided into areas, cubes of cells of the editor. The flaws of one area are mended one after the other, in
// the area with a margin of half its side. Areas that are even or odd along the same axes are two sides apart, so that
// their margins do not meet, and are mended at the same time.
constexpr double cell_side = 4;              // in voxels
constexpr std::int64_t smallest_area = 4;    // in cells; for a large expression, restriction takes most of the time
constexpr std::int64_t larger = 4;           // times; where triangles are too long for a small area
constexpr std::int64_t largest_area = 4096;  // longer triangles are left to the end, to one thread
constexpr std::size_t kinds_of_area = 8;

/// The area of a flaw: first whether it is odd along each axis, then its place.
using Area = std::array<std::int64_t, 4>;

Area area_of(const Cell& cell, std::int64_t side) {
  Area area{};
  for (std::size_t i = 0; i < 3; ++i) {
    area[i + 1] = cell[i] / side - (cell[i] % side < 0 ? 1 : 0);
    area[0] |= (area[i + 1] & 1) << i;
  }
  return area;
}

MeshEditor::Region region_of(const Area& area, std::int64_t side) {
  MeshEditor::Region region;
  for (std::size_t i = 0; i < 3; ++i) {
    region.lower[i] = area[i + 1] * side - side / 2;
    region.upper[i] = (area[i + 1] + 1) * side + side / 2;
  }
  return region;
}

class Sharpener {
 public:
  Sharpener(const Field& solid, double voxel, double tolerance, std::span<const std::uint32_t> creased,
            TriangleMesh& mesh, Progress& progress)
      : progress_(progress),
        editor_(mesh, creased, cell_side * voxel, 3 * voxel),
        draft_{solid, static_cast<float>(voxel), static_cast<float>(tolerance), mesh, editor_, true, {}},
        open_(creased.begin(), creased.end()) {}

  void run() {
    constexpr int rounds = 6;
    for (int round = 0; round < rounds && !open_.empty(); ++round) {
      if (round == rounds / 2) {
        draft_.features_only = false;
        tried_.clear();
        examined_.clear();
      }
      examined_.resize(draft_.mesh.triangles.size(), 0);
      if (round > 0) open_around();
      std::vector<Flaw> flaws = find_flaws();
      open_.clear();
      done_ = 0;
      for (auto first = flaws.begin(); first != flaws.end();) {
        const auto last =
            std::find_if(first, flaws.end(), [&](const Flaw& flaw) { return flaw.count != first->count; });
        mend({first, last}, [&] {
          progress_.report(
              0.95 + 0.05 * (round + static_cast<double>(done_) / static_cast<double>(flaws.size())) / rounds,
              "sharpening edges");
          progress_.check();
        });
        first = last;
      }
    }
    editor_.finish();
  }

 private:
  /// Opens the triangles beside those that have changed, unless they were examined.
  void open_around() {
    for (const std::uint32_t t : open_) examined_[t] = 0;
    std::vector<std::uint32_t> around;
    for (const std::uint32_t t : open_)
      for (const std::uint32_t vertex : draft_.mesh.triangles[t])
        for (const std::uint32_t beside : editor_.fan(vertex))
          if (examined_[beside] == 0) around.push_back(beside);
    open_ = std::move(around);
  }

  /// Returns the vertices, edges and triangles of the open triangles that are off by more than the
  /// tolerance: vertices first, then edges, then triangles; the largest error first.
  std::vector<Flaw> find_flaws() {
    if (kept_cost_ >= most_kept) kept_.clear(), kept_cost_ = 0;
    std::vector<Flaw> places = open_places();
    std::erase_if(places, [&](const Flaw& flaw) { return tried_.contains(key_of(flaw)); });
    measure(places);
    std::erase_if(places, [&](const Flaw& flaw) { return flaw.error <= draft_.tolerance; });
    std::sort(places.begin(), places.end(), [](const Flaw& one, const Flaw& other) {
      if (one.count != other.count) return one.count < other.count;
      if (one.error != other.error) return one.error > other.error;
      return std::tie(one.cell, one.vertices) < std::tie(other.cell, other.vertices);
    });
    draft_.moved.assign(draft_.mesh.vertices.size(), 0);
    return places;
  }

  /// The vertices, edges and triangles of the open triangles with a vertex whose triangles are known, each once, and
  /// close to each other in space.
  std::vector<Flaw> open_places() {
    open_ = sorted_once(open_, draft_.mesh.triangles.size());
    std::vector<std::uint32_t> vertices;
    vertices.reserve(3 * open_.size());
    for (const std::uint32_t t : open_) {
      examined_[t] = 1;
      const Triangle& v = draft_.mesh.triangles[t];
      vertices.insert(vertices.end(), v.begin(), v.end());
    }
    vertices = sorted_once(vertices, draft_.mesh.vertices.size());
    const std::vector<std::array<std::uint32_t, 2>> edges = edges_of_open();
    std::vector<Flaw> places;
    places.reserve(vertices.size() + edges.size() + open_.size());
    const auto add = [&](const Triangle& corners, int count) {
      if (std::all_of(corners.begin(), corners.begin() + count,
                      [&](std::uint32_t vertex) { return editor_.fan(vertex).empty(); }))
        return;
      Flaw place{corners, count, 0, {}};
      const Eigen::Vector3f middle = draft_.middle(place);
      place.cell = editor_.cell_of({middle.x(), middle.y(), middle.z()});
      places.push_back(place);
    };
    for (const std::uint32_t vertex : vertices) add({vertex, 0, 0}, 1);
    for (const auto& [from, to] : edges) add({from, to, 0}, 2);
    for (const std::uint32_t t : open_) add(draft_.mesh.triangles[t], 3);

    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(places.size());
    for (std::uint32_t i = 0; i < places.size(); ++i) order[i] = {near_key(places[i].cell), i};
    std::sort(order.begin(), order.end());
    std::vector<Flaw> ordered;
    ordered.reserve(places.size());
    for (const auto& [key, i] : order) ordered.push_back(places[i]);
    return ordered;
  }

  /// Returns numbers below `end`, in order and each once.
  static std::vector<std::uint32_t> sorted_once(const std::vector<std::uint32_t>& numbers, std::size_t end) {
    std::vector<std::uint64_t> there(end / 64 + 1, 0);
    for (const std::uint32_t number : numbers) there[number / 64] |= std::uint64_t{1} << number % 64;
    std::vector<std::uint32_t> sorted;
    sorted.reserve(numbers.size());
    for (std::size_t word = 0; word < there.size(); ++word)
      for (std::uint64_t left = there[word]; left != 0; left &= left - 1)
        sorted.push_back(static_cast<std::uint32_t>(64 * word) + static_cast<std::uint32_t>(std::countr_zero(left)));
    return sorted;
  }

  /// The edges of the open triangles, each once: the lesser vertex first, sorted. A counting sort by that vertex, then
  /// the few edges of one among themselves.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> edges_of_open() const {
    std::vector<std::uint32_t> start(draft_.mesh.vertices.size() + 1, 0);
    const auto for_edges = [&](const auto& visit) {
      for (const std::uint32_t t : open_) {
        const Triangle& v = draft_.mesh.triangles[t];
        for (std::size_t i = 0; i < 3; ++i) visit(std::min(v[i], v[(i + 1) % 3]), std::max(v[i], v[(i + 1) % 3]));
      }
    };
    for_edges([&](std::uint32_t from, std::uint32_t) { ++start[from + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<std::uint32_t> other(start.back()), next(start.begin(), start.end() - 1);
    for_edges([&](std::uint32_t from, std::uint32_t to) { other[next[from]++] = to; });
    std::vector<std::array<std::uint32_t, 2>> edges;
    edges.reserve(other.size() / 2 + 1);
    for (std::uint32_t from = 0; from + 1 < start.size(); ++from) {
      const auto first = other.begin() + start[from], last = other.begin() + start[from + 1];
      std::sort(first, last);
      for (auto to = first; to != last; ++to)
        if (to == first || *to != *(to - 1)) edges.push_back({from, *to});
    }
    return edges;
  }

  /// Cells with keys close to each other are close to each other, in cubes of `smallest_area`. The key's last bits are
  /// those of the cell in its cube. Only few cells far from each other have the same key.
  static constexpr int bits_in_cube = 2;
  static_assert(smallest_area == 1 << bits_in_cube);
  static std::uint64_t near_key(const Cell& cell) {
    std::uint64_t key = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = static_cast<std::uint64_t>(cell[i]);
      key |= (at >> bits_in_cube & 0xffff) << (16 * i + 3 * bits_in_cube) | (at & (smallest_area - 1))
                                                                                << (bits_in_cube * i);
    }
    return key;
  }

  /// Measures how far places are off the surface; the solid is restricted to an area, then to neighbours in it.
  void measure(std::vector<Flaw>& places) {
    const auto cube_of = [&](std::size_t i) { return near_key(places[i].cell) >> (3 * bits_in_cube); };
    std::vector<std::size_t> cubes;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (i == 0 || cube_of(i) != cube_of(i - 1)) cubes.push_back(i);
    cubes.push_back(places.size());
    const auto area = [&](std::size_t cube) { return area_of(places[cubes[cube]].cell, smallest_area); };
    for (std::size_t cube = 0; cube + 1 < cubes.size(); ++cube) kept_[area(cube)];
    parallel_for(cubes.size() - 1, [&](std::size_t cube) {
      progress_.check();
      const std::span<Flaw> inside{places.data() + cubes[cube], places.data() + cubes[cube + 1]};
      Surroundings own;
      const Surroundings& surroundings =
          surroundings_of(&kept_.at(area(cube)), region_of(area(cube), smallest_area), own);
      const Box box = box_of(inside);
      const bool held = surroundings.box.contains(box.lower) && surroundings.box.contains(box.upper);
      const Field& solid = held ? *surroundings.field : draft_.solid;
      constexpr std::size_t neighbours = 64;
      std::vector<Box> boxes;
      const auto group = [&](std::size_t i) {
        return inside.subspan(i * neighbours, std::min(neighbours, inside.size() - i * neighbours));
      };
      for (std::size_t i = 0; i * neighbours < inside.size(); ++i) boxes.push_back(box_of(group(i)));
      std::vector<Restriction> here(boxes.size());
      solid.restrict_all(boxes, Purpose::occupancy, here);
      Samples samples;
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        samples.clear();
        for (const Flaw& place : group(i)) samples.add(draft_.middle(place));
        samples.ask(*here[i].field);
        std::size_t at = 0;
        for (Flaw& place : group(i)) place.error = std::abs(samples.distance(at++));
        here[i] = {};
      }
    });
  }

  [[nodiscard]] Box box_of(std::span<const Flaw> places) const {
    const Vec3 first = draft_.middle(places.front()).cast<double>();
    Box box{first, first};
    for (const Flaw& place : places) {
      const Vec3 middle = draft_.middle(place).cast<double>();
      box = {box.lower.cwiseMin(middle), box.upper.cwiseMax(middle)};
    }
    return box;
  }

  static std::uint64_t key_of(const Flaw& flaw) {
    std::uint64_t key = static_cast<std::uint64_t>(flaw.count);
    for (const std::uint32_t vertex : flaw.vertices) key = (key ^ vertex) * 0x9e3779b97f4a7c15U;
    return key;
  }

  /// Flaws of one area, in order.
  struct Task {
    MeshEditor::Region region;
    Surroundings* kept;  ///< null: not kept
    std::vector<const Flaw*> flaws;
    std::vector<char> tried;          ///< by flaw
    std::vector<std::uint32_t> made;  ///< triangles
  };

  /// Mends flaws of one kind in the smallest areas that hold the triangles around them.
  template <class Report>
  void mend(std::span<const Flaw> flaws, const Report& report) {
    std::vector<const Flaw*> left;
    for (const Flaw& flaw : flaws) left.push_back(&flaw);
    for (std::int64_t side = smallest_area; side <= largest_area && !left.empty(); side *= larger) {
      std::map<Area, std::vector<const Flaw*>> areas;
      for (const Flaw* flaw : left) areas[area_of(flaw->cell, side)].push_back(flaw);
      left.clear();
      auto area = areas.begin();
      for (std::size_t kind = 0; kind < kinds_of_area; ++kind) {
        std::vector<Task> tasks;
        for (; area != areas.end() && static_cast<std::size_t>(area->first[0]) == kind; ++area) {
          Task task{region_of(area->first, side), side == smallest_area ? &kept_[area->first] : nullptr, {}, {}, {}};
          for (const Flaw* flaw : area->second) (holds(task.region, *flaw) ? task.flaws : left).push_back(flaw);
          if (!task.flaws.empty()) tasks.push_back(std::move(task));
        }
        carry_out(tasks, report);
      }
    }
    if (left.empty()) return;
    std::vector<Task> last(1);
    Surroundings everything{Box::everything(), RestrictedField(draft_.solid), {}};
    last[0] = {MeshEditor::everything(), &everything, std::move(left), {}, {}};
    carry_out(last, report);
    kept_cost_ -= everything.counted;
  }

  /// Whether the known triangles around a flaw lie in a region.
  [[nodiscard]] bool holds(const MeshEditor::Region& region, const Flaw& flaw) const {
    return std::all_of(flaw.vertices.begin(), flaw.vertices.begin() + flaw.count,
                       [&](std::uint32_t vertex) { return editor_.holds_fan(region, vertex); });
  }

  /// Carries out tasks whose regions have no cell in common.
  template <class Report>
  void carry_out(std::vector<Task>& tasks, const Report& report) {
    for (Task& task : tasks) editor_.supply(task.region, task.flaws.front()->count > 1 ? task.flaws.size() : 0);
    draft_.moved.resize(draft_.mesh.vertices.size(), 0);
    parallel_for(tasks.size(), [&](std::size_t i) {
      Task& task = tasks[i];
      Surroundings own;
      Surroundings& surroundings = surroundings_of(task.kept, task.region, own);
      Mender mender(draft_, task.region, surroundings);
      for (const Flaw* flaw : task.flaws) {
        if (done_++ % 16 == 0) report();
        task.tried.push_back(mender.mend(*flaw) ? 1 : 0);
      }
      task.made = std::move(mender.made);
      if (&surroundings == task.kept) count_kept(surroundings);
    });
    for (Task& task : tasks) {
      editor_.take_back(task.region);
      open_.insert(open_.end(), task.made.begin(), task.made.end());
      for (std::size_t i = 0; i < task.flaws.size(); ++i)
        if (task.tried[i] != 0) tried_.insert(key_of(*task.flaws[i]));
    }
  }

  /// Returns the surroundings of a region: those that are kept for it, or `own` if there is no place for more.
  Surroundings& surroundings_of(Surroundings* kept, const MeshEditor::Region& region, Surroundings& own) {
    const bool keeps = kept != nullptr && (kept->field || kept_cost_ < most_kept);
    Surroundings& surroundings = keeps ? *kept : own;
    if (surroundings.field) return surroundings;
    surroundings.box = editor_.extent(region);
    surroundings.field = draft_.solid.restricted(surroundings.box, Purpose::occupancy).field;
    if (keeps) count_kept(surroundings);
    return surroundings;
  }
  void count_kept(Surroundings& surroundings) {
    if (kept_cost_ >= most_kept) surroundings.blocks.clear();
    const std::size_t cost = surroundings.cost();
    kept_cost_ += cost - surroundings.counted;
    surroundings.counted = cost;
  }

  Progress& progress_;
  MeshEditor editor_;
  Draft draft_;
  std::vector<std::uint32_t> open_;                    ///< triangles still to be examined
  std::vector<char> examined_;                         ///< by triangle: whether it was, since it was made
  std::unordered_set<std::uint64_t> tried_;            ///< flaws, so that none is tried forever
  static constexpr std::size_t most_kept = 4'000'000;  ///< operations, of 16 bytes and their Fields
  std::map<Area, Surroundings> kept_;                  ///< by smallest area
  std::atomic<std::size_t> kept_cost_ = 0;
  std::atomic<std::size_t> done_ = 0;  ///< flaws of this round
};

}  // namespace

void sharpen(const Field& solid, double voxel, double tolerance, std::span<const std::uint32_t> creased,
             TriangleMesh& mesh, Progress& progress) {
  if (!creased.empty()) Sharpener(solid, voxel, tolerance, creased, mesh, progress).run();
}

}  // namespace fieldfab::contouring

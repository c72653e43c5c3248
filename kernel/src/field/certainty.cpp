#include "fieldfab/field/certainty.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>

#include "fieldfab/core/disjoint_sets.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/surface_proof.h"

namespace fieldfab {

std::string Certainty::text() const {
  if (certain()) return "certain";
  const char* why = "";
  switch (doubt) {
    case Doubt::none: break;
    case Doubt::not_looked: return "not certain, since it was not looked whether anything is missing";
    case Doubt::finest_size: why = "the smallest cells"; break;
    case Doubt::not_proved:
      why = "nothing is seen to be missing, but its slopes there are too roughly known for a proof";
      break;
    case Doubt::too_many: why = "the limit of divided cells was reached"; break;
    case Doubt::slopes_unknown: why = "this kind of solid does not tell its slopes"; break;
  }
  const char* const places_in_words = count == 1 ? "place" : "places";
  constexpr double most_triangles = 1e9;  // more than anyone wants
  if (!(wanted_voxel > 0) || wanted_triangles > most_triangles)
    return fmt::format(
        "not certain at {} {}, the largest {:.3g} mm: parts thinner than {:.3g} mm may be missing there ({})", count,
        places_in_words, largest, thickness, why);
  return fmt::format(
      "not certain at {} {}, the largest {:.3g} mm: parts thinner than {:.3g} mm may be missing there ({}; cells of "
      "{:.2g} mm would show them, with some {:.2g} million triangles)",
      count, places_in_words, largest, thickness, why, wanted_voxel, std::max(0.01, 1e-6 * wanted_triangles));
}

void Certainty::add(const Certainty& other) {
  count += other.count;
  largest = std::max(largest, other.largest);
  thickness = std::max(thickness, other.thickness);
  places.insert(places.end(), other.places.begin(), other.places.end());
  if (places.size() > most_places) places.resize(most_places);
  doubt = std::max(doubt, other.doubt);
  finest = std::max(finest, other.finest);
  wanted_voxel = wanted_voxel > 0 && other.wanted_voxel > 0 ? std::min(wanted_voxel, other.wanted_voxel)
                                                            : std::max(wanted_voxel, other.wanted_voxel);
  wanted_triangles += other.wanted_triangles;
}

void Certainty::gather(std::span<const UncertainCell> cells) {
  if (cells.empty()) {
    doubt = Doubt::none;
    return;
  }
  std::map<std::array<std::int32_t, 3>, std::uint32_t> by_voxel;
  DisjointSets sets(cells.size());
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const auto [found, fresh] = by_voxel.emplace(cells[i].voxel, i);
    if (!fresh) sets.unite(found->second, i);
  }
  for (const auto& [voxel, i] : by_voxel)
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (const auto found = by_voxel.find({voxel[0] + x, voxel[1] + y, voxel[2] + z}); found != by_voxel.end())
            sets.unite(found->second, i);

  std::map<std::uint32_t, UncertainPlace> joined;
  for (std::uint32_t i = 0; i < cells.size(); ++i) {
    const auto [found, fresh] = joined.emplace(sets.find(i), UncertainPlace{cells[i].box, cells[i].side});
    found->second.box = hull(found->second.box, cells[i].box);
    found->second.thickness = std::max(found->second.thickness, cells[i].side);
  }
  count = joined.size();
  for (const auto& [root, place] : joined) places.push_back(place);
  const auto longest = [](const UncertainPlace& place) { return place.box.size().maxCoeff(); };
  std::stable_sort(places.begin(), places.end(),
                   [&](const UncertainPlace& a, const UncertainPlace& b) { return longest(a) > longest(b); });
  largest = longest(places.front());
  for (const UncertainPlace& place : places) thickness = std::max(thickness, place.thickness);
  if (places.size() > most_places) places.resize(most_places);
}

namespace {

/// A part of the lattice: cells from `first` on, `count` along each axis.
struct CellRange {
  std::array<std::int32_t, 3> first, count;
};

/// Looks for uncertain cells from the top down.
class CellInspector {
 public:
  CellInspector(const Box& region, const std::array<std::int32_t, 3>& counts, Progress& progress)
      : region_(region), progress_(progress) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      cell_[static_cast<Eigen::Index>(axis)] = region.size()[static_cast<Eigen::Index>(axis)] / counts[axis];
    side_ = cell_.maxCoeff();
  }

  void run(const Field& field, const CellRange& range) {
    progress_.check();
    const auto& n = range.count;
    if (*std::max_element(n.begin(), n.end()) <= task_side) {
      Task task;
      inspect(field, range, task);
      const std::lock_guard lock(collecting_);
      cells_.insert(cells_.end(), task.cells.begin(), task.cells.end());
      known_ = known_ || task.known;
      return;
    }
    const std::vector<CellRange> parts = halves(range);
    const std::vector<Restriction> here = restricted(field, parts);
    parallel_for(parts.size(), [&](std::size_t i) {
      if (!here[i].range.decided()) run(*here[i].field, parts[i]);
    });
  }

  [[nodiscard]] Certainty certainty() {
    std::sort(cells_.begin(), cells_.end(),
              [](const UncertainCell& a, const UncertainCell& b) { return a.voxel < b.voxel; });
    Certainty certainty;
    certainty.finest = side_;
    certainty.doubt = known_ ? Doubt::finest_size : Doubt::slopes_unknown;
    certainty.gather(cells_);
    return certainty;
  }

 private:
  static constexpr std::int32_t task_side = 32;  // cells a side that are one thread's work

  struct Task {
    std::vector<UncertainCell> cells;
    std::vector<Eigen::Vector3f> normals;
    std::size_t proved = 0;
    bool known = false;
  };

  [[nodiscard]] Box box(const CellRange& range) const {
    Box box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<Eigen::Index>(axis);
      box.lower[a] = region_.lower[a] + cell_[a] * range.first[axis];
      box.upper[a] = region_.lower[a] + cell_[a] * (range.first[axis] + range.count[axis]);
    }
    return box;
  }
  /// With a margin, except across a flat region.
  [[nodiscard]] Box looked_at(const CellRange& range) const {
    const Vec3 margin = sheet_overlap * cell_;
    const Box exact = box(range);
    return {exact.lower - margin, exact.upper + margin};
  }

  [[nodiscard]] static std::vector<CellRange> halves(const CellRange& range) {
    std::vector<CellRange> parts{range};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (range.count[axis] < 2) continue;
      const std::int32_t half = range.count[axis] / 2;
      for (std::size_t i = parts.size(); i-- > 0;) {
        CellRange upper = parts[i];
        upper.first[axis] += half;
        upper.count[axis] -= half;
        parts[i].count[axis] = half;
        parts.push_back(upper);
      }
    }
    return parts;
  }

  [[nodiscard]] std::vector<Restriction> restricted(const Field& field, const std::vector<CellRange>& parts) const {
    std::vector<Box> boxes;
    boxes.reserve(parts.size());
    for (const CellRange& part : parts) boxes.push_back(looked_at(part));
    std::vector<Restriction> here(parts.size());
    // In a cell, what is not near its surface counts no more. Larger parts keep what covers the kinks of others.
    const bool of_cells = std::all_of(parts.begin(), parts.end(), is_cell);
    field.restrict_all(boxes, of_cells ? Purpose::occupancy : Purpose::value, here);
    return here;
  }
  [[nodiscard]] static bool is_cell(const CellRange& range) {
    return range.count == std::array<std::int32_t, 3>{1, 1, 1};
  }

  /// `field` has the solid's sign in the range, and its interval there leaves room for a surface.
  void inspect(const Field& field, const CellRange& range, Task& task) const {
    if (field.smooth()) return leave_open(range, task);
    const Box box = looked_at(range);
    task.normals.clear();
    const SurfaceProof proof = prove_sheet(field, box, task.normals, side_, 0);
    task.known = task.known || proof.known;
    if (proof.one_sheet || proof.empty) return;
    if (is_cell(range)) {
      // Where it has been to no avail often, it is not worth much more.
      constexpr std::size_t patience = 64;
      const bool hopeless = task.cells.size() > patience + task.proved;
      const bool proved =
          !field.faceted() && prove_sheet_by_parts(field, box, task.normals, 0, hopeless ? 0 : 2).one_sheet;
      if (proved)
        ++task.proved;
      else
        leave_open(range, task);
      return;
    }
    const std::vector<CellRange> parts = halves(range);
    const std::vector<Restriction> here = restricted(field, parts);
    const bool simpler =
        std::any_of(here.begin(), here.end(), [&](const Restriction& part) { return part.field.get() != &field; });
    // A Field that is the same in the parts (a mesh, a scan) is dear to ask, and tells little more of each.
    if (!simpler && !proof.known) return leave_open(range, task);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!here[i].range.decided()) inspect(*here[i].field, parts[i], task);
  }

  /// Several cells that are not looked into are one place.
  void leave_open(const CellRange& range, Task& task) const { task.cells.push_back({range.first, box(range), side_}); }

  Box region_;
  Progress& progress_;
  Vec3 cell_;
  double side_ = 0;
  std::mutex collecting_;
  std::vector<UncertainCell> cells_;
  bool known_ = false;
};

/// Whether the planes of a lattice pass through all samples of a Field: its cells then have all that is known.
bool divides_samples(const Field& field, const Box& region, const std::array<std::int32_t, 3>& counts) {
  const std::optional<Sampling> samples = field.sampling();
  if (!samples) return false;
  const auto is_whole = [](double number) {
    return std::abs(number - std::round(number)) < 1e-6 && std::abs(number) < 1e9;
  };
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double cell = region.size()[axis] / counts[static_cast<std::size_t>(axis)];
    const double parts = samples->spacing[axis] / cell;
    if (parts < 0.5 || !is_whole(parts) || !is_whole((region.lower[axis] - samples->origin[axis]) / cell)) return false;
  }
  return true;
}

}  // namespace

Certainty certainty_of_cells(const Field& field, const Box& region, double voxel, Progress& progress) {
  const Vec3 size = region.size();
  if (!region.valid() || !(size.x() > 0) || !(size.y() > 0) || !(voxel > 0) || !std::isfinite(voxel))
    throw Error(ErrorKind::bad_input, "region", "region and voxel must be finite, with a positive size");
  std::array<std::int32_t, 3> counts{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil(size[static_cast<Eigen::Index>(axis)] / voxel * (1 - 1e-9));
    if (cells > (1 << 24))
      throw Error(ErrorKind::too_large, "voxel", "divides the region into more than 2^24 cells a side");
    counts[axis] = std::max(1, static_cast<std::int32_t>(cells));
  }
  if (field.sampled()) {
    Certainty certainty;
    if (!divides_samples(field, region, counts)) certainty.doubt = Doubt::not_looked;
    return certainty;
  }
  progress.report(0, "looking for thin parts");
  CellInspector inspector(region, counts, progress);
  const Restriction here = field.restricted(region.grown(sheet_overlap * voxel));
  if (!here.range.decided()) inspector.run(*here.field, {{0, 0, 0}, counts});
  return inspector.certainty();
}

}  // namespace fieldfab

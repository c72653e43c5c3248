#include "fieldfab/openscad/design.h"

#include <algorithm>
#include <cmath>

#include "evaluator.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/model/model.h"
#include "programs.h"

namespace fieldfab::openscad {
namespace {

constexpr std::uintmax_t most_text = 1'000'000'000;  // bytes

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// A Field that knows a box which holds it.
class Boxed final : public Field {
 public:
  Boxed(FieldPtr field, const Box& box) : field_(std::move(field)), box_(box) {}
  void values(const Points& points, float* out) const noexcept override { field_->values(points, out); }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    field_->gradients(points, out, slopes);
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return field_->interval(box); }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    field_->slopes(box, directions, out);
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    field_->restrict_all(boxes, purpose, out);
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return box_; }
  [[nodiscard]] std::size_t cost() const noexcept override { return field_->cost(); }

 private:
  FieldPtr field_;
  Box box_;
};

/// Cells that see what is thin, but not so many on its surface that it takes long.
double voxel_for(double longest, double thinnest, double area) {
  constexpr double cells_across = 2.5, fewest = 128, most = 2000, most_on_surface = 300'000;
  const double least = std::max(longest / most, std::sqrt(area / most_on_surface));
  return std::min(std::max(thinnest / cells_across, least), longest / fewest);
}

}  // namespace

Tree read_tree(const std::filesystem::path& path, Progress& progress) {
  if (lower_extension(path) != ".scad") return parse_csg(read_file(path, most_text), path.string());
  const TemporaryFolder temporary;
  const std::filesystem::path csg = temporary.path() / "design.csg";
  run_openscad(path, csg, progress);
  return parse_csg(read_file(csg, most_text), path.string());
}

std::vector<int> dimensions_of(const Tree& tree) {
  const Evaluator evaluator(tree, {}, {}, Progress::none());
  std::vector<int> dimensions;
  for (NodeIndex i = 0; i < tree.nodes.size(); ++i) dimensions.push_back(evaluator.dimensions(i));
  return dimensions;
}

Design make_design(const Tree& tree, const std::filesystem::path& folder, const DesignOptions& options, Progress& progress) {
  Evaluator evaluator(tree, folder, options, progress);
  progress.report(0, "building the solid");
  Design design;
  const NodeIndex start = evaluator.start();
  // What single precision loses at the farthest corner, some times over.
  constexpr double loss = 1e-6;
  Solid solid;
  if (evaluator.dimensions(start) == 2) {
    const Region region = tidied(evaluator.flat(start));
    design.flat = true;
    if (!region.empty()) {
      const Eigen::AlignedBox2d box = region.bounds();
      constexpr double far_away = 1e9;
      const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
      if (!options.smooth)
        design.faces = [region, farthest](std::optional<double> thickness, Progress& shown) -> std::optional<TriangleMesh> {
          if (!thickness) return std::nullopt;
          constexpr double narrow = 8e-6;  // of the farthest coordinate: some last places of single precision
          for (const Region& shape : {separated(region), without_narrows(region, narrow * farthest)}) {
            const PartPtr plate = part_of(extruded_leaf(shape, 0, *thickness, Eigen::Affine3d::Identity()));
            if (auto faces = faces_of(*plate, shown)) return faces;
          }
          return std::nullopt;
        };
      const double growth = loss * farthest;
      Making making{growth, growth, options.formulas_only, &progress};
      if (options.formulas_only)
        solid = extruded_leaf(region, -far_away, far_away, Eigen::Affine3d::Identity())->solid(making);
      else
        solid = {std::nullopt, flat_field(region, growth)};
      design.voxel =
          voxel_for(box.sizes().maxCoeff(), region.stroke(), 2 * region.area() + region.length() * box.sizes().maxCoeff() / 32);
    }
  } else {
    const PartPtr part = evaluator.solid(start, Eigen::Affine3d::Identity());
    const Box box = part->empty() ? Box() : bounds_of(*part);
    if (box.size().minCoeff() > 0) {
      const double growth = loss * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
      solid = solid_of(*part, {growth, growth, options.formulas_only, &progress});
      design.bounds = box.grown(2 * growth);
      if (!options.smooth)
        design.faces = [part](std::optional<double> thickness, Progress& shown) -> std::optional<TriangleMesh> {
          if (thickness) return std::nullopt;  // a slice of it
          return faces_of(*part, shown);
        };
      design.voxel = voxel_for(box.size().maxCoeff(), thickness_of(*part), area_of(*part));
    }
  }
  design.notes = evaluator.notes();
  if (solid.empty()) return design;
  design.formula = solid.formula;
  design.field = solid.as_field();
  if (design.bounds) design.field = std::make_shared<Boxed>(design.field, *design.bounds);
  return design;
}

void add_model_readers() {
  add_model_reader(
      {{".scad", ".csg"}, [](const std::filesystem::path& path, Roundness roundness, Progress& progress) {
         const Tree tree = read_tree(path, progress);
         const Design design = make_design(tree, path.parent_path(), {roundness == Roundness::smooth, false}, progress);
         if (design.field == nullptr) throw Error(ErrorKind::bad_input, path.string(), "the design is empty");
         Model model;
         model.kind = "design";
         model.field = design.field;
         model.expression = design.formula;
         model.voxel = design.voxel;
         model.faces = design.faces;
         model.notes = design.notes;
         return model;
       }});
}

}  // namespace fieldfab::openscad

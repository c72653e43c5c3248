#include "fieldfab/openscad/design.h"
#include "fieldfab/core/lower_case.h"

#include <algorithm>
#include <cmath>

#include "evaluator.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/solid/open.h"
#include "programs.h"

namespace fieldfab::openscad {
namespace {

constexpr std::uintmax_t most_text = 1'000'000'000;  // bytes

/// Returns a voxel that resolves thin parts, unless that puts too many cells on the surface.
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

std::shared_ptr<OpenedSolid> make_design(const Tree& tree, const std::filesystem::path& folder,
                                         const DesignOptions& options, Progress& progress) {
  Evaluator evaluator(tree, folder, options, progress);
  progress.report(0, "building the solid");
  auto made = std::make_shared<OpenedSolid>();
  OpenedSolid& design = *made;
  design.kind = "design";
  std::optional<Box> bounds;
  const NodeIndex start = evaluator.start();
  // Several times the rounding of single precision at the farthest corner.
  constexpr double loss = 1e-6;
  Shape solid;
  if (evaluator.dimensions(start) == 2) {
    const Region region = tidied(evaluator.flat(start));
    design.flat = true;
    if (!region.empty()) {
      const Eigen::AlignedBox2d box = region.bounds();
      constexpr double far_away = 1e9;
      const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
      if (!options.smooth)
        design.faces = [region, farthest](std::optional<double> thickness,
                                          Progress& shown) -> std::optional<TriangleMesh> {
          if (!thickness) return std::nullopt;
          constexpr double narrow = 8e-6;  // times the farthest coordinate: several last places of single precision
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
      design.voxel = voxel_for(box.sizes().maxCoeff(), region.stroke(),
                               2 * region.area() + region.length() * box.sizes().maxCoeff() / 32);
    }
  } else {
    const PartPtr part = evaluator.solid(start, Eigen::Affine3d::Identity());
    const Box box = part->empty() ? Box() : bounds_of(*part);
    if (box.size().minCoeff() > 0) {
      const double growth = loss * std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
      solid = solid_of(*part, {growth, growth, options.formulas_only, &progress});
      bounds = box.grown(2 * growth);
      if (!options.smooth)
        design.faces = [part](std::optional<double> thickness, Progress& shown) -> std::optional<TriangleMesh> {
          if (thickness) return std::nullopt;  // a plate is wanted, not this solid
          return faces_of(*part, shown);
        };
      design.voxel = voxel_for(box.size().maxCoeff(), thickness_of(*part), area_of(*part));
    }
  }
  design.notes = evaluator.notes();
  if (solid.empty()) return made;
  design.formula = solid.formula;
  design.field = solid.as_field();
  if (bounds) design.field = with_known_bounds(design.field, *bounds);
  return made;
}

const Formats& all_formats() {
  static const Formats formats = kernel_formats().with(
      {{{".scad", ".csg"},
        FormatKind::design,
        std::nullopt,
        "an OpenSCAD design; .scad needs OpenSCAD installed",
        [](const std::filesystem::path& path, const OpenSettings& settings, Progress& progress) {
          const bool smooth = option_number(settings.options, "smooth", 0) != 0;
          const auto design = make_design(read_tree(path, progress), path.parent_path(), {smooth, false}, progress);
          if (design->field == nullptr) throw Error(ErrorKind::bad_input, path.string(), "the design is empty");
          return model_of_file(design, path, settings);
        }}});
  return formats;
}

}  // namespace fieldfab::openscad

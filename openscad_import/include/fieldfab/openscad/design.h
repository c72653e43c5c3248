/// A design of OpenSCAD as a solid.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"
#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/openscad/tree.h"

namespace fieldfab::openscad {

struct DesignOptions {
  bool smooth = false;         ///< circles, spheres, cylinders and turned shapes round, not faceted as OpenSCAD draws them
  bool formulas_only = false;  ///< throw bad_input rather than give what has no formula
};

/// What was read.
struct Design {
  FieldPtr field;                           ///< null where the design is empty
  std::optional<frep::Expression> formula;  ///< the same as a formula, where all of it has one
  std::optional<Box> bounds;                ///< holds it; where it is not flat
  std::optional<double> voxel;              ///< mm; cells that do not miss its thinnest part, where that does not take too many
  /// Makes its surface as it is, see Model::faces; null where nothing but a contour can be had.
  std::function<std::optional<TriangleMesh>(std::optional<double> thickness, Progress& progress)> faces;
  bool flat = false;               ///< a 2D design: without ends along z
  std::vector<std::string> notes;  ///< what was left out or mended, one line each, with FILE:LINE
};

/// Reads a .csg file, or a .scad file through the installed `openscad`. Throws io, bad_input: also with OpenSCAD's own message
/// where it fails.
Tree read_tree(const std::filesystem::path& path, Progress& progress = Progress::none());

/// How many dimensions each node's shape has: 2 or 3, or 0 where it draws nothing. Throws bad_input with FILE:LINE for what is
/// unknown.
std::vector<int> dimensions_of(const Tree& tree);

/// The solid of a tree; `folder` is where the files that it imports are looked for. Throws bad_input with FILE:LINE for what is
/// unknown or cannot be, io for a missing file, cancelled.
Design make_design(const Tree& tree, const std::filesystem::path& folder, const DesignOptions& options = {},
                   Progress& progress = Progress::none());

/// Lets load_model() read .csg and .scad files. To be called once by a program's main, or a module's initialisation.
void add_model_readers();

}  // namespace fieldfab::openscad

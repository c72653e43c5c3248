/// Solid: a Field with its metadata. Hosts create Solids, combine them, and call surface() for a mesh.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/frep/expression.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Computes the exact surface of a solid with flat faces, as valid as that of contour(), with the solid's own vertices.
/// Returns std::nullopt if this is impossible or would take long. A flat (2D) solid needs the `thickness` of its plate,
/// mm, from z = 0 upwards; `thickness` must be std::nullopt for any other solid. Throws Error(cancelled).
using FaceMaker = std::function<std::optional<TriangleMesh>(std::optional<double> thickness, Progress& progress)>;

/// A leaf of expressions: a solid that is not a formula, with the metadata of its source.
struct OpenedSolid : frep::Source {
  std::string kind;                         ///< "asdf", "mesh", "volume" or "design"
  std::optional<double> voxel;              ///< own resolution, mm
  std::optional<Box> bounds;                ///< own region, mm; contains the solid
  FaceMaker faces;                          ///< null: only contour() applies
  std::optional<frep::Expression> formula;  ///< equivalent formula, for a design that has one
  bool flat = false;                        ///< whether the solid is 2D: unbounded along z
  std::vector<std::string> notes;           ///< omissions and repairs, for people, one line each
};

/// A solid, as a value. Its expression defines it completely, with formulas and opened leaves.
struct Solid {
  frep::Expression expression = 1.0;  ///< default: empty space
  FieldPtr field;                     ///< Field of the expression; never null after solid_of()
  /// kind of the leaf if the solid is a single leaf, placed or not; otherwise "f-rep"
  std::string kind = "f-rep";
  std::optional<double> voxel;  ///< finest own resolution of its leaves, mm
  std::optional<Box> bounds;    ///< own region, mm, if known without a search
  FaceMaker faces;              ///< null where contour() is all there is
  bool flat = false;            ///< whether the solid is known to be 2D: unbounded along z
  std::string name;             ///< name of a part; may be empty
  std::optional<Colour> colour;
  std::string place = {};  ///< position of a part in its text, FILE:LINE:COLUMN; may be empty
};

/// Content of a file or a text: one solid, or several named parts.
struct Model {
  std::vector<Solid> parts;             ///< at least one
  std::vector<std::string> notes = {};  ///< omissions and repairs, for people, one line each
};

/// Returns the solid of an expression. A single leaf that is only moved or rotated keeps its faces, bounds and
/// resolution.
Solid solid_of(frep::Expression expression);
/// Returns the solid of a leaf, unchanged.
Solid solid_of(const std::shared_ptr<const OpenedSolid>& opened);
/// Returns a solid made in memory, which no text can name.
Solid solid_of(FieldPtr field, std::string kind, std::optional<Box> bounds = {}, bool flat = false);

/// Returns the union of all parts, or the part itself if there is only one.
Solid united(const Model& model);

/// Returns the part of that name. The reference is valid as long as `model`. Throws Error(bad_input) at `place`, with
/// the most similar name, if there is none.
const Solid& part_of(const Model& model, const std::string& name, const std::string& place);

/// Returns the solid between z = 0 and `height` mm: a plate, if the solid is flat. Throws Error(bad_input) unless
/// height > 0.
Solid plate_of(const Solid& solid, double height);

}  // namespace fieldfab

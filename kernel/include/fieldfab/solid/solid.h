/// Solid: a Field and what is known of it. Hosts make Solids, combine them, and ask surface() for a mesh.
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

/// Makes the exact surface of a solid that is drawn with flat faces: valid as contour()'s is, with the corners that the solid
/// has. Nothing where that is not possible or would take long. A flat (2D) solid needs the `thickness` of its plate, mm, from
/// z = 0 up; no other solid may be given one. Throws cancelled.
using FaceMaker = std::function<std::optional<TriangleMesh>(std::optional<double> thickness, Progress& progress)>;

/// A solid that is no formula, and what its source knows of it: a leaf of expressions.
struct OpenedSolid : frep::Source {
  std::string kind;                         ///< "asdf", "mesh", "volume" or "design"
  std::optional<double> voxel;              ///< resolution of its own, mm
  std::optional<Box> bounds;                ///< region of its own, which holds the solid
  FaceMaker faces;                          ///< null where contour() is all there is
  std::optional<frep::Expression> formula;  ///< the same solid as a formula, of a design that has one
  bool flat = false;                        ///< 2D: without ends along z
  std::vector<std::string> notes;           ///< what was left out or mended, for people, one line each
};

/// A solid, as a value. Its expression is the whole of it: formulas, and leaves that were opened.
struct Solid {
  frep::Expression expression = 1.0;  ///< empty space
  FieldPtr field;                     ///< of the expression; never null once made by solid_of()
  std::string kind = "f-rep";         ///< of the leaf, where the solid is one leaf (moved or not); else "f-rep"
  std::optional<double> voxel;        ///< resolution of its own, mm: the finest of its leaves
  std::optional<Box> bounds;          ///< region of its own, where one is known without a search
  FaceMaker faces;                    ///< null where contour() is all there is
  bool flat = false;                  ///< known to be 2D: without ends along z
  std::string name;                   ///< of a part; may be empty
  std::optional<Colour> colour;
  std::string place = {};  ///< of a part in the text that makes it: FILE:LINE:COLUMN; empty where there is none
};

/// What a file or a text makes: one solid, or several parts with names of their own.
struct Model {
  std::vector<Solid> parts;             ///< one or more
  std::vector<std::string> notes = {};  ///< for people, one line each: what was left out or mended
};

/// The solid of an expression. Of one leaf that is only placed, all that the leaf knows stays true: faces, bounds, resolution.
Solid solid_of(frep::Expression expression);
/// The solid of a leaf, as it is.
Solid solid_of(const std::shared_ptr<const OpenedSolid>& opened);
/// A solid that was made in memory; no text can name it.
Solid solid_of(FieldPtr field, std::string kind, std::optional<Box> bounds = {}, bool flat = false);

/// All parts as one solid; the part itself where there is only one.
Solid united(const Model& model);

/// The part of that name. Throws bad_input at `place`, with the name that is nearest.
const Solid& part_of(const Model& model, const std::string& name, const std::string& place);

/// The solid between z = 0 and `height` mm: a plate of a flat one. Throws bad_input for a height that is not positive.
Solid plate_of(const Solid& solid, double height);

}  // namespace fieldfab

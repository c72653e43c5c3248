/// The workflow as a graph (Keeter 6.1): stages convert one kind of artifact into another, and a search finds the chain
/// from the input to the operation.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "fieldfab/cam/base/setting.h"
#include "fieldfab/cam/plan/free_space.h"
#include "fieldfab/cam/plan/material.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/order.h"
#include "fieldfab/cam/plan/planes.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/render/image.h"
#include "fieldfab/solid/solid.h"

namespace fieldfab::cam {

/// Paths, and the constraints on joining them.
struct PlannedCuts {
  std::vector<Path> paths;
  bool ordered = false;  ///< whether their order and start points must be kept
  bool inside_first = true, may_reverse = false;
  std::function<bool(const Vec3&, const Vec3&)> may_stay_down = nullptr;
  bool drills = false;  ///< whether the paths drill holes
  double width = 0;     ///< width of cut that passes are planned for, mm; 0: the tool's
  double leans = 0;     ///< greatest inclination of the tool to the plane's z, radians
  /// tip surface of a finishing operation, so that later planes omit the area it covers
  std::shared_ptr<const TipSurface> finished = nullptr;
};

/// An intermediate result. A Solid has bounds here: the region of interest. A flat Solid is a drawing, constant along
/// z.
using Artifact = std::variant<Solid, Image, Bitmap, Outline, std::shared_ptr<const Surface>, PlannedCuts>;
/// Kind of an Artifact, in the order of the variant.
enum class Kind { solid, image, bitmap, outline, surface, paths };
const char* name_of(Kind kind);

/// Information about the job for stages, besides their own settings.
struct Context {
  Tool tool;
  Box stock;                                ///< box of the material in plane coordinates, mm
  Plane plane;                              ///< the plane from which the operation cuts
  FieldPtr part;                            ///< the part in its own coordinates; null for images
  std::function<const FreeSpace&()> space;  ///< free space around the part, computed on the first call
  const Material& material;                 ///< material left by earlier operations on this plane
  const std::vector<Reached>& earlier;      ///< areas finished by earlier operations on other planes
  Progress& progress;
  std::vector<std::string>& notes;  ///< receives notes for the user
};

/// A step of a workflow.
struct Stage {
  std::string name, help;
  Kind takes, makes;
  bool operation = false;  ///< whether jobs request it by name; other stages are inserted as needed
  Settings settings;
  std::function<Artifact(const Artifact&, const Values&, Context&)> run;
  /// For an operation on a drawing: returns the part of the stock that it may remove, or null if unknown. May be null.
  FieldPtr (*may_cut)(const FieldPtr& drawing, const Values&, const Box& stock) = nullptr;
};

/// Returns all stages. A new stage is an entry in the table of its file in cam/job; no other code refers to it.
const std::vector<Stage>& stages();
/// Returns the operation of that name. Throws Error(bad_input) at `place`, with the most similar name.
const Stage& operation(const std::string& name, const std::string& place);
/// Returns the settings common to all operations: how paths are joined to moves.
Settings joining_settings();
/// Returns the shortest chain of stages from a kind to an operation, which comes last. Throws Error(bad_input) if there
/// is none.
std::vector<const Stage*> chain(Kind from, const Stage& operation);

}  // namespace fieldfab::cam

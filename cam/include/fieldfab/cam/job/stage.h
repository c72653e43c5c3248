/// The workflow as a graph (Keeter 6.1): stages turn one kind of thing into another, and the system finds the chain that leads
/// from what there is to what a machine takes.
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

/// Paths, and how they want to be joined.
struct PlannedCuts {
  std::vector<Path> paths;
  bool ordered = false;  ///< their order and start points matter: leave them
  bool inside_first = true, may_reverse = false;
  std::function<bool(const Vec3&, const Vec3&)> may_stay_down = nullptr;
  double leans = 0;                                      ///< how far the tool leans from the plane's z at most, radians
  std::shared_ptr<const TipSurface> finished = nullptr;  ///< where a finishing tool could go, so that later planes leave that out
};

/// Solids have bounds here: the region that stages look at. A flat one is a drawing, the same at every z.
using Artifact = std::variant<Solid, Image, Bitmap, Outline, std::shared_ptr<const Surface>, PlannedCuts>;
/// What an Artifact is; in the variant's order.
enum class Kind { solid, image, bitmap, outline, surface, paths };
const char* name_of(Kind kind);

/// What stages may ask about the job besides their own settings.
struct Context {
  Tool tool;
  Box stock;                                ///< the material, mm, in the plane's coordinates
  Plane plane;                              ///< that is cut from
  FieldPtr part;                            ///< in its own coordinates; nullptr for images
  std::function<const FreeSpace&()> space;  ///< around it
  const Material& material;                 ///< what earlier operations on this plane have left
  const std::vector<Reached>& earlier;      ///< what other planes have finished
  Progress& progress;
  std::vector<std::string>& notes;  ///< what the user should know
};

/// A step of a workflow.
struct Stage {
  std::string name, help;
  Kind takes, makes;
  bool operation = false;  ///< asked for by name in a job; others are put in where they lead on
  Settings settings;
  std::function<Artifact(const Artifact&, const Values&, Context&)> run;
  /// Of an operation on a drawing: what of the stock it may take away. Null, or null from it: it does not say.
  FieldPtr (*may_cut)(const FieldPtr& drawing, const Values&, const Box& stock) = nullptr;
};

/// All stages there are. To add one, add it to the table of its file in cam/job: nothing else has to know.
const std::vector<Stage>& stages();
/// An operation by name; throws bad_input at `place` with the nearest name.
const Stage& operation(const std::string& name, const std::string& place);
/// What all operations can be told besides: how their paths are joined to moves.
Settings joining_settings();
/// The shortest chain of stages from a kind to an operation, the operation last. Throws bad_input where none leads there.
std::vector<const Stage*> chain(Kind from, const Stage& operation);

}  // namespace fieldfab::cam

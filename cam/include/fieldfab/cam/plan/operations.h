/// What a machine can do to a part: each operation turns outlines or a surface into paths of the tool's tip.
#pragma once

#include <optional>
#include <vector>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/path.h"
#include "fieldfab/cam/plan/surface.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

class Material;

/// A part seen from above as signed distance: negative in the part, exact at least near its outline.
struct Outline {
  FieldPtr distance;
  Rectangle bounds;   ///< holds the part
  double cell = 0.1;  ///< squares that contours of it are made with, mm
};

/// From the top of the material to the bottom of the cut, in even steps of at most `step`.
struct Depths {
  double top = 0, bottom = -1, step = 1e300;
  /// z of each pass, the highest first; the last one is the bottom. Throws bad_input unless bottom < top and step > 0.
  [[nodiscard]] std::vector<double> passes() const;
};

/// What all operations on outlines share.
struct CutSettings {
  double radius = 0;     ///< of the tool, or half of the beam's width, mm
  double allowance = 0;  ///< left on the part, mm
  Depths depths;
  bool climb = true;         ///< the wall on the right of the tool (for a spindle that turns clockwise)
  double tolerance = 0.005;  ///< for fitting lines and arcs, mm
  bool arcs = true;
};

enum class Side { outside, inside, on };

/// Bridges that hold a part while it is cut out.
struct Tabs {
  int count = 0;      ///< on each loop, evenly along it
  double width = 4;   ///< that stays, mm
  double height = 1;  ///< above the bottom of the cut, mm
};

/// Along the outline, `side` of it.
std::vector<Path> profile(const Outline& part, Side side, const CutSettings& cut, const Tabs& tabs = {},
                          Progress& progress = Progress::none());

/// Offsets outward from the outline, as for isolating the traces of a circuit board: `count` of them (-1: until all is cut), each
/// `stepover` mm from the one before.
std::vector<Path> isolate(const Outline& part, int count, double stepover, const CutSettings& cut,
                          Progress& progress = Progress::none());

/// How an area is cleared.
struct ClearSettings {
  double stepover = 1;      ///< between rings, mm; adaptive: the tool is engaged as in a straight pass of that stepover
  bool adaptive = false;    ///< adaptive() instead of rings
  double helix_radius = 1;  ///< adaptive: of the way into solid material; less where there is no room for it
  double ramp_angle = 3 * 3.14159265358979323846 / 180;  ///< of the helix against the plane, radians
  const Material* material = nullptr;                    ///< what there is to cut; nullptr: everything
};

/// Clears the inside of the outline, as far as the tool gets there. With adaptive clearing the paths are in their order.
std::vector<Path> pocket(const Outline& area, const ClearSettings& settings, const CutSettings& cut,
                         Progress& progress = Progress::none());
/// Pockets and necks that a tool of that radius does not get into: the middles of what it leaves, but for corners.
std::vector<Vec2> too_narrow(const Outline& area, double radius, Progress& progress = Progress::none());

/// Rings inside an area that the tool's middle may be in (negative), `stepover` apart, the outermost along its border.
std::vector<Path> rings(const Field& area, const Rectangle& bounds, double cell, double stepover, double z,
                        const CutSettings& cut, Progress& progress = Progress::none());

/// Clears an area with constant engagement: the tool's middle stays where `free` is negative, inside of the bounds, and is
/// steered step by step so that each step cuts the same area, as far as walls allow. Ways through what is cut already are part of
/// the paths (Pace::link), the way into solid material too. What can only be cut with more engagement (slots) comes last, and
/// then a pass along the walls. Paths are in their order. `cell`: squares that contours are made with.
std::vector<Path> adaptive(const Field& free, const Rectangle& bounds, double cell, const ClearSettings& settings,
                           const CutSettings& cut, Progress& progress = Progress::none());

/// Carves the inside of the outline with a V of half angle `half_angle`, so that its flanks end at the outline: along the medial
/// axis, as deep as the V is wide there, but no deeper than the depths' bottom; wider places get a flat floor.
std::vector<Path> v_carve(const Loops& part, double half_angle, double stepover, const CutSettings& cut,
                          Progress& progress = Progress::none());

/// A round hole.
struct Hole {
  Vec2 centre;
  double radius;
};
/// Loops that are circles to within the tolerance: the holes of a part (clockwise ones) and round posts.
std::vector<Hole> holes(const Loops& loops, double tolerance);
/// Holes of one diameter: down in pecks of `peck` mm (0: in one go), each a path of its own.
std::vector<Path> drill(const std::vector<Hole>& where, double peck, const Depths& depths);

/// Clears what lies above a surface in levels: at each of them what the tip can reach and where stock is left.
struct RoughSettings {
  Rectangle stock;  ///< of the material, mm
  Depths depths;
  ClearSettings clear;
  CutSettings cut;
  double cell = 0.2;  ///< squares of contours, mm
};
std::vector<Path> rough(const std::shared_ptr<const TipSurface>& tips, const RoughSettings& settings,
                        Progress& progress = Progress::none());

/// How a surface is finished.
struct FinishSettings {
  Rectangle area;           ///< where the tool's middle goes
  double stepover = 0.5;    ///< between passes, mm
  double angle = 0;         ///< of the passes against x, radians
  bool both_ways = true;    ///< every other pass runs back
  double bottom = -1e300;   ///< the tip goes no deeper
  double tolerance = 0.01;  ///< of the path against the surface, mm
};
/// Parallel passes over the surface.
std::vector<Path> raster(const TipSurface& tips, const FinishSettings& settings, Progress& progress = Progress::none());
/// One spiral from the middle outwards, in passes `stepover` apart.
std::vector<Path> spiral(const TipSurface& tips, const FinishSettings& settings, Progress& progress = Progress::none());
/// Level contours of the tip's surface at the depths' passes.
std::vector<Path> waterline(const std::shared_ptr<const TipSurface>& tips, const Rectangle& area, double cell,
                            const CutSettings& cut, Progress& progress = Progress::none());

/// Along the valleys of the surface: where a round tool touches both sides, whose normals there differ by at least `least_angle`
/// (radians). Valleys are looked for on a lattice of `cell` mm. Throws bad_input for a tool without a round corner.
std::vector<Path> pencil(const TipSurface& tips, const FinishSettings& settings, double cell, double least_angle,
                         Progress& progress = Progress::none());

/// The stepover at which a ball (or bull) of that corner radius leaves ridges of a height on a flat.
double stepover_for_scallop(double corner_radius, double scallop);

}  // namespace fieldfab::cam

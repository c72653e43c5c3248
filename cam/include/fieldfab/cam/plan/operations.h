/// Machining operations: each converts outlines or a surface into paths of the tool tip.
#pragma once

#include <optional>
#include <vector>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/path.h"
#include "fieldfab/cam/plan/surface.h"
#include "fieldfab/core/angle.h"
#include "fieldfab/core/progress.h"

namespace fieldfab::cam {

class Material;

/// A part seen from above, as a signed distance: negative in the part, exact at least near its outline.
struct Outline {
  FieldPtr distance;
  Rectangle bounds;   ///< contains the part
  double cell = 0.1;  ///< edge of the squares for contours, mm
};

/// Depth range of a cut, divided into equal steps of at most `step`, mm.
struct Depths {
  double top = 0, bottom = -1, step = 1e300;
  /// Returns z of each pass, from the highest to the bottom. Throws Error(bad_input) unless bottom < top and step > 0.
  [[nodiscard]] std::vector<double> passes() const;
};

/// Settings shared by operations on outlines.
struct CutSettings {
  double radius = 0;     ///< radius of the tool, or half the width of the beam, mm
  double allowance = 0;  ///< material left on the part, mm
  Depths depths;
  bool climb = true;         ///< climb milling: the wall is on the right of the tool (for a clockwise spindle)
  double tolerance = 0.005;  ///< tolerance of fitted lines and arcs, mm
  bool arcs = true;
};

enum class Side { outside, inside, on };

/// Holding tabs: bridges that hold a part while it is cut out.
struct Tabs {
  int count = 0;      ///< number on each loop, equally spaced
  double width = 4;   ///< remaining width, mm
  double height = 1;  ///< height above the bottom of the cut, mm
};

/// Cuts along the outline, on the given side.
std::vector<Path> profile(const Outline& part, Side side, const CutSettings& cut, const Tabs& tabs = {},
                          Progress& progress = Progress::none());

/// Cuts outward offsets of the outline, as for the isolation of circuit board traces: `count` of them (-1: until no
/// material is left), `stepover` mm apart.
std::vector<Path> isolate(const Outline& part, int count, double stepover, const CutSettings& cut,
                          Progress& progress = Progress::none());

/// Settings for clearing an area.
struct ClearSettings {
  /// distance of rings, mm; with adaptive clearing: the stepover of a straight pass with the same engagement
  double stepover = 1;
  bool adaptive = false;               ///< whether to use adaptive() instead of rings
  double helix_radius = 1;             ///< adaptive: radius of the entry helix, mm; smaller where there is no room
  double ramp_angle = to_radians(3);   ///< angle of the helix to the plane, radians
  const Material* material = nullptr;  ///< material to cut, not owned; nullptr: all
};

/// Clears the inside of the outline as far as the tool reaches. With adaptive clearing the paths are already ordered.
std::vector<Path> pocket(const Outline& area, const ClearSettings& settings, const CutSettings& cut,
                         Progress& progress = Progress::none());
/// Returns the centres of regions that a tool of that radius cannot enter (pockets and necks), except corners.
std::vector<Vec2> too_narrow(const Outline& area, double radius, Progress& progress = Progress::none());

/// Returns rings in the area of permitted tool centres (negative values), `stepover` mm apart, the outermost along its
/// border.
std::vector<Path> rings(const Field& area, const Rectangle& bounds, double cell, double stepover, double z,
                        const CutSettings& cut, Progress& progress = Progress::none());

/// Clears an area with constant engagement (adaptive clearing). The tool centre stays where `free` is negative, inside
/// `bounds`; each step is steered to cut the same area, as far as walls allow. The paths include links through cleared
/// areas (Pace::link) and entries into solid material. Slots, which need greater engagement, come last, followed by a
/// pass along the walls. Paths are ordered. `cell` is the edge of the squares for contours, mm.
std::vector<Path> adaptive(const Field& free, const Rectangle& bounds, double cell, const ClearSettings& settings,
                           const CutSettings& cut, Progress& progress = Progress::none());

/// V-carving of the inside of the outline with a V cutter of half angle `half_angle`, radians: the flanks end at the
/// outline. The tip follows the medial axis, at the depth where the V has the local width, but not below the depths'
/// bottom; wider regions get a flat floor.
std::vector<Path> v_carve(const Loops& part, double half_angle, double stepover, const CutSettings& cut,
                          Progress& progress = Progress::none());

/// Cuts along the middles of an area's slots: where it is as wide as the tool, within the tolerance, and at most
/// `widest` mm wide.
struct Slots {
  std::vector<Path> paths;  ///< each pass of a slot runs the other way than the one above
  /// a place in each slot that is wider than the tool by more than the tolerance: its sides keep material
  std::vector<Vec2> wide;
};
/// Returns the cuts along the slots of an area. Throws Error(bad_input), Error(cancelled).
Slots slots(const Loops& area, double widest, const CutSettings& cut, Progress& progress = Progress::none());

/// A round hole, mm.
struct Hole {
  Vec2 centre;
  double radius;
};
/// Returns the loops that are circles within the tolerance: holes (clockwise) and round posts.
std::vector<Hole> holes(const Loops& loops, double tolerance);
/// Drills holes of one diameter in pecks of `peck` mm (0: in one motion); each hole is a path.
std::vector<Path> drill(const std::vector<Hole>& where, double peck, const Depths& depths);

/// Settings for thread milling, mm.
struct ThreadSettings {
  double pitch = 1;        ///< rise of the helix in a turn
  double diameter = 0;     ///< largest diameter of the thread; 0: that of an ISO metric thread in the hole
  bool right_hand = true;  ///< false: left-hand
  int passes = 1;          ///< number of passes to the full depth of the thread
};
/// Mills internal threads into holes with a cutter of one tooth, whose tip has the depths' z: helical ways from the top
/// of the cut to its bottom, each pass deeper into the wall. Paths are ordered. Throws Error(bad_input) if the tool
/// does not fit into a hole, or the hole is wider than the thread.
std::vector<Path> mill_threads(const std::vector<Hole>& where, const ThreadSettings& thread, const CutSettings& cut);
/// Height of an internal ISO metric thread (ISO 68-1: 5/8 of the fundamental triangle), mm.
double thread_depth(double pitch);

/// Settings for facing.
struct FaceSettings {
  double stepover = 1;    ///< greatest width of a pass, mm
  double angle = 0;       ///< angle of the passes to x, radians
  bool both_ways = true;  ///< whether alternate passes run backwards
};
/// Level passes over the whole stock, at each of the depths' passes. The tool leaves the stock at the ends of each
/// pass. Paths are ordered.
std::vector<Path> face(const Rectangle& stock, const FaceSettings& settings, const CutSettings& cut);

/// Settings for roughing.
struct RoughSettings {
  Rectangle stock;  ///< extent of the material, mm
  Depths depths;
  ClearSettings clear;
  CutSettings cut;
  double cell = 0.2;  ///< edge of the squares for contours, mm
};
/// Clears the volume above a surface in levels: at each level the area that the tip can reach and that has stock left.
std::vector<Path> rough(const std::shared_ptr<const TipSurface>& tips, const RoughSettings& settings,
                        Progress& progress = Progress::none());

/// Settings for finishing a surface.
struct FinishSettings {
  Rectangle area;           ///< area of the tool centre
  double stepover = 0.5;    ///< distance of passes, mm
  double angle = 0;         ///< angle of the passes to x, radians
  bool both_ways = true;    ///< whether alternate passes run backwards
  double bottom = -1e300;   ///< lower limit of the tip, mm
  double tolerance = 0.01;  ///< tolerance of the path to the surface, mm
};
/// Parallel passes over the surface.
std::vector<Path> raster(const TipSurface& tips, const FinishSettings& settings, Progress& progress = Progress::none());
/// One spiral from the centre outwards, with passes `stepover` apart.
std::vector<Path> spiral(const TipSurface& tips, const FinishSettings& settings, Progress& progress = Progress::none());
/// Waterlines: level contours of the tip's surface at the depths' passes.
std::vector<Path> waterline(const std::shared_ptr<const TipSurface>& tips, const Rectangle& area, double cell,
                            const CutSettings& cut, Progress& progress = Progress::none());

/// Pencil milling along the valleys of the surface, where a round tool touches both sides and their normals differ by
/// at least `least_angle` radians. Valleys are searched on a lattice of `cell` mm. Throws Error(bad_input) for a tool
/// without a round corner.
std::vector<Path> pencil(const TipSurface& tips, const FinishSettings& settings, double cell, double least_angle,
                         Progress& progress = Progress::none());

/// Returns the stepover, mm, at which a ball or bull-nose of that corner radius leaves ridges (scallops) of height
/// `scallop` on a flat.
double stepover_for_scallop(double corner_radius, double scallop);

}  // namespace fieldfab::cam

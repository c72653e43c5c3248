/// Programs: moves with tools and speeds, before they are written for a machine.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/path.h"
#include "fieldfab/core/angle.h"

namespace fieldfab::cam {

/// A straight or circular move of the tool tip, in part coordinates.
struct Move {
  Vec3 to = Vec3::Zero();     ///< end position, mm
  double feed = 0;            ///< feed, mm/min; 0: a rapid, which does not cut
  double bulge = 0;           ///< bulge as in PathPoint; 0: straight
  Vec3 axis = Vec3::UnitZ();  ///< tool axis at the end position, towards the spindle, of length 1
  [[nodiscard]] bool rapid() const { return feed == 0; }
};

enum class Coolant : std::uint8_t { none, mist, flood };
/// Returns "none", "mist" or "flood".
std::string_view name_of(Coolant coolant);
/// Returns the coolant of that name. Throws Error(bad_input) at `place`, with the most similar name.
Coolant coolant_named(std::string_view name, const std::string& place);

/// The moves of one operation. The first is a rapid to a safe position, from wherever the machine is.
struct Section {
  std::string name;  ///< name of the operation, for comments and set-up sheets
  Tool tool;
  double spindle = 0;  ///< spindle speed, revolutions per minute; 0: none
  Coolant coolant = Coolant::none;
  std::string setup;     ///< manual instructions before this section; empty: none
  double clearance = 0;  ///< safe height z, mm
  bool drills = false;   ///< whether it drills holes, which a machine may do by cycles of its own
  std::vector<Move> moves;
  /// Whether the tool axis differs from z in some move.
  [[nodiscard]] bool tilted() const;
};

struct Program {
  std::string name;
  std::vector<Section> sections;
  Box stock;  ///< box of the material, mm; default: unknown
};

/// Entry into the material: vertical plunge; ramp along the path; or a helix beside its start, which becomes a ramp
/// where there is no room.
enum class Entry { plunge, ramp, helix };

/// Parameters of link().
struct LinkSettings {
  double clearance = 5;             ///< height z of rapids between paths, mm
  double feed = 600, plunge = 200;  ///< feed and plunge rate, mm/min
  double link_feed = 600;           ///< feed through cleared areas, mm/min
  Entry entry = Entry::plunge;
  double ramp_angle = to_radians(3);  ///< angle to the plane, radians
  double helix_radius = 0;            ///< radius of the helix of the tool's centre, mm
  double above = 1;                   ///< height above the material at which the tool slows down, mm
  /// Upper bound of the material's height z at the start of a path, mm; the entry starts there. Null: unknown.
  std::function<double(const Path&)> material = nullptr;
  /// Whether the tool may move straight between two points while down, instead of retracting. Null: it may not.
  std::function<bool(const Vec3& from, const Vec3& to)> may_stay_down = nullptr;
};

/// Joins paths to moves: rapids at the clearance height, entries, cuts.
std::vector<Move> link(const std::vector<Path>& paths, const LinkSettings& settings);

/// Dynamics of a machine: rapid speed (mm/min), acceleration (mm/s^2), and tolerance at corners.
struct Dynamics {
  /// corner: permitted deviation at a corner passed without a stop, mm
  double rapid = 3000, acceleration = 200, corner = 0.02;
};
/// Returns the estimated duration of moves, seconds, with deceleration at corners as `dynamics` requires.
double duration(const std::vector<Move>& moves, const Dynamics& dynamics);

/// Lengths of cutting and of non-cutting moves, mm.
struct Lengths {
  double cut = 0, rapid = 0;
};
Lengths lengths(const std::vector<Move>& moves);

}  // namespace fieldfab::cam

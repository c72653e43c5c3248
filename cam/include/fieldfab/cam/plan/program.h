/// What is sent to a machine: moves, with the tool and the speeds they are made with.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/base/tool.h"
#include "fieldfab/cam/plan/path.h"

namespace fieldfab::cam {

/// One straight or round move of the tool's tip, in the part's coordinates.
struct Move {
  Vec3 to = Vec3::Zero();     ///< mm
  double feed = 0;            ///< mm/min; 0: as fast as the machine can, not cutting
  double bulge = 0;           ///< see PathPoint; 0 for a straight one
  Vec3 axis = Vec3::UnitZ();  ///< of the tool at its end, towards the spindle
  [[nodiscard]] bool rapid() const { return feed == 0; }
};

enum class Coolant : std::uint8_t { none, mist, flood };
/// "none", "mist" or "flood".
std::string_view name_of(Coolant coolant);
/// Throws bad_input at `place`, with the nearest name.
Coolant coolant_named(std::string_view name, const std::string& place);

/// The moves of one operation. The first one starts where the machine then is: it is a rapid to a safe place.
struct Section {
  std::string name;  ///< of the operation, for comments and set-up sheets
  Tool tool;
  double spindle = 0;  ///< revolutions per minute; 0: none
  Coolant coolant = Coolant::none;
  std::string setup;     ///< what to do by hand before it; empty where the work stays as it is
  double clearance = 0;  ///< z at which nothing is in the way, mm
  std::vector<Move> moves;
  [[nodiscard]] bool tilted() const;
};

struct Program {
  std::string name;
  std::vector<Section> sections;
  Box stock;  ///< the material, mm; empty where not known
};

/// How the tool gets into the material: straight down; along the path itself; or by a helix beside its start where there is room
/// for one (along the path where there is not).
enum class Entry { plunge, ramp, helix };

struct LinkSettings {
  double clearance = 5;             ///< z of rapids between paths, mm
  double feed = 600, plunge = 200;  ///< mm/min
  double link_feed = 600;           ///< through what is cut already, mm/min
  Entry entry = Entry::plunge;
  double ramp_angle = 3 * 3.14159265358979323846 / 180;  ///< against the plane, radians
  double helix_radius = 0;                               ///< of a helix that the tool's middle follows, mm
  double above = 1;                                      ///< how far above the material the tool slows down, mm
  /// z of the material's surface where a path begins; no higher than it is known to be. Tools enter from there.
  std::function<double(const Path&)> material = nullptr;
  /// Whether the tool may go straight from one place to another while it cuts, instead of up, over and down.
  std::function<bool(const Vec3& from, const Vec3& to)> may_stay_down = nullptr;
};

/// Joins paths to moves: rapids at the clearance, entries, cuts.
std::vector<Move> link(const std::vector<Path>& paths, const LinkSettings& settings);

/// Time that moves take, seconds: with the machine's acceleration (mm/s^2) and rapid speed (mm/min), stopping at corners as far
/// as the machine must.
struct Dynamics {
  double rapid = 3000, acceleration = 200, corner = 0.02;  ///< corner: mm by which a corner may be cut while not stopping
};
double duration(const std::vector<Move>& moves, const Dynamics& dynamics);

/// Length cut and length travelled without cutting, mm.
struct Lengths {
  double cut = 0, rapid = 0;
};
Lengths lengths(const std::vector<Move>& moves);

}  // namespace fieldfab::cam

/// Simulation results: events, times, lengths, volumes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/stock/cuts.h"
#include "fieldfab/cam/stock/deviation.h"
#include "fieldfab/cam/stock/stock.h"

namespace fieldfab::cam {

/// A fault. Faults of one kind along one pass form one event.
struct SimulationEvent {
  enum class Kind : std::uint8_t {
    rapid_contact,    ///< a rapid meets material
    shank_contact,    ///< the shank meets material
    holder_contact,   ///< the holder meets material
    fixture_contact,  ///< any part of the tool meets a fixture
    over_travel,      ///< an axis leaves its limits
    spindle_stopped,  ///< material is cut with a stopped spindle
    gouge,            ///< less material is left than the target has
    excess,           ///< more material is left than permitted
  };
  Kind kind = Kind::rapid_contact;
  CutMove move;               ///< move of the greatest amount
  Vec3 place = Vec3::Zero();  ///< position of the greatest amount, part coordinates, mm
  /// greatest amount, by kind: depth in mm, volume in mm^3, or mm (degrees) beyond a limit
  double amount = 0;
  std::string message;
  int first_line = 0, last_line = 0;  ///< range of program lines of the pass in which it occurs
};
/// Returns "rapid contact" and so on.
std::string_view name_of(SimulationEvent::Kind kind);

/// A remark on a program that is not a fault.
struct SimulationNote {
  int line = 0;
  std::string message;
  int program = 0;  ///< index of the program in a sequence
};

/// The work of one program line with one tool.
struct LineRecord {
  int line = 0, tool = 0;
  double removed = 0;  ///< volume removed, mm^3
  double seconds = 0;
  double cut = 0, air = 0;  ///< length of feed inside and outside material, mm
  int program = 0;          ///< index of the program in a sequence
};

struct SimulationReport {
  std::vector<std::filesystem::path> programs;  ///< in the order of execution
  std::vector<SimulationEvent> events;
  std::vector<SimulationNote> notes;
  std::vector<LineRecord> lines;  ///< in the order of first execution
  std::optional<Deviation> deviation;
  std::uint64_t moves = 0, poses = 0;
  double seconds = 0, rapid_seconds = 0;
  double removed = 0, left = 0;        ///< volumes removed and left, mm^3
  double cut = 0, air = 0, rapid = 0;  ///< lengths of feeds inside and outside material and of rapids, mm
  StockStatistics stock;
  [[nodiscard]] bool good() const { return events.empty(); }
  /// Fraction of the feed outside material, from 0 to 1.
  [[nodiscard]] double air_share() const { return cut + air > 0 ? air / (cut + air) : 0; }
};

}  // namespace fieldfab::cam

/// What a simulation found: events, times, lengths, volumes.
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

/// Something that should not happen. Those of one kind along one pass are one event.
struct SimulationEvent {
  enum class Kind : std::uint8_t {
    rapid_contact,    ///< a rapid goes through material
    shank_contact,    ///< the shank meets material
    holder_contact,   ///< the holder meets material
    fixture_contact,  ///< any part of the tool meets a fixture
    over_travel,      ///< an axis leaves its limits
    spindle_stopped,  ///< material is cut while the spindle stands
    gouge,            ///< less is left than the target
    excess,           ///< more is left than allowed
  };
  Kind kind = Kind::rapid_contact;
  CutMove move;               ///< where it is worst
  Vec3 place = Vec3::Zero();  ///< there, part coordinates
  double amount = 0;          ///< there: mm of depth, mm^3 of material, or mm (degrees) beyond a limit, by its kind
  std::string message;
  int first_line = 0, last_line = 0;  ///< of the pass's lines where it happens
};
/// "rapid contact" and so on.
std::string_view name_of(SimulationEvent::Kind kind);

/// Something about a program that its reader should know and that is no fault.
struct SimulationNote {
  int line = 0;
  std::string message;
  int program = 0;  ///< of several in a row
};

/// What one line of a program did with one tool.
struct LineRecord {
  int line = 0, tool = 0;
  double removed = 0;  ///< mm^3
  double seconds = 0;
  double cut = 0, air = 0;  ///< mm of feed with and without material
  int program = 0;          ///< of several in a row
};

struct SimulationReport {
  std::vector<std::filesystem::path> programs;  ///< as they were carried out
  std::vector<SimulationEvent> events;
  std::vector<SimulationNote> notes;
  std::vector<LineRecord> lines;  ///< in the order in which they were first carried out
  std::optional<Deviation> deviation;
  std::uint64_t moves = 0, poses = 0;
  double seconds = 0, rapid_seconds = 0;
  double removed = 0, left = 0;        ///< mm^3
  double cut = 0, air = 0, rapid = 0;  ///< mm
  StockStatistics stock;
  [[nodiscard]] bool good() const { return events.empty(); }
  /// Share of the feed that meets no material, from 0 to 1.
  [[nodiscard]] double air_share() const { return cut + air > 0 ? air / (cut + air) : 0; }
};

}  // namespace fieldfab::cam

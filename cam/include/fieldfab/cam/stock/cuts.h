/// Provenance of a stock's surface: the cuts that made its samples.
#pragma once

#include <cstdint>
#include <vector>

#include "fieldfab/cam/base/tool_solid.h"

namespace fieldfab::cam {

/// Origin of a point on a stock's surface.
enum class CutBy : std::uint8_t {
  nothing,  ///< the stock's initial surface
  tip,      ///< the cutting part of the tool
  shank,
  holder,
};

/// A move of a program, for reports.
struct CutMove {
  int line = 0;            ///< line of the program; 0: none
  int tool = 0;            ///< tool number; 0: none
  int program = 0;         ///< index of the program in a sequence, from 0
  std::uint32_t pass = 0;  ///< pass number from 1: consecutive feeds form one pass, and so do consecutive rapids
};

/// A cut: a move with one part of its tool.
struct Cut {
  CutBy by = CutBy::nothing;
  CutMove move;
};

/// Returns the number that samples store for a part of the tool; `tip` is the number for its cutting part.
constexpr std::uint32_t cut_number(std::uint32_t tip, ToolRole role) { return tip + static_cast<std::uint32_t>(role); }

/// The cuts of a simulation, indexed by the numbers that samples store. 0 is the initial surface.
class Cuts {
 public:
  /// Adds a move. Returns the number for its tool's cutting part.
  std::uint32_t add(const CutMove& move);
  /// Count of assigned numbers, including 0.
  [[nodiscard]] std::size_t size() const { return 1 + parts * moves_.size(); }
  /// Returns the cut of a number; the initial surface for an unassigned number.
  [[nodiscard]] Cut operator[](std::uint32_t number) const;

 private:
  static constexpr std::uint32_t parts = 3;  ///< parts of a tool, one for each ToolRole
  std::vector<CutMove> moves_;
};

}  // namespace fieldfab::cam

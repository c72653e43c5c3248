/// What the samples of a stock remember: the cuts that made them.
#pragma once

#include <cstdint>
#include <vector>

#include "fieldfab/cam/base/tool_solid.h"

namespace fieldfab::cam {

/// What made a place of a stock's surface.
enum class CutBy : std::uint8_t {
  nothing,  ///< it is the stock's first surface
  tip,      ///< the cutting part of a tool
  shank,
  holder,
};

/// A move of a program.
struct CutMove {
  int line = 0;            ///< of the program; 0: none
  int tool = 0;            ///< its number; 0: none
  int program = 0;         ///< of several in a row, from 0
  std::uint32_t pass = 0;  ///< feeds without a rapid between them are one pass, rapids without a feed alike; from 1
};

/// One cut: a move with one part of its tool.
struct Cut {
  CutBy by = CutBy::nothing;
  CutMove move;
};

/// The number that samples remember of a part of the tool, where `tip` is that of its cutting part.
constexpr std::uint32_t cut_number(std::uint32_t tip, ToolRole role) { return tip + static_cast<std::uint32_t>(role); }

/// The cuts of a simulation by these numbers. 0 is the stock's first surface.
class Cuts {
 public:
  /// Adds a move and returns the number of its tool's cutting part.
  std::uint32_t add(const CutMove& move);
  /// Numbers given so far, 0 among them.
  [[nodiscard]] std::size_t size() const { return 1 + parts * moves_.size(); }
  /// The first surface for numbers that were never given.
  [[nodiscard]] Cut operator[](std::uint32_t number) const;

 private:
  static constexpr std::uint32_t parts = 3;  ///< of a tool: its roles
  std::vector<CutMove> moves_;
};

}  // namespace fieldfab::cam

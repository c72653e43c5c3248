// One block (line) of a G-code program: its words, sorted into modal groups.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "expression.h"
#include "fieldfab/cam/gcode/motion.h"

namespace fieldfab::cam::gcode {

/// A line in lower case, without spaces and comments.
struct Line {
  std::string text;
  std::string_view comment;  ///< the last comment, unchanged
  bool deleted = false;      ///< starts with '/'
  bool closed = true;        ///< whether each '(' has its ')'

  /// Reads a line of a file. Reuses its memory.
  void read(std::string_view raw);
};

/// Modal groups of G codes. A block may have one code of each group (except G codes that form a
/// group of their own).
enum class GGroup : std::uint8_t {
  action,
  motion,
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  compensation,
  length,
  retract,
  system,
  path,
  spindle_mode,
  lathe,
  rotation,
  count
};
enum class MGroup : std::uint8_t { stop, in_out, tool, spindle, coolant, override_, state, kinematics, user, count };

/// A block. G codes are stored times ten (G59.3 is 593).
struct Block {
  static constexpr int none = -1;
  std::array<int, static_cast<std::size_t>(GGroup::count)> g{};
  std::array<int, static_cast<std::size_t>(MGroup::count)> m{};
  std::uint32_t words = 0;  ///< one bit per letter
  std::array<double, 26> values{};
  bool has_radius = false, has_angle = false;  ///< @ and ^
  double radius = 0, angle = 0;
  int spindle = none;                ///< $
  bool machine_coordinates = false;  ///< G53
  bool passed_over = false;          ///< whether it has an ignored code, whose words are not checked

  void clear();
  [[nodiscard]] bool has(char letter) const { return (words >> static_cast<unsigned>(letter - 'a') & 1U) != 0; }
  [[nodiscard]] bool has_any(std::string_view letters) const {
    for (const char c : letters)
      if (has(c)) return true;
    return false;
  }
  [[nodiscard]] double operator[](char letter) const { return values[static_cast<std::size_t>(letter - 'a')]; }
  [[nodiscard]] int code(GGroup group) const { return g[static_cast<std::size_t>(group)]; }
  [[nodiscard]] int code(MGroup group) const { return m[static_cast<std::size_t>(group)]; }
};

/// The name of a stored code: "G59.3" for 593.
std::string g_name(int code);

/// Reads blocks. Assignments of parameters (#1=2) take effect after the whole block, as RS274/NGC
/// requires.
class BlockReader {
 public:
  /// `note` receives a message for each ignored code, in dialects other than LinuxCNC's.
  BlockReader(Parameters& parameters, Dialect dialect, std::function<void(std::string)> note)
      : parameters_(parameters), dialect_(dialect), note_(std::move(note)) {}
  /// Throws Refusal for an invalid block.
  void read(std::string_view text, Block& block);

 private:
  void read_word(Cursor& cursor, Block& block);
  void read_g(int code, Block& block);
  void read_m(int code, Block& block);
  void read_setting(Cursor& cursor);

  Parameters& parameters_;
  Dialect dialect_;
  std::function<void(std::string)> note_;
  std::vector<std::pair<std::variant<int, std::string>, double>> settings_;
};

/// Skips N and its number.
void skip_line_number(Cursor& cursor);

}  // namespace fieldfab::cam::gcode

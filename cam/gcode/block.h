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

/// A line without spaces, without comments, in lower case.
struct Line {
  std::string text;
  std::string_view comment;  ///< the last one, as it was written
  bool deleted = false;      ///< began with '/'
  bool closed = true;        ///< whether each '(' had its ')'

  /// Takes in a line of a file. Keeps the memory that it has.
  void read(std::string_view raw);
};

/// Where a block's G codes belong: only one of each group may stand in a block (but for those that only stand for themselves).
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

/// G codes are kept times ten (G59.3 is 593).
struct Block {
  static constexpr int none = -1;
  std::array<int, static_cast<std::size_t>(GGroup::count)> g{};
  std::array<int, static_cast<std::size_t>(MGroup::count)> m{};
  std::uint32_t words = 0;  ///< a bit for each letter
  std::array<double, 26> values{};
  bool has_radius = false, has_angle = false;  ///< @ and ^
  double radius = 0, angle = 0;
  int spindle = none;                ///< $
  bool machine_coordinates = false;  ///< G53
  bool passed_over = false;          ///< it has a code without a meaning here, whose words are not looked at

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

/// "G59.3" for 593.
std::string g_name(int code);

/// Reads blocks; settings of parameters (#1=2) take effect behind the whole block, as RS274/NGC wants it.
class BlockReader {
 public:
  /// `note` takes what is passed over in all dialects but LinuxCNC's.
  BlockReader(Parameters& parameters, Dialect dialect, std::function<void(std::string)> note)
      : parameters_(parameters), dialect_(dialect), note_(std::move(note)) {}
  /// Refuses what is no block.
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

/// Steps over N and its number.
void skip_line_number(Cursor& cursor);

}  // namespace fieldfab::cam::gcode

#include "dialect.h"

#include <array>
#include <map>

#include "base/names.h"

namespace fieldfab::cam {
namespace {

constexpr std::array<std::string_view, 4> names{"linuxcnc", "fanuc", "grbl", "mach3"};

}  // namespace

std::string_view name_of(Dialect dialect) { return names[static_cast<std::size_t>(dialect)]; }

Dialect dialect_named(std::string_view name, const std::string& place) {
  return named<Dialect>(name, names, "dialect", place);
}

namespace gcode {

std::optional<std::string> passed_over_g(Dialect dialect, int code) {
  // Codes of Fanuc and Haas. G5 and G5.1 are splines in other dialects.
  static const std::map<int, std::string> fanuc{{50, "high-speed machining"},
                                                {51, "look-ahead"},
                                                {80, "look-ahead"},
                                                {90, "exact stop"},
                                                {110, "end of data setting"},
                                                {150, "end of polar coordinates"},
                                                {230, "stored limits off"},
                                                {250, "spindle speed supervision off"},
                                                {260, "spindle speed supervision"},
                                                {401, "normal direction control off"},
                                                {500, "end of scaling"},
                                                {501, "end of mirroring"},
                                                {620, "corner override"},
                                                {630, "tapping mode"},
                                                {670, "end of macro calls"},
                                                {1030, "limit of look-ahead"},
                                                {1070, "end of cylindrical coordinates"},
                                                {1131, "end of polar coordinates"},
                                                {1310, "end of polar coordinates"},
                                                {1870, "accuracy"}};
  static const std::map<int, std::string> mach3{{150, "end of polar coordinates"}, {500, "end of scaling"}};
  if (dialect == Dialect::linuxcnc || dialect == Dialect::grbl) return std::nullopt;
  const auto& known = dialect == Dialect::fanuc ? fanuc : mach3;
  const auto found = known.find(code);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

bool passes_over_m(Dialect dialect, int code) {
  return dialect != Dialect::linuxcnc && code >= 0 && code != 47 && code != 96 && code != 97;
}

}  // namespace gcode
}  // namespace fieldfab::cam

// gcode_moves FILE [TOOLS]: prints the motions that read_gcode() returns for a program, one per
// line, for tests/hosts/gcode_test.py. TOOLS: lines of "number length diameter" in mm.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <numbers>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

int main(int count, char** words) {
  using namespace fieldfab;
  try {
    cam::ReadingOptions options;
    options.block_delete = false;  // as rs274
    options.most_blocks = 3'000'000;
    if (count > 2) {
      std::ifstream table(words[2]);
      int number = 0;
      double length = 0, diameter = 0;
      while (table >> number >> length >> diameter) options.tools[number] = {{0, 0, length}, diameter};
    }
    const std::string file = words[1], text = read_file(file);
    fmt::memory_buffer out;
    const auto notes = cam::read_gcode(text, file, options, [&](const cam::Motion& motion) {
      static constexpr const char* kinds[] = {"rapid", "feed", "arc", "dwell", "tool_change", "stop", "end"};
      fmt::format_to(std::back_inserter(out), "{} {} {} {}", kinds[static_cast<int>(motion.kind)], motion.line,
                     static_cast<int>(motion.plane), static_cast<int>(motion.mode));
      for (std::size_t k = 0; k < 9; ++k)
        fmt::format_to(std::back_inserter(out), " {:.6f}",
                       motion.end.at[k] * (k > 2 && k < 6 ? 180 / std::numbers::pi : 1));
      fmt::format_to(std::back_inserter(out), " {:.6f} {:.6f} {} {:.6f} {:.6f} {} {} {:.6f} {:.6f} {:.6f}\n",
                     motion.centre.x(), motion.centre.y(), motion.turns, motion.feed, motion.seconds, motion.tool,
                     motion.spindle, motion.tool_offset.x(), motion.tool_offset.y(), motion.tool_offset.z());
      if (out.size() > 1 << 16) {
        std::fwrite(out.data(), 1, out.size(), stdout);
        out.clear();
      }
    });
    std::fwrite(out.data(), 1, out.size(), stdout);
    for (const cam::ReadingNote& note : notes) fmt::print(stderr, "note {}: {}\n", note.line, note.message);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return error.kind() == ErrorKind::bad_input ? 2 : 3;
  }
}

/// Programs read into lists, for tests.
#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "fieldfab/cam/gcode/motion.h"
#include "fieldfab/core/error.h"

namespace fieldfab::cam {

constexpr double pi = std::numbers::pi;
using Kind = Motion::Kind;

struct Reading {
  std::vector<Motion> motions;
  std::vector<ReadingNote> notes;
  [[nodiscard]] Vec3 at(std::size_t i) const { return motions.at(i).end.xyz(); }
  [[nodiscard]] bool noted(const std::string& text) const {
    for (const ReadingNote& note : notes)
      if (note.message.find(text) != std::string::npos) return true;
    return false;
  }
};

inline ReadingOptions with_tools() {
  ReadingOptions options;
  options.tools[1] = {{0, 0, 10}, 6};
  options.tools[2] = {{0, 0, 25}, 4};
  return options;
}

inline Reading gcode(const std::string& text, const ReadingOptions& options = with_tools()) {
  Reading reading;
  reading.notes =
      read_gcode(text, "part.ngc", options, [&](const Motion& motion) { reading.motions.push_back(motion); });
  return reading;
}

/// Motions that move only.
inline Reading moves(const std::string& text, const ReadingOptions& options = with_tools()) {
  Reading reading = gcode("G21 G90 F100\n" + text, options);
  std::erase_if(reading.motions,
                [](const Motion& m) { return m.kind != Kind::rapid && m.kind != Kind::feed && m.kind != Kind::arc; });
  return reading;
}

inline void near(const Vec3& a, const Vec3& b, double within = 1e-9) {
  EXPECT_NEAR((a - b).norm(), 0, within) << a.transpose() << " instead of " << b.transpose();
}

/// Expects that reading throws Error(bad_input) at a line, with a message that contains a text.
inline void refused(const std::string& text, int line, const std::string& message,
                    const ReadingOptions& options = with_tools()) {
  try {
    gcode(text, options);
    ADD_FAILURE() << "read without an error: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_EQ(error.place(), "part.ngc:" + std::to_string(line)) << error.what();
    EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
  }
}

}  // namespace fieldfab::cam

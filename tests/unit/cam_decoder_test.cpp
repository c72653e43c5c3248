// Lines of G-code as typed commands, without an interpreter.
#include "gcode/decoder.h"

#include <gtest/gtest.h>

#include "fieldfab/core/error.h"
#include "gcode/refusal.h"

namespace fieldfab::cam::gcode {
namespace {

/// A control without predefined parameters.
struct NoPredefined final : PredefinedParameters {
  [[nodiscard]] double numbered(int) const override { return 0; }
  [[nodiscard]] std::optional<double> named(std::string_view) const override { return std::nullopt; }
};

struct Decoded {
  Command command;
  int motion = 800;
  std::vector<std::string> notes;
};

Decoded decoded(const std::vector<std::string>& lines, Dialect dialect = Dialect::linuxcnc, int motion = 800) {
  NoPredefined predefined;
  Parameters parameters(predefined);
  Decoded result;
  result.motion = motion;
  Decoder decoder(parameters, dialect, true, [&](std::string note) { result.notes.push_back(std::move(note)); });
  for (const std::string& text : lines) {
    Line line;
    line.read(text);
    decoder.decode(line, result.motion, result.command);
  }
  return result;
}

TEST(decoder, tells_kinds_of_lines) {
  using Kind = Command::Kind;
  EXPECT_EQ(decoded({"(a comment)"}).command.kind, Kind::nothing);
  EXPECT_EQ(decoded({"/G0 X1"}).command.kind, Kind::nothing);
  EXPECT_EQ(decoded({"%"}).command.kind, Kind::delimiter);
  EXPECT_EQ(decoded({"o100 sub"}).command.kind, Kind::flow);
  EXPECT_EQ(decoded({"G0 X1"}).command.kind, Kind::block);
  EXPECT_EQ(decoded({"$H"}, Dialect::grbl).command.kind, Kind::nothing);
}

TEST(decoder, modal_words_have_meanings) {
  const ModalWords set = decoded({"G20 G18 G91 G90.1 G98 G59.3 G61 G93 G7 M4"}).command.modal;
  EXPECT_EQ(set.inch, true);
  EXPECT_EQ(set.plane, ArcPlane::zx);
  EXPECT_EQ(set.absolute, false);
  EXPECT_EQ(set.arcs_absolute, true);
  EXPECT_EQ(set.retract_to_start, true);
  EXPECT_EQ(set.system, 9);
  EXPECT_EQ(set.path, 610);
  EXPECT_EQ(set.feed_mode, 930);
  EXPECT_EQ(set.diameter, true);
  EXPECT_EQ(set.spindle, -1);
  EXPECT_FALSE(set.control);
  EXPECT_EQ(decoded({"G55"}).command.modal.system, 2);
  EXPECT_EQ(decoded({"M19"}).command.modal.spindle, 0);
  // No state remains from the previous block.
  EXPECT_FALSE(decoded({"G20 G18", "G0 X1"}).command.modal.inch);
}

TEST(decoder, words_without_a_use_are_refused_or_passed_over) {
  EXPECT_THROW(decoded({"X1"}), Refusal);
  EXPECT_NO_THROW(decoded({"X1"}, Dialect::linuxcnc, 10));
  EXPECT_THROW(decoded({"G0 X1 I3"}), Refusal);
  EXPECT_THROW(decoded({"G80 X1"}), Refusal);
  EXPECT_THROW(decoded({"G92 X1 G1"}), Refusal);
  const Decoded fanuc = decoded({"G0 X1 I3"}, Dialect::fanuc);
  ASSERT_EQ(fanuc.notes.size(), 1U);
  EXPECT_NE(fanuc.notes[0].find("I in a block"), std::string::npos);
}

// On Fanuc controls G80 ends a cycle and restores the motion mode from before it.
TEST(decoder, g80_beside_g0_and_the_motion_in_force) {
  EXPECT_THROW(decoded({"G0 G80 X1"}), Refusal);
  const Decoded both = decoded({"G1 X1", "G80"}, Dialect::fanuc, 810);
  EXPECT_EQ(both.motion, 10);
  EXPECT_EQ(both.command.block.code(GGroup::motion), Block::none);
  const Decoded home = decoded({"G0 G28 Z0"}, Dialect::fanuc);
  EXPECT_EQ(home.motion, 0);
  EXPECT_EQ(home.command.block.code(GGroup::motion), Block::none);
}

TEST(decoder, dwells_in_a_controls_own_unit) {
  EXPECT_DOUBLE_EQ(decoded({"G4 P500"}, Dialect::fanuc).command.block['p'], 0.5);
  EXPECT_DOUBLE_EQ(decoded({"G4 X2."}, Dialect::fanuc).command.block['p'], 2);
  EXPECT_DOUBLE_EQ(decoded({"G4 P500"}, Dialect::grbl).command.block['p'], 500);
}

}  // namespace
}  // namespace fieldfab::cam::gcode

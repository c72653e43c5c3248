// First stage of reading a program: conversion of lines to typed commands.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "block.h"

namespace fieldfab::cam::gcode {

/// Settings by the modal words of a block, by meaning.
struct ModalWords {
  std::optional<int> feed_mode;  ///< G code times ten
  std::optional<ArcPlane> plane;
  std::optional<bool> inch, diameter, absolute, arcs_absolute, retract_to_start;
  std::optional<int> system;   ///< coordinate system: 1 is G54
  std::optional<int> path;     ///< G code times ten
  std::optional<int> spindle;  ///< 1 clockwise, -1 anticlockwise, 0 off
  std::optional<ControlMode> control;
};

/// A decoded line.
struct Command {
  enum class Kind : std::uint8_t {
    nothing,    ///< a comment, a deleted line, or a command to the control
    delimiter,  ///< %
    flow,       ///< an O word, for Flow
    block,
  };
  Kind kind = Kind::nothing;
  Block block;       ///< of a block: its words, after the dialect's rules
  ModalWords modal;  ///< of a block
};

/// Converts lines to commands by the rules of a dialect. Does not know the tool's position.
class Decoder {
 public:
  /// `note` receives a message for each ignored code, in dialects other than LinuxCNC's.
  Decoder(Parameters& parameters, Dialect dialect, bool block_delete, std::function<void(std::string)> note)
      : dialect_(dialect), block_delete_(block_delete), note_(std::move(note)), reader_(parameters, dialect, note_) {}

  /// Decodes a line. `motion`: the motion mode in force, which G80 and G28 of some dialects change.
  /// Throws Refusal for an invalid block, unused words, and words used twice.
  void decode(Line& line, int& motion, Command& command);

 private:
  [[nodiscard]] bool forgiving() const { return dialect_ != Dialect::linuxcnc; }
  bool forgive_line(Line& line);
  void forgive_block(const Line& line, Block& block, int& motion_in_force);
  void check_words(const Block& block, int motion_in_force) const;

  Dialect dialect_;
  bool block_delete_;
  std::function<void(std::string)> note_;
  BlockReader reader_;
  int plain_motion_ = 0;  ///< G0 to G3 from before a cycle, for dialects whose G80 restores it
};

/// The modal words of a block.
ModalWords modal_words(const Block& block);

}  // namespace fieldfab::cam::gcode

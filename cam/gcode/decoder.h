// The first step of reading a program: lines become typed commands.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "block.h"

namespace fieldfab::cam::gcode {

/// What a block's modal words set, by meaning.
struct ModalWords {
  std::optional<int> feed_mode;  ///< G code times ten
  std::optional<ArcPlane> plane;
  std::optional<bool> inch, diameter, absolute, arcs_absolute, retract_to_start;
  std::optional<int> system;   ///< of coordinates: 1 is G54
  std::optional<int> path;     ///< G code times ten
  std::optional<int> spindle;  ///< 1 clockwise, -1 anticlockwise, 0 off
  std::optional<ControlMode> control;
};

/// What a line asks for.
struct Command {
  enum class Kind : std::uint8_t {
    nothing,    ///< a comment, a deleted line, a command to the control
    delimiter,  ///< %
    flow,       ///< an O word, for Flow
    block,
  };
  Kind kind = Kind::nothing;
  Block block;       ///< of a block: its words, as the dialect has them
  ModalWords modal;  ///< of a block
};

/// Lines to commands, in the dialect's way. Knows nothing of where the tool stands.
class Decoder {
 public:
  /// `note` takes what is passed over in all dialects but LinuxCNC's.
  Decoder(Parameters& parameters, Dialect dialect, bool block_delete, std::function<void(std::string)> note)
      : dialect_(dialect), block_delete_(block_delete), note_(std::move(note)), reader_(parameters, dialect, note_) {}

  /// Decodes a line where the code `motion` is in force, which some dialects' G80 and G28 set. Refuses what is no block, words
  /// that nothing in it uses, and words that two things want.
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
  int plain_motion_ = 0;  ///< G0 to G3, as of before any cycle; for dialects whose G80 goes back to it
};

/// The modal words of a block.
ModalWords modal_words(const Block& block);

}  // namespace fieldfab::cam::gcode

// Execution of blocks: decodes them, updates the modal state, and hands motions to the stream.
#pragma once

#include <optional>

#include "decoder.h"
#include "motion_words.h"
#include "offsets.h"
#include "predefined.h"

namespace fieldfab::cam::gcode {

/// Reads a program. A block passes through three steps: the decoder converts it to a typed command; its modal words
/// update the control; its motion passes through the stages of the stream.
class Interpreter {
 public:
  Interpreter(std::string_view text, const std::string& file, const ReadingOptions& options, const MotionSink& sink,
              Progress& progress);
  std::vector<ReadingNote> run();

 private:
  bool step();
  void execute();

  // modal words, in their order of execution
  void set_feed();
  void set_speed();
  void select_tool();
  void machine_words();
  void change_tool();
  void take_tool();
  void set_control(ControlMode mode);
  void dwell();
  void set_plane(ArcPlane plane);
  void set_compensation();
  void action();

  // M words that save and restore modes, stop, or call
  void state_words();
  void save_state(bool restore_on_return);
  void restore_on_return();
  void stop_words();
  void end_program();

  Progress& progress_;
  ControlParameters predefined_;
  Control control_;
  MotionStream stream_;
  LineCount count_;
  Flow flow_;
  Decoder decoder_;
  Offsets offsets_;
  MotionWords motions_;
  Line line_;
  Command command_;
  const Block& block_ = command_.block;
  // % was first; the end was reached; something was read
  bool delimited_ = false, finished_ = false, begun_ = false;
  std::optional<Modes> saved_;
  struct SavedInCall {
    std::size_t depth;
    Modes modes;
  };
  std::vector<SavedInCall> saved_in_calls_;
};

}  // namespace fieldfab::cam::gcode

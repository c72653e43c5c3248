// Order of execution of lines: O words (subroutines, conditions, loops), M98 and M99.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sources.h"

namespace fieldfab::cam::gcode {

/// Returns a program's lines in their order of execution.
class Flow {
 public:
  Flow(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
       LineCount& count, Parameters& parameters);

  /// Reads the next line. Returns false at the end of the program's file. Throws Refusal beyond the
  /// greatest number of lines.
  bool next(Line& line);
  /// Executes a flow command.
  void carry_out(const Line& line);
  /// M98: executes the program from the line `O number` on, `repeats` times.
  void call_program(int number, int repeats);
  /// M99: returns, or repeats. Returns false outside of calls.
  bool return_program();

  [[nodiscard]] const std::string& file() const { return at_.source->name; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] bool in_program() const { return calls_.empty(); }
  /// Fraction of the program's own file that has been read.
  [[nodiscard]] double share() const;
  [[nodiscard]] std::size_t depth() const { return calls_.size(); }
  /// #<_value> and #<_value_returned>.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool value_returned() const { return value_returned_; }
  /// Sets a function that is called after each return from a subroutine (for M73).
  void on_return(std::function<void()> listener) { returned_ = std::move(listener); }

 private:
  enum class Kind : std::uint8_t { condition, loop, do_loop, repeat };
  struct Open {
    Kind kind = Kind::condition;
    std::string label;
    Position start;  ///< start of the next repetition
    std::int64_t left = 0;
  };
  struct Call {
    Position back, start;
    std::vector<Open> open;    ///< of the caller
    bool own_numbers = false;  ///< whether #1 to #30 are local
    int repeats = 1;
    std::string label;
  };

  /// Skips to the line with that label and one of the keywords, and returns the keyword. The
  /// position is then after that line, and `before_` before it.
  std::string skip_to(const std::string& label, std::initializer_list<std::string_view> keywords, const char* what);
  void close_to(const std::string& label, Kind kind, const char* what);
  Open* find_open(const std::string& label);
  void call(const Line& line, const FlowWord& word);
  void enter(const std::string& label, const Position& start, const std::vector<double>& arguments, bool own_numbers,
             int repeats);
  void leave();
  void carry_out_condition(const Line& line, const FlowWord& word);
  void carry_out_loop(const Line& line, const FlowWord& word);
  void again(Open& loop);

  LineCount& count_;
  Parameters& parameters_;
  Sources sources_;
  std::vector<Call> calls_;
  std::vector<Open> open_;
  Position at_;      // after the line that was read last
  Position before_;  // before it
  int line_ = 0;
  double value_ = 0;
  bool value_returned_ = false;
  std::function<void()> returned_;
};

}  // namespace fieldfab::cam::gcode

// Order of execution of lines: O words (subroutines, conditions, loops), M98 and M99.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "block.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {

/// A program or a subroutine file.
struct Source {
  std::string name;  ///< for messages
  std::string kept;  ///< the text, if this object owns it
  std::string_view text;
};

/// A position between two lines.
struct Position {
  const Source* source = nullptr;
  std::size_t offset = 0;
  int line = 0;  ///< number of lines before it
};

/// Returns a program's lines in their order of execution.
class Flow {
 public:
  Flow(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
       std::uint64_t most_lines, Parameters& parameters);

  /// Reads the next line. Returns false at the end of the program's file. Throws Refusal beyond the
  /// greatest number of lines.
  bool next(Line& line);
  /// Whether a line is a flow command: O and a label.
  [[nodiscard]] static bool is_flow(const Line& line);
  /// Executes such a line.
  void carry_out(const Line& line);
  /// M98: executes the program from the line `O number` on, `repeats` times.
  void call_program(int number, int repeats);
  /// M99: returns, or repeats. Returns false outside of calls.
  bool return_program();

  /// Counts a line, or work of a similar duration. Throws Refusal beyond the limit.
  void count();
  [[nodiscard]] const std::string& file() const { return at_.source->name; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }
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
  /// A parsed flow command: its label, its keyword, and the rest of the line.
  struct Word {
    std::string label, keyword;
    std::size_t rest = 0;
  };

  bool raw_line(Position& position, std::string_view& raw) const;
  [[nodiscard]] bool take_apart(const Line& line, Word& word, bool strict) const;
  double condition(const Line& line, const Word& word) const;
  /// Skips to the line with that label and one of the keywords, and returns the keyword. The
  /// position is then after that line, and `before_` before it.
  std::string skip_to(const std::string& label, std::initializer_list<std::string_view> keywords, const char* what);
  std::optional<Position> find(const Source& source, Position from, const std::string& label, bool program);
  void close_to(const std::string& label, Kind kind, const char* what);
  Open* find_open(const std::string& label);
  void call(const Line& line, const Word& word);
  void enter(const std::string& label, const Position& start, const std::vector<double>& arguments, bool own_numbers,
             int repeats);
  void leave();
  const Source* open_file(const std::string& label);
  void carry_out_condition(const Line& line, const Word& word);
  void carry_out_loop(const Line& line, const Word& word);
  void again(Open& loop);

  Source main_;
  std::vector<std::filesystem::path> folders_;
  std::map<std::string, std::unique_ptr<Source>> files_;
  std::map<std::string, Position> subroutines_;
  std::vector<Call> calls_;
  std::vector<Open> open_;
  Parameters& parameters_;
  Position at_;      // after the line that was read last
  Position before_;  // before it
  int line_ = 0;
  std::uint64_t lines_ = 0, most_lines_;
  double value_ = 0;
  bool value_returned_ = false;
  std::function<void()> returned_;
};

}  // namespace fieldfab::cam::gcode

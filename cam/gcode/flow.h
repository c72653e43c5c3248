// Which line of which file comes next: O-words (subroutines, conditions, loops), M98 and M99.
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
  std::string kept;  ///< the text, where it is ours to keep
  std::string_view text;
};

/// The place behind or before a line.
struct Position {
  const Source* source = nullptr;
  std::size_t offset = 0;
  int line = 0;  ///< number of lines before it
};

/// Gives a program's lines in the order in which they are carried out.
class Flow {
 public:
  Flow(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
       std::uint64_t most_lines, Parameters& parameters);

  /// The next line into `line`; false at the end of the program's file. Counts the lines and refuses to go on beyond the most.
  bool next(Line& line);
  /// Whether the line is one of flow: O and what follows.
  [[nodiscard]] static bool is_flow(const Line& line);
  /// Carries out such a line.
  void carry_out(const Line& line);
  /// M98: from the line `O number` on, so often.
  void call_program(int number, int repeats);
  /// M99: back, or again. False where nothing was called.
  bool return_program();

  /// Counts a line, or what takes as long as one; refuses to go on beyond the most.
  void count();
  [[nodiscard]] const std::string& file() const { return at_.source->name; }
  [[nodiscard]] int line() const { return line_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }
  [[nodiscard]] bool in_program() const { return calls_.empty(); }
  /// What share of the program's own file has been read.
  [[nodiscard]] double share() const;
  [[nodiscard]] std::size_t depth() const { return calls_.size(); }
  /// #<_value> and #<_value_returned>.
  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool value_returned() const { return value_returned_; }
  /// Called when a subroutine has been left (for M73).
  void on_return(std::function<void()> listener) { returned_ = std::move(listener); }

 private:
  enum class Kind : std::uint8_t { condition, loop, do_loop, repeat };
  struct Open {
    Kind kind = Kind::condition;
    std::string label;
    Position start;  ///< where the next round begins
    std::int64_t left = 0;
  };
  struct Call {
    Position back, start;
    std::vector<Open> open;    ///< the caller's
    bool own_numbers = false;  ///< whether #1 to #30 are its own
    int repeats = 1;
    std::string label;
  };
  /// A line of flow, taken apart: its label, its keyword, and what is behind it.
  struct Word {
    std::string label, keyword;
    std::size_t rest = 0;
  };

  bool raw_line(Position& position, std::string_view& raw) const;
  [[nodiscard]] bool take_apart(const Line& line, Word& word, bool strict) const;
  double condition(const Line& line, const Word& word) const;
  /// Goes forward to the line with that label and one of the keywords; returns which. Stands behind it then; `before_` is before
  /// it.
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
  Position at_;      // behind the line that was read last
  Position before_;  // before it
  int line_ = 0;
  std::uint64_t lines_ = 0, most_lines_;
  double value_ = 0;
  bool value_returned_ = false;
  std::function<void()> returned_;
};

}  // namespace fieldfab::cam::gcode
